"""Cost of the first frame of Phosphor as a large picture: large_bench.py PROGRAM. Measures the CPU
time and the peak memory of the whole command."""

import os
import subprocess
import sys
import tempfile
from pathlib import Path

from figure import tell

SIZES = ("4096x4096", "7680x4320")


def main():
    program = Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory(prefix="afterglow-bench-") as folder:
        for size in SIZES:
            process = subprocess.Popen([program, "render", "phosphor", "--size", size, "--frames", "1",
                                        "-o", str(Path(folder, size + ".png"))])
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
            if process.returncode:
                sys.exit("afterglow render --size %s failed with exit code %d" % (size, process.returncode))
            about = ("large", "First frame of Phosphor as a large PNG")
            words = size.replace("x", " x ")
            tell(*about, size + "-time", "%s: CPU time" % words, usage.ru_utime + usage.ru_stime, "s")
            tell(*about, size + "-memory", "%s: peak memory" % words, usage.ru_maxrss / 1e6 * 1.024, "GB")


main()
