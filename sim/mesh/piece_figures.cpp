#include "sim/mesh/piece_figures.h"

#include <cmath>
#include <cstdint>
#include <vector>

#include "sim/base/boxes.h"
#include "sim/mesh/triangle.h"

namespace kerf {
namespace {

/// The triangles that are joined to some by edges, these the first.
std::vector<int> connectedTo(const SurfaceMesh& mesh, std::vector<int> found) {
    std::vector<std::uint8_t> seen(mesh.triangleSlots(), 0);
    for (const int t : found) {
        seen[t] = 1;
    }
    for (std::size_t i = 0; i < found.size(); ++i) {
        for (const int h : mesh.twins(found[i])) {
            const int next = SurfaceMesh::triangleOf(h);
            if (seen[next] == 0) {
                seen[next] = 1;
                found.push_back(next);
            }
        }
    }
    return found;
}

/// Sums of tetrahedra with their apex near the piece, which keeps the digits of small ones.
struct Solid {
    Vec3 apex;
    double volume = 0;
    Vec3 moment = Vec3::Zero();  ///< volume times the way from the apex to the middle

    void add(const Corners& c) {
        const Vec3 a = c[0] - apex;
        const Vec3 b = c[1] - apex;
        const Vec3 d = c[2] - apex;
        const double part = tetrahedronVolume(a, b, d);
        volume += part;
        moment += part * (a + b + d) / 4;
    }
};

}  // namespace

PieceFigures figuresOfPiece(const SurfaceMesh& mesh, const PieceShells& shells, int triangle) {
    PieceFigures figures;
    Solid solid{mesh.position(mesh.triangle(triangle)[0])};
    for (const int t : connectedTo(mesh, shells.shellsAround(mesh, triangle))) {
        if (!mesh.present(t)) {
            continue;
        }
        const Corners corners = cornersOf(mesh, t);
        ++figures.triangles;
        (mesh.kind(t) == SurfaceKind::wall ? figures.cutArea : figures.skinArea) +=
            triangleArea(corners);
        solid.add(corners);
        figures.bounds.add(boxOf(corners));
    }
    figures.volume = solid.volume;
    const bool hollow = !(solid.volume > 1e-9 * std::pow(figures.bounds.diagonal(), 3));
    figures.centroid =
        hollow ? figures.bounds.center() : Vec3(solid.apex + solid.moment / solid.volume);
    return figures;
}

}  // namespace kerf
