"""A PipeWire server of its own for a test, without a session manager: the test links the nodes."""

import os
import shutil
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

CONFIG = """
context.properties = { core.daemon = true core.name = pipewire-0 }
context.spa-libs = { support.* = support/libspa-support }
context.modules = [
    { name = libpipewire-module-protocol-native }
    { name = libpipewire-module-client-node }
    { name = libpipewire-module-access }
    { name = libpipewire-module-metadata }
    { name = libpipewire-module-link-factory }
    { name = libpipewire-module-spa-node-factory }
]
context.objects = [
    { factory = spa-node-factory
        args = { factory.name = support.node.driver node.name = Dummy-Driver priority.driver = 20000 } }
]
"""


class PrivatePipeWire:
    """Skips the test where PipeWire or GStreamer is not installed."""

    def __enter__(self):
        for program in ("pipewire", "pw-link", "gst-launch-1.0"):
            if not shutil.which(program):
                raise unittest.SkipTest(f"{program} is not installed")
        self.folder = Path(tempfile.mkdtemp())
        (self.folder / "server.conf").write_text(CONFIG)
        self.variables = {"XDG_RUNTIME_DIR": str(self.folder), "PIPEWIRE_DEBUG": "1"}
        self.server = subprocess.Popen(["pipewire", "-c", str(self.folder / "server.conf")],
                                       env={**os.environ, **self.variables})
        self.wait_until("the server runs", lambda: (self.folder / "pipewire-0").exists())
        return self

    def __exit__(self, *_):
        self.end()
        shutil.rmtree(self.folder, ignore_errors=True)

    def end(self):
        self.server.terminate()
        self.server.wait()

    def wait_until(self, what, is_true):
        for _ in range(300):
            if is_true():
                return
            time.sleep(0.05)
        raise AssertionError(f"never happened: {what}")

    def do(self, *words):
        """The output of a command line tool of PipeWire."""
        return subprocess.run(words, capture_output=True, text=True, env={**os.environ, **self.variables}).stdout

    def has_port(self, node, direction):
        return f"{node}:" in self.do("pw-link", f"--{direction}")

    def link(self, sender, receiver):
        """Connects two nodes, once both are there."""
        self.wait_until(f"{sender} is there", lambda: self.has_port(sender, "output"))
        self.wait_until(f"{receiver} is there", lambda: self.has_port(receiver, "input"))
        self.do("pw-link", sender, receiver)

    def read(self, node, count, file):
        """Writes `count` pictures of a node into a file, as GStreamer reads them: rows of B, G, R and one
        more byte."""
        receiver = subprocess.Popen(
            ["gst-launch-1.0", "-q", "pipewiresrc", f"target-object={node}", f"num-buffers={count}",
             "client-name=receiver", "!", "video/x-raw,format=BGRx", "!", "filesink", f"location={file}"],
            env={**os.environ, **self.variables})
        try:
            self.link(node, "receiver")
            receiver.wait(timeout=30)
        finally:
            receiver.kill()
            receiver.wait()
        return file.read_bytes()
