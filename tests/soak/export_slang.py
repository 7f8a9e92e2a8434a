"""Exports looks and libretro presets as RetroArch presets, and lets Afterglow draw both."""

import os

from export_mpv import LOOKS, PRESETS, STACKS

# Presets that read pictures from more than one frame ago.
REFUSED = ["motionblur/response-time"]
FRAME = "16"


def missing():
    """Why nothing can be drawn, or ""."""
    return ""


def cases(program):
    """(name, options of the look, size of the picture, whether it must be refused) of each case."""
    found = [(f"{look} {stem}", [look, "--preset", stem], "640x360", False)
             for look in LOOKS for stem in program.presets(look)]
    found += [(look, [look], "640x360", False) for look in LOOKS + STACKS]
    found.append(("phosphor p31-terminal", ["phosphor", "--preset", "p31-terminal"], "640x360", False))
    corpus = os.environ.get("AFTERGLOW_SLANG_DIR", "")
    if not corpus:
        print("  skipped: AFTERGLOW_SLANG_DIR does not name a copy of libretro's slang-shaders")
        return found
    for is_refused, presets in ((False, PRESETS), (True, REFUSED)):
        found += [(preset, [f"{corpus}/{preset}.slangp"], "640x480", is_refused) for preset in presets]
    return found


def draw(program, options, size, folder):
    """"refused: ...", "wrong: ...", or the difference as text."""
    content = ["--source", f"{program.source_picture(folder)},fit=stretch,prescaled=1", "--size", size]
    preset = folder / "look.slangp"
    exported = program.run("export", *options, *content, "--to", "slang", "-o", preset)
    if exported.returncode:
        return "refused: " + exported.stderr.strip()
    for look, picture in ((options, "before.png"), ([preset], "after.png")):
        rendering = program.run("render", *look, *content, "--frames", FRAME, "-o", folder / picture)
        if rendering.returncode:
            return "wrong: " + rendering.stderr.strip()
    return program.difference(folder / "before.png", folder / "after.png")
