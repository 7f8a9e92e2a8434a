#!/usr/bin/env python3
"""reloads.py PROGRAM FOLDER [RELOADS]: saves shaders of a running look RELOADS times (default: 10,000).

After every 100 reloads, memory, GL objects, descriptors and threads of the window are noted. They must stay flat.
Results are kept in FOLDER, so a stopped run goes on, in a new process. Draws docs/reliability/reloads.svg.
"""

import json
import statistics
import sys
import tempfile
from pathlib import Path

import record

sys.path.insert(0, str(record.ROOT / "tests/window"))
from program import Program  # noqa: E402
from screen import Screen  # noqa: E402

LOOK = {"format": "afterglow-look", "version": 1, "name": "Small", "driven_by": "picture",
        "default_source": "pattern:smpte", "passes": [
            {"name": "first", "fragment": "first.frag", "inputs": {"scene": "source"}},
            {"name": "second", "fragment": "second.frag", "inputs": {"image": "first", "previous": "second@1"}}]}
TINT = "vec3 tinted(vec3 light) {{ return light * vec3(1.0, {}, 0.5); }}\n"
FIRST = """#version 410 core
#include "tint.glsl"
uniform sampler2D scene;
uniform float gain = {default};  // @range 0 1
{more}in vec2 uv;
out vec4 color;
void main() {{ color = vec4(tinted(texture(scene, uv).rgb) * gain * {factor}, 1.0); }}
"""
SECOND = """#version 410 core
uniform sampler2D image;
uniform sampler2D previous;
in vec2 uv;
out vec4 color;
void main() { color = mix(texture(image, uv), texture(previous, uv), 0.5); }
"""
PER_ROW = 100
WARM_UP = 1000  # reloads of a process that do not count: caches fill
MOST_GROWTH = 1.05
NAMES = {"memory_mb": "memory, MB", "gl_objects": "GL objects", "descriptors": "descriptors", "threads": "threads"}
PLOT = record.ROOT / "docs/reliability/reloads.svg"


class Edits:
    """Changes of a look of two passes, each with its own default of a parameter, by which the reload is seen."""

    def __init__(self, program):
        self.program = program
        self.folder = program.folder / "data/shaders/small"
        self.folder.mkdir()
        self.count = 0
        self.save("look.json", json.dumps(LOOK))
        self.save("tint.glsl", TINT.format(0.5))
        self.save("second.frag", SECOND)
        self.save("first.frag", FIRST.format(default=0.5, factor="1.0", more=""))

    def save(self, name, text):
        (self.folder / name).write_text(text)

    def apply(self, number):
        """One of ten kinds, in turn: other code, an error, a further parameter, an include, another format."""
        self.count += 1
        wanted = round(0.1 + 0.8 * (self.count % 9973) / 9973, 6)
        changes = {"default": wanted, "factor": "1.0", "more": ""}
        kind = number % 10
        if kind == 6:
            self.save("first.frag", FIRST.format(**{**changes, "factor": "missing"}))
            self.program.wait("the error is shown", lambda s: s["problems"] and not s["is_loading"])
            return
        if kind in (3, 4):
            LOOK["passes"][1]["format"] = "rgba32f" if kind == 3 else "rgba16f"
            self.save("look.json", json.dumps(LOOK))
        if kind == 5:
            self.save("tint.glsl", TINT.format(wanted))
        if kind == 8:
            changes.update(more="uniform float further = 1.0;  // @range 0 1\n", factor="further")
        if kind == 9:
            changes["factor"] = f"{1.0 - wanted:.6f}"
        self.save("first.frag", FIRST.format(**changes))
        self.program.wait("the look is reloaded", lambda s: s["values"].get("gain") == [wanted] and not s["problems"] and
                          ("further" in s["values"]) == (kind == 8))


def figures(program):
    status = dict(line.split(":", 1) for line in Path(f"/proc/{program.process.pid}/status").read_text().splitlines())
    return {"memory_mb": int(status["VmRSS"].split()[0]) / 1024, "threads": int(status["Threads"]),
            "descriptors": len(list(Path(f"/proc/{program.process.pid}/fd").iterdir())),
            "gl_objects": sum(program.state()["gl_objects"].values())}


