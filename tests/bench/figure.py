"""Prints and writes the figures of benchmark scripts, in the format of figure.h."""

import json
import os


def digits(value):
    size = abs(value)
    return "%.*f" % (0 if size == 0 else 4 if size < 0.1 else 3 if size < 10 else 1 if size < 100 else 0, value)


def goal(figure):
    """The goal of a figure as text; "": no goal."""
    for side, words in (("at_most", "at most"), ("at_least", "at least")):
        if side in figure:
            return "%s %.4g" % (words, figure[side])
    return ""


def tell(topic, title, key, what, value, unit="", at_most=None, detail=""):
    """Prints a figure, and appends it as a line of JSON to the file in AFTERGLOW_BENCH_FIGURES."""
    figure = {"topic": topic, "title": title, "key": key, "what": what, "value": value, "unit": unit}
    if at_most is not None:
        figure["at_most"] = at_most
    verdict = "" if at_most is None else "pass" if value <= at_most else "miss"
    figure.update(detail=detail, verdict=verdict)
    line = "  %-72s %8s %-8s %-17s %-14s%s" % (
        what, digits(value), unit, goal(figure), verdict, " (%s)" % detail if detail else "")
    print(line.rstrip(), flush=True)
    file = os.environ.get("AFTERGLOW_BENCH_FIGURES")
    if file:
        with open(file, "a", encoding="utf-8") as stream:
            stream.write(json.dumps(figure) + "\n")
