"""Inspecting the picture and its passes."""

from person import WINDOW, Person


class Looking(Person):
    def test_a_pass_can_be_looked_into(self):
        program = self.program
        program.click("pass:persistence")
        program.wait("the pass is inspected", lambda s: s["inspected"] == "persistence")
        program.click("channels:G")
        self.hover("inspector")
        program.wait("the value under the pointer is reported",
                     lambda s: s["probe"] and s["probe"]["pass"] == "persistence" and
                     len(s["probe"]["rgba"]) == 4)
        self.snapshot("inspector")
        program.key("p")
        program.place("back_to_picture")
        self.hover("picture")
        state = program.wait("the pass replaces the picture, and its values are reported",
                             lambda s: s["probe"] and s["probe"]["pass"] == "persistence")
        middle = [length / 2 for length in self.size]
        probe = state["probe"]
        self.assertLess(abs(probe["x"] - middle[0]) + abs(probe["y"] - middle[1]), 3)
        program.click("channels:RGB")
        before = self.brightness()
        program.key("e", "e", "e")
        program.wait_for("three stops are brighter", lambda: self.brightness() > before + 3)
        self.snapshot("large_pass")
        program.key("shift+e", "shift+e", "shift+e", "Escape")
        program.wait("Escape restores the picture",
                     lambda s: "back_to_picture" not in s["widgets"])

    def test_the_numbers_of_a_pass_are_measured_marked_and_saved(self):
        program = self.program
        program.click("pass:persistence")
        state = program.wait("the pass is measured",
                             lambda s: s["measured"] and s["measured"]["maximum"] > 1)
        self.assertEqual(state["levels"], [0, 1])
        self.assertEqual(state["measured"]["flaws"], 0)
        program.key("space")
        program.wait("playback stops", lambda s: not s["is_playing"])
        program.click("fit_levels")
        state = program.wait("black and white are the range of the values",
                             lambda s: s["measured"] and s["levels"] ==
                             [s["measured"]["minimum"], s["measured"]["maximum"]])
        self.fit_right_after_a_change_of_channels()
        left, top, right, bottom = program.place("histogram")
        middle = (top + bottom) // 2
        program.drag((right - 20, middle), (right - 20 - (right - left) // 2, middle))
        white = state["levels"][1]
        program.wait("a drag over half the strip halves white",
                     lambda s: abs(s["levels"][1] / white - 0.5) < 0.02 and s["levels"][0] == 0)
        program.click("level:black")
        program.type("0.125")
        program.key("Return")
        program.wait("the typed black point is set", lambda s: s["levels"][0] == 0.125)
        program.click("mark_clipping")
        program.click("false_color")
        self.snapshot("levels")
        for name in ("mark_clipping", "false_color", "reset_levels"):
            program.click(name)
        program.wait("the levels are reset", lambda s: s["levels"] == [0, 1])

        program.click("save_pass")
        program.place("dialog_file")
        program.key("ctrl+a")
        program.type(str(program.folder / "seen.png"))
        program.key("Return")
        program.wait("the saved pass is reported", lambda s: "seen.png" in s["notice"])
        self.assertEqual((program.folder / "seen.png").read_bytes()[:4], b"\x89PNG")
        program.key("space")

    def fit_right_after_a_change_of_channels(self):
        """No click is lost: the fit waits for the statistics of the new channel."""
        program = self.program
        before = program.state()
        program.click("reset_levels")
        program.wait("levels are reset", lambda s: s["levels"] == [0, 1])
        places = [program.middle(name) for name in ("channels:R", "fit_levels")]
        self.screen.do("mousemove", *places[0], "click", 1, "mousemove", *places[1], "click", 1)
        program.wait("the range of red is fitted", lambda s:
                     s["measured"] and s["channels"] != before["channels"] and s["levels"] ==
                     [s["measured"]["minimum"], s["measured"]["maximum"]])
        program.click("channels:RGB")
        program.click("fit_levels")
        program.wait("the range of all channels is fitted again", lambda s: s["levels"] == before["levels"])

    def test_a_pinned_pixel_is_followed_through_every_pass(self):
        program = self.program
        self.hover("picture")
        program.wait("the pointer is over the picture", lambda s: s["probe"])
        program.key("k")
        program.place("unpin:1")
        self.screen.do("mousemove", *program.middle("inspector"), "keydown", "ctrl", "click", 1,
                       "keyup", "ctrl")
        program.place("unpin:2")
        state = program.wait("the value in each pass is reported",
                             lambda s: len(s["pins"]) == 2 and all(s["pins"][1]))
        self.assertGreater(len(state["pins"][0]), 5)
        self.snapshot("pins")
        for left in (1, 0):
            program.click("unpin:1")
            program.wait("the pin is removed", lambda s, count=left: len(s["pins"]) == count)
        program.key("ctrl+7")
        program.wait("the pane is closed", lambda s: "bottom:Pins" not in s["widgets"])

    def test_a_pass_tells_what_it_reads_and_what_the_driver_got(self):
        program = self.program
        program.click("pass:persistence")
        program.key("ctrl+8")
        program.place("reads:current")
        self.snapshot("reads")
        program.click("reads:current")
        program.wait("a click inspects the input", lambda s: s["inspected"] == "beam")
        program.key("ctrl+9")
        program.click("text_line:beam.frag:2")
        program.wait_for("a click on a line opens the editor there",
                         lambda: "beam.frag" in program.edited_files())
        self.snapshot("text")
        program.key("ctrl+9")
        program.wait("the pane is closed", lambda s: "bottom:Compiled" not in s["widgets"])

    def test_every_pass_of_the_strip_tells_how_loud_it_is(self):
        program = self.program
        state = program.wait("every pass has been measured",
                             lambda s: len(s["gains"]) > 5 and all(s["gains"]))
        self.assertGreater(state["gains"][0][0], 0)
        self.assertLessEqual(state["gains"][-1][0], 1)
        self.snapshot("gains")

    def test_the_strip_tells_of_every_pass_also_when_it_opens_over_a_picture_that_rests(self):
        program = self.program
        program.key("space")
        before = program.wait("every pass has been measured",
                              lambda s: not s["is_playing"] and len(s["gains"]) > 5 and all(s["gains"]))
        program.key("ctrl+4")
        program.wait("the strip is closed", lambda s: "pass:beam" not in s["widgets"])
        program.key("ctrl+4")
        program.wait("the beam is measured as before without its own target",
                     lambda s: s["gains"] and s["gains"][0] and s["gains"][0][0] > 0 and
                     s["frame"] == before["frame"])
        program.key("space")

    def test_a_pass_is_switched_to_see_what_it_does(self):
        program = self.program

        def switch(name, label, what, is_so):
            self.screen.do("mousemove", *program.middle("pass:" + name), "click", 3)
            program.click("switch:" + label)
            program.wait(what, lambda s: is_so(s["switches"]) and "switch:Solo" not in s["widgets"])

        lit = self.brightness()
        switch("reduced", "Freeze", "the pass is frozen", lambda s: s["frozen"] == ["reduced"])
        switch("persistence", "Bypass", "the pass is bypassed", lambda s: s["bypassed"] == ["persistence"])
        switch("persistence", "Stop here", "later passes are not drawn",
               lambda s: s["last"] == "persistence")
        program.place("back_to_picture")
        program.click("pass:reduced")
        program.key("g")
        program.place("node:reduced")
        self.snapshot("switched")
        program.click("node:bloom_down_1")
        program.wait("a click in the graph inspects the pass", lambda s: s["inspected"] == "bloom_down_1")
        program.click("pass:beam")
        program.wait("a click in the strip inspects the pass", lambda s: s["inspected"] == "beam")
        program.key("shift+b")
        program.wait("the reason against the bypass is reported",
                     lambda s: "it has no inputs" in s["notice"])
        program.click("back_to_picture")
        program.wait("all passes are drawn again", lambda s: not s["switches"]["last"])
        program.key("ctrl+p")
        program.place("palette_query")
        program.type("clear solo")
        program.key("Return")
        program.wait("all switches are off", lambda s: not any(s["switches"].values()))
        program.click("pass:persistence")
        program.key("shift+h", "g")
        program.wait_for("the picture is as before", lambda: self.brightness() > lit / 2)

    def test_a_pyramid_leaves_room_for_all_passes_and_keys_step_through_those_that_draw(self):
        program = self.program
        program.wait("the first pass, all levels and the last pass are visible",
                     lambda s: {"pass:beam", "pass:bloom_down_6", "pass:bloom_up_1",
                                "pass:composite"} <= set(s["widgets"]))
        program.click("pass:bloom_down_2")
        program.wait("a click inspects a level", lambda s: s["inspected"] == "bloom_down_2")
        self.snapshot("pyramid")
        program.key("n")
        program.wait("N inspects the next pass", lambda s: s["inspected"] == "bloom_down_3")
        program.click("pass:beam")
        program.key("n")
        program.wait("N skips passes that are not drawn",
                     lambda s: s["inspected"] == "persistence")
        program.key("shift+n", "shift+n")
        program.wait("Shift+N wraps from the first pass to the last", lambda s: s["inspected"] == "composite")

    def test_a_pass_that_keys_choose_comes_into_sight_in_the_strip(self):
        program = self.program
        self.open_by_name(self.presets / "phosphor+crt/night-ward.json")
        program.wait("both looks are drawn", lambda s: "pass:phosphor/beam" in s["widgets"])
        program.click("pass:phosphor/beam")

        def is_whole(s, name):
            left, _, right, _ = s["widgets"].get("pass:" + name, (0, 0, 0, 0))
            ends = s["widgets"]["picture"]
            return ends[0] <= left < right <= ends[2]
        program.wait("only the first pass is visible", lambda s: s["inspected"] == "phosphor/beam" and
                     is_whole(s, "phosphor/beam") and not is_whole(s, "crt/crt"))
        program.key("shift+n")
        program.wait("only the last pass is visible", lambda s: s["inspected"] == "crt/crt" and
                     is_whole(s, "crt/crt") and not is_whole(s, "phosphor/beam"))
        self.snapshot("last_pass")

    def test_the_time_of_passes_is_held_against_a_budget(self):
        program = self.program
        program.key("ctrl+6")
        program.click("budget")
        program.type("0.5")
        program.key("Return")
        program.place("budget")
        self.snapshot("timings")
        program.click("budget")
        program.type("16.67")
        program.key("Return", "ctrl+6")
        program.wait("the pane is closed", lambda s: "budget" not in s["widgets"])

    def test_a_frame_ago_is_looked_into_texel_by_texel_and_along_a_line(self):
        program = self.program
        program.click("pass:persistence")
        program.click("inspector_frame")
        program.click("inspect:persistence@1")
        self.hover("inspector")
        program.wait("the pixel of the previous frame is reported",
                     lambda s: s["probe"] and s["probe"]["pass"] == "persistence@1")
        self.screen.do("click", "--repeat", 12, "--delay", 5, 4)
        program.wait("texel values are shown", lambda s: s["cells"][1] >= 4)
        self.snapshot("cells")
        program.key("l")
        program.wait("the middle row of the picture is plotted", lambda s: s["waveform"] == self.size[0])
        x, y = program.middle("picture")
        program.drag(program.middle("line_end"), (x, y))
        program.wait("the line is half as long",
                     lambda s: abs(s["waveform"] - self.size[0] / 2) < 4 and s["scan_line"][0] == 0)
        self.snapshot("waveform")
        self.screen.do("keydown", "shift")
        program.drag((x - 40, y - 50), (x + 40, y + 50))
        self.screen.do("keyup", "shift")
        program.wait("a drag with Shift draws a new line", lambda s: s["scan_line"][0] > 0.3 and
                     s["scan_line"][1] < 0.4 < 0.6 < s["scan_line"][3])
        program.key("l")
        program.click("pass:persistence")
        program.key("p", "f", "p")
        program.wait("the pane is closed and no texel values are shown",
                     lambda s: s["waveform"] == 0 and s["cells"] == [0, 0] and
                     s["looks_into"] == "persistence" and
                     "back_to_picture" not in s["widgets"])

    def test_the_wheel_zooms_about_the_pointer(self):
        program = self.program
        program.key("f")
        x, y = program.middle("picture")
        left, right = self.column_at(x, y), self.column_at(x + 96, y)
        self.screen.do("mousemove", x, y, "click", "--repeat", 4, "--delay", 5, 4)
        program.wait_for("neighbouring pixels are further apart",
                         lambda: self.column_at(x + 96, y) - left <= (right - left) / 2)
        self.assertLessEqual(abs(self.column_at(x, y) - left), 1)
        self.snapshot("zoomed")
        program.key("f")
        program.wait_for("F shows the whole picture again", lambda: self.column_at(x + 96, y) == right)

    def test_a_flash_is_seen_to_fall_in_every_pass(self):
        program = self.program
        self.hover("picture")
        program.wait("the pointer is over the picture", lambda s: s["probe"])
        program.key("i")
        program.place("impulse:persistence")
        self.snapshot("impulse")
        program.key("Escape")
        program.wait("the dialog is closed", lambda s: not s["dialog"])

    def test_flashes_are_counted_and_may_be_clamped(self):
        program = self.program
        program.click("flashes")
        program.click("comfort")
        program.wait("the flash limiter is on", lambda s: s["comfort"])
        program.place("comfort_rate")
        self.snapshot("flashes")
        program.key("Escape")
        program.choose("View", "Flash limiter")
        program.wait("the flash limiter is off", lambda s: not s["comfort"])

    def test_an_hdr_preview_is_marked_and_has_its_light(self):
        program = self.program
        program.choose("View", "HDR preview")
        program.wait("the preview is for the usual light", lambda s: s["hdr"] == [203, 1000])
        program.click("hdr")
        program.place("hdr_peak")
        self.snapshot("hdr")
        program.key("Escape")
        program.choose("View", "HDR preview")
        program.wait("the picture is as before", lambda s: s["hdr"] == [0, 0] and s["gains"][-1][0] <= 1)

    def test_everything_fits_a_small_window(self):
        program = self.program
        width, height = 900, 600
        self.screen.resize(width, height)
        program.wait("the panes shrink", lambda s: 0 < s["widgets"]["search"][2] <= width)
        program.key("F1")
        program.place("dialog_cancel")
        self.snapshot("small_keys")
        for key in ("Escape", "ctrl+o", "Escape"):
            state = program.wait("the dialog is within the window", lambda s: all(
                0 <= place[0] and 0 <= place[1] and place[2] <= width and place[3] <= height
                for name, place in s["widgets"].items() if name.startswith("dialog")))
            program.key(key)
            program.wait("a dialog opens or closes", lambda s, then=state: s["dialog"] != then["dialog"])
        self.snapshot("small")
        row = [program.place(name) for name in ("restart", "play", "step", "picture_size", "zoom")]
        for left, right in zip(row, row[1:]):
            self.assertLessEqual(left[2], right[0])
        self.screen.resize(*WINDOW)
