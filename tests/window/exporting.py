"""Exports in the background, saved pictures, and pictures on the clipboard."""

import datetime
import os
import shutil
import struct
import subprocess
import sys
import time
import unittest
from pathlib import Path

from person import PICTURE, Person

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "cli"))
from running_programs import MpvServer  # noqa: E402


class Exporting(Person):
    def fill(self, **fields):
        for field, text in fields.items():
            self.program.click(field)
            self.program.key("ctrl+a")
            self.program.type(text)

    def ask_for_export(self, name, **fields):
        self.program.choose("File", "Export video or image sequence…")
        self.fill(dialog_file=str(self.program.folder / name), **{"export_fps": "60", **fields})

    def confirm(self):
        self.program.click("dialog_ok")
        self.program.wait("the dialog is closed", lambda s: s["dialog"] == 0)

    def files(self, pattern):
        return sorted(self.program.folder.glob(pattern))

    def png_size(self, file):
        return list(struct.unpack(">II", file.read_bytes()[16:24]))

    def cancel_exports(self):
        while place := self.program.state()["widgets"].get("export_cancel"):
            left, top, right, bottom = place
            self.screen.do("mousemove", (left + right) // 2, (top + bottom) // 2, "click", 1)
            time.sleep(0.5)

    def test_frames_are_exported_in_the_background(self):
        program = self.program
        self.ask_for_export("frame_%02d.png", export_seconds="0.1")
        self.snapshot("export")
        program.key("Return")
        program.wait("the export is done", lambda s: s["dialog"] == 0 and "Exported 6 frames" in s["notice"])
        self.snapshot("exported")
        self.assertEqual([file.name for file in self.files("frame_*.png")],
                         ["frame_%02d.png" % number for number in range(6)])
        for file in self.files("frame_*.png"):
            self.assertEqual(self.png_size(file), PICTURE)

    def test_exports_wait_in_a_queue_while_the_picture_can_be_tuned(self):
        program = self.program
        self.ask_for_export("long_%06d.png", export_seconds="3600")
        program.key("Return")
        program.wait_for("some pictures are exported", lambda: len(self.files("long_*.png")) > 2)
        self.ask_for_export("next_%02d.png", export_seconds="0.05")
        program.key("Return")
        program.wait("the dialog is closed", lambda s: s["dialog"] == 0)
        program.set("decay", "0.61")
        frame = program.state()["frame"]
        program.wait("the picture continues", lambda s: s["frame"] > frame + 2)
        self.assertEqual(self.files("next_*.png"), [])
        program.click("export_chip")
        program.place("export_row:next_%02d.png")
        self.snapshot("exporting")
        program.key("Escape")
        program.wait("the list is closed", lambda s: "export_row:next_%02d.png" not in s["widgets"])
        program.click("export_cancel")
        program.wait_for("the next export runs", lambda: len(self.files("next_*.png")) == 3)
        self.assertLess(len(self.files("long_*.png")), 3600)

    def test_a_field_that_is_not_valid_keeps_the_dialog(self):
        program = self.program
        self.ask_for_export("film.avi")
        program.place("dialog_problem")
        program.click("export_size")
        program.place("export_size:Custom")
        program.key("Escape")
        program.wait("Escape closes only the list", lambda s: "export_size:Custom" not in s["widgets"])
        self.assertNotEqual(program.state()["dialog"], 0)
        self.snapshot("export_problem")
        program.key("Return")
        self.fill(dialog_file=str(program.folder / "film_%02d.png"), export_seconds="0.03", export_fps="abc")
        program.place("dialog_problem")
        program.key("Return")
        self.assertNotEqual(program.state()["dialog"], 0)
        program.click("export_fps:50")
        program.wait("no problem is left", lambda s: "dialog_problem" not in s["widgets"])
        program.click("dialog_ok")
        program.wait_for("the pictures are exported", lambda: len(self.files("film_*.png")) == 2)

    def test_quitting_while_exporting_asks(self):
        program = self.program
        self.ask_for_export("quit_%06d.png", export_seconds="3600")
        program.key("Return")
        program.wait_for("some pictures are exported", lambda: self.files("quit_*.png"))
        program.key("ctrl+q")
        program.place("dialog_ok")
        self.snapshot("quit_exporting")
        program.click("dialog_cancel")
        program.wait("the program goes on", lambda s: s["dialog"] == 0)
        count = len(self.files("quit_*.png"))
        program.wait_for("the export goes on", lambda: len(self.files("quit_*.png")) > count)
        self.cancel_exports()

    def test_pictures_are_saved_in_other_sizes_and_formats(self):
        program = self.program
        program.key("ctrl+e")
        program.place("dialog_file")
        self.snapshot("save_picture")
        self.fill(dialog_folder=str(program.folder))
        self.confirm()
        name = "phosphor-%s.png" % datetime.date.today().isoformat()
        program.wait_for("the picture has its default name", lambda: (program.folder / name).exists())
        self.assertEqual(self.png_size(program.folder / name), PICTURE)
        program.key("ctrl+e")
        self.fill(dialog_file=str(program.folder / "large.png"))
        program.click("still_size")
        program.click("still_size:2x (480 × 360)")
        program.click("still_format")
        program.click("still_format:PNG, 16 bit")
        self.confirm()
        program.wait_for("the larger picture is drawn", lambda: (program.folder / "large.png").exists())
        data = (program.folder / "large.png").read_bytes()
        self.assertEqual(struct.unpack(">IIBB", data[16:26]), (480, 360, 16, 2))
        program.key("ctrl+e")
        self.fill(dialog_file=str(program.folder / "small.avif"))
        program.click("still_size")
        program.click("still_size:1x (240 × 180)")
        self.confirm()
        program.wait_for("the AVIF is written", lambda: (program.folder / "small.avif").exists())
        self.assertEqual((program.folder / "small.avif").read_bytes()[4:12], b"ftypavif")

    @unittest.skipUnless(shutil.which("xclip"), "xclip is not installed")
    def test_the_picture_is_on_the_clipboard(self):
        program = self.program
        self.hover("picture")
        program.key("ctrl+shift+c")
        program.wait("the picture is copied", lambda s: "Copied the picture (240 × 180)" in s["notice"])
        screen = {**os.environ, "DISPLAY": self.screen.display}

        def pasted(target):
            return subprocess.run(["xclip", "-selection", "clipboard", "-t", target, "-o"], env=screen,
                                  check=True, capture_output=True, timeout=20).stdout
        self.assertIn(b"image/png", pasted("TARGETS").split())
        file = program.folder / "pasted.png"
        file.write_bytes(pasted("image/png"))
        self.assertEqual(self.png_size(file), PICTURE)
        self.assertGreater(len(file.read_bytes()), 1000)
        subprocess.run(["xclip", "-selection", "clipboard", "-i"], env=screen, input=b"text", check=True, timeout=20,
                       stdout=subprocess.DEVNULL)
        self.assertEqual(pasted("UTF8_STRING"), b"text")

    def test_a_look_is_exported_as_a_preset_and_compared(self):
        program = self.program
        program.click("look:crt")
        program.wait("the look is open", lambda s: s["look"] == "crt")
        program.choose("File", "Export look…")
        program.click("look_export_target")
        program.click("look_export_target:RetroArch preset")
        program.place("look_export_losses")
        preset = program.folder / "mine.slangp"
        self.fill(dialog_file=str(preset))
        self.snapshot("look_export_preset")
        program.key("Return")
        program.place("look_export_verification")
        self.snapshot("look_exported_preset")
        self.assertIn('alias1 = ', preset.read_text(encoding="utf-8"))
        program.key("Return")
        program.wait("the dialog is closed", lambda s: s["dialog"] == 0)

    def test_edits_are_sent_to_a_running_program(self):
        program = self.program
        program.click("look:crt")
        program.wait("the look is open", lambda s: s["look"] == "crt")
        mpv = MpvServer(program.folder / "mpv", ["own.glsl"])
        self.addCleanup(mpv.close)
        program.choose("File", "Send to mpv…")
        self.fill(send_address=str(program.folder / "wrong"))
        program.click("dialog_ok")
        program.place("send_failed")
        self.snapshot("send_failed")
        self.fill(send_address=str(program.folder / "mpv"))
        program.click("send_follows")
        program.click("dialog_ok")
        program.place("send_done")
        self.snapshot("send_done")
        first = mpv.shaders
        self.assertEqual((first[0], len(first)), ("own.glsl", 2))
        program.click("dialog_cancel")
        program.wait("the dialog is closed", lambda s: s["dialog"] == 0)
        program.set("exposure", "2")
        state = program.wait("the edit is sent", lambda s: mpv.shaders != first or s["notice"])
        self.assertNotEqual(mpv.shaders, first, state["notice"])
        self.assertIn("2.0", Path(mpv.shaders[1]).read_text(encoding="utf-8"))

    def test_a_look_is_exported_as_a_page_and_compared(self):
        program = self.program
        program.choose("File", "Export look…")
        program.click("look_export_target")  # the last one is remembered
        program.click("look_export_target:Web page")
        program.place("look_export_losses")
        self.snapshot("look_export")
        page = program.folder / "page"
        self.fill(dialog_file=str(page))
        if not shutil.which("chromium"):
            self.assertIn("look_export_verify", program.state()["widgets"])
        program.key("Return")
        program.place("look_export_done")
        self.snapshot("look_exported")
        html = page.with_suffix(".html").read_text(encoding="utf-8")
        self.assertIn('"name":"Phosphor"', html)
        if shutil.which("chromium"):
            program.place("look_export_verification")
        program.key("Return")
        program.wait("the dialog is closed", lambda s: s["dialog"] == 0)
