"""The examples run, in short, and leave what they promise; a study runs by the module."""

import json
import subprocess
import sys
import unittest

import kerf
from support import ROOT, TestCase, command_line, replayed

EXAMPLES = ROOT / "scripts/examples"


def without_times(table):
    """A table without its last two columns, which are measured."""
    return [line.rsplit(",", 2)[0] for line in table.read_text().splitlines()]


class Examples(TestCase):
    def run_example(self, name):
        done = subprocess.run([sys.executable, "-B", EXAMPLES / name, "--quick", "--out",
                               self.folder], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def test_stiffness(self):
        lines = self.run_example("stiffness.py").splitlines()
        sags = [float(line.split()[2]) for line in lines if " Pa " in line]
        self.assertEqual(sags, sorted(sags, reverse=True))
        self.assertGreater(sags[0], 5 * sags[-1])
        self.assertTrue((self.folder / "stiffness.png").exists())

    def test_the_notebook_shows_pictures(self):
        cells = json.loads((ROOT / "assets/notebooks/cut.ipynb").read_text())["cells"]
        shown = []
        names = {"display": lambda thing: shown.append(thing._repr_png_())}
        for cell in cells:
            if cell["cell_type"] == "code":
                exec("".join(cell["source"]), names)
        self.assertEqual(len(set(shown)), 5)
        file = self.folder / "last.png"
        file.write_bytes(shown[-1])
        self.assertEqual(command_line("compare", file, file).returncode, 0)
        self.assertEqual(names["report"].pieces, 2)

    def test_halve(self):
        last = [line for line in self.run_example("halve.py").splitlines() if "cut " in line][-1]
        self.assertAlmostEqual(float(last.split()[6]), 50, delta=1)
        self.assertEqual(len(replayed(self.folder / "halve.kerf.json", self.folder / "out")
                             ["pieces"]), 2)
        self.assertTrue((self.folder / "halve.png").exists())

    def test_controller(self):
        self.assertIn("steps, from", self.run_example("controller.py"))
        replayed(self.folder / "controller.kerf.json", self.folder / "out")
        self.assertTrue((self.folder / "controller.png").exists())


class Sweep(TestCase):
    def setUp(self):
        super().setUp()
        (self.folder / "short.kerf.json").write_text(
            '{"format": "kerf-session", "version": 1, "model": {"builtin": "sphere20"}, '
            '"steps": 40, "events": []}')
        self.study = self.folder / "study.json"
        self.study.write_text('{"format": "kerf-sweep", "version": 1, '
                              '"sessions": ["short.kerf.json"], '
                              '"grid": {"time_step": [0.004, 0.005]}}')

    def test_a_study_runs_by_the_module(self):
        said = command_line("sweep", self.study, "--out", self.folder / "local")
        study = kerf.Study(self.study)
        self.assertEqual([run.params for run in map(study.__getitem__, range(len(study)))],
                         [{"time_step": 0.004}, {"time_step": 0.005}])
        out = self.folder / "module"
        self.assertEqual([study.run(1, out)[0], study.run(0, out)[0]], [0, 0], said.stderr)
        self.assertEqual(study.gather(out), ([], []))
        self.assertEqual(without_times(out / "table.csv"),
                         without_times(self.folder / "local/table.csv"))


if __name__ == "__main__":
    unittest.main()
