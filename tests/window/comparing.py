"""Comparing the picture with a reference."""

from person import Person


class Comparing(Person):
    def test_values_in_a_slot_are_compared_with_and_taken_back(self):
        program = self.program
        program.click("play")
        program.wait("playback stops", lambda s: not s["is_playing"])
        program.click("slot:A")
        program.wait("slot A has the current values", lambda s: s["slots"] == [True, None, None])
        program.set("exposure", "6")
        program.wait("the current values differ from slot A", lambda s: s["slots"] == [False, None, None])
        self.hover("picture")
        program.key("ctrl+F5")
        program.wait("a wipe shows the slot", lambda s: s["wipe"] and s["compare"]["other"] == "Slot A")
        program.key("shift+w")
        place = program.place("reference")
        self.assertLess(place[2], program.place("picture")[0] + 4)
        before = program.state()["probe"]
        self.hover("reference")
        theirs = program.wait("the reference pixel is reported",
                              lambda s: s["probe"] and s["probe"] != before)["probe"]
        self.hover("picture")
        ours = program.wait("the picture's pixel is reported and differs", lambda s: s["probe"] and
                            s["probe"]["rgba"] != theirs["rgba"])["probe"]
        self.assertEqual((ours["x"], ours["y"]), (theirs["x"], theirs["y"]))

        program.click("compare:Difference")
        program.wait("the difference is measured", lambda s: s["compare"]["mean"] and
                     float(s["compare"]["mean"]) > 0)
        self.hover("picture")
        self.snapshot("difference")
        program.key("shift+m", "b")
        program.wait("the brightness is equalised", lambda s: s["compare"]["measure"] == 1 and
                     s["compare"]["stops"] and s["compare"]["stops"] > 0.1)
        program.click("fit_gain")
        program.key("b", "shift+m", "shift+m")
        program.click("compare_end")
        program.wait("the comparison is off", lambda s: s["compare"]["mode"] == "off")
        program.key("F5")
        state = program.wait("the values of the slot are recalled", lambda s: s["slots"][0])
        self.assertEqual(state["undo"], "Recall slot A")
        program.key("ctrl+z")

        self.screen.do("mousemove", *program.middle("slot:A"), "click", 3)
        program.click("slot:A:empty")
        program.wait("the menu clears the slot", lambda s: s["slots"] == [None, None, None])
        program.click("preset:overdriven")
        program.wait("a preset is open", lambda s: s["preset"] == "Overdriven")
        program.key("shift+F5")
        program.click("preset:amber-p3")
        program.wait("another preset is open", lambda s: s["preset"] == "Amber P3")
        program.key("F5")
        program.wait("the slot brings its preset back", lambda s: s["preset"] == "Overdriven" and s["slots"][0])
        program.key("ctrl+z")
        program.wait("undo restores the other one", lambda s: s["preset"] == "Amber P3")

    def test_while_a_key_is_held_the_other_picture_is_shown(self):
        program = self.program
        program.click("play")
        program.wait("playback stops", lambda s: not s["is_playing"])
        program.key("shift+F6")
        program.set("exposure", "0.2")
        program.key("ctrl+F6", "w")
        program.wait("the comparison is off", lambda s: s["compare"]["mode"] == "off")
        state = program.state()
        dark = self.brightness()
        self.hover("picture")
        self.screen.do("keydown", "o")
        program.wait("the reference is shown", lambda s: s["compare"]["is_flashing"] and
                     s["compare"]["other"] == "Slot B")
        program.wait_for("the view is brighter", lambda: self.brightness() > dark + 2)
        self.screen.do("keyup", "o")
        let_go = program.wait("the reference is hidden", lambda s: not s["compare"]["is_flashing"])
        program.wait_for("the picture is back", lambda: self.brightness() < dark + 1)
        self.assertEqual((let_go["values"], let_go["undo"]), (state["values"], state["undo"]))

    def test_a_dropped_picture_is_compared_with(self):
        program = self.program
        folder = program.folder / "pictures"  # watched from now on, so not the state folder
        folder.mkdir(exist_ok=True)
        file = folder / "screen.png"
        self.screen.save(file)
        self.drop(file)
        program.wait("the picture drives Phosphor", lambda s: "screen.png" in s["driving_source"] and
                     "picture_gain" in s["values"] and not s["wipe"])
        program.click("look:vector-beam")
        program.wait("a look without pictures is open", lambda s: s["look"] == "vector-beam")
        self.drop(file)
        program.wait("the picture is the reference", lambda s: s["wipe"] and
                     s["compare"]["other"].startswith("screen.png") and
                     "scaled" in s["compare"]["other"])
        program.key("w")
        program.wait("the comparison is off", lambda s: s["compare"]["mode"] == "off")
