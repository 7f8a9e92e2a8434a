"""Faults of the machine while the window runs: faults_test.py PROGRAM. docs/reliability.md lists what happens."""

import json
import os
import subprocess
import sys
import time
import unittest
from pathlib import Path

from own_program import OwnProgram
from program import TIMEOUT_SECONDS, Program
from screen import Screen

EXECUTABLE = Path(sys.argv[1]).resolve()
# A shell in its own mount namespace; what it mounts is not seen outside.
MOUNTS = ["unshare", "--mount", "--map-root-user", "sh", "-c"]


class FaultyMachine(Program):
    """A program that starts after shell commands, such as a mount, and without some variables."""

    commands = ""
    removed = ()

    def environment(self):
        return {name: value for name, value in super().environment().items() if name not in self.removed}

    def begin(self):
        self.state_file.unlink(missing_ok=True)
        command = [*MOUNTS, f'{self.commands} && exec "{self.executable}"'] if self.commands else [self.executable]
        self.process = subprocess.Popen(command, env=self.environment(), stderr=subprocess.DEVNULL)
        return self.wait("a look is drawn", lambda s: s.get("look") and s["frame"] > 2)


def can_mount():
    return subprocess.run([*MOUNTS, "mount -t tmpfs none /mnt"], capture_output=True, check=False).returncode == 0


class FaultsTest(OwnProgram):
    executable = EXECUTABLE
    make_program = FaultyMachine

    def full(self, folder):
        """A mount of a full disk, with the folder's files."""
        folder.mkdir(parents=True, exist_ok=True)
        return (f"cp -r {folder} {folder}.kept && mount -t tmpfs -o size=256k none {folder} && "
                f"cp -r {folder}.kept/. {folder} && (cat /dev/zero >{folder}/fill 2>/dev/null || true)")

    def read_only(self, folder):
        folder.mkdir(parents=True, exist_ok=True)
        return f"mount --bind {folder} {folder} && mount -o remount,bind,ro {folder}"

    def save(self, name):
        self.program.key("ctrl+shift+s")
        self.program.place("dialog_name")
        self.program.key("ctrl+a")
        self.program.type(name)
        self.program.key("Return")

    def check_that_it_draws(self):
        frame = self.program.state()["frame"]
        self.program.wait("it draws on", lambda s: s["frame"] > frame + 5 and s["has_picture"])

    def check_that_saving_fails(self, commands):
        self.program.commands = commands
        self.program.begin()
        self.program.set("decay", "0.5")
        self.save("Mine")
        state = self.program.wait("the dialog stays open with the reason", lambda s: "dialog_problem" in s["widgets"])
        self.assertEqual((state["typed"], state["values"]["decay"]), ("Mine", [0.5]))
        self.program.key("Escape")
        self.check_that_it_draws()

    @unittest.skipUnless(can_mount(), "no file system can be mounted here")
    def test_a_preset_on_a_full_disk_is_kept_in_the_dialog(self):
        self.check_that_saving_fails(self.full(self.folder / "own"))

    @unittest.skipUnless(can_mount(), "no file system can be mounted here")
    def test_a_preset_in_a_read_only_folder_is_kept_in_the_dialog(self):
        self.check_that_saving_fails(self.read_only(self.folder / "own"))

    @unittest.skipUnless(can_mount(), "no file system can be mounted here")
    def test_a_session_that_cannot_be_saved_is_reported(self):
        for commands in (self.full(self.folder / "state"), self.read_only(self.folder / "state")):
            before = self.program.session().read_bytes()
            self.program.commands = commands
            self.program.begin()
            self.program.set("decay", "0.5")
            self.program.wait("the reason is shown", lambda s: "session.json: can't write the file" in s["notice"])
            self.check_that_it_draws()
            self.program.quit()
            self.assertEqual(self.program.session().read_bytes(), before)

    def test_without_a_home_folder_it_draws_and_reports_it(self):
        self.program.removed = ("XDG_DATA_HOME", "XDG_STATE_HOME", "XDG_CONFIG_HOME", "XDG_CACHE_HOME")
        self.program.variables = {"HOME": "/proc/none"}
        self.program.begin()
        self.program.set("decay", "0.5")
        self.program.wait("the reason is shown", lambda s: "session.json: can't create its folder" in s["notice"])
        self.check_that_it_draws()
        self.program.quit()

    def test_an_edit_is_seen_when_the_clock_was_set_back(self):
        self.program.begin()
        shader = self.folder / "data/shaders/phosphor/composite.frag"
        for wanted, age in ((0.7, 0), (0.6, 7200), (0.5, 7200 * 12)):
            text = shader.read_text()
            shader.write_text(text.replace(text[text.index("keep_hue = "):].split(";")[0] + ";", f"keep_hue = {wanted};"))
            stamp = time.time() - age
            os.utime(shader, (stamp, stamp))
            self.program.wait("the edit is seen", lambda s: s["values"]["keep_hue"] == [wanted])
        self.program.set("decay", "0.5")
        self.program.quit()
        future = time.time() + 86400
        os.utime(self.program.session(), (future, future))
        state = self.program.begin()
        self.assertEqual(state["values"]["decay"], [0.5])

    def test_a_lost_display_ends_the_program_and_loses_no_value(self):
        self.program.begin()
        self.program.set("decay", "0.5")
        self.program.wait_for("the session is saved", lambda: json.loads(self.program.session().read_text())[
            "current"]["preset"]["values"].get("decay") == 0.5)
        self.screen.server.kill()
        code = self.program.process.wait(TIMEOUT_SECONDS)
        self.assertEqual(code, 1)
        with Screen(1000, 700) as screen:
            self.program.screen = screen
            state = self.program.begin()
            self.assertEqual((state["look"], state["values"]["decay"]), ("phosphor", [0.5]))
            self.program.quit()


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]], verbosity=2)
