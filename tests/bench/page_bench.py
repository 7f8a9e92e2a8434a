"""Frame times of exported pages: page_bench.py PROGRAM. Chromium draws each page with ?bare on the
system's GL. Then the program draws the same look at the same size and frame rate, because a beam draws
all of the time that has passed. It uses generic programs, as the page does."""

import json
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from figure import tell  # noqa: E402

SIZE = "640x360"
SECONDS = 6
AT_MOST = 2.0
REFRESH = 1000 / 60  # ms. A page draws no faster than the display
LOOKS = ("phosphor", "vector-beam", "crt", "shadow-mask", "caffeine")


def program_milliseconds(program, look, milliseconds):
    done = subprocess.run([program, "bench", look, "--size", SIZE, "--frames", "60", "--generic", "--json",
                           "--fps", "%.3f" % (1000 / milliseconds)], capture_output=True, text=True, check=True)
    return json.loads(done.stdout)["frame"]["wall_ms"]


def page_milliseconds(page):
    script = Path(__file__).resolve().parent / "page_frames.mjs"
    done = subprocess.run(["node", script, page, SIZE, str(SECONDS)], capture_output=True, text=True, check=True)
    return float(done.stdout)


def main():
    if not shutil.which("node") or not shutil.which("chromium"):
        print("  skipped: nodejs or chromium is not installed")
        return
    program = Path(sys.argv[1]).resolve()
    os.environ.setdefault("LIBGL_ALWAYS_SOFTWARE", "1")
    with tempfile.TemporaryDirectory(prefix="afterglow-bench-") as folder:
        for look in LOOKS:
            page = Path(folder) / (look + ".html")
            subprocess.run([program, "export", look, "--to", "web", "-o", page], check=True, stdout=subprocess.DEVNULL)
            drawn = page_milliseconds(page)
            own = max(program_milliseconds(program, look, drawn), REFRESH)
            tell("page", "Exported page in Chromium at %s" % SIZE, look, "page / program, " + look, drawn / own,
                 at_most=AT_MOST, detail="%.1f / %.1f ms" % (drawn, own))


main()
