"""Looks and presets in their lists, new looks, and the passes of a look."""

import json

from person import Person


class Collecting(Person):
    def rows(self, state, prefix):
        return {name: rect for name, rect in state["widgets"].items() if name.startswith(prefix)}

    def test_rows_keep_their_places_and_favourites_are_cycled(self):
        program = self.program
        program.place("look:crt")
        looks = self.rows(program.state(), "look:")
        program.click("look:crt")
        state = program.wait("the look is open", lambda s: s["look"] == "crt" and not s["is_loading"])
        self.assertEqual(self.rows(state, "look:"), looks)
        self.snapshot("lists")
        self.hover("preset:neon-rain")
        program.wait("the row has a star", lambda s: "list_star:neon-rain" in s["widgets"])
        program.click("list_star:neon-rain")
        self.hover("preset:arcade-cabinet")
        program.click("list_star:arcade-cabinet")
        program.key("shift+Next")
        program.wait("the first favourite opens", lambda s: s["preset"] == "Arcade cabinet" and
                     "favourite 1 of 2" in s["notice"])
        program.key("shift+Next")
        program.wait("the next favourite opens", lambda s: s["preset"] == "Neon rain")
        program.key("shift+Prior")
        program.wait("the previous one opens again", lambda s: s["preset"] == "Arcade cabinet")
        self.hover("preset:night-shift")
        top = program.place("preset:night-shift")[1]
        program.key("ctrl+shift+s")
        program.place("dialog_name")
        program.key("ctrl+a")
        program.type("Mine")
        program.key("Return")
        program.wait("the preset is saved and listed", lambda s: s["preset"] == "Mine" and
                     "Mine" in s["presets"]["listed"] and s["dialog"] == 0)
        self.assertEqual(program.place("preset:night-shift")[1], top)
        program.key("shift+Delete")
        program.wait("the preset is deleted", lambda s: s["preset"] == "")
        program.click("look_search")
        program.type("mask")
        program.wait("only matching looks are listed", lambda s: "look:shadow-mask" in s["widgets"] and
                     "look:crt" not in s["widgets"])
        program.click("look_search_clear")
        program.wait("all looks are listed", lambda s: "look:crt" in s["widgets"])
        program.click("recent_looks")
        program.click("recent_look:Phosphor")
        program.wait("the recent look is open", lambda s: s["look"] == "phosphor")

    def test_a_look_is_made_from_a_template_and_its_passes_are_changed(self):
        program = self.program
        program.key("ctrl+n")
        program.place("template:beam")
        self.snapshot("templates")
        program.click("template:generator")
        program.click("dialog_name")
        program.key("ctrl+a")
        program.type("a+b")
        program.wait("the name is refused", lambda s: "dialog_problem" in s["widgets"])
        program.answer("my-radar")
        state = program.wait("the new look is open", lambda s: s["look"] == "my-radar" and s["frame"] > 2)
        self.assertEqual(state["problems"], [])
        self.assertIn("shaders/my-radar", state["notice"])
        self.assertIn("offer:Open folder", state["widgets"])
        self.snapshot("created")
        program.click("offer:Open shader")
        program.wait_for("the editor has the shader", lambda: "my-radar/radar.frag" in program.edited_files())
        manifest = self.own / "shaders/my-radar/look.json"
        before = manifest.read_text()
        program.click("add_pass")
        program.answer("bloom")
        program.wait("the pass is in the strip", lambda s: "pass:bloom" in s["widgets"])
        names = [one["name"] for one in json.loads(manifest.read_text())["passes"]]
        self.assertEqual(names, ["radar", "bloom"])
        self.snapshot("added_pass")
        program.key("ctrl+z")
        program.wait("undo removes it", lambda s: "pass:bloom" not in s["widgets"])
        self.assertEqual(manifest.read_text(), before)
        self.assertFalse((manifest.parent / "bloom.frag").exists())
        program.key("ctrl+shift+z")
        program.wait("redo adds it", lambda s: "pass:bloom" in s["widgets"])
        program.screen.do("mousemove", *program.middle("pass:radar"), "click", 3)
        program.click("pass_edit:remove")
        state = program.wait("a pass without input stays", lambda s: "has no input" in s["notice"])
        program.screen.do("mousemove", *program.middle("pass:bloom"), "click", 3)
        program.click("pass_edit:remove")
        program.wait("the pass is removed", lambda s: "pass:bloom" not in s["widgets"])
        self.assertEqual(manifest.read_text(), before)
