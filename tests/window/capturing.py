"""Live sources: a window of another program through a look."""

import sys
from pathlib import Path

from person import Person

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "capture"))
from painted_window import PaintedWindow  # noqa: E402


class Capturing(Person):
    def other_window(self, title):
        program = self.program.executable.parents[1] / "tests" / "painted_window"
        window = PaintedWindow(program, self.screen.display, title, 40, 40, 320, 240)
        window.do("lower")
        return window

    def wait_for_red(self, what, low, high):
        """Waits until the red value below the pointer, 0 to 1, is in this range."""
        self.program.wait(what, lambda s: s["probe"] and low <= float(s["probe"]["rgba"][0]) <= high)

    def show_live(self, choice):
        self.program.click("live_source")
        self.program.click("live:" + choice)
        self.snapshot("live_dialog")
        self.program.click("dialog_ok")
        self.program.wait("the source is shown", lambda s: s["dialog"] == 0 and s["driving_source"].startswith(choice))

    def test_a_window_is_shown_live_and_found_again_after_it_was_closed(self):
        program = self.program
        window = self.other_window("Game, level 1")
        window.do("fill c02020")
        program.click("look:crt")
        program.wait("the look is open", lambda s: s["look"] == "crt" and not s["is_loading"])
        self.show_live("window:Game, level 1")
        self.hover("picture")
        self.wait_for_red("the window is drawn", 0.3, 1.0)
        self.snapshot("live_window")
        window.do("fill 000020")
        self.wait_for_red("the picture follows", 0.0, 0.1)
        window.close()
        program.wait("a notice says why", lambda s: "the window 'Game, level 1' was closed" in s["notice"])
        window = self.other_window("Game, level 2")
        self.addCleanup(window.close)
        window.do("fill c02020")
        again = self.other_window("Game, level 1")
        self.addCleanup(again.close)
        again.do("fill c02020")
        self.wait_for_red("it is found again", 0.3, 1.0)
        program.key("ctrl+z")
        program.wait("undo restores the source", lambda s: not s["driving_source"].startswith("window:"))

    def test_the_screen_leaves_out_the_window_itself(self):
        program = self.program
        program.click("look:crt")
        program.wait("the look is open", lambda s: s["look"] == "crt" and not s["is_loading"])
        self.show_live("screen:")
        program.wait("a notice says so", lambda s: "the window of Afterglow covers a part" in s["notice"])

    def test_a_wrong_live_source_keeps_the_dialog_open(self):
        program = self.program
        program.click("look:crt")
        program.wait("the look is open", lambda s: s["look"] == "crt" and not s["is_loading"])
        program.click("live_source")
        program.click("live_source_text")
        program.type("screen:area=wide")
        program.key("Return")
        program.place("dialog_problem")
        program.key("Escape")
        program.wait("the dialog is closed", lambda s: s["dialog"] == 0)
