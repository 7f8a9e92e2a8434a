"""Puts what the benches told into the table of the page about performance: write_table.py FIGURES DOCUMENT.

FIGURES has a line of JSON for each figure (tests/bench/figure.h). DOCUMENT has the two marks below; what
stands between them is written anew. Rows of figures that FIGURES does not have stay as they are, with
the day of their run. Ends with "N kept, M missed, K do not count" of FIGURES, and with 1 where one missed.
"""

import datetime
import json
import os
import re
import sys
from pathlib import Path

from figure import digits, goal

BEGIN = "<!-- figures: ./run bench writes what follows -->"
END = "<!-- end of figures -->"
HEAD = "| what | measured | goal | yardstick to itself | verdict |\n| --- | --- | --- | --- | --- |"
ROW = re.compile(r"^\| <!-- (?P<topic>[^/ ]+)/(?P<key>[^ ]+) -->.*\|$")
RULE = ("A figure is the median of the ratios of its turns, or what its row says. Where the yardstick, measured beside itself "
        "in the same turns, leaves 0.985 to 1.015, or the machine was not idle before, the figure does not count. "
        "A row that names a day is of an earlier run.")


def row_of(figure):
    """A figure's line of the table."""
    measured = " ".join(filter(None, [digits(figure["value"]), figure["unit"]]))
    if figure.get("detail"):
        measured += " (%s)" % figure["detail"]
    itself = "%.3f" % figure["itself"] if "itself" in figure else ""
    if "idle" in figure:
        itself = "idle before: %.0f %%" % (100 * figure["idle"])
    verdict = figure["verdict"]
    cells = [measured, goal(figure), itself, "**missed**" if verdict == "missed" else verdict]
    return "| <!-- %s/%s --> %s | %s |" % (figure["topic"], figure["key"], figure["what"], " | ".join(cells))


def read_rows(section):
    """Of each topic its title, and its rows by their keys."""
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
    """A row of an earlier run says of which."""
    cells = row[:-1].rstrip().rpartition("|")
    if not day or re.search(r"\d{4}-\d\d-\d\d", cells[2]):
        return row
    return "%s| %s |" % (cells[0], ", ".join(filter(None, [cells[2].strip(), day])))


def with_figures(document, figures, machine, today):
    """The document with these figures; `machine` are words for what was measured on."""
    before, begin, rest = document.partition(BEGIN)
    section, end, behind = rest.partition(END)
    if not begin or not end:
        raise ValueError("lacks the lines '%s' and '%s'" % (BEGIN, END))
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
    return before + begin + "\n" + "\n\n".join(["## Figures\n%s\n\n%s" % (facts, RULE), *tables]) + "\n" + end + behind


def machine():
    """The cores that one may use, and what they are."""
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
    print("%d kept, %d missed, %d do not count" % tuple(
        verdicts.count(verdict) for verdict in ("kept", "missed", "does not count")))
    sys.exit(1 if "missed" in verdicts else 0)


if __name__ == "__main__":
    main()
