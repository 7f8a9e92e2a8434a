"""The base class of the window tests: a shared program, its reset between tests, and checks of its
screen."""

import array
import json
import math
import tempfile
import unittest
import wave
from pathlib import Path

from drag import Drag
from program import Program
from screen import Screen

SOURCE = Path(__file__).resolve().parents[2]
PICTURES = SOURCE / "build/window"
WINDOW = (1280, 860)
PICTURE = [240, 180]


def write_tones(file, seconds):
    """Writes a sound that draws an ellipse: 220 Hz on both channels, a quarter period apart."""
    rate = 8000
    samples = array.array("h")
    for i in range(rate * seconds):
        turn = 2 * math.pi * 220 * i / rate
        samples.extend((round(24000 * math.sin(turn)), round(16000 * math.cos(turn))))
    with wave.open(str(file), "wb") as sound:
        sound.setnchannels(2)
        sound.setsampwidth(2)
        sound.setframerate(rate)
        sound.writeframes(samples.tobytes())


class Person(unittest.TestCase):
    """A user with a separate home folder, a small window and a small picture, because software GL is
    slow. After a failed test, the next one starts a new program."""

    executable = None  # set by the scripts that run the tests
    size = PICTURE
    cleanups = None

    @classmethod
    def setUpClass(cls):
        cls.cleanups = []
        cls.program = None

    @classmethod
    def tearDownClass(cls):
        cls.leave()

    @classmethod
    def leave(cls):
        if cls.program:
            cls.program.stop()
        cls.program = None
        for cleanup in reversed(cls.cleanups):
            cleanup(None, None, None)
        cls.cleanups = []

    @classmethod
    def enter(cls, manager):
        result = manager.__enter__()
        cls.cleanups.append(manager.__exit__)
        return result

    @classmethod
    def sit_down(cls):
        """Starts the program in an empty home folder, with the settings of a second start."""
        cls.screen = cls.enter(Screen(*WINDOW))
        folder = Path(cls.enter(tempfile.TemporaryDirectory(prefix="afterglow-window-")))
        cls.program = Program(cls.executable, SOURCE, folder, cls.screen)
        cls.arrange(cls.program)
        cls.program.arrange(*WINDOW, cls.size)
        cls.fresh = cls.program.start()
        cls.looks = folder / "data/shaders"
        cls.presets = folder / "data/presets"
        cls.own = folder / "own/afterglow"

    @classmethod
    def arrange(cls, program):
        """Changes the program before its start."""

    def setUp(self):
        if not self.program:
            self.sit_down()
        self.tidy_up()

    def run(self, result=None):
        bad = len(result.failures) + len(result.errors)
        super().run(result)
        if len(result.failures) + len(result.errors) > bad:
            if self.program:
                self.snapshot("failed_" + self.id().split(".")[-1])
            self.leave()

    def tidy_up(self):
        """Resets the look to its own values and signal, and waits until it plays."""
        program = self.program
        program.key("Escape")  # a popup would take the first click
        if program.state()["look"] != "phosphor":
            program.click("look:phosphor")
            program.wait("the look is open", lambda s: s["look"] == "phosphor")
        if program.state()["is_content_locked"]:
            program.click("keep_content")
            program.wait("the signal is unlocked", lambda s: not s["is_content_locked"])
        program.click("preset:")
        program.place("picture")  # waits until the click is processed
        return program.wait("the look has its defaults", self.is_tidy)

    def is_tidy(self, state):
        same = ("look", "preset", "values", "signal", "picture", "is_modified", "dialog")
        return (all(state.get(key) == self.fresh[key] for key in same) and
                state["is_playing"] and not state["is_loading"] and not state["reading"] and 2 < state["frame"] < 10000)

    def snapshot(self, name):
        self.screen.save(PICTURES / (name + ".png"))

    def brightness(self):
        """Mean brightness of the small picture, at the centre of its pane."""
        left, top, right, bottom = self.program.place("picture")
        x, y = (left + right) // 2, (top + bottom) // 2
        return self.screen.brightness((x - 150, y - 110, x + 150, y + 110))

    def restart_with_size(self, width, height):
        program = self.program
        program.quit()
        session = json.loads(program.session().read_text())
        session.update(follows_view=False, fits_shape=False, width=width, height=height)
        program.session().write_text(json.dumps(session))
        program.start()

    def hover(self, widget):
        self.screen.do("mousemove", *self.program.middle(widget))

    def column_at(self, x, y):
        """The column of the picture's pixel that the probe reports with the pointer there."""
        self.screen.do("mousemove", x + 1, y)
        turn = self.program.state()["turn"]
        self.program.wait("the pointer is processed", lambda s: s["turn"] > turn + 1)
        self.screen.do("mousemove", x, y)
        turn = self.program.state()["turn"]
        probe = self.program.wait("the value is reported", lambda s: s["turn"] > turn + 2)["probe"]
        return probe["x"]

    def open_by_name(self, file):
        """Types a path into the dialog for opening files."""
        self.program.key("ctrl+o")
        self.program.place("dialog_file")
        self.program.type(str(file))
        self.program.key("Return")

    def drop(self, file):
        drag = Drag(self.screen.display, [file])
        self.assertTrue(drag.drop(self.screen.window(), *self.program.middle("picture")))
        drag.close()
