"""The focus of the keyboard, lists, and the editor behind F4."""

from person import Person


class Keyboard(Person):
    def focus(self):
        return self.program.state()["widgets"].get("focus")

    def press_until(self, what, key, is_there):
        """Presses a key until the focus is where it should be; each press must move it."""
        for _ in range(40):
            before = self.focus()
            self.program.key(key)
            self.program.wait("the focus moves", lambda s: s["widgets"].get("focus") not in (None, before))
            if is_there(self.program.place("focus")):
                return
        raise AssertionError("the focus never came to: %s" % what)

    def is_on(self, widget, focus):
        """Whether the frame surrounds a widget, as high as it."""
        left, top, right, bottom = self.program.place(widget)
        return focus[0] <= left < focus[2] and focus[1] <= top and bottom <= focus[3] and \
            focus[3] - focus[1] < 2 * (bottom - top)

    def test_tab_moves_the_focus_through_controls_and_panes(self):
        program = self.program
        self.assertIsNone(self.focus())
        program.key("Tab")
        first = program.place("focus")
        program.key("Tab")
        program.wait("the focus moves on", lambda s: s["widgets"].get("focus") not in (None, first))
        program.key("shift+Tab")
        program.wait("the focus moves back", lambda s: s["widgets"].get("focus") == first)
        edge = program.place("search")[0]
        self.press_until("the parameters", "ctrl+Tab", lambda focus: focus[0] >= edge - 8)
        self.snapshot("focus")
        self.press_until("the toolbar", "ctrl+shift+Tab", lambda focus: self.is_on("play", focus) or
                         focus[3] < program.place("picture")[1])
        self.press_until("the pause button", "Tab", lambda focus: self.is_on("play", focus))
        program.key("Return")
        program.wait("the picture is paused", lambda s: not s["is_playing"])
        program.key("Escape")
        program.wait("no control has the focus", lambda s: "focus" not in s["widgets"])

    def test_a_slider_with_the_focus_is_turned_and_typed(self):
        program = self.program
        program.reveal("exposure")
        before = program.state()["values"]["exposure"][0]
        left, _, y = program.slider("exposure")
        self.press_until("the slider", "Tab", lambda focus: focus[0] < left < focus[2] and
                         focus[1] < y < focus[3])
        self.snapshot("focus_slider")
        program.key("Right")
        value = program.wait("the value increases", lambda s: s["values"]["exposure"][0] > before)
        self.assertEqual(value["undo"], "Exposure")
        program.key("Left")
        program.wait("the value decreases again", lambda s: abs(s["values"]["exposure"][0] - before) < 0.02)
        program.key("Return")
        program.type("0.5")
        program.key("Return")
        program.wait("the typed value is set", lambda s: s["values"]["exposure"] == [0.5])
        self.screen.do("mousemove", *program.middle("picture"), "click", 2)
        program.wait("a click takes the focus", lambda s: "focus" not in s["widgets"])

    def test_tab_moves_through_a_dialog_and_enter_activates_its_control(self):
        program = self.program
        program.key("ctrl+n")
        program.place("dialog_name")
        self.press_until("the third template", "shift+Tab", lambda focus: self.is_on("template:generator", focus))
        self.snapshot("focus_dialog")
        program.key("Return")
        program.place("focus")
        self.assertNotEqual(program.state()["dialog"], 0)
        self.press_until("Cancel", "Tab", lambda focus: self.is_on("dialog_cancel", focus))
        program.key("Return")
        program.wait("Cancel is activated", lambda s: s["dialog"] == 0 and "focus" not in s["widgets"])

    def test_escape_closes_menus_level_by_level_and_tab_opens_none(self):
        program = self.program
        program.key("F10")
        program.place("menu:Open…")
        program.key("Escape")
        program.wait("the menu is closed", lambda s: "menu:Open…" not in s["widgets"])
        program.key("Tab")
        program.place("focus")
        program.key("Tab")
        program.place("focus")
        self.assertNotIn("menu:Open…", program.state()["widgets"])
        program.key("Escape")
        program.wait("no control has the focus", lambda s: "focus" not in s["widgets"])
        program.click("menu:View")
        self.hover("menu:Output")
        program.place("menu:Blackout")
        program.key("Escape", "Escape")
        program.wait("both menus are closed", lambda s: "menu:Output" not in s["widgets"])

    def test_letters_choose_an_item_of_an_open_list(self):
        program = self.program
        program.reveal("tube")
        program.click("parameter:tube")
        program.place("item:tube:P31")
        program.type("p31")
        program.key("Return")
        program.wait("P31 is chosen", lambda s: s["values"]["tube"] == [9])

    def test_an_editor_that_fails_is_told_and_another_can_be_chosen(self):
        program = self.program
        script = program.folder / "editor"
        before = script.read_text()
        script.write_text("#!/bin/sh\nexit 3\n")
        program.key("F4")
        program.wait("the failure is reported", lambda s: "could not open" in s["notice"] and
                     "status 3" in s["notice"])
        self.snapshot("editor_failed")
        program.click("offer:Choose editor")
        program.wait("the palette lists editors", lambda s: s["dialog"] != 0)
        self.snapshot("choose_editor")
        program.key("Escape")
        program.wait("the palette is closed", lambda s: s["dialog"] == 0)
        script.write_text(before)
        program.key("F4")
        program.wait_for("the editor starts", lambda: ".frag" in program.edited_files())
