"""Kerf beside finite elements: what is measured, the report, and one case that is run."""

import json
import math
import unittest

import matplotlib.pyplot as plt
import numpy as np
from lab import bodies, fem, fem_cases
from lab.fem import Figures, KerfRun, Result, Surface
from lab_case import LabCase

import kerf


def box_at(size, moved):
    points, triangles = bodies.box(size, [2, 2, 2])
    return Surface(points, points + moved, triangles, np.zeros(len(triangles), bool))


def case_of(**keys):
    return fem_cases.Case("", "", "", None, [], 0, None, None, **keys)


def opening(*pairs):
    """Of pairs of points at a height and a depth, so far from each other."""
    rest = np.array([(0, y, z) for y, z, _ in pairs for _ in (0, 1)], float)
    moved = np.array([(side * gap, y, z) for y, z, gap in pairs for side in (0, 1)], float)
    return fem.opening_of(Surface(rest, moved, np.zeros((0, 3), int), np.zeros(0, bool)))


class Measures(unittest.TestCase):
    def test_sag_is_what_a_part_comes_down_by_in_the_mean(self):
        surface = box_at([1, 1, 1], 0)
        surface.positions[:, 1] -= surface.rest[:, 0] + surface.rest[:, 2]
        figures = fem.figures_of(case_of(end=0.5), surface)
        self.assertAlmostEqual(figures.sag, 0.5)
        self.assertIsNone(figures.opening)
        self.assertAlmostEqual(figures.volume_ratio, 1)
        self.assertAlmostEqual(fem.figures_of(case_of(hangs=True), surface).sag, 1)

    def test_shapes_that_are_aside_differ_by_how_far_they_are(self):
        here = box_at([1, 1, 1], 0)
        self.assertLess(fem.shape_deviation(here, here)[0], 1e-12)
        largest, mean = fem.shape_deviation(here, box_at([1, 1, 1], [0.1, 0, 0]))
        self.assertAlmostEqual(largest, 0.1)
        self.assertTrue(0 < mean < 0.1)
        self.assertAlmostEqual(fem.shape_deviation(here, box_at([1.4, 1, 1], 0))[0], 0.2)

    def test_the_nearest_triangle_is_found_among_small_ones_beside_a_large_one(self):
        near = bodies.box([1, 1, 1], [9, 9, 9])
        large, count = np.array([[-9, 0.6, -9], [9, 0.6, -9], [0, 0.6, 18]]), len(near[0])
        surface = Surface(None, np.vstack([near[0], large]),
                          np.vstack([near[1], [[count, count + 1, count + 2]]]), None)
        self.assertAlmostEqual(fem.distances(np.array([[0, 0.58, 0]]), surface)[0], 0.02)

    def test_an_opening_is_measured_in_the_middle_of_the_upper_side(self):
        self.assertAlmostEqual(opening((1, -1, 0.1), (1, 3, 0.5), (0.5, 0, 9)), 0.2)
        self.assertEqual(fem.opening_of(box_at([1, 1, 1], 0)), 0, "not cut")


def result_of(sag, gap, largest, volume_ratio=1.02):
    run = KerfRun(None, True, 100, "a" * 16)
    return Result("bar-50", "notched bar", "50 % of its height", run,
                  Figures(sag, gap, volume_ratio), Figures(0.010, 0.002, 1),
                  Figures(0.0098, 0.0019, 1), largest, largest / 4, 0.4)


class Report(unittest.TestCase):
    def test_marks_what_is_beyond_a_bar(self):
        within, beyond = result_of(0.0114, 0.0018, 0.019), result_of(0.0116, 0.0018, 0.021)
        self.assertTrue(within.holds())
        self.assertFalse(result_of(0.0116, 0.0018, 0.019).holds(), "sag")
        self.assertFalse(result_of(0.0114, 0.0016, 0.019).holds(), "opening")
        self.assertFalse(result_of(0.0114, 0.0018, 0.021).holds(), "shape")
        self.assertFalse(result_of(math.nan, 0.0018, 0.019).holds())
        self.assertFalse(result_of(0.0114, 0.0018, 0.019, 1.2).holds(), "volume")
        report = fem.report_of([within, beyond])
        self.assertIn("| 11.40 | 10.00 | +14.0 | 1.80 | 2.00 | -10.0 | 102.00 | 100.00 | +2.0 "
                      "| 4.75 | 1.19 | yes |", report)
        self.assertIn("| 11.60 | 10.00 | +16.0 ! |", report)
        self.assertIn("| 5.25 ! | 1.31 | no |", report)
        self.assertIn("| 1 of 2 | 2 of 2 | 2 of 2 | 1 of 2 | 1 of 2 |", report)
        self.assertIn("| notched bar | 50 % of its height | -2.0 | -5.0 |", report,
                      "larger elements")
        json.dumps(fem.summary_of([within, beyond]))


class Cases(LabCase):
    def test_are_the_same_bodies_for_both(self):
        for case in fem_cases.all_cases():
            points, triangles = case.model
            solid = case.solid(1)
            outside = (abs(solid.mesh.nodes) - points.max(axis=0)).max()
            self.assertLess(outside, 1e-12, case.name)
            share = 0.5 if case.name == "ball-half" else 1
            self.assertAlmostEqual(bodies.volume(solid.mesh.nodes, solid.mesh.skin()),
                                   share * bodies.volume(points, triangles), places=12)
            twice = len(np.unique(solid.mesh.nodes, axis=0)) < len(solid.mesh.nodes)
            self.assertEqual(case.opens, twice, case.name)
            self.assertGreater(solid.held.all(axis=1).sum(), 20, case.name)

    def test_a_bar_is_cut_and_compared_at_rest(self):
        """With the larger elements, to be quick."""
        result = fem.run_case(fem_cases.bar(50), self.folder, 1)
        self.assertTrue(result.run.settled)
        # Finite elements of a bar that is whole sag by 15 mm.
        self.assertGreater(result.elements.sag, 0.015)
        self.assertGreater(result.elements.opening, 0.001)
        self.assertTrue(0.5 < result.kerf.sag / result.elements.sag < 2, "softer at a notch")
        self.assertGreater(result.kerf.opening, 0.001)
        self.assertAlmostEqual(result.kerf.volume_ratio, 1, delta=1e-3)
        self.assertGreater(result.largest, result.mean)
        self.assertLess(result.shape_share, 0.1)
        self.assertGreater(plt.imread(self.folder / "bar-50.png").shape[1], 3 * 600)

        # The session is an ordinary one: a replay comes to the same bits.
        summary = kerf.replay(self.folder / "bar-50.kerf.json")
        self.assertEqual(summary["state_hash"], result.run.state_hash)


if __name__ == "__main__":
    unittest.main()
