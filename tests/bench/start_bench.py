"""How long the window takes to its first picture: start_bench.py PROGRAM. Phosphor at 1280 x 720 under
Xvfb, as a person left it, caches warm; in turn with a plain window, which has a context and nothing
else. Wall time from the start of the process, and CPU time of all its threads until then."""

import os
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "window"))
from program import Program  # noqa: E402
from screen import Screen  # noqa: E402

SOURCE = Path(__file__).resolve().parents[2]
WINDOW = (1280, 720)
STARTS = 15
FIRST_STARTS = 3  # what they find out is kept for the others
PATIENCE_SECONDS = 30
GOAL_MS = 150


def cpu_ms(process):
    """Of all threads of a process, so far."""
    spent = 0
    for thread in Path("/proc/%d/task" % process.pid).iterdir():
        spent += int((thread / "schedstat").read_text().split()[0])
    return spent / 1e6


class Start:
    """A program's way to what it shows first."""

    def __init__(self, command, environment):
        self.begun = time.monotonic()
        self.process = subprocess.Popen(command, env=environment, stdin=subprocess.PIPE,
                                        stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)

    def shown(self):
        """Milliseconds on the clock and of CPU time."""
        return 1e3 * (time.monotonic() - self.begun), cpu_ms(self.process)

    def end(self):
        self.process.kill()
        self.process.communicate()


def plain_start(plain, environment):
    start = Start([plain], environment)
    assert start.process.stdout.readline() == b"shown\n", "no window can be opened"
    times = start.shown()
    start.end()
    return times


def our_start(program, environment):
    program.state_file.unlink(missing_ok=True)
    start = Start([program.executable], environment)
    while b'"has_picture":true' not in state_of(program):
        assert start.process.poll() is None, "the program ended"
        assert time.monotonic() - start.begun < PATIENCE_SECONDS, "no picture comes"
        time.sleep(0.0005)
    times = start.shown()
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
        time.sleep(2)  # what is drawn after the first picture is kept, too
        program.quit()


def report(what, plain, ours):
    over = [b - a for a, b in zip(plain, ours)]
    print("  %-10s a context %6.1f ms   our first picture %6.1f ms   over it %6.1f ms (%.1f to %.1f; goal %d)" % (
        what, statistics.median(plain), statistics.median(ours), statistics.median(over), min(over), max(over),
        GOAL_MS))


def main():
    executable = Path(sys.argv[1]).resolve()
    plain = executable.parents[1] / "tests/bench/plain_window"
    with Screen(*WINDOW) as screen, tempfile.TemporaryDirectory(prefix="afterglow-bench-",
                                                                ignore_cleanup_errors=True) as folder:
        program = Program(executable, SOURCE, Path(folder), screen)
        warm_up(program)
        environment = environment_of(program)
        starts = [(plain_start(plain, environment), our_start(program, environment)) for _ in range(STARTS)]
        print("The window's start, medians of %d:" % STARTS)
        for what, kind in (("CPU time", 1), ("wall time", 0)):
            report(what, [a[kind] for a, _ in starts], [b[kind] for _, b in starts])


if __name__ == "__main__":
    main()
