"""Image sequences and videos as read by players and other programs."""

import json
import os
import resource
import shutil
import signal
import struct
import subprocess
import time
import unittest
import wave
import zlib

from program import PROGRAM, ProgramTest, main, read_png, run, unfiltered

HAS_FFMPEG = shutil.which("ffmpeg") is not None and shutil.which("ffprobe") is not None
RATE = 48000


def end_by_ctrl_c():
    signal.signal(signal.SIGINT, signal.SIG_DFL)  # the default, as in a terminal


def png_bodies(data, wanted):
    """The contents of all chunks of one kind, in file order."""
    at = 8
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        if kind == wanted:
            yield data[at + 8:at + 8 + length]
        at += 12 + length


class ExportTest(ProgramTest):
    def look(self, name, body, **last_pass):
        """A look with one pass and without a signal."""
        self.write(f"{name}/look.json", json.dumps(
            {"format": "afterglow-look", "version": 1, "name": name, "driven_by": "nothing", "settle_frames": 5,
             "passes": [{"name": "show", "fragment": "show.frag", **last_pass}]}))
        self.write(f"{name}/show.frag", "#version 410 core\nuniform float u_time;\nuniform vec2 u_resolution;\n"
                   "in vec2 uv;\nout vec4 color;\nvoid main() { " + body + " }\n")
        return self.folder / name

    def moving(self, **last_pass):
        return self.look("moving", "color = vec4(fract(u_time), uv.y, 0.5 + 0.5 * sin(40.0 * u_time + 9.0 * uv.x), 1.0);",
                         **last_pass)

    def heavy(self):
        """A look whose frames take some time."""
        return self.look("heavy", "float sum = u_time; for (int i = 0; i < 3000; ++i) sum = sin(sum + uv.x);"
                         " color = vec4(vec3(sum), 1.0);")

    def files(self, ending):
        return sorted(file.name for file in self.folder.iterdir() if file.name.endswith(ending))

    def leftovers(self):
        return [file.name for file in self.folder.iterdir() if file.name.startswith(".afterglow")]


class Targets(ExportTest):
    def test_numbers_below_zero_of_a_pass_of_whole_numbers_are_saved(self):
        self.write("look.json", """{ "format": "afterglow-look", "version": 1, "name": "Signed", "driven_by": "nothing", "passes": [
            { "name": "signed", "fragment": "i.frag", "format": "rgba32i" },
            { "name": "light", "fragment": "f.frag", "format": "rgba32f" },
            { "name": "shown", "fragment": "s.frag", "inputs": { "image": "signed" } }]}""")
        self.write("s.frag", """#version 410 core
            uniform isampler2D image;
            out vec4 color;
            void main() { color = vec4(texelFetch(image, ivec2(0), 0).r == -5 ? 0.2 : 0.0); }""")
        for name, kind in (("i", "ivec4"), ("f", "vec4")):
            self.write(f"{name}.frag", f"""#version 410 core
                out {kind} color;
                void main() {{ color = {kind}(-5, 70000, -2147483647 - 1, -32768); }}""")
        for name in ("signed", "light"):
            for ending in ("exr", "png"):
                self.assert_done(run("render", self.folder, "--size", "4x4", "--pass", name, "-o",
                                     self.folder / f"{name}.{ending}"))
        self.assert_done(run("render", self.folder, "--size", "4x4", "-o", self.folder / "shown.png"))
        self.assertEqual(read_png(self.folder / "shown.png")[2][0][0], 51)
        for ending in ("exr", "png"):
            self.assert_done(run("compare", self.folder / f"signed.{ending}", self.folder / f"light.{ending}",
                                 "--fail-above", "max=0"))
        numbers = self.write("i.frag", """#version 410 core
            out ivec4 color;
            void main() { color = ivec4(-4, 70000, -2147483647 - 1, -32768); }""")
        self.assert_done(run("render", self.folder, "--size", "4x4", "--pass", "signed", "-o", numbers.with_suffix(".exr")))
        self.assert_refused(run("compare", numbers.with_suffix(".exr"), self.folder / "light.exr", "--fail-above", "max=0"))
        passes = json.loads(run("describe", self.folder, "--json").stdout)["passes"]
        self.assertEqual(passes[0]["format"], "rgba32i")
        # Per pixel, 4 x 4 bytes are written and read, and 4 are written for the picture.
        measured = json.loads(run("bench", self.folder, "--size", "4x4", "--frames", "2", "--json").stdout)
        self.assertEqual(measured["bytes_per_pixel"], 36)


    def test_a_picture_of_4096_or_7680_pixels_is_drawn_to_its_end_and_a_larger_one_refused_in_words(self):
        look = self.look("halves", "color = vec4(floor(uv.x * 2.0), 0.2, floor(uv.y * 2.0), 1.0);")
        for width, height in ((4096, 4096), (7680, 4320)):
            picture = self.folder / f"{width}.png"
            self.assert_done(run("render", look, "--size", f"{width}x{height}", "--frames", 1, "-o", picture))
            data = picture.read_bytes()
            self.assertEqual(struct.unpack(">II", data[16:24]), (width, height))
            rows = zlib.decompress(b"".join(png_bodies(data, b"IDAT")))
            stride = 1 + 3 * width
            self.assertEqual(len(rows), stride * height)
            top = unfiltered(rows[0], bytearray(rows[1:stride]), bytearray(stride - 1))
            self.assertEqual((bytes(top[:3]), bytes(top[-3:])), (b"\0\x33\xff", b"\xff\x33\xff"))
        gone = self.folder / "none.png"
        refused = run("render", "phosphor", "--size", "16384x16384", "-o", gone)
        self.assert_refused(refused)
        # Limited by the memory of the machine, or with enough memory by the limit for targets.
        self.assertRegex(refused.stderr, "GB of memory|the limit is 8 GiB")
        self.assert_refused(run("render", look, "--size", "16385x16", "-o", gone), "1 to 16384 px per side, got '16385x16'", code=2)
        self.assertFalse(gone.exists())


