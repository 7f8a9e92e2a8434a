#!/usr/bin/env python3
"""Looks as ISF files: what the file contains, its picture, and bad input.

isf_export_test.py PROGRAM
"""
import json
import re
import unittest

from program import ProgramTest, main, read_png, run


class IsfExportTest(ProgramTest):
    def export(self, look, *options, name="look.fs"):
        file = self.folder / name
        self.assert_done(run("export", look, "--to", "isf", "-o", file, *options))
        return file

    def header(self, file):
        text = file.read_text(encoding="utf-8")
        self.assertTrue(text.startswith("/*{"))
        return json.loads(text[2:text.index("*/")]), text

    def inputs(self, file):
        return {entry["NAME"]: entry for entry in self.header(file)[0]["INPUTS"]}

    def look(self, label):
        folder = self.folder / "own"
        folder.mkdir()
        (folder / "show.frag").write_text(
            "#version 410 core\nin vec2 uv;\nout vec4 color;\nuniform sampler2D scene;\n"
            f'uniform float gain = 1.0;  // @label "{label}" @range 0 2\n'
            "void main() { color = vec4(texture(scene, uv).rgb * gain, 1.0); }\n", encoding="utf-8")
        (folder / "look.json").write_text(json.dumps({
            "format": "afterglow-look", "version": 1, "name": label, "about": label, "author": "A. Nyone",
            "license": "MIT", "driven_by": "picture", "default_source": "pattern:harbour",
            "source_encoding": "display",
            "passes": [{"name": "show", "fragment": "show.frag", "inputs": {"scene": "source"}}]}), encoding="utf-8")
        return folder

    def picture(self, look, *options, size="160x120"):
        file = self.folder / "picture.png"
        self.assert_done(run("render", look, "--source", "pattern:harbour", "--size", size, "--frames", "3",
                             "-o", file, *options))
        return b"".join(read_png(file)[2])

    def assert_same_picture(self, look, *options, size="160x120"):
        file = self.export(look, "--source", "pattern:harbour", *options)
        ours, theirs = self.picture(look, *options, size=size), self.picture(file, size=size)
        self.assertGreater(len(set(ours)), 30)
        self.assertLessEqual(max(abs(a - b) for a, b in zip(ours, theirs)), 1)

    def test_looks_and_stacks_draw_the_same_picture(self):
        self.assert_same_picture("crt", "--preset", "arcade-cabinet")
        self.assert_same_picture("crt+crt", "--set", "crt/aberration=3")

    def test_a_tube_keeps_its_afterglow(self):  # reads the previous frame in a later pass
        self.assert_same_picture("phosphor", "--preset", "long-green")

    def test_the_source_can_be_larger_than_the_picture(self):
        self.assert_same_picture("shadow-mask", "--preset", "studio-grille", size="128x96")

    def test_a_preset_of_another_program_draws_the_same_picture(self):
        slang = self.folder / "crt.slangp"
        self.assert_done(run("export", "crt", "--to", "slang", "-o", slang))
        self.assert_same_picture(slang)

    def test_an_isf_file_draws_the_same_picture(self):
        file = self.folder / "own.fs"
        file.write_text("""/*{"ISFVSN": "2", "INPUTS": [{"NAME": "inputImage", "TYPE": "image"},
            {"NAME": "r", "TYPE": "bool", "DEFAULT": true}, {"NAME": "texel_middle", "TYPE": "float", "DEFAULT": 0.5}],
            "PASSES": [{"TARGET": "texel", "WIDTH": 1, "HEIGHT": 1}, {"TARGET": "trail", "PERSISTENT": true}]}*/
            float ratio = RENDERSIZE.y / RENDERSIZE.x;
            vec4 texture(vec2 at) { return IMG_NORM_PIXEL(inputImage, at, 1.0); }
            void main() {
                vec4 color = texture(isf_FragNormCoord * vec2(1.0, ratio));
                color.r = r ? color.b : color.g;
                gl_FragColor = mix(color, IMG_THIS_PIXEL(trail), texel_middle);
            }
            """, encoding="utf-8")
        self.assert_same_picture(file)

    def test_a_limit_that_the_file_exceeds_can_be_raised(self):
        file = self.folder / "own.fs"
        file.write_text('/*{"ISFVSN": "2", "INPUTS": [{"NAME": "inputImage", "TYPE": "image"}]}*/\nvoid main() {\n'
                        + "    gl_FragColor += IMG_THIS_PIXEL(inputImage);\n" * 20 + "}\n", encoding="utf-8")

        def export(limit):
            return run("--limit", f"inlined-calls={limit}", "export", file, "--to", "isf", "-o", self.folder / "a.fs")

        done = export(60)
        self.assert_refused(done, "calls after inlining; the limit is 60")
        self.assert_done(export(re.search(r"inlined-calls=(\d+)", done.stderr)[1]))

    def test_parameters_are_inputs_with_their_values(self):
        inputs = self.inputs(self.export("shadow-mask", "--set", "mask_size=7", "--set", "tint=1,0.5,0",
                                         "--set", "tone_map=ACES", "--set", "dither=off"))
        self.assertEqual(inputs["inputImage"], {"NAME": "inputImage", "TYPE": "image"})
        size = inputs["mask_size"]
        self.assertEqual((size["TYPE"], size["MIN"], size["MAX"], size["DEFAULT"]), ("float", 2, 32, 7))
        self.assertEqual((inputs["tone_map"]["TYPE"], inputs["tone_map"]["DEFAULT"]), ("long", 2))
        self.assertEqual(inputs["tone_map"]["LABELS"][2], "ACES")
        self.assertEqual((inputs["dither"]["TYPE"], inputs["dither"]["DEFAULT"]), ("bool", False))
        self.assertEqual(inputs["red_offset"]["TYPE"], "point2D")
        color = inputs["tint_display"]
        self.assertEqual(color["TYPE"], "color")
        for given, expected in zip(color["DEFAULT"], (1.0, 0.735357, 0.0, 1.0)):  # sRGB of 0.5 linear
            self.assertAlmostEqual(given, expected, places=5)

    def test_the_author_s_text_stays(self):
        _, text = self.header(self.export("shadow-mask"))
        self.assertIn("// Distance from one red to the next, px.\nfloat mask_pitch() {\n", text)
        self.assertIn("// Licence: MIT\n", text)

    def test_hostile_text_stays_text(self):
        look = self.look("*/ ' \\\\ #error no")
        self.assert_same_picture(look)
        self.assertEqual(self.header(self.folder / "look.fs")[0]["CREDIT"], "A. Nyone")

    def test_what_isf_lacks_is_refused_before_anything_is_written(self):
        file = self.folder / "a.fs"
        self.assert_refused(run("export", "vector-beam", "--to", "isf", "-o", file), "draws a beam", "--to web")
        self.assert_refused(run("export", "phosphor", "--source", "pattern:harbour", "--to", "isf", "-o", file),
                            "more than 16 textures", "--to slang")  # blurs by a pyramid
        self.assert_refused(run("export", "crt", "--to", "isf", "-o", self.folder / "a.txt"), ".fs")
        self.assertEqual(list(self.folder.iterdir()), [])


if __name__ == "__main__":
    main()
