"""The list of parameters: search, filters, reset, Randomise and undo history."""

from person import Person


class Listing(Person):
    def test_one_group_and_all_are_reset(self):
        program = self.program
        default = program.state()["values"]
        for name in ("decay", "exposure"):
            program.set(name, "0.61")
        program.reveal("decay")
        program.click("reset_group:Phosphor")
        program.wait("the group is reset and another one is not", lambda s: s["undo"] == "Reset group" and
                     s["values"]["decay"] == default["decay"] and s["values"]["exposure"] == [0.61])
        program.choose("Edit", "Reset all parameters")
        program.wait("all parameters are reset", lambda s: s["values"] == default)

    def test_dice_turn_all_but_what_is_locked_in_one_step(self):
        program = self.program
        default = program.state()["values"]
        program.reveal("exposure")
        self.assertNotIn("lock:exposure", program.state()["widgets"])
        self.hover("label:exposure")
        self.hover("lock:exposure")
        self.snapshot("lock")
        program.click("lock:exposure")
        program.wait("the parameter is locked", lambda s: s["locked"] == ["exposure"])
        self.hover("picture")
        program.wait("the padlock is visible and the star is not", lambda s: "lock:exposure" in s["widgets"]
                     and "star:exposure" not in s["widgets"])
        program.key("ctrl+r")
        state = program.wait("the values are randomised", lambda s: s["undo"] == "Randomise"
                             and "randomised" in s["notice"])
        self.assertEqual(state["values"]["exposure"], default["exposure"])
        self.assertGreater(sum(state["values"][name] != default[name] for name in default),
                           len(default) // 2)
        self.snapshot("randomised")
        program.click("offer:Undo")
        program.wait("one undo restores the defaults", lambda s: s["values"] == default)
        program.click("lock:exposure")
        program.wait("the parameter is unlocked", lambda s: s["locked"] == [])

    def test_keys_belong_to_an_open_list(self):
        program = self.program
        program.reveal("tube")
        program.click("parameter:tube")
        program.place("item:tube:P31")
        self.snapshot("tubes")
        program.key("Down", "Down", "Return")
        program.wait("the second tube after Custom is chosen", lambda s: s["values"]["tube"] == [2])
        program.click("parameter:tube")
        program.place("item:tube:P31")
        program.key("h", "Escape")
        state = program.wait("the list is closed", lambda s: "item:tube:P31" not in s["widgets"])
        self.assertEqual(state["values"]["tube"], [2])

    def test_escape_clears_the_search_and_then_leaves_it(self):
        program = self.program
        program.key("ctrl+f", "ctrl+a")
        program.type("expo")
        program.wait("the list is filtered", lambda s: "parameter:beam_width" not in s["widgets"])
        program.key("Escape")
        program.wait("the search is empty", lambda s: "parameter:beam_width" in s["widgets"]
                     and "search_clear" not in s["widgets"])
        program.type("vign")  # the box still has the focus
        program.wait("the list is filtered", lambda s: "parameter:vignette" in s["widgets"]
                     and "parameter:beam_width" not in s["widgets"])
        program.click("search_clear")
        program.wait("the search is empty", lambda s: "parameter:beam_width" in s["widgets"])
        program.key("ctrl+f")
        program.type("vign")
        program.wait("the list is filtered", lambda s: "parameter:beam_width" not in s["widgets"])
        program.key("ctrl+a", "BackSpace", "Escape")
        program.place("picture")
        self.assertNotIn("search_clear", program.state()["widgets"], "an emptied box stays empty")

    def test_the_die_of_a_group_randomises_it_with_the_chosen_strength(self):
        program = self.program
        default = program.state()["values"]
        self.screen.do("mousemove", *program.middle("randomise"), "click", 3)
        program.click("random_strength:0.1")
        program.reveal("vignette")
        self.hover("group:Glass")
        self.snapshot("randomise_group")
        program.click("randomise_group:Glass")
        values = program.wait("the group is randomised", lambda s: s["undo"] == "Randomise")["values"]
        self.assertEqual(values["exposure"], default["exposure"])
        self.assertNotEqual(values["vignette"], default["vignette"])
        self.assertLessEqual(abs(values["vignette"][0] - default["vignette"][0]), 0.1)  # of 0..1
        self.screen.do("mousemove", *program.middle("randomise"), "click", 3)
        program.click("random_strength:1")

    def test_the_list_is_cut_to_favourites_changes_or_a_pass(self):
        program = self.program
        program.set("exposure", "0.61")
        self.hover("label:exposure")
        program.click("star:exposure")
        program.wait("the parameter is a favourite", lambda s: s["favourites"] == ["exposure"])
        program.key("ctrl+f", "ctrl+a", "BackSpace", "Return")

        def listed(s):
            return [name[len("label:"):] for name in s["widgets"] if name.startswith("label:")]

        def choose(name):
            program.click("filter")
            program.click("filter:" + name)
        choose("Favourites")
        program.wait("only the favourite is listed", lambda s: listed(s) == ["exposure"])
        self.snapshot("favourites")
        choose("Changed")
        program.wait("only the changed parameter is listed", lambda s: listed(s) == ["exposure"])
        program.click("pass:bloom_down_1")
        choose("This pass")
        program.wait("the pass does not use the parameter",
                     lambda s: "exposure" not in listed(s) and len(listed(s)) > 0)
        self.snapshot("this_pass")
        program.choose("Edit", "Show only favourites")
        self.hover("label:exposure")
        program.click("star:exposure")
        program.wait("the list of favourites is empty", lambda s: listed(s) == [] and
                     s["favourites"] == [])
        program.click("show_all")
        program.wait("all parameters are listed", lambda s: len(listed(s)) > 3)

    def test_a_long_list_scrolls_to_its_end_where_all_is_as_elsewhere(self):
        program = self.program
        program.key("ctrl+f", "ctrl+a", "BackSpace", "Return")
        x, y = program.middle("search")
        self.screen.do("mousemove", x, y + 100, *["click", 5] * 28)
        program.wait("the end of the list is visible", lambda s: "label:as_written" in s["widgets"])
        self.screen.do(*["click", 4] * 28)
        program.wait("the start of the list is visible again", lambda s: "label:as_written" not in s["widgets"])

    def test_everything_is_found_by_name(self):
        program = self.program
        program.key("ctrl+p")
        program.place("palette_query")
        program.type("paramexpo")
        program.wait("the parameter is found", lambda s: "palette:Parameter: Exposure" in s["widgets"])
        self.snapshot("palette")
        program.key("Return")
        program.wait("the parameter is shown in its panel", lambda s: s["dialog"] == 0 and
                     {"revealed:exposure", "parameter:exposure"} <= set(s["widgets"]))
        program.key("ctrl+p")
        program.place("palette_query")
        program.key("Down", "Up", "Return")
        program.wait("the most recent entry is first", lambda s: s["dialog"] == 0)
        program.key("ctrl+p")
        program.place("palette_query")
        program.type("preset overd")
        program.wait("a preset is found", lambda s: "palette:Preset: Overdriven" in s["widgets"])
        program.click("palette:Preset: Overdriven")
        program.wait("the preset opens", lambda s: s["preset"] == "Overdriven")
        program.key("ctrl+p")
        program.place("palette_query")
        program.type("undo")
        program.wait("the entry of the action contains its subject", lambda s:
                     "palette:Undo: Open Overdriven" in s["widgets"])
        program.key("Return")
        program.wait("the action is done", lambda s: s["dialog"] == 0 and not s["preset"])
        program.key("ctrl+p")
        program.place("palette_query")
        program.type("rename preset")
        program.wait("an unavailable action is listed", lambda s:
                     "palette:Rename preset…" in s["widgets"])
        program.key("Return", "Escape")
        program.wait("the unavailable action is not done", lambda s: s["dialog"] == 0)

    def test_the_history_lists_every_step_and_goes_there(self):
        program = self.program
        default = program.state()["values"]["decay"][0]
        for text in ("0.8", "0.7", "0.6"):
            program.set("decay", text)
        self.hover("picture")
        program.choose("Edit", "History")
        program.place("history_close")
        steps = [name for name in program.state()["widgets"] if name.startswith("history:")]
        last = max(int(name.split(":")[1]) for name in steps)
        self.snapshot("history")
        program.click("history:%d" % (last - 3))
        program.wait("three steps are undone at once",
                     lambda s: s["values"]["decay"] == [default] and s["redo"] == "Decay")
        program.click("history:%d" % (last - 1))
        program.wait("two steps are redone at once", lambda s: s["values"]["decay"] == [0.7])
        program.set("decay", "0.5")
        program.wait("a new step replaces the undone ones", lambda s:
                     "history:%d" % last in s["widgets"] and s["redo"] == "")
        program.key("ctrl+h")
        program.wait("the list of looks is back", lambda s: "history_close" not in s["widgets"] and
                     "look:phosphor" in s["widgets"])
