"""Matching the look to a photo."""

import subprocess

from person import Person

SIZE = ("--size", "240x180")
PHOTO = ("--set", "mask_type=Aperture grille", "--set", "mask_strength=0.7", "--set", "sampling=Continuous",
         "--set", "exposure=0.25", "--set", "vignette_depth=0", "--set", "red_offset=0,0", "--set", "green_offset=0,0",
         "--set", "blue_offset=0,0")


class Matching(Person):
    def draw(self, file, *arguments):
        """Renders a picture that contains no preset."""
        drawn = file.with_suffix(".png")
        subprocess.run([self.executable, "render", *map(str, arguments), "-o", drawn], check=True)
        subprocess.run(["ffmpeg", "-v", "error", "-y", "-i", drawn, "-q:v", "1", file], check=True)

    def open_dialog(self, widget):
        """Opens the dialog, and waits until it shows the widget."""
        self.program.key("ctrl+p")
        self.program.place("palette_query")
        self.program.type("Match a photo")
        self.program.wait("the palette finds it", lambda s: "palette:Match a photo…" in s["widgets"])
        self.program.key("Return")
        self.program.place(widget)

    def test_a_photo_is_matched_and_the_values_are_one_undo_step(self):
        program = self.program
        bars, photo = self.looks.parent / "bars.jpg", self.looks.parent / "set.jpg"
        self.draw(bars, "crt", "--set", "crt=off", "--source", "pattern:harbour", *SIZE)
        self.draw(photo, "shadow-mask", *PHOTO, "--source", bars, *SIZE)
        program.click("look:shadow-mask")
        program.wait("the look is open", lambda s: s["look"] == "shadow-mask")
        self.drop(bars)
        program.wait("the source is open", lambda s: str(bars) in s["driving_source"] and not s["reading"])
        program.set("exposure", "0.25")
        self.open_dialog("match_choose_photo")
        self.drop(photo)
        left, top, right, bottom = program.place("match_photo")
        self.snapshot("match_corners")
        program.drag((left + 2, top + 2), (left + 30, top + 20))
        self.snapshot("match_dragged")
        program.drag((left + 30, top + 20), (left + 1, top + 1))
        program.key("Left", "Up")
        program.click("dialog_ok")
        program.place("match_pictures")
        self.snapshot("match_running")
        program.click("match_stop")
        program.place("match:mask_size")
        self.snapshot("match_stopped")
        program.click("match_save")
        program.wait("a preset is saved", lambda s: s["dialog"] == 0 and s["preset"] == "set matched")
        saved = sorted(file.name for file in (self.own / "presets/shadow-mask").iterdir())
        self.assertEqual(saved, ["set matched.camera.json", "set matched.json", "set matched.photo.jpg"])
        program.key("ctrl+z")
        self.open_dialog("match_save")  # with the result
        program.click("dialog_ok")
        program.wait("the values are applied", lambda s: s["dialog"] == 0 and s["undo"] == "Match a photo")
        self.snapshot("match_applied")
        program.key("ctrl+z")
        program.wait("one step undoes them", lambda s: s["redo"] == "Match a photo" and s["undo"] == "Exposure")

    def test_a_dot_gives_the_beam_of_an_oscilloscope(self):
        program = self.program
        photo = self.looks.parent / "dot.jpg"
        light = "0.001+0.6*exp(-(pow(X-60,2)+pow(Y-100,2))/12)"
        subprocess.run(["ffmpeg", "-v", "error", "-y", "-f", "lavfi", "-i",
                        f"color=black:s=120x200,format=gbrp,geq=r='0':g='255*pow({light},1/2.2)':b='0'", "-frames:v", "1",
                        "-q:v", "1", "-pix_fmt", "yuvj444p", photo], check=True)
        program.click("look:vector-beam")
        program.wait("the look is open", lambda s: s["look"] == "vector-beam")
        self.open_dialog("match_choose_photo")
        self.assertNotIn("match_choose_source", program.state()["widgets"])
        self.drop(photo)
        program.place("match_photo")
        program.click("dialog_ok")
        program.wait("the match is complete", lambda s: "match_save" in s["widgets"])
        program.place("match:spot_sigma")
        self.snapshot("match_beam")
        program.click("dialog_ok")
        program.wait("the values are applied", lambda s: s["dialog"] == 0 and s["undo"] == "Match a photo")
