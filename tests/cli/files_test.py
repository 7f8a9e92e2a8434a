"""Real-world files: the files in tests/inputs open with their values, or are refused with a reason."""

import json
import os
import re
import shutil
import subprocess

from program import PROGRAM, SOURCE, ProgramTest, main, read_png, run

INPUTS = SOURCE / "tests" / "inputs"
TINT = "float tint() { return 0.5; }\n"


class Files(ProgramTest):
    def picture(self, look, *arguments, size="8x8", frames="1"):
        """The rows of its picture, and the output on stderr."""
        out = self.folder / "out.png"
        done = run("render", look, "--size", size, "--frames", frames, "-o", out, *arguments)
        self.assert_done(done)
        return read_png(out)[2], done.stderr

    def color(self, look, *arguments):
        """Red, green and blue at the centre."""
        rows, _ = self.picture(look, *arguments)
        return list(rows[4][12:15])


class Includes(Files):
    def test_an_include_goes_up_within_the_opened_tree(self):
        self.assertEqual(self.color(INPUTS / "bare/sub/up.frag"), [128, 128, 128])

    def test_a_refused_include_names_the_boundary_and_the_option(self):
        self.write("lib/tint.glsl", TINT)
        self.write("look/look.json",
                   '{"format": "afterglow-look", "version": 1, "name": "T", "driven_by": "nothing",'
                   ' "passes": [{"name": "a", "fragment": "a.frag"}]}')
        self.write("look/a.frag", '#version 410 core\n#include "../lib/tint.glsl"\nout vec4 color;\n'
                                  "void main() { color = vec4(tint()); }\n")
        look = self.folder / "look"
        self.assert_refused(run("check", look), "a.frag:2: error", f"'{look}'", "--include FOLDER")
        self.assert_done(run("check", look, "--include", self.folder / "lib"))
        self.assertEqual(self.color(look, "--include", self.folder / "lib"), [128, 128, 128])
        self.assert_refused(run("check", look, "--include", self.folder / "none"), "is not a folder")

    def test_a_linked_file_and_a_linked_folder_open(self):
        self.write("store/main.frag", '#include "lygia/tint.glsl"\n'
                                      "void main() { gl_FragColor = vec4(tint()); }\n")
        self.write("store/lygia/tint.glsl", TINT)
        (self.folder / "in/sub").mkdir(parents=True)
        (self.folder / "in/sub/main.frag").symlink_to(self.folder / "store/main.frag")
        (self.folder / "in/sub/lygia").symlink_to(self.folder / "store/lygia")
        self.assertEqual(self.color(self.folder / "in/sub/main.frag"), [128, 128, 128])


class Drawings(Files):
    def test_drawings_and_models_are_opened_by_their_signal(self):
        for signal in ("drawing:svg/z.svgz", "drawing:svg/use.svg", "scene:obj/cont.obj",
                       "scene:obj/scene_cont.json", "scene:obj/scene_cr_only.json",
                       "scene:obj/scene_degenerate.json"):
            kind, name = signal.split(":")
            rows, errors = self.picture("phosphor", "--signal", f"{kind}:{INPUTS / name}", size="64x64")
            self.assertEqual(errors, "", signal)
            self.assertGreater(max(map(max, rows)), 60, signal)

    def test_a_file_of_another_kind_says_what_it_is(self):
        for signal, words in (("drawing:wav/zerosize.wav", "audio:FILE"),
                              ("drawing:obj/cont.obj", "scene:FILE"),
                              ("scene:svg/use.svg", "drawing:FILE"),
                              ("audio:svg/use.svg", "drawing:FILE"),
                              ("drawing:toy/vscode.glsl", "an SVG, a scene (.json) or a model (.obj)")):
            kind, name = signal.split(":")
            self.assert_refused(run("render", "phosphor", "--signal", f"{kind}:{INPUTS / name}",
                                    "-o", self.folder / "x.png"), words)


