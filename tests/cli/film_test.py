"""Codecs, sound, transparency and loops of videos, as other programs read them."""

import array
import json
import math
import os
import shutil
import struct
import subprocess
import unittest
import wave

from program import ProgramTest, main, read_png, run

HAS_FFMPEG = shutil.which("ffmpeg") is not None and shutil.which("ffprobe") is not None
RATE = 48000


@unittest.skipUnless(HAS_FFMPEG, "ffmpeg is not installed")
class FilmTest(ProgramTest):
    def look(self, name, body, **more):
        """A look with one pass and without a signal."""
        self.write(f"{name}/look.json", json.dumps(
            {"format": "afterglow-look", "version": 1, "name": name, "driven_by": "nothing", "settle_frames": 2,
             "passes": [{"name": "show", "fragment": "show.frag", "format": "rgba32f", **more}]}))
        self.write(f"{name}/show.frag", "#version 410 core\nuniform float u_time;\nuniform sampler2D previous;\n"
                   "in vec2 uv;\nout vec4 color;\nvoid main() { " + body + " }\n")
        return self.folder / name

    def film(self, name, *arguments):
        done = run("render", *arguments, "-o", self.folder / name)
        self.assert_done(done)
        return self.folder / name

    def stream(self, film, kind="v"):
        told = subprocess.run(["ffprobe", "-v", "error", "-select_streams", kind, "-count_frames", "-show_streams",
                               "-of", "json", film], check=True, capture_output=True, text=True)
        return json.loads(told.stdout)["streams"][0]

    def decoded(self, film, pixels, *options):
        return subprocess.run(["ffmpeg", "-v", "error", *options, "-i", film, "-vsync", "passthrough", "-f", "rawvideo",
                               "-pix_fmt", pixels, "-sws_flags", "accurate_rnd+full_chroma_int", "-"],
                              check=True, capture_output=True).stdout

    def sound(self, film, kind="f32le"):
        """Interleaved samples of both channels."""
        raw = subprocess.run(["ffmpeg", "-v", "error", "-i", film, "-map", "0:a", "-f", kind, "-ac", "2", "-"],
                             check=True, capture_output=True).stdout
        samples = array.array("f" if kind == "f32le" else "i")
        samples.frombytes(raw)
        return samples

    def wav(self, name, seconds, wave_at):
        with wave.open(str(self.folder / name), "wb") as sound:
            sound.setparams((2, 2, RATE, 0, "NONE", ""))
            sound.writeframes(b"".join(struct.pack("<hh", round(32767 * wave_at(i)), round(32767 * wave_at(i + 29)))
                                       for i in range(round(seconds * RATE))))
        return self.folder / name


