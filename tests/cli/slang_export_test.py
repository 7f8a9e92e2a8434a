#!/usr/bin/env python3
"""Looks as libretro slang presets: what the files contain, their pictures, and bad input.

slang_export_test.py PROGRAM
"""
import json
import os
import re
import shutil
import subprocess
import unittest

from program import ProgramTest, main, read_png, run

STAGE = re.compile(r"^#pragma stage (\w+)$", re.MULTILINE)
INCLUDE = re.compile(r'^#include "(.*)"$', re.MULTILINE)


def expanded(file):
    """A shader with its includes, as RetroArch reads it."""
    return INCLUDE.sub(lambda found: expanded(file.parent / found.group(1)), file.read_text(encoding="utf-8"))


def stages(file):
    """The text of each stage of a shader. What comes before the first belongs to both."""
    head, *parts = STAGE.split(expanded(file))
    return {kind: head + text for kind, text in zip(parts[::2], parts[1::2])}


class SlangExportTest(ProgramTest):
    def export(self, look, *options, name="look.slangp"):
        file = self.folder / name
        return file, self.assert_done(run("export", look, "--to", "slang", "-o", file, *options))

    def look(self, name="own", label="Gain", about="A look.", shader=None, **members):
        folder = self.folder / name
        folder.mkdir()
        (folder / "show.frag").write_text(shader or (
            "#version 410 core\nin vec2 uv;\nout vec4 color;\nuniform sampler2D scene;\n"
            f'uniform float gain = 1.0;  // @label "{label}" @range 0 2\n'
            "void main() { color = vec4(texture(scene, uv).rgb * gain, 1.0); }\n"), encoding="utf-8")
        (folder / "look.json").write_text(json.dumps({
            "format": "afterglow-look", "version": 1, "name": name, "about": about, "author": "A. Nyone",
            "license": "MIT", "driven_by": "picture", "default_source": "pattern:harbour",
            "source_encoding": "display",
            "passes": [{"name": "show", "fragment": "show.frag", "inputs": {"scene": "source"}}], **members}),
            encoding="utf-8")
        return folder

    def picture(self, look, *options):
        file = self.folder / "picture.png"
        self.assert_done(run("render", look, "--source", "pattern:harbour", "--size", "160x90", "--frames", "3",
                             "-o", file, *options))
        return b"".join(read_png(file)[2])

    def assert_same_picture(self, look, *options):
        file, _ = self.export(look, "--source", "pattern:harbour", *options)
        ours, theirs = self.picture(look, *options), self.picture(file)
        self.assertGreater(len(set(ours)), 30)
        self.assertLessEqual(max(abs(a - b) for a, b in zip(ours, theirs)), 1)

    def test_looks_presets_and_stacks_draw_the_same_picture(self):
        self.assert_same_picture("crt", "--preset", "arcade-cabinet")
        self.assert_same_picture("shadow-mask", "--preset", "dot-triads")
        self.assert_same_picture("shadow-mask+crt", "--set", "crt/aberration=3")
        self.assert_same_picture("phosphor", "--preset", "long-green")

    @unittest.skipUnless(shutil.which("glslangValidator"), "glslangValidator is not installed")
    def test_another_compiler_accepts_each_stage(self):
        self.export("shadow-mask")
        shaders = sorted(self.folder.rglob("*.slang"))
        self.assertEqual(len(shaders), 7)
        for shader in shaders:
            texts = stages(shader)
            self.assertEqual(sorted(texts), ["fragment", "vertex"])
            for kind, text in texts.items():
                # The directives are RetroArch's own.
                text = re.sub(r"^#pragma (parameter|name|format) .*$", "", text, flags=re.MULTILINE)
                done = subprocess.run(["glslangValidator", "-V", "--stdin", "-S", kind[:4], "-o", os.devnull],
                                      input=text, capture_output=True, text=True)
                self.assertEqual(done.returncode, 0, f"{shader.name}, {kind}: {done.stdout}")

    def test_the_author_s_text_and_includes_stay(self):
        self.export("shadow-mask")
        own = self.folder / "look_shaders" / "tube.slang"
        text = own.read_text(encoding="utf-8")
        self.assertIn("// Distance from one red to the next, px.\nfloat mask_pitch() {\n", text)
        self.assertIn('/* uniform float mask_size = 6.0; */', text)
        self.assertIn('#include "include/mask.glsl"\n', text)
        shared = own.parent / "include" / "mask.glsl"
        self.assertIn("Mask", shared.read_text(encoding="utf-8"))

    def test_parameters_stay_with_their_values(self):
        self.export("crt", "--set", "exposure=2.5", "--set", "tone_map=ACES", "--set", "dither=off")
        text = (self.folder / "look_shaders" / "crt_2.slang").read_text(encoding="utf-8")
        self.assertIn('#pragma parameter exposure "Tone mapping: Exposure" 2.5 0.1 16 0.1\n', text)
        self.assertRegex(text, r'#pragma parameter tone_map "[^"]*2 ACES[^"]*" 2 0 6 1\n')
        self.assertIn('#pragma parameter dither "Tone mapping: Dither" 0 0 1 1\n', text)

    def test_the_head_has_author_and_licence(self):
        file, _ = self.export(self.look())
        for mark, part in (("#", file), ("//", self.folder / "look_shaders" / "show.slang")):
            text = part.read_text()
            self.assertIn(f"{mark} Author: A. Nyone\n{mark} Licence: MIT\n", text)
            self.assertIn("show.frag", text)

    def test_hostile_text_stays_text(self):
        hostile = "\"*/ #pragma \\"
        look = self.look(label="a */ b' #include", about=hostile + "\n#error no")
        self.assert_same_picture(look)

    def test_a_beam_is_refused_with_an_alternative(self):
        for options in ([], ["--dry-run"]):
            done = run("export", "vector-beam", "--to", "slang", "-o", self.folder / "a.slangp", *options)
            self.assert_refused(done, "draws a beam", "--to web")
        done = run("export", "phosphor", "--to", "slang", "-o", self.folder / "a.slangp")
        self.assert_refused(done, "a beam draws a signal", "a preset with one", "--to web")
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_nothing_is_half_written(self):
        self.assert_refused(run("export", "crt", "--to", "slang", "-o", self.folder / "a.txt"), ".slangp")
        self.assert_refused(run("export", "crt", "--to", "slang", "-o", self.folder), "is a folder")
        self.write("mine_shaders/notes.txt", "keep")
        for before in ("", "shaders = 1\n"):  # also if another preset has the name
            if before:
                self.write("mine.slangp", before)
            self.assert_refused(run("export", "crt", "--to", "slang", "-o", self.folder / "mine.slangp"),
                                "notes.txt", "isn't part of an earlier export")
        self.assertEqual((self.folder / "mine_shaders" / "notes.txt").read_text(), "keep")
        self.assertEqual((self.folder / "mine.slangp").read_text(), "shaders = 1\n")
        broken = self.look("broken", shader="#version 410 core\nvoid main() { oops }\n")
        self.assert_refused(run("export", broken, "--to", "slang", "-o", self.folder / "b.slangp"), "show.frag:2")
        self.assertFalse((self.folder / "b.slangp").exists())

    def test_an_exported_preset_is_exported_again(self):
        self.export("crt", name="first.slangp")
        self.export(self.folder / "first.slangp", name="second.slangp")  # has vertex shaders of its own
        self.assert_same_picture(self.folder / "second.slangp")

    def test_what_does_not_compile_there_is_refused_with_the_reason(self):
        shader = ("#version 410 core\nin vec2 uv;\nout vec4 color;\nuniform sampler2D scene;\n"
                  "uniform Block { float gain; };\nvoid main() { color = texture(scene, uv) * gain; }\n")
        look = self.look("block", shader=shader)
        for options in ([], ["--dry-run"]):
            done = run("export", look, "--to", "slang", "-o", self.folder / "a.slangp", *options)
            self.assert_refused(done, "can't be written as a RetroArch preset", "--to web")
            self.assertIn("\nerror: the look can't", done.stderr)  # without a temporary file
        self.assertFalse((self.folder / "a.slangp").exists())

    def test_a_loop_that_nothing_limits_is_exported(self):
        shader = ("#version 410 core\nin vec2 uv;\nout vec4 color;\nuniform sampler2D scene;\n"
                  "void main() {\n    float t = uv.x;\n    while (t > 0.5)\n"
                  "        t -= 0.1 + texture(scene, vec2(t)).r;\n"
                  "    color = texture(scene, uv) * t;\n}\n")
        look = self.look("loop", shader=shader)
        self.assertIn("nothing limits this loop", run("check", look).stderr)
        self.assert_same_picture(look)

    def test_an_earlier_export_is_replaced(self):
        self.export("shadow-mask")
        self.export("crt")
        self.assertFalse((self.folder / "look_shaders" / "tube.slang").exists())
        self.assert_done(run("check", self.folder / "look.slangp"))


if __name__ == "__main__":
    main()
