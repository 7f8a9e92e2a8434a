"""CPU time of the panels: panels_bench.py PROGRAM. The window at 1280 x 720 under Xvfb, with
Phosphor and with a look of 50 passes and 1,000 parameters. GL drawing is not included."""

import json
import statistics
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "window"))
from figure import tell  # noqa: E402
from program import Program  # noqa: E402
from screen import Screen  # noqa: E402

SOURCE = Path(__file__).resolve().parents[2]
WINDOW = (1280, 720)
TURNS = 80


def costs(program):
    """CPU time of the panels in the next redraws of the window, in ms, sorted."""
    seen = {}

    def is_enough(state):
        seen[state["turn"]] = state["panel_ms"]
        return len(seen) >= TURNS
    program.wait("%d window redraws" % TURNS, is_enough)
    return sorted(seen.values())


def report(key, what, program):
    times = costs(program)
    tell("panels", "Panels: CPU time per frame at %d x %d" % WINDOW, key, what, statistics.median(times), "ms",
         detail="p95 %.3g" % times[int(0.95 * len(times))])


def write_large_look(folder):
    """Writes a look of 50 passes with 20 parameters each."""
    folder.mkdir()
    passes = [{"name": "pass%d" % i, "fragment": "%d.frag" % i, "size": [8, 8], "inputs": {"before": "pass%d%s" % (max(i - 1, 0), "" if i else "@1")}}
              for i in range(50)]
    (folder / "look.json").write_text(json.dumps({"format": "afterglow-look", "version": 1, "name": "Large", "driven_by": "nothing", "passes": passes}))
    for i in range(50):
        names = ["knob_%d_%d" % (i, j) for j in range(20)]
        (folder / ("%d.frag" % i)).write_text(
            "#version 410 core\nuniform sampler2D before;\nuniform float u_time;\nin vec2 uv;\nout vec4 color;\n" +
            "".join('uniform float %s = 0.25;  // @range 0 1 @group "Pass %d"\n' % (name, i) for name in names) +
            "void main() { color = fract(texture(before, uv) + u_time + %s); }\n" % " + ".join(names))


def measure_large(executable, folder, screen):
    program = Program(executable, SOURCE, folder, screen)
    program.arrange(*WINDOW, [64, 48])
    write_large_look(folder / "large")
    program.start(folder / "large")
    report("large", "50 passes, 1,000 parameters", program)
    program.click("parameter:knob_0_3")
    report("large-turned", "50 passes, 1,000 parameters, one changed", program)
    program.key("ctrl+f")
    program.type("knob")
    report("large-search", "50 passes, 1,000 parameters, search that matches all", program)
    program.stop()


def main():
    executable = Path(sys.argv[1]).resolve()
    with Screen(*WINDOW) as screen, tempfile.TemporaryDirectory(prefix="afterglow-bench-") as folder:
        program = Program(executable, SOURCE, Path(folder), screen)
        program.arrange(*WINDOW, [64, 48])
        program.start()
        report("all", "default panels", program)
        program.key("ctrl+3")
        program.wait("the inspector is closed", lambda s: "channels:RGB" not in s["widgets"])
        report("no-inspector", "inspector closed", program)
        program.key("F11")
        report("picture", "full screen", program)
        program.stop()
        (Path(folder) / "large").mkdir()
        measure_large(executable, Path(folder) / "large", screen)


main()
