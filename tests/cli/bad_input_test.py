"""Broken, missing, huge and hostile files: one clear diagnostic, the exit code, no lost data."""

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
    """Each broken look has its own folder, so that one `check` reads all looks of a test."""

    def setUp(self):
        super().setUp()
        self.bad = []  # folder, words that the message must contain
        self.addCleanup(lambda: self.assertEqual(self.bad, [], "check_refused() was not called"))

    def look(self, text=None, **files):
        look = self.folder / f"look{len(self.bad)}"
        shutil.rmtree(look, ignore_errors=True)
        self.write(look / "look.json", manifest() if text is None else text)
        self.write(look / "only.frag", FRAGMENT)
        for name, content in files.items():
            self.write(look / name.replace("__", "."), content)
        return look

    def refuse(self, *words, text=None, **files):
        self.bad.append((self.look(text, **files), words))
        return self.bad[-1][0]

    def check_refused(self):
        """`check` refuses each look with its words, and `render` refuses the last one."""
        done = run("check", *(look for look, _ in self.bad))
        self.assert_refused(done)
        self.assertEqual(done.stdout, "")
        for look, words in self.bad:
            lines = [line for line in done.stderr.splitlines() if line.startswith(f"{look}/")]
            self.assertTrue(lines, f"no message about {look}, {words}")
            for word in words:
                self.assertIn(word, "\n".join(lines))
        look, words = self.bad[-1]
        self.assert_refused(run("render", look, "--size", "32x32", "-o", self.folder / "x.png"), *words)
        self.assertFalse((self.folder / "x.png").exists())
        self.bad = []

    def test_the_good_look_is_good(self):
        self.assert_done(run("check", self.look()))

    def test_a_shader_that_glslang_refuses_is_refused_with_file_and_line(self):
        self.refuse("only.frag:5: error:", "undeclared", only__frag=FRAGMENT.replace("uv * gain", "uvv * gain"))
        self.check_refused()

    def test_what_glslang_refuses_is_refused_where_the_driver_would_take_it(self):
        self.refuse("only.frag:5: error:", "the left side must be a variable",
                    only__frag=FRAGMENT.replace("color = ", "(gain > 0.0 ? color : color) = "))  # Mesa accepts this
        self.check_refused()

    def test_what_only_the_driver_refuses_is_told_in_the_authors_file_and_line(self):
        look = self.look(only__frag=FRAGMENT.replace("in vec2", '#include "part.glsl"\nin vec2'),
                         part__glsl="float one() {\n    return 1;\n}\n")  # not converted to float before GLSL 4.20
        self.assert_done(run("check", look))
        self.assert_refused(run("render", look, "--size", "32x32", "-o", self.folder / "x.png"),
                            "part.glsl:2: error: graphics driver: ")

    def test_a_mistake_in_an_include_is_reported_in_the_include(self):
        self.refuse("part.glsl:2: error:", only__frag=FRAGMENT.replace("in vec2", '#include "part.glsl"\nin vec2'),
                    part__glsl="float half_of(float x) {\n    return x * ; }\n")
        look = self.refuse("only.frag:3: error:", "is a folder",
                           only__frag=FRAGMENT.replace("in vec2", '#include "sub.glsl"\nin vec2'))
        (look / "sub.glsl").mkdir()
        self.check_refused()

    def test_a_cycle_of_includes_is_named(self):
        self.refuse("a.glsl", "b.glsl", only__frag=FRAGMENT.replace("in vec2", '#include "a.glsl"\nin vec2'),
                    a__glsl='#include "b.glsl"\n', b__glsl='#include "a.glsl"\n')
        self.check_refused()

    def test_includes_stay_inside_their_folders(self):
        (self.folder / "secret.glsl").write_text("float secret = 1.0;\n")
        (self.folder / "secret").write_text("float secret = 1.0;\n")
        for name in ("../secret.glsl", str(self.folder / "secret.glsl")):
            self.refuse("only.frag:3: error:", only__frag=FRAGMENT.replace("in vec2", f'#include "{name}"\nin vec2'))
        look = self.refuse("only.frag:3: error:", only__frag=FRAGMENT.replace("in vec2", '#include "link.glsl"\nin vec2'))
        os.symlink(self.folder / "secret", look / "link.glsl")  # not named like a shader file
        self.check_refused()

    def test_paths_of_a_look_stay_inside_its_folder(self):
        for path in ("../only.frag", "/etc/passwd"):
            self.refuse("look.json:", text=manifest(passes=[{"name": "only", "fragment": path}]))
        self.check_refused()

    def test_a_misspelt_hint_is_reported_on_its_line(self):
        self.refuse("only.frag:2: error:", "@rnage", only__frag=FRAGMENT.replace("@range", "@rnage"))
        self.check_refused()

    def test_an_unknown_key_is_reported_on_its_line(self):
        text = manifest(settle_frams=3)
        line = 1 + text[:text.index("settle_frams")].count("\n")
        self.refuse(f"look.json:{line}: error:", "did you mean 'settle_frames'", text=text)
        self.check_refused()

    def test_broken_manifests(self):
        whole = manifest()
        for text in ("", "   ", "[]", "nul", whole[:-3], whole + "}", "\0\1\2" * 100, '{"a":' * 5000):
            self.refuse("look.json", text=text)
        self.refuse("version", text=manifest(version=99))
        self.refuse("format", text=manifest(format="other"))
        self.check_refused()

    def test_missing_and_unreadable_files(self):
        (self.refuse("only.frag") / "only.frag").unlink()
        for make in (os.mkdir, os.mkfifo, lambda file: os.symlink("/dev/zero", file),
                     lambda file: os.symlink(file, file)):
            file = self.refuse("only.frag") / "only.frag"
            file.unlink()
            make(file)
        self.check_refused()
        self.assert_refused(run("check", self.folder / "none"), "none")

    def test_pictures_of_a_look_are_read(self):
        with_image = {"images": {"lut": "lut.png"},
                      "passes": [{"name": "only", "fragment": "only.frag", "inputs": {"image": "lut"}}]}
        on_picture = {"driven_by": "picture", "default_source": "lut.png"}
        shader = FRAGMENT.replace("in vec2", "uniform sampler2D image;\nin vec2").replace("uv * gain", "texture(image, uv).rg")
        for changes, text in ((with_image, shader), (on_picture, FRAGMENT)):
            for content in (b"", b"\x89PNG\r\n\x1a\n", b"hello"):
                self.refuse("lut.png: error:", text=manifest(**changes), only__frag=text, lut__png=content)
        self.refuse("size=0x0",
                    text=manifest(driven_by="picture", default_source="pattern:smpte,size=0x0"))
        self.check_refused()

    def test_binary_and_huge_shaders(self):
        self.refuse("only.frag", only__frag=os.urandom(4096))
        self.refuse("only.frag", only__frag="//" + "x" * (17 << 20))
        self.refuse("only.frag", only__frag="")
        self.refuse("only.frag", only__frag=FRAGMENT.replace("uv * gain", "(" * 20000 + "uv" + ")" * 20000))
        self.check_refused()

    def test_shaders_that_would_take_the_driver_too_long_are_refused_with_the_limit(self):
        main = "in vec2 uv;\nout vec4 color;\nvoid main() { %s color = vec4(uv, 0.0, 1.0); }\n"
        calls = "float f0(float x) { return x * 2.0; }\n" + "".join(
            f"float f{i}(float x) {{ return f{i - 1}(x) + f{i - 1}(x); }}\n" for i in range(1, 30))
        structs = "struct S0 { float x; };\n" + "".join(
            f"struct S{i} {{ S{i - 1} a, b; }};\n" for i in range(1, 30))
        cases = "".join(f"case {i}: color.x = {i}.0; break;" for i in range(30000))
        for before, body, limit in (
                ("", "float a[1100000000]; a[int(uv.x * 10.0)] = 1.0;", "variable-bytes"),
                ("", "float a[65536]; a[int(uv.x * 10.0)] = 1.0;", "indexed-bytes"),
                (calls, "color.x = f29(uv.x);", "inlined-calls"),
                (structs, "S29 s;", "struct-members"),
                ("".join(f"uniform float u{i};\n" for i in range(4000)), "", "uniforms"),
                ("", "switch (int(uv.x)) { %s }" % cases, "switch-cases")):
            start = time.monotonic()
            self.refuse(f"--limit {limit}=", only__frag="#version 410 core\n" + before + main % body)
            self.assertLess(time.monotonic() - start, 5)
        self.check_refused()

    def test_a_limit_is_raised_on_the_command_line(self):
        cases = "".join(f"case {i}: color.x = {i}.0; break;" for i in range(1300))
        look = self.look(only__frag="#version 410 core\nin vec2 uv;\nout vec4 color;\n"
                         "void main() { color = vec4(1.0); switch (int(uv.x)) { %s } }\n" % cases)
        self.assert_refused(run("check", look), "--limit switch-cases=2560")
        self.assert_done(run("check", look, "--limit", "switch-cases=1300"))
        self.assert_done(run("--limit", "switch-cases=1300", "describe", look, "--json"))
        self.assert_refused(run("check", look, "--limit", "uniforms=5"), "--limit switch-cases=2560")
        self.assert_refused(run("check", look, "--limit", "cases=5"), "unknown limit 'cases'", code=2)
        self.assert_refused(run("check", look, "--limit", "uniforms=none"), "'uniforms' must be a whole number", code=2)

    def test_a_target_too_large_is_refused(self):
        text = manifest(passes=[{"name": "only", "fragment": "only.frag", "scale": 60}])
        self.assert_refused(run("render", self.look(text), "-o", self.folder / "x.png"), "px")


