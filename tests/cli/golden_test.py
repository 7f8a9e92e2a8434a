"""Golden pictures of a user's folder: the command `golden`."""

import json
import os
import re
import shlex
import unittest

from program import ProgramTest, main, read_png, run

SMALL = ("--size", "32x18")
ISF = """/*{ "ISFVSN": "2", "INPUTS": [{ "NAME": "level", "TYPE": "float", "DEFAULT": 0.5 }] }*/
void main() { gl_FragColor = vec4(vec3(level), 1.0); }
"""


class GoldenTest(ProgramTest):
    def setUp(self):
        super().setUp()
        self.pictures = self.folder / "golden"

    def look(self, name, gray=0.2, settle=4):
        """A look of one gray, with the parameter `gray`."""
        self.write(f"looks/{name}/look.json", json.dumps(
            {"format": "afterglow-look", "version": 1, "name": name, "driven_by": "nothing", "settle_frames": settle,
             "passes": [{"name": "show", "fragment": "show.frag"}]}))
        return self.write(f"looks/{name}/show.frag", "#version 410 core\nuniform float gray = " + str(gray) +
                          ";  // @range 0 1\nout vec4 color;\nvoid main() { color = vec4(vec3(gray), 1.0); }\n")

    def preset(self, file, look, **values):
        return self.write(f"looks/{file}", json.dumps(
            {"format": "afterglow-preset", "version": 1, "look": look, "name": file, "values": values}))

    def golden(self, *arguments, folder="looks"):
        return run("golden", folder, *arguments, cwd=self.folder)

    def results(self, *arguments):
        """The pictures of --json by name, and the exit code."""
        done = self.golden("--json", *arguments)
        document = json.loads(done.stdout)
        self.assertEqual(document["passed"], done.returncode == 0)
        return {picture["name"]: picture for picture in document["pictures"]}, done

    def names(self):
        """The names of all files in the folder of the golden pictures, also hidden ones."""
        return sorted(file.name for file in self.pictures.iterdir())

    def record(self):
        return json.loads((self.pictures / "golden.json").read_text())


