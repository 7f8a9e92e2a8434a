"""A session bus of its own for a test. It starts no services, so that no portal of the machine takes part."""

import shutil
import subprocess
import tempfile
from pathlib import Path

CONFIG = """<busconfig>
  <type>session</type>
  <listen>unix:tmpdir=/tmp</listen>
  <policy context="default">
    <allow send_destination="*"/>
    <allow receive_sender="*"/>
    <allow own="*"/>
  </policy>
</busconfig>
"""


class PrivateBus:
    """`address` is for $DBUS_SESSION_BUS_ADDRESS."""

    def __enter__(self):
        self.folder = Path(tempfile.mkdtemp(prefix="afterglow-bus-"))
        (self.folder / "bus.conf").write_text(CONFIG)
        self.daemon = subprocess.Popen(
            ["dbus-daemon", f"--config-file={self.folder / 'bus.conf'}", "--nofork", "--nopidfile", "--print-address=1"],
            stdout=subprocess.PIPE, text=True)
        self.address = self.daemon.stdout.readline().strip()
        return self

    def __exit__(self, *_):
        self.daemon.kill()
        self.daemon.wait()
        self.daemon.stdout.close()
        shutil.rmtree(self.folder, ignore_errors=True)
