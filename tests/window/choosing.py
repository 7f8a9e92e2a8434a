"""Choosing from lists by typing, with the keyboard only."""

from person import Person


class Choosing(Person):
    def ask(self, words, entry):
        """Types words into the palette and chooses the first entry."""
        program = self.program
        program.key("ctrl+p")
        program.place("palette_query")
        program.type(words)
        program.wait("'%s' finds '%s'" % (words, entry), lambda s: "palette:" + entry in s["widgets"])
        program.key("Return")

    def test_a_signal_and_its_frequency_are_chosen_by_keys(self):
        program = self.program
        self.ask("signal two", "Signal: Two-channel waveform")
        program.wait("the waveform is drawn", lambda s: s["signal"].startswith("waveform:") and s["undo"] == "Signal")
        self.ask("wave 2 freq", "Signal: Wave 2 · Frequency…")
        program.place("asked")
        self.snapshot("asked")
        program.type("4.5")
        program.key("Return")
        program.wait("the number is set", lambda s: "f2=4.5" in s["signal"] and s["dialog"] == 0)
        self.ask("wave 2 freq", "Signal: Wave 2 · Frequency…")
        program.place("asked")
        program.type("7")
        program.key("Escape")
        program.wait("Escape keeps the value", lambda s: s["dialog"] == 0 and "f2=4.5" in s["signal"])
        program.key("ctrl+z", "ctrl+z")
        program.wait("undo restores the figure", lambda s: s["signal"].startswith("lissajous:"))
        program.key("ctrl+shift+z")
        program.wait("redo restores the waveform", lambda s: s["signal"].startswith("waveform:"))
        self.ask("look crt", "Look: CRT")
        program.wait("the look opens", lambda s: s["look"] == "crt" and s["dialog"] == 0)
        program.wait("changes are stored", lambda s: s["notice"].startswith("Your unsaved changes are kept"))
        self.ask("unsaved phosphor", "Unsaved changes: phosphor")
        program.wait("changes return", lambda s: s["look"] == "phosphor" and s["signal"].startswith("waveform:"))

    def test_the_menus_are_walked_by_keys(self):
        program = self.program
        program.key("F10")
        program.place("menu:Open…")
        program.key(*["Up"] * 12, "Right")  # over Quit and eleven more items
        program.place("menu:Morph: To Amber P3")
        program.key("Down", "Return")
        program.wait("the morph reaches the preset", lambda s: s["preset"] == "Amber P3")
        program.key("F10")
        program.place("menu:Open…")
        program.key("Down", "Right")
        program.place("menu:Undo")
        program.key("Right")
        program.place("menu:Full screen")
        program.key("Left", "Left")
        program.place("menu:Open…")
        program.key("Escape", "Right")
        program.wait("the menus are closed", lambda s: not any(
            "menu:" + item in s["widgets"] for item in ("Open…", "Undo", "Full screen")))

    def test_a_look_behind_its_source_and_the_inspector_are_chosen_by_keys(self):
        program = self.program
        self.ask("pass persist", "Pass: persistence")
        program.wait("the pass is inspected", lambda s: s["inspected"] == "persistence")
        self.ask("inspect ago", "Inspect: persistence, 1 frame ago")
        program.wait("the previous frame is inspected", lambda s: s["looks_into"] == "persistence@1")
        self.ask("green grey", "Channels: Green as grey")
        program.wait("one channel is shown", lambda s: s["channels"] == 2)
        self.ask("channels red green", "Channels: Red, green and blue")
        self.ask("inspect white", "Inspect: White point…")
        program.place("asked")
        program.type("4")
        program.key("Return")
        program.wait("white is 4", lambda s: s["levels"][1] == 4 and s["channels"] == 0)
        program.key("shift+a")
        self.ask("pass persist", "Pass: persistence")
        self.ask("add crt", "Stack: Add CRT")
        program.wait("both looks are drawn", lambda s: s["look"] == "phosphor+crt" and s["undo"] == "Add CRT")
        self.ask("remove phos", "Stack: Remove Phosphor")
        program.wait("the remaining look is open", lambda s: s["look"] == "crt")
        self.ask("source smpte", "Source: SMPTE bars")
        program.wait("the source is SMPTE bars", lambda s: s["driving_source"] == "pattern:smpte")
        program.key(*["ctrl+z"] * 3)
        program.wait("undo restores the look", lambda s: s["look"] == "phosphor" and not s["is_loading"])

    def test_a_picture_drives_phosphor_and_then_a_signal_again(self):
        program = self.program

        def by_picture(state):
            return state["driving_source"] == "pattern:terminal" and "picture_gain" in state["values"]

        def by_signal(state):
            return state["signal"].startswith("lissajous:") and "beam_width" in state["values"]

        self.assertTrue(by_signal(program.state()))
        program.click("preset:p31-terminal")
        program.wait("the picture drives Phosphor", lambda s: by_picture(s) and s["frame"] > 10 and
                     not s["is_loading"])
        program.click("source")
        program.place("use_signal")
        self.snapshot("picture_driven")
        program.click("use_signal")
        program.wait("the signal drives Phosphor", lambda s: by_signal(s) and s["undo"] == "Use a signal")
        self.ask("driven source", "Driven by: Source picture")
        program.wait("the picture drives it again", lambda s: by_picture(s) and s["values"]["tube"] == [9])  # P31
        program.key(*["ctrl+z"] * 3)
        program.wait("undo restores signal and values", lambda s: by_signal(s) and s["values"]["tube"] == [0])

    def test_every_menu_and_all_that_asks_in_a_window_of_its_own_opens(self):
        program = self.program
        program.click("preset:overdriven")
        program.wait("the preset is open", lambda s: s["preset"])
        for menu, item in {"File": "Quit", "Edit": "Undo", "View": "Zoom 1:1", "Compare": "Wipe",
                           "Pass": "Next pass", "Playback": "Restart", "Help": "Keyboard shortcuts"}.items():
            program.click("menu:" + menu)
            program.wait("the menu is open", lambda s: "menu:" + item in s["widgets"])
            program.key("Escape")
            program.wait("the menu is closed", lambda s: "menu:" + item not in s["widgets"])
        for key in ("ctrl+o", "ctrl+n", "ctrl+shift+s", "ctrl+p", "F1", "shift+F1", "i"):
            program.key(key)
            self.leave_dialog()
        for menu, action in (("File", "Duplicate look…"), ("File", "Save picture…"),
                             ("Edit", "Remote control…"), ("Playback", "Compare frame rates…")):
            program.choose(menu, action)
            self.leave_dialog()

    def leave_dialog(self):
        program = self.program
        turn = program.wait("the dialog is open", lambda s: s["dialog"])["turn"]
        program.wait("the dialog is drawn", lambda s: s["turn"] > turn + 1)
        program.key("Escape")
        program.wait("Escape closes the dialog", lambda s: s["dialog"] == 0)
