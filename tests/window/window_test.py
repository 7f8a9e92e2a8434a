"""Drives the window with mouse and keyboard: window_test.py PROGRAM [WindowTest.NAME...]."""

import json
import os
import sys
import unittest
from pathlib import Path

from person import PICTURE, WINDOW, Person, write_tones

Person.executable = Path(sys.argv[1]).resolve()


class WindowTest(Person):
    """Each test finds the look as it was first."""

    def test_a_knob_turns_the_picture_and_undo_turns_it_back(self):
        program = self.program
        state = program.state()
        self.snapshot("started")
        default = state["values"]["exposure"][0]
        dark = self.brightness()
        program.reveal("exposure")
        low, high, y = program.slider("exposure")
        program.drag(((low + high) // 2, y), (high, y))
        program.wait("the exposure is turned up, in one step",
                     lambda s: s["values"]["exposure"][0] > 4 * default and
                     s["undo"] == "Exposure" and s["is_modified"])
        program.wait_for("the picture is brighter", lambda: self.brightness() > dark + 3)
        self.snapshot("turned")

        program.key("ctrl+z")
        program.wait("one step back is the default again",
                     lambda s: s["values"]["exposure"][0] == default and
                     s["undo"] == state["undo"])
        program.wait_for("the picture is as dark as before", lambda: self.brightness() < dark + 2)
        program.key("ctrl+shift+z")
        program.wait("redo turns it up again",
                     lambda s: s["values"]["exposure"][0] > 4 * default and s["redo"] == "")
        program.click("reset:exposure")
        program.wait("its reset button gives the default",
                     lambda s: s["values"]["exposure"][0] == default)

    def test_a_number_is_typed(self):
        program = self.program
        program.set("exposure", "20.5")  # beyond the slider
        program.retype("exposure", "0,75")
        program.wait("a comma is a point", lambda s: s["values"]["exposure"] == [0.75])
        program.retype("exposure", "much")
        program.wait("what is no number is told", lambda s: "'much' is no number" in s["notice"])
        program.retype("exposure", "4,096")
        program.wait("what may be two numbers is told", lambda s: "may mean" in s["notice"])
        self.assertEqual(program.state()["values"]["exposure"], [0.75])
        program.set("decay", "0.5")
        program.retype("decay", "7")
        program.wait("it stops at the hard limit, which is told", lambda s:
                     s["values"]["decay"] == [1] and "at most 1" in s["notice"].lower())
        program.click("number:decay")
        program.type("0.25")
        program.click("label:decay")
        program.wait("leaving the field takes it too", lambda s: s["values"]["decay"] == [0.25])

    def test_help_shows_while_the_pointer_rests_on_a_parameter(self):
        program = self.program
        program.reveal("exposure")
        self.assertNotIn("help:exposure", program.state()["widgets"])
        self.hover("label:exposure")
        program.wait("its help is shown", lambda s: "help:exposure" in s["widgets"])
        self.snapshot("help")
        self.hover("picture")
        program.wait("and goes", lambda s: "help:exposure" not in s["widgets"])

    def test_the_wheel_zooms_about_the_pointer(self):
        program = self.program
        program.key("f")
        x, y = program.middle("picture")
        left, right = self.column_at(x, y), self.column_at(x + 96, y)
        self.screen.do("mousemove", x, y, "click", "--repeat", 4, "--delay", 5, 4)
        program.wait_for("what is beside is further away",
                         lambda: self.column_at(x + 96, y) - left <= (right - left) / 2)
        self.assertLessEqual(abs(self.column_at(x, y) - left), 1)
        self.snapshot("zoomed")
        program.key("f")
        program.wait_for("F shows it whole again", lambda: self.column_at(x + 96, y) == right)

    def test_time_stops_steps_and_starts_again(self):
        program = self.program
        self.hover("picture")
        program.key("space")
        state = program.wait("it stops", lambda s: not s["is_playing"])
        frame = program.state()["frame"]
        program.key("period")
        program.wait("one frame on", lambda s: s["frame"] == frame + 1)
        program.click("play")
        program.wait("it runs again", lambda s: s["is_playing"] and s["frame"] > state["frame"] + 5)
        program.key("r")
        program.wait("it starts anew", lambda s: s["frame"] < 60)

    def test_a_paused_picture_follows_a_knob(self):
        program = self.program
        program.reveal("exposure")
        program.click("play")
        program.wait("it stops", lambda s: not s["is_playing"])
        dark = self.brightness()
        low, high, y = program.slider("exposure")
        program.drag(((low + high) // 2, y), (high, y))
        program.wait_for("the resting picture is brighter", lambda: self.brightness() > dark + 3)

    def test_one_key_wipes_to_the_articles_own_picture(self):
        program = self.program
        program.click("play")
        program.wait("it stops", lambda s: not s["is_playing"])
        program.key("w")
        left, top, right, bottom = program.place("wipe")
        self.snapshot("wipe")
        place = program.place("picture")
        y = bottom - 40
        program.drag(((left + right) // 2, y), (place[2] - 20, y))
        program.wait("the line goes with the hand", lambda s: s["wipe"] > 0.9)
        self.hover("picture")
        article = program.wait("the article's value is told", lambda s: s["probe"])["probe"]
        left, top, right, bottom = program.place("wipe")
        program.drag(((left + right) // 2, y), (place[0] + 20, y))
        program.wait("and back", lambda s: s["wipe"] < 0.1)
        self.hover("picture")
        ours = program.wait("ours is told where ours is", lambda s: s["probe"] and
                            s["probe"]["rgba"] != article["rgba"])["probe"]
        self.assertEqual((ours["x"], ours["y"]), (article["x"], article["y"]))
        program.key("w")
        state = program.wait("the picture is alone again", lambda s: s["wipe"] is None)
        self.assertNotIn("wipe", state["widgets"])
        self.assertFalse(state["is_modified"])

    def test_presets_are_saved_and_loaded(self):
        program = self.program
        program.set("decay", "0.61")
        program.key("ctrl+s")
        program.place("dialog_name")
        program.type("Mine")
        self.snapshot("saving")
        program.key("Return")
        program.wait("it is saved", lambda s: s["preset"] == "Mine" and not s["is_modified"])
        saved = self.presets / "phosphor/Mine.json"
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
        program.wait("nothing is replaced without being asked", lambda s: s["dialog"] == 0)
        self.assertIn('"decay": 0.61', saved.read_text())
        program.click("preset:Mine")
        program.wait("the saved values are back",
                     lambda s: s["preset"] == "Mine" and s["values"]["decay"][0] == 0.61)

    def test_presets_are_renamed_duplicated_and_deleted(self):
        program = self.program
        folder = self.presets / "phosphor"
        program.set("decay", "0.61")
        program.choose("File", "Save preset as…")
        program.answer("First")
        program.wait("it is saved", lambda s: s["preset"] == "First" and not s["is_modified"])
        program.choose("File", "Rename preset…")
        program.answer("Second")
        program.wait("it is renamed", lambda s: s["preset"] == "Second")
        self.assertFalse((folder / "First.json").exists())
        program.key("F2")
        program.place("dialog_name")
        program.key("ctrl+a")
        program.type("overdriven")
        program.place("dialog_taken")
        program.key("Return", "Escape")
        program.wait("a name that is taken is refused",
                     lambda s: s["dialog"] == 0 and s["preset"] == "Second")
        program.set("decay", "0.62")
        program.key("ctrl+d")
        state = program.wait("the copy is open", lambda s: s["preset"] == "Second 2")
        self.assertTrue(state["is_modified"])  # what was not saved goes on in the copy
        program.key("ctrl+s")
        program.wait("it is saved", lambda s: not s["is_modified"])
        self.assertIn('"decay": 0.61', (folder / "Second.json").read_text())
        self.assertIn('"decay": 0.62', (folder / "Second 2.json").read_text())
        program.choose("File", "Delete preset…")
        program.click("dialog_ok")
        program.wait("it is gone, its values stay",
                     lambda s: s["preset"] == "" and s["values"]["decay"][0] == 0.62)
        self.assertEqual([file.name for file in folder.glob("Second*")], ["Second.json"])

    def test_a_preset_travels_as_a_line_of_text(self):
        program = self.program
        program.set("decay", "0.61")
        self.hover("picture")
        program.key("ctrl+c")
        program.wait("it is copied", lambda s: "Copied" in s["notice"])
        program.key("ctrl+z")
        program.wait("the value is gone", lambda s: s["values"]["decay"][0] != 0.61)
        program.key("ctrl+v")
        program.wait("the line brings it back, as one step",
                     lambda s: s["values"]["decay"][0] == 0.61 and s["undo"] == "Paste")

    def test_one_group_and_all_are_reset(self):
        program = self.program
        default = program.state()["values"]
        for name in ("decay", "exposure"):
            program.set(name, "0.61")
        program.reveal("decay")
        program.click("reset_group:Phosphor")
        program.wait("the group is reset, another is not", lambda s: s["undo"] == "Reset group" and
                     s["values"]["decay"] == default["decay"] and s["values"]["exposure"] == [0.61])
        program.choose("Edit", "Reset all parameters")
        program.wait("all are reset", lambda s: s["values"] == default)

    def test_a_pass_is_changed_and_written_back(self):
        program = self.program
        manifest = self.looks / "phosphor/look.json"
        before = json.loads(manifest.read_text())
        program.click("pass:bloom_x")
        program.wait("it is inspected", lambda s: s["inspected"] == "bloom_x")
        program.click("pass_format")
        program.place("format:rgba16f")
        other = next(name for name in program.state()["widgets"]
                     if name.startswith("format:") and name.endswith("f") and name != "format:rgba16f")
        program.click(other)
        program.wait("the change can be taken back", lambda s: s["undo"] == "Pass bloom_x")
        program.click("write_overrides")
        program.wait("it is written", lambda s: "Written" in s["notice"])
        after = json.loads(manifest.read_text())
        bloom = [one["name"] for one in before["passes"]].index("bloom_x")
        self.assertEqual(after["passes"][bloom]["format"], other.removeprefix("format:"))
        after["passes"][bloom]["format"] = before["passes"][bloom]["format"]
        self.assertEqual(after, before)

    def test_a_parameter_and_a_pass_open_the_editor_at_their_line(self):
        program = self.program
        program.click("pass:persistence")
        program.click("edit_pass")
        program.wait_for("the pass opens", lambda: "persistence.frag" in program.edited_files())
        program.reveal("exposure")
        program.click("label:exposure")
        program.click("open_declared")
        text = (self.looks / "phosphor/composite.frag").read_text()
        line = 1 + text[:text.index("uniform float exposure")].count("\n")
        program.wait_for("the parameter opens at its line", lambda: "+%d %s" % (
            line, self.looks / "phosphor/composite.frag") in program.edited_files())

    def test_a_new_look_and_a_copy_of_one_are_the_persons_own(self):
        program = self.program
        program.set("decay", "0.61")
        program.choose("File", "Duplicate this look…")
        program.answer("my-phosphor")
        state = program.wait("the copy is open", lambda s: s["look"] == "my-phosphor")
        self.assertEqual(state["values"]["decay"], [0.61])
        self.assertTrue((self.looks / "my-phosphor/composite.frag").exists())
        program.key("ctrl+n")
        program.answer("fresh")
        state = program.wait("the new look is open and drawn",
                             lambda s: s["look"] == "fresh" and s["frame"] > 2)
        self.assertEqual(state["problems"], [])
        self.snapshot("new_look")
        program.choose("File", "Back to the session before")
        program.wait("what was not saved comes back",
                     lambda s: s["look"] == "my-phosphor" and s["values"]["decay"] == [0.61])
        program.click("look:phosphor")
        program.click("dialog_cancel")
        state = program.wait("Cancel keeps everything", lambda s: s["dialog"] == 0)
        self.assertEqual((state["look"], state["values"]["decay"]), ("my-phosphor", [0.61]))

    def test_a_preset_opens_in_one_step_and_nothing_unsaved_is_lost(self):
        program = self.program
        program.set("decay", "0.61")
        program.click("preset:overdriven")
        program.wait("it opens at once", lambda s: s["preset"] == "Overdriven" and
                     s["undo"] == "Open Overdriven" and "Ctrl+Z" in s["notice"])
        program.key("ctrl+z")
        program.wait("one step back are the values before, still unsaved",
                     lambda s: s["preset"] == "" and s["is_modified"] and
                     s["values"]["decay"] == [0.61])

    def test_a_preset_of_a_stack_is_opened_bypassed_reordered_and_undone(self):
        program = self.program
        self.open_by_name(self.presets / "phosphor+crt/night-ward.json")
        values = program.wait("both looks draw", lambda s: s["look"] == "phosphor+crt" and
                              s["preset"] == "Night ward")["values"]
        program.click("stack_bypass:crt")
        program.wait("the second look draws nothing", lambda s: (s["bypass"], s["undo"]) == ("crt", "Bypass CRT"))
        program.click("stack_up:crt")
        program.wait("it comes first", lambda s: (s["look"], s["undo"]) == ("crt+phosphor", "Move CRT"))
        program.key("ctrl+z")
        program.wait("it is last again", lambda s: (s["look"], s["undo"]) == ("phosphor+crt", "Bypass CRT"))
        program.key("ctrl+z")
        program.wait("all is as the preset has it",
                     lambda s: not s["bypass"] and not s["is_modified"] and s["values"] == values)
        program.key("ctrl+z")
        program.wait("and then as it was before", lambda s: s["look"] == "phosphor" and not s["preset"])

    def test_a_sound_is_opened_plays_and_can_be_sought(self):
        program = self.program
        song = program.folder / "two tones.wav"
        write_tones(song, seconds=20)
        self.open_by_name(song)
        program.wait("it draws", lambda s: s["signal"].startswith("audio:") and not s["reading"])
        program.place("seek")
        self.snapshot("sound")
        left, top, right, bottom = program.place("seek")
        self.screen.do("mousemove", (left + right) // 2, (top + bottom) // 2, "click", 1)
        program.wait("its middle plays", lambda s: 9.5 < s["time"] < 15)
        program.key("r")
        program.wait("it begins again", lambda s: s["time"] < 3)
        program.key("ctrl+z")
        program.wait("undo gives the figure back", lambda s: s["signal"].startswith("lissajous:"))

    def test_a_file_that_is_missing_or_cut_off_keeps_a_mark(self):
        program = self.program
        gone = program.folder / "gone.wav"
        self.open_by_name(gone)
        program.wait("it is said, listed and marked at the signal", lambda s:
                     "gone.wav" in s["notice"] and "media_problem" in s["widgets"] and
                     [problem["file"] for problem in s["problems"]] == [str(gone)])
        self.snapshot("missing")
        cut = program.folder / "cut.wav"
        write_tones(cut, seconds=4)
        os.truncate(cut, 8044)
        self.open_by_name(cut)
        program.wait("what is there draws, and how much that is is told", lambda s: not s["reading"] and
                     ["breaks off: 0.25 of 4.00 s are there, the rest is missing"] ==
                     [problem["message"] for problem in s["problems"]])
        program.key("ctrl+z", "ctrl+z")
        program.wait("without the file there is no mark", lambda s: not s["problems"] and
                     "media_problem" not in s["widgets"])

    def strokes(self):
        """What is drawn by hand, as the signal has it."""
        return self.program.state()["signal"].partition("strokes=")[2]

    def ask_file(self, button, file):
        self.program.click(button)
        self.program.place("dialog_file")
        self.program.key("ctrl+a")
        self.program.type(str(file))
        self.program.key("Return")

    def edit_point(self, x, y):
        """Moves the point there and deletes it, and takes both back."""
        program = self.program
        program.click("pen_tool:Edit")
        before = self.strokes()
        program.drag((x, y), (x + 20, y + 20))
        program.wait("a point is moved in one step", lambda s:
                     s["undo"] == "Move point" and s["redo"] == "")
        self.assertEqual(self.strokes().count(" "), before.count(" "))
        self.snapshot("edited")
        program.key("ctrl+z")
        program.wait("it goes back", lambda s: self.strokes() == before)
        self.screen.do("mousemove", x, y, "click", 3)
        program.wait("the other button deletes it", lambda s:
                     s["undo"] == "Delete point" and
                     self.strokes().count(" ") == before.count(" ") - 2)
        program.key("ctrl+z")

    def test_a_person_draws_on_the_picture_and_keeps_it_as_an_svg(self):
        program = self.program
        self.hover("picture")
        program.key("d")
        program.wait("an empty drawing, and the pen in the hand", lambda s:
                     s["signal"] == "drawing:strokes=[]" and "pen_tool:Freehand" in s["widgets"])
        x, y = program.middle("picture")
        box = (x - 60, y + 37, x + 60, y + 43)
        program.wait_for("the figure before has faded", lambda: self.screen.brightness(box) < 25)
        program.click("pen_line:Straight")
        program.drag((x - 90, y + 40), (x + 90, y + 40))
        program.wait("one stroke, one step", lambda s:
                     s["undo"] == "Stroke" and "[L" in s["signal"] and s["signal"].count(" ") == 3)
        program.wait_for("the beam draws it", lambda: self.screen.brightness(box) > 60)
        left, height, right, _ = (float(number) for number in self.strokes()[2:-1].split())
        self.assertLess(abs(left + right), 0.02)  # as far to either side of the middle
        self.assertLess(height, -0.1)
        program.key("ctrl+z")
        program.wait("undo takes it away", lambda s: s["signal"] == "drawing:strokes=[]")
        program.wait_for("from the picture too", lambda: self.screen.brightness(box) < 25)
        program.key("ctrl+shift+z")
        program.click("pen_tool:Points")
        program.click("pen_line:Smooth")
        for place in ((x - 80, y), (x, y - 60), (x + 80, y)):
            self.screen.do("mousemove", *place, "click", 1)
        program.wait("three clicks make a line", lambda s: s["signal"].count(" ") == 8)
        self.snapshot("drawing")
        program.key("Escape")
        self.edit_point(x, y - 60)
        program.click("keyframe_copy")
        program.wait("a second keyframe", lambda s: "keyframe:2" in s["widgets"])
        program.click("pen_tool:Erase")
        self.screen.do("mousemove", x, y + 40, "click", 1)
        program.wait("a stroke is deleted there", lambda s: s["undo"] == "Delete stroke")
        self.snapshot("erased")
        drawn = self.strokes()
        file = program.folder / "mine.svg"
        self.ask_file("save_drawing", file)
        program.wait("it is saved", lambda s: "Saved 'mine.svg'" in s["notice"])
        self.assertEqual(file.read_text().count("data-keyframe"), 2)
        program.click("keyframe_clear")
        program.wait("the keyframe is empty", lambda s: s["signal"].endswith("[]"))
        (program.folder / "none.svg").write_text("<svg><text>nothing</text></svg>")
        self.ask_file("load_drawing", program.folder / "none.svg")
        program.wait("one without lines is told", lambda s: "has no paths" in s["notice"])
        self.ask_file("load_drawing", file)
        program.wait("it comes back with its keyframes",
                     lambda s: s["undo"] == "Load drawing" and self.strokes() == drawn)
        program.key("Escape")
        program.wait("Escape puts the pen down", lambda s: "pen_tool:Points" not in s["widgets"])
        self.snapshot("drawn")

    def test_what_is_dropped_on_the_window_opens(self):
        program = self.program
        song = program.folder / "zwei Töne.wav"
        write_tones(song, seconds=2)
        program.set("decay", "0.61")
        program.key("ctrl+s")
        program.answer("Mine")
        program.wait("it is saved", lambda s: not s["is_modified"])
        program.set("decay", "0.62")
        self.drop(song)
        program.wait("the sound draws", lambda s: s["signal"].startswith("audio:") and not s["reading"])
        program.key("ctrl+s")
        program.wait("it is saved", lambda s: not s["is_modified"])
        program.click("preset:overdriven")
        program.wait("another preset opens", lambda s: s["preset"] not in ("", "Mine"))
        self.drop(self.presets / "phosphor/Mine.json")
        program.wait("the preset opens", lambda s: s["preset"] == "Mine" and
                     s["values"]["decay"] == [0.62] and s["signal"].startswith("audio:"))

    def test_an_edited_shader_shows_at_once(self):
        program = self.program
        shader = self.looks / "phosphor/composite.frag"
        text = shader.read_text()
        white = text[:text.rindex("}")] + "    color = vec4(1.0);\n}\n"
        before = self.brightness()

        beside = shader.with_suffix(".new")
        beside.write_text(white)
        os.replace(beside, shader)
        program.wait_for("an edit by rename is seen", lambda: self.brightness() > 250)
        shader.write_text(text)
        program.wait_for("an edit in place is seen", lambda: self.brightness() < before + 20)

        broken = text.replace("void main() {", "void main() {\n    colour = 1.0;", 1)
        line = 1 + broken[:broken.index("colour = 1.0")].count("\n")
        shader.write_text(broken)
        state = program.wait("the mistake is shown", lambda s: s["problems"])
        problem = state["problems"][0]
        self.assertEqual((Path(problem["file"]).name, problem["line"]), ("composite.frag", line))
        self.assertIn("colour", problem["message"])
        self.assertEqual(problem["source"].strip(), "colour = 1.0;")
        program.wait("the last good picture runs on", lambda s: s["frame"] > state["frame"] + 3)
        self.assertGreater(self.brightness(), 0.5)
        self.snapshot("broken")
        program.click("problem:composite.frag:%d" % line)
        program.wait_for("a click opens the editor at the line",
                         lambda: "+%d" % line in program.edited_files())
        shader.write_text(text)
        program.wait("mending it clears the message", lambda s: not s["problems"])

    def test_a_pass_can_be_looked_into(self):
        program = self.program
        program.click("pass:persistence")
        program.wait("it is inspected", lambda s: s["inspected"] == "persistence")
        program.click("channels:G")
        self.hover("inspector")
        program.wait("the value under the pointer is told",
                     lambda s: s["probe"] and s["probe"]["pass"] == "persistence" and
                     len(s["probe"]["rgba"]) == 4)
        self.snapshot("inspector")
        program.key("p")
        program.place("back_to_picture")
        self.hover("picture")
        state = program.wait("it is as large as the picture, and its values are told",
                             lambda s: s["probe"] and s["probe"]["pass"] == "persistence")
        self.assertLess(abs(state["probe"]["x"] - 160) + abs(state["probe"]["y"] - 120), 3)
        program.click("channels:RGB")
        before = self.brightness()
        program.key("e", "e", "e")
        program.wait_for("three stops brighten it", lambda: self.brightness() > before + 3)
        self.snapshot("large_pass")
        program.key("shift+e", "shift+e", "shift+e", "Escape")
        program.wait("Escape goes back to the picture",
                     lambda s: "back_to_picture" not in s["widgets"])

    def test_everything_fits_a_small_window(self):
        program = self.program
        width, height = 900, 600
        self.screen.resize(width, height)
        program.wait("the panes give way", lambda s: 0 < s["widgets"]["search"][2] <= width)
        program.key("F1")
        program.place("dialog_cancel")
        self.snapshot("small_keys")
        for key in ("Escape", "ctrl+o", "Escape"):
            state = program.wait("what is drawn is within the window", lambda s: all(
                0 <= place[0] and 0 <= place[1] and place[2] <= width and place[3] <= height
                for name, place in s["widgets"].items() if name.startswith("dialog")))
            program.key(key)
            program.wait("a dialog opens or closes", lambda s, then=state: s["dialog"] != then["dialog"])
        self.snapshot("small")
        row = [program.place(name) for name in ("restart", "play", "step", "picture_size", "zoom")]
        for left, right in zip(row, row[1:]):
            self.assertLessEqual(left[2], right[0])
        self.screen.resize(*WINDOW)

    def test_everything_comes_back_after_a_quit_and_after_a_crash(self):
        program = self.program
        program.set("decay", "0.61")
        program.quit()
        state = program.start()
        self.assertEqual((state["values"]["decay"], state["picture"]), ([0.61], PICTURE))
        self.assertTrue(state["is_modified"])
        program.key("ctrl+z")
        program.wait("undo reaches back over the quit", lambda s: s["values"]["decay"] != [0.61])
        program.key("ctrl+shift+z")
        program.wait("it is there again", lambda s: s["values"]["decay"] == [0.61])
        program.kill()  # at once: a change is kept when it is done
        self.assertEqual(program.start()["values"]["decay"], [0.61])


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]], verbosity=2)
