"""The user's own content is kept: signal, source, presets and unsaved changes."""

import json
import struct
import zlib

from person import PICTURE, SOURCE, Person, write_tones


def write_png(file):
    """Writes 4 x 3 red pixels with 8 bits per channel."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    rows = (b"\0" + b"\xff\0\0" * 4) * 3
    file.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", 4, 3, 8, 2, 0, 0, 0)) +
                     chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


class Owning(Person):
    def open_song(self):
        song = self.program.folder / "song.wav"
        write_tones(song, seconds=2)
        self.open_by_name(song)
        self.program.wait("the sound is drawn and locked", lambda s:
                          s["signal"].startswith("audio:") and s["is_content_locked"] and not s["reading"])

    def open_preset(self, widget, name):
        self.program.click(widget)
        return self.program.wait("the preset opens", lambda s: s["preset"] == name and not s["is_loading"])

    def test_a_preset_keeps_the_users_sound_and_offers_its_own(self):
        program = self.program
        self.open_song()
        time = program.wait("the sound has played", lambda s: s["time"] > 1)["time"]
        state = self.open_preset("preset:overdriven", "Overdriven")
        self.assertGreaterEqual(state["time"], time, "the sound continues")
        self.assertTrue(state["signal"].startswith("audio:"))
        self.assertEqual(state["notice"], "Kept song.wav")
        self.assertFalse(state["is_modified"])
        self.snapshot("kept_signal")
        program.click("offer:Use the preset's signal")
        program.wait("the preset's signal is drawn", lambda s:
                     not s["signal"].startswith("audio:") and not s["is_content_locked"])
        program.key("ctrl+z")
        program.wait("one undo restores sound and lock", lambda s:
                     s["signal"].startswith("audio:") and s["is_content_locked"] and s["preset"] == "Overdriven")
        program.key("ctrl+z")
        program.wait("undo of the preset keeps the sound", lambda s:
                     s["signal"].startswith("audio:") and not s["preset"])
        program.key("ctrl+z")
        program.wait("undo of the choice restores the first signal", lambda s:
                     s["signal"] == self.fresh["signal"] and not s["is_content_locked"])

    def test_alt_and_a_click_open_a_preset_with_its_own_signal(self):
        program = self.program
        self.open_song()
        self.screen.do("keydown", "alt")
        program.click("preset:overdriven")
        self.screen.do("keyup", "alt")
        program.wait("the preset opens with its own signal", lambda s: s["preset"] == "Overdriven" and
                     not s["signal"].startswith("audio:") and not s["is_content_locked"])
        program.key("Escape")

    def test_a_generator_is_kept_once_it_is_locked_by_hand(self):
        program = self.program
        program.click("keep_content")
        program.wait("the signal is locked", lambda s: s["is_content_locked"])
        state = self.open_preset("preset:overdriven", "Overdriven")
        self.assertEqual(state["signal"], self.fresh["signal"])
        program.click("keep_content")
        program.wait("the signal is unlocked", lambda s: not s["is_content_locked"])
        state = self.open_preset("preset:amber-p3", "Amber P3")
        self.assertTrue(state["signal"].startswith("fm:"))

    def test_looks_of_the_other_kind_get_what_they_had(self):
        program = self.program
        self.open_song()
        program.click("look:crt")
        program.wait("the picture-driven look opens", lambda s: s["look"] == "crt" and not s["is_loading"])
        game = program.folder / "game.png"
        write_png(game)
        self.open_by_name(game)
        program.wait("the picture is the locked source", lambda s:
                     s["driving_source"].startswith(str(game)) and s["is_content_locked"])
        program.click("look:phosphor")
        program.wait("the sound is drawn again", lambda s: s["look"] == "phosphor" and
                     s["signal"].startswith("audio:") and not s["is_loading"])
        program.click("look:crt")
        program.wait("the picture is the source again", lambda s: s["look"] == "crt" and
                     s["driving_source"].startswith(str(game)) and not s["is_loading"])
        program.click("keep_content")

    def test_signal_and_lock_come_back_at_the_next_start(self):
        program = self.program
        self.open_song()
        # stop() kills the program, and the session is saved after the state.
        program.wait_for("the session has the sound", lambda: "song.wav" in
                         str(json.loads(program.session().read_text())["current"]))
        program.stop()
        program.start()
        program.wait("signal and lock are restored", lambda s:
                     s["signal"].startswith("audio:") and s["is_content_locked"] and not s["reading"])

    def test_a_session_of_an_older_version_opens_unchanged(self):
        program = self.program
        program.stop()
        present = program.session().read_text()
        older = json.loads((SOURCE / "tests/inputs/labels/session.json").read_text()
                           .replace("DATA", str(program.folder / "data")))
        older["window"].update({key: json.loads(present)["window"][key] for key in ("width", "height")})
        program.session().write_text(json.dumps(older))
        state = program.start()
        self.assertEqual(state["look"], "shadow-mask")
        expected = json.loads((SOURCE / "tests/inputs/labels/shadow-mask.expected.json").read_text())
        self.assertEqual({name: state["values"][name][0] for name in expected}, expected)
        self.assertEqual((state["undo"], state["picture"]), ("Open shadow-mask", [240, 180]))
        program.stop()
        program.session().write_text(present)
        program.start()

    def test_thumbnails_show_the_presets_signal_or_mine(self):
        program = self.program
        for preset in self.presets.glob("phosphor/*.json"):
            if preset.stem != "amber-p3":
                preset.unlink()
        program.key("ctrl+l")
        state = program.wait("the preset pictures are drawn", lambda s: s["presets"]["pictures"] == 2)
        drawn = state["presets"]["drawn"]
        program.click("pictures_with")
        program.click("pictures_with:mine")
        program.wait("the pictures are redrawn with the user's signal", lambda s: s["presets"]["drawn"] == drawn + 2)
        self.snapshot("presets_with_mine")
        program.key("ctrl+l")

    def test_a_shipped_preset_is_saved_under_a_name_of_its_own(self):
        program = self.program
        shipped = self.presets / "phosphor/amber-p3.json"
        before = shipped.read_bytes()
        self.open_preset("preset:amber-p3", "Amber P3")
        program.set("beam_width", "1.626")
        program.key("ctrl+s")
        program.place("dialog_name")
        self.snapshot("saving_shipped")
        program.key("Return")
        program.wait("a new preset is saved", lambda s:
                     s["preset"] == "Amber P3 (mine)" and not s["is_modified"])
        self.assertEqual(shipped.read_bytes(), before)
        text = (self.own / "presets/phosphor/Amber P3 (mine).json").read_text()
        self.assertIn('"beam_width": 1.626', text)
        self.assertIn('"tube": "P3"', text)
        self.assertIn("0.0005]", text)
        self.snapshot("yours_and_shipped")

    def test_unsaved_changes_are_listed_with_look_changes_and_age(self):
        program = self.program
        program.set("decay", "0.61")
        program.click("look:crt")
        program.wait("another look opens", lambda s: s["look"] == "crt" and not s["is_loading"] and
                     s["notice"].startswith("Your unsaved changes are kept"))
        program.click("menu:File")
        program.click("menu:Unsaved changes")
        kept = program.wait("the changes are listed", lambda s: any(w.startswith("kept:") for w in s["widgets"]))
        entry = next(w for w in kept["widgets"] if w.startswith("kept:"))
        program.place(entry)
        self.snapshot("unsaved")
        program.click(entry)
        program.wait("a click restores them", lambda s: s["look"] == "phosphor" and
                     s["values"]["decay"] == [0.61])

    def pane(self):
        left, top, right, bottom = self.program.place("picture")
        return [right - left, bottom - top]

    def test_panes_and_comparing_leave_the_picture_its_size(self):
        program = self.program
        self.restart_with_size(0, 0)  # like the first start, when the program chooses the size
        whole = self.pane()
        self.assertEqual(program.state()["picture"], whole)
        program.wait("the size is chosen", lambda s: s["fixed_size"] == whole)
        program.key("ctrl+7")
        program.place("bottom:Pins")
        small = self.pane()
        self.assertLess(small[1], whole[1])
        program.key("shift+F6", "w")
        program.wait("a comparison is on", lambda s: s["compare"]["mode"] != "off")
        self.assertEqual(program.state()["picture"], whole)
        self.snapshot("fixed_size")
        program.click("compare_end")
        program.click("picture_size")
        program.click("shape:view")
        program.wait("the render size follows the pane on request", lambda s: s["picture"] == small)
        program.key("ctrl+7")
        program.wait("the render size follows the pane", lambda s: s["picture"] == whole)
        program.click("picture_size")
        program.click("size:pane_once")
        program.quit()
        program.start()
        program.key("ctrl+7")
        program.place("bottom:Pins")
        self.assertEqual(program.state()["picture"], whole)
        program.key("ctrl+7")
        self.restart_with_size(*PICTURE)
