#!/usr/bin/env python3
"""Looks as user shaders of mpv: what the file contains, a picture that mpv draws, and bad input.

mpv_export_test.py PROGRAM
"""
import json
import re
import shutil
import struct
import subprocess
import sys
import unittest
import zlib

from program import SOURCE, ProgramTest, main, read_png, run

DRAW_IN_MPV = SOURCE / "tests" / "mpv" / "draw_in_mpv.py"
BLOCK = re.compile(r"^//!(HOOK|PARAM|TEXTURE) (.*)$", re.MULTILINE)
DEFINED_VALUE = re.compile(r"^#define \w+ -?[\d.e-]+  // .*\n", re.MULTILINE)
PARAMETER = re.compile(r"\n//!PARAM (\w+)\n//!DESC (.*)\n//!TYPE (.*)\n//!MINIMUM (.*)\n//!MAXIMUM (.*)\n(.*)\n")
SHADER = """#version 410 core
in vec2 uv;
out vec4 color;
uniform sampler2D scene;
uniform float gain = 1.0;  // @range 0 2
void main() { color = vec4(texture(scene, uv).rgb * gain, 1.0); }
"""


def png(rows):
    """The bytes of an 8-bit RGB picture."""
    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
    size = struct.pack(">IIBBBBB", len(rows[0]) // 3, len(rows), 8, 2, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", size) +
            chunk(b"IDAT", zlib.compress(b"".join(b"\0" + row for row in rows))) + chunk(b"IEND", b""))


