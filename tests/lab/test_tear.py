"""Toughness found again where specimens tear."""

import types
import unittest

import numpy as np
from lab import bodies, tear
from lab.tear import Material, Point

JELLY = Material("jelly", 2e4, 1000, 2)


def run_of(rates):
    """A strip that was torn at these energy release rates, a tenth each, and kept all energy."""
    points = [Point(0.001 * (i + 1), rate, 0.1 * i, 5, 3, 1, 1) for i, rate in enumerate(rates)]
    specimen = types.SimpleNamespace(name="strip", material=JELLY, WINDOW=(0.2, 0.6),
                                     toughness_from=tear.mean_release)
    return tear.Run(specimen, "coarse", "slow", 100, 0.01, points)


class Tear(unittest.TestCase):
    def test_the_toughness_is_read_while_a_fifth_to_three_fifths_are_torn(self):
        run = run_of([9, 9, 2, 2, 2, 2, 2, 9])
        self.assertAlmostEqual(run.found, 2)
        self.assertAlmostEqual(run.ratio, 1)
        self.assertAlmostEqual(run.balance, 1)
        self.assertEqual(tear.failure_of([run]), "")

    def test_what_is_not_found_again_is_told(self):
        self.assertEqual(tear.failure_of([run_of([1, 2])]),
                         "tear: strip of jelly, coarse, slow: it did not tear.")
        self.assertEqual(tear.failure_of([run_of([3] * 8)]),
                         "tear: strip of jelly, coarse, slow: 150 % of the toughness are found.")
        run = run_of([2] * 8)
        run.points[-1] = run.points[-1]._replace(work=10)
        self.assertEqual(tear.failure_of([run]),
                         "tear: strip of jelly, coarse, slow: 50 % of the work are found again.")

    def test_an_energy_is_fitted_by_a_square_and_a_cube(self):
        openings = np.linspace(1, 2, 9)
        fit = tear.Fit(openings, 3 * openings**2 - 0.5 * openings**3)
        self.assertAlmostEqual(fit(2), 8)
        self.assertAlmostEqual(fit.slope(2), 6 * 2 - 1.5 * 2**2)
        self.assertAlmostEqual(((fit - fit / 2) / 2)(2), 2)

    def test_a_ring_is_closed_and_as_large_as_asked(self):
        points, triangles = bodies.ring(1, 2, 0.5, [2, 60, 1])
        edges = {tuple(sorted(e)) for t in triangles for e in zip(t, np.roll(t, 1))}
        self.assertEqual(len(points) - len(edges) + len(triangles), 0)
        self.assertAlmostEqual(bodies.volume(points, triangles), 1.5 * np.pi, delta=0.02)

    def test_work_that_legs_store_is_no_toughness(self):
        """As finite elements have it: straight legs, whose energy is linear in opening and slit."""
        trouser = tear.Trouser(JELLY, "coarse")
        trouser.stored = lambda opening, length: 2 * opening + length
        start, end = (Point(0.001 * torn, 0, torn, 3 * torn, 0, 0, 0) for torn in (0.2, 0.45))
        expected = (3 * 0.25 - 2 * 0.00025 - 4 * 0.25) / (0.25 * trouser.ligament)
        self.assertAlmostEqual(trouser.toughness_from([start, end]) / expected, 1)

    def test_quick_tears_one_of_each(self):
        wanted = list(tear.cases(quick=True))
        self.assertEqual([kind.name for kind, *_ in wanted], [s.name for s in tear.SPECIMENS])
        self.assertEqual({(name, mesh, *speeds) for _, name, mesh, speeds in wanted},
                         {("gelatin", "coarse", "fast")})


if __name__ == "__main__":
    unittest.main()
