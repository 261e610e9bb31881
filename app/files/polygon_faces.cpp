#include "app/files/polygon_faces.h"

#include <algorithm>

#include "sim/repair/polygon_triangles.h"

namespace kerf::app {

std::vector<Triangle> trianglesOfFace(std::span<const Vec3> positions, std::span<const int> face) {
    const auto isThere = [&](int v) { return v >= 0 && std::size_t(v) < positions.size(); };
    std::vector<Triangle> triangles;
    if (face.size() > 3 && std::ranges::all_of(face, isThere)) {
        std::vector<Vec3> corners;
        for (const int v : face) {
            corners.push_back(positions[v]);
        }
        triangles = repair::triangulatePolygon(corners);
    }
    const bool fan = triangles.empty();
    for (int i = 2; fan && i < static_cast<int>(face.size()); ++i) {
        triangles.push_back({0, i - 1, i});
    }
    return triangles;
}

}  // namespace kerf::app
