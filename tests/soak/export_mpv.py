"""Draws exports in mpv, and compares them with Afterglow's pictures."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
DRAW_IN_MPV = SOURCE / "tests" / "mpv" / "draw_in_mpv.py"
LOOKS = ["crt", "shadow-mask"]
STACKS = ["crt+shadow-mask", "shadow-mask+crt", "crt+crt"]
# Presets of libretro's slang-shaders that are made of different parts of the format: one pass or many, vertex
# shaders, filters, wraps, targets of other sizes and formats.
PRESETS = """crt/crt-geom crt/crt-lottes crt/zfast-crt crt/crt-easymode crt/crt-pi crt/crt-hyllian-fast crt/crt-caligari
crt/crt-nes-mini crt/crt-lottes-fast crt/crt-sines crt/crt-gdv-mini crt/fakelottes crt/crt-consumer crt/gtu-v050
crt/crt-lottes-multipass crt/crt-interlaced-halation handheld/lcd-grid-v2 handheld/zfast-lcd
ntsc/ntsc-320px-composite vhs/vhs""".split()
# Presets that mpv cannot draw.
REFUSED = ["crt/crt-guest-advanced-fastest", "crt/crt-yah"]
FRAME = "3"


def missing():
    """Why nothing can be drawn, or ""."""
    for program in ("mpv", "Xvfb"):
        if not shutil.which(program):
            return f"{program} is not installed"
    return ""


def cases(program):
    """(name, options of the look, size of the picture, whether it must be refused) of each case."""
    found = [(f"{look} {stem}", [look, "--preset", stem], "640x360", False)
             for look in LOOKS for stem in program.presets(look)]
    found += [(look, [look], "640x360", False) for look in LOOKS + STACKS]
    corpus = os.environ.get("AFTERGLOW_SLANG_DIR", "")
    if not corpus:
        print("  skipped: AFTERGLOW_SLANG_DIR does not name a copy of libretro's slang-shaders")
        return found
    for is_refused, presets in ((False, PRESETS), (True, REFUSED)):
        found += [(preset, [f"{corpus}/{preset}.slangp"], "640x480", is_refused) for preset in presets]
    return found


def draw(program, options, size, folder):
    """"refused: ...", "wrong: ...", or the difference as text."""
    shader, drawn, rendered = (folder / name for name in ("look.glsl", "mpv.png", "render.png"))
    source = program.source_picture(folder)
    content = [*options, "--source", f"{source},fit=stretch,prescaled=1", "--size", size]
    exported = program.run("export", *content, "--to", "mpv", "-o", shader)
    if exported.returncode:
        return "refused: " + exported.stderr.strip()
    rendering = program.run("render", *content, "--frames", FRAME, "-o", rendered)
    if rendering.returncode:
        return "wrong: " + rendering.stderr.strip()
    done = subprocess.run([sys.executable, DRAW_IN_MPV, "--size", size, "--frame", FRAME, "--shader", shader, source,
                           drawn], capture_output=True, text=True, timeout=200)
    if done.returncode:
        return "wrong: " + done.stderr.strip()
    return program.difference(rendered, drawn)
