"""Finite elements: quadratic tetrahedra of a stable neo-Hookean solid, at rest under load."""

import dataclasses
import itertools

import numpy as np
import scipy.sparse as sparse
from scipy.sparse.linalg import splu

EDGES = np.array([[0, 1], [1, 2], [2, 0], [0, 3], [1, 3], [2, 3]])  # with a node in their middle
#: Outward: three corners, then the middles of 01, 12, 20 of these.
FACES = np.array([[0, 2, 1, 6, 5, 4], [0, 1, 3, 4, 8, 7], [1, 2, 3, 5, 9, 8], [2, 0, 3, 6, 7, 9]])
BALANCED = 1e-9  # what of the forces is not in balance where a solid rests, as a share of them
MOST_STEPS = 200  # of Newton's method
FREE_PIVOT = 1e-10  # least over largest pivot of what is held at all
SUFFICIENT = 1e-4  # share of the expected fall that a step must bring
DROWNED = 1e-9  # a fall of this share of the energy drowns in rounding
ROUNDING = 1e-13  # of energies, as a share of modulus times volume
NO_STRAIN = 1e-5  # its forces don't count
SHIFTS = (0, *10.0 ** np.arange(-6, 7))  # of the diagonal, where the tangent is indefinite


@dataclasses.dataclass
class SolidMesh:
    """A body filled with tetrahedra of ten nodes."""
    nodes: np.ndarray  #: at rest [m]
    tetrahedra: np.ndarray  #: [n, 10]: corners, then the middles of EDGES

    @classmethod
    def of(cls, nodes, tetrahedra):
        """Corners alone, in any orientation: gives each edge a node in its middle."""
        a, b, c, d = (nodes[tetrahedra[:, i]] for i in range(4))
        mirrored = np.einsum("ij,ij->i", np.cross(b - a, c - a), d - a) < 0
        tetrahedra[mirrored, 2:] = tetrahedra[mirrored, :1:-1]
        edges = np.sort(tetrahedra[:, EDGES].reshape(-1, 2), axis=1)
        edges, middle = np.unique(edges, axis=0, return_inverse=True)
        middles = nodes[edges].mean(axis=1)
        return cls(np.vstack([nodes, middles]),
                   np.hstack([tetrahedra, len(nodes) + middle.reshape(-1, 6)]))

    def faces(self):
        """Outer faces, outward: three corners, then the middles of their sides."""
        every = self.tetrahedra[:, FACES].reshape(-1, 6)
        _, first, count = np.unique(np.sort(every[:, :3], axis=1), axis=0, return_index=True,
                                    return_counts=True)
        return every[first[count == 1]]

    def skin(self):
        """Triangles, outward, four for each outer face."""
        return self.faces()[:, [[0, 3, 5], [3, 1, 4], [5, 4, 2], [3, 4, 5]]].reshape(-1, 3)


def lines_through(low, middle, high, cells):
    """Planes of a grid, with as many cells before `middle` as, of nearly that size, after it."""
    more = max(1, round(cells * (high - middle) / (middle - low)))
    return np.concatenate([np.linspace(low, middle, cells + 1),
                           np.linspace(middle, high, more + 1)[1:]])


def solid_box(lines, slit=None):
    """A box of cells of six tetrahedra each (Kuhn's) between these planes along x, y and z.

    slit: x, bottom and half width of a cut by a blade without thickness, on planes of the grid: all
    of it where y > bottom and |z| < half width. Nodes are there twice along it, so that it can
    open; no volume is taken.
    """
    nodes = np.stack(np.meshgrid(*lines, indexing="ij"), axis=-1)
    number = np.arange(nodes[..., 0].size).reshape(nodes.shape[:3])
    nodes, behind = nodes.reshape(-1, 3), number
    if slit:
        x, bottom, half = slit
        opened = np.flatnonzero((nodes[:, 0] == x) & (nodes[:, 1] > bottom + 1e-9)
                                & (abs(nodes[:, 2]) < half - 1e-9))
        behind = number.copy()  # as cells see their nodes of lower x
        behind.flat[opened] = len(nodes) + np.arange(len(opened))
        nodes = np.vstack([nodes, nodes[opened]])

    def corner(offset):
        of = (number if offset[0] else behind)
        return of[tuple(slice(o, o + n - 1) for o, n in zip(offset, number.shape))].ravel()

    kuhn = [np.stack([corner(at) for at in np.vstack([[0, 0, 0], np.eye(3, dtype=int)[list(order)]
                                                      .cumsum(axis=0)])], axis=1)
            for order in itertools.permutations(range(3))]
    return SolidMesh.of(nodes, np.vstack(kuhn))


