#!/usr/bin/env python3
"""match.py BUILD FOLDER: matches photos of known screens, and writes the errors to docs/match.md.

20 seeds x 3 mask types, with corners that are 0, 0.5 and 1 px off (standard deviation in x and in y). Two fits run at a
time. Results are kept in FOLDER, so a stopped run goes on. Errors above the limits below are an error.
"""

import datetime
import json
import os
import statistics
import subprocess
import sys
import tempfile
import textwrap
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import record

MASKS = {1: "Aperture grille", 2: "Slot mask", 3: "Dot triads"}
# Parameter: whether its error is relative, and the limit of the median error.
LIMITS = {
    "mask_size": (True, 0.005), "scanline_period": (True, 0.005), "curvature": (False, 0.005),
    "mask_strength": (True, 0.1), "scanline_strength": (True, 0.1), "bloom_radius": (True, 0.2),
    "bloom_intensity": (True, 0.2),
}
MOST_RESIDUAL = 1.2
COVERAGE = (0.85, 0.95)
MOST_WIDTH = 4.0
BEGIN, END = "<!-- fits -->", "<!-- end of fits -->"


def trials():
    return [(seed, mask, 0.5 * (seed % 3)) for seed in range(1, 21) for mask in MASKS]


def fit(program, trial):
    seed, mask, error = trial
    environment = dict(os.environ, LIBGL_ALWAYS_SOFTWARE="1", LP_NUM_THREADS="0")
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run([program, str(seed), str(mask), str(error), folder], capture_output=True, text=True,
                              env=environment, check=False)
    lines = [line for line in done.stdout.splitlines() if line.startswith("{")]
    if not lines:
        return {"seed": seed, "mask": mask, "error": done.stderr.strip() or f"ended with {done.returncode}"}
    return json.loads(lines[-1])


def finished_fits(program, file):
    """All fits; those in the file are not run again, unless the code has changed since then."""
    rows = record.Rows(file, lambda _: record.CODE["match"])
    known = {(row["seed"], row["mask"]) for row in rows.rows}
    waiting = [trial for trial in trials() if trial[:2] not in known]
    with ThreadPoolExecutor(2) as pool:
        for row in pool.map(lambda trial: fit(program, trial), waiting):
            rows.add(**row)
            print(f"{len(rows.rows)} of {len(trials())}: seed {row['seed']}, {MASKS[row['mask']]}"
                  + (f": {row['error']}" if "error" in row else ""), flush=True)
    return rows.rows


def figures(fits, name):
    """Median and largest error, coverage of the intervals, and their width relative to the median error."""
    is_relative, _ = LIMITS[name]
    rows = [row[name] for row in fits]
    scale = [abs(true) if is_relative else 1.0 for true, *_ in rows]
    errors = [abs(found - true) / unit for (true, found, _, _), unit in zip(rows, scale)]
    widths = [(high - low) / unit for (_, _, low, high), unit in zip(rows, scale)]
    covered = [low <= true <= high for true, _, low, high in rows]
    median = statistics.median(errors)
    return median, max(errors), statistics.mean(covered), statistics.median(widths) / max(median, 1e-12)


def table(good):
    """The lines of the table, and what misses its limit."""
    lines = ["| parameter | median error | limit | largest error | in the 90 % interval | median width / median error |",
             "| --- | --- | --- | --- | --- | --- |"]
    misses = []
    covered = []
    for name, (is_relative, limit) in LIMITS.items():
        median, largest, share, width = figures(good, name)
        covered.append(share)
        text = (lambda value: f"{100 * value:.2g} %") if is_relative else (lambda value: f"{value:.2g}")
        lines.append(f"| `{name}` | {text(median)} | {text(limit)} | {text(largest)} | {100 * share:.0f} % | "
                     f"{width:.1f} |")
        if median > limit:
            misses.append(f"{name}: median error {text(median)}")
        if width > MOST_WIDTH:
            misses.append(f"{name}: intervals {width:.1f} x the median error")
    mean = statistics.mean(covered)
    lines.append(f"| all | | | | {100 * mean:.0f} % | |")
    if not COVERAGE[0] <= mean <= COVERAGE[1]:
        misses.append(f"coverage {100 * mean:.0f} %")
    return lines, misses


def report(fits):
    good = [row for row in fits if "error" not in row]
    lines, misses = table(good)
    wrong = [row for row in good if row["type"] != row["mask"]]
    ratio = statistics.median(row["residual"] / row["residual_of_truth"] for row in good)
    summary = (f"{len(good)} of {len(fits)} photos matched at commit {record.commit()}, {datetime.date.today()}. "
               f"{len(good) - len(wrong)} mask types are right. "
               f"A fit takes {statistics.median(row['seconds'] for row in good):.0f} s "
               f"and {statistics.median(row['pictures'] for row in good):.0f} pictures on one core (median). The difference "
               f"is {ratio:.2f} times that of the true values.")
    misses += [f"seed {row['seed']}, {MASKS[row['mask']]}: {row['error']}" for row in fits if "error" in row]
    misses += [f"seed {row['seed']}, {MASKS[row['mask']]}: wrong type" for row in wrong]
    if ratio > MOST_RESIDUAL:
        misses.append(f"difference {ratio:.2f} x that of the true values")
    return [*textwrap.wrap(summary, 118), "", *lines], misses


def write_page(lines):
    page = record.ROOT / "docs" / "match.md"
    before, rest = page.read_text().split(BEGIN)
    after = rest.split(END)[1]
    page.write_text(before + BEGIN + "\n" + "\n".join(lines) + "\n" + END + after)


def main():
    program, folder = Path(sys.argv[1]) / "tests" / "match_soak", Path(sys.argv[2])
    lines, misses = report(finished_fits(program, folder / "match.jsonl"))
    write_page(lines)
    print("\n".join(lines))
    for miss in misses:
        print("miss:", miss)
    return 1 if misses else 0


if __name__ == "__main__":
    sys.exit(main())
