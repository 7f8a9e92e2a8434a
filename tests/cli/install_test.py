"""The files that `cmake --install` installs work at their new location: install_test.py PROGRAM."""

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROGRAM = Path(sys.argv.pop(1)).resolve()


class InstallTest(unittest.TestCase):
    def test_the_installed_program_finds_its_looks_and_draws_one(self):
        with tempfile.TemporaryDirectory() as folder:
            prefix = Path(folder) / "prefix"
            subprocess.run(["cmake", "--install", PROGRAM.parent.parent, "--prefix", prefix],
                           check=True, stdout=subprocess.DEVNULL)
            installed = prefix / "bin/afterglow"
            environment = {name: value for name, value in os.environ.items()
                           if name != "AFTERGLOW_DATA"}

            def run(*arguments):
                return subprocess.run([installed, *arguments], cwd=folder, env=environment,
                                      check=True, capture_output=True, text=True)

            self.assertIn("phosphor", run("list", "looks").stdout)
            listed = run("list", "presets").stdout
            self.assertIn("amber-p3", listed)
            picture = Path(folder) / "trace.png"
            run("render", "phosphor", "--preset", "amber-p3", "--size", "64x48", "--frames", "1",
                "-o", picture)
            self.assertEqual(picture.read_bytes()[:8], b"\x89PNG\r\n\x1a\n")
            # reading needs the module of the picture formats, which is installed too
            self.assertIn("max    0", run("compare", picture, picture).stdout)
            next(prefix.glob("lib*/**/afterglow-pictures.so")).unlink()
            with self.assertRaises(subprocess.CalledProcessError) as refused:
                run("compare", picture, picture)
            self.assertRegex(refused.exception.stderr, "trace.png: error: .*Rebuild or reinstall")


if __name__ == "__main__":
    unittest.main()