class BrokenOff(Files):
    def test_what_breaks_off_is_read_with_a_warning(self):
        for name, words in (("cut.wav", "the file ends early: only 0.02 of 0.05 s"),
                            ("zerosize.wav", "the recording is unfinished: its header")):
            _, errors = self.picture("phosphor", "--signal", f"audio:{INPUTS / 'wav' / name}", size="32x32")
            self.assertIn(f"{name}: warning: {words}", errors)
        _, errors = self.picture("crt", "--source", INPUTS / "pic/cut.jpg", size="32x32")
        self.assertIn("cut.jpg: warning: the file ends early", errors)

    def test_check_warns_as_render_does(self):
        for name in ("wav/cut.wav", "pic/cut.jpg"):
            shutil.copy(INPUTS / name, self.folder)
        for look, option, text in (("phosphor", "--signal", f"audio:{self.folder / 'cut.wav'}"),
                                   ("crt", "--source", str(self.folder / "cut.jpg"))):
            preset = self.folder / f"{look}.json"
            self.assert_done(run("preset", look, option, text, "-o", preset))
            checked = run("check", preset)
            self.assert_done(checked)
            _, errors = self.picture(preset, size="32x32")
            self.assertIn("the file ends early", errors)
            self.assertEqual(sorted(set(checked.stderr.splitlines())), sorted(set(errors.splitlines())))


def plain_picture(*color, side=4):
    """A picture of one colour, as PNM. Its file can have any ending."""
    return b"P6 %d %d 255\n" % (side, side) + bytes(color) * side * side


class Libretro(Files):
    def render_white(self, name):
        white = self.write("white.ppm", plain_picture(255, 255, 255))
        return self.picture(INPUTS / "slang" / name, "--source", white)

    def test_a_missing_file_of_values_is_a_warning(self):
        rows, errors = self.render_white("nested/top.slangp")
        self.assertIn("inner_second.params:2: warning: can't read 'gone.params'", errors)
        self.assertEqual(rows[4][12], 191)  # GAIN is 0.75, from a.params

    def test_a_decimal_comma_is_a_warning_with_its_line(self):
        _, errors = self.render_white("commanum.slangp")
        self.assertIn("commanum.slangp:3: warning: 'GAIN' is 0 because '0,5' has a decimal comma", errors)

    def test_a_shader_that_is_missing_names_one_that_is_there(self):
        for name, path in (("drive.slangp", "C:/RetroArch/shaders/stock.slang"),
                           ("colon.slangp", ":/shaders/shaders_slang/stock.slang")):
            self.assert_refused(run("check", INPUTS / "slang" / name), f"{name}:2: error",
                                path, "file not found (did you mean 'stock.slang'?)")
        for wanted, there in (("Shaders/Stock.slang", "shaders/stock.slang"), ("STOCK.slang", "stock.slang")):
            folder = self.folder / wanted.replace("/", "-")
            self.write(folder / there, "x")
            self.write(folder / "a.slangp", f"shaders = 1\nshader0 = {wanted}\n")
            self.assert_refused(run("check", folder / "a.slangp"), f"(did you mean '{there}'?)")


