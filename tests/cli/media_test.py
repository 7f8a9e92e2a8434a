"""Sources and signals from files on the command line: their pictures and their errors."""

import json
import math
import os
import shutil
import struct
import subprocess
import zlib

from program import ProgramTest, main, read_png, run

COLORS = ((200, 40, 0), (0, 180, 60), (30, 0, 220), (90, 90, 90))
COPY = """#version 410 core
uniform sampler2D image;
in vec2 uv;
out vec4 color;
void main() { color = texture(image, uv); }
"""


def without_pixels(width, height, color_type):
    """A 16-bit PNG with a header and no pixels."""
    body = struct.pack(">IIBBBBB", width, height, 16, color_type, 0, 0, 0)
    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", body) + chunk(b"IDAT", b"") + chunk(b"IEND", b"")


def png(width, height, rgb):
    """An 8-bit RGB PNG of one colour."""
    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
    head = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    rows = (b"\0" + bytes(rgb) * width) * height
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(rows)) +
            chunk(b"IEND", b""))


def exr(row):
    """One row of greys as 32-bit floats, uncompressed: OpenEXR, single part, scan lines."""
    def attribute(name, kind, value):
        return name + b"\0" + kind + b"\0" + struct.pack("<I", len(value)) + value
    box = struct.pack("<4i", 0, 0, len(row) - 1, 0)
    channels = b"".join(name + struct.pack("<xIB3xII", 2, 0, 1, 1) for name in (b"B", b"G", b"R"))
    head = (struct.pack("<II", 20000630, 2) + attribute(b"channels", b"chlist", channels + b"\0") +
            attribute(b"compression", b"compression", b"\0") + attribute(b"dataWindow", b"box2i", box) +
            attribute(b"displayWindow", b"box2i", box) + attribute(b"lineOrder", b"lineOrder", b"\0") +
            attribute(b"pixelAspectRatio", b"float", struct.pack("<f", 1)) +
            attribute(b"screenWindowCenter", b"v2f", struct.pack("<ff", 0, 0)) +
            attribute(b"screenWindowWidth", b"float", struct.pack("<f", 1)) + b"\0")
    line = struct.pack("<%df" % len(row), *row) * 3
    return head + struct.pack("<Q", len(head) + 8) + struct.pack("<iI", 0, len(line)) + line


def manifest(driven_by, **more):
    """The look.json of a look with one pass."""
    only = {"name": "only", "fragment": "only.frag", "format": "rgba32f"}
    if driven_by == "picture":
        only["inputs"] = {"image": "source"}
        more["default_source"] = "pattern:white"
    return json.dumps({"format": "afterglow-look", "version": 1, "driven_by": driven_by, "passes": [only], **more})


def pixel_art(width, height, times):
    """An 8-bit RGB PNG: pixels differ from their neighbours, and cover `times` x `times` px each."""
    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
    head = struct.pack(">IIBBBBB", width * times, height * times, 8, 2, 0, 0, 0)
    rows = b"".join((b"\0" + b"".join(bytes((9 * x, 7 * y, 128)) * times for x in range(width))) * times
                    for y in range(height))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(rows)) +
            chunk(b"IEND", b""))


