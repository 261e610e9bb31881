#include "sim/mesh/nearest_triangle.h"

#include <cassert>

#include "sim/base/math.h"

namespace kerf {

namespace {

constexpr double kFirstReach = 1e-6;  // of the diagonal
constexpr double kGrowth = 8;

}  // namespace

NearestTriangle::NearestTriangle(const std::vector<int>& ids, CornersOf cornersOf)
    : cornersOf_(std::move(cornersOf)), tree_(ids, [this](int id) { return boundsOf(id); }) {
    assert(!ids.empty());
}

Bounds NearestTriangle::boundsOf(int id) const {
    return boxOf(cornersOf_(id));
}

int NearestTriangle::find(const Vec3& p) {
    const double least = std::numeric_limits<double>::min();
    int found = -1;
    for (double reach = std::max(kFirstReach * tree_.bounds().diagonal(), least); found < 0;
         reach *= kGrowth) {
        found = findWithin(p, reach);
    }
    return found;
}

Vec3 NearestTriangle::closestPoint(const Vec3& p) {
    return closestOn(cornersOf_(find(p)), p);
}

/// -1 where none is within reach.
int NearestTriangle::findWithin(const Vec3& p, double reach) {
    const Bounds around = widened(Bounds{p, p}, reach);
    double least = reach;
    int found = -1;
    tree_.find([this](int id) { return boundsOf(id); },
               [&](const Bounds& box) { return box.overlaps(around); },
               [&](int id) {
                   const double distance = (closestOn(cornersOf_(id), p) - p).norm();
                   if (distance < least || (distance == least && id < found)) {
                       least = distance;
                       found = id;
                   }
               });
    return found;
}

}  // namespace kerf
