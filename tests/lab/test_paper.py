"""Sessions and report of the paper's experiments, without running any."""

import unittest

import kerf
import numpy as np
from lab import hollow, paper, paper_figures, paper_report
from lab.paper import PAPER, Picture

COLUMNS = ["step", "frame_ms", "cut_ms", "search_ms", "search_walk_ms", "search_seeds",
           "search_tests", "vertices", "triangles", "ispcs"]


def rows_of(*rows):
    """Rows of metrics.csv, each with some of its columns."""
    made = np.zeros(len(rows), [(name, float) for name in COLUMNS])
    for place, row in enumerate(rows):
        for name, value in {"frame_ms": 8, "cut_ms": 1, **row}.items():
            made[name][place] = value
    return made


def same(value):
    return {"mean": value, "min": value, "max": value}


def result_of(name, volume=1.0, **summary):
    """As if an experiment had run one step."""
    session = paper.paper_session(name, False)
    counts = {"vertices": 12, "triangles": 20, "ispcs": 12}
    lift = paper.moments_of(session).lift
    rows = rows_of({"step": lift, "vertices": 960, "triangles": 1760, "ispcs": 900})
    return paper.Result(name, session, kerf.Simulation.from_session(session).params, {
        "renderer": "some GPU", "steps": 1, "failures": [], "remarks": [], "pieces": [{}, {}],
        "before": counts, "after": counts, "closed_every_step": True,
        "volume_ratio": {"mean": volume, "min": volume, "final": volume}, "fps": same(125),
        "stages_ms": {"deform": same(3), "collide": same(4), "cut": same(1)},
        "subdivisions": dict.fromkeys(paper_report.PATTERNS, 0), **summary,
    }, rows, [rows], {way: rows for way in paper.WAYS}, [], [])


