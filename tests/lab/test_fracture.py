"""Challenge problems of fracture: what is expected, and what the report says."""

import json
import unittest

import numpy as np
from lab import fracture, legs
from lab.fracture import Bar, Beam, Row
from lab.tear import Material


class Pulled(Beam):
    """By the first step of the hands alone."""
    most_force = 0


class Fracture(unittest.TestCase):
    def test_a_notched_bar_breaks_between_what_handbooks_have(self):
        """Tada, Paris, Irwin, of the root of pi a: 1.12 for short notches, 1.37 where ends turn."""
        bar = Bar((20, 60, 2), notch=0.2)
        griffith = np.sqrt(bar.material.modulus * bar.material.toughness
                           / (np.pi * bar.notch * bar.width))
        self.assertTrue(1.12 < griffith / bar.griffith_stress() < 1.37)

    def test_legs_store_what_slender_beams_do(self):
        """Two cantilevers of width 1: their energy is half of force times opening, 3 E I / L^3."""
        beam = Pulled(Material("jelly", 2e4, 1000, 2), "coarse")
        (_, opening), (_, energy) = legs.curve_of(beam, 3)
        share = energy / (beam.thickness / beam.height / 4 / 3**3 * (3 * opening)**2 / 4)
        self.assertTrue(0.5 < share < 1, f"{share}: the end of the slit gives way")

    def test_what_is_off_is_told(self):
        rows = [Row("pure shear", "toughness", 2, np.float64(1.9)),
                Row("trousers", "toughness", 2, 3), Row("trousers", "toughness", 2, None)]
        self.assertEqual(fracture.failure_of(rows[:1]), "")
        self.assertEqual(fracture.failure_of(rows[:2]),
                         "fracture: trousers: 150 % of what is expected.")
        self.assertEqual(fracture.failure_of(rows[2:]), "fracture: trousers: it did not tear.")
        report = fracture.report_of(rows)
        self.assertIn("Within 15 %: 1 of 3.", report)
        self.assertIn("| trousers | toughness | 2 | - | - | no |", report)
        within = json.loads(json.dumps(fracture.summary_of(rows)))["problems"]
        self.assertEqual([r["within"] for r in within], [True, False, False])
        self.assertEqual(len(fracture.PROBLEMS) + len(fracture.OTHERS), 9)


if __name__ == "__main__":
    unittest.main()
