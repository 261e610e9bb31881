"""Finite elements: their meshes, their material, and solids at rest, beside theory."""

import unittest

import numpy as np
from lab import bodies, fem_solid
from lab.fem_solid import Solid, lines_through, solid_ball, solid_box

MODULUS = 1e5
LINES = [lines_through(-0.2, -0.05, 0.2, 2), np.linspace(-0.1, 0.1, 5), np.linspace(-0.1, 0.1, 5)]


def box(size, cells, slit=None):
    return solid_box([np.linspace(-s / 2, s / 2, n + 1) for s, n in zip(size, cells)], slit)


def solid_of(mesh, poisson_ratio, held, load=(0, 0, 0), moved_to=None, load_steps=1):
    """`held`: by node or by node and axis. `moved_to`: where what is held goes."""
    held = held if held.ndim == 2 else np.stack([held] * 3, axis=1)
    moved = np.zeros_like(mesh.nodes) if moved_to is None else moved_to - mesh.nodes
    return Solid(mesh, MODULUS, poisson_ratio, np.array(load, float), held, moved, load_steps)


def end_of(mesh, x):
    return mesh.nodes[:, 0] == x


class Meshes(unittest.TestCase):
    def expect_closed(self, mesh, volume):
        skin = mesh.skin()
        sides = {tuple(t[[i, (i + 1) % 3]]) for t in skin for i in range(3)}
        self.assertEqual(len(sides), 3 * len(skin))
        self.assertEqual({side[::-1] for side in sides}, sides)
        self.assertAlmostEqual(bodies.volume(mesh.nodes, skin), volume, places=13)

    def test_grid_lines_go_through_the_middle_one_in_even_steps(self):
        lines = lines_through(-0.2, -0.05, 0.2, 3)
        self.assertEqual((len(lines), lines[0], lines[3], lines[-1]), (9, -0.2, -0.05, 0.2))

    def test_a_box_has_a_closed_skin_around_its_volume(self):
        mesh = solid_box(LINES)
        self.assertEqual(len(mesh.tetrahedra), 5 * 4 * 4 * 6)
        self.assertEqual(len(mesh.nodes), 11 * 9 * 9)
        self.expect_closed(mesh, 0.4 * 0.2 * 0.2)

    def test_a_slit_opens_the_skin_and_takes_no_volume(self):
        mesh = solid_box(LINES, (-0.05, 0, 1))
        # Above its bottom, nodes of 4 of 8 rows and all 9 columns are there twice.
        self.assertEqual(len(mesh.nodes), 11 * 9 * 9 + 4 * 9)
        self.assertEqual(len(mesh.skin()), len(solid_box(LINES).skin()) + 2 * 4 * 2 * 4 * 2)
        self.expect_closed(mesh, 0.4 * 0.2 * 0.2)

    def test_elements_belong_to_one_side_of_a_slit(self):
        mesh = solid_box(LINES, (-0.05, 0, 0.1))
        _, place, count = np.unique(mesh.nodes, axis=0, return_inverse=True, return_counts=True)
        twice = count[place.ravel()] == 2
        self.assertTrue((mesh.nodes[twice, 1] > 0).all())
        behind = mesh.nodes[mesh.tetrahedra[:, :4], 0].mean(axis=1) > -0.05
        sides = [set(mesh.tetrahedra[own].ravel()) for own in (behind, ~behind)]
        self.assertFalse(sides[0] & sides[1] & set(np.flatnonzero(twice)))

    def test_a_ball_is_round_and_its_half_is_half_of_it(self):
        ball, half = solid_ball(0.5, 4, 3, False), solid_ball(0.5, 4, 3, True)
        self.assertEqual(len(ball.skin()), 8 * 16 * 4)
        volume = bodies.volume(ball.nodes, ball.skin())
        self.expect_closed(ball, volume)
        self.expect_closed(half, volume / 2)
        self.assertAlmostEqual(volume / (4 / 3 * np.pi * 0.125), 1, delta=0.1)
        self.assertAlmostEqual(np.linalg.norm(ball.nodes, axis=1).max(), 0.5)
        self.assertGreaterEqual(half.nodes[:, 0].min(), 0)


