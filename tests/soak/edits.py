#!/usr/bin/env python3
"""edits.py PROGRAM FOLDER [EDITS]: changes shaders of running looks at random, EDITS times (default: 1,000).

The window must keep its picture: the last good one after an error, the original one after the change is undone. A key
is pressed while each change is compiled, and again without a change: the response times are compared. Results are kept
in FOLDER, so a stopped run goes on. Let nothing else run on the machine.
"""

import json
import random
import re
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import record

sys.path.insert(0, str(record.ROOT / "tests/window"))
from program import Program  # noqa: E402
from screen import Screen  # noqa: E402

LOOKS = ("crt", "shadow-mask", "vector-beam", "phosphor")
PER_ROW = 25
MOST_RATIO, MOST_SECONDS = 1.5, 1.0
# From the save to the start of its compilation.
LONGEST_NOTICE = 0.6  # s
WINDOW, PICTURE = (640, 480), [160, 120]


def change_one(text, pattern, other):
    """Replaces one of the places that match. Without any, the text stays as it is."""
    places = list(re.finditer(pattern, text))
    if not places:
        return text
    found = random.choice(places)
    return text[:found.start()] + other(found[0]) + text[found.end():]


def change_name(text):
    pattern = r"\b[a-z_]{3,}\b"
    return change_one(text, pattern, lambda _: random.choice(re.findall(pattern, text)))


def change_lines(text, edit):
    lines = text.split("\n")
    at = random.randrange(len(lines))
    lines[at:at + 1] = edit(lines[at])
    return "\n".join(lines)


CHANGES = {
    "number": lambda text: change_one(text, r"\b\d+\.\d+\b", lambda old: f"{float(old) * random.uniform(0.5, 2.0):.4f}"),
    "operator": lambda text: change_one(text, r" [-+*/] ", lambda _: f" {random.choice('+-*/')} "),
    "name": change_name,
    "no line": lambda text: change_lines(text, lambda line: []),
    "line twice": lambda text: change_lines(text, lambda line: [line, line]),
    "letter": lambda text: change_lines(text, lambda line: [line + random.choice(";{}()#\"/@x")]),
    "half a file": lambda text: text[:random.randrange(len(text))],
    "empty file": lambda text: "",
}


class Editing:
    """One look in the window, with a change at a time."""

    def __init__(self, executable, look, folder, screen):
        self.screen = screen
        self.program = Program(executable, record.ROOT, folder, screen)
        self.program.arrange(*WINDOW, PICTURE)
        session = json.loads(self.program.session().read_text())
        session["look"] = str(folder / f"data/shaders/{look}/look.json")
        self.program.session().write_text(json.dumps(session))
        self.files = sorted((folder / f"data/shaders/{look}").glob("*.frag"))
        self.program.start()
        self.bright = self.brightness()

    def brightness(self):
        return self.screen.brightness(self.program.place("picture"))

    def settle(self):
        """Waits until the last save is compiled, or was refused."""
        end = time.monotonic() + LONGEST_NOTICE
        while time.monotonic() < end and not self.program.state()["is_loading"]:
            time.sleep(0.005)
        return self.program.wait("the change is compiled", lambda s: not s["is_loading"])

    def response(self):
        """Seconds until C shows another channel in the inspector, as the window's state shows it."""
        # A change that makes NaN stops playback until it is undone.
        self.program.wait("it plays", lambda s: s["is_playing"])
        time.sleep(random.uniform(0.0, 0.15))
        before = self.program.state()["channels"]
        begun = time.monotonic()
        self.screen.do("key", "c")
        while self.program.state().get("channels", before) == before:
            if time.monotonic() - begun > 30:
                raise AssertionError("the key had no effect for 30 s")
            time.sleep(0.001)
        return time.monotonic() - begun

    def edit(self):
        """One change, and back. Returns both response times, and whether the change was refused."""
        file = random.choice(self.files)
        original = changed = file.read_text()
        while changed == original:
            kind = random.choice(list(CHANGES))
            changed = CHANGES[kind](original)
        plain = self.response()
        file.write_text(changed)
        busy = self.response()
        state = self.settle()
        try:
            assert state["has_picture"], "there is no picture"
            if state["problems"]:
                assert self.brightness() > 0.5 * self.bright, "the last good picture is gone"
            file.write_text(original)
            self.settle()
            self.program.wait("the picture is back", lambda s: not s["problems"] and self.brightness() > 0.5 * self.bright)
        except AssertionError as error:
            lost = Path(tempfile.gettempdir()) / f"afterglow-edit-{file.name}"
            lost.write_text(changed)
            raise AssertionError(f"{kind} in {file}, kept as {lost}: {error}") from error
        return plain, busy, bool(state["problems"])


def edit_often(executable, look, rows, wanted, budget):
    with tempfile.TemporaryDirectory(prefix="afterglow-edits-", ignore_cleanup_errors=True) as folder, \
            Screen(*WINDOW) as screen:
        editing = Editing(executable, look, Path(folder), screen)
        try:
            while (missing := wanted - rows.total("edits", look=look)) > 0 and budget.left() > 0:
                results = [editing.edit() for _ in range(min(PER_ROW, missing))]
                rows.add(look=look, edits=len(results), refused=sum(refused for _, _, refused in results),
                         plain=[round(plain, 4) for plain, _, _ in results],
                         busy=[round(busy, 4) for _, busy, _ in results])
                print(f"{look}: {rows.total('edits', look=look)} of {wanted} edits", flush=True)
            editing.program.quit()
        finally:
            editing.program.stop()


def late(times):
    """The 95th percentile."""
    return statistics.quantiles(times, n=20)[-1]


def figures(rows, look):
    """The 95th percentiles without and with an edit, and the longest response with one, in s."""
    plain, busy = ([time for row in rows.rows if row["look"] == look for time in row[key]] for key in ("plain", "busy"))
    return late(plain), late(busy), max(busy)


def lines(rows):
    table = [record.stamp(), "", "| look | edits | refused | lost pictures | 95 % of keys, no edit | 95 % of keys, edit | "
             "ratio | longest |", "| --- | --- | --- | --- | --- | --- | --- | --- |"]
    for look in LOOKS:
        if rows.total("edits", look=look):
            plain, busy, worst = figures(rows, look)
            table.append(f"| {look} | {rows.total('edits', look=look)} | {rows.total('refused', look=look)} | 0 | "
                         f"{1000 * plain:.0f} ms | {1000 * busy:.0f} ms | {busy / plain:.2f} | {1000 * worst:.0f} ms |")
    return table


def main():
    wanted = (int(sys.argv[3]) if len(sys.argv) > 3 else 1000) // len(LOOKS)
    rows = record.Rows(Path(sys.argv[2]) / "edits.jsonl", lambda _: record.CODE["edits"])
    budget = record.Budget()
    for look in LOOKS:
        if rows.total("edits", look=look) < wanted:
            edit_often(Path(sys.argv[1]).resolve(), look, rows, wanted, budget)
    record.write("edits", lines(rows))
    if any(rows.total("edits", look=look) < wanted for look in LOOKS):
        sys.exit("The time is over. Run it again for the rest.")
    slow = [look for look in LOOKS if (found := figures(rows, look))[1] > MOST_RATIO * found[0] or found[2] > MOST_SECONDS]
    if slow:
        sys.exit(f"Keys are slow while these looks are edited: {', '.join(slow)}. See {record.PAGE}.")
    return 0


if __name__ == "__main__":
    sys.exit(main())
