"""A person lets things move by themselves, and has others move them."""

from person import Person


class Moving(Person):
    def test_a_parameter_moves_by_itself(self):
        program = self.program
        state = program.state()
        default = state["values"]["exposure"]
        program.reveal("exposure")
        self.hover("label:exposure")
        self.screen.do("click", 3)
        program.click("modulation")
        program.click("modulation:lfo")
        program.wait("it moves, in one step", lambda s: "exposure" in s["moving"] and
                     s["undo"] == "Modulation of Exposure" and s["is_modified"])
        seen = set()
        program.wait("the value of now goes up and down", lambda s:
                     seen.add(s["moving"]["exposure"]) or max(seen) - min(seen) > 1)
        self.snapshot("modulation")
        state = program.state()
        self.assertEqual(state["values"]["exposure"], default)
        program.click("modulation")
        program.click("modulation:rests")
        program.wait("it rests", lambda s: s["moving"] == {} and not s["is_modified"])
