"""The command line as used by scripts."""

import json
import math
import os
import subprocess
import wave

from program import PROGRAM, ProgramTest, main, read_png, run

SMALL = ("--size", "96x64", "--frames", "4")


class Listing(ProgramTest):
    def test_everything_can_be_listed_as_text_and_json(self):
        for what, one in (("looks", "phosphor"), ("presets", "article"), ("signals", "lissajous"),
                          ("patterns", "smpte")):
            result = run("list", what)
            self.assert_done(result)
            self.assertIn(one, result.stdout)
            entries = json.loads(run("list", what, "--json").stdout)
            self.assertIn(one, [entry["id"] for entry in entries])

    def test_help_names_every_command(self):
        result = run("--help")
        self.assert_done(result)
        for command in ("list", "render", "check", "describe", "preset", "compare", "bench", "sheet", "sweep", "signal",
                        "impulse", "corpus", "export", "golden", "pack", "gallery", "thumbnail"):
            self.assertIn(command, result.stdout)


class Rendering(ProgramTest):
    def test_the_same_command_gives_the_same_bytes(self):
        for name in ("a.png", "b.png"):
            self.assert_done(run("render", "phosphor", *SMALL, "-o", self.folder / name))
        self.assertEqual((self.folder / "a.png").read_bytes(), (self.folder / "b.png").read_bytes())

    def test_a_picture_has_the_asked_size_and_shows_a_trace(self):
        self.assert_done(run("render", "phosphor", *SMALL, "-o", self.folder / "a.png"))
        width, height, rows = read_png(self.folder / "a.png")
        self.assertEqual((width, height), (96, 64))
        self.assertGreater(max(max(row) for row in rows), 100)

    def test_a_sequence_is_numbered_from_0000_and_moves(self):
        self.assert_done(run("render", "phosphor", *SMALL, "-o", self.folder / "f_%04d.png"))
        names = sorted(file.name for file in self.folder.iterdir())
        self.assertEqual(names, [f"f_{n:04d}.png" for n in range(4)])
        self.assertNotEqual((self.folder / names[0]).read_bytes(), (self.folder / names[3]).read_bytes())

    def test_a_frame_of_a_sequence_is_the_frame_asked_for_alone(self):
        self.assert_done(run("render", "phosphor", *SMALL, "-o", self.folder / "f_%d.exr"))
        self.assert_done(run("render", "phosphor", "--size", "96x64", "--frames", "3", "-o", self.folder / "x.exr"))
        self.assert_done(run("compare", self.folder / "f_2.exr", self.folder / "x.exr", "--fail-above", "max=0"))

    def test_a_parameter_changes_the_picture(self):
        self.assert_done(run("render", "phosphor", *SMALL, "-o", self.folder / "a.png"))
        self.assert_done(run("render", "phosphor", *SMALL, "--set", "exposure=6", "-o", self.folder / "b.png"))
        self.assert_refused(run("compare", self.folder / "a.png", self.folder / "b.png", "--fail-above", "mean=0.001"))

    def test_moves_turn_parameters_over_time_at_any_rate(self):
        self.write("plain/look.json", json.dumps(
            {"format": "afterglow-look", "version": 1, "name": "Plain", "driven_by": "nothing",
             "passes": [{"name": "show", "fragment": "show.frag", "format": "rgba32f"}]}))
        self.write("plain/show.frag", "#version 410 core\nuniform float gray = 0.2;  // @range 0 1\n"
                   "out vec4 color;\nvoid main() { color = vec4(vec3(gray), 1.0); }\n")
        moves = self.write("moves.txt", "# a comment\n0.05 gray 0.4\n0.1 gray 0.5\n\n0.1 gray 0.6\n9 gray 1\n")
        for fps in (20, 60):
            frames = self.folder / f"{fps}_%04d.png"
            self.assert_done(run("render", self.folder / "plain", "-o", frames, "--fps", fps, "--frames",
                                 fps * 3 // 20, "--size", "4x4", "--moves", moves))
            for frame in range(fps * 3 // 20):
                seconds = (frame + 1) / fps
                expected = 0.6 if seconds >= 0.1 else 0.4 if seconds >= 0.05 else 0.2
                _, _, rows = read_png(str(frames) % frame)
                self.assertEqual(rows[0][0], round(255 * expected), f"{fps} Hz, frame {frame}")
        self.write("moves.txt", "0 gray 0.5\n1 grey 2\n2 gray much\n")
        self.assert_refused(run("render", self.folder / "plain", "-o", self.folder / "x.png", "--moves", moves),
                            f"{moves}:2: error: ", "did you mean 'gray'", f"{moves}:3: error: ")
        self.assertFalse((self.folder / "x.png").exists())

    def test_a_pass_and_all_passes_can_be_had(self):
        self.assert_done(run("render", "phosphor", *SMALL, "--pass", "persistence", "--all-passes",
                             self.folder / "all", "-o", self.folder / "p.exr"))
        files = sorted(file.name for file in (self.folder / "all").iterdir())
        self.assertEqual(files[0], "00_beam.exr")
        same = next(name for name in files if name.endswith("_persistence.exr"))
        self.assert_done(run("compare", self.folder / "all" / same, self.folder / "p.exr", "--fail-above", "max=0"))

    def test_a_size_follows_the_parameter_that_it_is_told_by(self):
        self.write("look.json", """{ "format": "afterglow-look", "version": 1, "name": "Blocks", "driven_by": "signal", "passes": [
            { "name": "blocks", "fragment": "a.frag", "size": ["$blocks", "$HEIGHT"] },
            { "name": "shown", "fragment": "b.frag", "inputs": { "image": "blocks" } }]}""")
        self.write("a.frag", """#version 410 core
            uniform float blocks = 4.0;  // @range 1 16
            out vec4 color;
            void main() { color = vec4(blocks / 16.0); }""")
        self.write("b.frag", """#version 410 core
            uniform sampler2D image;
            out vec4 color;
            void main() { color = vec4(float(textureSize(image, 0).x) / 16.0); }""")
        self.assert_done(run("render", self.folder, "--size", "8x8", "--set", "blocks=12", "-o", self.folder / "a.png"))
        self.assertEqual(read_png(self.folder / "a.png")[2][0][0], round(255 * 12 / 16))

    def test_a_sound_file_draws(self):
        sound = self.folder / "tone.wav"
        with wave.open(str(sound), "wb") as file:
            file.setnchannels(2)
            file.setsampwidth(2)
            file.setframerate(48000)
            file.writeframes(b"".join((20000 * (n % 100 < 50)).to_bytes(2, "little", signed=True) * 2
                                      for n in range(4800)))
        self.assert_done(run("render", "phosphor", *SMALL, "--signal", f"audio:{sound},mode=xy", "-o",
                             self.folder / "a.png"))
        self.assertGreater(max(max(row) for row in read_png(self.folder / "a.png")[2]), 100)

    def test_a_number_that_is_not_finite_is_clamped_and_told_once(self):
        self.write("wrong/look.json", json.dumps({
            "format": "afterglow-look", "version": 1, "name": "Wrong", "driven_by": "nothing",
            "passes": [
                {"name": "glow", "fragment": "glow.frag", "inputs": {"previous": "glow@1"}},
                {"name": "shown", "fragment": "shown.frag", "inputs": {"image": "glow"}}]}, indent=1))
        self.write("wrong/glow.frag", "#version 410 core\nuniform sampler2D previous;\n"
                   "uniform float none = 0.0;\nuniform int u_frame;\nin vec2 uv;\nout vec4 color;\n"
                   "void main() {\n    bool is_bad = u_frame == 3 && ivec2(gl_FragCoord.xy) == ivec2(4, 1);\n"
                   "    color = is_bad ? vec4(none / none) : texture(previous, uv) * 0.5 + 0.25;\n}\n")
        self.write("wrong/shown.frag", "#version 410 core\nuniform sampler2D image;\nin vec2 uv;\nout vec4 color;\n"
                   "void main() { color = texture(image, uv); }\n")
        for frames in (2, 3, 5):
            done = run("render", self.folder / "wrong", "--size", "16x8", "--frames", str(frames), "-o",
                       self.folder / f"{frames}.png")
            self.assert_done(done)
            told = [line for line in done.stderr.splitlines() if "NaN/Inf" in line]
            self.assertEqual(len(told), 0 if frames < 3 else 1, done.stderr)
            for line in told:
                self.assertIn("look.json:", line)
                self.assertIn("warning: pass 'glow'", line)
                self.assertIn("pixel (4, 6), frame 3", line)
        # 0 in frame 3, so 1/4 in frame 4 and 3/8 in frame 5
        _, _, rows = read_png(self.folder / "5.png")
        self.assertEqual(rows[6][4 * 3], round(255 * 3 / 8))

    def test_a_run_of_frames_that_flashes_too_often_is_told_once(self):
        self.write("flash/look.json", json.dumps({
            "format": "afterglow-look", "version": 1, "name": "Flash", "driven_by": "nothing",
            "passes": [{"name": "shown", "fragment": "shown.frag"}]}))
        self.write("flash/shown.frag", "#version 410 core\nuniform int period = 10;  // @range 2 60\n"
                   "uniform int u_frame;\nin vec2 uv;\nout vec4 color;\n"
                   "void main() { color = vec4(vec3(u_frame % period * 2 < period ? 0.0 : 1.0), 1.0); }\n")
        for period, told in ((20, 0), (10, 1)):
            done = run("render", self.folder / "flash", "--set", f"period={period}", "--size", "96x72",
                       "--frames", "60", "-o", self.folder / "f_%04d.png")
            self.assert_done(done)
            lines = [line for line in done.stderr.splitlines() if "flashes up to" in line]
            self.assertEqual(len(lines), told, done.stderr)
            for line in lines:
                self.assertIn("warning: the picture flashes up to 6 times a second (0 in red)", line)
        done = run("render", self.folder / "flash", "--size", "96x72", "--frames", "60", "-o", self.folder / "f.png")
        self.assertNotIn("flashes", done.stderr)  # a single picture does not flash

    def test_a_flash_falls_as_the_look_says(self):
        self.write("glow/look.json", json.dumps({
            "format": "afterglow-look", "version": 1, "name": "Glow", "driven_by": "picture",
            "default_source": "pattern:smpte", "output": "linear",
            "passes": [{"name": "glow", "fragment": "glow.frag", "format": "rgba32f",
                        "inputs": {"image": "source", "previous": "glow@1"}},
                       {"name": "shown", "fragment": "shown.frag", "format": "rgba32f", "inputs": {"image": "glow"}}]}))
        self.write("glow/glow.frag", "#version 410 core\nuniform sampler2D image, previous;\n"
                   "uniform float decay = 0.9;  // @range 0 1\nuniform float u_time_delta;\nin vec2 uv;\nout vec4 color;\n"
                   "void main() { color = texture(image, uv) + texture(previous, uv) * pow(decay, 60.0 * u_time_delta); }\n")
        self.write("glow/shown.frag", "#version 410 core\nuniform sampler2D image;\nin vec2 uv;\nout vec4 color;\n"
                   "void main() { color = 0.25 + 3.0 * texture(image, uv); }\n")
        for fps in (24, 60):
            done = run("impulse", self.folder / "glow", "--size", "32x18", "--fps", str(fps), "--json")
            self.assert_done(done)
            glow, shown = json.loads(done.stdout)["passes"]
            rate = -60 * math.log(0.9)  # per second
            for told, peak in ((glow, 1.0), (shown, 3.0)):
                self.assertAlmostEqual(told["peak"], peak, places=4)
                self.assertAlmostEqual(told["half_life_seconds"], math.log(2) / rate, places=4)
                for share, key in ((10, "10"), (100, "1"), (1000, "0.1")):
                    self.assertAlmostEqual(told[f"seconds_to_{key}_percent"], math.log(share) / rate, places=3)
        self.assertIn("Half-life\n", run("impulse", self.folder / "glow", "--size", "32x18").stdout)
        done = run("impulse", self.folder / "glow", "--at", "2,0")
        self.assertEqual(done.returncode, 2)
        self.assertIn("--at: expected X,Y from 0 to 1, got '2,0'", done.stderr)

    def test_a_sheet_shows_every_preset_of_a_look(self):
        self.write("data/shaders/plain/look.json", json.dumps({
            "format": "afterglow-look", "version": 1, "name": "Plain", "driven_by": "nothing",
            "passes": [{"name": "picture", "fragment": "plain.frag"}]}))
        self.write("data/shaders/plain/plain.frag", "#version 410 core\nuniform float grey = 0.0;\nout vec4 color;\n"
                   "void main() { color = vec4(vec3(grey), 1.0); }\n")
        for name, grey in (("dark", 0.4), ("light", 0.8)):
            self.write(f"data/presets/plain/{name}.json", json.dumps({
                "format": "afterglow-preset", "version": 1, "look": "plain", "name": name, "values": {"grey": grey}}))
        sheet = self.folder / "sheet.png"
        self.assert_done(run("sheet", "plain", "--data", self.folder / "data", "--size", "48x27", "--columns", "1",
                             "-o", sheet))
        _, _, rows = read_png(sheet)
        greys = [max(row) for row in rows]
        self.assertEqual((greys.count(102), greys.count(204)), (27, 27))
        self.assertLess(greys.index(102), greys.index(204))
        self.assert_refused(run("sheet", "phosphor", "-o", self.folder / "sheet.gif"), "sheet.gif", ".png or .exr")

    def test_a_sweep_holds_the_pictures_that_render_draws(self):
        small = ("--size", "64x48", "--frames", "2")
        out = self.folder / "sweep.png"
        done = run("sweep", "phosphor", *small, "--vary", "exposure=0.5:8:2", "--vary", "decay=0.5,0.9", "-o", out)
        self.assertEqual(done.returncode, 0, done.stderr)
        sheet = read_png(out)[2]
        places = []
        for decay in ("0.5", "0.9"):
            for exposure in ("0.5", "8"):
                one = self.folder / "one.png"
                run("render", "phosphor", *small, "--set", f"exposure={exposure}", "--set", f"decay={decay}", "-o", one)
                places.append(self.place_in(sheet, read_png(one)[2]))
        self.assertEqual(places[0][1], places[1][1])  # the first parameter varies across
        self.assertLess(places[0][0], places[1][0])
        self.assertEqual(places[0][0], places[2][0])  # the second one varies down
        self.assertLess(places[0][1], places[2][1])
        for wrong in ("exposure", "exposure=1:2", "exposur=1:2:3", "decay=0:7:3", "beam_color=0:1:3"):
            self.assert_refused(run("sweep", "phosphor", "--vary", wrong, "-o", out), wrong.split("=")[0])

    def place_in(self, sheet, rows):
        """Position of a picture within a larger one; all bytes must be equal."""
        rows = [bytes(row) for row in rows]
        sheet, wide = [bytes(row) for row in sheet], len(rows[0])
        for top in range(len(sheet) - len(rows) + 1):
            for left in range(0, len(sheet[0]) - wide + 1, 3):
                if all(sheet[top + y][left:left + wide] == row for y, row in enumerate(rows)):
                    return left // 3, top
        raise AssertionError("the picture is not in the sheet")

    def test_mistakes_are_named(self):
        out = self.folder / "x.png"
        self.assert_refused(run("render", "fosphor", "-o", out), "did you mean 'phosphor'")
        self.assert_refused(run("render", "phosphor", "-o", out, "--set", "dacay=1"), "did you mean 'decay'")
        self.assert_refused(run("render", "phosphor", "-o", out, "--set", "decay=fast"), "decay")
        self.assert_refused(run("render", "phosphor", "-o", out, "--pass", "bloom"), "has no pass 'bloom'")
        self.assert_refused(run("render", "phosphor", "-o", out, "--signal", "lisajous"), "did you mean 'lissajous'")
        self.assert_refused(run("render", "phosphor", "-o", out, "--set", "decay=7", "--set", "tone_map=9"),
                            "'decay' must be between 0 and 1", "'tone_map' must be one of")
        for wrong in (("--size", "big"), ("--size", "0x5"), ("--fps", "0"), ("--fps", "nan"), ("--frames", "-1"),
                      ("--sett", "a=1"), ("--signal", "")):
            self.assert_refused(run("render", "phosphor", "-o", out, *wrong), code=2)
        for name in ("x", "x.avi", "x_%f.png", "x_%d_%d.png", "/dev/full"):
            self.assert_refused(run("render", "phosphor", "-o", name), name, code=2)
        (self.folder / "taken").write_text("")
        self.assert_refused(run("render", "phosphor", "-o", self.folder / "taken/x.png"), "taken")
        self.assert_refused(run("render", "phosphor"), code=2)
        self.assert_refused(run("rendr", "phosphor", "-o", out), code=2)
        self.assert_refused(run("rendr"), "did you mean 'render'", code=2)
        self.assertFalse(out.exists())


class Output(ProgramTest):
    def test_a_full_disk_is_told(self):
        if not os.path.exists("/dev/full"):
            self.skipTest("this system has no /dev/full")
        with open("/dev/full", "w", encoding="utf-8") as full:
            done = subprocess.run([PROGRAM, "list", "signals"], stdout=full, stderr=subprocess.PIPE, text=True, check=False)
        self.assert_refused(done, "can't write the output")


class Presets(ProgramTest):
    def test_a_preset_travels_as_file_line_and_picture(self):
        file, picture = self.folder / "mine.json", self.folder / "mine.png"
        self.assert_done(run("preset", "phosphor", "--set", "decay=0.97", "--set", "beam_color=1,0.5,0.25",
                             "--signal", "lissajous:x=5,y=4", "--name", "Mine", "-o", file))
        preset = json.loads(file.read_text())
        self.assertEqual(preset["values"], {"beam_color": [1, 0.5, 0.25], "decay": 0.97})
        self.assertEqual(preset["signal"]["x"], 5)
        self.assertEqual(list(preset["values"]), sorted(preset["values"]))

        line = run("preset", file, "--line").stdout.strip()
        self.assertTrue(line.startswith("afterglow:1:") and "\n" not in line)
        self.assert_done(run("render", file, *SMALL, "-o", picture))
        self.assert_done(run("render", "phosphor", *SMALL, "--set", "decay=0.97", "--set", "beam_color=1,0.5,0.25",
                             "--signal", "lissajous:x=5,y=4", "-o", self.folder / "direct.exr"))
        for source in (file, line, picture):
            self.assert_done(run("render", source, *SMALL, "-o", self.folder / "again.exr"))
            self.assert_done(run("compare", self.folder / "again.exr", self.folder / "direct.exr",
                                 "--fail-above", "max=0"))

    def test_every_shipped_preset_opens_without_a_warning(self):
        files = [entry["file"] for entry in json.loads(run("list", "presets", "--json").stdout)]
        result = run("check", *files)
        self.assert_done(result)
        self.assertEqual(result.stderr, "")
        self.assertEqual(result.stdout.count(": good"), len(files))

    def test_values_of_parameters_that_are_gone_are_kept_and_told(self):
        file = self.write("old.json", json.dumps({"format": "afterglow-preset", "version": 1, "look": "phosphor",
                                                  "values": {"decay": 0.9, "dacay_red": 0.5}}))
        result = run("preset", file, "-o", self.folder / "new.json")
        self.assert_done(result)
        self.assertIn("dacay_red", result.stderr)
        self.assertEqual(json.loads((self.folder / "new.json").read_text())["values"]["dacay_red"], 0.5)


class Describing(ProgramTest):
    def test_the_frame_can_be_rebuilt_from_it(self):
        document = json.loads(run("describe", "phosphor", "--json", "--size", "640x360").stdout)
        passes = {one["name"]: one for one in document["passes"]}
        self.assertEqual(list(passes), ["beam", "segments", "excitation", "persistence", "reduced", "bloom_x", "bloom_down_1", "bloom_down_2", "bloom_down_3",
                                        "bloom_down_4", "bloom_down_5", "bloom_down_6", "bloom_up_5", "bloom_up_4", "bloom_up_3", "bloom_up_2", "bloom_up_1", "bloom_y", "composite"])
        self.assertEqual((passes["bloom_y"]["width"], passes["bloom_y"]["height"]), (320, 180))
        inputs = {one["name"]: one["from"] for one in passes["persistence"]["inputs"]}
        self.assertEqual((inputs["current"], inputs["previous"]), ("beam", "persistence@1"))
        names = {one["name"] for one in document["parameters"]}
        self.assertLessEqual({"decay", "bloom_intensity", "bloom_radius", "exposure", "aberration", "scanline_strength",
                              "scanline_period", "curvature", "vignette", "graticule", "beam_width", "beam_color",
                              "beam_gain", "ceiling"}, names)
        decay = next(one for one in document["parameters"] if one["name"] == "decay")
        self.assertEqual(decay["default"], 0.92)
        for key in ("label", "unit", "group", "help", "min", "max", "scale", "passes"):
            self.assertIn(key, decay)


class Comparing(ProgramTest):
    def ppm(self, name, *pixels):
        return self.write(name, b"P6 %d 1 255\n" % len(pixels) + bytes(v for pixel in pixels for v in pixel))

    def test_measures_follow_their_definitions(self):
        a = self.ppm("a.ppm", (0, 0, 0), (255, 255, 255))
        b = self.ppm("b.ppm", (51, 0, 0), (255, 255, 255))
        measured = json.loads(run("compare", a, b, "--json").stdout)
        self.assertAlmostEqual(measured["mean"], 0.2 / 6, places=6)
        self.assertAlmostEqual(measured["rms"], (0.04 / 6) ** 0.5, places=6)
        self.assertAlmostEqual(measured["max"], 0.2, places=6)
        self.assertAlmostEqual(measured["share"], 0.5, places=6)
        self.assertAlmostEqual(measured["psnr_db"], 21.7609, places=3)  # -10 log10(0.04 / 6)
        self.assert_done(run("compare", a, b, "--fail-above", "max=0.21"))
        self.assert_refused(run("compare", a, b, "--fail-above", "max=0.19"))
        self.assert_refused(run("compare", a, b, "--fail-above", "loud=1"), code=2)
        self.assert_refused(run("compare", a, b, "--tolerance", "nan"), code=2)

    def test_other_sizes_and_missing_files_are_not_good(self):
        a, b = self.ppm("a.ppm", (0, 0, 0)), self.ppm("b.ppm", (0, 0, 0), (0, 0, 0))
        self.assert_refused(run("compare", a, b), "sizes differ")
        self.assert_refused(run("compare", a, self.folder / "none.png"), "none.png")


class Measuring(ProgramTest):
    def test_bench_prints_what_a_frame_costs(self):
        result = run("bench", "phosphor", "--size", "160x90", "--frames", "5", "--json")
        self.assert_done(result)
        document = json.loads(result.stdout)
        self.assertGreater(document["frame"]["cpu_ms"], 0)
        self.assertEqual(len(document["passes"]), 19)
        self.assertEqual(document["draw_calls"], 16)  # only passes that the picture needs
        self.assertTrue(document["renderer"])
        generic = run("bench", "phosphor", "--size", "160x90", "--frames", "1", "--generic", "--json")
        self.assertEqual(json.loads(generic.stdout)["draw_calls"], 19)  # all passes

    def test_bench_tells_what_the_targets_take(self):
        # Custom tube: the light of this and of the previous frame. Measured tube: the beam, the
        # charge, and one target for the light and then the next charge. Both: the picture, and two
        # bloom targets at half the size.
        for tube, floats in (("Custom", 2), ("P31", 3)):
            result = run("bench", "phosphor", "--size", "160x90", "--frames", "1", "--json", "--set", f"tube={tube}",
                         "--set", "bloom_kind=Taps")
            self.assert_done(result)
            texels = 200  # at most, in bytes: placeholders of unused targets
            self.assertAlmostEqual(json.loads(result.stdout)["target_bytes"],
                                   160 * 90 * (16 * floats + 4) + 80 * 45 * 2 * 8, delta=texels)


class WithoutDisplay(ProgramTest):
    def test_the_window_says_what_it_found_and_renders_instead(self):
        result = run("crt", cwd=self.folder, XDG_STATE_HOME=self.folder)
        self.assert_done(result)
        self.assertIn("display", result.stderr.lower())
        width, height, _ = read_png(self.folder / "afterglow-crt.png")
        self.assertEqual((width, height), (1280, 720))
        self.assertIn("afterglow-crt.png", result.stdout)


class OtherPrograms(ProgramTest):
    """Looks of other programs on the command line."""

    SHADER = """#version 450
layout(push_constant) uniform Push { float level; uint FrameCount; } params;
layout(binding = 0, std140) uniform UBO { mat4 MVP; } global;
#pragma parameter level "Level" 0.2 0.0 1.0 0.1
#pragma stage vertex
layout(location = 0) in vec4 Position;
layout(location = 1) in vec2 TexCoord;
void main() { gl_Position = global.MVP * Position; }
#pragma stage fragment
layout(location = 0) out vec4 FragColor;
void main() { FragColor = vec4(params.level, 0.0, 0.0, 1.0); }
"""

    def red_of(self, *look):
        self.assert_done(run("render", *look, "-o", self.folder / "out.png", "--size", "4x4"))
        return read_png(self.folder / "out.png")[2][0][0]

    def test_a_slang_preset_is_drawn_and_its_parameter_kept_in_a_preset(self):
        self.write("red.slang", self.SHADER)
        chain = self.write("red.slangp", "shaders = 1\nshader0 = red.slang\nlevel = 0.4\n")
        self.assertEqual(self.red_of(chain), 102)
        self.assertEqual(self.red_of(self.folder / "red.slang"), 51)
        preset = self.folder / "presets" / "more.json"
        preset.parent.mkdir()
        state = {"XDG_STATE_HOME": self.folder / "state"}
        self.assert_done(run("preset", chain, "--set", "level=0.6", "-o", preset, **state))
        self.assertEqual(json.loads(preset.read_text())["look"], "red.slangp")
        self.assert_done(run("render", preset, "-o", self.folder / "out.png", "--size", "4x4", **state))
        self.assertEqual(read_png(self.folder / "out.png")[2][0][0], 153)
        (self.folder / "presets" / "red.slangp").write_text("shaders = 1\nshader0 = ../red.slang\n")
        self.assertEqual(self.red_of(preset), 153)  # also found in the folder of the preset

    ISF = """/*{"INPUTS": [{"NAME": "level", "TYPE": "float", "DEFAULT": 0.2},
 {"NAME": "tint", "TYPE": "color", "DEFAULT": [0.6, 0.0, 0.0, 1.0]},
 {"NAME": "tinted", "TYPE": "bool", "DEFAULT": false}]}*/
void main() { gl_FragColor = tinted ? tint : vec4(level, 0.0, 0.0, 1.0); }
"""

    def test_an_isf_shader_is_drawn_and_described_and_its_mistakes_are_told(self):
        shader = self.write("red.fs", self.ISF)
        self.assertEqual(self.red_of(shader), 51)
        self.assertEqual(self.red_of(shader, "--set", "level=0.4"), 102)
        self.assertEqual(self.red_of(shader, "--set", "tinted=true"), 153)
        result = run("describe", shader, "--json")
        self.assert_done(result)
        level, tint, _ = json.loads(result.stdout)["parameters"]
        self.assertEqual((level["type"], level["default"]), ("float", 0.2))
        self.assertEqual((tint["type"], tint["encoding"]), ("color", "display"))
        wrong = self.write("wrong.fs", self.ISF.replace("vec4(level", "vec5(level"))
        result = run("check", wrong)
        self.assertEqual(result.returncode, 1)
        self.assertIn("wrong.fs:4: error: ", result.stderr)

    def test_a_corpus_holds_isf_shaders_too(self):
        self.write("corpus/good.fs", self.ISF)
        self.write("corpus/bad.fs", "float main;\n")
        result = run("corpus", self.folder / "corpus", "--json", "--frames", "2", "--size", "8x8")
        bad, good = json.loads(result.stdout)["files"]
        self.assertIn("ISF", bad["why"])
        self.assertEqual((good["why"], good["drew"], good["parameters"]), ("", True, 3))

    def test_a_corpus_is_told_file_by_file(self):
        self.write("corpus/good.slang", self.SHADER)
        self.write("corpus/good.slangp", "shaders = 1\nshader0 = good.slang\n")
        self.write("corpus/bad/wrong.slang", self.SHADER.replace("vec4(params", "vec5(params"))
        self.write("corpus/bad/wrong.slangp", "shaders = 1\nshader0 = wrong.slang\n")
        self.write("corpus/bad/lost.slangp", "shaders = 1\nshader0 = none.slang\n")
        result = run("corpus", self.folder / "corpus", "--json", "--frames", "2", "--size", "8x8")
        self.assertEqual(result.returncode, 1, result.stderr)
        told = json.loads(result.stdout)
        self.assertEqual(told["sum"], {"files": 3, "parsed": 2, "compiled": 1, "linked": 1, "drew": 1})
        lost, wrong, good = told["files"]
        self.assertIn("none.slang", lost["why"])
        self.assertIn("wrong.slang:11: error: ", wrong["why"])
        self.assertEqual((good["why"], good["passes"], good["parameters"]), ("", 1, 1))
        self.assertEqual(run("corpus", self.folder / "corpus", "--only", "good").returncode, 0)

    TOY = "void mainImage(out vec4 c, in vec2 p) { c = vec4(float(iFrame) / 255.0, iTime, 0.0, 0.5); }"

    def test_a_shader_of_shadertoy_is_drawn_from_json_from_text_and_from_a_folder(self):
        image = {"type": "image", "inputs": [], "outputs": [{"id": "4dfGRr"}], "code": self.TOY}
        exported = self.write("exported.json", json.dumps([{"info": {"name": "a"}, "renderpass": [image]}]))
        answered = self.write("answered.json", json.dumps({"Shader": {"info": {}, "renderpass": [image]}}))
        text = self.write("folder/Image.glsl", self.TOY)
        for look in (exported, answered, text, text.parent):
            self.assertEqual(self.red_of(look, "--frames", "8"), 7)  # frames are counted from 0

    def test_a_fragment_shader_alone_is_drawn_with_its_uniforms_as_parameters(self):
        bare = self.write("bare.frag", "uniform float level; // @range 0 1\n"
                                       "void main() { gl_FragColor = vec4(level); }\n")
        self.assertEqual(self.red_of(bare, "--set", "level=0.4"), 102)

    def test_a_sample_of_a_corpus_is_the_same_each_time_and_another_with_another_seed(self):
        for n in range(30):
            self.write(f"many/{n}.glsl", self.TOY)

        def sample(*options):
            told = run("corpus", self.folder / "many", "--json", "--frames", "0", "--sample", "4", *options)
            return [entry["file"] for entry in json.loads(told.stdout)["files"]]

        first = sample()
        self.assertEqual(len(first), 4)
        self.assertEqual(first, sample())
        self.assertNotEqual(first, sample("--seed", "2"))


if __name__ == "__main__":
    main()
