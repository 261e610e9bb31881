"""Auto steps and iterations: the error that they leave is a few hundredths of the motion."""

import unittest

from lab import iterations
from lab.iterations import Run, Setting


class Auto(unittest.TestCase):
    def test_the_error_is_small_and_can_be_made_smaller(self):
        """With more steps for a firmer body, and for a smaller error."""
        steps = {}
        for modulus in (1e5, 1e6):
            for motion in iterations.MOTIONS:
                usual, exact = iterations.measure(Setting("sphere80", modulus, motion),
                                                  (0.02, 0.002))
                # The floor moves few vertices of so coarse a ball, for a moment.
                self.assertLess(usual.error, 0.05 if motion == "first swing" else 0.5, usual)
                self.assertLess(exact.error, usual.error)
                self.assertLess(usual.steps[0], exact.steps[0])
                steps[modulus] = usual.steps[0]
        self.assertLessEqual(steps[1e5], steps[1e6])

    def test_it_is_so_for_cut_bodies(self):
        for cut, pieces in zip(iterations.CUTS, (2, 1)):
            setting = Setting("sphere20", 1e6, "first swing", cut)
            self.assertEqual(iterations.begin(setting, {}).report.pieces, pieces)
            run, = iterations.measure(setting)
            self.assertLess(run.error, 0.1, run)

    def test_the_report_has_a_row_for_each_body_and_one_for_each_error(self):
        runs = [Run(Setting("banana", 1e6, motion), 0.02, (1, 3), (4, 4), 0.047)
                for motion in iterations.MOTIONS]
        by_asked = [run._replace(asked=asked) for run in runs for asked in iterations.ALL_ASKED]
        report = iterations.report_of(runs, by_asked)
        self.assertIn("| banana | none | 1e+06 | 1 to 3 | 4 | 4.7 | 1 to 3 | 4 | 4.7 |\n", report)
        self.assertIn("| 0.5 | 1 to 3 | 4 | 4.7 | 1 to 3 | 4 | 4.7 |\n", report)


if __name__ == "__main__":
    unittest.main()
