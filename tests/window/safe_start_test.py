"""The start after a crash, hang or reset of the driver: safe_start_test.py PROGRAM."""

import signal
import subprocess
import sys
import unittest
from pathlib import Path

from own_program import OwnProgram
from program import TIMEOUT_SECONDS, Program

EXECUTABLE = Path(sys.argv[1]).resolve()


class FaultyProgram(Program):
    """A program whose driver fails in the way that a test sets."""

    fault = ""

    def environment(self):
        return {**super().environment(), "AFTERGLOW_INJECT_FAULT": self.fault}

    def begin(self, *arguments, fault=""):
        """Starts the program without waiting."""
        self.fault = fault
        self.state_file.unlink(missing_ok=True)
        self.process = subprocess.Popen([self.executable, *arguments], env=self.environment(),
                                        stderr=subprocess.DEVNULL)

    def wait_for_offer(self):
        """Waits for the notice that the look was not opened."""
        return self.wait("the look is offered", lambda s: "offer:Try again" in s["widgets"])


class SafeStartTest(OwnProgram):
    executable = EXECUTABLE
    make_program = FaultyProgram

    def setUp(self):
        super().setUp()
        self.program.start()
        self.program.set("decay", "0.5")
        self.values = self.program.state()["values"]
        self.program.quit()

    def crash(self, *arguments):
        self.program.begin(*arguments, fault="crash")
        self.program.process.wait(TIMEOUT_SECONDS)
        self.assertEqual(self.program.process.returncode, -signal.SIGSEGV)

    def check_that_it_opens_again(self):
        program = self.program
        program.click("offer:Try again")
        state = program.wait("the look is open", lambda s: s.get("look") == "phosphor" and s["frame"] > 2)
        self.assertEqual(state["values"], self.values)
        self.assertTrue(state["is_modified"])
        program.quit()
        program.begin()
        program.wait("the look opens without an offer", lambda s: s.get("look") == "phosphor" and s["frame"] > 2)

    def test_a_look_that_crashed_the_program_is_offered_and_the_session_survives(self):
        self.crash()
        for _ in range(2):  # the same at each start until the user decides
            self.program.begin()
            state = self.program.wait_for_offer()
            self.assertEqual(state["notice"], "Afterglow quit while compiling \"phosphor\". "
                                              "The look was not reopened.")
            self.assertFalse(state.get("look"))
            self.program.quit()
        self.program.begin()
        self.program.wait_for_offer()
        self.program.click("offer:Open in editor")
        self.program.wait_for("the editor is started", lambda: "phosphor/look.json" in self.program.edited_files())
        self.check_that_it_opens_again()

    def test_a_look_whose_compiling_never_ended_is_offered(self):
        for end in (self.program.kill, self.program.quit):
            self.program.begin("phosphor", fault="hang")  # named: a second start without a name only offers it
            self.program.wait("the look is being opened", lambda s: s["is_loading"])
            end()
            self.program.begin()
            self.assertFalse(self.program.wait_for_offer().get("look"))
            self.program.quit()
        self.program.begin()
        self.program.wait_for_offer()
        self.check_that_it_opens_again()

    def test_after_a_reset_of_the_driver_the_window_comes_back_without_the_look(self):
        self.program.begin(fault="reset")
        state = self.program.wait_for_offer()
        self.assertEqual(state["notice"], "The graphics driver was reset while drawing \"phosphor\". "
                                          "The look was not reopened.")
        self.check_that_it_opens_again()

    def test_another_look_that_crashed_leaves_the_session_as_it_was(self):
        self.crash("crt")
        self.program.begin()
        state = self.program.wait("the session is restored", lambda s: s.get("look") == "phosphor" and s["frame"] > 2)
        self.assertEqual(state["values"], self.values)
        self.assertIn('"crt"', state["notice"])
        self.program.click("offer:Try again")
        self.program.wait("the look is open", lambda s: s["look"] == "crt" and s["frame"] > 2)

    def test_a_look_that_is_named_is_opened_after_a_crash(self):
        self.crash()
        self.program.begin("phosphor")
        self.program.wait("the look is open", lambda s: s.get("look") == "phosphor" and s["frame"] > 2)

    def test_a_session_whose_look_is_missing_says_so_and_opens_phosphor(self):
        gone = self.folder / "gone/look.json"
        session = self.program.session()
        session.write_text(session.read_text().replace(
            str(self.folder / "data/shaders/phosphor/look.json"), str(gone)))
        self.program.begin()
        state = self.program.wait("Phosphor is open", lambda s: s.get("look") == "phosphor" and s["frame"] > 2)
        self.assertIn("The look of the last session was not found: %s." % gone, state["notice"])
        self.assertFalse(state["is_modified"])
        self.assertEqual(len(list((self.folder / "state/afterglow/unsaved").glob("*.json"))), 1)

    def test_a_program_that_still_runs_is_no_crash(self):
        self.program.begin(fault="hang")
        self.program.wait("the look is being opened", lambda s: s["is_loading"])
        other = FaultyProgram.__new__(FaultyProgram)
        other.__dict__.update(self.program.__dict__)
        other.state_file = self.folder / "other.json"
        self.addCleanup(other.stop)
        other.begin()
        other.wait("the other program opens the look", lambda s: s.get("look") == "phosphor" and s["frame"] > 2)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]], verbosity=2)
