"""Auto iterations: the error that they leave is about the one that is asked for."""

import unittest

from lab import iterations
from lab.iterations import Run, Setting


class Auto(unittest.TestCase):
    def test_the_error_is_about_the_one_asked_for(self):
        """With fewer iterations for a softer body, and more for a smaller error."""
        chosen = {}
        for modulus in (1e5, 1e6):
            for motion in iterations.MOTIONS:
                runs = iterations.measure(Setting("sphere80", modulus, motion), (0.05, 0.02, 0.01))
                for run in runs:
                    self.assertLess(run.error, 1.5 * run.asked, run)
                    self.assertFalse(run.too_few)
                self.assertGreater(runs[0].error, runs[2].error)
                self.assertLess(runs[0].least, runs[2].least)
                chosen[modulus] = runs[1].least
        self.assertLess(chosen[1e5], chosen[1e6])
        self.assertLess(chosen[1e5], 10)

    def test_it_is_so_for_cut_bodies(self):
        for cut, pieces in zip(iterations.CUTS, (2, 1)):
            setting = Setting("sphere20", 1e6, "first swing", cut)
            self.assertEqual(iterations.begin(setting, {}).report.pieces, pieces)
            run, = iterations.measure(setting)
            self.assertLess(run.error, 1.5 * run.asked, run)

    def test_the_report_has_a_row_for_each_body_and_one_for_each_error(self):
        runs = [Run(Setting("banana", 1e7, motion), 0.02, 5, 60, 0.047, 0.23, True)
                for motion in iterations.MOTIONS]
        by_asked = [run._replace(asked=asked) for run in runs for asked in iterations.ALL_ASKED]
        report = iterations.report_of(runs, by_asked)
        self.assertIn("| banana | none | 1e+07 | 5 to 60* | 4.7 | 23 | 5 to 60* | 4.7 | 23 |\n", report)
        self.assertIn("| 0.5 | 5 to 60* | 4.7 | 5 to 60* | 4.7 |\n", report)


if __name__ == "__main__":
    unittest.main()
