"""Broken, missing, huge and hostile files: one clear diagnostic, the right exit code, nothing lost."""

import json
import os
import shutil
import signal
import subprocess
import time

from program import PROGRAM, SOURCE, ProgramTest, main, run

FRAGMENT = """#version 410 core
uniform float gain = 1.0;  // @range 0 2
in vec2 uv;
out vec4 color;
void main() { color = vec4(uv * gain, 0.0, 1.0); }
"""


def manifest(**changes):
    look = {"format": "afterglow-look", "version": 1, "name": "Test", "driven_by": "nothing",
            "passes": [{"name": "only", "fragment": "only.frag"}]}
    look.update(changes)
    return json.dumps(look, indent=1)


class BadLooks(ProgramTest):
    def look(self, text=None, **files):
        self.write("look/look.json", manifest() if text is None else text)
        self.write("look/only.frag", FRAGMENT)
        for name, content in files.items():
            self.write("look/" + name.replace("__", "."), content)
        return self.folder / "look"

    def refuse(self, *words, text=None, **files):
        """check and render both refuse the look, with these words."""
        look = self.look(text, **files)
        self.assert_refused(run("check", look), *words)
        self.assert_refused(run("render", look, "--size", "32x32", "-o", self.folder / "x.png"), *words)
        self.assertFalse((self.folder / "x.png").exists())

    def test_the_good_look_is_good(self):
        self.assert_done(run("check", self.look()))

    def test_a_shader_that_glslang_refuses_is_refused_with_file_and_line(self):
        self.refuse("only.frag:5: error:", "undeclared", only__frag=FRAGMENT.replace("uv * gain", "uvv * gain"))

    def test_a_mistake_in_an_include_is_reported_in_the_include(self):
        self.refuse("part.glsl:2: error:", only__frag=FRAGMENT.replace("in vec2", '#include "part.glsl"\nin vec2'),
                    part__glsl="float half_of(float x) {\n    return x * ; }\n")

    def test_a_cycle_of_includes_is_named(self):
        self.refuse("a.glsl", "b.glsl", only__frag=FRAGMENT.replace("in vec2", '#include "a.glsl"\nin vec2'),
                    a__glsl='#include "b.glsl"\n', b__glsl='#include "a.glsl"\n')

    def test_includes_stay_inside_their_folders(self):
        (self.folder / "secret.glsl").write_text("float secret = 1.0;\n")
        for name in ("../secret.glsl", str(self.folder / "secret.glsl")):
            self.refuse("only.frag:3: error:", only__frag=FRAGMENT.replace("in vec2", f'#include "{name}"\nin vec2'))
        look = self.look(only__frag=FRAGMENT.replace("in vec2", '#include "link.glsl"\nin vec2'))
        os.symlink(self.folder / "secret.glsl", look / "link.glsl")
        self.assert_refused(run("check", look), "only.frag:3: error:")

    def test_paths_of_a_look_stay_inside_its_folder(self):
        for path in ("../only.frag", "/etc/passwd"):
            self.refuse("look.json:", text=manifest(passes=[{"name": "only", "fragment": path}]))

    def test_a_misspelt_hint_is_reported_on_its_line(self):
        self.refuse("only.frag:2: error:", "@rnage", only__frag=FRAGMENT.replace("@range", "@rnage"))

    def test_an_unknown_key_is_reported_on_its_line(self):
        text = manifest(settle_frams=3)
        line = 1 + text[:text.index("settle_frams")].count("\n")
        self.refuse(f"look.json:{line}: error:", "did you mean 'settle_frames'", text=text)

    def test_broken_manifests(self):
        whole = manifest()
        for text in ("", "   ", "[]", "nul", whole[:-3], whole + "}", "\0\1\2" * 100, '{"a":' * 5000):
            self.refuse("look.json", text=text)
        self.refuse("version", text=manifest(version=99))
        self.refuse("format", text=manifest(format="other"))

    def test_missing_and_unreadable_files(self):
        look = self.look()
        (look / "only.frag").unlink()
        self.assert_refused(run("check", look), "only.frag")
        (look / "only.frag").mkdir()
        self.assert_refused(run("check", look), "only.frag")
        self.assert_refused(run("check", self.folder / "none"), "none")

    def test_binary_and_huge_shaders(self):
        self.refuse("only.frag", only__frag=os.urandom(4096))
        self.refuse("only.frag", only__frag="//" + "x" * (17 << 20))
        self.refuse("only.frag", only__frag="")
        self.refuse("only.frag", only__frag=FRAGMENT.replace("uv * gain", "(" * 20000 + "uv" + ")" * 20000))

    def test_a_target_too_large_is_refused(self):
        text = manifest(passes=[{"name": "only", "fragment": "only.frag", "scale": 60}])
        self.assert_refused(run("render", self.look(text), "-o", self.folder / "x.png"), "px")


