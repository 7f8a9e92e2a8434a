"""Editing looks and their shaders."""

import json
import os
from pathlib import Path

from person import Person


class Editing(Person):
    def test_an_edited_shader_shows_at_once(self):
        program = self.program
        shader = self.looks / "phosphor/composite.frag"
        text = shader.read_text()
        white = text[:text.rindex("}")] + "    color = vec4(1.0);\n}\n"
        before = self.brightness()

        beside = shader.with_suffix(".new")
        beside.write_text(white)
        os.replace(beside, shader)
        program.wait_for("an edit by rename is drawn", lambda: self.brightness() > 250)
        shader.write_text(text)
        program.wait_for("an edit in place is drawn", lambda: self.brightness() < before + 20)

        broken = text.replace("void main() {", "void main() {\n    colour = 1.0;", 1)
        line = 1 + broken[:broken.index("colour = 1.0")].count("\n")
        shader.write_text(broken)
        state = program.wait("the error is listed", lambda s: s["problems"])
        problem = state["problems"][0]
        self.assertEqual((Path(problem["file"]).name, problem["line"]), ("composite.frag", line))
        self.assertIn("colour", problem["message"])
        self.assertEqual(problem["source"].strip(), "colour = 1.0;")
        program.wait("the last good picture continues", lambda s: s["frame"] > state["frame"] + 3)
        self.assertGreater(self.brightness(), 0.5)
        self.snapshot("broken")
        program.click("problem:composite.frag:%d" % line)
        program.wait_for("a click opens the editor at the line",
                         lambda: "+%d" % line in program.edited_files())
        shader.write_text(text)
        program.wait("a corrected shader clears the error", lambda s: not s["problems"])

    def test_a_folder_for_includes_is_named_in_the_menu(self):
        program = self.program
        shader = self.looks / "phosphor/composite.frag"
        text = shader.read_text()
        library = program.folder / "library"
        library.mkdir()
        (library / "outside.glsl").write_text("// nothing\n")
        head, rest = text.split("\n", 1)
        shader.write_text(f'{head}\n#include "outside.glsl"\n{rest}')
        state = program.wait("the include is not found", lambda s: s["problems"])
        self.assertIn("outside.glsl", state["problems"][0]["message"])
        program.choose("Edit", "Includes")
        program.click("menu:Includes: Folders, separated by ':'…")
        program.place("asked")
        program.type(str(library))
        program.key("Return")
        program.wait("the include is found in the folder", lambda s: not s["problems"])
        shader.write_text(text)
        program.wait("the look is as before", lambda s: not s["problems"] and not s["is_loading"])

    def test_a_number_that_is_not_finite_stops_the_clock(self):
        program = self.program
        shader = self.looks / "phosphor/persistence.frag"
        text = shader.read_text()
        shader.write_text(text[:text.rindex("}")] + "    if (ivec2(gl_FragCoord.xy) == ivec2(9, 29))\n"
                          "        color.r = sqrt(-u_time_delta);\n}\n")
        state = program.wait("the NaN is reported with pass and pixel", lambda s: s["trip"])
        self.assertEqual(state["trip"][:3], [3, 9, self.size[1] - 1 - 29])
        self.assertFalse(state["is_playing"])
        self.assertEqual(state["frame"], state["trip"][3])
        program.click("trip_show")
        program.wait("the pass is inspected", lambda s: s["inspected"] == "persistence")
        self.snapshot("trip")
        program.click("trip_clamp")
        program.wait("time continues without another report", lambda s: not s["trip"] and
                     s["is_playing"] and s["frame"] > state["frame"] + 3)
        shader.write_text(text)
        program.wait("the corrected look is loaded", lambda s: not s["is_loading"])

    def test_a_pass_is_changed_and_written_back(self):
        program = self.program
        manifest = self.looks / "phosphor/look.json"
        before = json.loads(manifest.read_text())
        program.click("pass:bloom_down_1")
        program.wait("the pass is inspected", lambda s: s["inspected"] == "bloom_down_1")
        program.click("pass_format")
        program.place("format:rgba16f")
        other = next(name for name in program.state()["widgets"]
                     if name.startswith("format:") and name.endswith("f") and name != "format:rgba16f")
        program.click(other)
        program.wait("the override is one undo step", lambda s: s["undo"] == "Pass bloom_down_1")
        program.click("write_overrides")
        program.wait("look.json is written", lambda s: "Saved to look.json" in s["notice"])
        after = json.loads(manifest.read_text())
        bloom = [one["name"] for one in before["passes"]].index("bloom_down_1")
        self.assertEqual(after["passes"][bloom]["format"], other.removeprefix("format:"))
        after["passes"][bloom]["format"] = before["passes"][bloom]["format"]
        self.assertEqual(after, before)

    def test_a_parameter_and_a_pass_open_the_editor_at_their_line(self):
        program = self.program
        program.click("pass:persistence")
        program.click("edit_pass")
        program.wait_for("the pass opens in the editor", lambda: "persistence.frag" in program.edited_files())
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
        program.choose("File", "Duplicate look…")
        program.answer("my-phosphor")
        state = program.wait("the copy is open", lambda s: s["look"] == "my-phosphor")
        self.assertEqual(state["values"]["decay"], [0.61])
        self.assertTrue((self.own / "shaders/my-phosphor/composite.frag").exists())
        program.key("ctrl+n")
        program.answer("fresh")
        state = program.wait("the new look is open and drawn",
                             lambda s: s["look"] == "fresh" and s["frame"] > 2)
        self.assertEqual(state["problems"], [])
        self.snapshot("new_look")
        program.choose("File", "Restore unsaved changes")
        program.wait("the unsaved changes are restored",
                     lambda s: s["look"] == "my-phosphor" and s["values"]["decay"] == [0.61])
        program.click("look:phosphor")
        program.wait("the look opens without a question", lambda s: s["look"] == "phosphor")
        program.key("ctrl+shift+o")
        program.wait("the unsaved changes are restored again",
                     lambda s: s["look"] == "my-phosphor" and s["values"]["decay"] == [0.61])
