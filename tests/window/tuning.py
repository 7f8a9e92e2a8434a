"""Changing parameters."""

from person import Person


class Tuning(Person):
    def test_a_knob_turns_the_picture_and_undo_turns_it_back(self):
        program = self.program
        state = program.state()
        self.snapshot("started")
        default = state["values"]["exposure"][0]
        dark = self.brightness()
        program.reveal("exposure")
        low, high, y = program.slider("exposure")
        program.drag(((low + high) // 2, y), (high, y))
        program.wait("the exposure is increased in one step",
                     lambda s: s["values"]["exposure"][0] > 4 * default and
                     s["undo"] == "Exposure" and s["is_modified"])
        program.wait_for("the picture is brighter", lambda: self.brightness() > dark + 3)
        self.snapshot("turned")

        program.key("ctrl+z")
        program.wait("undo restores the default",
                     lambda s: s["values"]["exposure"][0] == default and
                     s["undo"] == state["undo"])
        program.wait_for("the picture is as dark as before", lambda: self.brightness() < dark + 2)
        program.key("ctrl+shift+z")
        program.wait("redo increases the exposure again",
                     lambda s: s["values"]["exposure"][0] > 4 * default and s["redo"] == "")
        program.click("reset:exposure")
        program.wait("the reset button sets the default",
                     lambda s: s["values"]["exposure"][0] == default)

    def test_a_number_is_typed(self):
        program = self.program
        program.set("exposure", "20.5")  # outside the range of the slider
        program.retype("exposure", "0,75")
        program.wait("a decimal comma is accepted", lambda s: s["values"]["exposure"] == [0.75])
        program.retype("exposure", "much")
        program.wait("an invalid number is reported", lambda s: '"much" isn\'t a number' in s["notice"])
        program.retype("exposure", "4,096")
        program.wait("an ambiguous number is reported", lambda s: "is ambiguous" in s["notice"])
        self.assertEqual(program.state()["values"]["exposure"], [0.75])
        program.set("decay", "0.5")
        program.retype("decay", "7")
        program.wait("the value is clamped to the hard limit, and the limit is reported", lambda s:
                     s["values"]["decay"] == [1] and "Limited to 1 " in s["notice"])
        program.click("number:decay")
        program.type("0.25")
        program.click("label:decay")
        program.wait("leaving the field sets the value too", lambda s: s["values"]["decay"] == [0.25])

    def test_a_parameter_is_turned_by_keys_alone(self):
        program = self.program
        program.reveal("exposure", "tone mapping")
        program.place("picture")  # waits until the search box has lost the keyboard focus
        program.key("Down")
        program.place("revealed:exposure")
        program.key("Right")
        state = program.wait("the value is 1/100 of the slider higher", lambda s:
                             abs(s["values"]["exposure"][0] - 1.5 * 160 ** 0.01) < 1e-5)
        self.assertEqual(state["undo"], "Exposure")
        program.key("Left", "Left")
        program.wait("the value is below its start", lambda s:
                     abs(s["values"]["exposure"][0] - 1.5 / 160 ** 0.01) < 1e-5)
        program.key("Return")
        program.place("picture")  # waits until the number has the keyboard focus
        program.type("4")
        program.key("Return")
        program.wait("the typed value is set", lambda s: s["values"]["exposure"] == [4])
        program.key("BackSpace")
        program.wait("the value is reset", lambda s: s["values"]["exposure"] == [1.5])
        program.key("Down", "Right")
        program.wait("the next parameter is a list", lambda s: s["values"]["tone_map"] == [2])
        program.key("Left")
        program.wait("all values are the defaults", lambda s: not s["is_modified"])

    def test_a_decay_is_a_time_and_is_compared_at_other_frame_rates(self):
        program = self.program
        program.set("decay", "0.5")
        program.retype("decay", "100 ms")
        program.wait("a half-life is accepted",
                     lambda s: abs(s["values"]["decay"][0] - 0.5 ** (1 / 6)) < 1e-4)
        program.retype("decay", "10% 0,5 s")
        program.wait("a time to a tenth is accepted",
                     lambda s: abs(s["values"]["decay"][0] - 0.1 ** (1 / 30)) < 1e-4)
        program.click("label:decay")
        program.wait("the help is open", lambda s: "compare_rates" in s["widgets"])
        self.snapshot("decay")
        program.click("compare_rates")
        program.wait("the rates are being drawn", lambda s: "dialog_progress" in s["widgets"])
        self.snapshot("rates_under_way")
        program.click("dialog_cancel")
        program.wait("the dialog is closed", lambda s: s["dialog"] == 0)
        program.choose("Playback", "Compare frame rates…")
        program.place("rates_difference")
        program.click("rates:24-30")
        program.place("rates_difference")
        self.snapshot("rates")
        program.key("Escape")
        program.wait("the dialog is closed", lambda s: s["dialog"] == 0)

    def test_a_period_that_pixels_cannot_draw_evenly_is_told(self):
        program = self.program
        program.set("scanline_period", "4.1")
        program.wait("bands every 164 px are reported", lambda s: "moire:scanline_period" in s["widgets"])
        self.snapshot("moire")
        program.retype("scanline_period", "5")
        program.wait("a whole number is not reported",
                     lambda s: "moire:scanline_period" not in s["widgets"])

    def test_a_period_in_source_lines_is_told_by_the_pixels_that_it_comes_to(self):
        program = self.program
        program.click("look:crt")
        program.wait("the look is open", lambda s: s["look"] == "crt" and not s["is_loading"])
        program.set("scanline_period", "4.1")  # bands of 164 px, which fit into 180 px
        program.wait("the period in px is reported", lambda s: "moire:scanline_period" in s["widgets"])
        program.reveal("scanline_unit")
        program.place("picture")  # waits until the search box has lost the keyboard focus
        program.key("Down")
        program.place("revealed:scanline_unit")
        program.key("Right")
        program.wait("the unit is lines of the source", lambda s: s["values"]["scanline_unit"] == [1])
        program.key("ctrl+f", "ctrl+a")
        program.type("scanline")
        program.wait("the period in lines is reported instead of the one in px", lambda s:
                     "number:scanline_period" in s["widgets"] and
                     "moire:scanline_period" not in s["widgets"] and
                     "moire:scanline_lines" in s["widgets"])
        self.snapshot("source_lines")

    def test_a_parameter_without_effect_is_dimmed_and_can_be_changed(self):
        program = self.program
        program.set("scanline_strength", "0")
        program.reveal("scanline_period")
        program.wait("the period is dimmed", lambda s: "dimmed:scanline_period" in s["widgets"])
        self.hover("label:scanline_period")
        program.wait("the help is shown", lambda s: "help:scanline_period" in s["widgets"])
        self.snapshot("dimmed")
        program.retype("scanline_period", "6")
        program.wait("the value changes", lambda s: s["values"]["scanline_period"] == [6])
        program.set("scanline_strength", "0.5")
        program.reveal("scanline_period")
        program.wait("the period is not dimmed",
                     lambda s: "dimmed:scanline_period" not in s["widgets"])

    def test_help_shows_while_the_pointer_rests_on_a_parameter(self):
        program = self.program
        program.reveal("exposure")
        self.assertNotIn("help:exposure", program.state()["widgets"])
        self.hover("label:exposure")
        program.wait("the help is shown", lambda s: "help:exposure" in s["widgets"])
        self.snapshot("help")
        self.hover("picture")
        program.wait("the help is hidden", lambda s: "help:exposure" not in s["widgets"])

    def test_a_paused_picture_follows_a_knob(self):
        program = self.program
        program.reveal("exposure")
        program.click("play")
        program.wait("playback stops", lambda s: not s["is_playing"])
        dark = self.brightness()
        low, high, y = program.slider("exposure")
        program.drag(((low + high) // 2, y), (high, y))
        program.wait_for("the paused picture is brighter", lambda: self.brightness() > dark + 3)

    def test_outlines_of_controls_have_a_contrast_of_3(self):
        """WCAG 2.1, success criterion 1.4.11, for a check box, a slider and a list."""
        def luminance(pixel):
            linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4
                      for c in (value / 255 for value in pixel)]
            return 0.0722 * linear[0] + 0.7152 * linear[1] + 0.2126 * linear[2]  # blue, green, red
        for name in ("one_color", "vignette", "tube"):
            self.program.reveal(name)
            left, top, _, bottom = self.program.place("parameter:" + name)
            row = self.screen.rows(left - 3, (top + bottom) // 2, left + 3, (top + bottom) // 2 + 1)[0]
            pixels = [luminance(row[i:i + 3]) for i in range(0, len(row), 4)]
            self.assertGreaterEqual((max(pixels[1:]) + 0.05) / (pixels[0] + 0.05), 3, name)

    def test_a_slider_runs_between_ends_that_are_typed(self):
        program = self.program
        program.reveal("exposure")
        low, high, y = program.slider("exposure")
        program.click("label:exposure")
        program.click("slider_high")
        program.type("4")
        program.key("Return")
        program.place("reset_slider_ends")
        self.snapshot("ends")
        program.key("Escape")
        program.drag(((low + high) // 2, y), (high + 20, y))
        program.wait("the drag ends at 4", lambda s: s["values"]["exposure"] == [4])
        program.click("label:exposure")
        program.click("slider_low")
        program.type("7")
        program.key("Return")
        program.wait("a minimum above the maximum is reported", lambda s:
                     "got 7 and 4" in s["notice"])
        program.click("reset_slider_ends")
        program.wait("the slider range of the look is restored", lambda s:
                     "reset_slider_ends" not in s["widgets"])
        program.key("Escape")
        program.drag(((low + high) // 2, y), (high + 20, y))
        program.wait("the slider range is larger", lambda s: s["values"]["exposure"][0] > 8)

    def test_a_hand_with_alt_is_ten_times_coarser_and_with_shift_finer(self):
        program = self.program
        program.set("keep_hue", "0.8")
        low, high, y = program.slider("keep_hue")

        def turned(key):
            self.screen.do("keydown", key)
            program.drag((high - 10, y), (high - 14, y))
            self.screen.do("keyup", key)
            state = program.wait("the drag changes the value", lambda s: s["values"]["keep_hue"][0] < 0.8)
            program.key("ctrl+z")
            program.wait("undo restores the value", lambda s: s["values"]["keep_hue"][0] == 0.8)
            return 0.8 - state["values"]["keep_hue"][0]
        share = 4 / (high - low)
        self.assertTrue(7 * share < turned("alt") < 13 * share)
        self.assertTrue(0.07 * share < turned("shift") < 0.13 * share)

    def test_one_key_wipes_to_the_articles_own_picture(self):
        program = self.program
        program.click("play")
        program.wait("playback stops", lambda s: not s["is_playing"])
        program.key("w")
        left, top, right, bottom = program.place("wipe")
        self.snapshot("wipe")
        place = program.place("picture")
        y = bottom - 40
        program.drag(((left + right) // 2, y), (place[2] - 20, y))
        program.wait("the line follows the pointer", lambda s: s["wipe"] > 0.9)
        self.hover("picture")
        article = program.wait("the article's value is reported", lambda s: s["probe"])["probe"]
        left, top, right, bottom = program.place("wipe")
        program.drag(((left + right) // 2, y), (place[0] + 20, y))
        program.wait("the line is moved back", lambda s: s["wipe"] < 0.1)
        self.hover("picture")
        ours = program.wait("the value of the look is reported", lambda s: s["probe"] and
                            s["probe"]["rgba"] != article["rgba"])["probe"]
        self.assertEqual((ours["x"], ours["y"]), (article["x"], article["y"]))
        program.key("w")
        state = program.wait("the comparison is off", lambda s: s["wipe"] is None)
        self.assertNotIn("wipe", state["widgets"])
        self.assertFalse(state["is_modified"])
