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

LOOK, SHADER = "crt", "crt.frag"
DEFAULT = "exposure = 1.0;"
ANCHOR = "in vec2 uv;"
PER_ROW = 100
WARM_UP = 1000  # reloads of a process that do not count: caches fill
MOST_GROWTH = {"memory_mb": 1.05, "gl_objects": 1.0, "descriptors": 1.0, "threads": 1.0}
NAMES = {"memory_mb": "memory, MB", "gl_objects": "GL objects", "descriptors": "descriptors", "threads": "threads"}
PLOT = record.ROOT / "docs/reliability/reloads.svg"


class Edits:
    """Changes of the look's files, each with its own default of a parameter, by which the reload is seen."""

    def __init__(self, program):
        self.program = program
        folder = program.folder / f"data/shaders/{LOOK}"
        self.shader, self.manifest = folder / SHADER, folder / "look.json"
        self.text, self.look = self.shader.read_text(), json.loads(self.manifest.read_text())
        assert DEFAULT in self.text and ANCHOR in self.text
        self.count = 0

    def apply(self, number):
        """One of ten kinds, in turn: new defaults, an error, a further parameter, another format of a target."""
        self.count += 1
        name, wanted = DEFAULT.split(" ")[0], round(0.2 + 0.8 * (self.count % 9973) / 9973, 6)
        text = self.text.replace(DEFAULT, f"{name} = {wanted};")
        kind = number % 10
        if kind == 6:
            self.shader.write_text(text.replace(ANCHOR, "missing_type broken;\n" + ANCHOR))
            self.program.wait("the error is shown", lambda s: s["problems"] and not s["is_loading"])
            return
        if kind == 8:
            text = text.replace(ANCHOR, "uniform float further = 0.0;  // @range 0 1\n" + ANCHOR)
            text = text.replace("vec3(", "(1.0 + further) * vec3(")
        if kind in (3, 4):
            self.look["passes"][0]["format"] = "rgba32f" if kind == 3 else "rgba16f"
            self.manifest.write_text(json.dumps(self.look))
        self.shader.write_text(text)
        self.program.wait("the look is reloaded", lambda s: s["values"][name] == [wanted] and not s["problems"] and
                          ("further" in s["values"]) == (kind == 8))


def figures(program):
    status = dict(line.split(":", 1) for line in Path(f"/proc/{program.process.pid}/status").read_text().splitlines())
    return {"memory_mb": int(status["VmRSS"].split()[0]) / 1024, "threads": int(status["Threads"]),
            "descriptors": len(list(Path(f"/proc/{program.process.pid}/fd").iterdir())),
            "gl_objects": sum(program.state()["gl_objects"].values())}


def reload_often(executable, rows, wanted, budget):
    with tempfile.TemporaryDirectory(prefix="afterglow-reloads-", ignore_cleanup_errors=True) as folder, \
            Screen(1000, 700) as screen:
        program = Program(executable, record.ROOT, Path(folder), screen)
        program.arrange(1000, 700, [240, 180])
        session = json.loads(program.session().read_text())
        session["look"] = str(Path(folder) / f"data/shaders/{LOOK}/look.json")
        program.session().write_text(json.dumps(session))
        run = 1 + max((row["run"] for row in rows.rows), default=0)
        try:
            program.start()
            edits = Edits(program)
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
    for key, most in MOST_GROWTH.items():
        values = [row[key] for row in rows.rows]
        grown = growth(rows, key)
        table.append(f"| {NAMES[key]} | {min(values):.0f} | {max(values):.0f} | "
                     f"{'' if grown is None else f'{grown:.3f}'} | {most} |")
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
    grown = [NAMES[key] for key, most in MOST_GROWTH.items() if (growth(rows, key) or 0) > most]
    if grown:
        sys.exit(f"These grow: {', '.join(grown)}. The figures are in {sys.argv[2]}/reloads.jsonl.")
    if rows.total("reloads") < wanted:
        sys.exit("The time is over. Run it again for the rest.")
    return 0


if __name__ == "__main__":
    sys.exit(main())
