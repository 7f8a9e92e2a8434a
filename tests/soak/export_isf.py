"""Exports looks and ISF files as ISF files, the latter also by way of a RetroArch preset, and compares the pictures."""

import os

from export_mpv import LOOKS, STACKS

# Effects with all types of inputs, several passes, buffers of the last frame, and pictures of other sizes.
FILES = """Boxinator|Chroma Zoom|Circle Open|Comet Tails|CrossZoom|Dilate|Directional Warp|Edge Trace|Exposure Adjust|
False Color|Kaleidoscope|Luminance Melt|Motion Heat Map|Noise Displace|Pixellate|Sine Warp Tile|Thermal Camera|
v002 Bleach Bypass|v002 Vignette|Water Drop""".replace("\n", "").split("|")
FRAME = "16"
BETWEEN = "slang"  # in a case's options: exports it as a preset first
SIZE = "480x320"


def missing():
    """Why nothing can be drawn, or ""."""
    return ""


def cases(program):
    """(name, options of the look, size of the picture, whether it must be refused) of each case."""
    found = [(f"{look} {stem}", [look, "--preset", stem], SIZE, False)
             for look in LOOKS for stem in program.presets(look)]
    found += [(look, [look], SIZE, False) for look in LOOKS + STACKS]
    found += [(f"phosphor {name}", ["phosphor", *options], SIZE, False)
              for name, options in (("long-green", ["--preset", "long-green"]),
                                    ("gather", ["--set", "bloom_kind=Taps", "--set", "one_color=on"]))]
    corpus = os.environ.get("AFTERGLOW_ISF_DIR", "")
    if not corpus:
        print("  skipped: AFTERGLOW_ISF_DIR does not name a copy of Vidvox's ISF-Files")
        return found
    return found + [(name + way, [f"{corpus}/ISF/{name}.fs", *between], SIZE, False)
                    for name in FILES for way, between in (("", []), (" by way of a RetroArch preset", [BETWEEN]))]


def draw(program, options, size, folder):
    """"refused: ...", "wrong: ...", or the difference as text."""
    content = ["--source", "pattern:harbour", "--size", size]
    preset, file = folder / "look.slangp", folder / "look.fs"
    steps = [(options, "isf", file)]
    if BETWEEN in options:
        options = [option for option in options if option != BETWEEN]
        steps = [(options, "slang", preset), ([preset], "isf", file)]
    for look, target, written in steps:
        exported = program.run("export", *look, *content, "--to", target, "-o", written)
        if exported.returncode:
            return "refused: " + exported.stderr.strip()
    for look, picture in ((options, "before.png"), ([file], "after.png")):
        rendering = program.run("render", *look, *content, "--frames", FRAME, "-o", folder / picture)
        if rendering.returncode:
            return "wrong: " + rendering.stderr.strip()
    return program.difference(folder / "before.png", folder / "after.png")
