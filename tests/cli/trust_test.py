"""What files of others can make the program do: trust_test.py PROGRAM CALL_LOG. CALL_LOG is a library that notes
sockets and started programs."""

import json
import subprocess
import sys
import unittest
import wave
from pathlib import Path

CALL_LOG = Path(sys.argv.pop(2)).resolve()

from program import PROGRAM, SLANG, SOURCE, ProgramTest, main, run  # noqa: E402  its arguments follow

ISF = """/*{"ISFVSN": "2", "INPUTS": [{"NAME": "level", "TYPE": "float", "DEFAULT": 0.5}]}*/
void main() { gl_FragColor = vec4(level); }
"""
SHADERTOY = "void mainImage(out vec4 color, in vec2 place) { color = vec4(place / iResolution.xy, iTime, 1.0); }\n"
OWN_PROGRAMS = {"afterglow", "ffmpeg", "ffprobe"}


class TrustTest(ProgramTest):
    def setUp(self):
        super().setUp()
        self.log = self.folder / "calls"
        self.given = self.folder / "given"  # the files of others
        self.given.mkdir()

    def calls(self):
        return self.log.read_text().splitlines() if self.log.exists() else []

    def files(self):
        return {file.relative_to(self.given): file.read_bytes() for file in self.given.rglob("*") if file.is_file()}

    def use(self, *arguments):
        """Runs a command. It must open no socket to other machines, start no other program, and leave the files alone."""
        before = self.files()
        self.assert_done(run(*arguments, cwd=self.folder, LD_PRELOAD=str(CALL_LOG), AFTERGLOW_CALL_LOG=str(self.log),
                             XDG_DATA_HOME=str(self.folder / "own"), XDG_STATE_HOME=str(self.folder / "state")))
        self.assertEqual([call for call in self.calls() if call.startswith("socket")], [])
        started = {Path(call.split(" ", 1)[1]).name for call in self.calls() if call.startswith("start")}
        self.assertLessEqual(started, OWN_PROGRAMS)
        self.assertEqual(self.files(), before)

    def render(self, *arguments):
        self.use("render", *arguments, "--size", "64x48", "-o", "picture.png")
        self.assertTrue((self.folder / "picture.png").exists())

    def preset(self, **changes):
        return self.write("given/preset.json", json.dumps({
            "format": "afterglow-preset", "version": 1, "look": "phosphor", "name": "Given", **changes}))

    def test_the_log_sees_sockets_and_programs(self):
        code = ("import os, socket; socket.socket(socket.AF_INET); socket.socket(socket.AF_INET6); "
                "os.posix_spawnp('true', ['true'], os.environ)")
        subprocess.run(["/usr/bin/python3", "-c", code], check=True, env={
            "PATH": "/usr/bin:/bin", "LD_PRELOAD": str(CALL_LOG), "AFTERGLOW_CALL_LOG": str(self.log)})
        self.assertEqual(self.calls(), ["socket 2", "socket 10", "start true"])

    def test_a_look_only_draws(self):
        look = json.loads((SOURCE / "shaders/crt/look.json").read_text())
        self.write("given/look/crt.frag", (SOURCE / "shaders/crt/crt.frag").read_text())
        self.write("given/look/look.json", json.dumps(look))
        self.render("given/look")
        self.use("check", "given/look")

    def test_shaders_of_other_programs_only_draw(self):
        for name, text in (("a.slang", SLANG), ("a.fs", ISF), ("a.glsl", SHADERTOY)):
            self.write(f"given/{name}", text)
            self.render(f"given/{name}")

    def test_a_preset_only_chooses_values_and_content(self):
        with wave.open(str(self.given / "a.wav"), "wb") as sound:
            sound.setparams((2, 2, 8000, 0, "NONE", ""))
            sound.writeframes(bytes(range(256)) * 100)
        self.preset(values={"decay": 0.5}, signal={"kind": "audio", "file": "a.wav"})
        self.render("given/preset.json")

    def test_a_pack_only_adds_looks_and_presets_to_the_own_folder(self):
        self.preset(values={"decay": 0.5})
        self.use("pack", "given/preset.json", "-o", "given.afterglow")
        (self.folder / "given.afterglow").rename(self.given / "given.afterglow")
        before = {file for file in self.folder.rglob("*") if file.is_file()}
        self.use("pack", "--install", "given/given.afterglow")
        added = {file for file in self.folder.rglob("*") if file.is_file()} - before - {self.log}
        self.assertTrue(added)
        for file in added:
            self.assertTrue(file.is_relative_to(self.folder / "own/afterglow"), file)

    def test_a_video_starts_only_ffmpeg(self):
        subprocess.run(["ffmpeg", "-loglevel", "error", "-f", "lavfi", "-i", "testsrc=size=64x48:rate=10:duration=1",
                        "-pix_fmt", "yuv420p", self.given / "a.mp4"], check=True)
        self.render("crt", "--source", "given/a.mp4")
        self.assertTrue(any(call.endswith("ffmpeg") for call in self.calls()), self.calls())

    def test_the_page_of_a_look_and_a_gallery_are_made_without_the_network(self):
        self.use("export", "crt", "--to", "web", "-o", "page.html")
        self.use("gallery", "crt", "-o", "gallery")


if __name__ == "__main__":
    assert PROGRAM.is_file() and CALL_LOG.is_file(), "give the program and the library"
    main()
