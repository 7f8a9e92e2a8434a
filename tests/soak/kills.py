#!/usr/bin/env python3
"""kills.py PROGRAM FOLDER [KILLS]: kills the program while it saves, and checks that each file is the old or the new one.

A fifth of KILLS (default: 1,000) each for presets and the session of the window, pictures, films and packs. A kill
comes at a random time after the temporary file was made. Results are kept in FOLDER, so a stopped run goes on.
"""

import ctypes
import fcntl
import json
import os
import random
import statistics
import struct
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import record

sys.path.insert(0, str(record.ROOT / "tests/window"))
from program import Program  # noqa: E402
from screen import Screen  # noqa: E402

PER_ROW = 20
TIMEOUT_SECONDS = 60
SIZE = "320x240"


class Watch:
    """Waits for events in a folder, with inotify(7)."""

    CREATED, MOVED = 0x100, 0x80

    def __init__(self, folder):
        libc = ctypes.CDLL(None, use_errno=True)
        self._file = os.fdopen(libc.inotify_init1(os.O_CLOEXEC | os.O_NONBLOCK), "rb", buffering=0)
        if libc.inotify_add_watch(self._file.fileno(), os.fsencode(folder), self.CREATED | self.MOVED) < 0:
            raise OSError(ctypes.get_errno(), f"can't watch {folder}")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._file.close()

    def wait(self, event):
        """Waits until a temporary file is created, or is moved to its name; returns the time of it."""
        end = time.monotonic() + TIMEOUT_SECONDS
        while time.monotonic() < end:
            events = self._file.read()
            now = time.monotonic()
            while events:
                _, mask, _, length = struct.unpack_from("iIII", events)
                name = events[16:16 + length].rstrip(b"\0")
                events = events[16 + length:]
                if mask & event and (event == self.MOVED or name.startswith(b".afterglow-")):
                    return now
            time.sleep(0.0001)
        raise AssertionError("no file was saved")


def leftovers(folder):
    return [file.name for file in folder.iterdir() if file.name.startswith(".afterglow-")]


def wait_for_writers(folder):
    """Waits until nothing writes to the temporary files: the encoder of a film ends a moment after the program."""
    for name in leftovers(folder):
        with (folder / name).open("rb") as file:
            fcntl.flock(file, fcntl.LOCK_EX)


def wait_randomly(span):
    """Up to the span, in seconds, and a bit longer. Half of all waits are zero: the event itself is late."""
    time.sleep(max(0.0, random.uniform(-1.5, 1.5) * span))


