"""Runs every command of the README and the tutorials as written."""

import re
import shlex
import shutil

from program import SLANG, SOURCE, ProgramTest, main, run

FENCED = re.compile(r"^```sh\n(.*?)^```", re.DOTALL | re.MULTILINE)
NOT_RUN = {(), ("build",), ("test",), ("package",)}  # open the window, build, and run these tests


def commands_of(page):
    """The arguments of each command of the program in the code blocks of a page, in order."""
    commands = []
    for block in FENCED.findall(page.read_text(encoding="utf-8")):
        for line in block.replace("\\\n", " ").splitlines():
            words = shlex.split(line, comments=True)
            if words and words[0] in ("./run", "afterglow") and tuple(words[1:]) not in NOT_RUN:
                commands.append(words[1:])
    return commands


class Pages(ProgramTest):
    def make_inputs(self, folder):
        """The user's files that the README names."""
        self.write(folder / "a.slang", SLANG)
        for name in ("my-shader", "crt-royale"):
            self.write(folder / f"{name}.slangp", "shaders = 1\nshader0 = a.slang\n")
        if shutil.which("ffmpeg"):
            self.assert_done(run("render", "crt", "--size", "64x36", "--frames", "3", "-o", folder / "game.mp4"))

    def run_page(self, page):
        """Runs the commands in a separate folder with the looks and presets of the repository."""
        folder = self.folder / page.stem
        folder.mkdir()
        for name in ("shaders", "presets"):
            (folder / name).symlink_to(SOURCE / name)
        self.make_inputs(folder)
        commands = commands_of(page)
        self.assertTrue(commands)
        for command in commands:
            if "game.mp4" in command and not shutil.which("ffmpeg"):
                continue
            with self.subTest(page=page.name, command=shlex.join(command)):
                self.assert_done(run(*command, cwd=folder, XDG_DATA_HOME=str(self.folder / "own")))

    def test_the_commands_of_the_readme(self):
        self.run_page(SOURCE / "README.md")

    def test_the_commands_of_the_tutorials(self):
        pages = sorted(SOURCE.glob("docs/tutorials/*.md"))
        self.assertEqual(len(pages), 5)
        for page in pages:
            self.run_page(page)


if __name__ == "__main__":
    main()
