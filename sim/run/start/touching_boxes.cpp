#include "sim/run/start/touching_boxes.h"

#include "sim/mesh/box_surface.h"

namespace kerf {

namespace {

constexpr float kSpeed = 1;  // of the boxes towards each other [m/s]

}  // namespace

SurfaceMesh touchingBoxes() {
    TriangleSoup all;
    for (const double height : {0.5, 1.45}) {
        const TriangleSoup box = boxSurface(Vec3::Ones(), {2, 2, 2});
        const int first = static_cast<int>(all.positions.size());
        for (const Vec3& p : box.positions) {
            all.positions.push_back(p + Vec3(0, height, 0));
        }
        for (const Triangle& t : box.triangles) {
            all.triangles.push_back({first + t[0], first + t[1], first + t[2]});
        }
    }
    return SurfaceMesh::fromTriangles(all.positions, all.triangles);
}

BodyState approachingStateOf(const SurfaceMesh& mesh) {
    BodyState state = stateOf(mesh);
    for (std::size_t v = 0; v < state.positions.size(); ++v) {
        const bool upper = v >= state.positions.size() / 2;
        state.velocities[v] = Vec3f(0, upper ? -kSpeed : kSpeed, 0);
    }
    return state;
}

Bounds approachingVelocities() {
    Bounds velocities;
    velocities.add(Vec3(0, -kSpeed, 0));
    velocities.add(Vec3(0, kSpeed, 0));
    return velocities;
}

}  // namespace kerf
