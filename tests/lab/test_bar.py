"""The virtual test bench: its specimens, and what its report says of them."""

import math
import unittest

import numpy as np
from lab import bar, bodies, fem_solid
from lab.bar import Accuracy, Setting


class Rig(unittest.TestCase):
    def test_a_bars_modulus_is_of_the_parameters_size(self):
        run = bar.measure(Setting(cells=3, true_modulus=False))
        self.assertTrue(run.settled)
        self.assertAlmostEqual(run.volume_ratio, 1, delta=1e-3)
        self.assertAlmostEqual(run.ratio, 1.5, delta=0.3, msg="docs/physics.md")

    def test_with_a_true_modulus_a_body_is_as_stiff_as_the_parameter_says(self):
        for kind in ("hanging bar", "compressed block", "sheared block", "hanging cube"):
            run = bar.measure(Setting(kind, cells=3))
            self.assertTrue(run.settled, kind)
            self.assertFalse(run.too_few, kind)
            self.assertAlmostEqual(run.volume_ratio, 1, delta=1e-3)
            self.assertAlmostEqual(run.ratio, 1, delta=0.2, msg=kind)

    def test_with_a_true_modulus_iterations_buy_no_stiffness(self):
        """Sweeps add no compliance, as far as the program does not say that they do."""
        block = Setting("compressed block", cells=2)
        many, few = bar.measure(block), bar.measure(block._replace(iterations=5))
        self.assertFalse(few.too_few)
        self.assertAlmostEqual(few.modulus / many.modulus, 1, delta=0.03)
        too_few = bar.measure(block._replace(iterations=5, modulus=1e7))
        self.assertTrue(too_few.too_few)
        self.assertLess(too_few.ratio, 0.75)

    def test_with_a_true_modulus_iterations_buy_accuracy(self):
        runs = bar.measure_accuracy((10, 20, 40), (0.005,))
        self.assertGreater(bar.order_of(runs), 0.8)
        self.assertLess(runs[-1].error, 0.02)

    def test_a_bent_bar_is_true_to_the_parameter_and_a_wide_slab_softer(self):
        """Rays along the normal let the faces of a slab slide over each other."""
        straight, slab = (bar.measure(Setting(kind, true_modulus=False))
                          for kind in ("bent bar", "bent slab"))
        self.assertTrue(straight.settled and slab.settled)
        self.assertAlmostEqual(straight.ratio, 1.2, delta=0.3, msg="docs/physics.md")
        self.assertAlmostEqual(slab.ratio, 0.6, delta=0.2, msg="docs/physics.md")

    def test_a_bar_that_is_much_softer_than_its_parameter_comes_to_rest_all_the_same(self):
        """The drag is critical for the parameter's modulus; what is softer by far creeps."""
        run = bar.measure(Setting("bent bar", modulus=1e6, iterations=5, true_modulus=False))
        self.assertTrue(run.settled)
        self.assertAlmostEqual(run.ratio, 0.09, delta=0.03, msg="docs/physics.md")

    def test_too_few_iterations_make_a_stiff_block_soft(self):
        block = Setting("compressed block", cells=2, modulus=1e6, true_modulus=False)
        few, many = (bar.measure(block._replace(iterations=n)) for n in (5, 40))
        self.assertGreater(many.modulus, 2 * few.modulus, "Jacobi needs small substeps")
        self.assertLess(few.ratio, 0.7)
        self.assertGreater(many.ratio, 1)
        self.assertTrue(few.too_few)
        self.assertFalse(many.too_few)

    def test_a_thin_bar_in_long_steps_is_soft_and_the_program_says_so(self):
        run = bar.measure(Setting(cells=2, iterations=5, time_step=0.01))
        self.assertTrue(run.settled)
        self.assertLess(run.ratio, 0.9)
        self.assertTrue(run.too_few)


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
    run = bar.Run(Setting(kind, cells=3), 0, 0, 1.25e5, volume_ratio, settled, False)
    return run._replace(**other)


class Report(unittest.TestCase):
    def test_takes_the_order_from_errors_and_substeps(self):
        runs = [Accuracy(10, 0.01, 0.16), Accuracy(20, 0.01, 0.04), Accuracy(20, 0.005, 0.01)]
        self.assertAlmostEqual(bar.order_of(runs), 2)
        self.assertIn("| 20 | 0.005 | 0.25 | 1 |", bar.accuracy_section(runs))

    def test_specimens_that_still_move_are_a_finding_and_no_failure(self):
        runs = [run_that(), run_that(False, kind="bent slab"), run_that(False, kind="hanging bar")]
        self.assertEqual(bar.failure_of(runs), "")
        self.assertEqual(
            bar.warning_of(runs),
            "bar: 2 specimens were still moving when time was up, so what stands there is not "
            "final: bent slab, E = 1e+05 Pa, 3 cells, 20 iterations of 0.005 s, true modulus; "
            "hanging bar, E = 1e+05 Pa, 3 cells, 20 iterations of 0.005 s, true modulus.")
        summary = bar.summary_of(runs)
        self.assertEqual(len(summary["still_moving"]), 2)
        self.assertEqual(len(summary["tests"]), 3)
        report = bar.report_of(runs)
        self.assertIn("| bent bar | 1e+05 | - | 1.25 | - | - |", report)
        self.assertIn("| bent slab | 1e+05 | - | 1.25 (still moving) | - | - |", report)

    def test_lost_volume_is_a_failure(self):
        runs = [run_that(), run_that(volume_ratio=0.97)]
        self.assertEqual(bar.failure_of(runs),
                         "bar: bent bar, E = 1e+05 Pa, 3 cells, 20 iterations of 0.005 s, true "
                         "modulus: the volume is 97.00 % of what it was.")
        self.assertEqual(bar.warning_of(runs), "")
        self.assertTrue(bar.failure_of([run_that(False, math.nan)]), "it left the range of numbers")

    def test_counts_what_holds_by_whether_iterations_are_enough(self):
        runs = [run_that(), run_that(modulus=1.3e5), run_that(too_few=True)]
        self.assertEqual(bar.count_runs(runs, True, False), [2, 0, 1])
        self.assertEqual(bar.count_runs(runs, True, True)[0], 1)
        self.assertEqual(bar.count_runs(runs, False, False)[0], 0)

    def test_the_whole_is_all_combinations(self):
        self.assertEqual(len(bar.settings(True)), 2 * 7 * 3 * 4 * 5 * 3)
        self.assertEqual(len(bar.settings()), 2 * 7 * 3 * (3 + 4 + 2 + 1))


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
