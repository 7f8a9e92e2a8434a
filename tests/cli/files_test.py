"""Files as people have them: what tests/inputs holds opens, with its values, or says what it is."""

from program import SOURCE, ProgramTest, main, read_png, run

INPUTS = SOURCE / "tests" / "inputs"
TINT = "float tint() { return 0.5; }\n"


class Files(ProgramTest):
    def picture(self, look, *arguments, size="8x8", frames="1"):
        """The rows of its picture, and what was printed on stderr."""
        out = self.folder / "out.png"
        done = run("render", look, "--size", size, "--frames", frames, "-o", out, *arguments)
        self.assert_done(done)
        return read_png(out)[2], done.stderr

    def color(self, look, *arguments):
        """Red, green and blue in the middle."""
        rows, _ = self.picture(look, *arguments)
        return list(rows[4][12:15])


class Includes(Files):
    def test_an_include_goes_up_within_the_opened_tree(self):
        self.assertEqual(self.color(INPUTS / "bare/sub/up.frag"), [128, 128, 128])

    def test_a_refused_include_names_the_boundary_and_the_option(self):
        self.write("lib/tint.glsl", TINT)
        self.write("look/look.json",
                   '{"format": "afterglow-look", "version": 1, "name": "T", "driven_by": "nothing",'
                   ' "passes": [{"name": "a", "fragment": "a.frag"}]}')
        self.write("look/a.frag", '#version 410 core\n#include "../lib/tint.glsl"\nout vec4 color;\n'
                                  "void main() { color = vec4(tint()); }\n")
        look = self.folder / "look"
        self.assert_refused(run("check", look), "a.frag:2: error", f"'{look}'", "--include DIR")
        self.assert_done(run("check", look, "--include", self.folder / "lib"))
        self.assertEqual(self.color(look, "--include", self.folder / "lib"), [128, 128, 128])
        self.assert_refused(run("check", look, "--include", self.folder / "none"), "is not a folder")

    def test_a_linked_file_and_a_linked_folder_open(self):
        self.write("store/main.frag", '#include "lygia/tint.glsl"\n'
                                      "void main() { gl_FragColor = vec4(tint()); }\n")
        self.write("store/lygia/tint.glsl", TINT)
        (self.folder / "in/sub").mkdir(parents=True)
        (self.folder / "in/sub/main.frag").symlink_to(self.folder / "store/main.frag")
        (self.folder / "in/sub/lygia").symlink_to(self.folder / "store/lygia")
        self.assertEqual(self.color(self.folder / "in/sub/main.frag"), [128, 128, 128])


class Drawings(Files):
    def test_drawings_and_models_are_opened_by_their_signal(self):
        for signal in ("drawing:svg/z.svgz", "drawing:svg/use.svg", "scene:obj/cont.obj",
                       "scene:obj/scene_cont.json", "scene:obj/scene_cr_only.json",
                       "scene:obj/scene_degenerate.json"):
            kind, name = signal.split(":")
            rows, errors = self.picture("phosphor", "--signal", f"{kind}:{INPUTS / name}", size="64x64")
            self.assertEqual(errors, "", signal)
            self.assertGreater(max(map(max, rows)), 100, signal)

    def test_a_file_of_another_kind_says_what_it_is(self):
        for signal, words in (("drawing:wav/zerosize.wav", "audio:FILE"),
                              ("drawing:obj/cont.obj", "scene:FILE"),
                              ("scene:svg/use.svg", "drawing:FILE"),
                              ("audio:svg/use.svg", "drawing:FILE"),
                              ("drawing:toy/vscode.glsl", "an SVG, a scene (.json) or a model (.obj)")):
            kind, name = signal.split(":")
            self.assert_refused(run("render", "phosphor", "--signal", f"{kind}:{INPUTS / name}",
                                    "-o", self.folder / "x.png"), words)


if __name__ == "__main__":
    main()