class BadPresets(ProgramTest):
    def test_broken_presets(self):
        good = {"format": "afterglow-preset", "version": 1, "look": "phosphor", "values": {"decay": 0.9}}
        bad = (("", ""), (json.dumps(good)[:-2], ":1: "), (b"\xff\xfe\0\0", ":1: "),
               (json.dumps({**good, "version": 2}), "version"),
               (json.dumps({**good, "look": "../phosphor"}), "../phosphor"),
               (json.dumps({**good, "look": "nowhere"}), "nowhere"),
               (json.dumps({**good, "values": {"decay": [1, 2, 3]}}), "decay"),
               (json.dumps({**good, "values": {"decay": "fast"}}), "decay"))
        files = [self.write(f"p{i}.json", text) for i, (text, _) in enumerate(bad)]
        done = run("check", *files)
        self.assert_refused(done)
        for file, (_, word) in zip(files, bad):
            said = [line for line in done.stderr.splitlines() if line.startswith(f"{file}:")]
            self.assertTrue(any(word in line for line in said), f"{file}, {word}: {said}")
        for command in (("describe", files[-1], "--json"), ("render", "phosphor", "--preset", files[-1], "-o", "x.png")):
            self.assert_refused(run(*command, cwd=self.folder), "p7.json:", "decay")

    def test_content_outside_of_a_presets_folder_is_named_by_the_user(self):
        here, secret = self.folder / "presets", self.folder / "secret.png"
        self.assert_done(run("render", "crt", "--source", "pattern:smpte", "--size", "32x32", "-o", secret))
        def preset(name, source):
            return self.write(here / name, json.dumps({"format": "afterglow-preset", "version": 1, "look": "crt",
                                                       "name": name, "source": source, "values": {}}))
        home = {"XDG_STATE_HOME": str(self.folder / "state")}
        for source in (str(secret), "../secret.png", "./../secret.png,fit=whole", "deep/../../secret.png"):
            words = ("presets/a.json: error: the preset uses content outside its folder: file '", "secret.png'")
            for command in ("render", "describe"):
                more = ("-o", self.folder / "x.png", "--size", "32x32") if command == "render" else ("--json",)
                self.assert_refused(run(command, preset("a.json", source), *more, **home), *words)
        self.assert_done(run("render", preset("a.json", "../secret.png"), "--source", secret, "--size", "32x32",
                             "-o", self.folder / "x.png", **home))
        shutil.copy(secret, here / "inside.png")
        (here / "folder").mkdir()
        shutil.copy(secret, here / "folder/inside.png")
        for source in ("inside.png", "folder/inside.png", str(here / "inside.png"), "pattern:smpte"):
            self.assert_done(run("render", preset("b.json", source), "--size", "32x32", "-o", self.folder / "x.png", **home))

    def test_files_that_a_preset_chooses_outside_of_its_folder_are_named_by_the_user(self):
        look = self.folder / "data/afterglow/shaders/look"
        self.write(look / "look.json", manifest())
        self.write(look / "only.frag", "#version 410 core\nuniform sampler2D picked;\nin vec2 uv;\nout vec4 color;\n"
                   "void main() { color = texture(picked, uv); }\n")
        secret, inside = self.folder / "secret.png", self.folder / "presets/inside.png"
        inside.parent.mkdir()
        self.assert_done(run("render", "crt", "--source", "pattern:smpte", "--size", "32x32", "-o", secret))
        shutil.copy(secret, inside)
        home = {"XDG_STATE_HOME": str(self.folder / "state"), "XDG_DATA_HOME": str(self.folder / "data")}
        def render(path, *more):
            preset = self.write("presets/p.json", json.dumps({
                "format": "afterglow-preset", "version": 1, "look": "look", "name": "p", "values": {"picked": str(path)}}))
            return run("render", preset, *more, "--size", "8x8", "-o", self.folder / "x.png",
                       cwd=self.folder, **home)
        for path in (secret, "../secret.png", "secret.png", "/etc/hostname"):
            self.assert_refused(render(path), "presets/p.json: error: the preset uses content outside its folder: file '", "secret.png" if
                                "secret" in str(path) else "/etc/hostname", "outside its folder", "--set picked=FILE")
        for path, more in ((secret, ("--set", f"picked={inside}")), ("inside.png", ()), (inside, ()),
                           ("pattern:noise", ())):
            self.assert_done(render(path, *more))

    def test_a_socket_of_a_preset_is_made_in_the_runtime_folder_alone(self):
        runtime = self.folder / "run"
        runtime.mkdir()
        place = self.folder / "any.sock"
        def preset(path):
            return self.write("s.json", json.dumps({
                "format": "afterglow-preset", "version": 1, "look": "vector-beam", "name": "s", "values": {},
                "signal": {"kind": "socket", "path": str(path)}}))
        for path in (place, runtime / "other.sock", runtime / "afterglow/../x.sock"):
            self.assert_refused(run("render", preset(path), "--size", "32x32", "-o", self.folder / "x.png",
                                    XDG_RUNTIME_DIR=str(runtime)), "the preset uses content outside its folder: socket '")
            self.assertFalse(path.exists())
        done = run("render", preset(runtime / "afterglow/a.sock"), "--size", "32x32", "--timeout", "0.2",
                   "-o", self.folder / "x.png", XDG_RUNTIME_DIR=str(runtime))
        self.assert_refused(done, "Waiting for a program at %s" % (runtime / "afterglow/a.sock"),
                            "sent no point before the timeout")
        self.assertEqual((runtime / "afterglow").stat().st_mode & 0o777, 0o700)

    def test_a_socket_without_a_path_is_made_where_only_its_user_can_write(self):
        runtime, state = self.folder / "run", self.folder / "state"
        runtime.mkdir()
        preset = self.write("s.json", json.dumps({"format": "afterglow-preset", "version": 1, "look": "vector-beam",
                                                  "name": "s", "values": {}, "signal": {"kind": "socket"}}))
        draw = ("--size", "32x32", "--timeout", "0.1", "-o", self.folder / "x.png")
        for where, place in ((str(runtime), runtime / "afterglow"), ("", state / "afterglow/run")):
            home = {"XDG_RUNTIME_DIR": where, "XDG_STATE_HOME": str(state)}
            for request in (("vector-beam", "--signal", "socket"), (preset,)):
                self.assert_refused(run("render", *request, *draw, **home),
                                    f"Waiting for a program at {place}/afterglow.sock", "before the timeout")
            self.assertEqual(place.stat().st_mode & 0o777, 0o700)
            self.assertEqual(list(place.iterdir()), [])
            place.chmod(0o777)
            self.assert_refused(run("render", preset, *draw, **home), f"{place}: error: other users can write to this folder")
            typed = self.folder / "typed.sock"
            self.assert_refused(run("render", "vector-beam", "--signal", f"socket:{typed}", *draw, **home),
                                f"Waiting for a program at {typed}")

    def test_control_characters_of_a_file_do_not_reach_the_terminal(self):
        bad = self.write("esc.json", '{"format": "afterglow-preset", "version": 1, "look": "crt", '
                         '"a\\u001b[2Jb\\u0000c\\u009b": 1}')
        done = run("render", bad, "-o", self.folder / "x.png")
        self.assert_refused(done, "a\\x1b[2Jb\\x00c\\xc2\\x9b")
        self.assertFalse(set(done.stderr) & set("\x1b\0\x9b"))

    def test_a_stack_has_at_most_64_looks(self):
        self.assert_refused(run("check", "+".join(["crt"] * 20000)), "the stack has 20000 looks; the limit is 64")

    def test_broken_lines(self):
        lines = ("afterglow:", "afterglow:1:", "afterglow:1:!!!!", "afterglow:9:AAAA", "afterglow:1:" + "A" * 5000)
        done = run("check", *lines)
        self.assert_refused(done)
        self.assertEqual(done.stderr.count("error:"), len(lines), done.stderr)
        self.assert_refused(run("describe", lines[-1], "--json"), "error:")


