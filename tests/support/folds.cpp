#include "tests/support/folds.h"

#include "sim/body/rest_geometry.h"
#include "tests/support/shell_lists.h"

namespace kerf::test {

namespace {

constexpr double kFold = std::numbers::pi / 2;

double angleBetween(const std::vector<Vec3>& at, const BendConstraint& bend) {
    const Vec3& x0 = at[bend.v0];
    const Dihedral<double> now =
        dihedral<double>(at[bend.v1] - x0, at[bend.v2] - x0, at[bend.v3] - x0);
    return now.valid ? now.angle : bend.rest_angle;
}

}  // namespace

std::vector<Fold> foldsOf(const SurfaceMesh& mesh, const std::vector<std::uint32_t>& pinned) {
    const auto holds = [&](std::uint32_t v) { return std::ranges::binary_search(pinned, v); };
    std::vector<Fold> folds;
    for (const BendConstraint& bend : buildBends(mesh, 1)) {
        const double turn = wrapAngle(angleBetween(mesh.positions(), bend) - bend.rest_angle);
        if (std::fabs(turn) > kFold && !holds(bend.v0) && !holds(bend.v1)) {
            folds.push_back({{bend.v0, bend.v1, bend.v2, bend.v3}, turn, bend.rest_angle});
        }
    }
    return folds;
}

int foldedEdges(const SurfaceMesh& mesh, const std::vector<std::uint32_t>& pinned) {
    return static_cast<int>(foldsOf(mesh, pinned).size());
}

}  // namespace kerf::test
