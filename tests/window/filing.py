"""Choosing files and names in the program's own dialogs."""

from person import Person, write_tones


class Filing(Person):
    def open_dialog(self, keys="ctrl+o"):
        self.program.key(keys)
        self.program.place("dialog_file")

    def retype_name(self, text):
        """Replaces the text of the field with the keyboard focus."""
        self.program.key("ctrl+a")
        self.program.type(text)
        self.program.wait("the text is typed", lambda s: s["typed"] == text)

    def make_sounds(self):
        folder = self.program.folder / "sounds"
        (folder / "sub").mkdir(parents=True, exist_ok=True)
        for name in ("osci.wav", "other.wav", "sub/inner.wav"):
            write_tones(folder / name, seconds=1)
        (folder / ".hidden.wav").write_bytes(b"")
        return folder

    def double_click(self, widget):
        self.screen.do("mousemove", *self.program.middle(widget), "click", "--repeat", 2, "--delay", 60, 1)

    def test_a_part_of_a_name_finds_a_file_and_a_miss_stays_in_the_dialog(self):
        program = self.program
        folder = self.make_sounds()
        self.open_dialog()
        self.retype_name("%s/" % folder)
        program.place("file:sub")
        self.assertNotIn("file:.hidden.wav", program.state()["widgets"])
        program.type("nothing")
        program.key("Return")
        state = program.wait("a miss is reported in the dialog", lambda s: "dialog_problem" in s["widgets"])
        self.assertTrue(state["dialog"])
        self.assertEqual(state["typed"], "%s/nothing" % folder)
        self.snapshot("file_miss")
        self.retype_name("%s/ot" % folder)
        program.wait("the first match is highlighted", lambda s: s["highlighted"] == "other.wav" and
                     "dialog_problem" not in s["widgets"] and "file:osci.wav" not in s["widgets"])
        program.key("Tab")
        program.wait("Tab completes the name", lambda s: s["typed"] == "%s/other.wav" % folder)
        self.retype_name("%s/os" % folder)
        self.snapshot("file_filter")
        program.key("Return")
        program.wait("the first match opens", lambda s: not s["dialog"] and "osci.wav" in s["signal"])
        self.open_dialog()
        program.wait("the last folder is listed", lambda s: "file:other.wav" in s["widgets"])
        program.click("hidden_files")
        program.place("file:.hidden.wav")
        program.click("hidden_files")
        program.click("sort:Modified")
        self.snapshot("file_columns")
        program.click("sort:Name")
        program.key("Escape")

    def test_a_click_selects_a_double_click_opens_and_typing_goes_on(self):
        program = self.program
        folder = self.make_sounds()
        self.open_dialog()
        self.retype_name("%s/" % folder)
        program.key("Return")
        program.wait("the folder is entered", lambda s: s["typed"] == "" and "file:sub" in s["widgets"])
        program.click("file:sub")
        state = program.wait("a click selects a folder", lambda s: s["highlighted"] == "sub")
        self.assertIn("file:osci.wav", state["widgets"])
        program.type("oth")
        program.wait("the name field has kept the keyboard focus", lambda s: s["typed"] == "oth")
        program.key("BackSpace", "BackSpace", "BackSpace")
        self.double_click("file:sub")
        program.place("file:inner.wav")
        program.click("dialog_up")
        program.place("file:sub")
        program.click("place:Home")
        program.place("file:sounds")
        self.double_click("file:sounds")
        self.double_click("file:osci.wav")
        program.wait("a double click opens a file", lambda s: not s["dialog"] and "osci.wav" in s["signal"])

    def open_save_dialog(self):
        self.program.click("save_pass")
        self.program.place("dialog_file")

    def test_a_saved_pass_is_checked_and_replaced_only_when_asked(self):
        program = self.program
        films = program.folder / "films"
        films.mkdir(exist_ok=True)
        self.open_save_dialog()
        self.assertEqual(program.state()["typed"], "composite.exr")
        self.retype_name("%s/glow.jpg" % films)
        program.place("dialog_suggestion")
        self.snapshot("file_suggestion")
        program.key("Return")
        program.click("dialog_suggestion")
        program.wait("the suggestion is taken", lambda s: s["typed"] == "%s/glow.exr" % films)
        program.key("Return")
        program.wait("the pass is saved", lambda s: not s["dialog"])
        size = (films / "glow.exr").stat().st_size
        self.assertGreater(size, 0)
        (films / "glow.exr").write_bytes(b"mine")
        self.open_save_dialog()
        program.place("file:glow.exr")  # the same folder again
        self.retype_name("glow")
        program.key("Return")
        program.place("dialog_taken")
        self.snapshot("file_replace")
        self.assertEqual((films / "glow.exr").read_bytes(), b"mine")
        program.key("Return")
        program.wait("the second Enter replaces the file", lambda s: not s["dialog"])
        self.assertEqual((films / "glow.exr").read_bytes()[:4], b"\x76\x2f\x31\x01")
        self.open_dialog()
        self.assertNotIn("file:glow.exr", program.state()["widgets"])  # opening has its own folder
        program.key("Escape")

    def test_an_invalid_name_or_a_failed_save_never_closes_a_dialog(self):
        program = self.program
        program.key("ctrl+n")
        program.place("dialog_name")
        self.retype_name("My Look")
        program.place("dialog_suggestion")
        self.snapshot("name_suggestion")
        program.key("Return")
        program.place("dialog_suggestion")
        self.assertEqual(program.state()["typed"], "My Look")
        program.key("Escape")
        program.set("decay", "0.61")
        program.key("ctrl+shift+s")
        program.place("dialog_name")
        self.retype_name("a/b")
        program.click("dialog_suggestion")
        program.wait("a valid name is suggested", lambda s: s["typed"] == "a-b")
        blocked = self.own / "presets/phosphor"
        blocked.parent.mkdir(parents=True, exist_ok=True)
        moved = blocked.with_name("moved")
        if blocked.exists():
            blocked.rename(moved)
        blocked.write_text("")  # a file where the folder should be
        program.key("Return")
        state = program.wait("the failure is reported", lambda s: "dialog_problem" in s["widgets"])
        self.assertTrue(state["dialog"])
        self.assertEqual(state["typed"], "a-b")
        self.snapshot("name_failure")
        blocked.unlink()
        if moved.exists():
            moved.rename(blocked)
        program.key("Return")
        program.wait("the preset is saved", lambda s: not s["dialog"] and s["preset"] == "a-b")
        (blocked / "a-b.json").unlink()

    def test_ten_thousand_files_do_not_stop_the_picture(self):
        program = self.program
        large = program.folder / "large"
        large.mkdir()
        for number in range(10000):
            (large / ("shot %d.png" % number)).touch()
        self.open_dialog()
        self.retype_name("%s/" % large)
        program.place("file:shot 0.png")
        frame = program.state()["frame"]
        program.key("End")
        program.type("9999")
        program.wait("the file is found", lambda s: s["highlighted"] == "shot 9999.png" and s["frame"] > frame)
        program.key("Escape")
