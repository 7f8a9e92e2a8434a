"""The output of --help. Its examples are run."""

import shlex
import shutil
import subprocess

from program import SLANG, SOURCE, ProgramTest, main, run


class Help(ProgramTest):
    DRAWS = ("render", "bench", "sheet", "sweep", "impulse", "golden")

    def commands(self):
        listed = run("--help").stdout.partition("\nCommands:\n")[2].partition("\n\n")[0]
        return [line.split()[0] for line in listed.splitlines() if line[2:3].strip()]

    def examples(self, *command):
        """The examples at the end of a help."""
        return [line.strip() for line in run(*command, "--help").stdout.partition("\nExamples:\n")[2].splitlines()]

    def test_each_help_fits_80_columns_and_ends_with_its_own_examples(self):
        commands = self.commands()
        self.assertEqual(len(commands), 19, commands)
        for command in ((), *((name,) for name in commands)):
            with self.subTest(command):
                done = run(*command, "--help")
                self.assert_done(done)
                self.assertLessEqual(max(map(len, done.stdout.splitlines())), 80)
                examples = self.examples(*command)
                self.assertTrue(2 <= len(examples) <= 4, examples)
                for example in examples:
                    self.assertEqual(example.split()[:1 + len(command)], ["afterglow", *command])

    def make_inputs(self):
        """Makes the files that the examples use."""
        self.assert_done(run("render", "crt", "--size", "64x36", "-o", self.folder / "picture.png"))
        for name in ("before.png", "after.png", "screenshot.png"):
            shutil.copy(self.folder / "picture.png", self.folder / name)
        self.assert_done(run("render", "crt", "--size", "64x36", "-o", self.folder / "before.exr"))
        bars = self.folder / "bars.png"
        self.assert_done(run("render", "crt", "--set", "crt=off", "--source", "pattern:harbour", "--size", "160x120", "-o", bars))
        photo = {"mask_type": "Aperture grille", "mask_strength": "0.7", "sampling": "Continuous", "exposure": "0.25",
                 "vignette_depth": "0", "red_offset": "0,0", "green_offset": "0,0",
                 "blue_offset": "0,0"}
        sets = [word for name, value in photo.items() for word in ("--set", f"{name}={value}")]
        self.assert_done(run("render", "shadow-mask", *sets, "--source", bars, "--size", "160x120", "-o", self.folder / "set.png"))
        if shutil.which("ffmpeg"):  # a light that goes off after 6 frames
            light = "if(lt(N,6),8,220*exp(-(N-6)/8.4))"
            subprocess.run(["ffmpeg", "-v", "error", "-f", "lavfi", "-i",
                            f"color=black:s=48x48:r=240:d=0.4,format=gbrp,geq=r='{light}/3':g='{light}':b='{light}/2'",
                            "-c:v", "libx264rgb", "-qp", "0", self.folder / "fade.mp4"], check=True)
        shutil.copy(self.folder / "before.exr", self.folder / "after.exr")
        self.assert_done(run("signal", "text:HI", "--seconds", "0.1", "-o", self.folder / "song.flac"))
        self.write("show.txt", "0 blackout on\n0.05 blackout off\n")
        for name in ("mine.json", "yours.json"):
            self.assert_done(run("preset", "crt", "-o", self.folder / name))
        shutil.copytree(SOURCE / "shaders/crt", self.folder / "my-look")
        self.write("logo.svg", "<svg xmlns='http://www.w3.org/2000/svg' width='9' height='9'><path d='M0 0L9 9'/></svg>")
        self.write("crt-geom.slangp", "shaders = 1\nshader0 = slang-shaders/crt/a.slang\n")
        self.write("slang-shaders/crt/a.slang", SLANG)
        self.write("slang-shaders/crt/a.slangp", "shaders = 1\nshader0 = a.slang\n")
        shutil.copytree(SOURCE / "shaders/crt", self.folder / "my-looks/glow")
        self.assert_done(run("preset", "crt", "-o", self.folder / "my-looks/warm.json"))
        self.write("my-looks/warm.json", (self.folder / "my-looks/warm.json").read_text().replace('"crt"', '"glow"'))
        self.write("shadertoy/a.glsl", "void mainImage(out vec4 c, in vec2 p) { c = vec4(iTime); }")

    def test_the_examples_work(self):
        self.make_inputs()
        for command in self.commands():
            for example in self.examples(command):
                words = shlex.split(example.partition(" > ")[0])[1:]
                if any(word.endswith(".mp4") for word in words) and not shutil.which("ffmpeg"):
                    continue
                if command in self.DRAWS and "--size" not in words:
                    words += ["--size", "64x36"]  # the same, but faster
                if command in ("sheet", "sweep"):
                    words += ["--fps", "240"]  # fewer samples per frame
                with self.subTest(example):
                    self.assert_done(run(*words, cwd=self.folder))

    def test_wrong_usage_says_what_to_do(self):
        for arguments, words in ((("render", "crt", "-o", "x.png", "--sett", "a=1"), "unknown option '--sett' (did you mean '--set'?)"),
                                 (("render", "crt", "-o", "x.png", "--size"), "--size needs a value\n"),
                                 (("render", "crt", "-o", "x.png", "--fps", "1", "--fps", "2"), "--fps can be given only once\n"),
                                 (("render", "crt", "-o", "x.png", "--frames", "x"),
                                  "--frames: expected a whole number from 1 to 10000000, got 'x'\n"),
                                 (("render", "crt", "-o", "x.png", "--frames", "1", "--seconds", "1"), "can't be used together\n"),
                                 (("render", "crt", "more", "-o", "x.png"), "unexpected argument 'more'\n"),
                                 (("render", "crt", "-o", "x.png", "--set", "1"), "--set: expected NAME=VALUE, got '1'\n"),
                                 (("list", "sounds"), "unknown word 'sounds'; use looks, presets, signals or patterns\n"),
                                 (("preset", "crt", "--name", ""), "--name: the value is empty\n"),
                                 (("check",), "LOOK is required\n")):
            with self.subTest(arguments):
                self.assert_refused(run(*arguments, cwd=self.folder), words,
                                    f"\nRun 'afterglow {arguments[0]} --help' for help.\n", code=2)


if __name__ == "__main__":
    main()
