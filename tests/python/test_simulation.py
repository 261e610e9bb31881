"""What a script does with a simulation, and sees of it."""

import csv
import json
import logging
import os
import signal
import subprocess
import sys
import threading
import time
import unittest

import numpy as np

import kerf
from support import ROOT, TestCase, command_line, halved, replayed

SPHERE = ROOT / "assets/sessions/sphere20.kerf.json"


def read_ply(file):
    """The positions of the vertices of a binary PLY."""
    data = file.read_bytes()
    head, body = data.split(b"end_header\n", 1)
    count = int(next(line.split()[2] for line in head.splitlines()
                     if line.startswith(b"element vertex")))
    vertex = head[:head.index(b"element face")]
    size = 4 * vertex.count(b"property float") + vertex.count(b"property uchar")
    bytes_of = np.frombuffer(body, np.uint8, count * size).reshape(count, size)
    return np.ascontiguousarray(bytes_of[:, :12]).view("<f4")


class Body(TestCase):
    def test_arrays_tell_of_the_body(self):
        sim, end = halved()
        before = sim.positions
        self.assertTrue(np.shares_memory(before, sim.positions))  # no copy between steps
        self.assertFalse(before.flags.writeable)
        kept = before.copy()
        sim.sweep(*end, steps=20)
        sim.lift_blade()
        sim.set("gravity", [0, -9.81, 0])
        report = sim.step(5)
        np.testing.assert_array_equal(before, kept)  # the step left it alone

        mesh, pieces = sim.mesh, sim.pieces
        self.assertEqual(report.pieces, 2)
        self.assertEqual(len(pieces.volume), 2)
        self.assertEqual(mesh.triangles.shape, (report.triangles, 3))
        self.assertGreater(mesh.cut.sum(), 0)
        self.assertEqual(mesh.cut.dtype, bool)
        for piece in range(2):
            mine = mesh.triangles[mesh.piece == piece]
            self.assertEqual(len(mine), pieces.triangles[piece])
            a, b, c = (sim.positions[mine[:, i]] for i in range(3))
            volume = np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6
            self.assertAlmostEqual(volume, pieces.volume[piece], delta=1e-5 * volume)
            np.testing.assert_allclose(sim.positions[mine].min((0, 1)), pieces.low[piece],
                                       atol=1e-6)
            np.testing.assert_allclose(sim.positions[mine].max((0, 1)), pieces.high[piece],
                                       atol=1e-6)
        self.assertAlmostEqual(pieces.volume.sum(), report.volume, delta=1e-6)
        self.assertEqual(sim.strains.shape, (report.triangles,))
        self.assertLess(sim.velocities[np.unique(mesh.triangles)][:, 1].mean(), -0.1)  # it falls
        self.assertLess(abs(sim.cut_report["area"]["wound_to_swept"] - 1), 0.01)

    def test_positions_are_those_of_an_export(self):
        sim, end = halved()
        sim.sweep(*end, steps=20)
        self.assertEqual(sim.export(self.folder / "body.ply", coordinates="scene"),
                         ["body.ply"])
        written = read_ply(self.folder / "body.ply")
        used = sim.positions[np.unique(sim.mesh.triangles)].astype("f4")
        self.assertEqual({tuple(p) for p in written}, {tuple(p) for p in used})

    def test_far_from_the_origin_all_speaks_of_the_scene(self):
        at = np.array([500000.0, 300.0, -5000000.0])
        sim = kerf.Simulation("sphere20", params={"gravity": [0, 0, 0], "floor": 250},
                              placement={"translate": list(at)})
        sim.move_blade(at + [-0.8, 0.7, 0.02], at + [0.8, 0.7, 0.05])
        sim.sweep(at + [-0.8, -0.75, 0.02], at + [0.8, -0.75, 0.05], steps=20)
        np.testing.assert_array_equal(sim.blade[0], at + [-0.8, -0.75, 0.02])
        sim.lift_blade()
        sim.add_box(at - [0, 2, 0], [1, 1, 1])
        np.testing.assert_array_equal(sim.boxes[0]["center"], at - [0, 2, 0])
        self.assertEqual(sim.params["floor"], 250)
        self.assertEqual(sim.step().pieces, 2)
        near, end = halved()
        near.sweep(*end, steps=20)
        near.lift_blade()
        near.step()
        corners = slice(12)  # the sphere's own; walls are divided as rounding has it
        for mine, other in ((sim.positions[corners], near.positions[corners]),
                            (sim.mesh.rest_positions[corners], near.mesh.rest_positions[corners]),
                            (sim.pieces.low, near.pieces.low)):
            np.testing.assert_allclose(mine - at, other, atol=1e-4)
        sim.save_session(self.folder / "far.kerf.json")
        summary = replayed(self.folder / "far.kerf.json", self.folder / "out")
        self.assertEqual(summary["state_hash"], sim.state_hash)

    def test_strengths_come_with_a_material_and_tearing_is_set(self):
        sim = kerf.Simulation("sphere20", material="skin-over-fat",
                              params={"floor": -1, "tensile_strength": 20e3})
        self.assertEqual(sim.params["tensile_strength"], 20e3)
        self.assertGreater(sim.params["skin_tensile_strength"], 1e7)
        self.assertEqual(sim.params["tearing"], 0)
        plain = kerf.Simulation("sphere20", params={"floor": -1})
        self.assertIsNone(plain.step().fracture_energy)
        plain.set("tearing", 1)
        plain.set("skin_toughness", 500)
        self.assertEqual(plain.step().fracture_energy, 0)
        self.assertEqual((plain.params["tearing"], plain.params["skin_toughness"]), (1, 500))
        self.assertIs(plain.report.tears, False)
        self.assertIn("of its strength", plain.tear_sentence)
        plain.set("toughness", 0)
        self.assertIsNone(plain.step().tears)
        self.assertIn(plain.tear_sentence, plain.messages[-1])

    def test_measures_are_the_columns_of_a_replay(self):
        replayed(SPHERE, self.folder, "--until", 30)
        sim = kerf.Simulation.from_session(SPHERE)
        with open(self.folder / "metrics.csv", encoding="utf-8") as file:
            for row in csv.DictReader(file):
                report = sim.step()
                mine = report.as_dict()
                self.assertEqual(list(mine), list(row))
                for column, text in row.items():
                    if column.endswith("_ms") or column == "real_time_factor":
                        continue
                    value = None if text == "" else float(text)
                    self.assertEqual(mine[column], value, column)
                    if not column.startswith("blade_"):
                        self.assertEqual(getattr(report, column), value, column)

    def test_the_real_time_factor_is_simulated_time_over_that_of_the_step(self):
        sim = kerf.Simulation("sphere20", params={"time_step": 0.004})
        report = sim.step()
        self.assertAlmostEqual(report.real_time_factor, 4 / report.frame_ms)
        sim.hold()
        self.assertIsNone(sim.step().real_time_factor)

    def test_forces_are_felt(self):
        session = json.loads((ROOT / "tests/sessions/pushing-blade.kerf.json").read_text())
        quiet = kerf.Simulation.from_session(session)
        feeling = kerf.Simulation.from_session(session, forces=True)
        most = 0.0
        for _ in range(session["steps"]):
            feeling.step()
            force = feeling.report.blade_force
            self.assertEqual(force.shape, (3,))
            most = max(most, float(np.linalg.norm(force)))
        quiet.step(session["steps"])
        self.assertIsNone(quiet.report.blade_force)
        self.assertGreater(most, 0)
        self.assertEqual(quiet.state_hash, feeling.state_hash)

    def test_a_picture_is_that_of_a_replay(self):
        session = {"format": "kerf-session", "version": 1, "model": {"builtin": "sphere20"},
                   "steps": 1, "events": [{"step": 1, "type": "screenshot", "file": "a.png",
                                           "width": 160, "height": 90}]}
        kerf.replay(session, self.folder)
        sim = kerf.Simulation.from_session(session)
        sim.step()
        picture = sim.picture(160, 90)
        self.assertEqual((picture.shape, picture.dtype), ((90, 160, 4), np.uint8))
        frame = subprocess.run(
            ["ffmpeg", "-v", "error", "-i", str(self.folder / "a.png"), "-f", "rawvideo",
             "-pix_fmt", "rgba", "-"], capture_output=True, check=True).stdout
        np.testing.assert_array_equal(picture, np.frombuffer(frame, np.uint8).reshape(90, 160, 4))
        other = sim.picture(160, 90, view={"eye": [0, 5, 0.1], "target": [0, 0, 0]})
        self.assertFalse((picture == other).all())

    def test_a_snapshot_is_come_back_to(self):
        sim, end = halved()
        sim.step(2)
        before, there = sim.snapshot(), sim.state_hash
        hashes = []
        for _ in range(2):
            sim.sweep(*end, steps=10)
            hashes.append(sim.state_hash)
            sim.restore(before)
            self.assertEqual((sim.state_hash, sim.step_count), (there, 2))
        self.assertEqual(hashes[0], hashes[1])
        other, _ = halved()
        with self.assertRaisesRegex(kerf.InputError, "of another simulation"):
            other.restore(before)
        del sim
        self.assertEqual(repr(before)[:1], "<")  # a snapshot outlives what it is of

    def test_changes_are_undone(self):
        sim, end = halved()
        sim.sweep(*end, steps=20)
        sim.lift_blade()
        sim.step()
        self.assertEqual(sim.report.pieces, 2)
        sim.undo()
        self.assertEqual(sim.step().pieces, 1)
        sim.redo()
        self.assertEqual(sim.step().pieces, 2)

    def test_pins_hands_and_boxes(self):
        sim = kerf.Simulation("sphere20", params={"floor": None}, placement={"translate": [0, 2, 0]},
                              boxes=[{"center": [0, -1, 0], "size": [1, 1, 1]}])
        sim.pin(low=[-1, 2.2, -1], high=[1, 3, 1])
        pinned = sim.pinned
        self.assertGreater(len(pinned), 0)
        fixed = sim.positions[pinned]
        sim.grab([0, 1.6, 0], 0.4, hand=3)
        sim.drag([0.3, 1.4, 0], hand=3)
        sim.add_box([2, 0, 0], [1, 1, 1], rotate=[0, 45, 0])
        sim.change_box(0, [0, -2, 0], [2, 1, 2])
        sim.step(5)
        sim.release(hand=3)
        np.testing.assert_array_equal(sim.positions[pinned], fixed)
        self.assertEqual([box["center"] for box in sim.boxes], [(0, -2, 0), (2, 0, 0)])
        self.assertEqual(sim.boxes[1]["rotate"], (0, 45, 0))
        sim.remove_box(0)
        sim.move_pins([0, 0.5, 0])
        np.testing.assert_allclose(sim.positions[pinned], fixed + [0, 0.5, 0], atol=1e-6)
        sim.unpin(center=[0, 2, 0], radius=5)
        self.assertEqual((len(sim.pinned), len(sim.boxes)), (0, 1))

    def test_a_piece_is_removed(self):
        sim = kerf.Simulation("sphere20", params={"floor": None, "gravity": [0, 0, 0]})
        sim.move_blade([0.1, 2, -2], [0.1, 2, 2])
        sim.sweep([0.1, -2, -2], [0.1, -2, 2], 30)
        sim.lift_blade()
        self.assertEqual(sim.step().pieces, 2)
        kept = sim.pieces.triangles[1]
        sim.remove_piece(0)
        np.testing.assert_array_equal(sim.pieces.triangles, [kept])
        self.assertRaises(kerf.InputError, sim.remove_piece, 0)

    def test_time_stands_and_parameters_change(self):
        sim = kerf.Simulation("sphere20", params={"floor": None})
        sim.hold()
        where = sim.positions
        self.assertEqual(sim.step(3).time, 0)
        np.testing.assert_array_equal(sim.positions, where)
        sim.resume()
        sim.set("time_step", np.float64(0.01))
        self.assertEqual(sim.params["time_step"], 0.01)
        self.assertAlmostEqual(sim.step().time, 0.01)
        self.assertEqual(set(sim.params), {row["name"] for row in kerf.parameters()})
        sim.restart()
        np.testing.assert_array_equal(sim.positions, where)


