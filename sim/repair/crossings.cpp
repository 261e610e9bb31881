#include "sim/repair/crossings.h"

#include <Eigen/Eigenvalues>

#include "sim/base/containers.h"
#include "sim/base/math.h"
#include "sim/mesh/box_tree.h"
#include "sim/repair/soup_editing.h"
#include "sim/repair/surface_contact.h"

namespace kerf::repair {

namespace {

// Beyond so many pairs a model is called crossing through and through.
constexpr std::size_t kMostCounted = 1'000'000;
// Of the squared edges: a surface is stretched as if it were no flatter.
constexpr double kFlat = 1e-12;
constexpr double kStretchedRounding = 1e-9;  // of the largest coordinate

bool haveEdgeInCommon(const Triangle& a, const Triangle& b) {
    return std::ranges::count_if(a, [&](int v) { return std::ranges::find(b, v) != b.end(); }) >= 2;
}

/// The soup stretched so that its edges are as long in all directions, on average: the tree's boxes
/// are cubes, and those of long needles would all meet.
TriangleSoup evenlyStretched(TriangleSoup soup) {
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const Triangle& t : soup.triangles) {
        for (int i = 0; i < 3; ++i) {
            const Vec3 edge = soup.positions[t[(i + 1) % 3]] - soup.positions[t[i]];
            spread += edge * edge.transpose();
        }
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread);
    const Vec3 lengths = axes.eigenvalues().cwiseMax(kFlat * axes.eigenvalues()[2]).cwiseSqrt();
    if (lengths.allFinite() && lengths[2] > 0) {
        const Eigen::Matrix3d stretch =
            lengths.cwiseInverse().asDiagonal() * axes.eigenvectors().transpose() * lengths[2];
        const Vec3 origin = soup.positions.front();
        for (Vec3& position : soup.positions) {
            position = stretch * (position - origin);
        }
    }
    return soup;
}

/// What rounding may add to or take from the box of a stretched triangle.
Bounds withRounding(const Bounds& box) {
    return widened(box, kStretchedRounding * std::max(box.low.cwiseAbs().maxCoeff(),
                                                      box.high.cwiseAbs().maxCoeff()));
}

}  // namespace

std::vector<std::pair<int, int>> findCrossings(const TriangleSoup& welded, std::size_t most,
                                               const std::vector<int>* parts) {
    std::vector<int> all(welded.triangles.size());
    std::iota(all.begin(), all.end(), 0);
    const TriangleSoup stretched = evenlyStretched(welded);
    const BoxTree::BoundsOf bounds = [&](int t) { return withRounding(boundsOf(stretched, t)); };
    BoxTree tree(all, bounds);
    const SurfaceContact contact(welded);
    const auto cross = [&](int a, int b) {
        return (parts == nullptr || (*parts)[a] != (*parts)[b]) &&
               !haveEdgeInCommon(welded.triangles[a], welded.triangles[b]) && contact.crosses(a, b);
    };
    std::vector<std::pair<int, int>> pairs;
    for (const int t : all) {
        const Bounds own = boundsOf(welded, t);
        const Bounds ownStretched = bounds(t);
        const auto overlaps = [&](const Bounds& box) { return box.overlaps(ownStretched); };
        tree.find(bounds, overlaps, [&](int other) {
            if (other > t && own.overlaps(boundsOf(welded, other)) && cross(t, other)) {
                pairs.emplace_back(t, other);
            }
        });
        if (pairs.size() >= most) {
            break;
        }
    }
    std::ranges::sort(pairs);
    pairs.resize(std::min(pairs.size(), most));
    return pairs;
}

std::vector<int> crossingTriangles(const TriangleSoup& welded) {
    std::vector<int> crossing;
    for (const auto& [a, b] : findCrossings(welded, kMostCounted)) {
        crossing.push_back(a);
        crossing.push_back(b);
    }
    sortUnique(crossing);
    return crossing;
}

}  // namespace kerf::repair
