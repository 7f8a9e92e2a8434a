"""Exports ISF files as RetroArch presets, these as ISF files again, and compares their pictures with the first ones."""

import os

# Effects with all types of inputs, several passes, buffers of the last frame, and pictures of other sizes.
FILES = """Boxinator|Chroma Zoom|Circle Open|Comet Tails|CrossZoom|Dilate|Directional Warp|Edge Trace|Exposure Adjust|
False Color|Kaleidoscope|Luminance Melt|Motion Heat Map|Noise Displace|Pixellate|Sine Warp Tile|Thermal Camera|
v002 Bleach Bypass|v002 Vignette|Water Drop""".replace("\n", "").split("|")
FRAME = "16"
SIZE = "480x320"


def missing():
    """Why nothing can be drawn, or ""."""
    return "" if os.environ.get("AFTERGLOW_ISF_DIR") else "AFTERGLOW_ISF_DIR does not name a copy of Vidvox's ISF-Files"


def cases(_program):
    """(name, options of the look, size of the picture, whether it must be refused) of each case."""
    folder = os.environ["AFTERGLOW_ISF_DIR"]
    return [(name, [f"{folder}/ISF/{name}.fs"], SIZE, False) for name in FILES]


def draw(program, options, size, folder):
    """"refused: ...", "wrong: ...", or the difference as text."""
    content = ["--source", "pattern:harbour", "--size", size]
    preset, file = folder / "look.slangp", folder / "look.fs"
    for look, target, written in ((options, "slang", preset), ([preset], "isf", file)):
        exported = program.run("export", *look, *content, "--to", target, "-o", written)
        if exported.returncode:
            return "refused: " + exported.stderr.strip()
    for look, picture in ((options, "before.png"), ([file], "after.png")):
        rendering = program.run("render", *look, *content, "--frames", FRAME, "-o", folder / picture)
        if rendering.returncode:
            return "wrong: " + rendering.stderr.strip()
    return program.difference(folder / "before.png", folder / "after.png")