class Material(unittest.TestCase):
    """On one cell, stretched, sheared, and with a part that is inside out."""

    def setUp(self):
        mesh = box((1, 1, 1), (1, 1, 1))
        self.solid = solid_of(mesh, 0.45, np.zeros(len(mesh.nodes), bool))
        self.rest = mesh.nodes

    def deformed(self):
        sheared = np.array([[1.2, 0.3, -0.1], [0.05, 0.8, 0.2], [-0.2, 0.1, 1.1]])
        bumps = 0.05 * np.sin(np.arange(self.rest.size).reshape(-1, 3))
        for f in (np.eye(3), sheared, sheared @ np.diag([1, 1, -0.7])):
            yield self.rest @ f.T + bumps

    def slope(self, function, positions, i, step=1e-6):
        change = np.zeros(positions.size)
        change[i] = step
        change = change.reshape(-1, 3)
        return (function(positions + change) - function(positions - change)) / (2 * step)

    def test_forces_are_the_slope_of_the_energy(self):
        for positions in self.deformed():
            forces = self.solid.forces(positions, 1).ravel()
            for i in range(0, positions.size, 7):
                slope = self.slope(self.solid.elastic_energy, positions, i)
                self.assertAlmostEqual(-forces[i], slope, delta=1e-3)

    def test_stiffness_is_the_slope_of_the_forces(self):
        for positions in self.deformed():
            matrix = self.solid.stiffness(positions).toarray()
            self.assertLess(abs(matrix - matrix.T).max(), 1e-9 * abs(matrix).max())
            for i in range(0, positions.size, 7):
                slope = self.slope(lambda at: self.solid.forces(at, 1), positions, i)
                self.assertLess(abs(matrix[:, i] + slope.ravel()).max(), 1e-3)

    def test_rests_undeformed_and_does_not_feel_turns(self):
        self.assertAlmostEqual(self.solid.elastic_energy(self.rest), 0, places=9)
        self.assertLess(abs(self.solid.forces(self.rest, 1)).max(), 1e-9)
        turn = np.linalg.qr(np.array([[1, 2, -1], [0, 1, 3], [2, 0, 1]]))[0]
        turn *= np.sign(np.linalg.det(turn))
        for positions in self.deformed():
            energy = self.solid.elastic_energy(positions)
            self.assertAlmostEqual(self.solid.elastic_energy(positions @ turn.T) / energy, 1)

    def test_obeys_hookes_law_where_strains_are_small(self):
        """Forces on the faces of a unit cube are its stresses."""
        strain, nu = 1e-7, 0.45

        def force_on(axis, f):
            forces = self.solid.forces(self.rest @ f.T, 1)
            return -forces[self.rest[:, axis] == 0.5].sum(axis=0)

        stretched = np.eye(3) + strain * np.diag([1, -nu, -nu])
        bound = 1e-5 * MODULUS * strain
        self.assertAlmostEqual(force_on(0, stretched)[0], MODULUS * strain, delta=bound)
        self.assertAlmostEqual(force_on(1, stretched)[1], 0, delta=bound)
        sheared = np.eye(3)
        sheared[0, 1] = strain
        self.assertAlmostEqual(force_on(1, sheared)[0], MODULUS / 2.9 * strain, delta=bound)


