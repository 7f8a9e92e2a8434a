"""Writes the figures of the benchmarks into the performance page: write_table.py FIGURES DOCUMENT.

FIGURES has one line of JSON per figure (tests/bench/figure.h). The text between the two marks in
DOCUMENT is replaced. Rows that are missing in FIGURES stay unchanged, with the date of their run.
Prints "N pass, M miss, K noise", counted in FIGURES. Exits with 1 if a figure missed its goal.
"""

import datetime
import json
import os
import re
import sys
from pathlib import Path

from figure import digits, goal

BEGIN = "<!-- figures, written by ./run bench -->"
END = "<!-- end of figures -->"
HEAD = "| figure | measured | goal | reference noise | verdict |\n| --- | --- | --- | --- | --- |"
ROW = re.compile(r"^\| <!-- (?P<topic>[^/ ]+)/(?P<key>[^ ]+) -->.*\|$")
RULE = """\
| verdict | meaning |
| --- | --- |
| pass | the figure meets its goal |
| **miss** | the figure does not meet its goal |
| noise | the measurement is invalid: the reference noise is outside 0.985 to 1.015, or the machine was not idle before |
| empty | the figure has no goal |
| with a date | the figure is from an earlier run |

A ratio to a reference is the median over rounds that alternate both, unless its row states otherwise.
*Reference noise* is the ratio of two measurements of the reference in the same rounds."""


def row_of(figure):
    """The table row of a figure."""
    measured = " ".join(filter(None, [digits(figure["value"]), figure["unit"]]))
    if figure.get("detail"):
        measured += " (%s)" % figure["detail"]
    itself = "%.3f" % figure["itself"] if "itself" in figure else ""
    if "idle" in figure:
        itself = "%.0f %% idle before" % (100 * figure["idle"])
    verdict = figure["verdict"]
    cells = [measured, goal(figure), itself, "**miss**" if verdict == "miss" else verdict]
    return "| <!-- %s/%s --> %s | %s |" % (figure["topic"], figure["key"], figure["what"], " | ".join(cells))


def read_rows(section):
    """The title of each topic, and its rows by key."""
    topics = {}
    title = ""
    for line in section.splitlines():
        row = ROW.match(line)
        if line.startswith("### "):
            title = line[4:]
        elif row:
            topics.setdefault(row["topic"], (title, {}))[1][row["key"]] = line
    return topics


def dated(row, day):
    """A row of an earlier run, with its date."""
    cells = row[:-1].rstrip().rpartition("|")
    if not day or re.search(r"\d{4}-\d\d-\d\d", cells[2]):
        return row
    return "%s| %s |" % (cells[0], ", ".join(filter(None, [cells[2].strip(), day])))


def with_figures(document, figures, machine, today):
    """The document with these figures; `machine` describes the machine that measured them."""
    before, begin, rest = document.partition(BEGIN)
    section, end, behind = rest.partition(END)
    if not begin or not end:
        raise ValueError("the lines '%s' and '%s' are missing" % (BEGIN, END))
    head = re.search(r"^Measured on (\S+) with (.*?)(?: and (.*))?\.$", section, re.MULTILINE)
    day, driver = (head[1], head[3]) if head else ("", "")
    topics = read_rows(section)
    for title, rows in topics.values():
        rows.update({key: dated(row, "" if day == today else day) for key, row in rows.items()})
    for line in figures:
        if "driver" in line:
            driver = line["driver"]
        else:
            rows = topics.get(line["topic"], ("", {}))[1]
            topics[line["topic"]] = (line["title"], rows)
            rows[line["key"]] = row_of(line)
    facts = "Measured on %s with %s%s." % (today, machine, " and " + driver if driver else "")
    tables = ["### %s\n%s\n%s" % (title, HEAD, "\n".join(rows.values())) for title, rows in topics.values()]
    return before + begin + "\n" + "\n\n".join(["## Measurements\n%s\n\n%s" % (facts, RULE), *tables]) + "\n" + end + behind


def machine():
    """The number of available cores, and their model."""
    names = re.findall(r"^model name\s*: (.*)$", Path("/proc/cpuinfo").read_text(), re.MULTILINE)
    return "%d cores (%s)" % (len(os.sched_getaffinity(0)), names[0].strip() if names else os.uname().machine)


def read_figures(path):
    figures = []
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        try:
            figures.append(json.loads(line))
        except ValueError as problem:
            raise ValueError("%s:%d: error: %s" % (path, number, problem)) from problem
    return figures


def main():
    if len(sys.argv) != 3:
        sys.exit("usage: write_table.py FIGURES DOCUMENT")
    path = Path(sys.argv[2])
    try:
        figures = read_figures(Path(sys.argv[1]))
        document = path.read_text(encoding="utf-8")
    except (OSError, ValueError) as problem:
        sys.exit(str(problem))
    try:
        written = with_figures(document, figures, machine(), datetime.date.today().isoformat())
    except ValueError as problem:
        sys.exit("%s: error: %s" % (path, problem))
    path.write_text(written, encoding="utf-8")
    verdicts = [figure.get("verdict") for figure in figures]
    print("%d pass, %d miss, %d noise" % tuple(verdicts.count(verdict) for verdict in ("pass", "miss", "noise")))
    sys.exit(1 if "miss" in verdicts else 0)


if __name__ == "__main__":
    main()
