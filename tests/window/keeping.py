"""Saving and sharing presets, and sessions."""

from person import PICTURE, Person, write_tones


class Keeping(Person):
    def test_presets_are_saved_and_loaded(self):
        program = self.program
        program.set("decay", "0.61")
        program.key("ctrl+s")
        program.place("dialog_name")
        program.type("Mine")
        self.snapshot("saving")
        program.key("Return")
        program.wait("the preset is saved", lambda s: s["preset"] == "Mine" and not s["is_modified"])
        saved = self.own / "presets/phosphor/Mine.json"
        self.assertIn('"decay": 0.61', saved.read_text())

        program.click("preset:overdriven")
        program.wait("another preset opens",
                     lambda s: s["preset"] != "Mine" and s["values"]["decay"][0] != 0.61)
        program.key("ctrl+shift+s")
        program.place("dialog_name")
        program.key("ctrl+a")
        program.type("Mine")
        program.place("dialog_taken")
        self.snapshot("taken")
        program.click("dialog_cancel")
        program.wait("the dialog is closed and nothing is overwritten", lambda s: s["dialog"] == 0)
        self.assertIn('"decay": 0.61', saved.read_text())
        program.click("preset:Mine")
        program.wait("the saved values are restored",
                     lambda s: s["preset"] == "Mine" and s["values"]["decay"][0] == 0.61)

    def test_presets_are_renamed_duplicated_and_deleted(self):
        program = self.program
        folder = self.own / "presets/phosphor"
        program.set("decay", "0.61")
        program.choose("File", "Save preset as…")
        program.answer("First")
        program.wait("the preset is saved", lambda s: s["preset"] == "First" and not s["is_modified"])
        program.choose("File", "Rename preset…")
        program.answer("Second")
        program.wait("the preset is renamed", lambda s: s["preset"] == "Second")
        self.assertFalse((folder / "First.json").exists())
        (folder / "Taken.json").write_text((folder / "Second.json").read_text())
        program.wait("the other preset is listed", lambda s: "preset:Taken" in s["widgets"])
        program.key("F2")
        program.place("dialog_name")
        program.key("ctrl+a")
        program.type("Taken")
        program.place("dialog_taken")
        program.key("Return", "Escape")
        program.wait("an existing name is refused",
                     lambda s: s["dialog"] == 0 and s["preset"] == "Second")
        program.set("decay", "0.62")
        program.key("ctrl+d")
        state = program.wait("the copy is open", lambda s: s["preset"] == "Second 2")
        self.assertTrue(state["is_modified"])  # the copy has the unsaved changes
        program.key("ctrl+s")
        program.wait("the preset is saved", lambda s: not s["is_modified"])
        self.assertIn('"decay": 0.61', (folder / "Second.json").read_text())
        self.assertIn('"decay": 0.62', (folder / "Second 2.json").read_text())
        program.choose("File", "Delete preset")
        state = program.wait("the preset is deleted and its values stay",
                             lambda s: s["preset"] == "" and s["values"]["decay"][0] == 0.62)
        self.assertIn('Deleted "Second 2"', state["notice"])
        self.assertEqual([file.name for file in folder.glob("Second*")], ["Second.json"])
        self.snapshot("deleted")
        program.click("offer:Undo")
        program.wait("the notice restores the preset", lambda s: s["preset"] == "Second 2")
        self.assertTrue((folder / "Second 2.json").exists())
        program.key("shift+Delete")
        program.wait("the key deletes the preset too", lambda s: s["preset"] == "")
        program.key("ctrl+z")
        program.wait("undo restores the preset", lambda s: s["preset"] == "Second 2")

    def test_a_preset_travels_as_a_line_of_text(self):
        program = self.program
        program.set("decay", "0.61")
        self.hover("picture")
        program.key("ctrl+c")
        program.wait("the preset is copied", lambda s: "Copied" in s["notice"])
        program.key("ctrl+z")
        program.wait("the value is undone", lambda s: s["values"]["decay"][0] != 0.61)
        program.key("ctrl+v")
        program.wait("pasting restores the value in one step",
                     lambda s: s["values"]["decay"][0] == 0.61 and s["undo"] == "Paste")

    def test_an_item_of_a_list_is_pasted_by_its_name(self):
        program = self.program
        program.click("preset:amber-p3")
        tube = program.wait("the preset is open", lambda s: s["preset"] == "Amber P3")["values"]["tube"]
        self.hover("picture")
        program.key("ctrl+c")
        program.wait("the preset is copied", lambda s: "Copied" in s["notice"])
        program.click("preset:")
        program.wait("the defaults are open", lambda s: s["preset"] == "" and s["values"]["tube"] != tube)
        self.hover("picture")
        program.key("ctrl+v")
        program.wait("the tube is pasted", lambda s: s["values"]["tube"] == tube and s["undo"] == "Paste")

    def test_a_preset_opens_in_one_step_and_nothing_unsaved_is_lost(self):
        program = self.program
        program.set("decay", "0.61")
        program.click("preset:overdriven")
        program.wait("the preset opens at once", lambda s: s["preset"] == "Overdriven" and
                     s["undo"] == "Open Overdriven" and "Ctrl+Z" in s["notice"])
        program.key("ctrl+z")
        program.wait("one undo restores the unsaved values",
                     lambda s: s["preset"] == "" and s["is_modified"] and
                     s["values"]["decay"] == [0.61])

    def test_a_preset_of_a_stack_is_opened_bypassed_reordered_and_undone(self):
        program = self.program
        self.open_by_name(self.presets / "phosphor+crt/night-ward.json")
        values = program.wait("both looks are drawn", lambda s: s["look"] == "phosphor+crt" and
                              s["preset"] == "Night ward")["values"]
        program.click("stack_bypass:crt")
        program.wait("the look is bypassed", lambda s: (s["bypass"], s["undo"]) == ("crt", "Bypass CRT"))
        program.click("stack_up:crt")
        program.wait("the look is first", lambda s: (s["look"], s["undo"]) == ("crt+phosphor", "Move CRT"))
        program.key("ctrl+z")
        program.wait("the look is last again", lambda s: (s["look"], s["undo"]) == ("phosphor+crt", "Bypass CRT"))
        program.key("ctrl+z")
        program.wait("the preset is unmodified again",
                     lambda s: not s["bypass"] and not s["is_modified"] and s["values"] == values)
        program.key("ctrl+z")
        program.wait("the previous look is open again", lambda s: s["look"] == "phosphor" and not s["preset"])

    def test_everything_comes_back_after_a_quit_and_after_a_crash(self):
        program = self.program
        program.set("decay", "0.61")
        self.hover("picture")
        program.key("w")
        left, top, right, bottom = program.place("wipe")
        program.drag(((left + right) // 2, bottom - 40), (right + 60, bottom - 40))
        line = program.wait("the line of the wipe is moved", lambda s: s["wipe"] > 0.55)["wipe"]
        program.quit()
        state = program.start()
        self.assertEqual((state["values"]["decay"], state["picture"]), ([0.61], PICTURE))
        program.wait("the wipe position is restored", lambda s: s["wipe"] == line)
        program.key("w")
        self.assertTrue(state["is_modified"])
        program.key("ctrl+z")
        program.wait("undo works across the restart", lambda s: s["values"]["decay"] != [0.61])
        program.key("ctrl+shift+z")
        program.wait("redo restores the value", lambda s: s["values"]["decay"] == [0.61])
        program.kill()  # immediately: each change is saved when it is made
        self.assertEqual(program.start()["values"]["decay"], [0.61])

    def test_keys_go_through_the_presets_of_the_open_look(self):
        program = self.program
        self.hover("picture")
        program.key("ctrl+Next")
        state = program.wait("the first preset opens, and its name and position are reported", lambda s:
                             s["preset"] and "preset 1 of" in s["notice"])
        first = state["preset"]
        self.assertIn(first, state["notice"])
        program.set("decay", "0.61")
        program.key("ctrl+Prior")
        program.wait("the defaults open, and the changes can be restored", lambda s:
                     not s["preset"] and not s["is_modified"] and "Ctrl+Z" in s["notice"])
        program.key("ctrl+z")
        program.wait("the unsaved values are restored",
                     lambda s: s["preset"] == first and s["values"]["decay"] == [0.61])
        program.key("ctrl+Next", "ctrl+Next")  # faster than presets are loaded
        program.wait("every key press counts", lambda s: s["preset"] and "preset 3 of" in s["notice"])

    def test_a_preset_is_compared_with_what_is_open(self):
        program = self.program
        program.set("decay", "0.61")
        program.screen.do("mousemove", *program.middle("preset:overdriven"), "click", 3)
        program.click("compare:overdriven")
        program.wait("the differences are listed", lambda s: "change:Decay" in s["widgets"])
        self.snapshot("compared")
        program.key("Escape")
        program.wait("the comparison is closed", lambda s: s["dialog"] == 0)

    def test_the_first_start_shows_what_to_do_and_a_sound_can_be_its_argument(self):
        program = self.program
        song = program.folder / "song.wav"
        write_tones(song, seconds=1)
        program.quit()
        program.forget_look()
        program.start(str(song))
        program.wait("the sound is drawn by the look of a first start", lambda s: s["look"] == "phosphor" and
                     s["signal"].startswith("audio:") and not s["reading"])
        self.snapshot("first_steps")
        program.click("first_steps:close")
        program.wait("the first steps are closed", lambda s: "first_steps" not in s["widgets"])
        self.open_by_name(self.presets / "phosphor/long-afterglow.json")
        program.wait("the preset is open",
                     lambda s: not s["dialog"] and s["preset"])
        program.quit()
        again = program.start()
        self.assertNotIn("first_steps", again["widgets"])
        program.key("ctrl+o")
        program.click("recent:long-afterglow.json")
        program.wait("the recent file opens", lambda s: not s["dialog"])
        program.key("ctrl+o")
        program.place("dialog_file")
        program.type("%s/" % (program.folder / "data"))
        program.key("Return")
        program.wait("the folder is entered", lambda s: s["typed"] == "" and "file:shaders" in s["widgets"])
        program.key("Down")
        program.place("file:shaders")
        program.key("Down")
        program.place("file:shaders")
        self.snapshot("open")
        program.key("Return")
        program.wait("the arrow keys selected the second folder", lambda s: "file:phosphor" in s["widgets"])
        program.key("Escape")
