"""Another program drives the beam through standard input or a Unix socket."""

import os
import signal
import socket
import struct
import subprocess
import time
import wave

from program import PROGRAM, ProgramTest, main, read_png, run

DOT = b"0.5 0.5 0 0.001\n0.5 0.5 1 0.03\n"
RENDER = (PROGRAM, "render", "vector-beam", "--size", "96x96", "--frames", "2")


class Pipe(ProgramTest):
    def render(self, name, sent, spec="stdin", code=0):
        file = self.folder / name
        done = subprocess.run([*RENDER, "--signal", spec, "-o", file], input=sent, capture_output=True, timeout=120)
        self.assertEqual(done.returncode, code, done.stderr)
        return file, done.stderr.decode()

    def start(self, place, *options):
        """Starts `render` with a socket at `place`, and waits for the socket."""
        started = subprocess.Popen([*RENDER, "--signal", f"socket:{place}", *options, "-o", self.folder / "out.png"],
                                   stderr=subprocess.PIPE)
        self.addCleanup(started.kill)
        end = time.monotonic() + 60
        while not place.exists() and started.poll() is None and time.monotonic() < end:
            time.sleep(0.02)
        return started

    def connect(self, place):
        sender = socket.socket(socket.AF_UNIX)
        self.addCleanup(sender.close)
        sender.connect(str(place))
        return sender

    def finish(self, started, code=0):
        _, told = started.communicate(timeout=60)
        self.assertEqual(started.returncode, code, told)
        return told.decode()

    def assert_dot(self, file):
        width, height, rows = read_png(file)
        light = [(sum(rows[y][3 * x:3 * x + 3]), x, y) for y in range(height) for x in range(width)]
        brightest, x, y = max(light)
        self.assertGreater(brightest, 100)
        # -1 to 1 covers 0.9 of 96 px: x and y of 0.5 are 21.6 px from the centre.
        self.assertLessEqual(abs(x - 69.6), 1)
        self.assertLessEqual(abs(y - 26.4), 1)

    def test_a_dot_lies_where_it_was_sent_and_bad_lines_are_told_once(self):
        good, told = self.render("good.png", DOT)
        self.assertEqual(told, "")
        self.assert_dot(good)
        bad, told = self.render("bad.png", b"0 nan 1\n" + DOT + b"x\n" * 1000, code=1)
        self.assertIn("stdin:1: error: 'y' must be a number, got 'nan'", told)
        self.assertEqual(told.count("error:"), 1)
        self.assertEqual(good.read_bytes(), bad.read_bytes())

    def test_a_program_that_sends_nothing_is_told(self):
        dark, told = self.render("dark.png", b"")
        self.assertEqual(told, "stdin: warning: ended without sending a point\n")
        self.assertLess(max(max(row) for row in read_png(dark)[2]), 10)

    def test_raw_points_draw_the_same(self):
        rest = struct.pack("<3f", 0.5, 0.5, 0) + struct.pack("<3f", 0.5, 0.5, 1) * 30
        raw, told = self.render("raw.png", rest, "stdin:format=f32le,rate=1000,channels=3")
        self.assertEqual(told, "")
        self.assert_dot(raw)

    def test_bytes_that_are_no_text_and_a_line_without_end_are_told_and_the_rest_is_sound(self):
        for sent, words in ((bytes(range(256)) * 40, "expected x y intensity"),
                            (b"1" * 3000000, "the line is too long; the limit is 1000 characters")):
            file = self.folder / "rest.wav"
            done = subprocess.run([PROGRAM, "signal", "stdin", "--seconds", "0.1", "-o", file],
                                  input=sent + b"\n0.5 -0.5 1 0.001\n", capture_output=True, timeout=60)
            self.assertEqual(done.returncode, 1, done.stderr)
            self.assertIn(words, done.stderr.decode("ascii"))
            # The beam stays at its last point to the end of the file, as two floats.
            self.assertEqual(struct.unpack("<2f", file.read_bytes()[-8:]), (0.5, -0.5))

    def test_a_socket_draws_what_one_program_sends_and_is_gone_afterwards(self):
        place = self.folder / "beam.sock"
        started = self.start(place)
        self.connect(place).sendall(DOT + b"0 0 0 10\n")  # enough without closing it
        self.assertRegex(self.finish(started), "^(Waiting for a program at|Receiving from) %s. Press Ctrl.C to stop.\n$" % place)
        self.assert_dot(self.folder / "out.png")
        self.assertFalse(place.exists())

    def test_a_flood_waits_and_a_sender_that_goes_away_ends_the_picture(self):
        place = self.folder / "beam.sock"
        started = self.start(place)
        sender = self.connect(place)
        sender.settimeout(60)
        try:
            for _ in range(300):
                sender.sendall(b"0 0 1 0.000001\n" * 10000)
        except (BrokenPipeError, ConnectionResetError):
            pass  # the picture was finished before everything was sent
        sender.close()
        self.finish(started)
        self.assertFalse(place.exists())

    def test_ctrl_c_ends_the_wait_and_removes_the_socket(self):
        place = self.folder / "beam.sock"
        started = self.start(place)
        started.send_signal(signal.SIGINT)
        self.finish(started, -signal.SIGINT)
        self.assertFalse(place.exists())

    def test_a_sender_that_stays_silent_ends_the_picture_at_the_timeout(self):
        place = self.folder / "beam.sock"
        nobody = self.start(place, "--timeout", "0.5")
        self.assertIn("beam.sock: error: sent no point before the timeout", self.finish(nobody, 1))
        silent = self.start(place, "--timeout", "0.5")
        self.connect(place).sendall(b"0.5 0.5 1 0.001\n")
        self.assertIn("beam.sock: error: sent no point before the timeout", self.finish(silent, 1))
        slow = self.start(place, "--timeout", "2")  # each point restarts the timeout
        sender = self.connect(place)
        for _ in range(4):
            time.sleep(0.8)
            sender.sendall(b"0.5 0.5 1 0.01\n")
        self.finish(slow)
        self.assertFalse(place.exists())

    def test_what_a_killed_program_left_is_replaced_and_what_another_uses_is_not(self):
        place = self.folder / "beam.sock"
        started = self.start(place)
        self.assert_refused(run("signal", f"socket:{place}", "-o", self.folder / "x.wav"),
                            str(place), "another running program uses this socket")
        started.kill()
        started.communicate()
        self.assertTrue(place.exists())
        again = self.start(place)
        while again.poll() is None:
            try:
                self.connect(place).sendall(DOT + b"0 0 0 10\n")
                break
            except (ConnectionRefusedError, FileNotFoundError):  # the old socket
                time.sleep(0.02)
        self.finish(again)

    def test_places_where_no_socket_can_be_are_told(self):
        file = self.write("file.txt", "kept")
        for place, words in ((file, "the path exists and isn't a socket"),
                             (self.folder / ("x" * 120), "the path is too long for a socket"),
                             (self.folder / "none/beam.sock", "No such file or directory")):
            done = run("signal", f"socket:{place}", "-o", self.folder / "x.wav")
            self.assert_refused(done, str(place), words)
        self.assertEqual(file.read_text(), "kept")
        if os.geteuid() != 0:  # root can write anywhere
            closed = self.folder / "closed"
            closed.mkdir(mode=0o500)
            self.assert_refused(run("signal", f"socket:{closed}/s", "-o", self.folder / "x.wav"), "Permission denied")

    def assert_red(self, done, file):
        self.assertEqual(done.returncode, 0, done.stderr)
        _, _, rows = read_png(file)
        self.assertGreater(max(max(row[0::3]) for row in rows), 100)
        self.assertEqual(max(max(row[1::3]) for row in rows), 0)
        self.assertEqual(max(max(row[2::3]) for row in rows), 0)

    def test_a_red_beam_has_neither_green_nor_blue(self):
        white = ("beam_color=1,1,1", "background=0,0,0", "dither=false", "tone_map=Clamp")
        options = [part for value in white for part in ("--set", value)]
        file = self.folder / "red.png"
        done = subprocess.run([*RENDER, *options, "--signal", "stdin", "-o", file],
                              input=b"0.5 0.5 1 0.03 1 0 0\n", capture_output=True, timeout=120)
        self.assert_red(done, file)
        # The third of five channels is the intensity, the fourth is red.
        with wave.open(str(self.folder / "five.wav"), "wb") as sound:
            sound.setparams((5, 2, 4800, 0, "NONE", ""))
            sound.writeframes(struct.pack("<5h", 16000, -16000, 32767, 32767, 20000) * 480)
        spec = f"audio:{self.folder}/five.wav,intensity=3,r=4"
        self.assert_red(run(*RENDER[1:], *options, "--signal", spec, "-o", file), file)


if __name__ == "__main__":
    main()