class MediaTest(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("copy/look.json", manifest("picture", source_encoding="display"))
        self.write("copy/only.frag", COPY)

    def plain(self, source, *more, size="8x8", out="x.png"):
        return run("render", self.folder / "copy", "--source", source, "--size", size, *more, "-o", self.folder / out)

    def color(self, *arguments, **settings):
        """The colour of the pixel at the centre."""
        self.assert_done(self.plain(*arguments, **settings))
        width, height, rows = read_png(self.folder / "x.png")
        middle = width // 2 * 3
        return tuple(rows[height // 2][middle:middle + 3])

    def assert_near(self, color, wanted, most):
        for ours, theirs in zip(color, wanted):
            self.assertLessEqual(abs(ours - theirs), most, f"{color}, not {wanted}")


class Pictures(MediaTest):
    def test_frame_n_of_a_sequence_is_the_nth_picture(self):
        for number, rgb in enumerate(COLORS):
            self.write(f"f_{number + 7:03d}.png", png(8, 8, rgb))
        sequence = self.folder / "f_%03d.png"
        self.assertEqual(self.color(sequence, "--frames", "3"), COLORS[2])
        self.assertEqual(self.color(sequence, "--frames", "5"), COLORS[0])  # it loops
        self.assertEqual(self.color(f"{sequence},loop=off,rate=30", "--frames", "9"), COLORS[3])
        self.assert_done(self.plain(sequence, "--frames", "4", out="all_%d.png"))
        for number, rgb in enumerate(COLORS):
            self.assertEqual(tuple(read_png(self.folder / f"all_{number}.png")[2][4][:3]), rgb)

    def test_a_missing_picture_of_a_sequence_is_told_and_the_one_before_stays(self):
        for number in (0, 2):
            self.write(f"f_{number}.png", png(8, 8, COLORS[number]))
        done = self.plain(self.folder / "f_%d.png", "--frames", "2")
        self.assert_refused(done, "f_%d.png: error: picture 1 is missing")
        self.assertEqual(tuple(read_png(self.folder / "x.png")[2][4][:3]), COLORS[0])

    def test_a_video_shows_its_pictures_in_their_order(self):
        for number, rgb in enumerate(COLORS):
            self.write(f"f_{number}.png", png(32, 32, rgb))
        video = self.folder / "clip.mkv"
        try:  # a lossless codec, so that pixels keep their values
            subprocess.run(["ffmpeg", "-v", "error", "-framerate", "30", "-i", self.folder / "f_%d.png",
                            "-c:v", "ffv1", "-pix_fmt", "bgr0", video], check=True)
        except FileNotFoundError:
            self.skipTest("there is no ffmpeg here")
        self.assert_done(self.plain(video, "--fps", "30", "--frames", "4", out="all_%d.png"))
        for number, rgb in enumerate(COLORS):
            self.assert_near(read_png(self.folder / f"all_{number}.png")[2][4][:3], rgb, 1)
        self.assert_near(self.color(video, "--frames", "4"), COLORS[1], 1)  # 4/60 s is 2/30 s
        self.assert_done(self.plain(video, "--frames", "3", out="again.png"))
        self.assert_done(self.plain(video, "--frames", "3"))
        self.assertEqual((self.folder / "again.png").read_bytes(), (self.folder / "x.png").read_bytes())

    def test_light_above_white_goes_from_exr_to_exr(self):
        self.write("bright/look.json", manifest("nothing", output="linear"))
        self.write("bright/only.frag", "#version 410 core\nout vec4 color;\nvoid main() { color = vec4(7.5, 1.25, 0.5, 1.0); }\n")
        self.write("copy/look.json", manifest("picture", output="linear"))
        bright, copied = self.folder / "bright.exr", self.folder / "copied.exr"
        self.assert_done(run("render", self.folder / "bright", "--size", "8x8", "-o", bright))
        self.assert_done(run("render", self.folder / "copy", "--source", bright, "--size", "8x8", "-o", copied))
        self.assert_done(run("compare", bright, copied, "--fail-above", "max=0"))
        self.assert_done(run("render", "crt", "--set", "crt=false", "--set", "dither=false", "--source", bright,
                             "--size", "8x8", "-o", self.folder / "shown.png"))
        self.assertEqual(tuple(read_png(self.folder / "shown.png")[2][4][:3]), (255, 255, 188))  # sRGB of 1/2

    def test_an_enlarged_screenshot_is_drawn_as_its_original(self):
        for times in (1, 3):
            (self.folder / ("art%d.png" % times)).write_bytes(pixel_art(20, 15, times))
        def drawn(source):
            self.assert_done(self.plain(self.folder / source, size="40x30", out="art.png"))
            return read_png(self.folder / "art.png")
        original = drawn("art1.png")
        self.assertEqual(drawn("art3.png"), original)
        self.assertEqual(drawn("art3.png,prescaled=3"), original)
        self.assertNotEqual(drawn("art3.png,prescaled=1"), original)

    def test_the_smallest_and_the_widest_picture_are_shown(self):
        one = self.write("one.png", png(1, 1, COLORS[0]))
        wide = self.write("wide.png", png(16384, 1, COLORS[1]))
        wider = self.write("wider.png", png(16385, 1, COLORS[1]))
        self.assertEqual(self.color(one), COLORS[0])
        self.assertEqual(self.color(f"{wide},fit=stretch"), COLORS[1])
        self.assertEqual(self.color(f"{one},fit=stretch", size="16384x1"), COLORS[0])
        self.assert_refused(self.plain(wider), "wider.png: error: the picture is too large", "16385 x 1 px")
        self.assert_refused(self.plain(one, size="16385x1"), "16385x1", code=2)
        self.assert_done(run("render", "shadow-mask", "--source", one, "--size", "1x1", "-o", self.folder / "x.png"))

    def test_a_picture_takes_at_most_a_gigabyte_and_is_refused_before_it_is_read(self):
        # 4 bytes per channel, plus 16 bytes per pixel on the GPU, are at most 920 MiB.
        for color_type, channels, side in ((0, 1, 6946), (2, 3, 5870), (6, 4, 5491)):
            self.assertLess((side - 1) ** 2 * 4 * (channels + 4), 920 << 20)
            self.assertGreater(side ** 2 * 4 * (channels + 4), 920 << 20)
            large = self.write("large.png", without_pixels(side, side, color_type))
            self.assert_refused(self.plain(large), "large.png: error: the picture is too large: %d x %d px" % (side, side))
            fits = self.write("fits.png", without_pixels(side - 1, side - 1, color_type))
            self.assert_refused(self.plain(fits), "fits.png: error: the picture is damaged")
        self.assert_refused(self.plain(self.write("page.png", without_pixels(8192, 8192, 6))), "is too large")

    def test_what_is_no_number_in_a_picture_is_told_and_harms_nothing(self):
        bad = self.write("bad.exr", exr([math.nan, math.inf, 5.0, 0.25]))
        done = self.plain(bad, size="4x1")
        self.assert_done(done)
        self.assertIn("bad.exr: warning: contains 6 NaN or Inf values", done.stderr)
        row = read_png(self.folder / "x.png")[2][0]
        self.assertEqual(list(row[::3]), [0, 255, 255, 137])  # sRGB of 1/4 is 0.5371

    def test_a_playlist_that_is_named_as_a_video_opens_no_other_file(self):
        other = self.folder / "private.mkv"
        subprocess.run(["ffmpeg", "-v", "error", "-f", "lavfi", "-i", "color=red:size=16x16:duration=1", other],
                       check=True)
        stream = self.folder / "private.ts"
        subprocess.run(["ffmpeg", "-v", "error", "-i", other, "-c:v", "mpeg2video", stream], check=True)
        hls = "#EXTM3U\n#EXT-X-TARGETDURATION:1\n#EXTINF:1,\n%s\n#EXT-X-ENDLIST\n"
        for name, text in (("absolute.mp4", hls % stream), ("url.mp4", hls % stream.as_uri()),
                           ("beside.mp4", hls % stream.name), ("list.mkv", "ffconcat version 1.0\nfile %s\n" % other),
                           ("list.webm", "ffconcat version 1.0\nfile private.mkv\n")):
            self.assert_refused(self.plain(self.write(name, text)), name + ": error: ")
        self.assert_done(self.plain(other))
        self.assert_done(self.plain(shutil.copy(stream, self.folder / "stream.mpg")))  # with any content

    def test_videos_that_cannot_be_read_are_named(self):
        self.assert_refused(self.plain(self.write("noise.mp4", os.urandom(3000))), "noise.mp4: error: ")
        self.assert_refused(self.plain(self.folder / "none.mp4"), "none.mp4: error: file not found")
        self.assertFalse((self.folder / "x.png").exists())


class Signals(MediaTest):
    def beam(self, spec):
        """Saves the signal as sound, which needs no look."""
        return run("signal", spec, "--seconds", "0.01", "-o", self.folder / "x.wav")

    def test_a_drawing_without_paths_is_refused(self):
        empty = '<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9"><desc>nothing</desc></svg>'
        for name, text, words in (("no.svg", empty, "nothing to draw"), ("cut.svg", empty[:60], "cut.svg:1: error: ")):
            self.assert_refused(self.beam(f"drawing:{self.write(name, text)}"), words)

    def test_a_model_with_corners_that_are_not_there_is_refused_at_its_line(self):
        scene = self.write("scene.json", """{"format": "afterglow-scene", "version": 1, "name": "Model",
            "items": [{"shape": "wireframe", "file": "model.obj"}]}""")
        corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n"
        self.write("model.obj", corners + "f 1 2 4\nf 1 2 3\nf -4 1 2\nf 1 2 99999999999999999999\n")
        self.assert_refused(self.beam(f"scene:{scene}"), "model.obj:4: error: ", "model.obj:6: error: ",
                            "model.obj:7: error: ")
        self.write("model.obj", corners + "f 1 2 -1\n")
        self.assert_done(self.beam(f"scene:{scene}"))

    def test_a_microphone_is_not_to_be_had_offline(self):
        self.assert_refused(self.beam("microphone:mode=xy"), "live sound only works in the window")

    def test_the_beam_goes_out_as_sound(self):
        file = self.folder / "beam.wav"
        self.assert_done(run("signal", "lissajous:x=1,y=1,phase=0.25,amplitude=0.5", "--seconds", "0.1", "--rate",
                             "48000", "-o", file))
        data = file.read_bytes()
        kind, channels, rate = struct.unpack("<HHI", data[data.index(b"fmt ") + 8:][:8])
        self.assertEqual((channels, rate), (2, 48000))
        self.assertEqual(struct.unpack("<H", data[data.index(b"fmt ") + 22:][:2])[0], 32, f"format {kind}")
        at = data.index(b"data") + 8
        samples = list(struct.iter_unpack("<ff", data[at:at + 4800 * 8]))
        self.assertEqual(len(samples), 4800)
        for x, y in samples[200:-200]:  # a circle, except where it is faded in or out
            self.assertAlmostEqual((x * x + y * y) ** 0.5, 0.5, delta=0.01)
        # 60 turns per second: 6 in 0.1 s, so x rises through 0 six times.
        upwards = sum(a[0] < 0 <= b[0] for a, b in zip(samples, samples[1:]))
        self.assertAlmostEqual(upwards, 6, delta=1)

        self.assert_done(run("signal", "lissajous", "--seconds", "0.01", "--channels", "3", "-o", file))
        data = file.read_bytes()
        self.assertEqual(struct.unpack("<H", data[data.index(b"fmt ") + 10:][:2])[0], 3)
        self.assert_done(run("signal", "lissajous", "--seconds", "0.01", "-o", self.folder / "beam.flac"))
        self.assertEqual((self.folder / "beam.flac").read_bytes()[:4], b"fLaC")
        self.assert_refused(run("signal", "lissajous", "-o", self.folder / "x.mp3"), ".wav or .flac")
        self.assert_refused(run("signal", "nothing", "-o", file), "unknown signal 'nothing'")


if __name__ == "__main__":
    main()