class Errors(TestCase):
    def test_sentences_are_those_of_the_command_line(self):
        text = json.loads(SPHERE.read_text())
        cases = {
            "missing": None,
            "version": {**text, "version": 7},
            "param": {**text, "params": {"gravty": 1}},
            "undo": {**text, "events": [{"step": 2, "type": "undo"}]},
            "model": {**text, "model": {"path": "nowhere.ply"}},
        }
        for name, session in cases.items():
            with self.subTest(name):
                file = self.folder / f"{name}.kerf.json"
                if session is not None:
                    file.write_text(json.dumps(session))
                said = command_line("replay", file, "--out", self.folder / "out")
                self.assertEqual(said.returncode, 3)
                with self.assertRaises(kerf.InputError) as raised:
                    kerf.replay(file)
                self.assertEqual(f"kerf: {raised.exception}\n", said.stderr)

    def test_what_cannot_be_done_changes_nothing(self):
        sim, _ = halved()
        before = sim.state_hash
        for sentence, act in {
                "There is nothing to undo": sim.undo,
                "grab.radius: -1 is out of range": lambda: sim.grab([0, 0, 0], -1),
                "blade.a: expected three numbers": lambda: sim.move_blade([0, 1], [1, 1, 1]),
                "time_step": lambda: sim.set("time_step", 7),
                "there is no event type 'cut'": lambda: sim.apply("cut"),
                "screenshot.width: 0 is out of range": lambda: sim.picture(0, 10),
                "view.eye: expected three numbers": lambda: sim.picture(view={"eye": 1,
                                                                              "target": [0, 0, 0]}),
                "'body.txt' must end in": lambda: sim.export(self.folder / "body.txt"),
        }.items():
            with self.assertRaisesRegex(kerf.InputError, sentence):
                act()
        self.assertEqual(sim.state_hash, before)
        self.assertTrue(issubclass(kerf.InputError, kerf.Error))

    def test_a_failed_check_is_told(self):
        text = json.loads(SPHERE.read_text())
        session = {**text, "events": [{"step": 2, "type": "check", "pieces": 3}]}
        sentence = "Step 2: the model is in 1 piece where the session expects 3."
        with self.assertRaises(kerf.CheckFailed) as raised:
            kerf.replay(session)
        self.assertEqual(str(raised.exception), sentence)
        self.assertEqual(raised.exception.summary["steps"], 2)
        with self.assertRaises(kerf.CheckFailed) as raised:
            kerf.Simulation.from_session(session).step(3)
        self.assertEqual(str(raised.exception), sentence)

    def test_without_opengl(self):
        code = ("import kerf\ntry:\n    kerf.Simulation('sphere20')\n"
                "except kerf.OpenGLError as error:\n    print(error)")
        done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True,
                              check=True, env={**os.environ, "KERF_FORCE_NO_GL": "1"})
        self.assertIn("KERF_FORCE_NO_GL", done.stdout)

    def test_warnings_go_to_logging(self):
        text = json.loads(SPHERE.read_text())
        with self.assertLogs("kerf", logging.WARNING) as logs:
            kerf.Simulation.from_session({**text, "colour": "red"})
        self.assertIn("colour: unknown key, ignored.", logs.output[0])

    def test_a_solver_that_is_no_longer_there_is_told_and_replaced(self):
        text = json.loads(SPHERE.read_text())
        former = {**text, "params": {"solver": "small_steps", "true_modulus": 1}}
        with self.assertLogs("kerf", logging.WARNING) as logs:
            sim = kerf.Simulation.from_session(former)
        self.assertIn("params.solver: \"small_steps\" is no longer there", "".join(logs.output))
        self.assertIn("params.true_modulus: ", "".join(logs.output))
        self.assertEqual(sim.params["solver"], "implicit")

    def test_the_papers_experiments_are_sessions(self):
        names = [paper["name"] for paper in kerf.paper_experiments()]
        self.assertEqual(names, ["sphere20", "sphere80", "sphere768", "octopus", "banana"])
        self.assertLessEqual(set(names), set(kerf.builtin_models()))

    def test_a_fork_is_refused(self):
        sim, _ = halved()
        child = os.fork()
        if child == 0:
            try:
                sim.step()
            except kerf.Error as error:
                os._exit(7 if "forked" in str(error) else 1)
            os._exit(2)
        self.assertEqual(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]), 7)
        sim.step()  # here it goes on

    def test_control_c_ends_a_long_run(self):
        sim = kerf.Simulation("sphere20")
        threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT)).start()
        begin = time.monotonic()
        with self.assertRaises(KeyboardInterrupt):
            sim.step(1_000_000)
        self.assertLess(time.monotonic() - begin, 60)
        done = sim.step_count
        self.assertLess(done, 1_000_000)
        sim.step()
        self.assertEqual(sim.step_count, done + 1)


if __name__ == "__main__":
    unittest.main()
