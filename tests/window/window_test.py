"""Drives the window with mouse and keyboard: window_test.py PROGRAM [Tuning|Tuning.NAME...].
The tests of a class share a window. Classes can run in parallel."""

import sys
import unittest
from pathlib import Path

from capturing import Capturing
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
from listing import Listing
from looking import Looking
from matching import Matching
from moving import Moving
from owning import Owning
from person import Person
from remoting import Remoting
from sequencing import Sequencing
from trying import Trying
from tuning import Tuning

Person.executable = Path(sys.argv[1]).resolve()


class WindowTest(Capturing, Choosing, Collecting, Comparing, Drawing, Driving, Editing, Exporting, Filing, Foreign,
                 Helping, Keeping, Keyboard, Listing, Looking, Matching, Moving, Owning, Remoting, Sequencing,
                 Trying, Tuning):
    """All tests with one window, for pictures of the manual."""


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *(sys.argv[2:] or ["WindowTest"])], verbosity=2)
