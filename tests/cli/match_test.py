"""Photos and videos of tubes on the command line. The pictures come from formulas in this file."""

import json
import math
import random
import shutil
import struct
import subprocess
import unittest
import zlib

from program import ProgramTest, main, run

P31 = ((0.12604, 0.959932), (2.25, 0.0326786), (16.0, 0.0073889))  # ms, weight: Tektronix, "CRT Data", 1966
GREEN = (0.02, 1.0, 0.37)
SIDE = 48  # px of a frame


def png(width, height, pixels, kind=2):
    """A PNG of RGB (kind 2) or grey (kind 0) bytes."""
    def chunk(name, body):
        return struct.pack(">I", len(body)) + name + body + struct.pack(">I", zlib.crc32(name + body))
    stride = width * (3 if kind == 2 else 1)
    rows = b"".join(b"\0" + pixels[y * stride:(y + 1) * stride] for y in range(height))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, kind, 0, 0, 0))
            + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def light_after(flash, begin, end):
    """The light of a flash of P31 in a frame, ms, by the integral of its exponentials."""
    return sum(weight * time * (math.exp(-max(begin - flash, 0) / time) - math.exp(-max(end - flash, 0) / time))
               for time, weight in P31)


def frame_of(light, most, noise):
    """RGB bytes: a bright square on black, with the noise of a sensor and gamma 2.2."""
    pixels = bytearray()
    for y in range(SIDE):
        for x in range(SIDE):
            inside = 16 <= x < 32 and 16 <= y < 32
            for color in GREEN:
                seen = (0.8 * color * light / most if inside else 0.0) + 0.004 + noise.gauss(0.0, 0.001)
                pixels.append(round(255 * min(max(seen, 0.0), 1.0) ** (1 / 2.2)))
    return bytes(pixels)



def beam_photo(width, height, sigma, radius, amount, peak=0.6, has_line=True):
    """A green line and dot of a Gaussian spot with two Gaussian glows, the wide one four times as wide, as in
    Vector beam. The camera adds a blur of 1 px, noise and gamma 2.2. Lengths in px."""
    noise = random.Random(3)
    terms = [(share, spread ** 2 + sigma ** 2 + 1.0)
             for share, spread in ((1.0, 0.0), (0.6 * amount, radius), (0.4 * amount, 4.0 * radius))]
    most_of_line = sum(share / math.sqrt(variance) for share, variance in terms)
    most_of_dot = sum(share / variance for share, variance in terms)

    def line(square):
        return sum(share / math.sqrt(variance) * math.exp(-0.5 * square / variance) for share, variance in terms)

    def dot(square):
        return sum(share / variance * math.exp(-0.5 * square / variance) for share, variance in terms)

    lines = [line((i / 4) ** 2) / most_of_line for i in range(4 * height)]
    pixels = bytearray()
    for y in range(height):
        for x in range(width):
            light = dot((x + 0.5 - 0.5 * width) ** 2 + (y + 0.5 - 0.7 * height) ** 2) / most_of_dot
            if has_line:
                light += lines[round(4 * abs(y + 0.5 - 0.3 * height - 0.2 * (x - 0.5 * width)) / math.hypot(1, 0.2))]
            for color in (0.3, 1.0, 0.4):
                seen = 0.001 + peak * color * light
                seen += noise.gauss(0.0, 0.003) * math.sqrt(max(seen, 0.02))
                pixels.append(min(round(255 * max(seen, 0.0) ** (1 / 2.2)), 255))
    return png(width, height, bytes(pixels))


