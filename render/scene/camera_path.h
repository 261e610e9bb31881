#pragma once

#include <vector>

#include "render/scene/camera.h"

namespace kerf::render {

/// The view between two others, `share` 0 to 1: turned the short way, the distance in equal ratios.
Camera between(const Camera& from, const Camera& to, double share);
/// The share 0 to 1 of a way that has been gone at a share of its time: it starts and ends gently.
double eased(double share);

/// Where a camera is at a moment [steps].
struct CameraKey {
    double at = 0;
    Camera camera;
};

/// The way of a camera through its keys. It rests at each of them, and stands still before the
/// first one and behind the last one.
class CameraPath {
  public:
    CameraPath() = default;
    /// Keys by their moments; of several at one moment the last counts.
    explicit CameraPath(std::vector<CameraKey> keys);

    /// Without keys there is no camera.
    bool empty() const { return keys_.empty(); }
    /// The camera at a moment [steps]. Needs a key.
    Camera at(double moment) const;

  private:
    std::vector<CameraKey> keys_;
};

}  // namespace kerf::render
