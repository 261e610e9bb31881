#include "tests/support/folds.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/body/constraint_builder.h"
#include "sim/body/dihedral.h"

namespace kerf::test {

namespace {

constexpr double kFold = std::numbers::pi / 2;

double angleBetween(const std::vector<Vec3>& at, const shared::BendConstraint& bend) {
    const Vec3& x0 = at[bend.v0];
    const Dihedral<double> now =
        dihedral<double>(at[bend.v1] - x0, at[bend.v2] - x0, at[bend.v3] - x0);
    return now.valid ? now.angle : bend.rest_angle;
}

}  // namespace

int foldedEdges(const SurfaceMesh& mesh, const std::vector<std::uint32_t>& pinned) {
    const auto holds = [&](std::uint32_t v) { return std::ranges::binary_search(pinned, v); };
    int folds = 0;
    for (const shared::BendConstraint& bend : buildBends(mesh, 1)) {
        const double change = wrapAngle(angleBetween(mesh.positions(), bend) - bend.rest_angle);
        folds += std::fabs(change) > kFold && !holds(bend.v0) && !holds(bend.v1);
    }
    return folds;
}

}  // namespace kerf::test
