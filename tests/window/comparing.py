"""Comparing the picture with another one."""

from person import Person


class Comparing(Person):
    def test_a_dropped_picture_is_compared_with(self):
        program = self.program
        file = program.folder / "screen.png"
        self.screen.save(file)
        self.drop(file)
        program.wait("it is on the other side", lambda s: s["wipe"] and
                     s["compare"]["other"].startswith("screen.png") and
                     "fitted" in s["compare"]["other"])
        program.key("w")
        program.wait("ours is alone", lambda s: s["compare"]["mode"] == "off")
