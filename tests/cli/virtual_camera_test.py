#!/usr/bin/env python3
"""Virtual cameras: pictures through a PipeWire server of the test, as GStreamer reads them."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

TESTS = Path(__file__).resolve().parents[1]
sys.path.insert(1, str(TESTS / "pipewire"))

from private_pipewire import PrivatePipeWire  # noqa: E402
from program import PROGRAM, ProgramTest, main, run  # noqa: E402

# Draws colours that depend on the pixel: 8 red steps to the right, 5 green steps upwards, blue 51.
STEPS = """/*{ }*/
void main() {
    vec2 pixel = floor(gl_FragCoord.xy);
    gl_FragColor = vec4(mod(pixel.x, 8.0) * 17.0 / 255.0, mod(pixel.y, 5.0) * 30.0 / 255.0, 0.2, 1.0);
}
"""
WIDTH, HEIGHT = 37, 21


def expected_picture():
    return b"".join(bytes([51, (HEIGHT - 1 - y) % 5 * 30, x % 8 * 17, 255])
                    for y in range(HEIGHT) for x in range(WIDTH))


class VirtualCameraTest(ProgramTest):
    def setUp(self):
        super().setUp()
        self.look = self.folder / "steps.fs"
        self.look.write_text(STEPS)

    def server(self):
        server = PrivatePipeWire().__enter__()
        self.addCleanup(server.__exit__)
        return server

    def start(self, server, output, *options):
        drawing = subprocess.Popen(
            [PROGRAM, "render", self.look, "--size", f"{WIDTH}x{HEIGHT}", "--fps", "30", "-o", output, *options],
            env={**os.environ, **server.variables}, stderr=subprocess.PIPE, text=True)
        self.addCleanup(drawing.stderr.close)
        self.addCleanup(drawing.wait)
        self.addCleanup(drawing.kill)
        return drawing

    def test_another_program_reads_the_pixels(self):
        server = self.server()
        drawing = self.start(server, "pipewire:Test tube")
        received = server.read("Test tube", 3, self.folder / "received.raw")
        self.assertEqual(received, expected_picture() * 3)
        drawing.send_signal(signal.SIGINT)
        drawing.wait(timeout=30)
        server.wait_until("the camera is gone", lambda: "Test tube" not in server.do("pw-cli", "ls", "Node"))

    def test_the_camera_has_a_usual_name(self):
        server = self.server()
        self.start(server, "pipewire:")
        server.wait_until("the camera is there", lambda: server.has_port("Afterglow", "output"))
        self.assertIn('media.class = "Video/Source"', server.do("pw-cli", "ls", "Node"))

    def test_frames_are_shown_at_their_times(self):
        server = self.server()
        begun = time.monotonic()
        drawing = self.start(server, "pipewire:", "--seconds", "1")
        self.assertEqual(drawing.wait(timeout=60), 0)
        self.assertGreaterEqual(time.monotonic() - begun, 1)  # 30 frames

    def test_the_end_of_the_server_is_reported(self):
        server = self.server()
        drawing = self.start(server, "pipewire:")
        server.wait_until("the camera is there", lambda: server.has_port("Afterglow", "output"))
        server.end()
        self.assertEqual(drawing.wait(timeout=30), 1)
        self.assertIn("the PipeWire server has ended", drawing.stderr.read())

    def test_what_is_missing_is_named(self):
        for output, why in (("pipewire:", "no PipeWire server answers (Host is down). Install the packages pipewire "
                                          "and wireplumber"),
                            ("v4l2:/dev/video-none", "virtual camera '/dev/video-none' not found. Install the package "
                                                     "v4l2loopback-dkms"),
                            ("v4l2:/dev/null", "'/dev/null' is not a free virtual camera")):
            with self.subTest(output):
                refused = run("render", self.look, "--size", "8x8", "-o", output, XDG_RUNTIME_DIR=self.folder)
                self.assert_refused(refused, why)

    def test_wrong_usage_is_refused(self):
        for options, why in ((["-o", "v4l2:"], "name a virtual camera as pipewire:NAME or v4l2:/dev/videoN"),
                             (["-o", "pipewire:", "--all-passes", "x"], "needs --frames or --seconds"),
                             (["-o", "pipewire:", "--loop"], "--loop needs a video file"),
                             (["-o", "pipewire:", "--codec", "h264"], "need a video file"),
                             (["-o", "pipewire:", "--alpha"], "--alpha needs a video file")):
            with self.subTest(options):
                self.assert_refused(run("render", self.look, *options), why, code=2)


if __name__ == "__main__":
    main()
