#include "sim/contact/box_obstacles.h"

#include <utility>

namespace kerf {

namespace {

constexpr double kDepth = 0.5;  // h

}  // namespace

ObstacleKind BoxObstacles::kind() {
    return {{}, "sim/boxes/vertices.comp", true};
}

std::unique_ptr<const Obstacles> BoxObstacles::of(std::vector<StaticBox> boxes) {
    return boxes.empty() ? nullptr : std::make_unique<BoxObstacles>(std::move(boxes));
}

std::size_t BoxObstacles::write(const Bounds& bounds, gpu::Buffer& records) const {
    std::vector<shared::BoxRecord> near;
    for (const StaticBox& box : boxes_) {
        if (box.bounds().overlaps(bounds)) {
            near.push_back(boxRecord(box.center, box.axes(), 0.5 * box.size));
        }
    }
    if (!near.empty()) {
        records.assign(near);
    }
    return near.size();
}

TouchDistances BoxObstacles::distances(const ContactSettings& settings, double edgeLength) const {
    const auto thickness = static_cast<float>(settings.thickness * edgeLength);
    return {thickness, static_cast<float>(kDepth * edgeLength) + thickness};
}

}  // namespace kerf
