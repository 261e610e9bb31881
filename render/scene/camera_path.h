#pragma once

#include <vector>

#include "render/scene/camera.h"

namespace kerf::render {

/// The view between two others, `share` 0 to 1: turned the short way, at geometric distances.
Camera between(const Camera& from, const Camera& to, double share);
/// Smooth easing: the share of the path at a share of the time, 0 to 1.
double eased(double share);

/// A camera at a time [steps].
struct CameraKey {
    double at = 0;
    Camera camera;
};

/// The path of a camera through its keys. It rests at each, and does not move before the first and
/// after the last.
class CameraPath {
  public:
    CameraPath() = default;
    /// Keys by time; the last of several at one time counts.
    explicit CameraPath(std::vector<CameraKey> keys);

    /// Whether there are no keys, and so no camera.
    bool empty() const { return keys_.empty(); }
    /// The camera at a time [steps]. Needs a key.
    Camera at(double moment) const;

  private:
    std::vector<CameraKey> keys_;
};

}  // namespace kerf::render
