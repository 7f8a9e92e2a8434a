#!/usr/bin/env python3
"""export.py PROGRAM [TARGET ...]: draws exported looks in the programs that they are for, and compares the pictures.

At most 2/255 in 99.9 % of the pixels is right. Prints a line for each look and the counts. A wrong picture, and a
look that should be refused and is not, or the reverse, is an error.
"""

import json
import subprocess
import sys
import tempfile
from pathlib import Path

import export_isf
import export_mpv
import export_reshade
import export_slang

TARGETS = {"slang": export_slang, "isf": export_isf, "mpv": export_mpv, "reshade": export_reshade}


class Program:
    """Afterglow."""

    def __init__(self, path):
        self.path = Path(path).resolve()

    def run(self, *arguments):
        return subprocess.run([self.path, *map(str, arguments)], stdin=subprocess.DEVNULL, capture_output=True,
                              text=True, errors="replace", timeout=300)

    def presets(self, look):
        """The names of a look's presets, without its own name."""
        lines = self.run("list", "presets").stdout.splitlines()
        names = [line.split("  ")[0].strip() for line in lines]
        return [name.partition("/")[2] for name in names if name.startswith(look + "/")]

    def source_picture(self, folder):
        """A picture of 320x240 pixels."""
        file = folder / "source.png"
        done = self.run("render", "crt", "--set", "crt=off", "--source", "pattern:harbour", "--size", "320x240", "-o",
                        file)
        assert done.returncode == 0, done.stderr
        return file

    def difference(self, ours, theirs):
        """The difference as text. It starts with "wrong" if it is too large."""
        just_above_2 = 2.01 / 255
        shares = []
        for tolerance in (0.01 / 255, just_above_2):
            done = self.run("compare", ours, theirs, "--tolerance", tolerance, "--json")
            if done.returncode:
                return "wrong: " + done.stderr.strip()
            found = json.loads(done.stdout)
            shares.append(found["share"])
        text = f"max {found['max'] * 255:.0f}/255, {100 * shares[0]:.2g} % differ"
        return text if shares[1] <= 0.001 else f"wrong: {text}, {100 * shares[1]:.2g} % by more than 2/255"


def check(program, target):
    """Draws all cases of a target. Gives the number of errors."""
    print(target.__name__.partition("_")[2])
    if reason := target.missing():
        print(f"  skipped: {reason}")
        return 0
    counts = {"exact": 0, "refused": 0, "wrong": 0}
    errors = 0
    for name, options, size, is_refused in target.cases(program):
        with tempfile.TemporaryDirectory(prefix="afterglow-") as folder:
            found = target.draw(program, options, size, Path(folder))
        kind = found.partition(":")[0]
        counts[kind if kind in counts else "exact"] += 1
        is_error = kind == "wrong" or (kind == "refused") != is_refused
        errors += is_error
        print(f"  {'FAILED' if is_error else 'pass  '}  {name}: {found}", flush=True)
    print(f"  {counts['exact']} exact, {counts['refused']} refused, {counts['wrong']} wrong")
    return errors


def main():
    program = Program(sys.argv[1])
    chosen = sys.argv[2:] or list(TARGETS)
    sys.exit(1 if sum(check(program, TARGETS[name]) for name in chosen) else 0)


if __name__ == "__main__":
    main()
