"""What the panels cost the CPU: panels_bench.py PROGRAM. The window at 1280 x 720 under Xvfb with the
Phosphor look; what GL makes of their triangles is not in it."""

import statistics
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "window"))
from program import Program  # noqa: E402
from screen import Screen  # noqa: E402

SOURCE = Path(__file__).resolve().parents[2]
WINDOW = (1280, 720)
TURNS = 80


def costs(program):
    """Milliseconds of the next turns of the window."""
    seen = {}

    def is_enough(state):
        seen[state["turn"]] = state["panel_ms"]
        return len(seen) >= TURNS
    program.wait("%d turns" % TURNS, is_enough)
    return sorted(seen.values())


def report(what, program):
    times = costs(program)
    print("  %-34s %.2f ms (p95 %.2f)" % (what, statistics.median(times), times[int(0.95 * len(times))]))


def main():
    executable = Path(sys.argv[1]).resolve()
    print("The panels, CPU time a frame at %d x %d, median (p95):" % WINDOW)
    with Screen(*WINDOW) as screen, tempfile.TemporaryDirectory(prefix="afterglow-bench-") as folder:
        program = Program(executable, SOURCE, Path(folder), screen)
        program.arrange(*WINDOW, [64, 48])
        program.start()
        report("all panes, as at first", program)
        program.key("ctrl+3")
        program.wait("the inspector is closed", lambda s: "channels:RGB" not in s["widgets"])
        report("inspector closed", program)
        program.key("F11")
        report("only the picture", program)
        program.stop()


main()
