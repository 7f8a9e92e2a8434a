"""Drives the window with mouse and keyboard: window_test.py PROGRAM [Tuner|Looker|WindowTest.NAME...].
Two people at once, each at a window of their own, are through in half the time."""

import sys
import unittest
from pathlib import Path

from choosing import Choosing
from comparing import Comparing
from drawing import Drawing
from driving import Driving
from editing import Editing
from foreign import Foreign
from keeping import Keeping
from looking import Looking
from moving import Moving
from owning import Owning
from person import Person
from trying import Trying
from tuning import Tuning

Person.executable = Path(sys.argv[1]).resolve()


class Tuner(Tuning, Keeping, Trying):
    """One person at one window: each test finds the look as it was first."""


class Looker(Driving, Drawing, Editing, Looking, Moving, Comparing, Choosing):
    """Another one."""


class Owner(Owning, Foreign):
    """A third one, whose own things stay."""


class WindowTest(Tuner, Looker, Owner):
    """Somebody who does it all."""


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *(sys.argv[2:] or ["Tuner", "Looker", "Owner"])], verbosity=2)
