"""Cost of the paused window: idle_bench.py PROGRAM. Phosphor at 1280 x 720 under Xvfb. Measures the
CPU time of the program and its redraws over ten seconds without input."""

import os
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
SECONDS = 10
AT_MOST = 1.0  # percent of a core


def cpu_seconds(process):
    fields = Path("/proc/%d/stat" % process.pid).read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def fall_asleep(program):
    """Waits until the program has drawn nothing for three seconds."""
    seen = {"turn": None, "since": 0.0}

    def sleeps(state):
        if state["turn"] != seen["turn"]:
            seen.update(turn=state["turn"], since=time.monotonic())
        return time.monotonic() - seen["since"] > 3
    program.wait("the window is idle", sleeps)


def report(key, what, program):
    fall_asleep(program)
    before, turn = cpu_seconds(program.process), program.state()["turn"]
    time.sleep(SECONDS)
    share = 100 * (cpu_seconds(program.process) - before) / SECONDS
    tell("idle", "Paused window, Phosphor at %d x %d, over %d s" % (*WINDOW, SECONDS), key, what, share,
         "% of a core", at_most=AT_MOST, detail="window redraws: %d" % (program.state()["turn"] - turn))


def main():
    executable = Path(sys.argv[1]).resolve()
    with Screen(*WINDOW) as screen, tempfile.TemporaryDirectory(prefix="afterglow-bench-") as folder:
        program = Program(executable, SOURCE, Path(folder), screen)
        program.arrange(*WINDOW, [640, 360])
        program.start()
        program.key("space")
        report("all", "default panels", program)
        program.key("ctrl+3")
        program.wait("the inspector is closed", lambda s: "channels:RGB" not in s["widgets"])
        report("no-inspector", "inspector closed", program)
        program.key("F11")
        report("picture", "full screen", program)
        program.stop()


main()