def reload_often(executable, rows, wanted, budget):
    with tempfile.TemporaryDirectory(prefix="afterglow-reloads-", ignore_cleanup_errors=True) as folder, \
            Screen(480, 360) as screen:
        program = Program(executable, record.ROOT, Path(folder), screen)
        program.arrange(480, 360, [96, 72])
        program.variables["MESA_SHADER_CACHE_DISABLE"] = "true"  # it starts threads as needed
        session = json.loads(program.session().read_text())
        session["look"] = str(Path(folder) / "data/shaders/small/look.json")
        program.session().write_text(json.dumps(session))
        run = 1 + max((row["run"] for row in rows.rows), default=0)
        edits = Edits(program)
        try:
            program.start()
            while rows.total("reloads") < wanted and budget.left() > 0:
                for number in range(PER_ROW):
                    edits.apply(number)
                rows.add(run=run, reloads=PER_ROW, **figures(program))
                print(f"{rows.total('reloads')} of {wanted} reloads: {rows.rows[-1]}", flush=True)
            program.quit()
        finally:
            program.stop()


def growth(rows, key):
    """The mean of the last fifth by that of the first fifth after the warm-up, of the longest process."""
    runs = {}
    for row in rows.rows:
        runs.setdefault(row["run"], []).append(row[key])
    values = max(runs.values(), key=len)[WARM_UP // PER_ROW:]
    part = max(1, len(values) // 5)
    return statistics.fmean(values[-part:]) / statistics.fmean(values[:part]) if values else None


def lines(rows):
    table = [record.stamp(), "", f"{rows.total('reloads'):,} reloads in {len({row['run'] for row in rows.rows})} "
             f"process(es). The first {WARM_UP:,} of a process are left out.", "",
             "| figure | lowest | highest | end / start | goal |", "| --- | --- | --- | --- | --- |"]
    for key, name in NAMES.items():
        values = [row[key] for row in rows.rows]
        grown = growth(rows, key)
        table.append(f"| {name} | {min(values):.0f} | {max(values):.0f} | "
                     f"{'' if grown is None else f'{grown:.3f}'} | at most {MOST_GROWTH} |")
    return [*table, "", "![Memory, GL objects, descriptors and threads over the reloads](reliability/reloads.svg)"]


def plot(rows):
    """Four lines over the reloads, each from 0 to its largest value."""
    width, height, left = 640, 80, 150
    parts = []
    for place, (key, name) in enumerate(NAMES.items()):
        values = [row[key] for row in rows.rows]
        base = (place + 1) * (height + 20)
        points = " ".join(f"{left + width * i / max(1, len(values) - 1):.1f},{base - height * value / max(values):.1f}"
                          for i, value in enumerate(values))
        parts.append(f'<text x="0" y="{base - height / 2}">{name}</text><text x="{left - 8}" y="{base - height + 4}" '
                     f'text-anchor="end">{max(values):.0f}</text><text x="{left - 8}" y="{base}" text-anchor="end">0</text>'
                     f'<path d="M{left} {base}h{width}" stroke="#888"/>'
                     f'<polyline points="{points}" fill="none" stroke="#1a7f37" stroke-width="2"/>')
    bottom = len(NAMES) * (height + 20)
    end = f'<text x="{left + width}" y="{bottom + 20}" text-anchor="end">{rows.total("reloads"):,} reloads</text>'
    PLOT.write_text(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {left + width + 10} {bottom + 30}" '
                    f'font-family="sans-serif" font-size="13" fill="#808080">{"".join(parts)}{end}</svg>\n')


def main():
    wanted = int(sys.argv[3]) if len(sys.argv) > 3 else 10_000
    rows = record.Rows(Path(sys.argv[2]) / "reloads.jsonl", lambda _: record.CODE["reloads"])
    if rows.total("reloads") < wanted:
        reload_often(Path(sys.argv[1]).resolve(), rows, wanted, record.Budget())
    record.write("reloads", lines(rows))
    plot(rows)
    grown = [name for key, name in NAMES.items() if (growth(rows, key) or 0) > MOST_GROWTH]
    if grown:
        sys.exit(f"These grow: {', '.join(grown)}. The figures are in {sys.argv[2]}/reloads.jsonl.")
    if rows.total("reloads") < wanted:
        sys.exit("The time is over. Run it again for the rest.")
    return 0


if __name__ == "__main__":
    sys.exit(main())