def solid_ball(radius, rows, layers, half):
    """A ball around the origin, or the half of it where x >= 0, in layers of one thickness.

    The faces of an octahedron are divided into `rows` squared triangles each, whose corners are
    moved onto the sphere: its skin is flat between them.
    """
    numbers, nodes, tetrahedra = {}, [], []

    def node(corner, layer):
        key = (corner, layer) if layer else 0  # the middle of the ball
        if key not in numbers:
            numbers[key] = len(nodes)
            out = np.array(corner, float)
            nodes.append(out / np.linalg.norm(out) * (radius * layer / layers))
        return numbers[key]

    for face in itertools.product((1,) if half else (1, -1), (1, -1), (1, -1)):
        for triangle in triangles_of(rows):
            # Diagonals of sides start at the lowest corner, so that neighbours fit.
            corners = sorted(tuple(int(x) for x in corner * face) for corner in triangle)
            for layer in range(layers):
                for turn in range(3 if layer else 1):
                    tetrahedra.append([node(corners[n], layer) if n <= turn
                                       else node(corners[n - 1], layer + 1) for n in range(4)])
    return SolidMesh.of(np.array(nodes), np.array(tetrahedra))


def triangles_of(rows):
    """The triangles of a face of the octahedron: corners are steps along the axes."""
    for i in range(rows):
        for j in range(rows - i):
            k = rows - 1 - i - j
            yield np.array([i, j, k]) + np.eye(3, dtype=int)
            if k > 0:  # beside it, upside down
                yield np.array([i + 1, j + 1, k]) - np.eye(3, dtype=int)


