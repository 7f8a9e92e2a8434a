"""Drives the window with mouse and keyboard: window_test.py PROGRAM [WindowTest.NAME...]."""

import sys
import unittest
from pathlib import Path

from drawing import Drawing
from driving import Driving
from editing import Editing
from keeping import Keeping
from looking import Looking
from person import Person
from tuning import Tuning

Person.executable = Path(sys.argv[1]).resolve()


class WindowTest(Tuning, Keeping, Driving, Drawing, Editing, Looking):
    """One person at one window: each test finds the look as it was first."""


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *(sys.argv[2:] or ["WindowTest"])], verbosity=2)
