"""A virtual screen: its pixels, mouse and keyboard."""

import os
import shutil
import struct
import subprocess
import tempfile
import zlib
from pathlib import Path


class Screen:
    """Xvfb on a free display, terminated at the end of the `with` block."""

    def __init__(self, width, height):
        self.size = (width, height)

    def __enter__(self):
        self.folder = Path(tempfile.mkdtemp(prefix="afterglow-screen-"))
        reader, writer = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-noreset", "-displayfd", str(writer), "-screen", "0", "%dx%dx24" % self.size,
             "-fbdir", str(self.folder), "-nolisten", "tcp", "+extension", "GLX"],
            pass_fds=[writer], stderr=subprocess.DEVNULL)
        os.close(writer)
        with os.fdopen(reader) as numbers:
            number = numbers.readline().strip()
        if not number:
            raise RuntimeError("Xvfb did not start")
        self.display = ":" + number
        return self

    def __exit__(self, *_):
        self.server.terminate()
        self.server.wait()
        shutil.rmtree(self.folder, ignore_errors=True)

    def do(self, *words):
        """Runs xdotool. Without its sleep of 100 ms after each click, unless the words say otherwise."""
        told = [str(word) for word in words]
        for i in reversed([i for i, word in enumerate(told[:-1]) if word == "click"]):
            if not told[i + 1].startswith("--"):
                told[i + 1:i + 1] = ["--delay", "0"]
        subprocess.run(["xdotool", *told], check=True, stdout=subprocess.DEVNULL,
                       env={**os.environ, "DISPLAY": self.display})

    def window(self):
        """The X window of the program."""
        found = subprocess.run(["xdotool", "search", "--onlyvisible", "--name", "Afterglow"],
                               check=True, capture_output=True, text=True,
                               env={**os.environ, "DISPLAY": self.display})
        return int(found.stdout.split()[0])

    def resize(self, width, height):
        """Resizes the program's window, like a drag of its corner."""
        self.do("windowsize", self.window(), width, height)

    def rows(self, left, top, right, bottom):
        """The pixels of a rectangle, each row as bytes of blue, green, red, unused."""
        data = (self.folder / "Xvfb_screen0").read_bytes()
        header = struct.unpack(">25I", data[:100])  # X11/XWDFile.h
        start = header[0] + header[19] * 12
        stride = header[12]
        return [data[start + y * stride + left * 4:start + y * stride + right * 4]
                for y in range(top, bottom)]

    def brightness(self, place):
        """Mean of red, green and blue over a rectangle, 0..255."""
        rows = self.rows(*place)
        total = sum(sum(row[channel::4]) for row in rows for channel in range(3))
        return total / (3 * sum(len(row) // 4 for row in rows))

    def save(self, file):
        """Saves the screen as a PNG."""
        width, height = self.size
        lines = bytearray()
        for row in self.rows(0, 0, width, height):
            rgb = bytearray(3 * width)
            rgb[0::3], rgb[1::3], rgb[2::3] = row[2::4], row[1::4], row[0::4]
            lines += b"\0" + rgb

        def chunk(kind, body):
            check = zlib.crc32(kind + body)
            return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", check)

        header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) +
                         chunk(b"IDAT", zlib.compress(bytes(lines), 1)) + chunk(b"IEND", b""))
