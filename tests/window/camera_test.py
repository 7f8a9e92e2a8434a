"""The picture of the window as a virtual camera: camera_test.py PROGRAM."""

import sys
import unittest
from pathlib import Path

from own_program import OwnProgram

SOURCE = Path(__file__).resolve().parents[2]
sys.path.insert(1, str(SOURCE / "tests" / "pipewire"))
from private_pipewire import PrivatePipeWire  # noqa: E402

EXECUTABLE = Path(sys.argv[1]).resolve()
NAME = "Afterglow"


class CameraTest(OwnProgram):
    executable = EXECUTABLE

    def switch(self):
        """Runs the action from the palette."""
        self.program.key("ctrl+p")
        self.program.type("virtual camera")
        self.program.key("Return")

    def test_the_picture_is_a_camera(self):
        server = PrivatePipeWire().__enter__()
        self.addCleanup(server.__exit__)
        program = self.program
        program.variables = server.variables
        program.start()
        program.click("look:crt")
        program.wait("the look is open", lambda s: s["look"] == "crt" and not s["is_loading"])
        self.switch()
        program.wait("the name is shown", lambda s: s["notice"] ==
                     'Virtual camera on. Choose the camera "Afterglow" in the other program.')
        received = server.read(NAME, 30, self.folder / "received.raw")
        frame = 240 * 180 * 4
        self.assertEqual(len(received), 30 * frame)
        self.assertGreater(max(received[-frame::4]), 60, "the last frame is not black")
        program.key("ctrl+b")
        program.wait("it is blacked out", lambda s: s["output"] == "black")
        black = server.read(NAME, 30, self.folder / "black.raw")
        self.assertEqual(max(max(black[at::4]) for at in range(3)), 0, "no frame shows the picture")
        program.key("ctrl+b")
        program.wait("it is visible again", lambda s: s["output"] == "camera")
        program.key("space")  # a paused picture is sent, too
        program.wait("the picture is paused", lambda s: not s["is_playing"])
        still = server.read(NAME, 30, self.folder / "still.raw")
        self.assertGreater(max(still[-frame::4]), 60)
        self.switch()
        server.wait_until("the camera is gone", lambda: not server.has_port(NAME, "output"))
        self.switch()
        server.wait_until("it is there again", lambda: server.has_port(NAME, "output"))
        server.end()
        program.wait("the end of the server is reported", lambda s: s["notice"].startswith("The PipeWire server has ended"))

    def test_a_missing_server_is_reported(self):
        self.program.variables = {"XDG_RUNTIME_DIR": str(self.folder)}
        self.program.start()
        self.switch()
        self.program.wait("what to install is named", lambda s: "Install the packages pipewire" in s["notice"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
