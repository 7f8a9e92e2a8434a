"""Looks exported for other programs: docs/portable.md."""

import json
import zipfile
import os
import shutil
import subprocess
import unittest
import wave

from program import ProgramTest, main, run

LOOKS = ("phosphor", "crt", "shadow-mask", "vector-beam", "caffeine", "phosphor+crt")
CREDITS = """// SPDX-License-Identifier: CC0-1.0
// Written by A. Person
#version 410 core
out vec4 color;
uniform float level = 0.5;  // @range 0 1 @label "</script>\\"Level"
void main() { color = vec4(level); }
"""


class PortableTest(ProgramTest):
    def export(self, look, *options):
        folder = self.folder / "exported"
        self.assert_done(run("export", look, "--to", "portable", "-o", folder, *options))
        return folder, json.loads((folder / "portable.json").read_text())

    def look(self, name, text=CREDITS, **keys):
        self.write(f"{name}/look.json", json.dumps(
            {"format": "afterglow-look", "version": 1, "name": name, "driven_by": "nothing",
             "passes": [{"name": "show", "fragment": "show.frag"}], **keys}))
        self.write(f"{name}/show.frag", text)
        return self.folder / name

    def paths(self, document):
        """All paths that a document names."""
        for item in document["passes"]:
            yield from (item["vertex"], item["fragment"])
        for image in document["images"]:
            yield from image.get("faces", [image["file"]] if "file" in image else [])

    def test_every_look_names_only_files_of_its_folder_and_all_its_passes(self):
        for look in LOOKS:
            with self.subTest(look):
                folder, document = self.export(look)
                described = json.loads(run("describe", look, "--json").stdout)
                self.assertEqual([p["name"] for p in document["passes"]], [p["name"] for p in described["passes"]])
                for passed, known in zip(document["passes"], described["passes"]):
                    self.assertEqual((folder / passed["fragment"]).read_text(), known["fragment"])
                    self.assertEqual((folder / passed["vertex"]).read_text(), known["vertex"])
                    self.assertEqual(passed["blend"], known["blend"])
                for path in self.paths(document):
                    self.assertFalse(path.startswith("/") or ".." in path, path)
                    self.assertTrue((folder / path).is_file(), path)
                self.assertNotIn(str(self.folder.parent), (folder / "portable.json").read_text())

    @unittest.skipUnless(shutil.which("glslangValidator"), "glslangValidator is not installed")
    def test_another_compiler_accepts_every_shader(self):
        for look in LOOKS:
            folder, document = self.export(look)
            files = [folder / item[stage] for item in document["passes"] for stage in ("vertex", "fragment")]
            checked = subprocess.run(["glslangValidator", *files], capture_output=True, text=True)
            self.assertEqual(checked.returncode, 0, checked.stdout[-2000:])

    @unittest.skipUnless(shutil.which("glslangValidator") and shutil.which("spirv-val"),
                         "glslangValidator or spirv-val is not installed")
    def test_other_compilers_accept_every_stage(self):
        for look in ("phosphor", "crt"):
            folder, document = self.export(look, "--stages")
            files = {"spirv": [], "es": [], "hlsl": []}
            for item in document["passes"]:
                for name, stage in item["stages"].items():
                    self.assertEqual(set(stage["not_compiled"]), {"msl"}, stage)
                    self.assertIn("metal", (folder / stage["msl"]).read_text())
                    reflection = json.loads((folder / stage["reflection"]).read_text())
                    self.assertEqual(reflection["entryPoints"][0]["name"], "main")
                    for language, paths in files.items():
                        paths.append((name, folder / stage[language]))
            for name, file in files["spirv"]:
                self.compile("spirv-val", "--target-env", "vulkan1.0", file)
            for name, file in files["es"]:
                self.compile("glslangValidator", "-S", name[:4], file)
            for name, file in files["hlsl"]:
                self.compile("glslangValidator", "-D", "-V", "-S", name[:4], "-e", "main", "-o", os.devnull, file)

    def compile(self, *command):
        checked = subprocess.run(command, capture_output=True, text=True)
        self.assertEqual(checked.returncode, 0, f"{command}: {checked.stdout[-1000:]}{checked.stderr[-1000:]}")

    def test_an_archive_has_the_same_files_and_is_reproducible(self):
        archives = []
        for name in ("one.zip", "two.zip"):
            self.assert_done(run("export", "vector-beam", "--to", "portable", "-o", self.folder / name))
            archives.append((self.folder / name).read_bytes())
        self.assertEqual(archives[0], archives[1])
        folder, document = self.export("vector-beam")
        with zipfile.ZipFile(self.folder / "one.zip") as archive:
            self.assertIsNone(archive.testzip())
            self.assertEqual(sorted(archive.namelist()),
                             sorted(p.relative_to(folder).as_posix() for p in folder.rglob("*") if p.is_file()))
            self.assertEqual(json.loads(archive.read("portable.json")), document)
        (self.folder / "note.txt").write_text("mine")
        self.assert_refused(run("export", "crt", "--to", "portable", "-o", self.folder / "note.txt" / "y.zip"), "y.zip")

    def test_values_signal_and_source_are_those_of_the_command(self):
        _, document = self.export("phosphor", "--set", "decay=0.5", "--signal", "lissajous:x=3,y=2", "--size", "64x48")
        parameters = {p["name"]: p for p in document["parameters"]}
        self.assertEqual(parameters["decay"]["value"], 0.5)
        self.assertEqual((document["signal"]["kind"], document["signal"]["settings"]["x"]), ("lissajous", 3))
        self.assertEqual(document["size"], [64, 48])
        folder, document = self.export("crt", "--source", "pattern:smpte,fit=whole")
        self.assertEqual(document["source"]["content"], "media/smpte.png,fit=whole")
        self.assertEqual(document["source"]["generated"], "pattern:smpte,fit=whole")
        self.assertTrue((folder / "media/smpte.png").exists())
        _, document = self.export("vector-beam", "--signal", "text:HI")
        item = document["signal"]["paths"]["items"][0]
        self.assertEqual((item["perspective"], len(item["paths"][0]["points"]) % 4), (3, 0))

    def test_media_are_copied_under_safe_names_and_missing_ones_are_named(self):
        song = self.folder / "my song.wav"
        self.write_wav(song)
        folder, document = self.export("phosphor", "--signal", f"audio:{song}")
        copy = document["signal"]["settings"]["file"]
        self.assertEqual(copy, "media/my-song.wav")
        self.assertEqual((folder / copy).read_bytes(), song.read_bytes())
        picture = self.folder / "picture.png"
        self.assert_done(run("render", "crt", "--size", "16x16", "-o", picture))
        folder, document = self.export("crt", "--source", f"{picture},fit=whole")
        self.assertEqual(document["source"]["content"], "media/picture.png,fit=whole,prescaled=auto")
        self.assertEqual((folder / "media/picture.png").read_bytes(), picture.read_bytes())
        filter_file = self.folder / "second.fs"
        filter_file.write_text('/*{"INPUTS": [{"NAME": "inputImage", "TYPE": "image"}, '
                               '{"NAME": "other", "TYPE": "image"}]}*/\n'
                               "void main() { gl_FragColor = IMG_THIS_PIXEL(inputImage) + IMG_THIS_PIXEL(other); }\n")
        _, document = self.export(filter_file)
        self.assertTrue(document["parameters"][0]["generated"].startswith("pattern:"), document["parameters"])
        folder, document = self.export(filter_file, "--set", f"other={picture}")
        self.assertEqual((folder / document["parameters"][0]["value"]).read_bytes(), picture.read_bytes())
        picture.unlink()
        self.assert_refused(run("export", "crt", "--source", picture, "--to", "portable", "-o", self.folder / "new"),
                            "picture.png")
        self.assertFalse((self.folder / "new").exists())

    def write_wav(self, file):
        with wave.open(str(file), "wb") as sound:
            sound.setnchannels(2)
            sound.setsampwidth(2)
            sound.setframerate(8000)
            sound.writeframes(bytes(8000))

    def test_licences_and_authors_of_sources_are_kept(self):
        _, document = self.export(self.look("mine", license="MIT"))
        self.assertEqual(document["license"], "MIT")
        notices = {notice["file"]: notice for notice in document["notices"]}
        self.assertEqual(notices["show.frag"]["license"], "CC0-1.0")
        self.assertIn("Written by A. Person", notices["show.frag"]["text"])
        shutil.rmtree(self.folder / "exported")
        look = self.look("includes", '#version 410 core\n#include "one/a.glsl"\n#include "two/a.glsl"\n' +
                         CREDITS.split("core\n")[1])
        self.write("includes/one/a.glsl", "// SPDX-License-Identifier: MIT\n")
        self.write("includes/two/a.glsl", "// Copyright (c) B. Person\n")
        _, document = self.export(look)
        licenses = {notice["file"]: notice["license"] for notice in document["notices"]}
        self.assertEqual((licenses["one/a.glsl"], licenses["two/a.glsl"]), ("MIT", "see comments"))
        _, document = self.export(self.look("bare", CREDITS.split("Person\n")[1]))
        self.assertEqual({n["license"] for n in document["notices"]}, {"not stated"})

    def test_an_earlier_export_is_replaced_and_nothing_else(self):
        folder, _ = self.export("crt")
        (folder / "shaders/9-stale.frag").write_text("old")
        self.export("crt")
        self.assertFalse((folder / "shaders/9-stale.frag").exists())
        self.assertEqual([p.name for p in self.folder.iterdir()], ["exported"])
        (folder / "player.js").write_text("mine")
        self.assert_refused(run("export", "crt", "--to", "portable", "-o", folder), "player.js", "Move it")
        self.assertEqual((folder / "player.js").read_text(), "mine")
        self.write("notes/mine.txt", "text")
        self.assert_refused(run("export", "crt", "--to", "portable", "-o", self.folder / "notes"), "not an exported look")
        self.assertEqual((self.folder / "notes/mine.txt").read_text(), "text")

    def test_a_look_with_errors_is_not_exported(self):
        broken = self.look("broken", "#version 410 core\nvoid main() { nothing(); }\n")
        self.assert_refused(run("export", broken, "--to", "portable", "-o", self.folder / "new"), "show.frag:2")
        self.assertFalse((self.folder / "new").exists())

    def test_a_dry_run_writes_nothing(self):
        done = run("export", "crt", "--to", "portable", "--dry-run", cwd=self.folder)
        self.assert_done(done)
        self.assertIn("The moving test picture becomes a still picture.", done.stdout)
        self.assertIn("nothing is lost", run("export", "phosphor", "--to", "portable", "--dry-run").stdout)
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_wrong_usage_is_told(self):
        for options, words in ((("--to", "nowhere", "-o", "x"), "Choose from: portable"), (("--to", "portable"), "-o PATH")):
            result = run("export", "crt", *options)
            self.assertEqual(result.returncode, 2)
            self.assertIn(words, result.stderr)


if __name__ == "__main__":
    main()
