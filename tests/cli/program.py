"""Runs the program for the tests, and writes and reads their files."""

import os
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib
from pathlib import Path

PROGRAM = Path(sys.argv.pop(1) if len(sys.argv) > 1 else "build/release/app/afterglow").resolve()
SOURCE = Path(__file__).resolve().parents[2]
# A small RetroArch shader.
SLANG = """#version 450
layout(binding = 0, std140) uniform UBO { mat4 MVP; } global;
#pragma stage vertex
layout(location = 0) in vec4 Position;
layout(location = 1) in vec2 TexCoord;
void main() { gl_Position = global.MVP * Position; }
#pragma stage fragment
layout(location = 0) out vec4 FragColor;
void main() { FragColor = vec4(1.0, 0.0, 0.0, 1.0); }
"""


def run(*arguments, cwd=None, timeout=120, **environment):
    """The finished process, with stdout and stderr as text. A GL error always fails the test."""
    settings = {key: value for key, value in os.environ.items() if key not in ("DISPLAY", "WAYLAND_DISPLAY")}
    settings.update(MESA_DEBUG="1", **environment)  # Mesa prints each GL error to stderr
    done = subprocess.run([PROGRAM, *map(str, arguments)], cwd=cwd, env=settings, timeout=timeout,
                          stdin=subprocess.DEVNULL, capture_output=True, text=True, errors="replace")
    assert "Mesa: User error" not in done.stderr, done.stderr
    return done


def read_png(file):
    """Width, height and rows of RGB bytes of an 8-bit RGB or RGBA PNG."""
    data = Path(file).read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n", f"{file} is not a PNG"
    at, packed = 8, b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            width, height, depth, color = struct.unpack(">IIBB", body[:10])
            assert (depth, color) in ((8, 2), (8, 6)), f"{file}: depth {depth}, colour type {color}"
        elif kind == b"IDAT":
            packed += body
        at += 12 + length
    channels = 3 if color == 2 else 4
    raw, stride = zlib.decompress(packed), width * channels
    rows, above = [], bytearray(stride)
    for y in range(height):
        start = y * (stride + 1)
        row = unfiltered(raw[start], bytearray(raw[start + 1:start + 1 + stride]), above, channels)
        above = row
        colors = bytearray(row)
        if channels == 4:
            del colors[3::4]
        rows.append(colors)
    return width, height, rows


def unfiltered(kind, row, above, channels=3):
    """A PNG row with its filter undone (PNG 1.2, chapter 6)."""
    if kind == 0:
        return row
    for i, value in enumerate(row):
        left = row[i - channels] if i >= channels else 0
        up, corner = above[i], above[i - channels] if i >= channels else 0
        if kind == 1:
            row[i] = (value + left) & 255
        elif kind == 2:
            row[i] = (value + up) & 255
        elif kind == 3:
            row[i] = (value + (left + up) // 2) & 255
        elif kind == 4:
            estimate = left + up - corner
            nearest = min((abs(estimate - left), 0, left), (abs(estimate - up), 1, up),
                          (abs(estimate - corner), 2, corner))[2]
            row[i] = (value + nearest) & 255
    return row


class ProgramTest(unittest.TestCase):
    """A test with its own temporary folder."""

    def setUp(self):
        self._folder = tempfile.TemporaryDirectory(prefix="afterglow-")
        self.folder = Path(self._folder.name)
        self.addCleanup(self._folder.cleanup)

    def write(self, name, text):
        file = self.folder / name  # an absolute name is unchanged
        file.parent.mkdir(parents=True, exist_ok=True)
        if isinstance(text, bytes):
            file.write_bytes(text)
        else:
            file.write_text(text)
        return file

    def assert_done(self, result):
        self.assertEqual(result.returncode, 0, result.stderr)

    def assert_refused(self, result, *words, code=1):
        self.assertEqual(result.returncode, code, f"{result.stdout}{result.stderr}")
        for word in words:
            self.assertIn(word, result.stderr)


def main():
    if not PROGRAM.is_file():
        sys.exit(f"there is no program {PROGRAM}; give its path")
    unittest.main(verbosity=2)