class MpvExportTest(ProgramTest):
    def export(self, look, *options, name="look.glsl"):
        file = self.folder / name
        self.assert_done(run("export", look, "--to", "mpv", "-o", file, *options))
        return file.read_text(encoding="utf-8")

    def look(self, name="own", shader=SHADER, inputs=None, **members):
        """The folder of a look with one pass."""
        self.write(f"{name}/show.frag", shader)
        self.write(f"{name}/look.json", json.dumps({
            "format": "afterglow-look", "version": 1, "name": name, "about": "A look.", "author": "A. Nyone",
            "license": "MIT", "driven_by": "picture", "default_source": "pattern:harbour",
            "source_encoding": "display",
            "passes": [{"name": "show", "fragment": "show.frag", "inputs": inputs or {"scene": "source"}}],
            **members}))
        return self.folder / name

    def refused(self, look, *words, name="look.glsl"):
        before = sorted(self.folder.iterdir())
        for options in (["-o", self.folder / name], ["--dry-run"]):
            self.assert_refused(run("export", look, "--to", "mpv", *options), *words)
        self.assertEqual(sorted(self.folder.iterdir()), before)

    def test_the_author_s_text_stays_with_its_includes(self):
        text = self.export("shadow-mask")
        self.assertIn("// Distance from one red to the next, px.\nfloat mask_pitch() {\n", text)
        self.assertIn("/* uniform float mask_size = 6.0; */", text)
        self.assertNotIn("#include", text)
        self.assertNotIn("#version", text)

    def test_values_are_defined_with_label_and_range(self):
        text = self.export("crt", "--set", "exposure=2.5", "--set", "tone_map=ACES", "--set", "dither=off")
        self.assertIn("#define exposure 2.5  // Tone mapping: Exposure, 0.1 to 16.0\n", text)
        self.assertRegex(text, r"#define tone_map 2  // Tone mapping: Tone map: 0 Clamp, .*2 ACES.*, 0 to 6\n")
        self.assertIn("#define dither 0  // Tone mapping: Dither, 0 to 1\n", text)
        self.assertNotIn("//!PARAM", text)

    def test_parameters_have_the_same_body(self):
        options = ["--set", "exposure=2.5", "--set", "dither=off"]
        defined, parameters = self.export("crt", *options), self.export("crt", *options, "--params")
        body = PARAMETER.sub("", parameters)
        self.assertEqual(DEFINED_VALUE.sub("", defined), body)
        found = {name: rest for name, *rest in PARAMETER.findall(parameters)}
        self.assertEqual(found["exposure"], ["Tone mapping: Exposure", "float", "0.1", "16.0", "2.5"])
        self.assertEqual(found["dither"], ["Tone mapping: Dither", "int", "0", "1", "0"])
        self.assertEqual(len(found), len(DEFINED_VALUE.findall(defined)))

    def test_the_head_has_author_and_licence(self):
        head = self.export(self.look()).partition("//!")[0]
        self.assertIn("// Author: A. Nyone\n// Licence: MIT\n", head)
        self.assertIn("show.frag", head)

    def test_hostile_text_starts_no_block(self):
        hostile = 'a */ " \\ //!HOOK MAIN'
        shader = SHADER.replace("uniform float", "// //!BIND none\n/* //!SAVE x */ uniform float").replace(
            "@range 0 2", f'@range 0 2 @label "{hostile.replace(chr(34), chr(39))}"')
        look = self.look("evil //!HOOK", shader, about=hostile + "\n//!TEXTURE x\n#error", author=hostile)
        for options in ([], ["--params"]):
            text = self.export(look, *options)
            marks = [line for line in text.splitlines() if "//!" in line]
            self.assertTrue(all(line.startswith("//!") and line.count("//!") == 1 for line in marks), marks)
            self.assertEqual([found[0] for found in BLOCK.findall(text)],
                             ["PARAM"] * len(options) + ["HOOK", "HOOK"])
            self.assertNotIn("\n#error", text)

    def test_names_of_mpv_and_of_other_macros_are_renamed(self):
        shader = SHADER.replace("void main", "#define pair(x) ((x) * 1.0)\n"
                                "float random(float frame) { return pair(frame) + HALF(frame); }\n"
                                "void main").replace("in vec2 uv", "#define HALF(x) (x)\nin vec2 uv").replace(
            "* gain", "* gain * random(0.5)")
        text = self.export(self.look(shader=shader))
        self.assertIn("float own_random(float own_frame)", text)
        self.assertEqual(text.count("#undef pair\n"), 1)
        self.assertEqual(text.count("#undef HALF\n"), 1)

    def test_targets_keep_their_bits_and_sizes(self):
        self.write("own/half.frag", SHADER)
        look = self.look(passes=[
            {"name": "half", "fragment": "half.frag", "format": "rgba8", "scale": 0.5, "inputs": {"scene": "source"}},
            {"name": "show", "fragment": "show.frag", "inputs": {"scene": {"from": "half", "wrap": "border"}}}])
        text = self.export(look)
        self.assertIn("//!WIDTH OUTPUT.w 0.500000000 * OUTPUT.w 0.500000000 * 0.5 < +\n", text)
        self.assertIn("return afterglow_rounded(color);", text)
        self.assertIn("afterglow_linear_border(afterglow_pass_half_raw, at)", text)

    def test_a_picture_is_embedded_with_the_first_row_at_the_bottom(self):
        self.write("own/table.png", png([b"\xff\0\0\0\xff\0", b"\0\0\xff\xff\xff\xff"]))
        shader = SHADER.replace("uniform float", "uniform sampler2D table;\nuniform float").replace(
            "* gain", "* gain + texture(table, uv).rgb")
        text = self.export(self.look(shader=shader, inputs={"scene": "source", "table": "table"},
                                     images={"table": "table.png"}))
        self.assertIn("//!SIZE 2 2\n//!FORMAT rgba8\n//!FILTER LINEAR\n"
                      "0000ffffffffffffff0000ff00ff00ff\n", text)

    def test_what_mpv_cannot_draw_is_refused_with_an_alternative(self):
        self.refused("vector-beam", "draws a beam", "--to web")
        self.refused(self.look("past", inputs={"scene": "show@1"}), "previous frame",
                     "--to web")
        self.refused(self.look("holes", SHADER.replace("{ color", "{ if (uv.x < 0.5) discard; color")),
                     "discards pixels", "--to web")

    def test_nothing_is_half_written(self):
        self.assert_refused(run("export", "crt", "--to", "mpv", "-o", self.folder / "a.txt"), ".glsl")
        self.assert_refused(run("export", "crt", "--to", "mpv", "-o", self.folder), "is a folder")
        self.assert_refused(run("export", "crt", "--to", "web", "--params", "-o", self.folder / "a.html"),
                            "only with --to mpv", code=2)
        self.refused(self.look("broken", "#version 410 core\nvoid main() { oops }\n"), "show.frag:2")

    def test_verify_says_that_mpv_draws_the_file(self):
        done = run("export", "crt", "--to", "mpv", "-o", self.folder / "a.glsl", "--verify")
        self.assertEqual(done.returncode, 1)
        self.assertIn("not verified: ", done.stdout)

    @unittest.skipUnless(shutil.which("mpv") and shutil.which("Xvfb"), "mpv or Xvfb is not installed")
    def test_mpv_draws_the_same_picture(self):
        source, drawn, rendered = (self.folder / name for name in ("source.png", "mpv.png", "render.png"))
        self.assert_done(run("render", "crt", "--set", "crt=off", "--source", "pattern:harbour", "--size", "160x120",
                             "-o", source))
        content = ["--source", f"{source},fit=stretch,prescaled=1", "--size", "320x180"]
        self.export("shadow-mask", *content)
        self.assert_done(run("render", "shadow-mask", *content, "--frames", "3", "-o", rendered))
        done = subprocess.run([sys.executable, DRAW_IN_MPV, "--size", "320x180", "--frame", "3", "--shader",
                               self.folder / "look.glsl", source, drawn], capture_output=True, text=True, timeout=100)
        self.assertEqual(done.returncode, 0, done.stderr)
        ours, theirs = (b"".join(read_png(file)[2]) for file in (rendered, drawn))
        self.assertGreater(len(set(ours)), 30)
        off = {i // 3 for i, (a, b) in enumerate(zip(ours, theirs, strict=True)) if abs(a - b) > 2}
        self.assertLessEqual(len(off), 0.001 * len(ours) / 3)


if __name__ == "__main__":
    main()
