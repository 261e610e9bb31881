#include "sim/cut/cleanup/placement.h"

#include <Eigen/Eigenvalues>
#include <tuple>

#include "sim/base/containers.h"
#include "sim/mesh/triangle.h"

namespace kerf::cut {

namespace {

// Directions in which the volume changes by less than this share of the most (squared) are left
// alone: they would need long ways.
constexpr double kWeakDirection = 1e-2;
constexpr double kNoDirection = 1e-12;
// Rest shapes stretched by more than this do not get longer ways.
constexpr double kMostStretch = 4;
// How much more the volume of the body counts than that of its sides where not all can be kept.
constexpr double kSumOverParts = 10;

using Solver = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>;

/// gradient . d = change
struct VolumeEquation {
    Vec3 gradient = Vec3::Zero();
    double change = 0;
};

/// Of moving the ring's vertex from `place`, with all else where `positions` has it.
VolumeEquation equationAt(const SurfaceMesh& mesh, const VertexPositions& positions,
                          const OneRing& ring, const Vec3& place) {
    VolumeEquation equation;
    for (const int t : ring.before) {
        const Triangle& c = mesh.triangle(t);
        equation.change += tetrahedronVolume(positions[c[0]] - place, positions[c[1]] - place,
                                             positions[c[2]] - place);
    }
    for (const RingTriangle& t : ring.after) {
        const auto at = std::find(t.corners.begin(), t.corners.end(), ring.vertex);
        const auto corner = at - t.corners.begin();
        equation.gradient += areaNormal(place, positions[t.corners[(corner + 1) % 3]],
                                        positions[t.corners[(corner + 2) % 3]]) /
                             6;
    }
    return equation;
}

Eigen::Matrix3d outerSum(const std::vector<Vec3>& gradients) {
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (const Vec3& g : gradients) {
        sum += g * g.transpose();
    }
    return sum;
}

Vec3 shortestSolution(const std::vector<VolumeEquation>& equations, double h) {
    std::vector<Vec3> gradients;
    Vec3 right = Vec3::Zero();
    for (const VolumeEquation& equation : equations) {
        gradients.push_back(equation.gradient);
        right += equation.gradient * equation.change;
    }
    const Solver solver(outerSum(gradients));
    const double most = solver.eigenvalues()[2];
    const double least = std::max(kWeakDirection * most, 1e-8 * h * h * h * h);
    Vec3 solution = Vec3::Zero();
    for (int k = 0; k < 3; ++k) {
        const double value = solver.eigenvalues()[k];
        if (value > least) {
            const Vec3 axis = solver.eigenvectors().col(k);
            solution += axis * (axis.dot(right) / value);
        }
    }
    return solution;
}

Vec3 shortened(const Vec3& way, double most) {
    const double length = way.norm();
    return length > most ? Vec3(way * (most / length)) : way;
}

double residual(const std::vector<VolumeEquation>& equations, const Vec3& way) {
    double sum = 0;
    for (const VolumeEquation& equation : equations) {
        sum += std::fabs(equation.change - equation.gradient.dot(way));
    }
    return sum;
}

VolumeEquation sumOf(const std::vector<VolumeEquation>& equations) {
    VolumeEquation sum;
    for (const VolumeEquation& equation : equations) {
        sum.gradient += equation.gradient;
        sum.change += equation.change;
    }
    return sum;
}

struct Displacement {
    Vec3 way = Vec3::Zero();
    double defect = 0;
};

/// Where more than two sheets meet not every piece can keep its volume; then the body does.
Displacement displaceTogether(const std::vector<VolumeEquation>& equations, double h,
                              double longest, double tolerable) {
    Displacement result;
    result.way = shortened(shortestSolution(equations, h), longest);
    result.defect = residual(equations, result.way);
    if (result.defect <= tolerable || equations.size() <= 2) {
        return result;
    }
    const VolumeEquation sum = sumOf(equations);
    const Vec3 way = shortestSolution({sum}, h);
    const double defect =
        residual(equations, way) / kSumOverParts + std::fabs(sum.change - sum.gradient.dot(way));
    if (way.norm() < longest && defect < result.defect) {
        result = {way, defect};
    }
    return result;
}

/// Whether all copies that stay, and all that go, lie at one place each.
bool isClosed(const VertexPositions& positions, const std::vector<OneRing>& rings, double h) {
    std::vector<int> staying;
    std::vector<int> going;
    for (const OneRing& ring : rings) {
        (ring.joins ? going : staying).push_back(ring.vertex);
        going.insert(going.end(), ring.merged.begin(), ring.merged.end());
    }
    return haveOnePlace(positions, staying, h) && haveOnePlace(positions, going, h);
}

/// The current or the rest shape.
struct Shape {
    VertexPositions positions;
    Vec3 OneRing::*place;
    double longestWay;  ///< [m]
    double tolerable;   ///< [m^3]
};

VolumeEquation equationIn(const Workspace& workspace, const Shape& shape, const OneRing& ring) {
    return equationAt(workspace.mesh, shape.positions, ring, ring.*shape.place);
}

/// Moves rings that share their way. Returns the volume that remains.
double placeTogether(const Workspace& workspace, const Shape& shape, std::vector<OneRing>& rings) {
    const std::vector<VolumeEquation> equations =
        mapped(rings, [&](const OneRing& ring) { return equationIn(workspace, shape, ring); });
    const Displacement together =
        displaceTogether(equations, workspace.edgeLength(), shape.longestWay, shape.tolerable);
    for (OneRing& ring : rings) {
        ring.*shape.place += together.way;
    }
    return together.defect;
}

double placeAlone(const Workspace& workspace, const Shape& shape, OneRing& ring) {
    const VolumeEquation equation = equationIn(workspace, shape, ring);
    const Vec3 way =
        shortened(shortestSolution({equation}, workspace.edgeLength()), shape.longestWay);
    ring.*shape.place += way;
    return residual({equation}, way);
}

double placeIn(const Workspace& workspace, const Shape& shape, std::vector<OneRing>& rings) {
    if (isClosed(shape.positions, rings, workspace.edgeLength())) {
        return placeTogether(workspace, shape, rings);
    }
    double defect = 0;
    for (OneRing& ring : rings) {
        defect += placeAlone(workspace, shape, ring);
    }
    return defect;
}

DeformationField fieldBetween(const Shape& from, const Shape& to, const SurfaceMesh& mesh,
                              std::span<const OneRing> rings) {
    DeformationField field(from.positions, to.positions);
    for (const OneRing& ring : rings) {
        for (const int t : ring.before) {
            field.add(mesh.triangle(t));
        }
    }
    return field;
}

Vec3 meanOf(std::span<const Vec3> ways) {
    const Vec3 sum = std::accumulate(ways.begin(), ways.end(), Vec3(Vec3::Zero()));
    return sum / static_cast<double>(ways.size());
}

/// Takes `shape` along the ways of another one, so that its own volumes ask for little and both
/// stay alike.
void follow(const Workspace& workspace, const Shape& other, const std::vector<Vec3>& ways,
            const Shape& shape, std::vector<OneRing>& rings) {
    if (isClosed(shape.positions, rings, workspace.edgeLength())) {
        const Vec3 way = fieldBetween(other, shape, workspace.mesh, rings).along(meanOf(ways));
        for (OneRing& ring : rings) {
            ring.*shape.place += shortened(way, shape.longestWay);
        }
        return;
    }
    for (std::size_t k = 0; k < rings.size(); ++k) {
        const Vec3 way = fieldBetween(other, shape, workspace.mesh, {&rings[k], 1}).along(ways[k]);
        rings[k].*shape.place += shortened(way, shape.longestWay);
    }
}

bool liesAtRest(const SurfaceMesh& mesh, const OneRing& ring) {
    return std::ranges::all_of(ring.before, [&](int t) {
        return std::ranges::all_of(mesh.triangle(t),
                                   [&](int v) { return mesh.restPosition(v) == mesh.position(v); });
    });
}

std::vector<Vec3> placesIn(const Shape& shape, const std::vector<OneRing>& rings) {
    return mapped(rings, shape.place);
}

/// How far each ring's vertex has gone from its place before.
std::vector<Vec3> waysFrom(std::vector<Vec3> places, const Shape& shape,
                           const std::vector<OneRing>& rings) {
    for (std::size_t k = 0; k < rings.size(); ++k) {
        places[k] = rings[k].*shape.place - places[k];
    }
    return places;
}

/// First in the shape that is at rest, where slits are closed and nothing is crumpled; the other
/// one follows. Returns the volumes that remain.
std::pair<double, double> placeAlike(const Workspace& workspace, const Shape& atRest,
                                     const Shape& other, std::vector<OneRing>& rings) {
    const std::vector<Vec3> before = placesIn(atRest, rings);
    const double defectAtRest = placeIn(workspace, atRest, rings);
    // Else the equations are the same, to the last bit.
    const auto liesThere = [&](const OneRing& ring) { return liesAtRest(workspace.mesh, ring); };
    if (!std::ranges::all_of(rings, liesThere)) {
        follow(workspace, atRest, waysFrom(before, atRest, rings), other, rings);
    }
    return {defectAtRest, placeIn(workspace, other, rings)};
}

}  // namespace

VolumeDefect placeByVolume(const Workspace& workspace, std::vector<OneRing>& rings) {
    const SurfaceMesh& mesh = workspace.mesh;
    const VolumeDefect tolerable = workspace.mostPerOperation();
    const double longest = workspace.mostDeviation();
    const double stretch = std::min(kMostStretch, restStretch(mesh, rings.front().vertex));
    const Shape current{VertexPositions::current(mesh), &OneRing::position, longest,
                        tolerable.current};
    const Shape rest{VertexPositions::atRest(mesh), &OneRing::rest, longest * stretch,
                     tolerable.rest};
    VolumeDefect defect;
    if (workspace.judgesAtRest()) {
        std::tie(defect.current, defect.rest) = placeAlike(workspace, current, rest, rings);
    } else {
        std::tie(defect.rest, defect.current) = placeAlike(workspace, rest, current, rings);
    }
    return defect;
}

VolumeDefect volumeDefect(const SurfaceMesh& mesh, const std::vector<OneRing>& rings) {
    VolumeDefect defect;
    for (const OneRing& ring : rings) {
        defect.current +=
            std::fabs(equationAt(mesh, VertexPositions::current(mesh), ring, ring.position).change);
        defect.rest +=
            std::fabs(equationAt(mesh, VertexPositions::atRest(mesh), ring, ring.rest).change);
    }
    return defect;
}

Vec3 volumeGradient(const SurfaceMesh& mesh, const VertexPositions& positions, int vertex) {
    Vec3 gradient = Vec3::Zero();
    const Vec3& place = positions[vertex];
    mesh.forEachOutgoing(vertex, [&](int h) {
        gradient += areaNormal(place, positions[mesh.target(h)], positions[mesh.apex(h)]) / 6;
    });
    return gradient;
}

Vec3 projectOnConstantVolume(const std::vector<Vec3>& gradients, const Vec3& direction) {
    const Solver solver(outerSum(gradients));
    const double most = solver.eigenvalues()[2];
    Vec3 projected = Vec3::Zero();
    for (int k = 0; k < 3; ++k) {
        if (solver.eigenvalues()[k] <= kNoDirection * most) {
            const Vec3 axis = solver.eigenvectors().col(k);
            projected += axis * axis.dot(direction);
        }
    }
    return projected;
}

double restStretch(const SurfaceMesh& mesh, int vertex) {
    double rest = 0;
    double current = 0;
    mesh.forEachOutgoing(vertex, [&](int h) {
        rest += (mesh.restPosition(mesh.target(h)) - mesh.restPosition(vertex)).norm();
        current += (mesh.position(mesh.target(h)) - mesh.position(vertex)).norm();
    });
    return rest / std::max(current, 1e-300);
}

bool haveOnePlace(const VertexPositions& places, const std::vector<int>& vertices, double h) {
    return std::all_of(vertices.begin(), vertices.end(), [&](int v) {
        return (places[v] - places[vertices[0]]).norm() <= kCoincident * h;
    });
}

}  // namespace kerf::cut
