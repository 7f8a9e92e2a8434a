#!/usr/bin/env python3
"""Films and sweeps that are drawn in parts: their pictures equal those of a single run."""

import json
import os
import shutil
import subprocess
import unittest
import xml.etree.ElementTree as ElementTree

from program import PROGRAM, ProgramTest, main, read_png, run

PLAIN = ("--size", "64x48", "--fps", "10")


class JobsTest(ProgramTest):
    def split(self, *arguments, engine="make", name="farm", code=0):
        done = run("jobs", *arguments, "--for", engine, "-o", self.folder / name, cwd=self.folder)
        self.assertEqual(done.returncode, code, f"{done.stdout}{done.stderr}")
        return done

    def start(self, *arguments, name="farm", path=None, **environment):
        program = self.folder / "bin"
        program.mkdir(exist_ok=True)
        link = program / "afterglow"
        if not link.exists():
            link.symlink_to(PROGRAM)
        settings = dict(os.environ, PATH=path or f"{program}:{os.environ['PATH']}", **environment)
        return subprocess.run([self.folder / name / "run", *arguments], env=settings, capture_output=True, text=True,
                              timeout=150, check=False)

    def whole(self, *arguments):
        """The frames of a single run."""
        done = run("render", *arguments, "-o", self.folder / "whole" / "%04d.png", cwd=self.folder)
        self.assert_done(done)
        return self.folder / "whole"

    def assert_same(self, count, first=0):
        """All frames have the same bytes as those of a single run."""
        numbers = range(first, first + count)
        self.assertEqual(sorted(file.name for file in (self.folder / "farm/frames").iterdir()),
                         [f"{number:04}.png" for number in numbers])
        for number in numbers:
            name = f"{number:04}.png"
            self.assertEqual((self.folder / "farm/frames" / name).read_bytes(),
                             (self.folder / "whole" / name).read_bytes(), name)

    def assert_close(self, count):
        """All frames differ by at most one 8-bit step from those of a single run."""
        for number in range(count):
            name = f"{number:04}.png"
            drawn, whole = (read_png(self.folder / folder / name)[2] for folder in ("farm/frames", "whole"))
            largest = max(abs(a - b) for left, right in zip(drawn, whole) for a, b in zip(left, right))
            self.assertLessEqual(largest, 1, name)

    @unittest.skipUnless(shutil.which("parallel"), "GNU parallel is not installed")
    def test_parallel_draws_the_same_film_and_touches_nothing_else(self):
        film = ("crt", "--source", "pattern:glyph-rain", *PLAIN, "--frames", "11")
        self.whole(*film)
        self.split(*film, "--frames-per-job", "4", "--join", "farm/film.mkv", engine="parallel")
        home = self.folder / "home"
        home.mkdir()
        homes = {f"XDG_{kind}_HOME": str(home / kind) for kind in ("CONFIG", "DATA", "STATE", "CACHE")}
        done = self.start("2", HOME=str(home), MESA_SHADER_CACHE_DIR="", **homes)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assert_same(11)
        self.assertEqual(list(home.iterdir()), [])
        told = subprocess.run(["ffprobe", "-v", "error", "-count_frames", "-show_streams", "-of", "json",
                               self.folder / "farm/film.mkv"], check=True, capture_output=True, text=True)
        self.assertEqual(json.loads(told.stdout)["streams"][0]["nb_read_frames"], "11")

    def test_sub_frames_are_the_same_in_parts_that_begin_within_a_source_frame(self):
        film = ("rolling-scan", "--source", "pattern:glyph-rain", "--subframes", *PLAIN, "--frames", "14")
        self.whole(*film)
        self.split(*film, "--frames-per-job", "3")
        self.assert_done(self.start())
        self.assert_same(14)

    def test_fading_light_differs_by_at_most_one_step(self):
        for look, *values in (("phosphor", "decay=0.8"), ("phosphor", "tube=P32", "time_scale=2"),
                              ("phosphor", "as_written=true", "decay=0.7"), ("vector-beam", "decay_time=80")):
            shutil.rmtree(self.folder / "whole", ignore_errors=True)
            shutil.rmtree(self.folder / "farm", ignore_errors=True)
            film = [look, *PLAIN, "--frames", "90", "--signal", "lissajous:x=3,y=2,speed=0.4"]
            for value in values:
                film += ["--set", value]
            with self.subTest(film):
                self.whole(*film)
                said = self.split(*film, "--frames-per-job", "30").stdout
                self.assertRegex(said, r"Each part draws \d+ earlier frames first")
                self.assertIn("--lead-in", (self.folder / "farm/part").read_text())
                done = self.start()
                self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
                self.assert_close(90)

    def test_the_parts_of_a_film_with_a_start_have_its_numbers_and_its_sound(self):
        tone = self.folder / "tone.wav"
        subprocess.run(["ffmpeg", "-v", "error", "-f", "lavfi", "-i", "aevalsrc=sin(880*t)|cos(880*t):d=2:s=48000",
                        tone], check=True)
        film = ("phosphor", "--signal", "audio:tone.wav,mode=xy", *PLAIN, "--set", "decay=0.5", "--start", "0.5")
        self.split(*film, "--frames-per-job", "6", "--join", "out/film.mov")
        self.assert_done(self.start("1"))
        self.assertEqual(len(list((self.folder / "farm/frames").glob("00*.png"))), 15)
        self.assertTrue((self.folder / "farm/frames/0005.png").exists())
        self.assert_done(run("render", *film, "-o", "single.mov", cwd=self.folder))
        sounds = [self.sound(self.folder / name) for name in ("out/film.mov", "single.mov")]
        self.assertGreater(len(sounds[0]), 100000)
        self.assertEqual(*sounds)

    def sound(self, film):
        return subprocess.run(["ffmpeg", "-v", "error", "-i", film, "-map", "0:a", "-f", "f32le", "-"], check=True,
                              capture_output=True).stdout

    def test_finished_parts_are_not_drawn_again(self):
        film = ("crt", "--source", "pattern:smpte", *PLAIN, "--frames", "6")
        self.split(*film, "--frames-per-job", "2")
        self.assert_done(self.start())
        frames = sorted((self.folder / "farm/frames").iterdir())
        before = [file.stat().st_mtime_ns for file in frames]
        frames[3].unlink()
        self.assert_done(self.start())
        after = [file.stat().st_mtime_ns for file in frames]
        self.assertEqual([number for number in range(6) if before[number] != after[number]], [2, 3])

    def test_a_failure_is_reported_and_the_join_is_not_started(self):
        film = ("crt", "--source", "clip.png", *PLAIN, "--frames", "4")
        self.assert_done(run("render", "crt", *PLAIN, "--frames", "1", "-o", self.folder / "clip.png"))
        self.split(*film, "--frames-per-job", "2", "--join", "film.mp4")
        (self.folder / "clip.png").unlink()
        done = self.start()
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("clip.png", done.stderr)
        self.assertFalse((self.folder / "film.mp4").exists())
        missing = self.start(path="/usr/bin:/bin")
        self.assertEqual(missing.returncode, 1)
        self.assertIn("afterglow was not found", missing.stderr)

    def test_a_sweep_is_drawn_in_parts_and_joined_to_its_sheet(self):
        sweep = ("crt", "--source", "pattern:smpte", *PLAIN, "--vary", "exposure=1:4:5", "--frames", "2")
        self.split(*sweep, "--frames-per-job", "2", "--join", "sheet.png")
        self.assert_done(self.start())
        self.assert_done(run("sweep", *sweep, "-o", self.folder / "whole/%04d.png"))
        self.assert_same(5)
        self.assert_done(run("sweep", *sweep, "-o", self.folder / "single.png"))
        self.assertEqual(read_png(self.folder / "sheet.png"), read_png(self.folder / "single.png"))

    def test_looks_without_a_known_bound_start_at_the_first_frame(self):
        said = self.split("caffeine", *PLAIN, "--frames", "4", "--frames-per-job", "2").stdout
        self.assertIn("Each part draws all earlier frames first: pass 'points' accumulates.", said)
        self.assertNotIn("--lead-in", (self.folder / "farm/part").read_text())
        said = self.split("phosphor", *PLAIN, "--set", "decay=1", "--frames", "4", "--frames-per-job", "2",
                          name="held").stdout
        self.assertIn("at these values, earlier frames do not fade", said)

    def test_opencue_gets_a_specification_in_the_order_of_its_schema(self):
        self.split("crt", "--source", "pattern:smpte", *PLAIN, "--frames", "5", "--frames-per-job", "2", "--join",
                   "film.mp4", engine="opencue")
        root = ElementTree.parse(self.folder / "farm/opencue.xml").getroot()
        # The elements that the files use, in the order of the specification language, version 1.15.
        order = {
            "spec": ["show", "shot", "user", "uid", "job", "depends"],
            "job": ["paused", "maxretries", "layers"],
            "layers": ["layer", "layer"],
            "layer": ["cmd", "range", "chunk", "services"],
            "services": ["service"],
            "depends": ["depend"],
            "depend": ["depjob", "deplayer", "onjob", "onlayer"],
        }
        for element in root.iter():
            self.assertEqual([child.tag for child in element], order.get(element.tag, []), element.tag)
        layers = {layer.get("name"): (layer.get("type"), layer.findtext("range")) for layer in root.iter("layer")}
        self.assertEqual(layers, {"parts": ("Render", "0-2"), "join": ("Post", "1")})
        self.assertEqual(root.find("depends/depend").get("type"), "LAYER_ON_LAYER")

    def test_wrong_usage_is_refused_before_anything_is_written(self):
        full = self.write("full/file.txt", "")
        film = ("crt", "--frames", "4", "--frames-per-job", "2", "--for", "make")
        self.assert_refused(run("jobs", *film, "-o", full.parent), "the folder is not empty")
        farm = self.folder / "farm"
        self.assert_refused(run("jobs", *film, "--source", "pipe:", "-o", farm), "live input can't be drawn in parts")
        for more, words in ((("--join", "film.txt"), "--join: the file name must end in"),
                            (("--hdr", "hdr10"), "--hdr: the parts are 8-bit pictures"),
                            (("--vary", "exposure=1:2:2", "--start", "1"), "--vary draws separate pictures"),
                            (("--codec", "h264"), "need a video file"),
                            (("--vary", "a=1:2:2", "--vary", "b=1:2:2", "--vary", "c=1:2:2"), "at most twice")):
            self.assert_refused(run("jobs", *film, *more, "-o", farm), words, code=2)
        large = ("--size", "8000x8000", "--vary", "exposure=1:4:50", "--join", self.folder / "sheet.png")
        self.assert_refused(run("jobs", *film, *large, "-o", farm), "the limit")
        self.assert_refused(run("jobs", *film[:1], "--for", "make", "--frames-per-job", "1", "--frames", "200000", "-o", farm),
                            "200000 parts are too many")
        self.assert_refused(run("render", "crt", "--lead-in", "1", "-o", self.folder / "x_%04d.png"),
                            "--lead-in needs --start", code=2)
        self.assertFalse(farm.exists())
        self.assert_refused(run("render", "crt", "--frames-from", self.folder / "no_%04d.png", "--frames", "2", "-o",
                                self.folder / "film.mp4"), "no_0000.png")


if __name__ == "__main__":
    main()
