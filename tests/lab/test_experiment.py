"""`kerf experiment` as a person calls it."""

import json
import os
import unittest

import matplotlib.pyplot as plt
from lab_case import LabCase, experiment


class Experiment(LabCase):
    def test_leaves_what_the_contract_says(self):
        out = self.folder / "out"
        out.mkdir()
        (out / "report.md").write_text("of an earlier run")
        done = experiment("sphere20", "--runs", 2, "--out", out, "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        printed = json.loads(done.stdout)
        summary = json.loads((out / "sphere20/summary.json").read_text())
        self.assertEqual(printed["experiments"]["sphere20"]["state_hash"], summary["state_hash"])
        self.assertEqual(len(summary["pieces"]), 2)
        self.assertEqual(plt.imread(out / "sphere20/plots.png").shape[1], 900)
        report = (out / "report.md").read_text()
        self.assertIn("| Sphere 20 | 100.00 | ", report)
        self.assertIn("99.6", report, "the paper's mean volume")
        for figure in ("figure-5a", "figure-7a", "figure-9", "figure-10"):
            file = f"figures/{figure}.png"
            self.assertIn(f"]({file})", report)
            self.assertGreater(plt.imread(out / file).shape[1], 900, file)
        self.assertTrue((out / "sphere20/runs/2/metrics.csv").exists())
        self.assertFalse((out / "sphere20/runs/3").exists())
        self.assertTrue((out / "sphere20/search/adjacency/metrics.csv").exists())
        self.assertIn("| Sphere 20 | adjacency | ", report)
        self.assertNotIn("Octopus", report, "was not run")

    def test_runs_as_published(self):
        out = self.folder / "out"
        done = experiment("sphere20", "--published", "--runs", 1, "--out", out, "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        summary = json.loads((out / "sphere20/summary.json").read_text())
        self.assertEqual(len(summary["pieces"]), 2)
        self.assertFalse(summary["closed_every_step"], "open while the blade is in it")
        self.assertTrue(0.95 < summary["volume_ratio"]["min"] < 0.999, "its solver loses volume")
        self.assertEqual(summary["failures"], [])
        report = (out / "report.md").read_text()
        self.assertIn("(`solver` pbd, `paper_contact`, `open_cut`)", report)
        self.assertIn("lips apart", report, "what the hollow picture shows")
        self.assertTrue((out / "sphere20/hollow/hollow.png").exists())

    def test_help_is_that_of_the_laboratory(self):
        done = experiment("--help")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("usage: kerf experiment [-h] --out DIR", done.stdout)
        self.assertIn("--published", done.stdout)
        self.assertIn("Exit codes: 0 done", done.stdout)

    def test_wrong_usage_is_one_sentence_and_exit_code_2(self):
        for words, told in (
                (["--out", "x"], "NAME"), (["all"], "--out"),
                (["all", "--out", ""], "--out: the name is empty"),
                (["bar", "--published", "--out", "x"], "takes neither --published nor --runs"),
                (["bar", "--runs", "2", "--out", "x"], "takes neither --published nor --runs"),
                (["fem", "--runs", "2", "--out", "x"], "'fem' is none of the paper's experiments"),
                (["sphere20", "--whole", "--out", "x"], "--whole is for 'bar' alone"),
                (["blade", "--quick", "--out", "x"], "--quick is for 'tear' alone"),
                (["all", "--runs", "0", "--out", "x"], "--runs"),
                (["cube", "--out", "x"], "there is no experiment 'cube'; there are sphere20, ")):
            done = experiment(*words)
            self.assertEqual(done.returncode, 2, words)
            self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
            self.assertIn(told, done.stderr)

    def test_a_file_is_no_folder(self):
        file = self.folder / "out"
        file.write_text("")
        done = experiment("sphere20", "--out", file)
        self.assertEqual(done.returncode, 3)
        self.assertEqual(done.stderr, f"kerf: {file}: --out is a file; name a folder.\n")

    def test_without_opengl_nothing_is_written(self):
        out = self.folder / "out"
        done = experiment("all", "--out", out, **os.environ, KERF_FORCE_NO_GL="1")
        self.assertEqual(done.returncode, 4, done.stderr)
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        self.assertFalse(out.exists())

    def test_names_the_package_that_is_missing(self):
        """As where matplotlib is not installed."""
        (self.folder / "matplotlib.py").write_text("raise ModuleNotFoundError(name='matplotlib')")
        done = experiment("sphere20", "--out", self.folder / "out",
                          **{**os.environ, "PYTHONPATH": str(self.folder)})
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertIn("python3-matplotlib", done.stderr)
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        self.assertFalse((self.folder / "out").exists())


if __name__ == "__main__":
    unittest.main()
