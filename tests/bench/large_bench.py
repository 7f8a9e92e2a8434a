"""What a first frame of Phosphor takes as a large picture: large_bench.py PROGRAM. CPU time of the whole
command and the most memory that it had."""

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
                sys.exit("afterglow render --size %s ended with %d" % (size, process.returncode))
            about = ("large", "A first frame of Phosphor as a PNG, large")
            words = size.replace("x", " x ")
            tell(*about, size + "-time", words + ": CPU time", usage.ru_utime + usage.ru_stime, "s")
            tell(*about, size + "-memory", words + ": most memory", usage.ru_maxrss / 1e6 * 1.024, "GB")


main()
