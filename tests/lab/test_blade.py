"""The force on a blade that goes down into a block."""

import unittest

from lab import blade
from lab.blade import Point


class Blade(unittest.TestCase):
    def test_feels_nothing_above_the_block_and_breaks_into_it(self):
        run = blade.measure("soft", {
            "gravity": [0, 0, 0], "floor": None, "time_step": 0.02, "iterations": 2,
            "air_drag": 2, "damping": 0, "youngs_modulus": 1e4, "toughness": 5, "blade_feels": 1})
        self.assertLess(run.points[0].depth, 0)
        for point in run.points:
            if point.depth < 0:
                self.assertEqual((point.force, point.fracture), (0, 0), point.depth)
        self.assertGreater(run.rupture.force, 0)
        self.assertGreater(run.rupture.depth, 0)
        self.assertGreater(run.points[-1].fracture, 0)
        self.assertGreater(run.points[-1].work, 0)

    def test_the_plateau_begins_behind_where_it_breaks_in(self):
        points = [Point(0.001 * i, force, i, 0.5 * i, fracture, 0.25 * i) for i, (force, fracture)
                  in enumerate([(0, 0), (9, 0), (7, 1), (99, 2), *[(3, 3)] * 9])]
        run = blade.Run("", {"toughness": 50}, points)
        self.assertEqual(run.rupture, points[1])
        self.assertAlmostEqual(run.plateau, 3)
        self.assertAlmostEqual(run.expected, 3)
        self.assertAlmostEqual(run.found, (0.5 * 12 + 3 + 0.25 * 12) / 12)


if __name__ == "__main__":
    unittest.main()
