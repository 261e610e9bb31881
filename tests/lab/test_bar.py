"""The virtual test bench: its specimens, and what its report says of them."""

import math
import unittest

import numpy as np
from lab import bar, bodies, fem_solid
from lab.bar import Accuracy, Setting


class Rig(unittest.TestCase):
    def test_a_body_is_as_stiff_as_the_parameter_says(self):
        for kind in ("hanging bar", "compressed block", "sheared block", "hanging cube"):
            run = bar.measure(Setting(kind, cells=3))
            self.assertTrue(run.settled, kind)
            self.assertAlmostEqual(run.volume_ratio, 1, delta=1e-3)
            self.assertAlmostEqual(run.ratio, 1, delta=0.2, msg=kind)

    def test_iterations_and_long_steps_change_no_stiffness(self):
        """Also of a stiff block, which the sweeps of a step would leave soft."""
        block = Setting("compressed block", cells=2, modulus=1e6)
        usual = bar.measure(block)
        for other in (block._replace(iterations=5), block._replace(time_step=0.02)):
            self.assertAlmostEqual(bar.measure(other).modulus / usual.modulus, 1, delta=0.05)

    def test_shorter_steps_buy_accuracy(self):
        runs = bar.measure_accuracy((20,), (0.005, 0.0025))
        self.assertGreater(bar.order_of(runs), 1)
        self.assertLess(runs[-1].error, 0.02)


class Theory(unittest.TestCase):
    """The formulas beside finite elements of a bar whose weight lies all through it."""

    def deflection(self, aside, poisson_ratio):
        """How far the free end moves, over what the formula says."""
        size, weight = np.array([0.1, 0.4, 0.1]), 50.0  # small: the formulas are for small strains
        mesh = fem_solid.solid_box([np.linspace(-s / 2, s / 2, n + 1)
                                    for s, n in zip(size, (2, 8, 2))])
        load = weight * (np.array([1, 0, 0]) if aside else np.array([0, -1, 0]))
        held = np.stack([mesh.nodes[:, 1] == size[1] / 2] * 3, axis=1)
        solid = fem_solid.Solid(mesh, 1e5, poisson_ratio, load, held, np.zeros_like(mesh.nodes))
        way = solid.relaxed() - mesh.nodes
        length, section = size[1], size[0] * size[2]
        theory = (weight * section * length**4 / (8 * 1e5 * size[2] * size[0]**3 / 12) if aside
                  else weight * length**2 / (2 * 1e5))
        return abs(way[mesh.nodes[:, 1] == -size[1] / 2, 0 if aside else 1].mean()) / theory

    def test_agrees_with_finite_elements(self):
        """The clamped top stiffens a little, the more so the less the solid can be compressed."""
        self.assertAlmostEqual(self.deflection(False, 0.0), 1, delta=1e-2)
        self.assertAlmostEqual(self.deflection(False, 0.3), 1, delta=0.03)
        self.assertAlmostEqual(self.deflection(False, 0.45), 1, delta=0.08)
        self.assertAlmostEqual(self.deflection(True, 0.3), 1, delta=0.1)


def run_that(settled=True, volume_ratio=1, kind="bent bar", **other):
    run = bar.Run(Setting(kind, cells=3), 0, 0, 1.25e5, volume_ratio, settled)
    return run._replace(**other)


class Report(unittest.TestCase):
    def test_takes_the_order_from_errors_and_steps_of_the_most_iterations(self):
        runs = [Accuracy(10, 0.01, 0.16), Accuracy(20, 0.01, 0.04), Accuracy(20, 0.005, 0.01)]
        self.assertAlmostEqual(bar.order_of(runs), 2)
        self.assertIn("| 20 | 0.005 | 1 |", bar.accuracy_section(runs))

    def test_specimens_that_still_move_are_a_finding_and_no_failure(self):
        runs = [run_that(), run_that(False, kind="bent slab"), run_that(False, kind="hanging bar")]
        self.assertEqual(bar.failure_of(runs), "")
        self.assertEqual(
            bar.warning_of(runs),
            "bar: 2 specimens were still moving when time was up, so what stands there is not "
            "final: bent slab, E = 1e+05 Pa, 3 cells, steps of 0.005 s, auto iterations; "
            "hanging bar, E = 1e+05 Pa, 3 cells, steps of 0.005 s, auto iterations.")
        summary = bar.summary_of(runs)
        self.assertEqual(len(summary["still_moving"]), 2)
        self.assertEqual(len(summary["tests"]), 3)
        report = bar.report_of(runs)
        self.assertIn("| bent bar | 1e+05 | - | 1.25 | - | - |", report)
        self.assertIn("| bent slab | 1e+05 | - | 1.25 (still moving) | - | - |", report)

    def test_lost_volume_is_a_failure(self):
        runs = [run_that(), run_that(volume_ratio=0.97)]
        self.assertEqual(bar.failure_of(runs),
                         "bar: bent bar, E = 1e+05 Pa, 3 cells, steps of 0.005 s, auto "
                         "iterations: the volume is 97.00 % of what it was.")
        self.assertEqual(bar.warning_of(runs), "")
        self.assertTrue(bar.failure_of([run_that(False, math.nan)]), "it left the range of numbers")

    def test_counts_what_holds_by_iterations_and_spheres_apart(self):
        runs = [run_that(), run_that(modulus=1.3e5), run_that(kind="pressed sphere")]
        self.assertEqual(bar.count_runs(runs), [3, 0, 2])
        counts = bar.count_table(runs)
        self.assertIn("| spheres | 1 | 0 | 1 |", counts)
        self.assertIn("| others, 5 iterations | 0 | 0 | 0 |", counts)
        self.assertIn("| others, auto iterations | 2 | 0 | 1 |", counts)

    def test_the_whole_is_all_combinations(self):
        self.assertEqual(len(bar.settings(True)), 7 * 3 * 4 * 3 * 3)
        self.assertEqual(len(bar.settings()), 7 * 3 * (3 + 2 + 2 + 1))


class Bodies(unittest.TestCase):
    def test_boxes_are_closed_and_as_large_as_they_should_be(self):
        points, triangles = bodies.box([1, 2, 3], [2, 3, 4])
        self.assertAlmostEqual(bodies.volume(points, triangles), 6)
        self.assertAlmostEqual(bodies.areas(points, triangles).sum(), 22)
        sides = {tuple(t[[i, (i + 1) % 3]]) for t in triangles for i in range(3)}
        self.assertEqual(len(sides), 3 * len(triangles))
        self.assertEqual({side[::-1] for side in sides}, sides)

    def test_a_body_is_simulated_as_it_is(self):
        points, triangles = bodies.box([0.1, 0.4, 0.1], [1, 4, 1])
        sim = bodies.simulate(points, triangles)
        np.testing.assert_allclose(sim.mesh.rest_positions, points, atol=1e-15)
        np.testing.assert_array_equal(sim.mesh.triangles, triangles)


if __name__ == "__main__":
    unittest.main()
