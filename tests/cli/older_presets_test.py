"""Presets that an older program wrote are drawn as that program drew them."""

import json

from program import SOURCE, ProgramTest, main, run

PRESETS = SOURCE / "tests/inputs/presets"


class OlderPresets(ProgramTest):
    """Each picture was drawn by the program that wrote the preset, before content kept its shape."""

    def test_presets_without_a_fit_keep_their_meaning(self):
        names = sorted(file.stem for file in PRESETS.glob("*.json"))
        self.assertEqual(len(names), 10)
        for name in names:
            with self.subTest(name):
                drawn = self.folder / (name + ".png")
                self.assert_done(run("render", PRESETS / (name + ".json"), "--size", "160x90", "--frames", "20",
                                     "-o", drawn))
                compared = run("compare", drawn, PRESETS / (name + ".expected.png"), "--json")
                # Drivers round differently: two of 255 anywhere.
                self.assertLessEqual(json.loads(compared.stdout)["max"], 2 / 255, name)

    def test_content_of_the_command_line_keeps_its_shape(self):
        for look, content, words in (("phosphor", "--signal", "audio:circle.wav"), ("crt", "--source", "ring.png")):
            file = PRESETS / words.split(":")[-1]
            given = words.replace(file.name, str(file))
            shapes = {}
            for fit in ("", ",fit=whole", ",fit=stretch"):
                drawn = self.folder / "x.png"
                self.assert_done(run("render", look, content, given + fit, "--size", "160x90", "--frames", "2",
                                     "-o", drawn))
                shapes[fit] = drawn.read_bytes()
            self.assertEqual(shapes[""], shapes[",fit=whole"], look)
            self.assertNotEqual(shapes[""], shapes[",fit=stretch"], look)


if __name__ == "__main__":
    main()