class Comparing(GoldenTest):
    def test_a_missing_picture_fails_with_the_command_that_creates_it(self):
        self.look("a", settle=4)
        self.look("b", settle=100)
        self.preset("presets/a/Half Way.json", "a", gray=0.5)
        self.preset("shared/bright.json", "b", gray=1.0)
        self.write("looks/level.fs", ISF)
        self.preset("presets/level.fs/full.json", "level.fs", level=1.0)
        done = self.golden(*SMALL, "--share", "1 %")
        self.assert_refused(done)
        commands = re.findall(r"Create it: (afterglow .*)", done.stdout)
        self.assertEqual(len(commands), 6, done.stdout)
        self.assertEqual(self.names(), ["report.html"])
        self.assert_done(run(*shlex.split(commands[1])[1:], cwd=self.folder))
        self.assertEqual(self.names(), ["a--half-way.png", "golden.json", "report.html"])
        self.assertEqual(read_png(self.pictures / "a--half-way.png")[:2], (32, 18))
        self.assert_done(self.golden("--update"))
        self.assertEqual(self.names(), sorted([
            "a.png", "a--half-way.png", "b.png", "b--bright.png", "level.fs.png", "level.fs--full.png", "golden.json",
            "report.html"]))
        for name, gray in (("a", 51), ("a--half-way", 128), ("b--bright", 255), ("level.fs", 128),
                           ("level.fs--full", 255)):
            self.assertEqual(read_png(self.pictures / f"{name}.png")[2][9][9], gray, name)
        record = self.record()
        self.assertEqual((record["max"], record["share"], record["size"]), ("2/255", "1 %", "32x18"))
        self.assertEqual({name: entry["frames"] for name, entry in record["pictures"].items()},
                         {"a": 4, "a--half-way": 4, "b": 60, "b--bright": 60, "level.fs": 1, "level.fs--full": 1})
        self.assertIn("llvmpipe", record["driver"]["renderer"])
        before = {name: (self.pictures / name).read_bytes() for name in self.names() if name != "report.html"}
        done = self.golden()
        self.assert_done(done)
        self.assertIn("Pictures: 6 (equal: 6)\nReport: golden/report.html\n", done.stdout)
        self.assertEqual(before, {name: (self.pictures / name).read_bytes() for name in before})

    def test_differences_are_measured_against_the_stored_bounds(self):
        self.look("same")
        shader = self.look("moved", 0.2)
        self.assert_done(self.golden(*SMALL, "--update", "--frames", "1"))
        shader.write_text(shader.read_text().replace("vec4(vec3(gray), 1.0)",
                                                     "vec4(vec3(gray + step(gl_FragCoord.x, 8.0) * 10.0 / 255.0), 1.0)"))
        pictures, done = self.results()
        self.assertEqual(done.returncode, 1)
        self.assertEqual(list(pictures), ["moved", "same"])  # the differing one first
        moved = pictures["moved"]
        self.assertEqual((moved["status"], moved["max"], moved["share"]), ("different", 10, 25))
        self.assertAlmostEqual(moved["mean"], 2.5)
        self.assertEqual(moved["command"], "afterglow golden looks --update moved")
        for bounds, code in ((("--max", "10/255"), 0), (("--share", "25 %"), 0), (("--max", "9"), 1)):
            self.assertEqual(self.golden(*bounds).returncode, code, bounds)
        self.assertEqual(self.record()["max"], "2/255")
        self.assert_done(self.golden("--update", "moved", "--max", "1"))
        self.assertEqual(self.record()["max"], "1/255")
        self.assert_done(self.golden())

    def test_a_broken_look_is_named_with_its_line_and_the_others_are_drawn(self):
        self.look("fine")
        shader = self.look("torn")
        preset = self.preset("presets/torn/p.json", "torn", gray=0.9)
        self.assert_done(self.golden(*SMALL, "--update"))
        golden = (self.pictures / "torn.png").read_bytes()
        shader.write_text(shader.read_text() + "oops\n")
        preset.write_text(preset.read_text()[:-3])
        self.look("new")
        for arguments, status in (((), "missing"), (("--update",), "created")):
            pictures, done = self.results(*arguments)
            self.assertEqual(done.returncode, 1)
            self.assertIn("looks/torn/show.frag:5: error: ", done.stderr)
            self.assertIn("looks/presets/torn/p.json:1: error: ", done.stderr)
            self.assertEqual({name: picture["status"] for name, picture in pictures.items()},
                             {"torn": "broken", "torn--p": "broken", "new": status, "fine": "equal"})
        self.assertEqual((self.pictures / "torn.png").read_bytes(), golden)
        self.assertIn("torn--p", self.record()["pictures"])

    def test_orphaned_pictures_and_other_drivers_are_reported(self):
        self.look("a")
        preset = self.preset("p.json", "a", gray=0.9)
        self.assert_done(self.golden(*SMALL, "--update"))
        preset.unlink()
        self.look("b")
        self.write("golden/mine.png", "not ours")
        record = self.record()
        record["driver"]["renderer"] = "Other GPU"
        self.write("golden/golden.json", json.dumps(record))
        self.assert_done(self.golden("--update", "b.png"))
        pictures, done = self.results()
        self.assert_done(done)
        self.assertEqual(pictures["a--p"]["status"], "orphaned")
        self.assertIn("golden/golden.json: warning: 1 golden picture was drawn by another driver: Other GPU", done.stderr)
        self.assert_done(self.golden("--update"))
        self.assertEqual(self.names(), ["a.png", "b.png", "golden.json", "mine.png", "report.html"])
        self.assertEqual(list(self.record()["pictures"]), ["a", "b"])
        self.assertEqual(self.golden().stderr, "")


