"""Drives the window with mouse and keyboard:
window_test.py PROGRAM [Tuner|Looker|Owner|Filer|WindowTest.NAME...].
The groups have separate windows and can run in parallel."""

import sys
import unittest
from pathlib import Path

from choosing import Choosing
from collecting import Collecting
from comparing import Comparing
from drawing import Drawing
from driving import Driving
from editing import Editing
from exporting import Exporting
from filing import Filing
from foreign import Foreign
from helping import Helping
from keeping import Keeping
from keyboard import Keyboard
from looking import Looking
from moving import Moving
from owning import Owning
from person import Person
from remoting import Remoting
from trying import Trying
from tuning import Tuning

Person.executable = Path(sys.argv[1]).resolve()


class Tuner(Tuning, Keeping, Trying):
    """The first group of tests. They share a window, and each one starts with the initial look."""


class Looker(Driving, Drawing, Editing, Looking, Moving, Remoting, Comparing,
             Choosing):
    """The second group."""


class Owner(Owning, Foreign, Collecting):
    """The third group: content and looks of the user, and looks of other programs."""


class Filer(Filing, Exporting, Helping, Keyboard):
    """The fourth group: dialogs for files, exports, help, and the keyboard."""


class WindowTest(Tuner, Looker, Owner, Filer):
    """All groups, for running single tests."""


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *(sys.argv[2:] or ["Tuner", "Looker", "Owner", "Filer"])], verbosity=2)
