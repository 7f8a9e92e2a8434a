"""Help, keys and problems: rebinding, search in the source, a second window."""

import copy
import json

from person import Person


class Helping(Person):
    def keys(self):
        file = self.program.folder / "config/afterglow/keys.json"
        return json.loads(file.read_text())["keys"] if file.exists() else {}

    def test_a_key_is_changed_swapped_and_reset(self):
        program = self.program
        program.key("F1")
        program.place("keys_search")
        widgets = program.state()["widgets"]
        names = [name[4:] for name in widgets if name.startswith("key:") and "key_label:" + name[4:] in widgets]
        self.assertGreater(len({widgets["key:" + name][0] for name in names}), 1, "columns")
        for name in names:
            gap = widgets["key_label:" + name][0] - widgets["key:" + name][2]
            self.assertTrue(0 < gap < 20, "the label of %s is %s px after its key" % (name, gap))
        program.type("play or")
        program.wait("the list is filtered", lambda s: "key:undo" not in s["widgets"])
        program.click("key:play_pause")
        program.place("keys_prompt")
        program.key("F9")
        program.wait_for("the new key is saved", lambda: self.keys() == {"play_pause": "F9"})
        self.snapshot("keys")
        program.click("dialog_cancel")
        program.wait("the dialog is closed", lambda s: s["dialog"] == 0)
        was_playing = program.state()["is_playing"]
        program.key("F9")
        program.wait("the new key works", lambda s: s["is_playing"] != was_playing)
        program.key("F9")
        program.wait("and again", lambda s: s["is_playing"] == was_playing)

        program.key("F1")
        program.click("key:play_pause")
        program.key("ctrl+z")
        program.click("keys_swap")
        program.wait_for("the keys are swapped",
                         lambda: self.keys() == {"play_pause": "Ctrl+Z", "undo": "F9"})
        program.click("key:undo")
        program.place("keys_prompt")
        program.key("Escape")
        program.wait("Escape only ends the wait", lambda s: s["dialog"] != 0)
        program.click("keys_reset_all")
        program.wait_for("all keys are the initial ones", lambda: self.keys() == {})
        program.click("dialog_cancel")
        program.wait("the dialog is closed", lambda s: s["dialog"] == 0)

    def test_the_compiled_source_is_searched_and_copied(self):
        program = self.program
        program.key("ctrl+9")
        program.click("source_search")
        program.type("uniform")
        program.place("source_matches")
        program.key("Return", "Return")
        self.snapshot("source")
        program.click("source_next")
        program.click("source_copy:Fragment shader")
        program.click("source_search_clear")
        program.key("Escape", "ctrl+9")

    def test_a_similar_name_and_the_source_are_shown_for_an_error(self):
        program = self.program
        shader = self.looks / "phosphor/composite.frag"
        text = shader.read_text()
        shader.write_text(text.replace("void main() {", "void main() {\n    float a = smothstep(0.0, 1.0, 0.5);", 1))
        state = program.wait("the error is listed", lambda s: s["problems"])
        self.assertEqual(state["problems"][0]["message"],
                         "'smothstep' is not a function (did you mean 'smoothstep'?)")
        program.place("errors")
        self.snapshot("similar")
        shader.write_text(text)
        program.wait("a corrected shader clears the error", lambda s: not s["problems"])

    def test_a_second_window_says_so_and_has_its_own_session(self):
        program = self.program
        second = copy.copy(program)
        second.state_file = program.folder / "second.json"
        try:
            second.start()
            second.wait("it says so", lambda s: "Another Afterglow window is open" in str(s["notice"]))
            self.snapshot("second")
        finally:
            second.stop()
        self.assertTrue((program.folder / "state/afterglow/session-2.json").exists())