class Naming(GoldenTest):
    def test_names_are_unique_and_valid_on_every_file_system(self):
        for name in ("x/Crt Look", "y/crt-look", "../looks/only"):
            self.look(name)
        hostile = "<img src=x onerror='alert(1)'>&\"\n"
        self.preset(f"{hostile.replace('/', '')}.json", "only", gray=0.5)
        self.preset("presets/only/ONE.json", "only", gray=0.5)
        self.preset("more/only/one.json", "only", gray=0.5)
        self.assert_done(self.golden(*SMALL, "--update"))
        names = [name for name in self.names() if name.endswith(".png")]
        self.assertEqual(len(names), 6, names)
        self.assertIn("x-crt-look.png", names)
        self.assertIn("y-crt-look.png", names)
        self.assertIn("only--img-src-x-onerror-alert-1.png", names)
        self.assertEqual(len({name.lower() for name in names}), 6)
        self.assertNotRegex("".join(names), r"[^a-z0-9_.+-]")
        html = (self.pictures / "report.html").read_text(encoding="utf-8")
        self.assertNotIn("<img src=x", html)
        self.assertIn("&lt;img src=x onerror=&#39;alert(1)&#39;&gt;&amp;&quot;\\x0a.json", html)


class Reporting(GoldenTest):
    def test_the_report_is_one_file_with_all_pictures(self):
        shader = self.look("moved")
        self.look("same")
        self.assert_done(self.golden(*SMALL, "--update"))
        shader.write_text(shader.read_text().replace("gray = 0.2", "gray = 0.25"))
        self.look("new")
        self.assert_refused(self.golden())
        page = self.pictures / "report.html"
        html = page.read_text(encoding="utf-8")
        self.assertNotRegex(html, r"(?:src|href)\s*=\s*[\"'](?!data:)|https?:")
        entries = re.findall(r'<details class="(\w+)" id="(\w+)"', html)
        self.assertEqual(entries, [("different", "moved"), ("missing", "new"), ("equal", "same")])
        self.assertIn("max 13/255, 100 % of pixels beyond 2/255", html)
        self.assertIn("Difference × 16", html)
        self.assertIn("<code>afterglow golden looks --update moved</code>", html)
        self.assertEqual(len(re.findall(r'src="data:image/png;base64,', html)), 5)


class BadInput(GoldenTest):
    def test_wrong_usage(self):
        self.look("a")
        for arguments, words in ((("--max", "2/256"), "--max: expected a difference from 0/255 to 255/255, got '2/256'"),
                                 (("--share", "-1"), "--share: expected a share from 0 % to 100 %, got '-1'"),
                                 (("--size", "0x0"), "--size: expected WIDTHxHEIGHT"),
                                 (("--frames", "0"), "--frames: expected a whole number from 1 to"),
                                 (("--update", ""), "--update: the value is empty"),
                                 (("looks2",), "unexpected argument 'looks2'")):
            with self.subTest(arguments):
                self.assert_refused(self.golden(*arguments), words, code=2)
        self.assert_refused(run("golden"), "FOLDER is required", code=2)
        self.assertFalse(self.pictures.exists())

    def test_folders_and_files_that_can_not_be_used(self):
        self.look("a")
        self.write("empty/readme.txt", "nothing")
        self.assert_refused(self.golden(folder="gone"), "gone: error: folder not found")
        self.assert_refused(self.golden(folder="empty"), "empty: error: the folder contains no looks and no presets")
        self.assert_refused(self.golden("--update", "b"), "has no look or preset with the picture 'b'")
        self.assert_refused(self.golden("--update", "--dir", "looks/a/look.json"), "isn't a folder")
        self.assert_done(self.golden(*SMALL, "--update"))
        for old, new, words in (('"2/255"', '"many"', "golden.json:4: error: 'max' must be"),
                                ('"a":', '"../a":', "'../a' can't be the name of a golden picture"),
                                ('"version": 1', '"version": 2', "golden.json:3: error: format version 2 is too new")):
            with self.subTest(words):
                text = (self.pictures / "golden.json").read_text()
                self.write("golden/golden.json", text.replace(old, new))
                self.assert_refused(self.golden(), words)
                self.write("golden/golden.json", text)
        self.write("golden/a.png", b"\x89PNG\r\n\x1a\n cut off")
        self.assertIn("different: a: ", self.golden().stdout)

    @unittest.skipIf(os.geteuid() == 0, "root can write everywhere")
    def test_a_folder_that_can_not_be_written(self):
        self.look("a")
        self.pictures.mkdir(mode=0o500)
        self.assert_refused(self.golden("--update"), "golden/report.html: error: ")
        self.assertEqual(self.names(), [])


if __name__ == "__main__":
    main()
