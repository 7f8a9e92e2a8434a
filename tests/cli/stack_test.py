"""Stacks of looks on the command line: looks in series."""

import json

from program import ProgramTest, main, read_png, run

GAIN = """#version 410 core
uniform sampler2D image;
uniform float gain = 0.5;  // @range 0 2
uniform float PARAMETER = 0.0;
in vec2 uv;
out vec4 color;
void main() { color = texture(image, uv) * gain + PARAMETER; }
"""


class Stacks(ProgramTest):
    def setUp(self):
        super().setUp()
        for name, parameter in (("half", "lift"), ("tone", "shift")):
            self.write(f"data/shaders/{name}/look.json", json.dumps({
                "format": "afterglow-look", "version": 1, "name": name.title(), "driven_by": "picture",
                "default_source": "pattern:white", "source_encoding": "display", "license": "MIT",
                "passes": [{"name": "show", "fragment": "show.frag", "format": "rgba32f",
                            "inputs": {"image": "source"}}]}))
            self.write(f"data/shaders/{name}/show.frag", GAIN.replace("PARAMETER", parameter))

    def lab(self, *arguments):
        return run("--data", self.folder / "data", *arguments)

    def level(self, *arguments):
        """The value of the pixel at the centre, 0..1 in steps of 1/255."""
        self.assert_done(self.lab("render", *arguments, "--size", "8x8", "-o", self.folder / "x.png"))
        return read_png(self.folder / "x.png")[2][4][12] / 255

    def test_every_command_takes_a_stack(self):
        self.assertIn("parameters: 4)", self.lab("check", "half+tone").stdout)
        told = json.loads(self.lab("describe", "half+tone", "--json", "--set", "lift=0.25").stdout)
        self.assertEqual([one["name"] for one in told["passes"]], ["half/show", "tone/show"])
        self.assertEqual(told["passes"][1]["inputs"][0]["from"], "half/show")
        self.assertEqual(told["passes"][1]["rename"]["gain"], "tone/gain")
        values = {one["name"]: one["value"] for one in told["parameters"]}
        self.assertEqual(values, {"half/gain": 0.5, "half/lift": 0.25, "tone/gain": 0.5, "tone/shift": 0})
        bench = json.loads(self.lab("bench", "half+half", "--size", "8x8", "--frames", "1", "--json").stdout)
        self.assertEqual([one["name"] for one in bench["passes"]], ["half/show", "half#2/show"])

    def test_the_picture_goes_from_look_to_look(self):
        self.assertAlmostEqual(self.level("half"), 0.5, delta=0.002)
        self.assertAlmostEqual(self.level("half+tone"), 0.25, delta=0.002)
        self.assertAlmostEqual(self.level("half+tone+half", "--set", "shift=0.5", "--set", "half#2/gain=1"), 0.75, delta=0.002)
        self.assertAlmostEqual(self.level("half+tone", "--pass", "half/show"), 0.5, delta=0.002)

    def test_a_preset_of_a_stack_is_made_listed_and_opened(self):
        file = self.folder / "data/presets/half+half/quiet.json"
        file.parent.mkdir(parents=True)
        self.assert_done(self.lab("preset", "half+half", "--set", "half#2/gain=0.25", "-o", file))
        made = json.loads(file.read_text())
        self.assertEqual((made["look"], made["values"]), ("half+half", {"half#2/gain": 0.25}))
        listed = json.loads(self.lab("list", "presets", "--json").stdout)
        self.assertEqual([(one["look"], one["id"]) for one in listed], [("half+half", "quiet")])
        self.assert_done(self.lab("sheet", "half+half", "--size", "48x27", "-o", self.folder / "sheet.png"))
        greys = [max(row) for row in read_png(self.folder / "sheet.png")[2]]
        self.assertEqual(greys.count(32), 27)  # half of a quarter
        self.assertAlmostEqual(self.level("half+half", "--preset", "quiet"), 0.125, delta=0.002)
        line = self.lab("preset", file, "--line").stdout.strip()
        self.assertAlmostEqual(self.level(line), 0.125, delta=0.002)

        file.write_text(json.dumps(dict(made, bypass=["half"])))
        self.assertAlmostEqual(self.level("half+half", "--preset", "quiet"), 0.25, delta=0.002)
        self.assertIn('"bypass": ["half"]', self.again(file))
        file.write_text(json.dumps(dict(made, bypass=["half#3"]), indent=1))
        self.assert_refused(self.lab("render", file, "-o", self.folder / "x.png"), "quiet.json:", "unknown look 'half#3'")

    def again(self, file):
        self.assert_done(self.lab("preset", file, "-o", self.folder / "again.json"))
        return (self.folder / "again.json").read_text()

    def test_mistakes_in_a_stack_are_named(self):
        out = ("--size", "8x8", "-o", self.folder / "x.png")
        self.assert_refused(self.lab("render", "half+tones", *out), "no look called 'tones'", "did you mean 'tone'")
        self.assert_refused(self.lab("render", "half+", *out), "LOOK+LOOK")
        self.assert_refused(self.lab("render", "half+tone", "--set", "gain=1", *out), "half/gain, tone/gain")
        self.assert_refused(self.lab("render", "half+tone", "--pass", "show", *out), "half/show, tone/show")
        self.write("data/shaders/tone/show.frag", GAIN.replace("PARAMETER", "shift").replace("gain +", "gian +"))
        self.assert_refused(self.lab("check", "half+tone"), "tone/show.frag:7: error:", "gian")


if __name__ == "__main__":
    main()
