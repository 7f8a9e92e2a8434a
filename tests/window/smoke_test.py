"""The window's main road with real mouse and keyboard events: smoke_test.py PROGRAM.

Open, turn a knob, undo, edit a shader in both ways of saving, break it and mend it, quit, and find all
as it was left. Screenshots go to build/window/.
"""

import os
import sys
import tempfile
import unittest
from pathlib import Path

from program import Program
from screen import Screen

SOURCE = Path(__file__).resolve().parents[2]
PROGRAM = Path(sys.argv.pop(1)).resolve()
PICTURES = SOURCE / "build/window"


class Smoke(unittest.TestCase):
    def setUp(self):
        screen = Screen(1280, 720)
        self.screen = screen.__enter__()
        self.addCleanup(screen.__exit__, None, None, None)
        folder = tempfile.TemporaryDirectory(prefix="afterglow-window-")
        self.addCleanup(folder.cleanup)
        self.program = Program(PROGRAM, SOURCE, Path(folder.name), self.screen)
        self.addCleanup(self.program.stop)
        self.shader = Path(folder.name) / "data/shaders/phosphor/composite.frag"

    def turn_up(self, name):
        """Drags a parameter's slider to its right end; a busy machine may lose an event, so up to thrice."""
        before = self.program.state()["values"][name]
        for _ in range(3):
            low, high, y = self.program.slider(name)
            self.program.drag(((low + high) // 2, y), (high, y))
            if self.program.state()["values"][name] > before:
                return self.program.state()["values"][name]
        self.fail(f"the slider of '{name}' does not follow the mouse")

    def save_in_place(self, text):
        self.shader.write_text(text)

    def save_by_rename(self, text):
        beside = self.shader.with_suffix(".new")
        beside.write_text(text)
        os.replace(beside, self.shader)

    def test_the_main_road(self):
        program = self.program
        state = program.start("phosphor")
        self.screen.save(PICTURES / "started.png")
        self.assertEqual(state["problems"], [])
        default = state["values"]["beam_gain"]

        self.turn_up("beam_gain")
        program.wait("the change is marked and named", lambda s: s["is_modified"] and s["undo"])
        self.screen.save(PICTURES / "turned.png")
        for _ in range(20):  # a key that is down for less than a slow frame may be lost
            if not program.state()["undo"]:
                break
            program.key("ctrl+z")
        program.wait("undo gives the default", lambda s: s["values"]["beam_gain"] == default)

        text = self.shader.read_text()
        line = "uniform float exposure = 1.5;"
        self.assertIn(line, text)
        self.save_by_rename(text.replace(line, "uniform float exposure = 2.5;"))
        program.wait("an edit by rename is seen", lambda s: s["values"]["exposure"] == [2.5])
        self.save_in_place(text.replace(line, "uniform float exposure = 3.5;"))
        program.wait("an edit in place is seen", lambda s: s["values"]["exposure"] == [3.5])
        self.save_in_place(text.replace("void main()", "void main() { undeclared_name = 1.0; }\nvoid rest()"))
        broken = program.wait("a mistake is told", lambda s: s["problems"])
        self.assertIn("composite.frag", str(broken["problems"]))
        self.assertIn("undeclared_name", str(broken["problems"]))
        frame = broken["frame"]
        program.wait("the last good picture runs on", lambda s: s["frame"] > frame + 2)
        self.screen.save(PICTURES / "broken.png")
        self.save_in_place(text)
        program.wait("mending clears it", lambda s: not s["problems"] and s["values"]["exposure"] == [1.5])

        left = self.turn_up("beam_gain")
        program.quit()
        program.start()
        program.wait("the last state is back", lambda s: s["values"]["beam_gain"] == left and s["is_modified"])
        self.screen.save(PICTURES / "restored.png")


if __name__ == "__main__":
    unittest.main(verbosity=2)