class Sequences(ExportTest):
    def test_each_file_is_what_the_frame_alone_gives(self):
        for texel in ("rgba8", "rgba16f", "rgba32f"):
            look = self.moving(format=texel)
            size = ("--size", "67x45")
            for ending in ("png", "exr"):
                frames = self.folder / f"{texel}_%04d.{ending}"
                self.assert_done(run("render", look, *size, "--frames", 23, "-o", frames))
                self.assertEqual(len([name for name in self.files(ending) if name.startswith(texel)]), 23)
                for number in (0, 9, 22):
                    alone = self.folder / f"alone.{ending}"
                    self.assert_done(run("render", look, *size, "--frames", number + 1, "-o", alone))
                    if ending == "exr":
                        self.assertEqual((self.folder / f"{texel}_{number:04d}.exr").read_bytes(), alone.read_bytes())
                    else:
                        self.assertEqual(read_png(str(frames) % number), read_png(alone))
                    alone.unlink()
        self.assertEqual(self.leftovers(), [])

    def test_a_part_has_the_frames_and_the_numbers_of_the_whole(self):
        scope = ("render", "phosphor", "--size", "64x48", "--fps", "20")
        self.assert_done(run(*scope, "--frames", 16, "-o", self.folder / "all_%04d.exr"))
        self.assert_done(run(*scope, "--start", "0.5", "--seconds", "0.3", "-o", self.folder / "part_%04d.exr"))
        self.assertEqual([name for name in self.files("exr") if name.startswith("part")],
                         [f"part_{number:04d}.exr" for number in range(10, 16)])
        for number in range(10, 16):
            self.assertEqual((self.folder / f"part_{number:04d}.exr").read_bytes(),
                             (self.folder / f"all_{number:04d}.exr").read_bytes())

    def test_ctrl_c_leaves_whole_pictures_only(self):
        started = subprocess.Popen([PROGRAM, "render", self.heavy(), "--size", "320x240", "--frames", "100000",
                                    "-o", self.folder / "f_%06d.png"], stderr=subprocess.PIPE, preexec_fn=end_by_ctrl_c)
        self.addCleanup(started.kill)
        end = time.monotonic() + 60
        while len(self.files("png")) < 3 and started.poll() is None and time.monotonic() < end:
            time.sleep(0.02)
        started.send_signal(signal.SIGINT)
        self.assertEqual(started.wait(timeout=60), -signal.SIGINT)
        started.stderr.close()
        names = self.files("png")
        self.assertGreaterEqual(len(names), 3)
        for name in names:
            self.assertEqual(read_png(self.folder / name)[:2], (320, 240))
        self.assertEqual(self.leftovers(), [])

    def limited(self, most, *arguments):
        """A run with at most `most` bytes per file, like on a full disk."""
        def limit():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (most, most))
        done = subprocess.run([PROGRAM, *map(str, arguments)], preexec_fn=limit, stdin=subprocess.DEVNULL, timeout=120,
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, 1, done.stderr)
        return done.stderr

    def test_a_file_that_cannot_be_written_ends_it_and_is_named(self):
        noise = self.look("noise", "color = vec4(fract(sin(dot(uv, vec2(12.9898, 78.233)) + u_time) * 43758.5453));")
        told = self.limited(4000, "render", noise, "--size", "64x64", "--frames", 50, "-o", self.folder / "f_%02d.png")
        self.assertIn("f_00.png: error: can't write the file: File too large", told)
        self.assertEqual(self.files("png") + self.leftovers(), [])
        self.write("file", "")
        done = run("render", noise, "--size", "8x8", "-o", self.folder / "file/f_%02d.png")
        self.assert_refused(done, "f_00.png: error: can't write the file: ", "isn't a folder")

    @unittest.skipUnless(HAS_FFMPEG, "there is no ffmpeg here")
    def test_a_film_that_cannot_be_written_is_named(self):
        noise = self.look("noise", "color = vec4(fract(sin(dot(uv, vec2(12.9898, 78.233)) + u_time) * 43758.5453));")
        for ending in ("mp4", "webm", "gif"):
            told = self.limited(4000, "render", noise, "--size", "64x64", "--frames", 50,
                                "-o", self.folder / f"film.{ending}")
            self.assertIn(f"film.{ending}: error: can't write the ", told)
            self.assertEqual(self.files(ending) + self.leftovers(), [])

    def test_what_makes_no_sense_is_wrong_usage(self):
        look = self.moving()
        for arguments, words in ((("-o", "f_%d.mp4"), "a video is one file"),
                                 (("-o", "f.avi"), "must end in .png, .exr, .mp4, .mov, .mkv, .webm or .gif, got 'f.avi'"),
                                 (("-o", "f.png", "--start", "1"), "--start needs a video or an image sequence"),
                                 (("-o", "f.mp4", "--seconds", "0"), "--seconds"),
                                 (("-o", "f.mp4", "--seconds", "1", "--frames", "2"), "--frames")):
            self.assert_refused(run("render", look, *arguments, cwd=self.folder), words, code=2)
        self.assert_refused(run("render", look, "-o", self.folder / "f_%d.png", "--start", "1", "--frames", "5"),
                            "--start is after the last of --frames")


