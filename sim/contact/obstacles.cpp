#include "sim/contact/obstacles.h"

#include "shaders/shared/blade_records.h"

namespace kerf {

namespace {

constexpr double kDepth = 0.5;  // h
constexpr double kThin = 2;     // h

static_assert(sizeof(shared::BladeRecord) == 112);

Vec3 turnBetween(const BladeFrame& from, const BladeFrame& to) {
    const Eigen::AngleAxisd turn(Eigen::Matrix3d(to.axes * from.axes.transpose()));
    return turn.angle() * turn.axis();
}

shared::BladeRecord recordOf(const BladeMotion& motion, std::size_t substep) {
    const BladeFrame& from = motion.frames[substep];
    const BladeFrame& to = motion.frames[substep + 1];
    const double shoulder = motion.shoulder();
    const double middle = 0.5 * (shoulder + motion.back);
    const auto centerOf = [&](const BladeFrame& frame) {
        return Vec3(frame.origin + middle * frame.axes.col(1));
    };
    const Vec3 half{from.halfLength, 0.5 * (motion.back - shoulder), motion.halfAt(shoulder)};
    return {boxRecord(centerOf(from), from.axes, half),
            packed(centerOf(to) - centerOf(from), motion.front - middle),
            packed(turnBetween(from, to), motion.halfThickness),
            {static_cast<float>(motion.bevel), 0, 0, 0}};
}

}  // namespace

static_assert(sizeof(shared::BoxRecord) == 64);

shared::vec4 packed(const Vec3& v, double w) {
    return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z()),
            static_cast<float>(w)};
}

shared::BoxRecord boxRecord(const Vec3& center, const Eigen::Matrix3d& axes, const Vec3& half) {
    return {packed(center, 0), packed(axes.col(0), half.x()), packed(axes.col(1), half.y()),
            packed(axes.col(2), half.z())};
}

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

ObstacleKind BladeObstacle::kind() {
    return {
        {{"BLADE", "1"}}, "sim/boxes/blade.comp", "sim/boxes/blade_load.comp", false, false, true};
}

std::unique_ptr<const Obstacles> BladeObstacle::of(std::optional<BladeMotion> motion) {
    return motion ? std::make_unique<BladeObstacle>(std::move(*motion)) : nullptr;
}

std::size_t BladeObstacle::write(const Bounds& bounds, gpu::Buffer& records) const {
    if (!motion_.bounds().overlaps(bounds)) {
        return 0;
    }
    std::vector<shared::BladeRecord> ofSubsteps;
    for (std::size_t i = 0; i + 1 < motion_.frames.size(); ++i) {
        ofSubsteps.push_back(recordOf(motion_, i));
    }
    records.assign(ofSubsteps);
    return 1;
}

/// No thickness is kept: the walls of a cut lie close.
TouchDistances BladeObstacle::distances(const ContactSettings& /*settings*/,
                                        double /*edgeLength*/) const {
    return {0, static_cast<float>(motion_.halfThickness)};
}

}  // namespace kerf