class Command:
    """Saves by a command: the first time with one value, and again with another one."""

    def __init__(self, program, kind, folder):
        self.folder = folder / kind
        self.folder.mkdir()
        end = {"picture": ".png", "film": ".mp4", "pack": ".afterglow"}[kind]
        self.file = self.folder / ("saved" + end)
        (folder / "other").mkdir()
        other = folder / "other" / self.file.name  # a pack contains its name
        self.command = self.arguments(program, kind, "0.95", self.file)
        self.run(self.arguments(program, kind, "0.5", self.file))
        self.old = self.file.read_bytes()
        self.run(self.arguments(program, kind, "0.95", other))
        self.new = other.read_bytes()
        assert self.old != self.new
        self.span = statistics.median(self.measure() for _ in range(5))  # s
        self.file.write_bytes(self.old)

    def arguments(self, program, kind, decay, file):
        look = [program, "pack" if kind == "pack" else "render"]
        if kind == "pack":
            preset = self.folder.parent / f"preset{decay}.json"
            self.run([program, "preset", "phosphor", "--set", f"decay={decay}", "--name", "Slow", "-o", preset])
            return [*look, "phosphor", preset, "-o", file]
        frames = ["--frames", "8"] if kind == "film" else []
        return [*look, "phosphor", "--size", SIZE, "--set", f"decay={decay}", *frames, "-o", file]

    @staticmethod
    def run(command):
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def measure(self):
        """Seconds from the temporary file to the saved one."""
        with Watch(self.folder) as watch, subprocess.Popen(self.command, stdout=subprocess.DEVNULL,
                                                           stderr=subprocess.DEVNULL):
            start = watch.wait(Watch.CREATED)
            return watch.wait(Watch.MOVED) - start

    def kill(self):
        """Kills it once; whether the file is the new one."""
        with Watch(self.folder) as watch:
            process = subprocess.Popen(self.command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            watch.wait(Watch.CREATED)
            wait_randomly(self.span)
            process.kill()
            process.wait()
        wait_for_writers(self.folder)
        content = self.file.read_bytes()
        assert content in (self.old, self.new), f"{self.file} is neither the old nor the new file"
        assert len(leftovers(self.folder)) <= 1, leftovers(self.folder)
        if content == self.new:
            self.file.write_bytes(self.old)
        return content == self.new

    def end(self):
        """A save that is not killed removes what was left."""
        self.run(self.command)
        assert self.file.read_bytes() == self.new and not leftovers(self.folder)

    def close(self):
        """Nothing runs between two kills."""


class Window:
    """Saves in the window: a preset by Ctrl+S, or the session by a change of a value."""

    def __init__(self, program, kind, folder):
        self.kind = kind
        self.screen = Screen(1000, 700).__enter__()
        self.program = Program(program, record.ROOT, folder, self.screen)
        self.program.arrange(1000, 700, [240, 180])
        self.program.start()
        self.program.set("decay", "0.5")
        self.program.key("ctrl+shift+s")
        self.program.answer("Mine")
        preset = folder / "own/afterglow/presets/phosphor/Mine.json"
        self.program.wait_for("the preset is saved", preset.exists)
        self.file = self.program.session() if kind == "session" else preset
        self.folder = self.file.parent
        self.value = None  # the last one
        self.span = statistics.median(self.measure() for _ in range(5))  # s

    def begin_save(self):
        """Changes the value; the last key saves it. Returns the process that presses the key."""
        self.value = round(random.uniform(0.1, 0.98), 4)
        key = "Return"
        if self.kind == "session":
            self.program.reveal("decay")
            self.program.click("number:decay")
            self.program.type(str(self.value))
        else:
            self.program.set("decay", str(self.value))
            key = "ctrl+s"
        return subprocess.Popen(["xdotool", "key", key], env={**os.environ, "DISPLAY": self.screen.display})

    def measure(self):
        with Watch(self.folder) as watch:
            with self.begin_save():
                start = watch.wait(Watch.CREATED)
                return watch.wait(Watch.MOVED) - start

    def saved(self):
        """The value in the file. A file that is cut or mixed is not JSON, or has another value."""
        content = json.loads(self.file.read_text())
        return (content["current"]["preset"] if self.kind == "session" else content)["values"]["decay"]

    def kill(self):
        before = self.value
        self.program.wait_for("the last value is saved", lambda: self.saved() == before)
        with Watch(self.folder) as watch, self.begin_save():
            watch.wait(Watch.CREATED)
            wait_randomly(self.span)
            self.program.kill()
        now = self.saved()
        assert now in (before, self.value), f"{self.file} has the value {now}, not {before} or {self.value}"
        assert len(leftovers(self.folder)) <= 1, leftovers(self.folder)
        state = self.program.start()
        assert self.kind != "session" or state["values"]["decay"] == [now], state["values"]["decay"]
        assert self.kind != "preset" or state["preset"] == "Mine", state["preset"]
        is_new, self.value = now == self.value, now
        return is_new

    def end(self):
        with Watch(self.folder) as watch, self.begin_save():
            watch.wait(Watch.MOVED)
        self.program.quit()
        assert not leftovers(self.folder)

    def close(self):
        self.program.stop()
        self.screen.__exit__()


KINDS = {"preset": Window, "session": Window, "picture": Command, "film": Command, "pack": Command}


def kill_often(program, kind, rows, wanted, budget):
    with tempfile.TemporaryDirectory(prefix="afterglow-kills-") as folder:
        saver = KINDS[kind](program, kind, Path(folder))
        try:
            while (missing := wanted - rows.total("kills", kind=kind)) > 0 and budget.left() > 0:
                count = min(PER_ROW, missing)
                rows.add(kind=kind, kills=count, new=sum(saver.kill() for _ in range(count)))
                print(f"{kind}: {rows.total('kills', kind=kind)} of {wanted} kills", flush=True)
            saver.end()
        finally:
            saver.close()


def lines(rows):
    table = [record.stamp(), "", "| saved | kills | kept the old file | had the new file | lost |",
             "| --- | --- | --- | --- | --- |"]
    for kind in KINDS:
        kills, new = rows.total("kills", kind=kind), rows.total("new", kind=kind)
        table.append(f"| {kind} | {kills:,} | {kills - new:,} | {new:,} | none |")
    return table


def main():
    program = Path(sys.argv[1]).resolve()
    wanted = (int(sys.argv[3]) if len(sys.argv) > 3 else 1000) // len(KINDS)
    rows = record.Rows(Path(sys.argv[2]) / "kills.jsonl", lambda _: record.CODE["kills"])
    budget = record.Budget()
    for kind in KINDS:
        if rows.total("kills", kind=kind) < wanted:
            kill_often(program, kind, rows, wanted, budget)
    record.write("kills", lines(rows))
    if any(rows.total("kills", kind=kind) < wanted for kind in KINDS):
        sys.exit("The time is over. Run it again for the rest.")
    return 0


if __name__ == "__main__":
    sys.exit(main())
