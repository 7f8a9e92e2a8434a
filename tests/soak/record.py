"""record.py [PART...]: the results of long tests in docs/reliability.md: sections with commit and date, and which of them
are too old. Writes that the named parts have passed."""

import datetime
import functools
import json
import re
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs/reliability.md"
MOST_SECONDS = 55 * 60  # of one run of a part
STATES = "states"
@functools.lru_cache
def sources_of(program):
    """The files of ours that a program is compiled from: what it includes, and the .cpp file of each header. A .cpp file
    without a header of its name counts for all headers of its folder."""
    found, left = set(), [ROOT / program]
    while left:
        file = left.pop()
        if file in found or not file.is_file():
            continue
        found.add(file)
        left.append(file.with_suffix(".cpp"))
        if file.suffix == ".h" and file.is_relative_to(ROOT / "app"):
            left += [other for other in file.parent.glob("*.cpp") if not other.with_suffix(".h").exists()]
        for name in re.findall(r'^#include "([^"]+)"', file.read_text(), re.MULTILINE):
            left += [ROOT / "app" / name, ROOT / "tests" / name]
            if name == "io/pictures/picture_codec.h":
                left.append(ROOT / "app/pictures/codec.cpp")
    return tuple(sorted(str(file.relative_to(ROOT)) for file in found))


def fuzzed_sources():
    programs = sorted(file.relative_to(ROOT) for file in ROOT.glob("tests/fuzz/*_fuzz.cpp"))
    return tuple(sorted({source for program in programs for source in sources_of(program)}))


# The code that each part tests. A change of it makes the part's results old.
CODE = {
    "fuzz": fuzzed_sources(),
    "reloads": ("app/glsl", "app/gpu", "app/graph", "app/io/files", "app/lab/reload"),
    "edits": ("app/glsl", "app/gpu", "app/graph", "app/lab/reload", "app/ui/window"),
    "kills": ("app/formats/pack", "app/formats/preset", "app/formats/settings", "app/io/files", "app/io/pictures",
              "app/io/video", "app/lab/session"),
    "match": ("app/lab/match", "app/model/photo"),
    "slurm": ("app/cli/jobs.cpp", "app/cli/render.cpp", "app/lab/farm", "app/model/plan/lead_in.cpp"),
    "export": ("app/formats/effect", "app/formats/isf_export", "app/formats/mpv_export", "app/formats/portable",
               "app/formats/reshade_export", "app/formats/slang_export", "app/lab/export"),
    "package": ("CMakeLists.txt", "app/CMakeLists.txt", "app/lab/packs", "app/package", "tests/soak/package.sh"),
}


class Budget:
    """The time that is left for this run of a part."""

    def __init__(self, seconds=MOST_SECONDS):
        self._end = time.monotonic() + seconds

    def left(self):
        return self._end - time.monotonic()


def git(*arguments):
    return subprocess.run(["git", "-C", str(ROOT), *arguments], capture_output=True, text=True, check=True).stdout.strip()


def commit():
    return git("rev-parse", "--short=8", "HEAD")


@functools.lru_cache
def has_changed(since, paths):
    """Whether files in `paths` were committed after the commit `since`, or are changed now."""
    known = subprocess.run(["git", "-C", str(ROOT), "cat-file", "-e", f"{since}^{{commit}}"], capture_output=True,
                           check=False).returncode == 0
    return not known or bool(git("log", "--format=%h", f"{since}..HEAD", "--", *paths)) or bool(
        git("status", "--porcelain", "--", *paths))


class Rows:
    """The results of a part so far, one line of JSON each. Those of older code are left out: `sources` gives the paths
    that a row's result depends on. A new file begins with the rows `first`."""

    def __init__(self, file, sources, first=()):
        file.parent.mkdir(parents=True, exist_ok=True)
        if not file.exists():
            file.write_text("".join(json.dumps(row) + "\n" for row in first))
        self._file = file
        rows = [json.loads(line) for line in file.read_text().splitlines()]
        self.rows = [row for row in rows if not has_changed(row["commit"], sources(row))]

    def add(self, **row):
        self.rows.append({**row, "commit": commit()})
        with self._file.open("a") as kept:
            kept.write(json.dumps(self.rows[-1]) + "\n")

    def total(self, key, **wanted):
        """The sum of `key` over the rows with these values."""
        return sum(row[key] for row in self.rows if wanted.items() <= row.items())


def stamp():
    """The commit and the date of a result."""
    return f"Commit {commit()}, {datetime.date.today().isoformat()}."


def replaced(text, name, lines):
    """The text of the page with these lines in the section of that name."""
    begin, end = f"<!-- {name} -->\n", f"<!-- end of {name} -->"
    before, rest = text.split(begin)
    return before + begin + "\n".join(lines) + "\n" + end + rest.split(end)[1]


def section(text, name):
    return text.split(f"<!-- {name} -->\n")[1].split(f"<!-- end of {name} -->")[0]


def states(text):
    """One row per part: its commit, its date, and whether its code has changed since then."""
    rows = ["| part | commit | date | state |", "| --- | --- | --- | --- |"]
    for name, paths in CODE.items():
        found = re.search(r"Commit ([0-9a-f]+), (\d{4}-\d\d-\d\d)\.", section(text, name))
        if not found:
            rows.append(f"| `{name}` | | | not run |")
            continue
        state = "older than the code" if has_changed(found[1], paths) else "current"
        rows.append(f"| `{name}` | {found[1]} | {found[2]} | {state} |")
    return rows


def write(name, lines):
    """Writes the results of a part, and the states of all parts."""
    text = replaced(PAGE.read_text(), name, lines)
    PAGE.write_text(replaced(text, STATES, states(text)))


if __name__ == "__main__":
    for passed in sys.argv[1:]:
        write(passed, [stamp()])
    page = PAGE.read_text()
    PAGE.write_text(replaced(page, STATES, states(page)))
