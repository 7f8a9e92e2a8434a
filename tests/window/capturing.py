"""Live sources: a window of another program through a look."""

import os
import subprocess
import sys
from pathlib import Path

from person import PICTURE, Person

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "capture"))
from painted_window import PaintedWindow  # noqa: E402


class Capturing(Person):
    def other_window(self, title):
        program = self.program.executable.parents[1] / "tests" / "painted_window"
        window = PaintedWindow(program, self.screen.display, title, 40, 40, 320, 240)
        window.do("lower")
        return window

    def open_crt_and_game(self):
        """Opens CRT, and a red window, which is returned."""
        window = self.other_window("Game")
        self.addCleanup(window.close)
        window.do("fill c02020")
        self.program.click("look:crt")
        self.program.wait("the look is open", lambda s: s["look"] == "crt" and not s["is_loading"])
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

    def test_the_overlay_stays_over_the_window(self):
        program, screen = self.program, self.screen
        window = self.open_crt_and_game()
        program.key("ctrl+shift+F12")
        program.wait("a window is asked for", lambda s: "needs a window as its source" in s["notice"])
        self.show_live("window:Game")
        window.do("raise")
        program.key("ctrl+shift+F12")
        program.wait("the overlay is open", lambda s: s["output"] == "overlay")

        def colours(left, top, right, bottom):
            """The colours of a column in the middle, as blue, green, red."""
            middle = (left + right) // 2
            return {row[:3] for row in screen.rows(middle, top, middle + 1, bottom)}

        def is_drawn(*place):
            """Whether the look draws the red window here: with scanlines."""
            reds = {red for blue, green, red in colours(*place) if blue < 90 and green < 90 and red > 120}
            return bool(reds) and max(reds) - min(reds) > 10

        program.wait_for("the look covers the window", lambda: is_drawn(60, 60, 340, 260))
        program.wait("the picture has the size of the window", lambda s: s["picture"] == [320, 240])
        self.snapshot("overlay")
        window.do("move 800 400")
        program.wait_for("it follows the window", lambda: is_drawn(820, 420, 1100, 620))
        window.do("resize 200 160")
        program.wait("the picture follows its size", lambda s: s["picture"] == [200, 160])
        program.wait_for("it has the size of the window", lambda: is_drawn(820, 420, 980, 540)
                         and not is_drawn(1010, 420, 1100, 540))
        self.assertEqual(self.window_at(840, 480), self.window_named("Game"), "clicks go to the window below")
        window.do("hide")
        program.wait("the hidden window is a problem", lambda s: s["problems"])
        program.wait_for("it is hidden with the window", lambda: not is_drawn(820, 420, 980, 540))
        window.do("show")
        program.wait_for("it returns with the window", lambda: is_drawn(820, 420, 980, 540))
        program.wait("the problem is solved", lambda s: not s["problems"])
        window.do("lower")
        program.wait_for("it is covered with the window", lambda: not is_drawn(820, 420, 980, 540))
        window.do("raise")
        program.wait_for("it is above again", lambda: is_drawn(820, 420, 980, 540))
        program.key("ctrl+shift+F12")
        program.wait("the overlay is closed", lambda s: s["output"] == "off")
        program.wait_for("the window is visible", lambda: colours(820, 420, 980, 540) == {bytes([0x20, 0x20, 0xC0])})
        program.wait("the picture has its own size", lambda s: s["picture"] == PICTURE)

    def test_the_overlay_closes_with_another_source(self):
        program = self.program
        self.open_crt_and_game()
        self.show_live("window:Game")
        program.key("ctrl+shift+F12")
        program.wait("the overlay is open", lambda s: s["output"] == "overlay")
        program.key("F12")
        program.wait("the output window replaces it", lambda s: s["output"] == "on")
        program.key("ctrl+shift+F12")
        program.wait("the overlay is open again", lambda s: s["output"] == "overlay")
        program.key("ctrl+z")
        program.wait("it closes with its source", lambda s: s["output"] == "off")

    def window_at(self, x, y):
        """The window that gets a click at a point of the screen."""
        self.screen.do("mousemove", x, y)
        return self.window_number("getmouselocation", "--shell").split("WINDOW=")[1].split()[0]

    def window_named(self, title):
        return self.window_number("search", "--name", f"^{title}$").split()[0]

    def window_number(self, *words):
        return subprocess.run(["xdotool", *words], check=True, capture_output=True, text=True,
                              env={**os.environ, "DISPLAY": self.screen.display}).stdout
