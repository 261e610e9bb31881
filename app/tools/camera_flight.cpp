#include "app/tools/camera_flight.h"

#include <algorithm>
#include <cmath>

namespace kerf::app {
namespace {

/// Columns: right, up, back.
Eigen::Quaterniond orientationOf(const render::Camera& camera) {
    const Eigen::Matrix3d turn = camera.view().topLeftCorner<3, 3>().cast<double>().transpose();
    return Eigen::Quaterniond(turn).normalized();
}

double distanceOf(const render::Camera& camera) {
    return std::max((camera.eye - camera.target).norm(), 1e-9);
}

}  // namespace

render::Camera between(const render::Camera& from, const render::Camera& to, double share) {
    const Eigen::Matrix3d turn =
        orientationOf(from).slerp(share, orientationOf(to)).toRotationMatrix();
    const double distance = distanceOf(from) * std::pow(distanceOf(to) / distanceOf(from), share);
    render::Camera camera = to;
    camera.target = from.target + share * (to.target - from.target);
    camera.eye = camera.target + distance * turn.col(2);
    camera.up = turn.col(1);
    camera.fovY = from.fovY + share * (to.fovY - from.fovY);
    return camera;
}

void CameraFlight::start(const render::Camera& shown, const render::Camera& to) {
    way_ = Way{shown, to, 0};
}

render::Camera CameraFlight::destination(const render::Camera& shown) const {
    return way_ ? way_->to : shown;
}

bool CameraFlight::advance(render::Camera& shown, double seconds) {
    if (!way_) {
        return false;
    }
    way_->flown += seconds;
    if (way_->flown >= kSeconds) {
        land(shown);
        return true;
    }
    const double t = way_->flown / kSeconds;
    shown = between(way_->from, way_->to, t * t * (3 - 2 * t));
    return true;
}

void CameraFlight::land(render::Camera& shown) {
    if (way_) {
        shown = way_->to;
        way_.reset();
    }
}

}  // namespace kerf::app
