"""Time from the start of the window to its first picture: start_bench.py PROGRAM. Phosphor at
1280 x 720 under Xvfb, with a saved session and warm caches. Starts alternate with those of a plain
window that only has a context. Wall time from the start of the process, CPU time of its threads."""

import os
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "window"))
from figure import tell  # noqa: E402
from program import Program  # noqa: E402
from screen import Screen  # noqa: E402

SOURCE = Path(__file__).resolve().parents[2]
WINDOW = (1280, 720)
STARTS = 15
FIRST_STARTS = 3  # these fill the caches for the others
TIMEOUT_SECONDS = 30
OPEN_SECONDS = 2  # of a start before its end: a program that ends earlier counts as crashed
GOAL_MS = 300


def cpu_ms(process):
    """CPU time of all threads of a process so far."""
    spent = 0
    for thread in Path("/proc/%d/task" % process.pid).iterdir():
        spent += int((thread / "schedstat").read_text().split()[0])
    return spent / 1e6


class Start:
    """A program between its start and its first picture."""

    def __init__(self, command, environment):
        self.begun = time.monotonic()
        self.process = subprocess.Popen(command, env=environment, stdin=subprocess.PIPE,
                                        stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)

    def shown(self):
        """Wall time and CPU time so far, in ms."""
        return 1e3 * (time.monotonic() - self.begun), cpu_ms(self.process)

    def end(self):
        self.process.kill()
        self.process.communicate()


def plain_start(plain, environment):
    start = Start([plain], environment)
    assert start.process.stdout.readline() == b"shown\n", "can't open a window"
    times = start.shown()
    start.end()
    return times


def our_start(program, environment):
    program.state_file.unlink(missing_ok=True)
    start = Start([program.executable], environment)
    while b'"has_picture":true' not in state_of(program):
        assert start.process.poll() is None, "the program exited"
        assert time.monotonic() - start.begun < TIMEOUT_SECONDS, "no picture within %d s" % TIMEOUT_SECONDS
        time.sleep(0.0005)
    times = start.shown()
    time.sleep(OPEN_SECONDS)
    start.end()
    return times


def state_of(program):
    try:
        return program.state_file.read_bytes()
    except FileNotFoundError:
        return b""


def environment_of(program):
    folder = program.folder
    return {**program.environment(), "XDG_CACHE_HOME": str(folder / "cache"),
            "MESA_SHADER_CACHE_DIR": str(folder / "driver")}


def warm_up(program):
    os.environ.update({key: environment_of(program)[key]
                       for key in ("XDG_CACHE_HOME", "MESA_SHADER_CACHE_DIR")})
    for _ in range(FIRST_STARTS):
        program.start()
        time.sleep(2)  # programs drawn after the first picture are cached, too
        program.quit()


def report(key, what, plain, ours, at_most=None):
    over = [b - a for a, b in zip(plain, ours)]
    tell("start", "Window start, Phosphor at %d x %d, medians of %d" % (*WINDOW, STARTS), key,
         "first picture: %s above a plain window" % what, statistics.median(over), "ms", at_most=at_most,
         detail="%.0f to %.0f ms; %.0f ms, plain window %.0f ms" % (min(over), max(over), statistics.median(ours), statistics.median(plain)))


def main():
    executable = Path(sys.argv[1]).resolve()
    plain = executable.parents[1] / "tests/bench/plain_window"
    with Screen(*WINDOW) as screen, tempfile.TemporaryDirectory(prefix="afterglow-bench-",
                                                                ignore_cleanup_errors=True) as folder:
        program = Program(executable, SOURCE, Path(folder), screen)
        warm_up(program)
        environment = environment_of(program)
        starts = [(plain_start(plain, environment), our_start(program, environment)) for _ in range(STARTS)]
        for key, what, kind, at_most in (("cpu", "CPU time", 1, None), ("wall", "wall time", 0, GOAL_MS)):
            report(key, what, [a[kind] for a, _ in starts], [b[kind] for _, b in starts], at_most)


if __name__ == "__main__":
    main()
