"""Mistakes of a practised cut, and what they move."""

import os
import unittest

from lab import practice
from lab_case import LabCase
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

    def test_the_scene_is_turned_with_the_hand(self):
        turned, plain = practice.turned(90), practice.line()
        for one, other in zip(turned["events"], plain["events"]):
            if one["type"] == "blade":
                x, y, z = other["a"]
                self.assertEqual(one["a"], tasks.rounded((z, y, -x)))
        self.assertEqual(turned["task"]["lines"][0]["points"][0], [0, tasks.TOP, 0.035])
        self.assertEqual(turned["more_models"][0]["placement"]["rotate"], [0, 90, 0])

    def test_half_of_the_poses_are_the_same_way(self):
        half, all_ = practice.with_poses(2)["events"], practice.line()["events"]
        self.assertTrue(all(event in all_ for event in half))
        self.assertEqual(len([e for e in half if e["type"] == "blade"]), 101)
        self.assertEqual(half[-1], all_[-1])


class Trust(LabCase):
    def test_the_expert_passes_and_a_hand_that_shakes_does_not(self):
        expert = practice.score_of(practice.line(), self.folder, "incision by the expert")
        self.assertEqual(expert["violations"], [])
        self.assertLess(expert["wobble"], practice.LEAST["wobble"])
        hand = practice.line(aside=practice.shaking(practice.UNSAFE, 1))
        shaken = practice.score_of(hand, self.folder, "incision shaken")
        self.assertEqual([told.split(":")[0] for told in shaken["violations"]], ["Wobble"])

    @unittest.skipUnless("KERF_NIGHTLY" in os.environ, "takes ten minutes")
    def test_figures_of_the_same_try_stay_within_what_the_page_says(self):
        expert = practice.score_of(practice.line(), self.folder, "incision by the expert")
        self.assertEqual(practice.spreads(expert, self.folder, {})[1], [])
        self.assertEqual(practice.shakes(self.folder, {})[1], [])


if __name__ == "__main__":
    unittest.main()