class Beams(ProgramTest):
    """Photos of a beam, 384 px high."""

    PLAIN = ("--set", "spot_growth=0", "--set", "tone_map=Clamp", "--set", "keep_hue=0")

    def match(self, photo, *options):
        return run("match", "vector-beam", *self.PLAIN, "--photo", self.write("beam.png", photo), "--json", *options)

    def test_a_line_and_a_dot_give_the_width_and_the_glow(self):
        unit = 384 / 512
        photo = beam_photo(280, 384, sigma=3.2 * unit, radius=8.0 * unit, amount=0.5)
        done = self.match(photo, "-o", self.folder / "beam.json", "--report", self.folder / "beam.html")
        self.assert_done(done)
        found = {row["name"]: row for row in json.loads(done.stdout)["parameters"]}
        self.assertEqual(set(found), {"spot_sigma", "glow_radius", "glow_amount"})
        for name, truth, tolerance in (("spot_sigma", 3.2, 0.1), ("glow_radius", 8.0, 0.2), ("glow_amount", 0.5, 0.2)):
            with self.subTest(name):
                self.assertLess(abs(found[name]["value"] / truth - 1.0), tolerance)
        self.assertLess(found["spot_sigma"]["low"], 3.2)
        self.assertGreater(found["spot_sigma"]["high"], 3.2)
        self.assertTrue(found["spot_sigma"]["identifiable"])
        self.assertGreater(json.loads(done.stdout)["explained"], 0.99)
        preset = json.loads((self.folder / "beam.json").read_text())
        self.assertAlmostEqual(preset["values"]["spot_sigma"], found["spot_sigma"]["value"], places=3)
        self.assertEqual((self.folder / "beam.html").read_text().count("<img "), 3)

    def test_a_spot_as_narrow_as_the_blur_is_not_identifiable(self):
        photo = beam_photo(120, 200, sigma=0.9, radius=6.0, amount=0.0, has_line=False)
        done = self.match(photo, "--set", "glow_amount=0", "--lock", "glow_radius,glow_amount")
        self.assert_done(done)
        (spot,) = json.loads(done.stdout)["parameters"]
        self.assertFalse(spot["identifiable"])
        self.assertIn("the camera's blur", spot["reason"])

    def test_photos_without_a_beam_are_refused(self):
        dark = png(120, 90, bytes(3 * 120 * 90))
        self.assert_refused(self.match(dark), "The photo shows neither a straight line nor an isolated dot.")
        bright = beam_photo(200, 384, sigma=1.5, radius=6.0, amount=0.0, peak=3.0)
        self.assert_refused(self.match(bright), "The lines and dots of the beam are overexposed.")
        self.assert_refused(run("match", "phosphor", "--source", "pattern:smpte", "--photo",
                                self.write("beam.png", dark), "--json"), "is matched by its beam")


