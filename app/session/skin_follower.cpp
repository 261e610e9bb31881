#include "app/session/skin_follower.h"

#include "sim/body/body_model.h"
#include "sim/run/start/prepared_body.h"

namespace kerf::app {
namespace {

bool isSkin(const std::array<std::uint32_t, 4>& triangle) {
    return (triangle[3] & 1U) == 0;  // see surfaceTag()
}

Corners restCorners(const BodyModel& model, const std::array<std::uint32_t, 4>& triangle) {
    const auto at = [&](std::size_t i) -> Vec3 {
        return model.restPositions[triangle[i]].cast<double>();
    };
    return {at(0), at(1), at(2)};
}

}  // namespace

std::shared_ptr<const render::SkinPaint> SkinFollower::paintOf(const Simulation& simulation) {
    if (!looks_.colored()) {
        return nullptr;
    }
    if (uncut_ != simulation.uncut()) {
        beginWith(simulation.uncut());
    }
    if (revision_ != simulation.modelRevision()) {
        revision_ = simulation.modelRevision();
        paint_ = std::make_shared<const render::SkinPaint>(render::paintSkin(
            follow(simulation.bodyModel()), !looks_.skin.colors.empty(), looks_.appearance));
    }
    return paint_;
}

void SkinFollower::beginWith(const std::shared_ptr<const UncutBody>& uncut) {
    uncut_ = uncut;
    carrier_.emplace(uncut_->mesh, looks_.skin);
    known_.clear();
    revision_ = -1;
}

std::vector<render::PaintedTriangle> SkinFollower::follow(const BodyModel& model) {
    std::vector<render::PaintedTriangle> skin;
    for (std::size_t i = 0; i < model.triangles.size(); ++i) {
        if (isSkin(model.triangles[i])) {
            const Corners corners = restCorners(model, model.triangles[i]);
            skin.push_back(
                {static_cast<std::uint32_t>(i), attributesOf(model.meshTriangle[i], corners)});
        }
    }
    return skin;
}

const TriangleAttributes& SkinFollower::attributesOf(int slot, const Corners& corners) {
    const auto place = static_cast<std::size_t>(slot);
    known_.resize(std::max(known_.size(), place + 1));
    std::optional<Known>& known = known_[place];
    if (!known || known->corners != corners) {
        known = Known{corners, carrier_->of(slot, corners)};
    }
    return known->attributes;
}

}  // namespace kerf::app
