#!/usr/bin/env python3
"""fuzz.py BUILD FOLDER [RUNS]: fuzzes every reader, and writes the numbers of runs to docs/reliability.md.

A reader of ours gets RUNS runs (default: 1,000,000), one that is mostly a library's a tenth of them. Results are kept in
FOLDER, so a stopped run goes on, until the code has changed. In a new FOLDER the numbers of the page go on. Failing inputs
are kept in BUILD/found.
"""

import os
import re
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import record

FUZZ = record.ROOT / "tests/fuzz"
OURS = {
    "control": "OSC packets, MIDI messages, beams as text and samples",
    "glsl": "GLSL texts, annotations",
    "include": "includes",
    "isf": "ISF files",
    "pack": "tables of contents of packs, records of golden pictures",
    "preset": "presets: JSON, line of text, PNG",
    "scene": "scenes, OBJ",
    "settings": "session, keys, devices, playlist",
    "show": "cue files, drawings as text, automation",
    "slang_preset": "slang presets",
    "slang_shader": "slang shaders",
    "svg_path": "paths, transforms and numbers of SVG drawings",
    "toy_json": "Shadertoy JSON",
    "toy_text": "Shadertoy texts",
    "words": "signals, sources, expressions, conditions, commands",
}
LIBRARIES = {
    "look": "whole looks: glslang, SPIRV-Cross",
    "picture": "PNG, JPEG, EXR, HDR, TGA, BMP, TIFF, GIF, WebP: OpenImageIO",
    "sound": "WAV, FLAC, OGG, MP3, AIFF: libsndfile",
    "svg": "SVG drawings: librsvg, pugixml",
    "zip": "ZIP: libzip",
}
SLICE_SECONDS = 120


def runs_on_page():
    """The rows of the page's table, at its commit. A reader with a finding has none."""
    text = record.section(record.PAGE.read_text(), "fuzz")
    commit = re.search(r"Commit ([0-9a-f]+),", text)
    rows = re.findall(r"^\| `(\w+)` \|.*\| ([\d,]+) \| none \|$", text, re.MULTILINE)
    return [{"reader": reader, "runs": int(runs.replace(",", "")), "commit": commit[1]} for reader, runs in rows]


class Fuzzing:
    """The runs so far, and those that are missing."""

    def __init__(self, build, folder, runs):
        self.build, self.runs = build, runs
        self.rows = record.Rows(folder / "fuzz.jsonl",
                                lambda row: record.sources_of(f"tests/fuzz/{row['reader']}_fuzz.cpp"), runs_on_page())
        self.budget = record.Budget()
        self.findings = []

    def wanted(self, reader):
        return self.runs if reader in OURS else self.runs // 10

    def done(self, reader):
        return self.rows.total("runs", reader=reader)

    def fuzz(self, reader):
        """Slices of SLICE_SECONDS, until all runs are done or the time is over."""
        while self.done(reader) < self.wanted(reader) and self.budget.left() > SLICE_SECONDS:
            row = self.slice(reader, self.wanted(reader) - self.done(reader))
            if row is None:
                self.findings.append(reader)
                return
            self.rows.add(**row)
            print(f"{reader}: {self.done(reader)} of {self.wanted(reader)} runs", flush=True)

    def slice(self, reader, count):
        """The row of a slice; None: a finding."""
        texts = self.build / "texts" / reader
        texts.mkdir(parents=True, exist_ok=True)
        (self.build / "found").mkdir(exist_ok=True)
        log = self.build / f"{reader}.log"
        command = [self.build / f"tests/fuzz/{reader}_fuzz", f"-runs={count}", f"-max_total_time={SLICE_SECONDS}",
                   "-max_len=4096", "-timeout=10", "-rss_limit_mb=3072", f"-artifact_prefix={self.build}/found/{reader}-",
                   f"-dict={FUZZ}/words/{reader}.dict", texts, FUZZ / "seeds" / reader]
        environment = dict(os.environ, UBSAN_OPTIONS="print_stacktrace=1", LSAN_OPTIONS=f"suppressions={FUZZ}/../leaks.txt")
        with log.open("w") as out:
            code = subprocess.run(command, env=environment, stdout=out, stderr=out, check=False).returncode
        told = log.read_text(errors="replace")
        ended = re.search(r"Done (\d+) runs in (\d+) second", told)
        if code != 0 or not ended:
            print(f"{reader}: a finding\n" + "\n".join(told.splitlines()[-40:]), flush=True)
            return None
        return {"reader": reader, "runs": int(ended[1]), "seconds": int(ended[2])}

    def lines(self):
        lines = [record.stamp() + " Address and undefined-behaviour sanitizers.", "",
                 "| reader | files | runs | findings |", "| --- | --- | --- | --- |"]
        for readers in (OURS, LIBRARIES):
            for reader, files in readers.items():
                lines.append(f"| `{reader}` | {files} | {self.done(reader):,} | "
                             f"{'**1**' if reader in self.findings else 'none'} |")
        return lines


def main():
    build, folder = Path(sys.argv[1]), Path(sys.argv[2])
    runs = int(sys.argv[3]) if len(sys.argv) > 3 else 1_000_000
    fuzzing = Fuzzing(build, folder, runs)
    programs = sorted(file.name.removesuffix("_fuzz") for file in (build / "tests/fuzz").glob("*_fuzz"))
    assert programs == sorted(OURS | LIBRARIES), programs
    with ThreadPoolExecutor(2) as pool:
        list(pool.map(fuzzing.fuzz, sorted(programs, key=lambda reader: reader in OURS)))
    record.write("fuzz", fuzzing.lines())
    missing = [reader for reader in programs if fuzzing.done(reader) < fuzzing.wanted(reader)]
    if fuzzing.findings:
        sys.exit(f"Findings in: {', '.join(fuzzing.findings)}. The inputs are in {build}/found.")
    if missing:
        sys.exit(f"The time is over. Run it again for: {', '.join(missing)}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
