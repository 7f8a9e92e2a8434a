"""Draws exports with vkBasalt, and compares them with Afterglow's pictures."""

import os
import subprocess
import sys
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
sys.path.append(str(SOURCE / "tests" / "reshade"))

import vkbasalt

LOOKS = ["crt", "shadow-mask"]
STACKS = ["crt+shadow-mask", "shadow-mask+crt", "crt+crt"]
# Presets of libretro's slang-shaders that are made of different parts of the format: one pass or many, vertex
# shaders, filters, wraps, earlier frames, pictures, targets of other sizes and formats.
PRESETS = """crt/crt-geom crt/crt-lottes crt/zfast-crt crt/crt-easymode-halation crt/crt-aperture crt/crt-pi
crt/crt-lottes-multipass crt/crt-gdv-mini crt/crt-guest-advanced-fast handheld/lcd-grid-v2 handheld/gameboy
ntsc/ntsc-256px-composite motionblur/response-time reshade/lut""".split()
# Presets that the format cannot hold.
REFUSED = ["crt/crt-hyllian"]
FRAMES = 10  # more than any of them remembers


def show_picture(program):
    return program.path.parents[1] / "tests" / "show_picture"


def missing():
    """Why nothing can be drawn, or ""."""
    return vkbasalt.missing(SOURCE / "build" / "release" / "tests" / "show_picture")


def cases(program):
    """(name, options of the look, size of the picture, whether it must be refused) of each case."""
    found = [(f"{look} {stem}", [look, "--preset", stem], "640x360", False)
             for look in LOOKS for stem in program.presets(look)]
    found += [(f"{look}, {size}", [look], size, False) for look in LOOKS + STACKS for size in ("640x360", "173x101")]
    found.append(("phosphor p31-terminal", ["phosphor", "--preset", "p31-terminal"], "640x360", False))
    corpus = os.environ.get("AFTERGLOW_SLANG_DIR", "")
    if not corpus:
        print("  skipped: AFTERGLOW_SLANG_DIR does not name a copy of libretro's slang-shaders")
        return found
    for is_refused, presets in ((False, PRESETS), (True, REFUSED)):
        found += [(preset, [f"{corpus}/{preset}.slangp"], "640x480", is_refused) for preset in presets]
    return found


def pixels_of(file):
    """The RGB bytes of a picture."""
    return subprocess.run(["ffmpeg", "-v", "error", "-i", file, "-f", "rawvideo", "-pix_fmt", "rgb24", "-"],
                          stdin=subprocess.DEVNULL, capture_output=True, check=True).stdout


def draw(program, options, size, folder):
    """"refused: ...", "wrong: ...", or the difference as text."""
    effect, shown, drawn, rendered = (folder / name for name in ("look.fx", "shown.png", "drawn.ppm", "render.png"))
    exported = program.run("export", *options, "--to", "reshade", "-o", effect)
    if exported.returncode:
        return "refused: " + exported.stderr.strip()
    # The game draws the picture in the size of the screen.
    plain = program.run("render", "crt", "--set", "crt=off", "--source",
                        f"{program.source_picture(folder)},fit=stretch,prescaled=1", "--size", size, "-o", shown)
    rendering = program.run("render", *options, "--source", shown, "--size", size, "--frames", FRAMES, "-o", rendered)
    for done in (plain, rendering):
        if done.returncode:
            return "wrong: " + done.stderr.strip()
    vkbasalt.define(effect, frame_rate=60, source_lines=0)
    screen = tuple(map(int, size.split("x")))
    settings = folder / "look_reshade" / "vkBasalt.conf"
    try:
        theirs = vkbasalt.show(show_picture(program), settings, screen, pixels_of(shown), FRAMES)
    except vkbasalt.EffectError as error:
        return f"wrong: {error}"
    vkbasalt.write_ppm(drawn, screen, theirs)
    return program.difference(rendered, drawn)
