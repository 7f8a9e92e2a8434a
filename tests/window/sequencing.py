"""Timeline, tempo, cues and playlist."""

import re

from person import Person, write_tones


class Sequencing(Person):
    def open_song(self, seconds):
        song = self.program.folder / "song.wav"
        write_tones(song, seconds)
        self.open_by_name(song)
        self.program.wait("the sound is drawn", lambda s: s["signal"].startswith("audio:") and not s["reading"])

    def open_timeline(self):
        self.program.key("shift+t")
        return self.program.place("timeline")

    def test_the_sound_is_scrubbed_and_a_region_is_set_and_undone(self):
        program = self.program
        self.open_song(seconds=20)
        left, top, right, bottom = self.open_timeline()
        program.key("space")
        program.wait("the picture is paused", lambda s: not s["is_playing"])
        middle = ((left + right) // 2, (top + bottom) // 2)
        self.screen.do("mousemove", *middle, "click", 1)
        program.wait("the time is that of the click", lambda s: abs(s["time"] - 10) < 0.2)
        self.snapshot("timeline")
        frame = program.state()["time"]
        program.key("comma")
        program.wait("the picture is one frame earlier", lambda s: abs(s["time"] - (frame - 1 / 60)) < 1e-3)
        quarter = (right - left) // 4
        program.drag((left + quarter, top + 4), (left + 2 * quarter, top + 4))
        state = program.wait("the region is part of the signal", lambda s: "end=" in s["signal"])
        start, end = (float(re.search(key + "=([0-9.]+)", state["signal"]).group(1)) for key in ("start", "end"))
        self.assertAlmostEqual(start, 5, delta=0.2)
        self.assertAlmostEqual(end, 10, delta=0.2)
        self.snapshot("timeline_region")
        program.key("ctrl+z")
        program.wait("undo removes the region", lambda s: "end=" not in s["signal"])
        program.key("shift+t", "space")

    def test_a_tempo_is_typed_and_undone(self):
        program = self.program
        self.open_timeline()
        program.click("tempo")
        program.key("ctrl+a")
        program.type("90")
        program.key("Return")
        program.wait("the tempo is an undo step", lambda s: "empo" in s["undo"])
        program.key("ctrl+z")
        program.wait("undo restores the tempo", lambda s: "empo" not in s["undo"])
        program.key("shift+t")

    def test_cues_black_out_the_picture_until_they_are_switched_off(self):
        program = self.program
        cues = program.folder / "show.txt"
        cues.write_text("0 blackout on\n0 parameter decay 0.5\n")
        self.assertGreater(self.brightness(), 0)
        self.open_timeline()
        program.click("open_cues")
        program.place("dialog_file")
        program.key("ctrl+a")
        program.type(str(cues))
        program.key("Return")
        program.wait_for("the picture is black", lambda: self.brightness() == 0)
        self.snapshot("cues")
        program.click("play_cues")
        program.wait_for("the picture is back", lambda: self.brightness() > 0)
        self.screen.do("mousemove", *program.middle("timeline"), "click", 3)
        program.click("cue:add")
        program.place("timeline:cue")
        program.key("ctrl+a")
        program.type('0:01 preset "Ambr P3"')
        program.key("Return")
        program.place("timeline:cue_problem")
        self.snapshot("cue_problem")
        program.key("ctrl+a")
        program.type("0:01 restart")
        program.key("Return")
        program.wait("the corrected cue is added", lambda s: s["undo"] == "Add cue")
        program.key("ctrl+z", "ctrl+z")
        program.place("open_cues")
        program.key("shift+t")

    def test_presets_of_a_playlist_follow_each_other(self):
        program = self.program
        program.choose("View", "Playlist")
        program.click("playlist_add_all")
        program.place("playlist:1")
        self.snapshot("playlist")
        program.click("playlist:2")
        first = program.wait("the chosen preset opens", lambda s: s["preset"] not in ("", "Default"))["preset"]
        program.click("playlist_next")
        program.wait("the next preset opens", lambda s: s["preset"] not in ("", first))
        program.click("playlist_clear")
        program.choose("View", "Playlist")