class Videos(ProgramTest):
    """A flash of a P31 tube in 96 frames at 240 per second."""

    FRAME = 1000.0 / 240.0  # ms

    def make_frames(self, name="fade_%03d.png", count=96):
        flash = 5.4 * self.FRAME
        lights = [light_after(flash, i * self.FRAME, (i + 1) * self.FRAME) for i in range(count)]
        noise = random.Random(1)
        for i, light in enumerate(lights):
            self.write(name % i, png(SIDE, SIDE, frame_of(light, max(lights), noise)))
        return self.folder / name

    def match(self, video, *more):
        return run("match", "phosphor", "--video", video, *more)

    def test_a_flash_gives_the_tube_and_its_slow_time_constant(self):
        frames = self.make_frames()
        done = self.match(frames, "--fps", "240", "--json", "-o", self.folder / "tube.json")
        self.assert_done(done)
        found = json.loads(done.stdout)
        self.assertEqual(found["types"], {"tube": "P31"})
        self.assertEqual(found["tubes"][0]["tube"], "P31")
        self.assertGreater(found["tubes"][0]["probability"], 0.9)
        self.assertEqual(len(found["tubes"]), 10)
        self.assertAlmostEqual(sum(tube["probability"] for tube in found["tubes"]), 1.0, places=6)
        self.assertEqual(found["lit_frames"], 1)
        *short, slow = found["time_constants"]
        self.assertLess(abs(slow["seconds"] / 0.016 - 1.0), 0.05)
        self.assertLess(slow["low"], 0.016)
        self.assertGreater(slow["high"], 0.016)
        self.assertTrue(slow["identifiable"])
        for constant in short:
            self.assertFalse(constant["identifiable"])
            self.assertEqual(constant["reason"], "it is shorter than a frame of the video")
        preset = json.loads((self.folder / "tube.json").read_text())
        self.assertEqual(preset["values"]["tube"], "P31")

    @unittest.skipUnless(shutil.which("ffmpeg"), "ffmpeg is not installed")
    def test_a_film_at_a_slower_rate_than_it_was_recorded_at(self):
        frames = self.make_frames()
        film = self.folder / "fade.mp4"
        subprocess.run(["ffmpeg", "-v", "error", "-framerate", "30", "-i", frames, "-c:v", "libx264rgb", "-qp", "0", film],
                       check=True)
        done = self.match(film, "--fps", "240", "--at", "24,24", "-o", self.folder / "tube.json")
        self.assert_done(done)
        self.assertIn("240 frames per second, place 28,28", done.stdout)
        self.assertIn("tube                     P31\n", done.stdout)

    def test_an_exponential_that_no_tube_has_gives_its_own_decay(self):
        seconds, noise = 0.4, random.Random(2)
        for i in range(160):
            light = 0.0 if i < 5 else math.exp(-(i - 5) / (60 * seconds))
            self.write("slow_%03d.png" % i, png(SIDE, SIDE, frame_of(light, 1.0, noise)))
        done = self.match(self.folder / "slow_%03d.png", "--fps", "60", "--preset", "radar-p7", "--json")
        self.assert_done(done)
        found = json.loads(done.stdout)
        self.assertEqual(found["types"], {"tube": "Custom"})
        decay = next(row for row in found["parameters"] if row["name"] == "decay")
        half_life = math.log(0.5) / math.log(decay["value"]) / 60
        self.assertLess(abs(half_life / (seconds * math.log(2)) - 1.0), 0.05)
        (constant,) = found["time_constants"]
        self.assertLess(constant["low"], seconds)
        self.assertGreater(constant["high"], seconds)

    def test_bad_videos_are_refused_with_the_reason(self):
        frames = self.make_frames(count=8)
        dark = self.write("dark_0.png", png(SIDE, SIDE, bytes(3 * SIDE * SIDE))).with_name("dark_%d.png")
        shutil.copy(self.folder / "dark_0.png", self.folder / "dark_1.png")
        white = self.write("white_0.png", png(SIDE, SIDE, b"\xff" * (3 * SIDE * SIDE))).with_name("white_%d.png")
        shutil.copy(self.folder / "dark_0.png", self.folder / "white_1.png")
        grey = self.write("grey_0.png", png(SIDE, SIDE, bytes(SIDE * SIDE), kind=0)).with_name("grey_%d.png")
        rate = ("--fps", "240", "--json")
        for words, video, options in (
                ("The rate at which this was recorded is not known. Give it with --fps.", frames, ("--json",)),
                ("does not show how the light fades. Record the moment when it goes off", frames, rate),
                ("The place 99,5 is outside the video. It has 48 x 48 px.", frames, (*rate, "--at", "99,5")),
                ("The video shows no light at this place.", dark, (*rate, "--at", "8,8")),
                ("The video is overexposed where the light changes.", white, rate),
                ("The frames must have colours", grey, rate),
                ("This is not a video.", self.folder / "fade_000.png", rate)):
            with self.subTest(words):
                self.assert_refused(self.match(video, *options), words)
        self.assert_refused(run("match", "crt", "--video", frames, *rate), "This look does not say which parameters a video")

    def test_wrong_usage_says_what_to_do(self):
        for words, arguments in (
                ("Give --photo FILE or --video FILE", ("--json",)),
                ("Give --photo FILE or --video FILE", ("--photo", "a.png", "--video", "a.mp4", "--json")),
                ("--output FILE, --report FILE or --json is required", ("--photo", "a.png")),
                ("--report needs --photo", ("--video", "a.mp4", "--report", "a.html")),
                ("--at: expected X,Y in px, got '5'", ("--video", "a.mp4", "--at", "5", "--json")),
                ("--corners: expected 8 numbers", ("--photo", "a.png", "--corners", "1,2,3", "--json"))):
            with self.subTest(words):
                self.assert_refused(run("match", "phosphor", *arguments), words, code=2)


