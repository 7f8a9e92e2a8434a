#!/usr/bin/env python3
"""Looks as effects of ReShade: what the files contain, pictures that vkBasalt draws, and bad input.

reshade_export_test.py PROGRAM SHOW_PICTURE
"""
import configparser
import json
import re
import sys
import unittest

from program import SOURCE, ProgramTest, main, read_png, run

SHOW_PICTURE = sys.argv.pop(1) if len(sys.argv) > 1 else ""
sys.path.insert(0, str(SOURCE / "tests" / "reshade"))

import vkbasalt

UNIFORM = re.compile(r"^uniform (\w+) (\w+) < (.*) > = (.*);$", re.MULTILINE)
ANNOTATION = re.compile(r'(\w+) = ("(?:[^"\\]|\\.)*"|[^;]*); ?')
SIZE = (320, 180)
HOSTILE = '*/ "; } \\" #error \\'


class ReshadeExportTest(ProgramTest):
    def export(self, look, *options, name="look.fx"):
        file = self.folder / name
        self.assert_done(run("export", look, "--to", "reshade", "-o", file, *options))
        return file

    def uniforms(self, file):
        """Type, value and annotations of each parameter."""
        return {name: (kind, value, dict(ANNOTATION.findall(annotations)))
                for kind, name, annotations, value in UNIFORM.findall(file.read_text(encoding="utf-8"))}

    def look(self, name="own", about="A look.", shader=None, inputs=None):
        folder = self.folder / name
        folder.mkdir()
        (folder / "show.frag").write_text(shader or (
            "#version 410 core\nin vec2 uv;\nout vec4 color;\nuniform sampler2D scene;\n"
            "uniform float gain = 0.5;  // @label \"*/ '; } #error\" @range 0 2\n"
            'uniform int level = 1;  // @items "Low" "2 high */" "Top"\n'
            "uniform vec3 tint = vec3(1.0, 0.5, 0.25);  // @color\n"
            "uniform bool is_green = false;\n"
            "struct Mix { float gain; vec3 tint; };\n"
            "const float weights[3] = float[3](0.25, 0.5, 0.25);\n"
            "void main() {\n"
            "    Mix mixed = Mix(gain * float(level), is_green ? vec3(0.0, 1.0, 0.0) : tint);\n"
            "    vec3 sum = vec3(0.0);\n"
            "    int i = 0;\n"
            "    while (i < 3) { sum += weights[i] * texelFetch(scene, ivec2(gl_FragCoord.xy), 0).rgb; ++i; }\n"
            "    vec4 near = textureGather(scene, uv, 1);\n"
            "    sum += 0.001 * mod(near.x + near.w, 1.0);\n"
            "    color = vec4(sum * mixed.gain * mixed.tint, 1.0);\n}\n"), encoding="utf-8")
        (folder / "look.json").write_text(json.dumps({
            "format": "afterglow-look", "version": 1, "name": name, "about": about, "author": "A. Nyone",
            "license": "MIT", "driven_by": "picture", "default_source": "pattern:harbour",
            "source_encoding": "display",
            "passes": [{"name": "pass", "fragment": "show.frag", "inputs": inputs or {"scene": "source"}}]}),
            encoding="utf-8")
        return folder

    def picture(self, look, *options):
        """The RGB bytes of frame 3."""
        file = self.folder / "picture.png"
        size = "x".join(map(str, SIZE))
        self.assert_done(run("render", look, "--size", size, "--frames", "3", "-o", file, *options))
        return b"".join(read_png(file)[2])

    def assert_drawn(self, look, *options, settings=None):
        """vkBasalt draws the same picture: at most 2/255 in 99.9 % of the pixels."""
        source = self.folder / "source.png"
        if not source.exists():
            shown = self.picture("crt", "--set", "crt=off", "--source", "pattern:harbour")
            (self.folder / "picture.png").rename(source)
        shown = b"".join(read_png(source)[2])
        effect = self.export(look)
        vkbasalt.define(effect, frame_rate=60, source_lines=0)
        conf = self.folder / "look_reshade" / "vkBasalt.conf"
        text = conf.read_text(encoding="utf-8")
        for name, value in (settings or {}).items():
            text, count = re.subn(rf"(?m)^{name} = .*$", f"{name} = {value}", text)
            self.assertEqual(count, 1, name)
        conf.write_text(text, encoding="utf-8")
        theirs = vkbasalt.show(SHOW_PICTURE, conf, SIZE, shown, 3)
        ours = self.picture(look, "--source", source, *options)
        self.assertNotEqual(ours, shown)
        wrong = sum(max(abs(a - b) for a, b in zip(ours[i:i + 3], theirs[i:i + 3])) > 2
                    for i in range(0, len(ours), 3))
        self.assertLessEqual(wrong, 0.001 * SIZE[0] * SIZE[1])

    @unittest.skipIf(vkbasalt.missing(SHOW_PICTURE), vkbasalt.missing(SHOW_PICTURE))
    def test_vkbasalt_draws_the_same_picture_with_the_values_of_its_settings(self):
        self.assert_drawn("shadow-mask", "--set", "dither=off", "--set", "scanline_strength=0.4",
                          settings={"look_dither": "false", "look_scanline_strength": "0.4"})
        self.assert_drawn(self.look(about=HOSTILE + "\n#error no \\"), "--set", "level=2", "--set", "gain=0.25",
                          settings={"look_level": "2", "look_gain": "0.25"})

    def test_parameters_are_uniforms_with_their_present_values(self):
        uniforms = self.uniforms(self.export("crt", "--set", "exposure=2.5", "--set", "tone_map=ACES", "--set",
                                             "dither=off"))
        kind, value, annotations = uniforms["look_exposure"]
        self.assertEqual((kind, float(value)), ("float", 2.5))
        self.assertEqual({name: float(annotations[name]) for name in ("ui_min", "ui_max", "ui_step")},
                         {"ui_min": 0.1, "ui_max": 16, "ui_step": 0.1})
        self.assertEqual((annotations["ui_label"], annotations["ui_type"], annotations["ui_category"]),
                         ('"Exposure"', '"slider"', '"Tone mapping"'))
        self.assertIn("Brightness before tone mapping", annotations["ui_tooltip"])
        self.assertEqual(uniforms["look_dither"][:2], ("bool", "false"))
        kind, value, annotations = uniforms["look_tone_map"]
        self.assertEqual((kind, value, annotations["ui_type"]), ("int", "2", '"combo"'))
        self.assertEqual(annotations["ui_items"].strip('"').split("\\0")[2], "ACES")

    def test_colours_are_vectors_and_lists_are_indices(self):
        uniforms = self.uniforms(self.export(self.look()))
        self.assertEqual(uniforms["look_tint"][:2], ("float3", "float3(1.0, 0.5, 0.25)"))
        self.assertEqual(uniforms["look_tint"][2]["ui_type"], '"color"')
        self.assertEqual(uniforms["look_level"][:2], ("int", "1"))
        self.assertEqual(uniforms["look_level"][2]["ui_items"], '"Low\\0 2 high */\\0Top\\0"')

    # ReShade itself was not tried.
    def test_the_preset_has_all_values(self):
        self.export(self.look())
        parser = configparser.ConfigParser()
        parser.optionxform = str
        text = (self.folder / "look_reshade" / "look.ini").read_text(encoding="utf-8")
        parser.read_string("[all]\n" + text)
        self.assertEqual(parser["all"]["Techniques"], "Afterglow_look@look.fx")
        self.assertEqual(dict(parser["look.fx"]), {"look_gain": "0.5", "look_level": "1", "look_tint": "1,0.5,0.25",
                                                   "look_is_green": "0"})

    def test_settings_of_vkbasalt_are_scalars(self):
        self.export(self.look())
        text = (self.folder / "look_reshade" / "vkBasalt.conf").read_text(encoding="utf-8")
        settings = dict(re.findall(r"(?m)^(\w+) = (.*)$", text))
        self.assertEqual(settings["effects"], "Afterglow_look")
        self.assertEqual(settings["Afterglow_look"], f'"{self.folder.resolve() / "look.fx"}"')
        self.assertEqual({name: value for name, value in settings.items() if name.startswith("look_")},
                         {"look_gain": "0.5", "look_level": "1", "look_is_green": "false"})

    def test_the_user_can_state_the_lines_and_the_place_of_the_picture(self):
        text = self.export("crt").read_text(encoding="utf-8")
        settings = dict(re.findall(r"#ifndef AFTERGLOW_(\w+)\n    #define AFTERGLOW_\w+ (\d+)", text))
        self.assertEqual(settings, {"SOURCE_LINES": "240", "SOURCE_COLUMNS": "0", "CONTENT_LEFT": "0",
                                    "CONTENT_TOP": "0", "CONTENT_WIDTH": "0", "CONTENT_HEIGHT": "0",
                                    "FRAME_RATE": "0"})

    def test_the_head_has_author_and_licence(self):
        text = self.export(self.look()).read_text(encoding="utf-8")
        self.assertIn("// Author: A. Nyone\n// Licence: MIT\n", text)
        self.assertIn("show.frag", text)

    def test_what_reshade_can_not_do_is_refused_with_an_alternative(self):
        wide = self.look("wide", shader=(
            "#version 410 core\nin vec2 uv;\nout vec4 color;\nuniform sampler2D scene;\n"
            "uniform float gain = 1.0;\n"
            "void main() { mat2x3 m = mat2x3(gain); color = vec4(m * texture(scene, uv).rg, 1.0); }\n"))
        for look, words in (("vector-beam", ["draws a beam", "--to web"]),
                            (wide, ["'pass'", "matrices that are not square", "--to web or --to slang"])):
            before = sorted(self.folder.iterdir())
            for options in (["-o", self.folder / "a.fx"], ["--dry-run"]):
                self.assert_refused(run("export", look, "--to", "reshade", *options), *words)
            self.assertEqual(sorted(self.folder.iterdir()), before)

    def test_nothing_is_half_written(self):
        self.assert_refused(run("export", "crt", "--to", "reshade", "-o", self.folder / "a.txt"), ".fx")
        (self.folder / "mine_reshade").mkdir()
        (self.folder / "mine_reshade" / "own.png").write_text("mine", encoding="utf-8")
        self.assert_refused(run("export", "crt", "--to", "reshade", "-o", self.folder / "mine.fx"),
                            "own.png", "isn't part of an earlier export")
        broken = self.look("broken", shader="#version 410 core\nvoid main() { oops }\n")
        self.assert_refused(run("export", broken, "--to", "reshade", "-o", self.folder / "b.fx"), "show.frag:2")
        self.assertFalse((self.folder / "b.fx").exists())
        self.assert_refused(run("export", "crt", "--to", "reshade", "-o", self.folder / 'a"b.fx'),
                            "vkBasalt", "another name")

    def test_afterglow_says_that_it_can_not_verify_an_effect(self):
        done = run("export", "crt", "--to", "reshade", "-o", self.folder / "a.fx", "--verify")
        self.assertEqual(done.returncode, 1)
        self.assertIn("not verified: ", done.stdout)


if __name__ == "__main__":
    main()
