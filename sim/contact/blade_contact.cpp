#include "sim/contact/blade_contact.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "shaders/shared/blade_records.h"

namespace kerf {

namespace {

static_assert(sizeof(shared::BladeRecord) == 112);

// Of what lies behind the front: the box that stands for the blade begins no farther back.
constexpr double kLongestBevel = 0.8;

/// y where the box begins whose corners and edges meet triangles.
double shoulderOf(const BladeMotion& motion) {
    return motion.front + std::min(motion.bevel, kLongestBevel * (motion.back - motion.front));
}

Vec3 turnBetween(const BladeFrame& from, const BladeFrame& to) {
    const Eigen::AngleAxisd turn(Eigen::Matrix3d(to.axes * from.axes.transpose()));
    return turn.angle() * turn.axis();
}

shared::BladeRecord recordOf(const BladeMotion& motion, std::size_t substep) {
    const BladeFrame& from = motion.frames[substep];
    const BladeFrame& to = motion.frames[substep + 1];
    const double shoulder = shoulderOf(motion);
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

void BladeContact::setMotion(std::optional<BladeMotion> motion) {
    motion_ = std::move(motion);
    if (motion_ && !kernels_) {
        kernels_.emplace(Kernels{BoxTouches(gpu::Defines{{"BLADE", "1"}}),
                                 gpu::Program::compute("sim/boxes/blade.comp")});
    }
}

void BladeContact::beginStep(const BodyReach& reach) {
    reached_ = motion_ && motion_->bounds().overlaps(boundsInStep(reach, settings_));
    if (!reached_) {
        return;
    }
    std::vector<shared::BladeRecord> records;
    for (std::size_t i = 0; i + 1 < motion_->frames.size(); ++i) {
        records.push_back(recordOf(*motion_, i));
    }
    blades_.assign(records);
    kernels_->touches.resize(body_);
    shared::BoxUniforms uniforms = boxUniforms(settings_, body_, 1);
    uniforms.depth = static_cast<float>(motion_->halfThickness);
    kernels_->touches.setUniforms(uniforms);
}

void BladeContact::respond(int substep) {
    if (!reached_) {
        return;
    }
    kernels_->touches.bind(body_, blades_);
    body_.incidenceRanges->bindStorage(shared::kBladeRangesBinding);
    body_.incidence->bindStorage(shared::kBladeIncidenceBinding);
    const auto index = static_cast<std::uint32_t>(substep);
    kernels_->touches.triangles().set("substep", index);
    kernels_->vertices.set("substep", index);
    kernels_->touches.solve(body_);
    runOver(kernels_->vertices, body_.vertexCount);
}

}  // namespace kerf
