#!/usr/bin/env python3
"""The screen of a Wayland desktop: a stand-in for its portal, and a PipeWire server of the test.

screen_cast_test.py PROGRAM FAKE_SCREEN_CAST
"""

import os
import re
import subprocess
import sys
from pathlib import Path

FAKE_SCREEN_CAST = sys.argv.pop()
TESTS = Path(__file__).resolve().parents[1]
sys.path[1:1] = [str(TESTS / "pipewire"), str(TESTS / "desktop")]

from private_bus import PrivateBus  # noqa: E402
from private_pipewire import PrivatePipeWire  # noqa: E402
from program import PROGRAM, ProgramTest, main, read_png  # noqa: E402

# Draws colours that depend on the pixel.
STEPS = """/*{ }*/
void main() {
    vec2 pixel = floor(gl_FragCoord.xy);
    gl_FragColor = vec4(mod(pixel.x, 8.0) * 17.0 / 255.0, mod(pixel.y, 5.0) * 30.0 / 255.0, 0.2, 1.0);
}
"""
# Draws the source without a change.
COPY = """/*{ "INPUTS": [{ "NAME": "inputImage", "TYPE": "image" }] }*/
void main() { gl_FragColor = IMG_THIS_PIXEL(inputImage); }
"""
WIDTH, HEIGHT = 37, 21


class ScreenCastTest(ProgramTest):
    def setUp(self):
        super().setUp()
        self.copy = self.write("copy.fs", COPY)
        self.server = self.enter(PrivatePipeWire())
        self.bus = self.enter(PrivateBus())
        self.environment = {**os.environ, **self.server.variables, "DBUS_SESSION_BUS_ADDRESS": self.bus.address,
                            "WAYLAND_DISPLAY": "wayland-test"}

    def enter(self, manager):
        entered = manager.__enter__()
        self.addCleanup(manager.__exit__, None, None, None)
        return entered

    def start(self, *words, **settings):
        process = subprocess.Popen([str(word) for word in words], env=self.environment, text=True, **settings)
        for stream in (process.stdin, process.stdout, process.stderr):
            if stream:
                self.addCleanup(stream.close)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process

    def desktop(self, reaction):
        """Starts a screen and the portal that shares it."""
        self.start(PROGRAM, "render", self.write("steps.fs", STEPS), "--size", f"{WIDTH}x{HEIGHT}", "--fps", "30", "-o",
                   "pipewire:Screen")
        return self.portal(reaction)

    def portal(self, reaction):
        """Starts the portal of the present screen."""
        self.server.wait_until("the screen is there", lambda: self.server.has_port("Screen", "output"))
        nodes = re.findall(r"id (\d+), type PipeWire:Interface:Node(?:.*\n)+?.*node.name = \"Screen\"",
                           self.server.do("pw-cli", "ls", "Node"))
        portal = self.start(FAKE_SCREEN_CAST, reaction, nodes[-1], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        self.assertEqual(portal.stdout.readline(), "running\n")
        return portal

    def draw(self, source, *options):
        return self.start(PROGRAM, "render", self.copy, "--source", source, "--size", f"{WIDTH}x{HEIGHT}", *options,
                          stderr=subprocess.PIPE)

    def calls(self, portal, count):
        return [portal.stdout.readline().strip() for _ in range(count)]

    def test_the_shared_screen_is_drawn(self):
        portal = self.desktop("share")
        file = self.folder / "drawn.png"
        drawing = self.draw("screen:", "--frames", "1", "-o", file)
        self.server.link("Screen", "Afterglow")
        self.assertEqual(drawing.wait(timeout=60), 0, drawing.stderr.read())
        _, _, rows = read_png(file)
        expected = [bytes(value for x in range(WIDTH) for value in (x % 8 * 17, (HEIGHT - 1 - y) % 5 * 30, 51))
                    for y in range(HEIGHT)]
        self.assertEqual([bytes(row) for row in rows], expected)
        self.assertEqual(self.calls(portal, 4),
                         ["CreateSession", "SelectSources types=3 cursor_mode=1 persist_mode=2", "Start",
                          "OpenPipeWireRemote"])

    def test_the_pixel_formats_of_other_senders_are_read(self):
        for pixels in ("BGRx", "BGRA", "RGBx", "RGBA"):
            with self.subTest(pixels):
                screen = self.start("gst-launch-1.0", "-q", "videotestsrc", "is-live=true", "pattern=solid-color",
                                    "foreground-color=0xff3366cc", "!",
                                    f"video/x-raw,format={pixels},width={WIDTH},height={HEIGHT},framerate=30/1", "!",
                                    "pipewiresink", "mode=provide",
                                    "stream-properties=p,media.class=Video/Source,node.name=Screen")
                portal = self.portal("share")
                file = self.folder / f"{pixels}.png"
                drawing = self.draw("screen:", "--frames", "1", "-o", file)
                self.server.link("Screen", "Afterglow")
                self.assertEqual(drawing.wait(timeout=60), 0, drawing.stderr.read())
                _, _, rows = read_png(file)
                self.assertEqual({bytes(row) for row in rows}, {bytes([0x33, 0x66, 0xCC]) * WIDTH})
                for process in (portal, screen):
                    process.kill()
                    process.wait()

    def test_the_cursor_is_asked_for(self):
        portal = self.desktop("share")
        self.draw("screen:,cursor=on", "--frames", "1", "-o", self.folder / "drawn.png")
        self.assertIn("cursor_mode=2", self.calls(portal, 2)[1])

    def begin(self, seconds):
        """The portal, and a drawing that has written its first frame."""
        portal = self.desktop("share")
        drawing = self.draw("screen:", "--seconds", seconds, "-o", self.folder / "%d.png")
        self.server.link("Screen", "Afterglow")
        self.calls(portal, 4)
        self.server.wait_until("the first frame is written", (self.folder / "0.png").exists)
        return portal, drawing

    def test_after_a_loss_the_same_is_shared_again_without_a_question(self):
        portal, drawing = self.begin(30)
        self.server.end()
        self.assertEqual(self.calls(portal, 2)[1],
                         "SelectSources types=3 cursor_mode=1 persist_mode=2 restore_token=again")
        drawing.kill()

    def test_after_the_user_has_stopped_sharing_nothing_is_asked(self):
        portal, drawing = self.begin(3)
        portal.stdin.write("end\n")
        portal.stdin.flush()
        self.assertEqual(drawing.wait(timeout=60), 0, "the last picture stays")
        self.assertIn("screen sharing was refused or stopped on the desktop", drawing.stderr.read())
        portal.stdin.close()
        self.assertEqual(portal.stdout.read(), "", "no further call")

    def test_a_refusal_is_final(self):
        portal = self.desktop("deny")
        refused = self.draw("screen:", "--frames", "1", "-o", self.folder / "no.png")
        self.assertEqual(refused.wait(timeout=60), 1)
        self.assertIn("screen sharing was refused or stopped on the desktop", refused.stderr.read())
        self.assertEqual(self.calls(portal, 3)[-1], "Start")

    def test_what_is_missing_is_named(self):
        for reaction, source, why in (("", "screen:", "Install the package xdg-desktop-portal"),
                                      ("nothing", "screen:", "the desktop has shared no screen"),
                                      ("", "screen:area=0x0+8+8", "area= needs an X11 session")):
            with self.subTest(why):
                if reaction:
                    self.desktop(reaction)
                refused = self.draw(source, "--frames", "1", "-o", self.folder / "no.png")
                self.assertEqual(refused.wait(timeout=60), 1)
                self.assertIn(why, refused.stderr.read())


if __name__ == "__main__":
    main()
