"""Rotates a molecule and the camera with the mouse: orbit_test.py PROGRAM [OrbitTest.NAME...]."""

import sys
import unittest
from pathlib import Path

from person import Person

Person.executable = Path(sys.argv[1]).resolve()


class OrbitTest(Person):
    """Each test starts with a converged Caffeine, with more samples than its new limit."""

    size = [160, 120]

    def setUp(self):
        super().setUp()
        self.program.click("look:caffeine")
        self.program.wait("the samples accumulate", lambda s: s["look"] == "caffeine" and s["samples"] > 12)
        self.program.set("converge", "12")
        self.program.wait("the look has converged", lambda s: s["has_converged"] and s["samples"] > 12)

    def drag(self, button, right, up):
        """Drags from the centre of the picture."""
        x, y = self.program.middle("picture")
        self.program.drag((x, y), (x + right, y - up), button)

    def values_after(self, what, is_true):
        return self.program.wait(what, lambda s: is_true(s["values"]))["values"]

    def test_the_left_button_turns_the_molecule_and_the_right_one_moves_the_camera(self):
        program = self.program
        rest = program.state()["values"]
        self.drag(1, 60, 0)
        turned = self.values_after("the molecule rotates", lambda v: v["orbit_turn"] != rest["orbit_turn"])
        self.assertGreater(turned["orbit_turn"][1], rest["orbit_turn"][1])  # about the y axis
        self.assertEqual(turned["orbit_azimuth"], rest["orbit_azimuth"])
        self.drag(3, 40, -24)
        moved = self.values_after("the camera moves", lambda v: v["orbit_azimuth"] != [0] and
                                  v["orbit_elevation"] != [0])
        self.assertLess(moved["orbit_azimuth"][0], 0)  # against the direction of the mouse
        self.assertGreater(moved["orbit_elevation"][0], 0)
        self.assertEqual(moved["orbit_turn"], turned["orbit_turn"])
        self.snapshot("orbit")
        self.screen.do("keydown", "ctrl", "click", 4, "keyup", "ctrl")
        self.values_after("the wheel zooms in", lambda v: 0.5 < v["orbit_distance"][0] < 1)
        program.key("ctrl+z", "ctrl+z", "ctrl+z")
        self.values_after("each movement is one undo step", lambda v: v == rest)

    def test_what_changes_the_scene_begins_anew_and_enough_is_enough(self):
        program = self.program
        held = program.state()["samples"]
        program.set("exposure", "2")
        self.assertEqual(program.state()["samples"], held)
        self.drag(1, 40, 0)
        program.wait("a rotation restarts the samples",
                     lambda s: s["samples"] == 12 and s["has_converged"])
        program.set("converge", "30")
        program.wait("more samples are drawn", lambda s: s["samples"] == 30 and s["has_converged"])
        program.set("converge", "12")
        program.set("bounces", "0")
        program.wait("a parameter restarts the samples", lambda s: s["samples"] == 12 and s["has_converged"])


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]], verbosity=2)
