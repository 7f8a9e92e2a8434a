"""A look that a signal or a source picture can drive, on the command line."""

import json

from program import ProgramTest, main, read_png, run

SHOWN = """#version 410 core
#ifdef DRIVEN_BY_PICTURE
uniform sampler2D image;
uniform float gain = 0.5;  // @range 0 2
#else
uniform float level = 0.25;  // @range 0 1
#endif
in vec2 uv;
out vec4 color;
void main() {
#ifdef DRIVEN_BY_PICTURE
    color = texture(image, uv) * gain;
#else
    color = vec4(level);
#endif
}
"""


class Drivers(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write_look("either", "signal-or-picture", SHOWN)
        self.write_look("half", "picture", SHOWN.replace("#version 410 core", "#version 410 core\n"
                                                         "#define DRIVEN_BY_PICTURE"))
        self.beam = self.write_preset("either", "beam", values={"level": 0.75},
                                      signal={"kind": "lissajous"})
        self.picture = self.write_preset("either", "picture", values={"gain": 0.4},
                                         source="pattern:white")

    def write_look(self, name, driver, text):
        self.write(f"data/shaders/{name}/look.json", json.dumps({
            "format": "afterglow-look", "version": 1, "name": name.title(), "driven_by": driver,
            "default_source": "pattern:white", "source_encoding": "display", "license": "MIT",
            **({"default_signal": {"kind": "lissajous"}} if driver != "picture" else {}),
            "passes": [{"name": "show", "fragment": "show.frag", "inputs": {
                "image": {"from": "source"} if driver == "picture" else
                         {"from": "source", "driven_by": "picture"}}}]}))
        self.write(f"data/shaders/{name}/show.frag", text)

    def write_preset(self, look, name, **members):
        file = self.folder / f"data/presets/{look}/{name}.json"
        self.write(str(file.relative_to(self.folder)), json.dumps(
            {"format": "afterglow-preset", "version": 1, "look": look, "name": name, **members}))
        return file

    def lab(self, *arguments):
        return run("--data", self.folder / "data", *arguments)

    def level(self, *arguments):
        """The value of the pixel at the centre, 0..1 in steps of 1/255."""
        self.assert_done(self.lab("render", *arguments, "--size", "8x8", "-o", self.folder / "x.png"))
        return read_png(self.folder / "x.png")[2][4][12] / 255

    def test_a_preset_or_an_option_chooses_the_driver(self):
        for expected, arguments in ((0.25, ["either"]), (0.75, [self.beam]), (0.4, [self.picture]),
                                    (0.75, ["either", "--preset", "beam"]),
                                    (0.4, ["either", "--preset", "picture"]),
                                    (0.5, ["either", "--source", "pattern:white"]),
                                    (0.25, ["either", "--signal", "lissajous"]),
                                    (0.5, ["either", "--preset", "beam", "--source", "pattern:white"]),
                                    (0.25, ["either", "--preset", "picture", "--signal", "lissajous"]),
                                    (0.1, ["either", "--source", "pattern:white", "--set", "gain=0.1"])):
            with self.subTest(arguments=arguments):
                self.assertAlmostEqual(self.level(*arguments), expected, delta=0.003)

    def test_in_a_stack_it_stays_a_beam_look_unless_the_preset_has_a_source(self):
        stack = self.write_preset("either+half", "picture", values={"either/gain": 0.4, "half/gain": 1},
                                  source="pattern:white")
        self.assertAlmostEqual(self.level("either+half"), 0.125, delta=0.003)
        self.assertAlmostEqual(self.level(stack), 0.4, delta=0.003)
        self.assertIn("isn't drawn", self.lab("check", "half+either").stderr)

    def test_both_drivers_at_once_are_refused(self):
        self.assert_refused(self.lab("render", "either", "--source", "pattern:white", "--signal", "lissajous",
                                     "-o", self.folder / "x.png"),
                            "a signal or a picture drives 'either', but not both")
        both = self.write_preset("either", "both", signal={"kind": "lissajous"}, source="pattern:white")
        self.assert_refused(self.lab("check", both), f"{both}: error: a signal or a picture drives 'either'")

    def test_a_preset_is_checked_for_the_parameters_of_both_drivers(self):
        mixed = self.write_preset("either", "mixed", values={"level": 0.5, "gain": 0.5, "gian": 1},
                                  source="pattern:white")
        checked = self.lab("check", mixed)
        self.assert_done(checked)
        self.assertIn("gian", checked.stderr)
        self.assertNotIn("'level'", checked.stderr)

    def test_check_reads_the_look_for_both_drivers(self):
        self.write("data/shaders/either/show.frag", SHOWN.replace("* gain", "* gone"))
        self.assert_refused(self.lab("check", "either"), "show.frag:12: error: ", "gone")
        self.write("data/shaders/either/show.frag", SHOWN.replace("vec4(level)", "vec4(gone)"))
        self.assert_refused(self.lab("check", "either"), "show.frag:14: error: ", "gone")

    def test_describe_and_export_tell_the_driver(self):
        for arguments, driver, names in ((["either"], "signal", ["level"]), ([self.picture], "picture", ["gain"])):
            self.assert_done(self.lab("export", *arguments, "--to", "portable", "-o", self.folder / driver))
            told = json.loads((self.folder / driver / "portable.json").read_text())
            self.assertEqual(told["driven_by"], driver)
            self.assertEqual([one["name"] for one in told["parameters"]], names)


if __name__ == "__main__":
    main()