class Isf(Files):
    def parameters(self, look):
        done = run("describe", look, "--json")
        self.assert_done(done)
        return {one["name"]: one for one in json.loads(done.stdout)["parameters"]}

    def test_code_may_stand_before_the_header(self):
        look = INPUTS / "isf/codefirst.fs"
        self.assertIn("a", self.parameters(look))
        # isf_FragNormCoord of the texel to the right of and below the centre of 8 x 8 texels.
        for got, expected in zip(self.color(look), (255 * 4.5 / 8, 255 * 3.5 / 8, 127.5)):
            self.assertAlmostEqual(got, expected, delta=1)

    def test_a_long_with_labels_is_a_list(self):
        look = INPUTS / "isf/longmis.fs"
        items = {name: [item["label"] for item in one["items"]] for name, one in self.parameters(look).items()}
        self.assertEqual(items, {"m": ["a", "b", "2"], "n": ["x", "y", "z"], "o": ["p", "q"]})
        self.assertEqual(self.color(look), [0, 255, 0])  # m 0, n 1, o 0

    def test_an_imported_cube_is_made_of_six_pictures(self):
        text = (INPUTS / "isf/cube_imported.fs").read_text()
        look = self.write("cube.fs", text)
        rows, errors = self.picture(look)
        self.assertEqual(rows[4][12:15], bytearray(3))
        self.assertIn("'sky' shows black", errors)
        for face in range(6):
            self.write(f"{face}.png", plain_picture(40 * face, 200, 10))
        self.assertEqual(self.color(look), [160, 200, 10])  # +z is the fifth face
        self.write("down.fs", text.replace("isf_FragNormCoord*2.-1., 1.", "isf_FragNormCoord*0.1, -1."))
        self.assertEqual(self.color(self.folder / "down.fs"), [200, 200, 10])
        self.write("3.png", plain_picture(0, 0, 0, side=8))
        self.assertIn("squares of the same size", self.picture(look)[1])

    def test_a_color_may_be_written_as_text(self):
        look = self.write("color.fs", """/*{"INPUTS": [{"NAME": "c", "TYPE": "color", "DEFAULT": "#ff8000"},
            {"NAME": "d", "TYPE": "color", "DEFAULT": "#0f08"}]}*/
            void main() { gl_FragColor = vec4(c.rg, d.a, 1.0); }""")
        self.assertEqual(self.color(look), [255, 128, 136])

    def test_a_mistake_in_a_header_of_one_line_has_its_column(self):
        for header, column in (('{"INPUTS": [{"NAME": "a" "TYPE": "float"}]}', 27),
                               ('{"INPUTS": [{"NAME": "a", "TYPE": "foo"}]}', 27)):
            look = self.write("one.fs", f"/*{header}*/\nvoid main() {{}}\n")
            done = run("check", look)
            self.assert_refused(done, "one.fs:1: error")
            found = re.search(r"column (\d+)", done.stderr)
            self.assertIsNotNone(found, done.stderr)
            self.assertAlmostEqual(int(found[1]), column + 2, delta=9)

    def test_commas_before_a_closing_bracket_are_passed_over(self):
        look = self.write("comma.fs", '/*{"INPUTS": [{"NAME": "a", "TYPE": "float", "DEFAULT": 1,},],}*/\n'
                                      "void main() { gl_FragColor = vec4(a); }\n")
        self.assertEqual(self.color(look), [255, 255, 255])


class Shadertoy(Files):
    def test_a_download_of_all_shaders_opens_if_it_holds_one(self):
        for got, expected in zip(self.color(INPUTS / "toy/export.json"),
                                 (255 * 4.5 / 8, 255 * 3.5 / 8, 127.5)):
            self.assertAlmostEqual(got, expected, delta=1)
        several = json.loads((INPUTS / "toy/export.json").read_text())
        several["shaders"].append(json.loads(json.dumps(several["shaders"][0])))
        several["shaders"][1]["info"]["name"] = "other"
        self.assert_refused(run("check", self.write("all.json", json.dumps(several))), "'n', 'other'")

    def test_a_saved_web_page_says_so(self):
        self.assert_refused(run("check", INPUTS / "toy/html.json"), "is a web page, not Shadertoy's JSON")
        page = self.write("a.frag", "<!DOCTYPE html>\n<html><pre>void main() {}</pre></html>")
        self.assert_refused(run("check", page), "is a web page, not a shader")

    def test_the_directives_of_an_editor_wire_channels_and_uniforms(self):
        look = self.write("toy/vscode.glsl", (INPUTS / "toy/vscode.glsl").read_text())
        _, errors = self.picture(look)
        self.assertIn("vscode.glsl:1: warning: can't find the picture '../pic/rgb.png'", errors)
        self.write("pic/rgb.png", plain_picture(100, 60, 20))
        self.assertEqual(self.color(look), [50, 30, 10])
        rows, errors = self.picture(look, frames="2")  # adds its own previous frame
        self.assertEqual((list(rows[4][12:15]), errors), ([100, 60, 20], ""))
        self.assertEqual(self.color(look, "--set", "gain=1"), [100, 60, 20])

    def test_the_directives_name_other_files_as_buffers(self):
        self.write("b.glsl", "void mainImage(out vec4 o, in vec2 f) { o = vec4(0.25); }\n")
        look = self.write("a.glsl", '#iChannel2 "file://b.glsl"\n#iChannel2::MinFilter "Nearest"\n'
                                    "#iUniform color3 tint = color3(1.0, 0.5, 0.0)\n"
                                    "void mainImage(out vec4 o, in vec2 f) {\n"
                                    "    o = vec4(tint * 4.0 * texture(iChannel2, f / iResolution.xy).r, 1.0);\n}\n")
        self.assertEqual(self.color(look), [255, 128, 0])
        broken = self.write("c.glsl", '#iChannel0 "self"\nvoid mainImage(out vec4 o, in vec2 f) {\n    o = x;\n}\n')
        self.assert_refused(run("check", broken), "c.glsl:3: error")


