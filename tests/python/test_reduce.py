"""`kerf reduce` makes sessions small. Most commands here read the session and run nothing."""

import json
import sys
import unittest

from support import KERF, TestCase, command_line

SESSION = {
    "format": "kerf-session", "version": 1, "model": {"builtin": "sphere80"}, "steps": 400,
    "params": {"gravity": [0, 0, 0], "floor": -1, "friction": 0.1},
    "view": {"eye": [2, 1, 2], "target": [0, 0, 0]},
    "events": [
        *({"step": 10 * i, "type": "set", "name": "friction", "value": i / 20} for i in range(12)),
        {"step": 130, "type": "blade", "a": [-0.8, 0.6, 0], "b": [0.8, 0.6, 0]},
        {"step": 200, "type": "blade", "a": [-0.8, -0.6, 0], "b": [0.8, -0.6, 0]},
        {"step": 201, "type": "lift"},
        {"step": 400, "type": "check", "pieces": 2},
    ],
}


class Reduce(TestCase):
    def setUp(self):
        super().setUp()
        self.session = self.folder / "long.kerf.json"
        self.session.write_text(json.dumps(SESSION))
        self.out = self.folder / "out"

    def reduce(self, body, out="out"):
        """Runs it with a program of Python that has the session as `s`, and where that lies."""
        code = f"import json, os, sys; s = json.load(open(sys.argv[1])); {body}"
        return command_line("reduce", self.session, "--out", self.folder / out, "--",
                            sys.executable, "-c", code, "{}")

    def reduced(self):
        return json.loads((self.out / "reduced.kerf.json").read_text())

    def test_what_the_command_needs_is_left(self):
        done = self.reduce("e = [x['type'] for x in s['events']]; "
                           "sys.exit(7 * (e.count('blade') == 2 and 'floor' in s['params'] "
                           "and s['events'][-1]['step'] >= 7))")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stdout, r": 2 events, 7 steps, \d+ triangles, "
                                      "of 16 events, 400 steps, 80 triangles; ")
        self.assertIn("round 1: 2 events", done.stderr)
        reduced = self.reduced()
        self.assertEqual([event["type"] for event in reduced["events"]], ["blade", "blade"])
        self.assertEqual(reduced["params"], {"floor": -1})
        self.assertNotIn("view", reduced)
        self.assertTrue(reduced["model"]["remesh"])

    def test_the_way_of_the_blade_is_trimmed(self):
        self.reduce("a, b = [(x['step'], x['a'][1]) for x in s['events'] if x['type'] == 'blade']; "
                    "slow = a[1] - b[1] <= 0.02 * (b[0] - a[0]); "
                    "sys.exit(7 * (slow and a[1] >= 0.3 >= b[1]))")
        high, low = (event["a"][1] for event in self.reduced()["events"])
        self.assertLess(high - low, 0.1)

    def test_a_session_that_breaks_otherwise_does_not_count(self):
        done = self.reduce("sys.exit(7 if len(s['events']) >= 3 else 3)")
        self.assertIn(": 3 events, 1 step,", done.stdout, done.stderr)

    def test_the_same_call_goes_on_after_a_stop(self):
        count = "open('runs', 'a').write('.'); "
        body = f"os.chdir({str(self.folder)!r}); {count}" + "sys.exit(len(s['events']) >= 3)"
        stop = "os.path.getsize('runs') == 6 and os.kill(os.getppid(), 2); "
        stopped = self.reduce(body.replace("sys.exit", stop + "sys.exit"))
        self.assertEqual(stopped.returncode, 130, stopped.stderr)
        self.assertIn("the same call goes on", stopped.stderr)
        self.assertFalse((self.out / "reduced.kerf.json").exists())
        done = self.reduce(body.replace("sys.exit", stop + "sys.exit"))
        self.assertIn(": 3 events, 1 step,", done.stdout, done.stderr)
        together = (self.folder / "runs").stat().st_size
        (self.folder / "runs").unlink()
        self.reduce(body, "another")
        self.assertLessEqual(together - (self.folder / "runs").stat().st_size, 1)

    def test_what_cannot_be_reduced_is_told(self):
        for said, body in {"ends with exit code 0 for the session itself": "0",
                           "this is of another session or command": "1"}.items():
            done = self.reduce(body)
            self.assertEqual((done.returncode, done.stdout), (3, ""))
            self.assertIn(said, done.stderr)
        done = command_line("reduce", self.session, "--out", self.folder / "b", "--", "/no/such")
        self.assertIn("kerf: /no/such: can't be started (No such file", done.stderr)
        self.session.write_text("[]")
        self.assertIn("can't be read as a session", self.reduce("0", "c").stderr)

    def test_a_failing_check_of_a_replay(self):
        session = {**SESSION, "model": {"builtin": "sphere20"}, "steps": 100, "events": [
            {"step": 0, "type": "blade", "a": [-0.8, 0.63, 0.02], "b": [0.8, 0.57, 0.05]},
            {"step": 40, "type": "blade", "a": [-0.8, -0.62, 0.02], "b": [0.8, -0.68, 0.05]},
            {"step": 41, "type": "lift"}, {"step": 90, "type": "check", "pieces": 1}]}
        self.session.write_text(json.dumps(session))
        done = command_line("reduce", self.session, "--out", self.out, "--", KERF, "replay", "{}",
                            "--out", self.folder / "run")
        self.assertEqual(done.returncode, 0, done.stderr)
        small = self.reduced()
        self.assertLessEqual(len(small["events"]) + small["steps"], 10)
        replay = command_line("replay", self.out / "reduced.kerf.json", "--out", self.folder / "run")
        self.assertEqual(replay.returncode, 1)
        self.assertIn("pieces where the session expects 1", replay.stderr)


if __name__ == "__main__":
    unittest.main()