class Codecs(FilmTest):
    def test_each_codec_stores_what_its_name_says(self):
        look = self.look("moving", "color = vec4(uv.x, uv.y, fract(u_time), 1.0);")
        for name, options, codec, pixels in (
                ("a.mp4", (), "h264", "yuv420p"), ("a.mov", (), "h264", "yuv420p"), ("a.mkv", (), "h264", "yuv420p"),
                ("b.mp4", ("--codec", "h265"), "hevc", "yuv420p10le"),
                ("c.mp4", ("--codec", "av1"), "av1", "yuv420p10le"),
                ("d.mov", ("--codec", "prores"), "prores", "yuv444p12le"),  # the decoder's pixels
                ("e.mkv", ("--codec", "ffv1"), "ffv1", "bgr0"), ("f.webm", (), "vp9", "yuv420p"),
                ("i.mkv", ("--codec", "h265"), "hevc", "yuv420p10le"), ("j.mkv", ("--codec", "vp9"), "vp9", "yuv420p"),
                ("g.webm", ("--codec", "av1", "--quality", "50"), "av1", "yuv420p10le"), ("h.gif", (), "gif", "bgra")):
            film = self.film(name, look, "--size", "97x65", "--fps", "25", "--seconds", "0.2", *options)
            picture = self.stream(film)
            self.assertEqual((picture["codec_name"], picture["pix_fmt"], picture["nb_read_frames"]),
                             (codec, pixels, "5"), name)
            if codec not in ("ffv1", "gif"):
                self.assertEqual([picture.get(f"color_{of}") for of in ("space", "primaries", "transfer", "range")],
                                 ["bt709", "bt709", "bt709", "tv"], name)
            middle = self.decoded(film, "rgb24")
            width, height = picture["width"], picture["height"]
            at = 3 * (width * 32 + 48)
            for is_, expected in zip(middle[at:at + 3], (128, 128, 10)):
                self.assertAlmostEqual(is_, expected, delta=10, msg=name)
            self.assertEqual(len(middle), 5 * 3 * width * height)

    def test_ffv1_is_the_pictures_bit_for_bit(self):
        look = self.look("noise", "color = vec4(fract(sin(dot(uv, vec2(12.9898, 78.233)) + u_time + vec3(0, 1, 2)) * 43758.5453), 1.0);")
        size = ("--size", "61x37", "--frames", "4")
        film = self.film("film.mkv", look, *size, "--codec", "ffv1")
        self.film("f%d.png", look, *size)
        pictures = b"".join(bytes(row) for i in range(4) for row in read_png(self.folder / f"f{i}.png")[2])
        self.assertEqual(self.decoded(film, "rgb24"), pictures)

    def test_ten_bits_have_more_levels_than_eight(self):
        look = self.look("ramp", "color = vec4(vec3(0.25 + 0.25 * uv.x), 1.0);")
        for codec, least, most in (("h264", 40, 70), ("h265", 160, 280)):
            film = self.film("ramp.mp4", look, "--size", "1024x64", "--frames", "1", "--codec", codec, "--quality", "4")
            luma = self.decoded(film, "gray16le")
            levels = len({luma[2 * i:2 * i + 2] for i in range(1024)})
            self.assertTrue(least < levels < most, (codec, levels))

    def test_quality_changes_the_size(self):
        look = self.look("noise", "color = vec4(fract(sin(dot(uv, vec2(12.9898, 78.233)) + u_time) * 43758.5453));")
        sizes = [self.film(f"q{quality}.mp4", look, "--size", "128x96", "--frames", "6", "--quality", quality)
                 .stat().st_size for quality in (10, 45)]
        self.assertGreater(sizes[0], 3 * sizes[1])

    def test_what_does_not_fit_is_wrong_usage_and_names_what_does(self):
        look = self.look("plain", "color = vec4(0.5);")
        for options, words in (
                (("-o", "a.mp4", "--codec", "ffv1"), "'.mp4' can't hold FFV1 (lossless). Use .mkv."),
                (("-o", "a.mp4", "--audio-codec", "flac"), "'.mp4' can't hold FLAC (lossless). Use .mkv."),
                (("-o", "a.webm", "--codec", "h264"), "'.webm' can't hold H.264. Use .mp4, .mov or .mkv."),
                (("-o", "a.mp4", "--alpha"), "has no transparency. Use .mov (ProRes 4444)"),
                (("-o", "a.mp4", "--codec", "h26"), "unknown codec 'h26' (did you mean 'h264'?)"),
                (("-o", "a.gif", "--loop", "--fps", "100"), "a GIF holds at most 50 frames per second"),
                (("-o", "a.mp4", "--quality", "99"), "the quality of H.264 is 1 to 51"),
                (("-o", "a.png", "--codec", "h264"), "need a video file"),
                (("-o", "a.png", "--alpha"), "--alpha needs a video file or numbered PNG files"),
                (("-o", "a.png", "--loop"), "--loop needs a video file"),
                (("-o", "a.mp4", "--loop", "--start", "1"), "leave out --start"),
                (("-o", "a.mp4", "--size", "8000p"), "Named sizes: 720p")):
            self.assert_refused(run("render", look, *options, cwd=self.folder), words, code=2)
        self.assert_refused(run("render", look, "--size", "32x32", "--codec", "av1", "-o", self.folder / "a.mp4"),
                            "AV1 (10 bit) needs at least 64 x 64 px")
        self.assertEqual([file.name for file in self.folder.iterdir() if file.is_file()], [])

    def test_a_size_has_a_name(self):
        film = self.film("tall.mp4", self.look("plain", "color = vec4(0.5);"), "--size", "portrait", "--frames", "1")
        picture = self.stream(film)
        self.assertEqual((picture["width"], picture["height"]), (1080, 1920))


def pq_signal(nits):
    """ITU-R BT.2100, table 4."""
    power = (nits / 10000.0) ** (2610.0 / 16384.0)
    return ((3424.0 / 4096.0 + 2413.0 / 128.0 * power) / (1.0 + 2392.0 / 128.0 * power)) ** (2523.0 / 32.0)


