"""Constants in shader sources as parameters on the command line."""

import json

from program import ProgramTest, main, read_png, run


class Constants(ProgramTest):
    def test_a_constant_of_a_shader_is_set_described_swept_and_kept_in_a_preset(self):
        shader = self.write("a.glsl", "#define LEVEL 0.2  // @range 0 1 @label \"Level\"\n"
                            "void mainImage(out vec4 c, in vec2 p) { c = vec4(LEVEL); }\n")
        size = ("--size", "4x4", "--frames", 1)

        def red(*arguments):
            self.assert_done(run("render", *arguments, *size, "-o", self.folder / "a.png"))
            return read_png(self.folder / "a.png")[2][0][0]

        self.assertEqual(red(shader), round(255 * 0.2))
        self.assertEqual(red(shader, "--set", "LEVEL=0.6"), round(255 * 0.6))
        self.assert_refused(run("render", shader, "--set", "LEVEL=much", "-o", self.folder / "x.png"), "LEVEL")
        described = run("describe", shader, "--set", "LEVEL=0.6", "--json")
        self.assert_done(described)
        level = json.loads(described.stdout)["parameters"][0]
        self.assertEqual((level["name"], level["default"], level["value"], level["label"], level["constant"]),
                         ("LEVEL", 0.2, 0.6, "Level", True))
        preset = self.folder / "p.json"
        self.assert_done(run("preset", shader, "--set", "LEVEL=0.8", "-o", preset))
        self.assertEqual(json.loads(preset.read_text())["values"], {"LEVEL": 0.8})
        self.assertEqual(red(shader, "--preset", preset), round(255 * 0.8))
        moves = self.write("moves.txt", "0 LEVEL 1\n")
        self.assertEqual(red(shader, "--moves", moves), 255)
        sheet = self.folder / "sheet.png"
        self.assert_done(run("sweep", shader, *size, "--vary", "LEVEL=0.2,0.6,1", "-o", sheet))
        shown = {pixel for row in read_png(sheet)[2] for pixel in row}
        self.assertLessEqual({round(255 * level) for level in (0.2, 0.6, 1.0)}, shown)
        self.assert_done(run("bench", shader, "--set", "LEVEL=0.4", "--size", "4x4", "--json"))
        self.write("a.glsl", "#define LEVEL 0.2  // @range 1 0\nvoid mainImage(out vec4 c, in vec2 p) { c = vec4(LEVEL); }\n")
        self.assert_refused(run("check", shader), f"{shader}:1: error: @range: the minimum must be below the maximum")

    def test_a_limit_that_was_raised_holds_for_each_value_of_a_constant(self):
        chain = "float f0() { return LEVEL; }\n" + "".join(
            f"float f{i}() {{ return f{i - 1}(); }}\n" for i in range(1, 70))
        shader = self.write("a.glsl", "#define LEVEL 0.2  // @range 0 1\n" + chain +
                            "void mainImage(out vec4 c, in vec2 p) { c = vec4(f69()); }\n")
        size = ("--size", "4x4", "--frames", 2, "-o", self.folder / "a.png")
        moves = self.write("moves.txt", "0.01 LEVEL 1\n")
        self.assert_refused(run("render", shader, *size), "--limit depth=")
        self.assert_done(run("render", shader, *size, "--moves", moves, "--limit", "depth=100"))
        self.assertEqual(read_png(self.folder / "a.png")[2][0][0], 255)


if __name__ == "__main__":
    main()