class Photos(ProgramTest):
    """Photos that can't be matched, and the report of one that can."""

    def match(self, photo, *more):
        source = () if "--source" in more else ("--source", "pattern:smpte")
        return run("match", "shadow-mask", "--photo", photo, *source, "--json", *more)

    def gradient(self, width, height):
        return bytes(value for y in range(height) for x in range(width)
                     for value in (40 + 100 * x // width, 40 + 100 * y // height, 90))

    def test_bad_photos_are_refused_with_the_reason(self):
        photo = self.write("photo.png", png(160, 120, self.gradient(160, 120)))
        white = self.write("white.png", png(160, 120, b"\xff" * (3 * 160 * 120)))
        grey = self.write("grey.png", png(160, 120, bytes(160 * 120), kind=0))
        text = self.write("text.jpg", "no picture")
        for words, file, options in (
                ("missing.jpg: error:", self.folder / "missing.jpg", ()),
                ("text.jpg: error:", text, ()),
                ("The photo is overexposed: 100 %", white, ()),
                ("This photo has no colours.", grey, ()),
                ("is outside the photo. The photo has 160 x 120 px.", photo, ("--corners", "0,0,999,0,150,110,0,110")),
                ("crossed", photo, ("--corners", "150,0,0,0,150,110,0,110")),
                ("none.png", photo, ("--source", self.folder / "none.png"))):
            with self.subTest(words):
                self.assert_refused(self.match(file, *options), words)

    def test_the_orientation_of_a_photo_is_followed(self):
        """The photo lies on its side, and its EXIF data turn it upright."""
        if not shutil.which("ffmpeg"):
            self.skipTest("ffmpeg is not installed")
        plain = self.write("plain.png", png(120, 160, self.gradient(120, 160)))
        subprocess.run(["ffmpeg", "-v", "error", "-i", plain, self.folder / "plain.jpg"], check=True)
        data = (self.folder / "plain.jpg").read_bytes()
        exif = b"Exif\0\0MM\0*" + struct.pack(">IHHHIHHI", 8, 1, 0x0112, 3, 1, 6, 0, 0)
        turned = self.write("turned.jpg", data[:2] + b"\xff\xe1" + struct.pack(">H", 2 + len(exif)) + exif + data[2:])
        self.assert_refused(self.match(turned, "--corners", "0,0,999,0,150,110,0,110"), "The photo has 160 x 120 px.")

    def test_a_match_writes_preset_camera_and_report(self):
        bars, photo = self.folder / "bars.png", self.folder / "set.png"
        size = ("--size", "240x180")
        values = {"mask_type": "Aperture grille", "mask_strength": "0.7", "sampling": "Continuous", "exposure": "0.25",
                  "vignette_depth": "0", "red_offset": "0,0", "green_offset": "0,0", "blue_offset": "0,0"}
        sets = [word for name, value in values.items() for word in ("--set", f"{name}={value}")]
        self.assert_done(run("render", "crt", "--set", "crt=off", "--source", "pattern:harbour", *size, "-o", bars))
        self.assert_done(run("render", "shadow-mask", *sets, "--source", bars, *size, "-o", photo))
        report = self.folder / "set.html"
        done = run("match", "shadow-mask", "--photo", photo, "--source", bars, "-o", self.folder / "set.json",
                   "--report", report, "--json")
        self.assert_done(done)
        found = json.loads(done.stdout)
        self.assertEqual(found["types"], {"mask_type": "Aperture grille"})
        pitch = next(row for row in found["parameters"] if row["name"] == "mask_size")
        self.assertLess(abs(pitch["value"] / 6.0 - 1.0), 0.01)
        self.assertGreater(found["explained"], 0.9)
        page = report.read_text()
        self.assertIn("% of the light and dark that were compared.", page)
        self.assertEqual(page.count("<img "), 3)
        self.assertIn("<td>mask_size</td>", page)
        self.assertEqual(json.loads((self.folder / "set.camera.json").read_text()), found["camera"])
        preset = json.loads((self.folder / "set.json").read_text())
        self.assertEqual(preset["values"]["mask_type"], "Aperture grille")


if __name__ == "__main__":
    main()