def hlg_signal(nits, peak):
    """Grey. ITU-R BT.2100, table 5: OETF after the inverse OOTF."""
    gamma = 1.2 + 0.42 * math.log10(peak / 1000.0)
    scene = (nits / peak) ** (1.0 / gamma)
    a, b, c = 0.17883277, 0.28466892, 0.55991073
    return math.sqrt(3.0 * scene) if scene <= 1.0 / 12.0 else a * math.log(12.0 * scene - b) + c


class Hdr(FilmTest):
    PATCHES = (100.0, 203.0, 1000.0)  # cd/m2

    def patches(self, **more):
        """A look with three patches from left to right, for a paper white of 203 cd/m2."""
        self.write("patches/look.json", json.dumps(
            {"format": "afterglow-look", "version": 1, "name": "patches", "driven_by": "nothing", "output": "linear",
             "passes": [{"name": "show", "fragment": "show.frag", "format": "rgba32f"}], **more}))
        self.write("patches/show.frag", "#version 410 core\nuniform float u_peak;\nin vec2 uv;\nout vec4 color;\n"
                   "void main() { float nits[] = float[](100.0, 203.0, 1000.0);\n"
                   "color = vec4(vec3(min(nits[int(3.0 * uv.x)] / 203.0, u_peak)), 1.0); }\n")
        return self.folder / "patches"

    def codes(self, film):
        """The 10-bit codes of luma and both chroma in the middle of each patch."""
        raw = subprocess.run(["ffmpeg", "-v", "error", "-i", film, "-frames:v", "1", "-f", "rawvideo", "-pix_fmt",
                              "yuv444p10le", "-"], check=True, capture_output=True).stdout
        words = array.array("H", raw)
        return [[words[plane * 96 * 64 + 32 * 96 + x] for plane in range(3)] for x in (16, 48, 80)]

    def test_patches_have_the_codes_of_bt2100(self):
        look = self.patches()
        for name, hdr, transfer, signal in (("a.mp4", "hdr10", "smpte2084", pq_signal),
                                            ("b.mp4", "hlg", "arib-std-b67", lambda nits: hlg_signal(nits, 1000.0)),
                                            ("c.mov", "hdr10", "smpte2084", pq_signal)):
            codec = ("--codec", "prores") if name.endswith(".mov") else ()
            film = self.film(name, look, "--size", "96x64", "--frames", "1", "--hdr", hdr, *codec)
            told = self.stream(film)
            self.assertEqual([told.get(f"color_{of}") for of in ("space", "primaries", "transfer", "range")],
                             ["bt2020nc", "bt2020", transfer, "tv"], name)
            self.assertIn("p12le" if name.endswith(".mov") else "p10le", told["pix_fmt"])
            for nits, (luma, blue, red) in zip(self.PATCHES, self.codes(film)):
                self.assertAlmostEqual(luma, 64 + 876 * signal(nits), delta=2, msg=(name, nits))
                self.assertAlmostEqual(blue, 512, delta=1)
                self.assertAlmostEqual(red, 512, delta=1)

    def test_paper_white_and_peak_are_settings_and_metadata(self):
        film = self.film("film.mp4", self.patches(), "--size", "96x64", "--frames", "1", "--hdr", "hdr10",
                         "--paper-white", "100", "--peak", "400")
        expected = [64 + 876 * pq_signal(nits) for nits in (100.0 * 100.0 / 203.0, 100.0, 400.0)]
        for (luma, _, _), code in zip(self.codes(film), expected):
            self.assertAlmostEqual(luma, code, delta=2)
        told = subprocess.run(["ffprobe", "-v", "error", "-show_frames", "-read_intervals", "%+#1", "-of", "json", film],
                              check=True, capture_output=True, text=True).stdout
        display = next(data for data in json.loads(told)["frames"][0]["side_data_list"] if "max_luminance" in data)
        self.assertEqual(display["max_luminance"], "4000000/10000")

    def test_a_look_is_told_the_peak_and_without_hdr_white(self):
        look = self.look("peak", "color = vec4(vec3(0.1 * u_peak), 1.0);")
        shader = look / "show.frag"
        shader.write_text(shader.read_text().replace("uniform float u_time;", "uniform float u_peak;"))
        size = ("--size", "96x64", "--frames", "1")
        for options, display in (((), 0.1), (("--hdr", "hdr10", "--paper-white", "200", "--peak", "800"), 0.4)):
            luma = self.codes(self.film("film.mp4", look, *size, "--codec", "h265", *options))[1][0]
            light = 200.0 * ((display + 0.055) / 1.055) ** 2.4
            self.assertAlmostEqual(luma, 64 + 876 * (pq_signal(light) if options else display), delta=2)

    def test_what_has_no_hdr_is_wrong_usage(self):
        look = self.patches()
        for options, words in (
                (("-o", "a.mp4", "--hdr", "hdr10", "--codec", "h264"), "has only 8 bits, but HDR needs 10"),
                (("-o", "a.png", "--hdr", "hdr10"), "--hdr needs a video file"),
                (("-o", "a.mov", "--hdr", "hlg", "--codec", "prores", "--alpha"), "HDR videos have no transparency"),
                (("-o", "a.mp4", "--peak", "400"), "--paper-white and --peak need --hdr"),
                (("-o", "a.mp4", "--hdr", "hdr10", "--peak", "100"), "--peak must not be below --paper-white")):
            self.assert_refused(run("render", look, *options, cwd=self.folder), words, code=2)


