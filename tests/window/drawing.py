"""Drawing with the beam."""

from person import Person


class Drawing(Person):
    def strokes(self):
        """The strokes in the text of the signal."""
        return self.program.state()["signal"].partition("strokes=")[2]

    def ask_file(self, button, file):
        self.program.click(button)
        self.program.place("dialog_file")
        self.program.key("ctrl+a")
        self.program.type(str(file))
        self.program.key("Return")

    def edit_point(self, x, y):
        """Moves the point at this position, deletes it, and undoes both."""
        program = self.program
        program.click("pen_tool:Edit")
        before = self.strokes()
        program.drag((x, y), (x + 20, y + 20))
        program.wait("a point is moved in one step", lambda s:
                     s["undo"] == "Move point" and s["redo"] == "")
        self.assertEqual(self.strokes().count(" "), before.count(" "))
        self.snapshot("edited")
        program.key("ctrl+z")
        program.wait("undo moves the point back", lambda s: self.strokes() == before)
        self.screen.do("mousemove", x, y, "click", 3)
        program.wait("the secondary button deletes the point", lambda s:
                     s["undo"] == "Delete point" and
                     self.strokes().count(" ") == before.count(" ") - 2)
        program.key("ctrl+z")

    def test_a_person_draws_on_the_picture_and_keeps_it_as_an_svg(self):
        program = self.program
        self.hover("picture")
        program.key("d")
        program.wait("the drawing is empty and the pen is active", lambda s:
                     s["signal"] == "drawing:fit=whole,strokes=[]" and "pen_tool:Freehand" in s["widgets"])
        x, y = program.middle("picture")
        box = (x - 60, y + 37, x + 60, y + 43)
        program.wait_for("the previous figure has faded", lambda: self.screen.brightness(box) < 25)
        program.click("pen_line:Straight")
        program.drag((x - 90, y + 40), (x + 90, y + 40))
        program.wait("one stroke is one step", lambda s:
                     s["undo"] == "Stroke" and "[L" in s["signal"] and s["signal"].count(" ") == 3)
        program.wait_for("the beam draws the stroke", lambda: self.screen.brightness(box) > 60)
        left, height, right, _ = (float(number) for number in self.strokes()[2:-1].split())
        self.assertLess(abs(left + right), 0.02)  # symmetric about the centre
        self.assertLess(height, -0.1)
        program.key("ctrl+z")
        program.wait("undo removes the stroke", lambda s: s["signal"] == "drawing:fit=whole,strokes=[]")
        program.wait_for("the stroke is gone from the picture", lambda: self.screen.brightness(box) < 25)
        program.key("ctrl+shift+z")
        program.click("pen_tool:Points")
        program.click("pen_line:Smooth")
        for place in ((x - 80, y), (x, y - 60), (x + 80, y)):
            self.screen.do("mousemove", *place, "click", 1)
        program.wait("three clicks draw a line", lambda s: s["signal"].count(" ") == 8)
        self.snapshot("drawing")
        program.key("Escape")
        self.edit_point(x, y - 60)
        program.click("keyframe_copy")
        program.wait("there is a second keyframe", lambda s: "keyframe:2" in s["widgets"])
        program.click("pen_tool:Erase")
        self.screen.do("mousemove", x, y + 40, "click", 1)
        program.wait("the stroke is deleted", lambda s: s["undo"] == "Delete stroke")
        self.snapshot("erased")
        drawn = self.strokes()
        file = program.folder / "mine.svg"
        self.ask_file("save_drawing", file)
        program.wait("the drawing is saved", lambda s: 'Saved "mine.svg"' in s["notice"])
        self.assertEqual(file.read_text().count("data-keyframe"), 2)
        program.click("keyframe_clear")
        program.wait("the keyframe is empty", lambda s: s["signal"].endswith("[]"))
        (program.folder / "none.svg").write_text("<svg><desc>nothing</desc></svg>")
        self.ask_file("load_drawing", program.folder / "none.svg")
        program.place("dialog_problem")  # an SVG without lines; the dialog stays open
        program.key("ctrl+a")
        program.type(str(file))
        program.key("Return")
        program.wait("the drawing is loaded with its keyframes",
                     lambda s: s["undo"] == "Load drawing" and self.strokes() == drawn)
        program.key("Escape")
        program.wait("Escape deactivates the pen", lambda s: "pen_tool:Points" not in s["widgets"])
        self.snapshot("drawn")