class BadSounds(ProgramTest):
    def test_broken_sounds(self):
        for name, content in (("empty.wav", b""), ("binary.wav", os.urandom(500)), ("short.wav", b"RIFF\xff\xff\xff\x7fWAVE"),
                              ("text.flac", b"hello")):
            file = self.write(name, content)
            self.assert_refused(run("render", "phosphor", "--size", "32x32", "--frames", "1", "--signal",
                                    f"audio:{file}", "-o", self.folder / "x.png"), name)
        self.assert_refused(run("render", "phosphor", "--signal", "audio:none.wav", "-o", self.folder / "x.png"), "none.wav")


class BadDrawings(ProgramTest):
    def refused(self, signal, *words):
        self.assert_refused(run("render", "phosphor", "--size", "32x32", "--frames", "1", "--signal",
                                f"drawing:{signal}", "-o", self.folder / "x.png"), *words)

    def test_a_drawing_that_cannot_be_drawn_is_told(self):
        for text, line, words in (("<svg><desc>hi</desc></svg>", 1, "nothing to draw"),
                                  ("<svg>\n<path d='M0 0L", 2, "not well-formed")):
            file = self.write(self.folder / "bad.svg", text)
            self.refused(file, f"{file}:{line}: error: ", words)
        self.refused("strokes=[L0 0 1]", "stroke 1 of keyframe 1: expected pairs")


class Saving(ProgramTest):
    def test_a_preset_is_the_old_or_the_new_one_whenever_the_program_is_killed(self):
        file = self.folder / "p.json"
        self.assert_done(run("preset", "phosphor", "--set", "decay=0.9", "-o", file))
        for attempt in range(6):
            process = subprocess.Popen([PROGRAM, "preset", "phosphor", "--set", "decay=0.5", "-o", file],
                                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            # The temporary file appears when saving starts. At the end it replaces the preset.
            while attempt and process.poll() is None and not list(self.folder.glob(".afterglow-*")):
                pass
            time.sleep(0.0001 * attempt)
            process.send_signal(signal.SIGKILL)
            process.wait()
            self.assertIn(json.loads(file.read_text())["values"]["decay"], (0.9, 0.5))
            for left in self.folder.glob(".afterglow-*"):
                left.unlink()

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