class Alpha(FilmTest):
    def test_a_look_without_alpha_is_transparent_where_it_is_black(self):
        # Left: black. Right: half red over nothing, so full red with half alpha.
        look = self.look("half", "color = vec4(uv.x < 0.5 ? 0.0 : 0.5, 0.0, 0.0, 1.0);")
        for name, options in (("a.mov", ()), ("b.mkv", ()), ("c.webm", ("-c:v", "libvpx-vp9"))):
            film = self.film(name, look, "--size", "64x64", "--frames", "2", "--alpha")
            pixels = self.decoded(film, "rgba", *options)[:64 * 64 * 4]
            left, right = 4 * (64 * 32 + 10), 4 * (64 * 32 + 50)
            self.assertAlmostEqual(pixels[left + 3], 0, delta=2, msg=name)
            for is_, expected in zip(pixels[right:right + 4], (255, 0, 0, 128)):
                self.assertAlmostEqual(is_, expected, delta=6, msg=name)
        self.film("f%d.png", look, "--size", "4x1", "--frames", "2", "--alpha")
        self.assertEqual(list(self.decoded(self.folder / "f1.png", "rgba")), [0, 0, 0, 0] * 2 + [255, 0, 0, 128] * 2)

    def test_the_alpha_of_a_shader_is_kept(self):
        self.write("clear.fs", """/*{ "ISFVSN": "2" }*/
            void main() { gl_FragColor = vec4(0.2, 0.6, 1.0, isf_FragNormCoord.x < 0.5 ? 0.25 : 1.0); }""")
        film = self.film("a.mkv", self.folder / "clear.fs", "--size", "64x64", "--frames", "2", "--alpha")
        pixels = self.decoded(film, "rgba")
        self.assertEqual(tuple(pixels[4 * 10:4 * 11]), (51, 153, 255, 64))
        self.assertEqual(tuple(pixels[4 * 50:4 * 51]), (51, 153, 255, 255))


class Videos(FilmTest):
    def test_a_video_keeps_its_length_and_its_sound(self):
        source = self.folder / "source.mkv"
        tone = "aevalsrc='0.5*sin(2*PI*1000*t)*between(t,0.3,0.4)':s=48000:d=0.6"  # from 0.3 to 0.4 s
        subprocess.run(["ffmpeg", "-v", "error", "-f", "lavfi", "-i", "testsrc=size=32x24:rate=25:duration=0.6", "-f",
                        "lavfi", "-i", tone, "-c:v", "ffv1", "-c:a", "flac", source], check=True)
        for options, start in (((), 0.0), (("--start", "0.2"), 0.2)):
            film = self.film("film.mkv", "crt", "--source", source, "--size", "32x24", *options)
            self.assertEqual(int(self.stream(film)["nb_read_frames"]), round((0.6 - start) * 60))
            left = self.sound(film)[::2]
            self.assertAlmostEqual(len(left) / RATE, 0.6 - start, delta=0.001)
            heard = [index for index, value in enumerate(left) if abs(value) > 0.05]
            self.assertAlmostEqual(heard[0] / RATE, 0.3 - start, delta=0.001)
            self.assertAlmostEqual(heard[-1] / RATE, 0.4 - start, delta=0.001)
        silent = self.film("silent.mkv", "crt", "--source", f"{source},rate=5", "--size", "32x24", "--seconds", "0.1")
        kinds = subprocess.run(["ffprobe", "-v", "error", "-show_entries", "stream=codec_type", "-of", "csv=p=0", silent],
                               check=True, capture_output=True, text=True).stdout.split()
        self.assertEqual(kinds, ["video"])
        self.assert_refused(run("render", "crt", "--source", source, "--start", "0.7", "-o", self.folder / "x.mp4"),
                            "the video ends at 0.6 s")


