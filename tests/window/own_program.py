"""The base class of window tests that start the program themselves."""

import tempfile
import unittest
from pathlib import Path

from program import Program
from screen import Screen

SOURCE = Path(__file__).resolve().parents[2]


class OwnProgram(unittest.TestCase):
    """Each test has a screen, a home folder and the program, which it starts."""

    make_program = Program

    def setUp(self):
        self.screen = Screen(1000, 700).__enter__()
        self.addCleanup(self.screen.__exit__, None, None, None)
        folder = tempfile.TemporaryDirectory(prefix="afterglow-window-")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.program = self.make_program(self.executable, SOURCE, self.folder, self.screen)
        self.addCleanup(self.program.stop)
        self.program.arrange(1000, 700, [240, 180])
