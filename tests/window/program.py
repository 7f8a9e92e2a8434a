"""The program on a virtual screen, controlled like by a user."""

import json
import os
import shutil
import signal
import subprocess
import time
from pathlib import Path

TIMEOUT_SECONDS = 30


class Program:
    """Afterglow with its own copy of the looks and presets, and its own home folder."""

    def __init__(self, executable, source, folder, screen):
        self.executable = executable
        self.screen = screen
        self.folder = folder
        self.state_file = folder / "state.json"
        self.editor_log = folder / "editor.log"
        self.bus = "disabled:"  # no session bus: the program's own file dialog opens
        self.variables = {}  # further environment variables
        for part in ("shaders", "presets"):
            shutil.copytree(source / part, folder / "data" / part)
        editor = folder / "editor"
        editor.write_text('#!/bin/sh\necho "$@" >> "%s"\n' % self.editor_log)
        editor.chmod(0o755)

    def arrange(self, width, height, picture):
        """Writes a session like after a first use: a window of this size and a small picture. The look's
        figure gets few points, because software GL is slow."""
        manifest = self.folder / "data/shaders/phosphor/look.json"
        look = json.loads(manifest.read_text())
        look["default_signal"]["points"] = 512
        manifest.write_text(json.dumps(look, indent=2))
        session = self.session()
        session.parent.mkdir(parents=True, exist_ok=True)
        session.write_text(json.dumps({
            "format": "afterglow-session", "version": 1,
            "look": str(self.folder / "data/shaders/phosphor/look.json"),
            "follows_view": False, "width": picture[0], "height": picture[1],
            "window": {"width": width, "height": height}}))

    def forget_look(self):
        """Removes the look from the session, as if none had been opened."""
        session = json.loads(self.session().read_text())
        self.session().write_text(json.dumps({**session, "look": ""}))

    def session(self):
        """The session file."""
        return self.folder / "state/afterglow/session.json"

    def environment(self):
        """The environment variables of the program."""
        return {**os.environ, "DISPLAY": self.screen.display, "HOME": str(self.folder),
                "XDG_DATA_HOME": str(self.folder / "own"),
                "XDG_STATE_HOME": str(self.folder / "state"),
                "XDG_CONFIG_HOME": str(self.folder / "config"),
                "AFTERGLOW_DATA": str(self.folder / "data"),
                "AFTERGLOW_STATE_FILE": str(self.state_file),
                "DBUS_SESSION_BUS_ADDRESS": self.bus, "VISUAL": str(self.folder / "editor"),
                "LIBGL_ALWAYS_SOFTWARE": "1", **self.variables}

    def start(self, *arguments):
        self.state_file.unlink(missing_ok=True)
        self.process = subprocess.Popen([self.executable, *arguments], env=self.environment())
        return self.wait("a look is open and drawn", lambda s: s.get("look") and s["frame"] > 2)

    def state(self):
        try:
            return json.loads(self.state_file.read_text())
        except FileNotFoundError:
            return {}

    def wait(self, what, is_true):
        """Waits until `is_true` for the state, and returns it. Reports `what` after a timeout."""
        end = time.monotonic() + TIMEOUT_SECONDS
        state = {}
        while time.monotonic() < end:
            if self.process.poll() is not None:
                raise AssertionError("the program ended (%s) before: %s" % (self.process.returncode, what))
            state = self.state()
            if state and is_true(state):
                return state
            time.sleep(0.02)
        shown = {key: state.get(key) for key in state if key not in ("widgets", "values")}
        raise AssertionError("never happened: %s\nlast state: %s" % (what, shown))

    def wait_for(self, what, is_true):
        """Like `wait`, for conditions outside the state."""
        self.wait(what, lambda _: is_true())

    def place(self, widget):
        """The rectangle of a widget, once it is constant after all input is processed."""
        rows = {"preset": "preset_rows", "look": "look_rows"}.get(widget.split(":")[0]) if ":" in widget else None
        if rows:
            self.scroll_to(widget, rows)
        seen = {"place": None, "since": 0, "turn": 0, "time": 0.0}

        def is_still(state):
            place, turn = state["widgets"].get(widget), state["turn"]
            if rows and place is None:
                self.scroll_to(widget, rows)  # the list scrolled by itself, to what has just been opened
            if turn != seen["turn"]:
                seen.update(turn=turn, time=time.monotonic())
            if place != seen["place"] or state["is_behind"] or place is None:
                seen.update(place=place, since=turn)
                return False
            is_asleep = time.monotonic() - seen["time"] > 1
            return turn > seen["since"] + 1 or is_asleep
        return self.wait("a widget named '%s'" % widget, is_still)["widgets"][widget]

    def scroll_to(self, widget, rows):
        """Scrolls a list by the wheel until a row is within its pane."""
        def shown(state):
            return {name: place for name, place in state["widgets"].items()
                    if name.startswith(widget.split(":")[0] + ":")}

        state = self.wait("the list '%s'" % rows, lambda s: rows in s["widgets"])
        direction = -1  # up; of a row that is not drawn, only the end of the list shows the direction
        before = None
        for _ in range(60):
            (left, top, right, bottom), row = state["widgets"][rows], state["widgets"].get(widget)
            if row and top + 2 < (row[1] + row[3]) / 2 < bottom - 2:
                return
            if row:
                direction = -1 if row[1] < top else 1
            elif shown(state) == before:
                direction = -direction
            before = shown(state)
            self.screen.do("mousemove", (left + right) // 2, (top + bottom) // 2, "click", 4 if direction < 0 else 5)
            state = self.wait("the wheel is processed", lambda s: s["turn"] > state["turn"] + 2)

    def middle(self, widget):
        left, top, right, bottom = self.place(widget)
        return (left + right) // 2, (top + bottom) // 2

    def click(self, widget):
        self.screen.do("mousemove", *self.middle(widget), "click", 1)

    def drag(self, start, end, button=1):
        """Presses at `start`, moves to `end` in steps, releases, and waits until the program has
        processed all input."""
        words = ["mousemove", *start, "mousedown", button]
        for step in range(1, 9):
            words += ["mousemove", *(round(a + (b - a) * step / 8) for a, b in zip(start, end)), "sleep", 0.03]
        self.screen.do(*words, "mouseup", button)
        self.place("picture")

    def slider(self, name):
        """Left end, right end and vertical centre of a parameter's slider."""
        left, top, _, bottom = self.place("parameter:" + name)
        number = self.place("number:" + name)
        return left + 2, number[0] - 8, (top + bottom) // 2

    def reveal(self, name, search=None):
        """Brings a parameter into view with the search box: by its name, or as the first match."""
        self.key("ctrl+f", "ctrl+a")
        self.type(search or name)
        self.wait("the parameter '%s' is shown" % name,
                  lambda s: "parameter:" + name in s["widgets"])
        self.key("Return")

    def choose(self, menu, action):
        """Chooses an action from a menu."""
        self.click("menu:" + menu)
        self.click("menu:" + action)

    def answer(self, text):
        """Types into the dialog for a name, and confirms."""
        self.place("dialog_name")
        self.key("ctrl+a")
        self.type(text)
        self.key("Return")
        self.wait("the dialog is closed", lambda s: s["dialog"] == 0)

    def edited_files(self):
        """The arguments of all starts of the user's editor, one line each."""
        return self.editor_log.read_text() if self.editor_log.exists() else ""

    def set(self, name, text):
        """Types a parameter's value and waits until it is set."""
        if "number:" + name not in self.state()["widgets"]:
            self.reveal(name)
        self.click("number:" + name)
        self.type(text)
        self.key("Return")
        self.wait("'%s' is %s" % (name, text), lambda s: s["values"][name][0] == float(text))

    def retype(self, name, text):
        """Types a value into the number field of a visible parameter."""
        self.click("number:" + name)
        self.type(text)
        self.key("Return")

    def key(self, *keys):
        self.screen.do("key", *keys)

    def type(self, text):
        self.screen.do("type", text)

    def quit(self):
        self.key("ctrl+q")
        self.process.wait(TIMEOUT_SECONDS)
        assert self.process.returncode == 0, "the program ended with %s" % self.process.returncode

    def kill(self):
        self.process.send_signal(signal.SIGKILL)
        self.process.wait()

    def stop(self):
        if getattr(self, "process", None) and self.process.poll() is None:
            self.kill()
