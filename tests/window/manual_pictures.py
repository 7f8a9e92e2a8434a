"""Updates the pictures of docs/manual.md and README.md: manual_pictures.py PROGRAM [readme]. It runs tests of the
window with a larger picture, which takes some minutes with software GL."""

import shutil
import sys
import tempfile
import unittest
from pathlib import Path

import person
import program

SIZE = [640, 480]
README_WINDOW = (1440, 900)
README_SIZE = (800, 600)
# The test that makes each picture. The first one draws the pictures of presets, which the others show in the list.
STORIES = {
    "presets": "test_all_presets_have_a_picture",
    "waveform": "test_a_frame_ago_is_looked_into_texel_by_texel_and_along_a_line",
    "step": "test_while_a_key_is_held_over_a_slider_the_picture_shows_what_a_step_changes",
    "filmstrip": "test_a_filmstrip_and_a_contact_sheet_are_clicked_to_take_a_value",
    "difference": "test_values_in_a_slot_are_compared_with_and_taken_back",
    "levels": "test_the_numbers_of_a_pass_are_measured_marked_and_saved",
    "switched": "test_a_pass_is_switched_to_see_what_it_does",
    "impulse": "test_a_flash_is_seen_to_fall_in_every_pass",
}


def readme_story(base):
    """A test that draws the picture of README.md: a new user has opened a preset of Phosphor."""

    class Readme(base):
        def test_the_window_has_a_preset_of_phosphor(self):
            self.program.quit()
            shutil.copy(person.SOURCE / "shaders/phosphor/look.json", self.looks / "phosphor")  # all points of its figure
            self.program.start()
            self.program.key("ctrl+l")
            self.program.wait("all preset pictures are drawn", has_all_pictures)
            self.program.key("ctrl+l")
            self.program.click("preset:green-p31")
            self.program.wait("the preset is open", lambda s: s["preset"] == "Green P31 bench scope")
            self.restart_with_size(*README_SIZE)
            self.program.click("pass:composite")
            self.screen.do("mousemove", *README_WINDOW)
            self.program.wait("the figure has the phase to show", lambda s: s["time"] > 5.5)
            self.program.key("space")
            self.program.place("picture")  # waits until the key is processed
            self.snapshot("window")

    return Readme("test_the_window_has_a_preset_of_phosphor")


def has_all_pictures(state):
    return state["presets"]["listed"] and state["presets"]["pictures"] == len(state["presets"]["listed"])


def run(tests, copies):
    """Runs the tests, then copies their pictures: name -> folder of the project."""
    with tempfile.TemporaryDirectory() as folder:
        person.PICTURES = Path(folder)
        if not unittest.TextTestRunner(verbosity=2).run(unittest.TestSuite(tests)).wasSuccessful():
            sys.exit(1)
        for name, target in copies.items():
            shutil.copy(Path(folder, name + ".png"), person.SOURCE / target)


def redraw_readme():
    person.WINDOW = README_WINDOW
    from window_test import Person
    run([readme_story(Person)], {"window": "docs"})


def main():
    program.TIMEOUT_SECONDS = 120
    if sys.argv[2:] == ["readme"]:
        redraw_readme()
        return
    person.PICTURE[:] = SIZE  # before the tests are imported
    from window_test import WindowTest

    class Manual(WindowTest):
        """Adds a test that takes too long for the normal test run."""

        def test_all_presets_have_a_picture(self):
            self.program.key("space", "ctrl+l")
            self.program.wait("all preset pictures are drawn", has_all_pictures)
            self.snapshot("presets")
            self.program.key("ctrl+l")

    run([Manual(name) for name in STORIES.values()], {name: "docs/manual" for name in STORIES})


if __name__ == "__main__":
    main()
