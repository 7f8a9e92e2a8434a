"""A window of another program for the tests: build/.../tests/painted_window."""

import os
import subprocess


class PaintedWindow:
    """A window of another program, in its own process."""

    def __init__(self, program, display, title, x, y, width, height):
        self.process = subprocess.Popen([program, title, *map(str, (x, y, width, height))], text=True,
                                        stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                        env={**os.environ, "DISPLAY": display})
        self.wait()

    def wait(self):
        answer = self.process.stdout.readline().strip()
        assert answer == "done", answer

    def do(self, command):
        """Carries out a command, see painted_window.cpp."""
        print(command, file=self.process.stdin, flush=True)
        self.wait()

    def close(self):
        self.process.stdin.close()
        self.process.wait()
        self.process.stdout.close()