class Report(unittest.TestCase):
    def test_names_what_did_not_hold_and_what_is_to_be_known(self):
        octopus = result_of("octopus", failures=["Step 7: the volume is not finite any more."],
                            remarks=["Step 0: the volume is far off."])
        report = paper_report.report([octopus], None, False)
        self.assertIn("- Octopus: Step 7: the volume", report)
        self.assertIn("## Remarks\n\n- Octopus: Step 0: the volume is far off.\n", report)
        self.assertIn("some GPU", report)
        self.assertIn("91.1", report)

    def test_derives_the_previous_method_from_the_gains(self):
        for name, rate in (("sphere768", 108.4), ("octopus", 51.7), ("banana", 32.1)):
            self.assertAlmostEqual(paper_report.previous_fps(PAPER[name]), rate, delta=0.05)
        self.assertIsNone(paper_report.previous_fps(PAPER["sphere20"]))
        self.assertIn("| Banana | 32.1 | 51.8 | 61.37 |",
                      paper_report.performance([result_of("banana")]))
        self.assertIn("| Sphere 20 | above 172.1 | 172.1 | - |",
                      paper_report.performance([result_of("sphere20")]))

    def test_has_the_figures_of_the_runs_alone(self):
        spheres = paper_report.report([result_of("sphere20"), result_of("sphere768")], None, False)
        self.assertIn("](figures/figure-5a.png)", spheres)
        self.assertIn("](figures/figure-7c.png)", spheres)
        self.assertIn("**Figure 5.** Cutting simulation: (a) Sphere 20: time step 0.005 s, auto it",
                      spheres)
        for other in ("**Figure 6.**", "figure-5b", "**Figure 2.**"):
            self.assertNotIn(other, spheres)
        banana = paper_report.report([result_of("banana")], None, False)
        self.assertIn("](figures/figure-8b.png)", banana)
        self.assertNotIn("**Figure 5.**", banana)

    def test_says_that_volume_is_held_by_a_constraint(self):
        octopus = [result_of("octopus")]
        own = paper_report.differences(octopus, False)
        self.assertIn("a constraint of its own", own)
        self.assertIn("100.00 % where the paper has 91.1 %: a constraint", own)
        self.assertNotIn("a constraint of its own", paper_report.differences(octopus, True))

    def test_says_why_a_figure_is_far_from_the_papers(self):
        self.assertNotIn("far from the paper's",
                         paper_report.differences([result_of("sphere20", 0.996)], False))
        slow = result_of("sphere20", 0.9, fps=same(22.7))
        far = paper_report.differences([slow], False)
        self.assertIn("22.7 frames a second are 0.13 of the paper's 172.1", far)
        self.assertIn("falls to 90.0 % where the paper speaks of negligible change", far)

    def test_says_which_stage_takes_the_time(self):
        self.assertIn("the other way round",
                      paper_report.differences([result_of("sphere20")], False))
        cutting = result_of("sphere20")
        cutting.summary["stages_ms"]["cut"] = same(50)
        self.assertIn("So it is here.", paper_report.differences([cutting], False))

    def test_compares_the_halves_of_figure_two(self):
        summary = {"volume_ratio": {"final": 1}, "steps": 400, "remarks": []}

        def method(volume, published):
            halves = [paper.HollowRun("a.png", ratio, summary) for ratio in (volume, 1)]
            return paper_report.method([result_of("sphere768")], halves, published)

        self.assertIn("As in the paper, the halves collapse", method(0.44, False))
        self.assertIn("(a): the volume is 44.00 % in the picture", method(0.44, False))
        self.assertIn("the bends of plain PBD hold the skin up alone", method(0.96, True))

    def test_lists_every_setting(self):
        settings = paper_report.settings([result_of("octopus"), result_of("banana")], False)
        for parameter in kerf.parameters():
            self.assertIn(f"`{parameter['name']}`", settings)
        self.assertIn("| `youngs_modulus`, Pa | 300000 | 500000 |", settings)
        self.assertIn("| gravity after the cut, m/s^2 | [0, -9.81, 0] from step 120 |", settings)

    def test_compares_the_ways_to_search(self):
        sphere = result_of("sphere768")
        sphere.searches = {way: rows_of({"frame_ms": 10 + ms, "cut_ms": 1 + ms, "search_ms": ms,
                                         "search_walk_ms": ms / 2, "search_seeds": 3,
                                         "search_tests": 768})
                           for way, ms in (("tree", 0), ("adjacency", 1), ("all", 6))}
        section = paper_report.search([sphere])
        self.assertIn("| Sphere 768 | adjacency | 768 | 1.000 (1.000 to 1.000) | 0.500", section)
        self.assertIn("| Sphere 768 | 48.06 | 45.45 | 52.38 | 366.67 |", section)

    def test_counts_right_after_the_cut_and_at_the_end(self):
        sphere = result_of("sphere768",
                           before={"vertices": 386, "triangles": 768, "ispcs": 386},
                           after={"vertices": 930, "triangles": 1696, "ispcs": 880})
        self.assertIn("| 386 / 960 / 930 | 768 / 1760 / 1696 | 386 / 900 / 880 | 768 |",
                      paper_report.cutting([sphere]))

    def test_rates_have_the_spread_of_the_means_of_the_runs(self):
        sphere = result_of("sphere20")
        sphere.strokes = [rows_of({"frame_ms": ms}) for ms in (10, 20, 40)]
        self.assertIn("| Sphere 20 | 58.3 | 25.0 | 100.0 |", paper_report.performance([sphere]))

    def test_reads_buffers_and_groups_from_the_shaders(self):
        buffers = {name: rest for name, *rest in paper_report.shader_buffers()}
        self.assertEqual(buffers["Positions"][:2], ["1", "per vertex"])
        self.assertEqual(buffers["Entries"][0], "7")
        self.assertTrue(all(size and contents for _, size, contents in buffers.values()))
        self.assertEqual(paper_report.group_size(), 256)


