"""The desktop's file dialog, by a stand-in for its portal on a private session bus:
desktop_dialog_test.py PROGRAM [DesktopDialogTest.NAME...]."""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from person import Person, write_tones

sys.path.insert(1, str(Path(__file__).resolve().parents[1] / "desktop"))
from private_bus import PrivateBus  # noqa: E402

Person.executable = Path(sys.argv[1]).resolve()
FAKE_PORTAL = Person.executable.parents[1] / "tests/fake_portal"


class DesktopDialogTest(Person):
    @classmethod
    def sit_down(cls):
        cls.bus = cls.enter(PrivateBus()).address
        cls.portal_folder = Path(cls.enter(tempfile.TemporaryDirectory(prefix="afterglow-portal-")))
        cls.start_portal()
        cls.cleanups.append(lambda *_: cls.end(cls.portal))
        super().sit_down()

    @classmethod
    def arrange(cls, program):
        program.bus = cls.bus

    @classmethod
    def start_portal(cls):
        cls.portal = subprocess.Popen([FAKE_PORTAL, cls.portal_folder], stdin=subprocess.PIPE,
                                      stdout=subprocess.PIPE, text=True,
                                      env={"DBUS_SESSION_BUS_ADDRESS": cls.bus})
        assert cls.portal.stdout.readline().strip() == "running"

    @staticmethod
    def end(process):
        process.kill()
        process.communicate()

    def react(self, reaction):
        (self.portal_folder / "calls").unlink(missing_ok=True)
        (self.portal_folder / "reaction").write_text(reaction)

    def calls(self):
        file = self.portal_folder / "calls"
        return file.read_text().splitlines() if file.exists() else []

    def test_the_desktops_dialog_opens_and_saves(self):
        program = self.program
        sound = program.folder / "a tone.wav"
        write_tones(sound, seconds=1)
        self.react("choose file://%s" % str(sound).replace(" ", "%20"))
        program.key("ctrl+o")
        program.wait("the chosen sound opens", lambda s: "a tone.wav" in s["signal"] and not s["dialog"])
        call, = self.calls()
        self.assertTrue(call.startswith('OpenFile "x11:0x%x" ' % self.screen.window()), call)
        self.assertIn('"*.wav"', call)

        self.react("choose file://%s/seen" % program.folder)
        program.click("save_pass")
        program.wait_for("the pass is saved", (program.folder / "seen.exr").exists)
        call, = self.calls()
        self.assertIn('"current_name"="composite.exr"', call)

        program.wait("the dialog is closed", lambda s: not s["dialog"])
        program.click("save_pass")  # the extension leads to a file that the desktop did not ask about
        program.place("dialog_taken")
        program.key("Escape")
        self.react("cancel")
        program.key("ctrl+o")
        program.wait_for("the desktop was asked", self.calls)
        program.wait("a cancelled dialog closes", lambda s: not s["dialog"])

    def test_a_portal_that_hangs_or_ends_is_replaced(self):
        program = self.program
        self.react("hang")
        program.key("ctrl+o")
        program.place("own_dialog")
        frame = program.state()["frame"]
        program.wait("the picture goes on", lambda s: s["frame"] > frame + 5)
        self.snapshot("desktop_dialog")
        program.click("own_dialog")
        program.place("dialog_file")
        self.snapshot("own_dialog")
        program.key("Escape")
        program.wait("the dialog is closed", lambda s: not s["dialog"])

        self.react("leave")
        program.key("ctrl+o")
        program.place("dialog_file")
        program.wait("the failure is reported", lambda s: "desktop's file dialog failed" in s["notice"])
        program.key("Escape")
        self.end(self.portal)
        program.key("ctrl+o")
        program.place("dialog_file")  # without a portal, the own dialog opens at once
        program.key("Escape")
        type(self).start_portal()
        self.react("hang")
        program.wait("the dialog is closed", lambda s: not s["dialog"])
        program.key("ctrl+o")
        program.place("own_dialog")
        program.key("Escape")
        program.choose("File", "Use desktop file dialog")
        program.key("ctrl+o")
        program.place("dialog_file")
        program.key("Escape")
        program.choose("File", "Use desktop file dialog")


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]], verbosity=2)