class Rest(unittest.TestCase):
    def test_deforms_evenly_where_the_border_does(self):
        """The patch test: large or small."""
        f = np.array([[1.3, 0.4, 0], [-0.1, 0.8, 0.2], [0.1, 0, 1.1]])
        mesh = box((0.3, 0.2, 0.2), (3, 2, 2))
        border = (abs(mesh.nodes) - [0.15, 0.1, 0.1]).max(axis=1) > -1e-12
        for poisson_ratio in (0, 0.3, 0.49):
            rest = solid_of(mesh, poisson_ratio, border, moved_to=mesh.nodes @ f.T).relaxed()
            self.assertLess(abs(rest - mesh.nodes @ f.T).max(), 1e-9)
            self.assertAlmostEqual(bodies.volume(rest, mesh.skin()),
                                   0.3 * 0.2 * 0.2 * np.linalg.det(f))

    def test_narrows_where_pulled(self):
        """Evenly, so that a smaller Poisson's ratio narrows it less, and 0 not at all."""
        mesh = box((0.2, 0.1, 0.1), (2, 1, 1))
        held = np.stack([abs(mesh.nodes[:, 0]) == 0.1, mesh.nodes[:, 1] == -0.05,
                         mesh.nodes[:, 2] == -0.05], axis=1)
        narrow = []
        for poisson_ratio in (1e-9, 0.3, 0.45):
            stretched = mesh.nodes * [1.0001, 1, 1]
            rest = solid_of(mesh, poisson_ratio, held, moved_to=stretched).relaxed()
            change = (rest - mesh.nodes)[mesh.nodes[:, 1] == 0.05, 1]
            self.assertLess(np.ptp(change), 1e-12)
            narrow.append(-change.mean() / 0.1 / 0.0001)
        np.testing.assert_allclose(narrow, [0, 0.3, 0.45], atol=1e-3)

    def test_grows_longer_under_its_own_weight(self):
        mesh = box((0.4, 0.1, 0.1), (4, 1, 1))
        rest = solid_of(mesh, 0, end_of(mesh, 0.2), (-10, 0, 0)).relaxed()
        theory = 10 * 0.4**2 / (2 * MODULUS)
        self.assertAlmostEqual((-0.2 - rest[:, 0].min()) / theory, 1, delta=1e-3)

    def cantilever(self, cells, poisson_ratio, weight=10, load_steps=1):
        """How far the end of a bar that is clamped at the other one comes down."""
        mesh = box((0.4, 0.1, 0.1), (4 * cells, cells, cells))
        solid = solid_of(mesh, poisson_ratio, end_of(mesh, -0.2), (0, -weight, 0),
                         load_steps=load_steps)
        return (mesh.nodes - solid.relaxed())[end_of(mesh, 0.2), 1].mean()

    def over_timoshenko(self, cells, poisson_ratio):
        load = 10 * 0.1 * 0.1  # [N/m]
        bending = load * 0.4**4 / (8 * MODULUS * 0.1**4 / 12)
        shearing = load * 0.4**2 / 2 / (MODULUS / (2 * (1 + poisson_ratio)) * 0.01 * 5 / 6)
        return self.cantilever(cells, poisson_ratio) / (bending + shearing)

    def test_a_bar_bends_as_timoshenko_says(self):
        self.assertAlmostEqual(self.over_timoshenko(1, 0), 1, delta=0.03)
        self.assertAlmostEqual(self.over_timoshenko(2, 0), 1, delta=0.01)

    def test_does_not_lock_where_volume_is_nearly_kept(self):
        """Linear tetrahedra would lock and give way by a fraction of that."""
        for poisson_ratio in (0.3, 0.45, 0.49):
            coarse, fine = (self.over_timoshenko(cells, poisson_ratio) for cells in (1, 2))
            self.assertGreater(fine, coarse)
            self.assertTrue(0.86 < fine < 1, poisson_ratio)

    def test_turns_with_what_holds_it_without_strain(self):
        mesh = box((0.2, 0.1, 0.1), (2, 1, 1))
        turn = np.array([[0.36, 0.48, -0.8], [-0.8, 0.6, 0], [0.48, 0.64, 0.6]])
        solid = solid_of(mesh, 0.45, end_of(mesh, -0.1), moved_to=mesh.nodes @ turn.T)
        rest = solid.relaxed()
        self.assertLess(abs(rest - mesh.nodes @ turn.T).max(), 1e-6)
        self.assertLess(solid.elastic_energy(rest), 1e-9)

    def test_comes_to_rest_far_from_where_it_was(self):
        """A load that bends the bar far down, at once and in steps."""
        at_once, in_steps = (self.cantilever(1, 0.45, 9810, steps) for steps in (1, 4))
        self.assertGreater(at_once, 0.1)
        self.assertAlmostEqual(in_steps, at_once, delta=1e-7)

    def notch_over_theory(self, rows):
        """What a notch half through a bar adds to its sag, over what fracture mechanics says.

        It gives way by an angle of 4 sigma / E times 1.71 (Tada, Paris, Irwin: The Stress Analysis
        of Cracks Handbook, single edge crack in bending).
        """
        def sag(slit):
            mesh = box((0.8, 0.1, 0.025), (4 * rows, rows, 1), slit)
            rest = solid_of(mesh, 0, end_of(mesh, -0.4), (0, -1, 0)).relaxed()
            return (mesh.nodes - rest)[end_of(mesh, 0.4), 1].mean()

        arm = 0.6  # from the notch to the end
        moment = 0.1 * 0.025 * arm**2 / 2
        theory = 4 * 6 * moment / (0.1**2 * 0.025) / MODULUS * 1.71 * arm
        return (sag((-0.2, 0, 1)) - sag(None)) / theory

    def test_a_notch_gives_way_as_fracture_mechanics_says(self):
        """Stresses at its front have no limit, so that comes nearer with the cells alone."""
        coarse, fine = self.notch_over_theory(4), self.notch_over_theory(8)
        self.assertGreater(fine, coarse + 0.05)
        self.assertAlmostEqual(fine, 1, delta=0.12)

    def test_refuses_a_solid_that_can_move_freely(self):
        mesh = box((0.1, 0.1, 0.1), (1, 1, 1))
        for corners in (0, 1):  # it can turn about one
            held = np.arange(len(mesh.nodes)) < corners
            with self.assertRaises(ArithmeticError):
                solid_of(mesh, 0.3, held).relaxed()

    def test_a_tangent_that_is_not_definite_is_raised(self):
        matrix = fem_solid.sparse.csc_matrix(np.array([[1.0, 2], [2, 1]]))
        way = fem_solid.downhill(matrix, np.array([1.0, -1]))
        self.assertGreater(way @ [1, -1], 0, "downhill")


if __name__ == "__main__":
    unittest.main()
