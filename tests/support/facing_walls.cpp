#include "tests/support/facing_walls.h"

#include <random>

#include "sim/mesh/triangle.h"
#include "tests/support/shapes.h"
#include "tests/support/step_bench.h"

namespace kerf::test {

namespace {

/// The corners of a small rectangle in a triangle, as weights.
std::array<Vec3, 4> rectangleIn(const Corners& at) {
    const Vec3 normal = areaNormal(at);
    const Vec3 along = (at[1] - at[0]).normalized();
    const Vec3 across = normal.normalized().cross(along);
    const Vec3 middle = (at[0] + at[1] + at[2]) / 3;
    const double size = 0.1 * normal.norm() / longestEdge(at);
    std::array<Vec3, 4> corners;
    for (int i = 0; i < 4; ++i) {
        const Vec3 p =
            middle + size * ((i % 2 == 0 ? 1 : -1) * along + (i < 2 ? 0.6 : -0.6) * across);
        for (int k = 0; k < 3; ++k) {
            const Vec3 part = areaNormal(p, at[(k + 1) % 3], at[(k + 2) % 3]);
            corners[i][k] = part.dot(normal) / normal.squaredNorm();
        }
    }
    return corners;
}

}  // namespace

SurfaceMesh halvedBox(double noise) {
    StepBench bench(box(), 0.3);
    bench.begin(bladeAt(1, 0.1));
    bench.cutTo(bladeAt(-1, 0.1));
    std::mt19937 random{5};
    std::uniform_real_distribution<double> uniform{-noise, noise};
    for (int v = 0; noise > 0 && v < bench.mesh.vertexCount(); ++v) {
        const Vec3 off(uniform(random), uniform(random), uniform(random));
        bench.mesh.setPosition(v, bench.mesh.position(v) + off);
    }
    return bench.mesh;
}

int copyIn(const SurfaceMesh& mesh, int t, int v) {
    for (const int corner : mesh.triangle(t)) {
        if (mesh.firstCopy(corner) == mesh.firstCopy(v)) {
            return corner;
        }
    }
    return -1;
}

int mirrorOf(const SurfaceMesh& mesh, int wall) {
    const std::vector<int> living = livingTriangles(mesh);
    const auto found = std::ranges::find_if(living, [&](int t) {
        return mesh.wallLabel(t) == (mesh.wallLabel(wall) ^ 1) &&
               std::ranges::all_of(mesh.triangle(wall),
                                   [&](int v) { return copyIn(mesh, t, v) >= 0; });
    });
    return found == living.end() ? -1 : *found;
}

std::vector<int> wallsOfPlus(const SurfaceMesh& mesh) {
    std::vector<int> walls = livingTriangles(mesh);
    std::erase_if(walls, [&](int t) { return mesh.wallLabel(t) != 0; });
    return walls;
}

DrawnCurves drawnOnBoth(const SurfaceMesh& mesh, int wall, int mirror) {
    DrawnCurves drawn(mesh);
    const Triangle& c = mesh.triangle(wall);
    const Triangle& facing = mesh.triangle(mirror);
    int strip = 0;
    const auto onBoth = [&](int u, int v, double t) {
        drawn.onEdge(u, v, t, strip);
        drawn.onEdge(copyIn(mesh, mirror, u), copyIn(mesh, mirror, v), t, strip);
        ++strip;
    };
    const auto length = [&](int i) { return (mesh.position(c[i]) - mesh.position(c[0])).norm(); };
    for (const double share : {0.3, 0.6}) {
        const double distance = share * std::min(length(1), length(2));
        onBoth(c[0], c[1], distance / length(1));
        onBoth(c[0], c[2], distance / length(2));
    }
    onBoth(c[1], c[2], 0.5);
    for (const Vec3& weights : rectangleIn(cornersOf(mesh, wall))) {
        Vec3 turned;
        for (int i = 0; i < 3; ++i) {
            turned[std::ranges::find(facing, copyIn(mesh, mirror, c[i])) - facing.begin()] =
                weights[i];
        }
        drawn.inFace(wall, weights, strip);
        drawn.inFace(mirror, turned, strip);
        ++strip;
    }
    return drawn;
}

}  // namespace kerf::test
