"""Mistakes of a practised cut, and what they move."""

import unittest

from lab import practice
from lab.practice import tasks

EXPERT = {"deviation_max": 1e-4, "time": 4.0, "tremor": None, "force_max": 0.01}


class Practice(unittest.TestCase):
    def test_a_hand_of_least_jerk_starts_and_ends_at_rest(self):
        self.assertEqual([tasks.least_jerk(x) for x in (-1, 0, 0.5, 1, 2)], [0, 0, 0.5, 1, 1])
        self.assertLess(tasks.least_jerk(0.01), 1e-4)

    def test_ways_begin_and_end_as_the_experts(self):
        for way in (practice.jerky, practice.resting):
            self.assertEqual(way(0), 0)
            self.assertEqual(way(1), 1)
            values = [way(k / 100) for k in range(101)]
            self.assertEqual(values, sorted(values))
        self.assertEqual(practice.resting(0.4), practice.resting(0.6))

    def test_strokes_become_a_pose_a_step_and_lifts(self):
        events, step = tasks.events_of(tasks.expert_slice(seconds=0.1), 0.02)
        self.assertEqual([e["type"] for e in events], 2 * (6 * ["blade"] + ["lift"]))
        self.assertEqual([e["step"] for e in events[5:9]], [5, 6, 8, 9])
        self.assertEqual(step, 16)

    def test_what_moves_is_told_from_what_should_not(self):
        changes = practice.moved(EXPERT, {**EXPERT, "deviation_max": 2e-3, "force_max": 0.02})
        self.assertNotIn("tremor", changes)
        self.assertEqual(practice.missing(changes, {"deviation_max": 1e-3}), [])
        self.assertEqual(practice.missing(changes, {"time": 1, "deviation_max": -1e-3}),
                         ["time", "deviation_max"])
        self.assertEqual(practice.unwanted(changes, EXPERT, {"deviation_max"}), ["force_max"])

    def test_the_line_of_a_task_is_where_its_expert_cuts(self):
        session = tasks.session_of("slice", tasks.expert_slice())
        xs = {line["points"][0][0] for line in session["task"]["lines"]}
        self.assertEqual(xs, {e["a"][0] for e in session["events"] if e["type"] == "blade"})


if __name__ == "__main__":
    unittest.main()