class Sessions(unittest.TestCase):
    def test_pictures_follow_the_course_of_the_experiment(self):
        for name in PAPER:
            session = paper.paper_session(name, False)
            at = paper.moments_of(session)
            self.assertTrue(at.blade < at.lift < at.gravity < session["steps"], name)
            before, half, through, falling = paper.cutting_pictures(session)
            self.assertEqual(before.step, at.blade)
            self.assertTrue(at.blade < half.step < at.lift < through.step, name)
            self.assertGreater(falling.step, at.gravity, "the pieces fall")
            fall = paper.fall_pictures(session)
            self.assertEqual(len(fall), 3)
            self.assertGreater(fall[0].step, falling.step)
            self.assertEqual(fall[-1].step, session["steps"])

    def test_have_the_papers_solver_and_iterations_as_published_alone(self):
        own = paper.paper_session("banana", False)["params"]
        published = paper.paper_session("banana", True)["params"]
        self.assertEqual((own.get("solver"), own["iterations"]), (None, "auto"))
        self.assertEqual((published["solver"], published["iterations"]), ("pbd", 10))

    def test_a_stroke_alone_takes_no_pictures(self):
        for name in PAPER:
            session = paper.paper_session(name, False)
            pictures = paper.cutting_pictures(session)
            stroke = paper.stroke_alone(paper.with_pictures(session, pictures, 100))
            self.assertEqual(stroke["steps"], paper.moments_of(session).lift + 1)
            for event in stroke["events"]:
                self.assertLessEqual(event["step"], stroke["steps"])
                self.assertNotIn(event["type"], ("check", "screenshot"))

    def test_pictures_leave_the_session_as_it_was(self):
        session = paper.paper_session("sphere20", False)
        events = list(session["events"])
        more = paper.with_pictures(session, [Picture(3, "a.png", "")], 100)
        self.assertEqual(session["events"], events)
        self.assertEqual(len(more["events"]), len(events) + 1)

    def test_figures_have_the_papers_numbers(self):
        self.assertEqual(paper_figures.cutting_figure("sphere80").file, "figures/figure-5b.png")
        self.assertEqual(paper_figures.cutting_figure("octopus").file, "figures/figure-6a.png")
        self.assertEqual(paper_figures.fall_figure("banana").file, "figures/figure-8b.png")
        self.assertEqual(paper_figures.volume_label("banana"), "(e)")


class Hollow(unittest.TestCase):
    def events_of(self, session, kind):
        return [event for event in session["events"] if event["type"] == kind]

    def test_draws_both_lips_away_from_the_blade(self):
        for name in PAPER:
            session = paper.paper_session(name, False)
            points = kerf.Simulation.from_session(session).positions
            opened, end = hollow.hollow_session(session, points, "hollow.png", (360, 360))
            first, last = self.events_of(opened, "blade")
            a, b = np.array(first["a"]), np.array(first["b"])
            self.assertTrue(first["step"] < end < last["step"], name)
            across = np.cross(b - a, np.add(last["a"], last["b"]) - a - b)
            across /= np.linalg.norm(across)
            grabs, drags = self.events_of(opened, "grab"), self.events_of(opened, "drag")
            beside = [across @ (np.array(grab["at"]) - a) for grab in grabs]
            self.assertLess(beside[0] * beside[1], 0)
            for away, grab, drag in zip(beside, grabs, drags):
                self.assertGreater(abs(away), 0.99 * grab["radius"], "it holds one side alone")
                self.assertGreater(away * (across @ np.subtract(drag["to"], grab["at"])), 0,
                                   "it draws outwards")

    def test_needs_a_picture_of_the_cut(self):
        session = paper.paper_session("sphere20", False)
        points = np.eye(3)
        session["events"] = [e for e in session["events"] if e["type"] != "screenshot"]
        self.assertIsNone(hollow.hollow_session(session, points, "a.png", (1, 1)))
        session["events"] = []
        self.assertIsNone(hollow.hollow_session(session, points, "a.png", (1, 1)))


if __name__ == "__main__":
    unittest.main()