@dataclasses.dataclass
class Solid:
    """A solid that is held and loaded."""
    mesh: SolidMesh
    youngs_modulus: float  #: [Pa]
    poisson_ratio: float
    load: np.ndarray  #: its weight for each volume, all around [N/m^3]
    held: np.ndarray  #: [nodes, 3] whether a node is held along an axis
    moved: np.ndarray  #: [nodes, 3] how far what is held is moved [m]
    load_steps: int = 1  #: in which loads and holds are applied, each by the same share

    def __post_init__(self):
        nu = self.poisson_ratio
        self.shear = self.youngs_modulus / (2 * (1 + nu))
        self.bulk = self.youngs_modulus * nu / ((1 + nu) * (1 - 2 * nu)) + self.shear
        weights = np.full((4, 4), (5 - np.sqrt(5)) / 20)  # four points of integration
        np.fill_diagonal(weights, (5 + 3 * np.sqrt(5)) / 20)
        along = np.vstack([[-1, -1, -1], np.eye(3)])  # derivatives of the weights
        a, b = EDGES.T
        values = np.hstack([weights * (2 * weights - 1), 4 * weights[:, a] * weights[:, b]])
        slopes = np.concatenate([(4 * weights - 1)[..., None] * along,
                                 4 * (weights[:, a, None] * along[b]
                                      + weights[:, b, None] * along[a])], axis=1)
        jacobian = np.einsum("tai,qaj->tqij", self.mesh.nodes[self.mesh.tetrahedra], slopes)
        self.volumes = np.linalg.det(jacobian) / 24
        self.gradients = np.einsum("qaj,tqji->tqai", slopes, np.linalg.inv(jacobian))
        weight = np.einsum("tq,qa,i->tai", self.volumes, values, self.load)
        self.loads = self.gathered(weight)
        self.free = np.flatnonzero(~self.held)
        unknowns = (3 * self.mesh.tetrahedra[..., None] + range(3)).reshape(-1, 30)
        self.rows = np.repeat(unknowns, 30, axis=1).ravel()
        self.columns = np.tile(unknowns, 30).ravel()

    def gathered(self, of_elements):
        """Sums of what each element gives its nodes."""
        sums = np.zeros_like(self.mesh.nodes)
        np.add.at(sums, self.mesh.tetrahedra, of_elements)
        return sums

    def strain(self, positions):
        """The deformation gradient F, its cofactors, and its determinant less 1."""
        f = np.einsum("tai,tqaj->tqij", positions[self.mesh.tetrahedra], self.gradients)
        cofactors = np.stack([np.cross(f[..., (i + 1) % 3], f[..., (i + 2) % 3])
                              for i in range(3)], axis=-1)
        return f, cofactors, (f[..., 0] * cofactors[..., 0]).sum(axis=-1) - 1

    def elastic_energy(self, positions):
        """Of Smith, de Goes, Kim (2018), without their barrier [J]."""
        f, _, growth = self.strain(positions)
        density = (self.shear / 2 * ((f**2).sum(axis=(-1, -2)) - 3) - self.shear * growth
                   + self.bulk / 2 * growth**2)
        return (self.volumes * density).sum()

    def forces(self, positions, share):
        """What pulls at each node: this share of the loads less the elastic forces [N]."""
        f, cofactors, growth = self.strain(positions)
        stress = self.shear * f + (self.bulk * growth - self.shear)[..., None, None] * cofactors
        pull = np.einsum("tq,tqij,tqaj->tai", self.volumes, stress, self.gradients)
        return share * self.loads - self.gathered(pull)

    def stiffness(self, positions):
        """The derivative of the elastic forces by the unknowns."""
        f, cofactors, growth = self.strain(positions)
        elements = np.zeros((len(f), 10, 3, 10, 3))
        for q in range(4):
            g, volume = self.gradients[:, q], self.volumes[:, q]
            elements += np.einsum("t,tai,tbi,jk->tajbk", self.shear * volume, g, g, np.eye(3),
                                  optimize=True)
            normals = np.einsum("tij,taj->tai", cofactors[:, q], g)
            elements += np.einsum("t,taj,tbk->tajbk", self.bulk * volume, normals, normals)
            turned = np.einsum("tij,tabj->tabi", f[:, q], np.cross(g[:, :, None], g[:, None]))
            turned *= (volume * (self.bulk * growth[:, q] - self.shear))[:, None, None, None]
            for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
                elements[:, :, i, :, j] += turned[..., k]
                elements[:, :, j, :, i] -= turned[..., k]
        size = self.mesh.nodes.size
        matrix = sparse.csc_matrix((elements.ravel(), (self.rows, self.columns)), (size, size))
        return matrix[self.free][:, self.free]

    def scale(self, forces, share):
        """How large the forces are that balance each other [N]."""
        least = NO_STRAIN * self.shear * self.volumes.sum()**(2 / 3)
        return np.linalg.norm(forces[self.held]) + share * np.linalg.norm(self.loads) + least

    def relaxed(self):
        """Where all nodes rest [m]: by Newton's method on the energy, with a line search.

        Raises ArithmeticError where it can move freely, or does not come to rest.
        """
        positions = self.mesh.nodes.copy()
        factors = definite_factors(self.stiffness(positions))
        pivots = factors.U.diagonal() if factors else np.zeros(1)
        if not pivots.min() > FREE_PIVOT * pivots.max():
            raise ArithmeticError("what holds the solid lets it move freely")
        for share in np.arange(1, self.load_steps + 1) / self.load_steps:
            positions[self.held] = (self.mesh.nodes + share * self.moved)[self.held]
            positions = self.balanced(positions, share)
        return positions

    def balanced(self, positions, share):
        for _ in range(MOST_STEPS):
            forces = self.forces(positions, share)
            own = forces.ravel()[self.free]
            if np.linalg.norm(own) <= BALANCED * self.scale(forces, share):
                return positions
            positions = self.advanced(positions, own, share)
        raise ArithmeticError("a solid did not come to rest")

    def advanced(self, positions, forces, share):
        """A step, shortened until the energy falls as a step downhill must let it fall."""
        way = np.zeros(positions.size)
        way[self.free] = downhill(self.stiffness(positions), forces)
        way = way.reshape(-1, 3)

        def potential(at):
            return self.elastic_energy(at) - share * (self.loads * (at - self.mesh.nodes)).sum()

        before, slope = potential(positions), forces @ way.ravel()[self.free]
        drowned = (DROWNED * self.elastic_energy(positions)
                   + ROUNDING * self.shear * self.volumes.sum())
        for part in 0.5 ** np.arange(27):
            moved = positions + part * way
            if slope < drowned or before - potential(moved) >= SUFFICIENT * part * slope:
                return moved
        raise ArithmeticError("a solid did not come to rest: no step lowers its energy")


def definite_factors(matrix):
    """The factors of a symmetric matrix; None where it is not positive definite."""
    try:
        factors = splu(matrix, permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0,
                       options={"SymmetricMode": True})
    except RuntimeError:  # it is singular
        return None
    pivots_stay = (factors.perm_r == factors.perm_c).all()
    return factors if pivots_stay and (factors.U.diagonal() > 0).all() else None


def downhill(stiffness, forces):
    """The step of Newton's method; the diagonal is raised until the tangent is definite."""
    diagonal = abs(stiffness.diagonal())
    for shift in SHIFTS:
        factors = definite_factors(stiffness + sparse.diags(shift * diagonal, format="csc"))
        if factors:
            return factors.solve(forces)
    raise ArithmeticError("a solid did not come to rest: it has no stiffness")
