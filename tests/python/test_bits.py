"""The module comes to the same bits as `kerf replay`."""

import csv
import pathlib
import threading
import unittest

import numpy as np

import kerf
from support import ROOT, TestCase, halved, replayed

STEPS = 50  # as far as the longer sessions are run here
SESSIONS = [
    "assets/sessions/sphere20.kerf.json",
    "tests/regression/two-models.kerf.json",
    "tests/regression/undo-and-redo.kerf.json",
    "tests/regression/pulled-then-cut.kerf.json",
    "tests/regression/plain-pbd.kerf.json",
    "tests/regression/pushing-blade.kerf.json",
]


def hashes_of(folder: pathlib.Path):
    with open(folder / "hashes.csv", encoding="utf-8") as file:
        return [row["state_hash"] for row in csv.DictReader(file)]


class Bits(TestCase):
    def test_each_step_is_that_of_a_replay(self):
        for name in SESSIONS:
            with self.subTest(name):
                folder = self.folder / pathlib.Path(name).stem
                replayed(ROOT / name, folder, "--hashes", "--until", STEPS)
                expected = hashes_of(folder)
                sim = kerf.Simulation.from_session(ROOT / name)
                found = []
                for _ in expected:
                    sim.step()
                    found.append(sim.state_hash)
                self.assertEqual(found, expected)

    def test_a_replay_is_that_of_the_program(self):
        session = ROOT / "assets/sessions/sphere20.kerf.json"
        expected = replayed(session, self.folder / "program", "--hashes", "--until", STEPS)
        summary = kerf.replay(session, self.folder / "module", hashes=True, until=STEPS)
        for key in ("model", "steps", "state_hash", "pieces", "cut_report", "volume_ratio"):
            self.assertEqual(summary[key], expected[key], key)
        self.assertEqual(summary["files"], expected["files"])
        for name in ("final.ply", "hashes.csv"):
            self.assertEqual((self.folder / "module" / name).read_bytes(),
                             (self.folder / "program" / name).read_bytes(), name)

    def test_what_a_script_did_replays(self):
        sim, end = halved()
        sim.step(3)  # the blade stands still
        sim.sweep(*end, steps=20)
        sim.lift_blade()
        sim.set("gravity", [0, -9.81, 0])
        sim.grab([0, 0.4, 0.3], 0.3)
        sim.step(2)
        sim.drag([0, 0.5, 0.4])
        sim.step(5)
        sim.undo()
        sim.step(4)
        sim.save_session(self.folder / "script.kerf.json")
        summary = replayed(self.folder / "script.kerf.json", self.folder / "out")
        self.assertEqual(summary["state_hash"], sim.state_hash)
        self.assertEqual(summary["steps"], 34)

    def test_a_restored_course_is_what_is_saved(self):
        sim, end = halved()
        before = sim.snapshot()
        sim.sweep([-0.8, 0, 0.02], [0.8, 0, 0.05], steps=12)
        sim.restore(before)
        sim.sweep(*end, steps=20)
        sim.lift_blade()
        sim.step(2)
        sim.save_session(self.folder / "script.kerf.json")
        summary = replayed(self.folder / "script.kerf.json", self.folder / "out")
        self.assertEqual(summary["state_hash"], sim.state_hash)

    def test_two_that_interleave_are_as_alone(self):
        stiff = {"youngs_modulus": 1e6}
        alone = []
        for params in ({}, stiff):
            sim, end = halved()
            for _ in cut_in_steps(sim, end, params):
                pass
            alone.append(sim.state_hash)
        self.assertNotEqual(*alone)

        first, end = halved()
        second, _ = halved()
        for _ in zip(cut_in_steps(first, end, {}), cut_in_steps(second, end, stiff)):
            self.assertFalse((first.picture(64, 48) == second.picture(96, 48)[:, :64]).all())
        self.assertEqual([first.state_hash, second.state_hash], alone)

    def test_threads_may_share_one(self):
        sim, end = halved()
        for _ in cut_in_steps(sim, end, {}):
            pass
        expected = sim.state_hash

        shared, _ = halved()
        for _ in cut_in_steps(shared, end, {}, led_by=in_a_thread):
            pass
        self.assertEqual(shared.state_hash, expected)


def in_a_thread(work):
    """Does something in a thread that ends with it."""
    thread = threading.Thread(target=work)
    thread.start()
    thread.join()


def cut_in_steps(sim, end, params, led_by=lambda work: work()):
    """A cut with other parameters, which rests after each step."""
    for name, value in params.items():
        sim.set(name, value)
    start = sim.blade
    for step in range(1, 21):
        pose = [a + (np.array(b) - a) * step / 20 for a, b in zip(start, end)]
        led_by(lambda pose=pose: sim.sweep(*pose, steps=1))
        yield
    led_by(sim.lift_blade)
    led_by(sim.step)
    yield


if __name__ == "__main__":
    unittest.main()
