#!/usr/bin/env python3
"""Looks as Shadertoy files: what the file contains, its picture, and bad input.

shadertoy_export_test.py PROGRAM
"""
import json
import unittest

from program import ProgramTest, main, read_png, run

OWN_SHADER = """#version 410 core
// A comment with */ and "quotes".
in vec2 uv;
out vec4 color;
uniform sampler2D scene;  // the picture
uniform float gain = 1.0; // @label "{label}" @range 0 2
uniform vec2 iMouse = vec2(0.5);  // @range 0 1
void main() {{ color = vec4(texture(scene, uv).rgb * gain + 0.1 * iMouse.x, 1.0); }}
"""


class ShadertoyExportTest(ProgramTest):
    def export(self, look, *options, name="export.json"):
        file = self.folder / name
        self.assert_done(run("export", look, "--to", "shadertoy", "-o", file, *options))
        return file

    def passes(self, file):
        document = json.loads(file.read_text(encoding="utf-8"))
        return {entry["name"]: entry for entry in document["renderpass"]}

    def parameters(self, look, *options):
        described = run("describe", look, "--json", *options)
        self.assert_done(described)
        return {entry["name"]: entry for entry in json.loads(described.stdout)["parameters"]}

    def look(self, label):
        folder = self.folder / "own"
        folder.mkdir()
        (folder / "show.frag").write_text(OWN_SHADER.format(label=label), encoding="utf-8")
        (folder / "look.json").write_text(json.dumps({
            "format": "afterglow-look", "version": 1, "name": label, "about": "*/ \" \\\n\t'", "author": "A. Nyone",
            "license": "MIT", "driven_by": "picture", "default_source": "pattern:harbour",
            "source_encoding": "display",
            "passes": [{"name": "show", "fragment": "show.frag", "inputs": {"scene": "source"}}]}), encoding="utf-8")
        return folder

    def picture(self, look, size, source, *options):
        file = self.folder / "picture.png"
        self.assert_done(run("render", look, *source, "--size", size, "--frames", "3", "-o", file, *options))
        return b"".join(read_png(file)[2])

    def assert_same_picture(self, look, *options, name="export.json", size="161x91",
                            source=("--source", "pattern:harbour")):
        file = self.export(look, *options, name=name)
        ours, theirs = self.picture(look, size, source, *options), self.picture(file, size, source)
        self.assertGreater(len(set(ours)), 30)
        self.assertLessEqual(max(abs(a - b) for a, b in zip(ours, theirs)), 1)
        return file

    def test_looks_and_stacks_draw_the_same_picture(self):
        self.assert_same_picture("shadow-mask", "--preset", "dot-triads", "--set", "mask_size=13")
        self.assert_same_picture("shadow-mask", "--preset", "article")  # texture() reads its mip levels
        self.assert_same_picture("crt+crt", "--set", "crt#2/aberration=3")

    # A table of points, whose light each pixel adds up. The tap-by-tap bloom needs fewer buffers.
    def test_a_beam_draws_the_same_picture(self):
        options = ("--set", "bloom_kind=Taps", "--set", "beam_color=1,0.5,0.2", "--set", "decay=0.8")
        signal = ("--signal", "lissajous:x=5,y=4,points=1000,speed=0.3,weighting=speed")
        file = self.assert_same_picture("phosphor", *signal, *options, source=())
        passes = self.passes(file)
        self.assertEqual([*passes], ["Image", "Buffer A", "Buffer B", "Buffer C", "Buffer D", "Common"])
        self.assertIn("const float signal_x = 5.0;  // @range 1 12", passes["Buffer A"]["code"])
        self.assertEqual(self.parameters(file)["signal_speed"]["default"], 0.3)

    def test_a_sweep_draws_the_same_picture(self):
        self.assert_same_picture("phosphor", "--signal", "am:points=1000,speed=0.7", "--set", "bloom_kind=Taps",
                                 source=(), size="128x72")

    def test_a_preset_of_another_program_draws_the_same_picture(self):
        slang = self.folder / "crt.slangp"
        self.assert_done(run("export", "crt", "--to", "slang", "-o", slang))
        self.assert_same_picture(slang, size="320x240")  # not smaller than its passes

    # Read again, a parameter has the author's range, label and other hints.
    def test_an_isf_file_draws_the_same_picture(self):
        file = self.folder / "own.fs"
        file.write_text("""/*{"ISFVSN": "2", "INPUTS": [{"NAME": "inputImage", "TYPE": "image"},
            {"NAME": "inverse", "TYPE": "bool", "DEFAULT": true}, {"NAME": "r", "TYPE": "float", "DEFAULT": 0.8}]}*/
            vec2 middle = RENDERSIZE * r, scale = 1.0 / middle;
            void main() {
                vec4 color = IMG_NORM_PIXEL(inputImage, isf_FragNormCoord);
                color.r = inverse ? 1.0 - color.r : color.g;
                gl_FragColor = color * length((gl_FragCoord.xy - middle) * scale);
            }
            """, encoding="utf-8")
        self.assert_same_picture(file)

    def test_parameters_are_constants_with_their_annotations(self):
        options = ("--set", "mask_size=7", "--set", "tone_map=ACES", "--set", "dither=off", "--set", "curvature=0.2")
        file = self.export("shadow-mask", *options)
        ours, theirs = self.parameters("shadow-mask", *options), self.parameters(file)
        kept = ("label", "unit", "group", "help", "min", "max", "items", "when")
        for name in ("mask_size", "tone_map", "dither", "curvature", "exposure"):
            self.assertEqual(theirs[name]["default"], ours[name]["value"], name)
            for key in kept:
                self.assertEqual(theirs[name].get(key), ours[name].get(key), f"{name}: {key}")
        self.assertEqual([theirs[f"red_offset_{axis}"]["default"] for axis in "xy"], [-2, 0])
        self.assertEqual(theirs["tint_g"]["label"], "Tint, green")
        tube = self.passes(file)["Buffer B"]["code"]
        self.assertIn("const float mask_size = 7.0;      // @range 2 32  @limit 0.5 256  @label \"Pitch\"", tube)
        # Two passes read it.
        self.assertIn("const float curvature = 0.2;  // @range 0 0.3", self.passes(file)["Common"]["code"])

    def test_buffers_and_channels_are_those_of_the_site(self):
        passes = self.passes(self.export("shadow-mask"))
        self.assertEqual([*passes], ["Image", "Buffer A", "Buffer B", "Buffer C", "Buffer D", "Common"])
        self.assertEqual([entry["outputs"][0]["id"] for entry in passes.values() if entry["outputs"]],
                         ["4dfGRr", "4dXGR8", "XsXGR8", "4sXGR8", "XdfGR8"])
        reads = {name: [(i["channel"], i["type"], i["id"]) for i in entry["inputs"]] for name, entry in passes.items()}
        self.assertEqual(reads["Buffer B"], [(0, "webcam", "4sf3zr"), (1, "buffer", "4dXGR8")])
        self.assertEqual(reads["Buffer C"], [(0, "buffer", "XsXGR8")])
        self.assertEqual(passes["Buffer C"]["inputs"][0]["sampler"]["filter"], "mipmap")
        for entry in passes.values():
            for read in entry["inputs"]:
                self.assertEqual((read["type"], read["src"]), (read["ctype"], read["filepath"]))

    def test_the_author_s_text_stays(self):
        passes = self.passes(self.export("shadow-mask"))
        self.assertIn("// Distance from one red to the next, px.\nfloat mask_pitch() {\n", passes["Buffer B"]["code"])
        self.assertIn("// Licence: MIT\n", passes["Image"]["code"])

    def test_hostile_text_stays_text_also_when_it_is_exported_again(self):
        look = self.look("*/ ' \\\\ #error no")
        first = self.assert_same_picture(look, "--set", "gain=0.5")
        info = json.loads(first.read_text(encoding="utf-8"))["info"]
        self.assertEqual((info["username"], info["description"]), ("A. Nyone", "*/ \" \\\n\t'"))
        code = self.passes(first)["Image"]["code"]
        self.assertIn('// A comment with */ and "quotes".\n', code)
        self.assertIn('const float gain = 0.5; // @label "*/ \' \\\\ #error no" @range 0 2\n', code)
        again = self.assert_same_picture(first, name="again.json")
        self.assertEqual(self.parameters(again)["gain"]["default"], 0.5)
        self.assertEqual(self.parameters(again)["gain"]["label"], "*/ ' \\ #error no")

    def test_what_shadertoy_lacks_is_refused_before_anything_is_written(self):
        file = self.folder / "a.json"
        self.assert_refused(run("export", "vector-beam", "--to", "shadertoy", "-o", file), "draws a beam", "--to web")
        self.assert_refused(run("export", "phosphor", "--set", "tube=P7", "--to", "shadertoy", "-o", file),
                            "needs 5 buffers, one for the points of the beam")
        self.assert_refused(run("export", "phosphor", "--signal", "text:HELLO", "--to", "shadertoy", "-o", file),
                            "the signal 'text'", "--to web")
        self.assert_refused(run("export", "shadow-mask+crt", "--to", "shadertoy", "-o", file), "needs 6 buffers")
        self.assert_refused(run("export", "crt", "--to", "shadertoy", "-o", self.folder / "a.txt"), ".json")
        self.assert_refused(run("export", "crt", "--to", "shadertoy", "-o", self.folder / "look.json"), "another name")
        self.assertEqual(list(self.folder.iterdir()), [])


if __name__ == "__main__":
    main()
