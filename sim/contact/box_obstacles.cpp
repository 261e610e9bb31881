#include "sim/contact/box_obstacles.h"

#include <algorithm>
#include <utility>

namespace kerf {

namespace {

constexpr double kDepth = 0.5;  // h
constexpr double kThin = 2;     // h

}  // namespace

ObstacleKind BoxObstacles::kind() {
    return {{}, "sim/boxes/vertices.comp", "", true, true};
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

bool BoxObstacles::mayPierce(const Bounds& bounds, double edgeLength) const {
    return std::ranges::any_of(boxes_, [&](const StaticBox& box) {
        return box.size.minCoeff() < kThin * edgeLength && box.bounds().overlaps(bounds);
    });
}

TouchDistances BoxObstacles::distances(const ContactSettings& settings, double edgeLength) const {
    const auto thickness = static_cast<float>(settings.thickness * edgeLength);
    return {thickness, static_cast<float>(kDepth * edgeLength) + thickness};
}

}  // namespace kerf
