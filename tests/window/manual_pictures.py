"""Updates the pictures of docs/manual.md: manual_pictures.py PROGRAM. It runs tests of the window
with a larger picture, which takes some minutes with software GL."""

import shutil
import sys
import tempfile
import unittest
from pathlib import Path

import person
import program

SIZE = [640, 480]
# The test that makes each picture.
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


def main():
    person.PICTURE[:] = SIZE  # before the tests are imported
    program.TIMEOUT_SECONDS = 120
    from window_test import WindowTest

    class Manual(WindowTest):
        """Adds a test that takes too long for the normal test run."""

        def test_all_presets_have_a_picture(self):
            self.program.key("space", "ctrl+l")
            self.program.wait("all preset pictures are drawn", lambda s: s["presets"]["listed"] and
                              s["presets"]["pictures"] == len(s["presets"]["listed"]))
            self.snapshot("presets")
            self.program.key("ctrl+l")

    with tempfile.TemporaryDirectory() as folder:
        person.PICTURES = Path(folder)
        told = unittest.TextTestRunner(verbosity=2).run(
            unittest.TestSuite(Manual(name) for name in sorted(set(STORIES.values()))))
        if not told.wasSuccessful():
            sys.exit(1)
        for name in STORIES:
            shutil.copy(Path(folder, name + ".png"), person.SOURCE / "docs/manual")


if __name__ == "__main__":
    main()
