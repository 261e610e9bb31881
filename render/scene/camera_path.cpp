#include "render/scene/camera_path.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace kerf::render {
namespace {

/// Columns: right, up, back.
Eigen::Quaterniond orientationOf(const Camera& camera) {
    const Eigen::Matrix3d turn = camera.view().topLeftCorner<3, 3>().cast<double>().transpose();
    return Eigen::Quaterniond(turn).normalized();
}

double distanceOf(const Camera& camera) {
    return std::max((camera.eye - camera.target).norm(), 1e-9);
}

}  // namespace

Camera between(const Camera& from, const Camera& to, double share) {
    const Eigen::Matrix3d turn =
        orientationOf(from).slerp(share, orientationOf(to)).toRotationMatrix();
    const double distance = distanceOf(from) * std::pow(distanceOf(to) / distanceOf(from), share);
    Camera camera = to;
    camera.target = from.target + share * (to.target - from.target);
    camera.eye = camera.target + distance * turn.col(2);
    camera.up = turn.col(1);
    camera.fovY = from.fovY + share * (to.fovY - from.fovY);
    return camera;
}

double eased(double share) {
    return share * share * (3 - 2 * share);
}

CameraPath::CameraPath(std::vector<CameraKey> keys) : keys_(std::move(keys)) {}

Camera CameraPath::at(double moment) const {
    const auto next = std::ranges::upper_bound(keys_, moment, {}, &CameraKey::at);
    if (next == keys_.begin()) {
        return next->camera;
    }
    const CameraKey& last = *std::prev(next);
    if (next == keys_.end()) {
        return last.camera;
    }
    return between(last.camera, next->camera, eased((moment - last.at) / (next->at - last.at)));
}

}  // namespace kerf::render
