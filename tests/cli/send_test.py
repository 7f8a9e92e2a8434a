#!/usr/bin/env python3
"""Looks sent to running programs. Small servers take the place of RetroArch and mpv.

send_test.py PROGRAM
"""
import os
import socket
import time
import unittest
from pathlib import Path

from program import ProgramTest, main, run
from running_programs import MpvServer, RetroArchServer


class SendTest(ProgramTest):
    def setUp(self):
        super().setUp()
        os.environ["XDG_CACHE_HOME"] = str(self.folder / "cache")

    def test_retroarch_loads_a_preset(self):
        retroarch = RetroArchServer()
        self.addCleanup(retroarch.close)
        result = run("export", "crt", "--to", "slang", "--send", retroarch.port)
        self.assert_done(result)
        self.assertEqual(result.stdout, "sent to RetroArch\n")
        for _ in range(100):
            if retroarch.loaded:
                break
            time.sleep(0.05)
        (path, text), = retroarch.loaded
        self.assertTrue(path.endswith(".slangp"))
        self.assertIn("shaders =", text)
        self.assert_done(run("check", path))

    def test_mpv_gets_a_shader_beside_its_own(self):
        mpv = MpvServer(self.folder / "mpv", ["/home/me/sharpen.glsl"])
        self.addCleanup(mpv.close)
        sent = []
        for brightness in ("1", "2", "3", "4"):
            self.assert_done(run("export", "crt", "--to", "mpv", "--send", self.folder / "mpv", "--set",
                                 f"exposure={brightness}"))
            own, shader = mpv.shaders
            self.assertEqual(own, "/home/me/sharpen.glsl")
            sent.append(Path(shader))
        self.assertEqual(len(set(sent)), 4)  # mpv keeps what it has read of a path
        self.assertEqual([file.exists() for file in sent], [False, False, True, True])

    def test_a_program_that_does_not_answer_is_named_with_what_to_do(self):
        silent = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.addCleanup(silent.close)
        silent.bind(("127.0.0.1", 0))
        port = silent.getsockname()[1]
        self.assert_refused(run("export", "crt", "--to", "slang", "--send", port),
                            f"RetroArch does not answer on port {port}. Enable network commands.")
        missing = self.folder / "no-socket"
        self.assert_refused(run("export", "crt", "--to", "mpv", "--send", missing),
                            f"mpv does not answer on {missing}. Start it with --input-ipc-server={missing}.")

    def test_wrong_use(self):
        self.assert_refused(run("export", "crt", "--to", "web", "--send", "55355"), "--send: only with", code=2)
        self.assert_refused(run("export", "crt", "--to", "slang", "--send", "near"), "'near' is not a port")
        self.assert_refused(run("export", "vector-beam", "--to", "slang", "--send", "55355"), "draws a beam")


if __name__ == "__main__":
    main()
