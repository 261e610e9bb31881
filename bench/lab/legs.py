"""The energy that legs store while hands pull them apart, by finite elements: a slit sheet."""

import numpy as np
import scipy.sparse as sparse
from scipy.interpolate import CubicSpline

from .fem_cases import POISSON_RATIO
from .fem_solid import Solid, solid_box

# In widths of a leg, whose modulus is 1.
CELL = 0.5  # of quadratic elements; one lies through the thickness
LONGER = (0.5, 1, 1.5, 2)  # slits than the first one
FURTHER = 1  # the hands in a step, of the opening at which it was to tear
MOST_STEPS = 40


class SprungSolid(Solid):
    """A free solid whose nodes are pulled by springs."""

    def __init__(self, mesh):
        none = np.zeros_like(mesh.nodes)
        super().__init__(mesh, 1, POISSON_RATIO, np.zeros(3), none > 0, none)
        self.springs = np.zeros((len(mesh.nodes), 1))
        self.goals = mesh.nodes

    def sprung_energy(self, positions):
        return (self.springs * (positions - self.goals)**2).sum() / 2

    def elastic_energy(self, positions):
        return super().elastic_energy(positions) + self.sprung_energy(positions)

    def forces(self, positions, share):
        return super().forces(positions, share) - self.springs * (positions - self.goals)

    def stiffness(self, positions):
        return super().stiffness(positions) + sparse.diags(np.repeat(self.springs, 3), format="csc")

    def scale(self, forces, share):
        return np.linalg.norm(self.springs * (self.mesh.nodes - self.goals))


class StoredEnergy:
    """Of a specimen with two legs, by the opening and the length of its slit."""

    def __init__(self, specimen):
        self.unit = specimen.material.modulus * specimen.height**3
        self.height = specimen.height
        self.lengths = [specimen.LEGS + more for more in LONGER]
        self.curves = [CubicSpline(*curve_of(specimen, length)) for length in self.lengths]

    def __call__(self, opening, length):
        """[J] at an opening [m], with a slit of this length in widths of a leg."""
        energies = [curve(opening / self.height / length) for curve in self.curves]
        return self.unit * float(CubicSpline(self.lengths, energies)(length))


def curve_of(specimen, length):
    """Openings over the length of the slit, and the energies without those of the hands."""
    solid, hands = solid_of(specimen, length)
    rest = positions = solid.mesh.nodes
    further = FURTHER * specimen.opening / specimen.height
    openings, energies = [0], [0]
    for step in range(1, MOST_STEPS):
        solid.goals = rest + step * further * hands
        positions = solid.balanced(positions, 0)
        ways = 2 * ((positions - rest) * hands).sum(axis=1)[np.any(hands, axis=1)]
        openings.append(2 * ways.mean() / length)
        energies.append(solid.elastic_energy(positions) - solid.sprung_energy(positions))
        force = (solid.springs * (solid.goals - positions) * hands).sum()
        if force > specimen.most_force:
            break
    return openings, energies


def solid_of(specimen, length):
    """A sheet with a slit of this length, and the way of its nodes for a hand's unit of opening.

    Along its first axis lie the legs side by side, along the second one it is long.
    """
    half, thickness = specimen.LENGTH / 2, specimen.thickness / specimen.height
    mesh = solid_box([grid(2), grid(specimen.LENGTH), np.array([-thickness, thickness]) / 2],
                     (0, half - length, thickness))
    solid, hands = SprungSolid(mesh), np.zeros_like(mesh.nodes)
    share = np.zeros(len(mesh.nodes))
    np.add.at(share, mesh.tetrahedra, solid.volumes.sum(axis=1)[:, None] / 10)
    for side in (1, -1):
        held = np.linalg.norm(mesh.nodes - [side / 2, half, 0], axis=1) <= specimen.REACH
        hands[held] = side * specimen.across[[1, 0, 2]] / 2
        solid.springs[held, 0] = specimen.hand_stiffness * share[held]
    return solid, hands


def grid(length):
    return np.linspace(-length / 2, length / 2, round(length / CELL) + 1)