class Pipe(ExportTest):
    def test_y4m_goes_into_a_pipe_and_nothing_else(self):
        # BT.709 in limited range: Y is 16 + 219 / 255 of the luma; Cb and Cr likewise.
        look = self.look("plain", "color = vec4(200.0 / 255.0, 30.0 / 255.0, (uv.y > 0.5 ? 60.0 : 255.0) / 255.0, 1.0);")
        done = subprocess.run([PROGRAM, "render", look, "--size", "7x4", "--fps", "25", "--seconds", "0.12", "-o", "-"],
                              capture_output=True, timeout=120)
        self.assertEqual((done.returncode, done.stderr), (0, b""))
        header, _, frames = done.stdout.partition(b"\n")
        self.assertEqual(header, b"YUV4MPEG2 W7 H4 F25:1 Ip A1:1 C444 XCOLORRANGE=LIMITED")
        self.assertEqual(len(frames), 3 * (6 + 3 * 28))
        planes = b""
        for blue in (60, 255):  # above and below
            light = 0.2126 * 200 + 0.7152 * 30 + 0.0722 * blue
            planes += bytes([round(16 + 219 / 255 * light), round(128 + 224 / 255 * (blue - light) / 1.8556),
                             round(128 + 224 / 255 * (200 - light) / 1.5748)])
        frame = b"FRAME\n" + b"".join(planes[plane:plane + 1] * 14 + planes[plane + 3:plane + 4] * 14
                                      for plane in range(3))
        self.assertEqual(frames, frame * 3)

    def test_a_reader_that_goes_away_ends_it(self):
        started = subprocess.Popen([PROGRAM, "render", self.moving(), "--size", "64x64", "--seconds", "3600", "-o", "-"],
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.addCleanup(started.kill)
        self.assertTrue(started.stdout.read(9).startswith(b"YUV4MPEG2"))
        started.stdout.close()
        self.assertNotEqual(started.wait(timeout=60), 0)
        started.stderr.close()


@unittest.skipUnless(HAS_FFMPEG, "there is no ffmpeg here")
class Films(ExportTest):
    def film(self, name, *arguments):
        self.assert_done(run("render", *arguments, "-o", self.folder / name))
        self.assertEqual(self.leftovers(), [])
        return self.folder / name

    def facts(self, film):
        told = subprocess.run(["ffprobe", "-v", "error", "-count_frames", "-show_streams", "-show_format", "-of", "json",
                               film], check=True, capture_output=True, text=True)
        facts = json.loads(told.stdout)
        return {stream["codec_type"]: stream for stream in facts["streams"]}, facts["format"]

    def pictures(self, film, size):
        """All frames as RGB bytes."""
        raw = subprocess.run(["ffmpeg", "-v", "error", "-i", film, "-vsync", "passthrough", "-f", "rawvideo",
                              "-pix_fmt", "rgb24", "-sws_flags", "accurate_rnd+full_chroma_int", "-"], check=True, capture_output=True).stdout
        length = 3 * size[0] * size[1]
        return [raw[at:at + length] for at in range(0, len(raw), length)]

    def samples(self, film):
        """The left channel, from time 0 of the video."""
        raw = subprocess.run(["ffmpeg", "-v", "error", "-copyts", "-i", film, "-map", "0:a", "-af", "aresample=first_pts=0",
                              "-f", "f32le", "-ac", "2", "-ar", str(RATE), "-"], check=True, capture_output=True).stdout
        return [pair[0] for pair in struct.iter_unpack("<ff", raw)]

    def tone_burst(self, first, count, seconds):
        """Silence with a burst on both channels: the beam jumps to the upper right and back."""
        with wave.open(str(self.folder / "burst.wav"), "wb") as sound:
            sound.setparams((2, 2, RATE, 0, "NONE", ""))
            level = struct.pack("<hh", 16384, 16384)
            rest = bytes(4)
            sound.writeframes(rest * first + level * count + rest * (round(seconds * RATE) - first - count))
        return f"audio:{self.folder}/burst.wav,mode=xy"

    def test_a_film_has_the_size_the_rate_and_the_length_that_were_asked_for(self):
        for ending, codec, size in (("mp4", "h264", (98, 62)), ("webm", "vp9", (97, 61)), ("gif", "gif", (97, 61))):
            film = self.film(f"film.{ending}", self.moving(), "--size", "97x61", "--fps", "25", "--seconds", "1.2")
            streams, _ = self.facts(film)
            self.assertEqual(list(streams), ["video"])
            picture = streams["video"]
            self.assertEqual(picture["codec_name"], codec)
            self.assertEqual((picture["width"], picture["height"]), size)
            self.assertEqual(picture["nb_read_frames"], "30")
            self.assertEqual(picture["avg_frame_rate"], "25/1")
            if ending == "gif":
                continue
            self.assertEqual(picture["pix_fmt"], "yuv420p")
            self.assertEqual([picture.get(f"color_{of}") for of in ("space", "primaries", "transfer", "range")],
                             ["bt709", "bt709", "bt709", "tv"])
        start = (self.folder / "film.mp4").read_bytes()[:4096]
        self.assertIn(b"moov", start)  # players need the index at the start

    def test_colours_are_those_of_the_look(self):
        look = self.look("plain", "color = vec4(uv.x < 0.5 ? vec3(200, 30, 60) / 255.0 : vec3(20, 160, 240) / 255.0, 1.0);")
        for ending in ("mp4", "webm", "gif"):
            film = self.film(f"film.{ending}", look, "--size", "64x32", "--fps", "25", "--frames", "3")
            pictures = self.pictures(film, (64, 32))
            self.assertEqual(len(pictures), 3)
            for x, rgb in ((12, (200, 30, 60)), (51, (20, 160, 240))):
                at = 3 * (64 * 16 + x)
                for is_, expected in zip(pictures[1][at:at + 3], rgb):
                    self.assertAlmostEqual(is_, expected, delta=5, msg=ending)

    def test_the_last_row_and_column_of_an_odd_size_are_there_twice(self):
        look = self.look("plain", "color = vec4(vec3(0.8), 1.0);")
        film = self.film("film.mp4", look, "--size", "33x31", "--frames", "2")
        for number in self.pictures(film, (34, 32))[0]:
            self.assertAlmostEqual(number, 204, delta=2)

    def test_a_gif_leaves_out_what_is_too_fast_for_it(self):
        film = self.film("film.gif", self.moving(), "--size", "32x32", "--fps", "100", "--seconds", "1")
        picture = self.facts(film)[0]["video"]
        self.assertEqual(picture["nb_read_frames"], "50")
        self.assertAlmostEqual(float(picture["duration"]), 1.0, delta=0.03)

    def test_a_flash_and_its_sound_are_where_they_were_in_the_signal(self):
        first, count, seconds, fps = 24000, 800, 0.9, 60  # frame 31: from 30/60 s to 31/60 s
        spec = self.tone_burst(first, count, seconds)
        side = 64
        # -1 to 1 covers 0.9 of the picture. The beam is half way right and half way up.
        at = 3 * (side * round(side / 2 - 0.225 * side) + round(side / 2 + 0.225 * side))
        for ending, start in (("mp4", 0.0), ("webm", 0.0), ("mp4", 0.25)):
            film = self.film(f"film.{ending}", "vector-beam", "--size", f"{side}x{side}", "--signal", spec,
                             *(("--start", start) if start else ()))
            streams, whole = self.facts(film)
            self.assertEqual(int(streams["video"]["nb_read_frames"]), round((seconds - start) * fps))
            self.assertAlmostEqual(float(whole["duration"]), seconds - start, delta=0.03)
            light = [max(picture[at:at + 3]) for picture in self.pictures(film, (side, side))]
            lit = round((first / RATE - start) * fps)
            self.assertLess(max(light[:lit]), 60)
            self.assertGreater(light[lit], 100)
            heard = self.samples(film)
            begins = next(i for i, sample in enumerate(heard) if sample > 0.25)
            self.assertAlmostEqual(begins, first - start * RATE, delta=24)
            self.assertAlmostEqual(float(streams["video"]["start_time"]), 0.0, delta=0.001)
            self.assertGreaterEqual(len(heard), round((seconds - start) * RATE))

    def test_a_sound_ends_with_the_film_and_a_gif_has_none(self):
        spec = self.tone_burst(0, 100, 2.0)
        film = self.film("film.mp4", "vector-beam", "--size", "32x32", "--signal", spec, "--seconds", "0.5")
        self.assertAlmostEqual(len(self.samples(film)), RATE / 2, delta=1024)
        film = self.film("film.gif", "vector-beam", "--size", "32x32", "--signal", spec, "--fps", "10")
        streams, _ = self.facts(film)
        self.assertEqual(list(streams), ["video"])
        self.assertEqual(streams["video"]["nb_read_frames"], "20")
        self.assert_refused(run("render", "vector-beam", "--signal", spec, "--start", "2", "-o", self.folder / "x.mp4"),
                            "nothing to export from 2 s on: the sound ends at 2 s")

    def test_ctrl_c_leaves_the_film_that_was_there(self):
        film = self.write("film.mp4", "old")
        started = subprocess.Popen([PROGRAM, "render", self.heavy(), "--size", "320x240", "--seconds", "3600",
                                    "-o", film], stderr=subprocess.PIPE, preexec_fn=end_by_ctrl_c)
        self.addCleanup(started.kill)
        end = time.monotonic() + 60
        while not self.leftovers() and started.poll() is None and time.monotonic() < end:
            time.sleep(0.02)
        time.sleep(0.3)
        started.send_signal(signal.SIGINT)
        self.assertEqual(started.wait(timeout=60), -signal.SIGINT)
        started.stderr.close()
        self.assertEqual(film.read_text(), "old")
        self.assertEqual(self.leftovers(), [])

    def test_without_ffmpeg_its_package_is_named(self):
        done = run("render", self.moving(), "--size", "8x8", "-o", self.folder / "film.mp4", PATH=str(self.folder))
        self.assert_refused(done, "film.mp4: error: ", "Debian package ffmpeg", "isn't installed")
        self.assertEqual(self.files("mp4") + self.leftovers(), [])


if __name__ == "__main__":
    main()
