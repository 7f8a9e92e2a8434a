"""Choosing the input of a look, playback and sound."""

import json
import os
import shutil
import time

from person import Person, write_tones


class Driving(Person):
    def test_a_paused_window_rests_with_the_pointer_over_the_picture(self):
        program = self.program
        self.hover("picture")
        program.key("space")
        program.wait("playback stops", lambda s: not s["is_playing"])
        turns = []

        def rests():
            turns.append(program.state()["turn"])
            time.sleep(0.3)
            return len(turns) > 1 and turns[-1] == turns[-2]

        program.wait_for("no more updates are drawn", rests)
        program.key("space")

    def test_time_stops_steps_and_starts_again(self):
        program = self.program
        self.hover("picture")
        program.key("space")
        state = program.wait("playback stops", lambda s: not s["is_playing"])
        frame = program.state()["frame"]
        program.key("period")
        program.wait("one frame is stepped", lambda s: s["frame"] == frame + 1)
        program.click("play")
        program.wait("playback continues", lambda s: s["is_playing"] and s["frame"] > state["frame"] + 5)
        program.key("r")
        program.wait("playback restarts", lambda s: s["frame"] < 60)

    def test_a_sound_is_opened_plays_and_can_be_sought(self):
        program = self.program
        song = program.folder / "two tones.wav"
        write_tones(song, seconds=20)
        self.open_by_name(song)
        program.wait("the sound is drawn", lambda s: s["signal"].startswith("audio:") and not s["reading"])
        program.place("seek")
        self.snapshot("sound")
        left, top, right, bottom = program.place("seek")
        self.screen.do("mousemove", (left + right) // 2, (top + bottom) // 2, "click", 1)
        program.wait("playback is at the middle of the sound", lambda s: 9.5 < s["time"] < 15)
        program.key("r")
        program.wait("playback restarts", lambda s: s["time"] < 3)
        program.key("ctrl+z")
        program.wait("undo restores the figure", lambda s: s["signal"].startswith("lissajous:"))

    def test_the_beam_goes_to_the_sound_output_or_says_why_not(self):
        program = self.program
        program.click("signal_group:Sound devices")
        program.click("sound:beam")
        before = program.state()["frame"]
        missing = "The beam is only shown on the screen."
        state = program.wait("the beam output is on, or a missing device is reported", lambda s:
                             missing in s["notice"] or
                             ("sound:beam_level" in s["widgets"] and s["frame"] > before + 5))
        self.snapshot("beam_output")
        if missing not in state["notice"]:
            program.click("sound:beam")
        program.wait("the beam output is off and frames continue", lambda s:
                     "sound:beam_level" not in s["widgets"] and s["frame"] > state["frame"] + 3)
        self.leave()  # the layout of the panel has changed

    def test_a_file_that_is_missing_or_cut_off_keeps_a_mark(self):
        program = self.program
        gone = program.folder / "gone.wav"
        before = program.state()["signal"]
        self.open_by_name(gone)
        state = program.wait("the dialog reports the missing file", lambda s: "dialog_problem" in s["widgets"])
        self.assertEqual((state["signal"], state["problems"], state["is_content_locked"]), (before, [], False))
        program.key("Escape")
        program.wait("the dialog is closed", lambda s: not s["dialog"])
        program.key("ctrl+o")
        program.place("dialog_file")
        self.assertNotIn("recent:gone.wav", program.state()["widgets"])
        program.key("Escape")
        lost = self.presets / "phosphor/lost.json"
        lost.write_text(json.dumps({"format": "afterglow-preset", "version": 1, "look": "phosphor", "name": "Lost",
                                    "signal": {"kind": "audio", "file": "gone.wav"}}))
        self.open_by_name(lost)
        program.wait("the missing file of a preset is listed and marked at the signal", lambda s:
                     "gone.wav" in s["notice"] and "media_problem" in s["widgets"] and
                     [problem["file"] for problem in s["problems"]] == ["gone.wav"])
        self.snapshot("missing")
        lost.unlink()
        cut = program.folder / "cut.wav"
        write_tones(cut, seconds=4)
        os.truncate(cut, 8044)
        self.open_by_name(cut)
        program.wait("the start of the sound is drawn, and its length is reported", lambda s: not s["reading"] and
                     ["the file ends early: only 0.25 of 4.00 s were read"] ==
                     [problem["message"] for problem in s["problems"]])
        program.key("ctrl+z", "ctrl+z")
        program.wait("the mark is gone with the file", lambda s: not s["problems"] and
                     "media_problem" not in s["widgets"])

    def test_what_is_dropped_on_the_window_opens(self):
        program = self.program
        song = program.folder / "zwei Töne.wav"
        write_tones(song, seconds=2)
        program.set("decay", "0.61")
        program.key("ctrl+s")
        program.answer("Mine")
        program.wait("the preset is saved", lambda s: not s["is_modified"])
        program.set("decay", "0.62")
        self.drop(song)
        program.wait("the sound is drawn", lambda s: s["signal"].startswith("audio:") and not s["reading"])
        program.key("ctrl+s")
        program.wait("the preset is saved", lambda s: not s["is_modified"])
        program.click("preset:overdriven")
        program.wait("another preset opens", lambda s: s["preset"] not in ("", "Mine"))
        self.drop(self.own / "presets/phosphor/Mine.json")
        program.wait("the preset opens", lambda s: s["preset"] == "Mine" and
                     s["values"]["decay"] == [0.62] and s["signal"].startswith("audio:"))

    def test_a_pack_that_was_saved_is_installed_when_it_is_dropped(self):
        program = self.program
        program.key("ctrl+shift+d")
        program.answer("tube")
        program.wait("the copy is open", lambda s: s["look"] == "tube" and s["dialog"] == 0)
        program.key("ctrl+s")
        program.answer("Mine")
        program.wait("the preset is saved", lambda s: not s["is_modified"])
        program.choose("File", "Save pack…")
        self.snapshot("save-pack")
        program.place("dialog_file")
        program.key("ctrl+a")
        program.type(str(program.folder / "tube.afterglow"))
        program.key("Return")
        pack = program.folder / "tube.afterglow"
        program.wait_for("the pack is written", pack.exists)
        program.wait("the end is reported", lambda s: 'Saved "tube.afterglow"' in s["notice"])
        program.click("look:crt")
        program.wait("another look is open", lambda s: s["look"] == "crt")
        for folder in ("shaders/tube", "presets/tube"):
            shutil.rmtree(self.own / folder)
        self.drop(pack)
        program.wait("the pack is installed", lambda s: "Installed 'tube': 1 look and 1 preset." in s["notice"])
        self.snapshot("installed-pack")
        program.click("offer:Open Phosphor")
        program.wait("the look opens", lambda s: s["look"] == "tube")

    def test_the_output_window_shows_the_picture_alone(self):
        program, screen = self.program, self.screen
        edge = (0, 0, 100, 100)
        panels = screen.brightness(edge)
        self.assertGreater(panels, 0)
        program.key("F12")
        program.wait_for("there are no panels around the picture", lambda: screen.brightness(edge) == 0)
        middle = (340, 180, 940, 680)
        program.wait_for("the picture is visible", lambda: screen.brightness(middle) > 1)
        self.snapshot("output")
        program.wait("the render size of the display is offered", lambda s: s["notice"] ==
                     "The render size is 240 × 180 px, the display 1280 × 860 px")
        program.key("ctrl+Next")
        program.wait("its keys work as in the main window", lambda s: s["preset"] and s["output"] == "on")
        program.key("ctrl+b")
        program.wait_for("the picture is black", lambda: screen.brightness(middle) == 0)
        program.key("ctrl+b")
        program.wait_for("the picture is visible again", lambda: screen.brightness(middle) > 1)
        program.key("Escape")
        program.wait("the output window is closed", lambda s: s["output"] == "off")
        program.wait_for("the panels are visible again", lambda: abs(screen.brightness(edge) - panels) < 1)
