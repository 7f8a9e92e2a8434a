"""Draws effects of ReShade with vkBasalt, over a software driver of Vulkan and on a display of its own.

Needs the Debian packages vkbasalt, mesa-vulkan-drivers and xvfb, and the program show_picture.
"""

import glob
import os
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "window"))

from screen import Screen

DRIVERS = "/usr/share/vulkan/icd.d/lvp_icd.*.json"
LAYERS = "/usr/share/vulkan/implicit_layer.d/vkBasalt*.json"


class EffectError(Exception):
    """vkBasalt did not accept the effect. The text is its log."""


def missing(program):
    """Why nothing can be drawn, or "". program: the path of show_picture."""
    if not os.path.isfile(program):
        return "show_picture is not built, because libvulkan-dev is not installed"
    return "" if glob.glob(DRIVERS) and glob.glob(LAYERS) else "vkbasalt or mesa-vulkan-drivers is not installed"


def define(effect, **macros):
    """Sets macros of an effect, as ReShade does with its settings."""
    effect = Path(effect)
    lines = "".join(f"#define AFTERGLOW_{name.upper()} {value}\n" for name, value in macros.items())
    effect.write_text(lines + effect.read_text(encoding="utf-8"), encoding="utf-8")


def write_ppm(file, size, pixels):
    Path(file).write_bytes(b"P6\n%d %d\n255\n" % size + bytes(pixels))


def read_ppm(file):
    """The RGB bytes of a picture."""
    return Path(file).read_bytes().split(b"\n", 3)[3]


def show(program, settings, size, pixels, frames, timeout=60):
    """Shows a picture for some frames, and gives what the window shows then. program: the path of show_picture.
    settings: that of a vkBasalt.conf. pixels: RGB bytes. Raises EffectError if vkBasalt reports an error."""
    with tempfile.TemporaryDirectory(prefix="afterglow-vulkan-") as folder, Screen(*size) as screen:
        picture, result, log = (Path(folder) / name for name in ("picture.ppm", "result.ppm", "log"))
        write_ppm(picture, size, pixels)
        environment = {**os.environ, "DISPLAY": screen.display, "VK_ICD_FILENAMES": glob.glob(DRIVERS)[0],
                       "LP_NUM_THREADS": "2", "ENABLE_VKBASALT": "1", "VKBASALT_CONFIG_FILE": str(settings),
                       "VKBASALT_LOG_LEVEL": "warn", "VKBASALT_LOG_FILE": str(log)}
        done = subprocess.run([program, picture, str(frames), result], env=environment, timeout=timeout,
                              stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False)
        problems = log.read_text(errors="replace") if log.exists() else ""
        if "vkBasalt err" in problems or done.returncode != 0:
            raise EffectError(f"{problems}{done.stderr}\nThe program ended with {done.returncode}.")
        return read_ppm(result)
