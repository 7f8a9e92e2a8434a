"""Reading a screen that changes 30 times a second: capture_bench.py PROGRAM. Time from a change on
the screen to the picture, and CPU time next to FFmpeg's x11grab at 30 pictures per second, which
reads the same screen under Xvfb. A window of 640 x 360 in a screen of 1920 x 1080 changes. Then the
program draws such a window with CRT, in its render size, and the time counts until the picture is on
the screen."""

import mmap
import os
import random
import statistics
import struct
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "window"))
from figure import tell  # noqa: E402
from program import Program  # noqa: E402
from screen import Screen  # noqa: E402

SCREEN = (1920, 1080)
RATE = 30
SECONDS = 8
FRAME_MS = 1000 / RATE
LOOK_CHANGES = 120
TOPIC = "capture"
TITLE = "Live sources"


def cpu_seconds(process):
    """CPU time of a process that has ended."""
    before = os.times()
    process.wait()
    after = os.times()
    return after.children_user + after.children_system - before.children_user - before.children_system


class Window:
    """A window that changes its colour."""

    def __init__(self, program, environment, width, height):
        self.process = subprocess.Popen([program, "Bench", "0", "0", str(width), str(height)], text=True,
                                        env=environment, stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        self.process.stdout.readline()

    def fill(self, color):
        """Returns when the window has changed, in s of the monotonic clock."""
        begun = time.monotonic()
        print("fill %06x" % color, file=self.process.stdin, flush=True)
        self.process.stdout.readline()
        return begun

    def lower(self):
        print("lower", file=self.process.stdin, flush=True)
        self.process.stdout.readline()

    def play(self, seconds):
        """Changes the colour at the rate; (time, colour) of each change."""
        changes = []
        begun = time.monotonic()
        while time.monotonic() < begun + seconds:
            color = 1 + len(changes)
            changes.append((self.fill(color), color))
            time.sleep(max(0.0, begun + len(changes) / RATE - time.monotonic()))
        return changes

    def close(self):
        self.process.stdin.close()
        self.process.wait()


def delays_of(lines, changes):
    """ms from each change to its picture."""
    shown = {}
    for line in lines:
        when, red, green, blue = line.split()
        shown.setdefault(int(red) << 16 | int(green) << 8 | int(blue), float(when))
    return [1000 * (shown[color] - when) for when, color in changes if color in shown]


def ours(reader, window, environment):
    """Delays in ms, CPU time in s."""
    process = subprocess.Popen([reader, "screen:"], env=environment, stdin=subprocess.PIPE,
                               stdout=subprocess.PIPE, text=True)
    process.stdout.readline()
    changes = window.play(SECONDS)
    time.sleep(0.3)
    process.stdin.close()
    lines = process.stdout.read().splitlines()
    return delays_of(lines, changes), cpu_seconds(process)


def theirs(window, environment):
    """CPU time of ffmpeg in s."""
    process = subprocess.Popen(
        ["ffmpeg", "-v", "error", "-nostdin", "-f", "x11grab", "-framerate", str(RATE), "-video_size",
         "%dx%d" % SCREEN, "-draw_mouse", "0", "-i", environment["DISPLAY"], "-t", str(SECONDS), "-f", "null", "-"],
        env=environment, stderr=subprocess.DEVNULL)
    window.play(SECONDS)
    return cpu_seconds(process)


def measure(folder, width, height):
    with Screen(*SCREEN) as screen:
        environment = {**os.environ, "DISPLAY": screen.display}
        window = Window(folder.parent / "painted_window", environment, width, height)
        delays, our_cpu = ours(folder / "capture_reader", window, environment)
        their_cpu = theirs(window, environment)
        window.close()
    return delays, our_cpu, their_cpu


class Pixel:
    """The brightness of a pixel of a virtual screen, read without a request to the server."""

    def __init__(self, screen, x, y):
        with (screen.folder / "Xvfb_screen0").open("rb") as file:
            self.memory = mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ)
        header = struct.unpack(">25I", self.memory[:100])  # X11/XWDFile.h
        self.at = header[0] + header[19] * 12 + y * header[12] + x * 4

    def wait(self, is_bright):
        """Returns the time when it is bright or dark; None: it did not change within 2 s."""
        end = time.monotonic() + 2
        while time.monotonic() < end:
            if (self.memory[self.at] > 60) == is_bright:
                return time.monotonic()
            time.sleep(0.0003)
        return None


def measure_look(folder):
    """Delays in ms from a change of a window to the picture of CRT on the screen, and the ms of one of our
    frames meanwhile."""
    program_file = folder.parents[1] / "app/afterglow"
    with Screen(1280, 860) as screen, tempfile.TemporaryDirectory() as home:
        program = Program(program_file, Path(__file__).resolve().parents[2], Path(home), screen)
        program.arrange(1280, 860, [640, 360])
        program.start("crt")
        window = Window(folder.parent / "painted_window", program.environment(), 640, 360)
        window.fill(0)
        window.lower()
        program.click("live_source")
        program.click("live:window:Bench")
        program.click("dialog_ok")
        program.wait("the source is shown", lambda s: s["dialog"] == 0 and s["driving_source"].startswith("window:Bench"))
        x, y = program.middle("picture")
        pixel = Pixel(screen, int(x), int(y))
        delays = []
        begun_turn, begun_time = program.state()["turn"], time.monotonic()
        for change in range(LOOK_CHANGES):
            is_bright = change % 2 == 0
            time.sleep(random.uniform(0.08, 0.12))
            begun = window.fill(0xC0C0C0 if is_bright else 0)
            shown = pixel.wait(is_bright)
            if shown:
                delays.append(1000 * (shown - begun))
        frame = 1000 * (time.monotonic() - begun_time) / (program.state()["turn"] - begun_turn)
        window.close()
        program.quit()
    return delays, frame


def main():
    folder = Path(__file__).resolve().parents[2] / "build/release/tests/bench"
    for width, height in ((640, 360), SCREEN):
        delays, our_cpu, their_cpu = measure(folder, width, height)
        delays.sort()
        part = "%d x %d px of the screen" % (width, height)
        detail = "%d changes" % len(delays)
        tell(TOPIC, TITLE, "capture-median-%d" % width, "change of %s to picture, median" % part,
             statistics.median(delays), "ms", FRAME_MS, detail)
        tell(TOPIC, TITLE, "capture-p95-%d" % width, "change of %s to picture, 95th percentile" % part,
             delays[len(delays) * 95 // 100], "ms", FRAME_MS, detail)
        tell(TOPIC, TITLE, "capture-cpu-%d" % width, "CPU time next to FFmpeg's x11grab, %s change" % part,
             our_cpu / their_cpu, "x", 1.0, "%.2f s and %.2f s" % (our_cpu, their_cpu))
    delays, our_frame = measure_look(folder)
    delays.sort()
    detail = "%d of %d changes; one of our frames: %.1f ms" % (len(delays), LOOK_CHANGES, our_frame)
    goal = FRAME_MS + our_frame
    tell(TOPIC, TITLE, "capture-look-median", "change of a window of 640 x 360 px to CRT's picture on the screen, median",
         statistics.median(delays), "ms", goal, detail)
    tell(TOPIC, TITLE, "capture-look-p95", "the same, 95th percentile", delays[len(delays) * 95 // 100], "ms", goal,
         detail)


if __name__ == "__main__":
    main()
