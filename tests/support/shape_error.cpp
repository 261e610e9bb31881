#include "tests/support/shape_error.h"

#include "sim/body/rest_geometry.h"

namespace kerf::test {

namespace {

Vec3 mean(const std::vector<Vec3>& points, std::span<const int> subset) {
    Vec3 sum = Vec3::Zero();
    for (const int v : subset) {
        sum += points[v];
    }
    return sum / static_cast<double>(subset.size());
}

}  // namespace

double rmsShapeError(const std::vector<Vec3>& rest, const std::vector<Vec3>& current,
                     std::span<const int> subset) {
    if (subset.empty()) {
        return 0;
    }
    const Vec3 restMean = mean(rest, subset);
    const Vec3 currentMean = mean(current, subset);
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for (const int v : subset) {
        covariance += (current[v] - currentMean) * (rest[v] - restMean).transpose();
    }
    const Eigen::Matrix3d rotation = bestRotation(covariance);
    double sum = 0;
    for (const int v : subset) {
        sum += (current[v] - currentMean - rotation * (rest[v] - restMean)).squaredNorm();
    }
    return std::sqrt(sum / static_cast<double>(subset.size()));
}

}  // namespace kerf::test
