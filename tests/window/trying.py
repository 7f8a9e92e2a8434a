"""Previewing changes, and morphing to a preset."""

from person import Person


class Trying(Person):
    def hold_over(self, parameter, key):
        self.program.reveal(parameter)
        self.hover("parameter:" + parameter)
        self.program.wait("the pointer is over the parameter", lambda s: s["pointed"] == parameter)
        self.screen.do("keydown", key)

    def test_while_a_key_is_held_over_a_slider_the_picture_shows_what_a_step_changes(self):
        program = self.program
        before = program.state()
        self.hold_over("exposure", "u")
        state = program.wait("the step up is reported", lambda s: not s["step"]["is_busy"] and
                             "of 255 levels" in s["step"]["words"])
        self.assertIn("Exposure 1.5 → ", state["step"]["words"])
        changes = [float(share) for share in state["step"]["changes"]]
        self.assertGreater(changes[-1], 0)
        self.assertEqual(changes[0], 0)  # the beam is drawn before it
        program.wait_for("unchanged areas are grey", lambda: 90 < self.brightness() < 160)
        self.snapshot("step")
        self.screen.do("keyup", "u")
        state = program.wait("the key is up", lambda s: s["step"]["words"] == "")
        program.wait_for("the picture is back", lambda: self.brightness() < 80)
        self.assertEqual((state["values"], state["undo"]), (before["values"], before["undo"]))
        self.assertGreater(state["frame"], before["frame"])  # time continued

        program.set("bloom_intensity", "0")
        self.hold_over("bloom_radius", "u")
        program.wait("the pass in which the effect ends is reported",
                     lambda s: "its effect ends in" in s["step"]["words"])
        self.screen.do("keyup", "u")

    def test_a_filmstrip_and_a_contact_sheet_are_clicked_to_take_a_value(self):
        program = self.program
        program.click("play")
        program.reveal("exposure")
        program.click("label:exposure")
        program.click("filmstrip")
        sheet = program.wait("all cells are drawn", lambda s: s["sheet"]["cells"] == 7 and
                             s["sheet"]["drawn"] == 7)
        self.snapshot("filmstrip")
        program.click("cell:5")
        state = program.wait("the value is applied", lambda s: s["sheet"]["present"] == 5)
        self.assertTrue(state["undo"].startswith("Apply Exposure"))
        self.assertNotEqual(state["values"]["exposure"], sheet["values"]["exposure"])
        program.key("ctrl+z")
        program.wait("one undo restores the value",
                     lambda s: s["values"]["exposure"] == sheet["values"]["exposure"])
        program.click("sheet_columns")
        program.click("sheet_count:3")
        program.click("sheet_down")
        self.screen.do("mousemove", *program.middle("sheet_choice:bloom_radius"))
        self.screen.do("click", 5)  # the list must be scrolled
        program.wait("the list is scrolled", lambda s: s["widgets"]["sheet_choice:bloom_intensity"][3] < 700)
        program.click("sheet_choice:bloom_intensity")
        program.wait("a sheet of all combinations is being drawn", lambda s: s["sheet"]["columns"] == 3 and
                     s["sheet"]["cells"] == 15 and s["sheet"]["drawn"] > 5)
        self.snapshot("sheet")
        program.click("cell:5")
        state = program.wait("both values are applied", lambda s: s["sheet"]["present"] == 5)
        self.assertEqual((state["values"]["exposure"], state["values"]["bloom_intensity"]),
                         ([16], [0.75]))
        program.key("ctrl+0")
        program.wait("the pane is closed", lambda s: "sheet_down" not in s["widgets"])

    def test_a_preset_is_chosen_by_its_picture_opened_or_morphed_to(self):
        program = self.program
        others = {preset: preset.read_text() for preset in self.presets.glob("phosphor/*.json")
                  if preset.stem != "amber-p3"}
        for preset in others:
            preset.unlink()
        broken = self.presets / "phosphor/broken.json"
        broken.write_text('{\n"format": 3 }')
        program.click("play")
        program.key("ctrl+l")
        program.wait("the defaults and the good preset have pictures, and the broken one has a problem", lambda s:
                     s["presets"]["listed"] == ["", "broken", "amber-p3"] and
                     s["presets"]["pictures"] == 2 and len(s["presets"]["problems"]) == 1)
        self.hover("picture:amber-p3")
        program.click("preset_star:amber-p3")
        program.click("only_starred")
        program.wait("only the favourite is listed", lambda s: s["presets"]["listed"] == ["amber-p3"])
        self.snapshot("presets")
        program.click("morph_seconds")
        program.click("morph_seconds:1")
        program.key("ctrl+shift+Next")
        program.wait("the key starts a morph", lambda s: s["morph"] is not None)
        state = program.wait("the morph is complete", lambda s: s["morph"] is None)
        self.assertEqual((state["preset"], state["is_modified"], state["undo"]),
                         ("Amber P3", False, "Morph to Amber P3"))
        program.key("ctrl+z")
        program.wait("one undo restores the defaults", lambda s: s["preset"] == "")
        program.click("picture:amber-p3")
        state = program.wait("a click opens the preset", lambda s: s["preset"] == "Amber P3")
        self.assertEqual(state["presets"]["drawn"], 2)  # no picture is redrawn
        program.click("only_starred")
        program.key("ctrl+l")
        program.wait("the pane is closed", lambda s: "preset_search" not in s["widgets"])
        self.assertIn('"phosphor/amber-p3"', program.session().read_text())
        broken.unlink()
        for preset, text in others.items():
            preset.write_text(text)
        program.place("preset:overdriven")