class Signals(Files):
    def test_a_file_may_have_commas_and_equals_signs_in_its_name(self):
        song = (INPUTS / "wav/Song, Pt. 2.wav").read_bytes()
        for name in ("Song, Pt. 2.wav", "a=b.wav", "x, y = z.wav"):
            file = self.write(name, song)
            shutil.copy(file, self.folder / "plain.wav")
            plain, _ = self.picture("phosphor", "--signal", f"audio:{self.folder / 'plain.wav'}", size="32x32")
            for text in (f'audio:"{file}"', f'audio:"{file}",mode=xy'):
                self.assert_done(run("render", "phosphor", "--signal", text, "--frames", "1", "--size", "8x8",
                                     "-o", self.folder / "x.png"))
            done = run("render", "phosphor", "--signal", f"audio:{name}", "--frames", "1", "--size", "32x32",
                       "-o", self.folder / "y.png", cwd=self.folder)
            if name != "x, y = z.wav":
                self.assert_done(done)
                self.assertEqual(read_png(self.folder / "y.png")[2], plain)

    def test_what_the_font_lacks_is_a_warning(self):
        for text, missing in (("Äß Łódź naïve", ""), ("Ж и Ж", "Ж и")):
            _, errors = self.picture("phosphor", "--signal", f"text:{text}", size="32x32")
            self.assertIn(f"missing from the font are drawn as boxes: {missing}\n" if missing else "", errors)
            self.assertEqual("missing from the font" in errors, bool(missing), errors)


class Machine(Files):
    def test_a_picture_larger_than_memory_is_refused_first(self):
        memory = os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE")
        if memory > 60e9:
            self.skipTest("this machine may draw it")
        done = run("render", "phosphor", "--size", "16384x16384", "-o", self.folder / "x.png", timeout=30)
        self.assert_refused(done, "GB of memory", "smaller --size")

    def test_a_full_disk_at_the_drivers_cache_ends_nothing(self):
        cache = self.folder / "cache"
        cache.mkdir()
        mounts = ["unshare", "--mount", "--map-root-user", "sh", "-c"]
        fill = f"mount -t tmpfs -o size=64k none {cache} && (cat /dev/zero >{cache}/fill 2>{os.devnull} || true) && "
        if subprocess.run([*mounts, fill + "true"], capture_output=True).returncode != 0:
            self.skipTest("no file system can be mounted here")
        out = self.folder / "x.png"
        environment = dict(os.environ, XDG_CACHE_HOME=str(cache))
        environment.pop("MESA_SHADER_CACHE_DIR", None)
        done = subprocess.run([*mounts, fill + f"{PROGRAM} render crt --size 32x32 --frames 1 -o {out}"],
                              env=environment, capture_output=True, text=True, timeout=120)
        self.assert_done(done)
        self.assertTrue(out.is_file())


if __name__ == "__main__":
    main()
