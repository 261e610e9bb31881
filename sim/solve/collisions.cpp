#include "sim/solve/collisions.h"

#include "sim/solve/body_view.h"

namespace kerf {

template <class F>
void Collisions::forEachKind(F&& f) {
    f(contacts_);
    f(paperContact_);
    f(boxes_);
    f(blade_);
    f(edge_);
}

void Collisions::setBody(const BodyModel& model, bool isNew) {
    order_.follow(model, isNew);
    ContactBody body = contactBodyOf(body_);
    body.order = &order_;
    forEachKind([&](auto& kind) { kind.setBody(body, contactEdgeLength(model)); });
}

void Collisions::setSettings(const ContactSettings& settings) {
    forEachKind([&](auto& kind) { kind.setSettings(settings); });
}

void Collisions::expect(const Bounds& positions, const Bounds& velocities, RelativeMotion motion) {
    constexpr double kMargin = 0.5;  // of the diagonal
    const Vec3 fastest = velocities.low.cwiseAbs().cwiseMax(velocities.high.cwiseAbs());
    motion_ = motion;
    motion_.speed = velocities.diagonal();
    reach_ = {positions, velocities.empty() ? 0.0 : fastest.norm(), kMargin * body_.model.diagonal};
}

void Collisions::askForLoads(gpu::ReadBack& back) {
    edge_.askForLoad(back);
    blade_.askForLoad(back);
}

void Collisions::takeLoads(const gpu::ReadBack& back) {
    edge_.takeLoad(back);
    blade_.takeLoad(back);
}

void Collisions::beginStep(const gpu::Buffer* folds) {
    contacts_.beginStep(motion_);
    contacts_.setFolds(folds);
    reach_.floor =
        body_.active(shared::kFloorPart) ? body_.uniforms.floor_height : BodyReach::kNoFloor;
    boxes_.beginStep(reach_);
    blade_.beginStep(reach_);
    edge_.beginStep();
}

void Collisions::respond() {
    contacts_.respond(body_.way);
    blade_.respond();
    boxes_.respond();
}

/// It moves X past what candidates were found from.
void Collisions::respondAsThePaper() {
    contacts_.forgetCandidates();
    paperContact_.respond(static_cast<std::uint32_t>(body_.pieces.pieces().size()));
}

ContactReadings Collisions::readings() const {
    const bool paper = paperContact_.enabled();
    return {paper ? paperContact_.state() : contacts_.state(), contacts_.searchedPositions(),
            paper || contacts_.enabled()};
}

ContactMemory Collisions::memory() const {
    ContactMemory memory = contacts_.memory();
    memory.motion = motion_;
    return memory;
}

void Collisions::remember(const ContactMemory& memory) {
    contacts_.remember(memory);
    motion_ = memory.motion;
}

}  // namespace kerf
