#!/usr/bin/env python3
"""Live sources: windows and screens of a virtual X server, and video from pipes.

capture_test.py PROGRAM PAINTED_WINDOW
"""
import os
import subprocess
import sys
import unittest
from pathlib import Path

PAINTED_WINDOW = sys.argv.pop()
TESTS = Path(__file__).resolve().parents[1]
sys.path[1:1] = [str(TESTS / "window"), str(TESTS / "capture")]

from painted_window import PaintedWindow  # noqa: E402
from program import PROGRAM, ProgramTest, main, read_png, run  # noqa: E402
from screen import Screen  # noqa: E402

# Draws the source without a change.
COPY = """/*{ "INPUTS": [{ "NAME": "inputImage", "TYPE": "image" }] }*/
void main() { gl_FragColor = IMG_THIS_PIXEL(inputImage); }
"""
NAVY, ORANGE, GREEN = (0x20, 0x40, 0x60), (0xFF, 0x80, 0x00), (0x00, 0xFF, 0x00)


class CaptureTest(ProgramTest):
    @classmethod
    def setUpClass(cls):
        cls.screen = Screen(800, 600).__enter__()
        cls.addClassCleanup(cls.screen.__exit__)

    def setUp(self):
        super().setUp()
        self.copy = self.folder / "copy.fs"
        self.copy.write_text(COPY)

    def window(self, *words):
        window = PaintedWindow(PAINTED_WINDOW, self.screen.display, *words)
        self.addCleanup(window.close)
        return window

    def render(self, source, size, *options):
        return run("render", self.copy, "--source", source, "--size", size, *options, DISPLAY=self.screen.display)

    def pixels(self, source, size):
        """The drawn rows of RGB colours."""
        file = self.folder / "drawn.png"
        self.assert_done(self.render(source, size, "--frames", "1", "-o", file))
        _, _, rows = read_png(file)
        return [[tuple(row[x:x + 3]) for x in range(0, len(row), 3)] for row in rows]

    def test_a_covered_window_is_drawn_without_the_window_that_covers_it(self):
        window = self.window("Painted: one, two", 100, 100, 320, 200)
        window.do("fill 204060")
        window.do("part 10 20 30 40 ff8000")
        cover = self.window("Cover", 150, 150, 320, 200)
        cover.do("fill 00ff00")
        rows = self.pixels("window:painted: ONE, two", "320x200")
        wanted = [[ORANGE if 10 <= x < 40 and 20 <= y < 60 else NAVY for x in range(320)] for y in range(200)]
        self.assertEqual(rows, wanted)
        # The screen has what the user sees.
        rows = self.pixels("screen:area=140x140+20+20", "20x20")
        self.assertEqual(rows, [[GREEN if x >= 10 and y >= 10 else NAVY for x in range(20)] for y in range(20)])

    def test_the_cursor_is_drawn_on_request(self):
        window = self.window("Painted", 0, 0, 200, 200)
        window.do("fill 204060")
        self.screen.do("mousemove", 100, 100)
        self.assertEqual(self.pixels("screen:area=50x50+100+100", "100x100"), [[NAVY] * 100] * 100)
        rows = self.pixels("screen:area=50x50+100+100,cursor=on", "100x100")
        changed = {(x, y) for y, row in enumerate(rows) for x, color in enumerate(row) if color != NAVY}
        self.assertTrue(changed)
        self.assertTrue(all(abs(x - 50) < 32 and abs(y - 50) < 32 for x, y in changed), changed)

    def test_a_window_that_is_missing_or_minimised_is_named(self):
        window = self.window("Painted", 0, 0, 64, 48)
        window.do("fill 204060")
        self.assert_refused(self.render("window:Editor", "64x48", "--frames", "1", "-o", self.folder / "no.png"),
                            "no window has the title 'Editor'. Open windows: 'Painted'")
        window.do("hide")
        self.assert_refused(self.render("window:Painted", "64x48", "--frames", "1", "-o", self.folder / "no.png"),
                            "the window 'Painted' is minimised")

    def test_what_is_not_on_the_screen_is_refused(self):
        for source, why in (("screen:area=700x0+200+100", "the area does not fit on the screen, which has 800x600 px"),
                            ("screen::4321", "can't open the X display ':4321'"),
                            ("screen:,area=1x1", "expected XxY+W+H"),
                            ("camera:/dev/no-camera", "camera '/dev/no-camera' not found"),
                            ("pipe:/no/such/pipe", "can't open the pipe"),
                            (f"pipe:{self.copy}", "the file is not a named pipe. Create one with mkfifo.")):
            with self.subTest(source):
                self.assert_refused(self.render(source, "64x48", "--frames", "1", "-o", self.folder / "no.png"), why)
        self.assert_refused(run("render", self.copy, "--source", "screen:", "-o", self.folder / "no.png"),
                            "no X display found")

    def test_a_preset_does_not_record_the_screen_by_itself(self):
        preset = self.folder / "live.json"
        self.assert_done(run("preset", "crt", "--source", "screen:", "-o", preset))
        self.assert_refused(run("render", preset, "-o", self.folder / "no.png", DISPLAY=self.screen.display),
                            "live source 'screen:'. If you trust it, load it with --signal or --source.")

    def piped(self, data, source, *options):
        """Draws 8x6 pixels with data on standard input."""
        settings = {key: value for key, value in os.environ.items() if key != "DISPLAY"}
        return subprocess.run([PROGRAM, "render", self.copy, "--source", source, "--size", "8x6", *options],
                              input=data, capture_output=True, env=settings, timeout=120)

    def drawn(self, count):
        """The colour of the first pixel of each picture."""
        return [tuple(read_png(self.folder / f"{i}.png")[2][0][:3]) for i in range(count)]

    def test_every_picture_of_a_pipe_is_drawn_at_its_time(self):
        raw = b"".join(bytes(color) * 48 for color in (NAVY, ORANGE, GREEN))
        done = self.piped(raw, "pipe:size=8x6,format=rgb24,rate=25", "--fps", "50", "--frames", "6", "-o",
                          self.folder / "%d.png")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.drawn(6), [NAVY, NAVY, ORANGE, ORANGE, GREEN, GREEN])

    def test_a_y4m_pipe_has_its_own_size_and_rate(self):
        # White, grey and black in limited range: ITU-R BT.601, Y = 16 + 219 * level.
        frames = b"".join(b"FRAME\n" + bytes([luma]) * 48 + bytes([128]) * 96 for luma in (235, 126, 16))
        y4m = b"YUV4MPEG2 W8 H6 F30:1 Ip A1:1 C444\n" + frames
        done = self.piped(y4m, "pipe:", "--fps", "30", "--frames", "4", "-o", self.folder / "%d.png")
        self.assertEqual(done.returncode, 0, done.stderr)
        grey = round((126 - 16) * 255 / 219)
        self.assertEqual(self.drawn(4), [(255,) * 3, (grey,) * 3, (0,) * 3, (0,) * 3])  # the last one stays

    def test_a_named_pipe_is_read(self):
        pipe = self.folder / "fifo"
        os.mkfifo(pipe)
        with subprocess.Popen([PROGRAM, "render", self.copy, "--source", f"pipe:{pipe},size=8x6,format=gray",
                               "--size", "8x6", "--frames", "1", "-o", self.folder / "0.png"]) as drawing:
            pipe.write_bytes(bytes([100]) * 48)
            self.assertEqual(drawing.wait(timeout=120), 0)
        self.assertEqual(self.drawn(1), [(100,) * 3])

    def test_a_pipe_with_other_data_is_refused(self):
        for data, source, why in ((b"hello\n" * 99, "pipe:", b"standard input does not begin with a y4m header"),
                                  (b"", "pipe:", b"the pipe was closed"),
                                  (b"YUV4MPEG2 W8 H6 F30:1\nFRAME\n", "pipe:", b"has ended"),
                                  (b"123", "pipe:size=8x6,format=rgb24", b"has ended"),
                                  (b"123" * 48, "pipe:size=8x6,format=rgb25", b"rgb25")):
            with self.subTest(why):
                done = self.piped(data, source, "--frames", "1", "-o", self.folder / "no.png")
                self.assertEqual(done.returncode, 1, done.stderr)
                self.assertIn(why, done.stderr)


if __name__ == "__main__":
    main()
