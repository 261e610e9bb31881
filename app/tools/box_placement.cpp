#include "app/tools/box_placement.h"

#include <algorithm>

namespace kerf::app {

StaticBox boxBeside(const Bounds& body, std::optional<double> floor) {
    const double side = std::clamp(body.diagonal() / 3, kLeastBoxSize, kLargestBoxSize);
    const double ground = floor.value_or(body.low.y());
    StaticBox box;
    box.size = Vec3::Constant(side);
    box.center = {body.high.x() + side, ground + side / 2, body.center().z()};
    box.center = box.center.cwiseMax(-kFarthestBox).cwiseMin(kFarthestBox);
    return box;
}

}  // namespace kerf::app