class BadPresets(ProgramTest):
    def refuse(self, text, *words):
        file = self.write("p.json", text)
        for command in (("describe", file, "--json"), ("render", "phosphor", "--preset", file, "-o", self.folder / "x.png")):
            self.assert_refused(run(*command), *words)

    def test_broken_presets(self):
        good = {"format": "afterglow-preset", "version": 1, "look": "phosphor", "values": {"decay": 0.9}}
        self.refuse("", "p.json")
        self.refuse(json.dumps(good)[:-2], "p.json:1")
        self.refuse(json.dumps({**good, "version": 2}), "version")
        self.refuse(json.dumps({**good, "values": {"decay": "fast"}}), "decay")
        self.refuse(json.dumps({**good, "values": {"decay": [1, 2, 3]}}), "decay")
        self.refuse(json.dumps({**good, "look": "nowhere"}), "nowhere")
        self.refuse(b"\xff\xfe\0\0", "p.json")

    def test_broken_lines(self):
        for line in ("afterglow:", "afterglow:1:", "afterglow:1:!!!!", "afterglow:9:AAAA", "afterglow:1:" + "A" * 5000):
            result = run("describe", line, "--json")
            self.assert_refused(result)
            self.assertTrue(result.stderr.strip())


class BadSounds(ProgramTest):
    def test_broken_sounds(self):
        for name, content in (("empty.wav", b""), ("binary.wav", os.urandom(500)), ("short.wav", b"RIFF\xff\xff\xff\x7fWAVE"),
                              ("text.flac", b"hello")):
            file = self.write(name, content)
            self.assert_refused(run("render", "phosphor", "--size", "32x32", "--frames", "1", "--signal",
                                    f"audio:{file}", "-o", self.folder / "x.png"), name)
        self.assert_refused(run("render", "phosphor", "--signal", "audio:none.wav", "-o", self.folder / "x.png"), "none.wav")


class Saving(ProgramTest):
    def test_a_preset_is_the_old_or_the_new_one_whenever_the_program_is_killed(self):
        file = self.folder / "p.json"
        self.assert_done(run("preset", "phosphor", "--set", "decay=0.9", "-o", file))
        for attempt in range(12):
            process = subprocess.Popen([PROGRAM, "preset", "phosphor", "--set", "decay=0.5", "-o", file],
                                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            time.sleep(0.01 * attempt)
            process.send_signal(signal.SIGKILL)
            process.wait()
            self.assertIn(json.loads(file.read_text())["values"]["decay"], (0.9, 0.5))

    def test_a_folder_that_cannot_be_written_is_named(self):
        self.assert_refused(run("preset", "phosphor", "-o", "/proc/none/p.json"), "/proc/none")


class DataFolder(ProgramTest):
    def test_another_data_folder_is_used(self):
        shutil.copytree(SOURCE / "shaders", self.folder / "shaders")
        shutil.move(self.folder / "shaders/phosphor", self.folder / "shaders/mine")
        self.assert_done(run("check", "mine", "--data", self.folder))
        self.assert_done(run("check", "mine", AFTERGLOW_DATA=str(self.folder)))
        self.assert_refused(run("check", "phosphor", "--data", self.folder), "phosphor")
        self.assert_refused(run("check", "phosphor", "--data", "/none"), "/none")


if __name__ == "__main__":
    main()
