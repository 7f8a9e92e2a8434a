"""Presets of an older version are drawn as that version drew them."""

import json

from program import SOURCE, ProgramTest, main, run

PRESETS = SOURCE / "tests/inputs/presets"
LABELS = SOURCE / "tests/inputs/labels"


class OlderPresets(ProgramTest):
    """The pictures were drawn by the version that wrote the presets. Content did not keep its shape then."""

    def test_presets_without_a_fit_keep_their_meaning(self):
        names = sorted(file.stem for file in PRESETS.glob("*.json"))
        self.assertEqual(len(names), 10)
        for name in names:
            with self.subTest(name):
                drawn = self.folder / (name + ".png")
                self.assert_done(run("render", PRESETS / (name + ".json"), "--size", "160x90", "--frames", "20",
                                     "-o", drawn))
                compared = run("compare", drawn, PRESETS / (name + ".expected.png"), "--json")
                # Drivers round differently: at most 2 of 255 for any pixel.
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

    def test_presets_lines_and_automation_with_older_item_labels_open(self):
        """Each list is set to its last item, or to the one before it if the last is the default."""
        looks = sorted(file.stem for file in LABELS.glob("*.line"))
        self.assertEqual(len(looks), 5)
        for look in looks:
            expected = json.loads((LABELS / (look + ".expected.json")).read_text())
            for saved in (LABELS / (look + ".json"), (LABELS / (look + ".line")).read_text().strip()):
                with self.subTest(look=look, saved=str(saved)[:20]):
                    described = run("describe", saved, "--json")
                    self.assert_done(described)
                    self.assertNotIn("warning", described.stderr)
                    self.assertEqual(items_of(json.loads(described.stdout), expected), expected)
            with self.subTest(look=look, saved="automation"):
                self.assert_done(run("render", look, "--moves", LABELS / (look + ".moves"), "--size", "32x18",
                                     "--frames", "1", "-o", self.folder / (look + ".png")))


def items_of(described, names):
    """The selected item of each list in `names`, as a number, from the output of `describe`."""
    lists = {entry["name"]: entry for entry in described["parameters"] if entry["name"] in names}
    return {name: next(item["value"] for item in entry["items"] if entry["value"] in (item["label"], item["value"]))
            for name, entry in lists.items()}


if __name__ == "__main__":
    main()
