"""The files of the package: completions, menu entry, icon. package_test.py PROGRAM."""

import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as xml
from pathlib import Path

PROGRAM = Path(sys.argv.pop(1)).resolve()
PACKAGE = Path(__file__).resolve().parents[1] / "app/package"
COMPLETE = """source "$1"; shift
COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _afterglow; printf '%s\\n' "${COMPREPLY[@]}"
"""


class Completions(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.holder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.holder.cleanup)
        cls.folder = Path(cls.holder.name)
        subprocess.run([sys.executable, PACKAGE / "write_completions.py", PROGRAM, cls.folder], check=True)
        cls.bash = cls.folder / "share/bash-completion/completions/afterglow"

    def completed(self, *words):
        path = f"{PROGRAM.parent}:/usr/bin:/bin"
        return subprocess.run(["bash", "-c", COMPLETE, "bash", self.bash, "afterglow", *words], env={"PATH": path},
                              check=True, capture_output=True, text=True).stdout.split()

    def test_bash_completes_commands_options_and_names(self):
        self.assertEqual(self.completed("ren"), ["render"])
        self.assertEqual(self.completed("render", "phosphor", "--pre"), ["--preset"])
        self.assertIn("phosphor", self.completed("render", "pho"))
        self.assertIn("amber-p3", self.completed("render", "phosphor", "--preset", "amb"))
        self.assertEqual(self.completed("export", "crt", "--to", ""),
                         ["portable", "web", "slang", "isf", "shadertoy", "mpv", "reshade"])

    def test_every_command_and_option_is_in_each_file(self):
        commands = re.findall(r"^  (\w+) +\w", subprocess.run([PROGRAM, "--help"], capture_output=True, text=True)
                              .stdout.partition("\nCommands:\n")[2].partition("\n\n")[0], re.MULTILINE)
        self.assertGreater(len(commands), 15)
        for file in self.folder.rglob("*"):
            if file.is_file():
                text = file.read_text()
                for word in (*commands, "preset", "frames", "no-pages"):
                    self.assertRegex(text, rf"\b{word}\b", file)

    @unittest.skipUnless(shutil.which("zsh"), "zsh is not installed")
    def test_zsh_reads_its_file(self):
        subprocess.run(["zsh", "-n", self.folder / "share/zsh/vendor-completions/_afterglow"], check=True)


class Files(unittest.TestCase):
    def test_the_menu_entry_names_the_icon_and_the_file_types(self):
        entry = dict(line.split("=", 1) for line in (PACKAGE / "afterglow.desktop").read_text().splitlines()[1:])
        self.assertTrue((PACKAGE / f"{entry['Icon']}.svg").is_file())
        space = {"m": "http://www.freedesktop.org/standards/shared-mime-info"}
        types = {kind.get("type") for kind in xml.parse(PACKAGE / "afterglow.xml").findall("m:mime-type", space)}
        self.assertEqual(set(entry["MimeType"].strip(";").split(";")), types)
        thumbnailer = (PACKAGE / "afterglow.thumbnailer").read_text()
        for kind in types:
            self.assertIn(kind, thumbnailer)

    def test_the_metadata_names_the_same_types_and_the_licence(self):
        component = xml.parse(PACKAGE / "org.afterglow.Afterglow.metainfo.xml").getroot()
        self.assertEqual(component.findtext("project_license"), "MIT")
        self.assertEqual(len(component.findall("provides/mediatype")), 3)


if __name__ == "__main__":
    unittest.main()