class Sound(FilmTest):
    def test_lossless_sound_is_the_file_bit_for_bit(self):
        tone = self.wav("tone.wav", 0.5, lambda i: 0.7 * math.sin(i * 0.05) + 0.2 * math.sin(i * 1.7))
        with wave.open(str(tone)) as sound:
            source = array.array("h")
            source.frombytes(sound.readframes(RATE))
        scope = ("vector-beam", "--size", "128x128", "--signal", f"audio:{tone},mode=xy")
        for name, options, codec in (("a.mov", (), "pcm_f32le"), ("a.mkv", (), "flac"),
                                     ("b.mkv", ("--audio-codec", "pcm"), "pcm_f32le")):
            film = self.film(name, *scope, *options)
            self.assertEqual(self.stream(film, "a")["codec_name"], codec)
            self.assertEqual(list(self.sound(film, "s32le")), [sample * 65536 for sample in source], name)
        film = self.film("part.mkv", *scope, "--start", "0.25")
        self.assertEqual(list(self.sound(film, "s32le")), [sample * 65536 for sample in source[RATE // 2:]])

    def test_aac_does_not_click_when_a_sound_starts_at_once(self):
        for name, tone in (("low", lambda i: 0.73 * math.cos(i * 2 * math.pi * 110 / RATE)),
                           ("high", lambda i: 0.73 * math.cos(i * 2 * math.pi * 1000 / RATE)),
                           ("chord", lambda i: sum(0.18 * math.cos(i * 2 * math.pi * f / RATE) for f in (220, 277.2, 330, 440)))):
            sound = self.wav(f"{name}.wav", 1.0, tone)
            for ending in ("mp4", "mov"):
                film = self.film(f"{name}.{ending}", "vector-beam", "--size", "128x128", "--signal", f"audio:{sound},mode=xy",
                                 "--audio-codec", "aac")
                samples = self.sound(film)
                start = 2 * RATE // 20
                first = max(map(abs, samples[:start]))
                later = max(map(abs, samples[start:2 * RATE]))
                self.assertLess(20 * math.log10(first / later), 0.1, film.name)
                self.assertAlmostEqual(float(self.stream(film)["start_time"]), 0.0, delta=0.001)
                self.assertAlmostEqual(samples[0], tone(0), delta=0.08)

    def test_aac_warns_that_it_distorts_an_xy_figure(self):
        sound = self.wav("tone.wav", 0.2, lambda i: 0.5 * math.sin(i * 0.1))
        scope = ("render", "vector-beam", "--size", "128x128", "--signal")
        done = run(*scope, f"audio:{sound},mode=xy", "-o", self.folder / "a.mp4")
        self.assert_done(done)
        self.assertIn("warning: AAC changes the sound. An oscilloscope that plays this film draws a distorted figure. Use .mov or .mkv", done.stderr)
        for signal, name, more in ((f"audio:{sound},mode=waveform", "b.mp4", ()), (f"audio:{sound},mode=xy", "c.mkv", ()),
                                   (f"audio:{sound},mode=xy", "d.mp4", ("--audio-codec", "none"))):
            self.assertNotIn("distorts", run(*scope, signal, *more, "-o", self.folder / name).stderr)


class Loops(FilmTest):
    def frames(self, look, *arguments):
        done = run("render", look, *arguments, "--codec", "ffv1", "--loop", "-o", self.folder / "loop.mkv")
        self.assert_done(done)
        return int(self.stream(self.folder / "loop.mkv")["nb_read_frames"])

    def test_a_scope_loops_after_the_period_of_its_signal(self):
        for signal, fps, frames in (("lissajous:x=3,y=2,speed=0.5", "25", 50), ("lissajous:x=3,y=2", "60", 1),
                                    ("text:HI,size=0.2,spin=180", "20", 40)):
            self.assertEqual(self.frames("phosphor", "--size", "96x64", "--signal", signal, "--fps", fps), frames)
        # The first frame follows the last one: twice the period has the same pictures twice.
        self.film("twice_%03d.png", "phosphor", "--size", "96x64", "--signal", "text:HI,size=0.2,spin=180", "--fps", "20",
                  "--start", "60", "--seconds", "4")
        first = [read_png(self.folder / f"twice_{1200 + i:03d}.png")[2] for i in range(80)]
        for i in range(40):
            for row, later in zip(first[i], first[i + 40]):
                self.assertLessEqual(max(abs(a - b) for a, b in zip(row, later)), 1)

    def test_a_shader_loops_after_the_period_of_its_time(self):
        look = self.look("turning", "color = vec4(0.5 + 0.5 * sin(6.283185307 * (u_time / 0.8 + uv.x)), uv.y, 0.3, 1.0);")
        self.assertEqual(self.frames(look, "--size", "64x48", "--fps", "25"), 20)
        self.assertEqual(self.frames(look, "--size", "64x48", "--fps", "25", "--seconds", "1.6"), 40)

    def test_the_frame_after_the_last_is_the_first(self):
        # Light that needs 600 frames to come within 1/255 of its end.
        slow = self.look("slow", "vec3 light = vec3(uv.x < 0.5 + 0.4 * sin(6.283185307 * u_time) ? 0.01 : 0.0);"
                         " color = vec4(texture(previous, uv).rgb * 0.99 + light, 1.0);",
                         inputs={"previous": "show@1"})
        self.assertEqual(self.frames(slow, "--size", "96x64", "--fps", "30"), 30)
        loop = self.decoded(self.folder / "loop.mkv", "rgb24")
        size = 3 * 96 * 64
        first, second, last = loop[:size], loop[size:2 * size], loop[-size:]
        def step(a, b):
            return max(abs(x - y) for x, y in zip(a, b))
        self.assertLessEqual(step(last, first), step(first, second) + 1)

    def test_a_rate_that_does_not_fit_is_refused_with_those_that_do(self):
        refused = run("render", "phosphor", "--size", "64x48", "--signal", "lissajous:x=3,y=2,speed=0.3", "--fps", "25",
                      "--loop", "-o", self.folder / "a.gif")
        self.assert_refused(refused, "repeats after 3.33333 s, which is not a whole number of frames at 25 fps",
                            "Frame rates that fit: 24, 30, 48, 60, 120")

    def test_what_never_repeats_is_refused(self):
        noise = self.look("noise", "color = vec4(fract(sin(dot(uv, vec2(12.9898, 78.233)) + u_time * u_time) * 43758.5453));")
        for look, signal, words in (("phosphor", "waveform:ch1=noise", "can't loop: noise never repeats"),
                                    (noise, None, "does not repeat within 120 s")):
            more = ("--signal", signal) if signal else ()
            self.assert_refused(run("render", look, *more, "--size", "16x16", "--fps", "10", "--loop",
                                    "-o", self.folder / "a.gif"), words)
        self.assertFalse((self.folder / "a.gif").exists())


class Encoders(FilmTest):
    """What ffmpeg may do wrong, by a program of that name."""

    def fake(self, text):
        folder = self.folder / "bin"
        folder.mkdir(exist_ok=True)
        self.write("bin/ffmpeg", "#!/bin/sh\n" + text)
        (folder / "ffmpeg").chmod(0o755)
        return f"{folder}:{os.environ['PATH']}"

    def test_an_encoder_that_dies_is_reported_with_its_reason(self):
        look = self.look("plain", "color = vec4(0.5);")
        for text, words in (("kill -9 $$", "ffmpeg: stopped by signal 9 (Killed), possibly out of memory"),
                            ("echo 'Unknown encoder' >&2; exit 1", "ffmpeg: Unknown encoder"),
                            ("exit 4", "ffmpeg: exited with status 4")):
            done = run("render", look, "--size", "64x64", "--frames", "100", "-o", self.folder / "a.mp4", PATH=self.fake(text))
            self.assert_refused(done, "a.mp4: error: can't write the video: " + words)
            self.assertEqual([file.name for file in self.folder.iterdir() if file.is_file()], [])


if __name__ == "__main__":
    main()
