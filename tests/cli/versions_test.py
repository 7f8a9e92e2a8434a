"""Files that earlier versions wrote still open: tests/inputs/versions/."""

import json
import shutil

from program import SOURCE, ProgramTest, main, read_png, run

VERSIONS = SOURCE / "tests/inputs/versions"


class Versions(ProgramTest):
    """Each folder has one file per format, as that version wrote it."""

    def setUp(self):
        super().setUp()
        for kind in ("DATA", "STATE", "CACHE"):
            (self.folder / kind).mkdir()
        self.folders = {f"XDG_{kind}_HOME": str(self.folder / kind) for kind in ("DATA", "STATE", "CACHE")}
        self.folders["XDG_DATA_HOME"] = str(self.folder / "DATA")

    def at(self, *arguments):
        done = run(*arguments, **self.folders)
        self.assert_done(done)
        self.assertNotIn("warning", done.stderr)
        return done.stdout

    def picture(self, *arguments):
        self.at("render", *arguments, "--size", "64x36", "--frames", "3", "-o", self.folder / "x.png")
        return read_png(self.folder / "x.png")

    def test_looks_presets_lines_pictures_packs_and_scenes_open(self):
        versions = sorted(VERSIONS.iterdir())
        self.assertTrue(versions)
        for version in versions:
            with self.subTest(version.name):
                self.at("pack", "--install", version / "glow.afterglow")
                expected = self.picture("glow", "--preset", "cold")
                line = (version / "line.txt").read_text().split()[-1]
                self.assertEqual(self.picture(line), expected)
                self.assertEqual(self.picture(version / "cold.png"), expected)
                self.assertEqual(self.picture(version / "presets/cold.json"), expected)
                width, height, rows = read_png(version / "cold.png")  # as that version drew it
                self.assertLessEqual(max(abs(a - b) for one, two in zip(rows, expected[2]) for a, b in zip(one, two)), 2)
                shutil.rmtree(self.folder / "DATA/afterglow")
                self.at("check", version / "looks/glow")
                self.picture(version / "presets/stack.json")
                self.picture("vector-beam", "--signal", f"scene:{version / 'scene.json'}")

    def test_golden_pictures_are_compared_by_the_stored_bounds(self):
        for version in VERSIONS.iterdir():
            golden = self.folder / "golden"
            self.at("golden", version / "looks", "--dir", golden, "--update", "--size", "64x36", "--frames", "3")
            shutil.copy(version / "golden.json", golden)
            compared = json.loads(run("golden", version / "looks", "--dir", golden, "--json", **self.folders).stdout)
            self.assertTrue(compared["passed"], compared)
            self.assertEqual(compared["pictures"][0]["size"], "64x36")


main()
