#include "app/editor/steps/background_work.h"

#include "sim/run/simulation.h"

namespace kerf::app {

namespace {

constexpr double kQuiet = 0.25;  // without input before it goes on [s]

}  // namespace

void KernelPreparation::advance(const EditorScene& scene, double elapsedSeconds) {
    quiet_ += elapsedSeconds;
    if (!left_ || quiet_ < kQuiet) {
        return;
    }
    if (std::exchange(isNew_, false)) {
        warmUp_ = std::make_unique<KernelWarmUp>(scene.simulation().params());
    } else if (!warmUp_->advance()) {
        left_ = false;  // What it has compiled stays as long as it does.
    }
}

void RestDepths::note(const std::shared_ptr<const UncutBody>& body, render::DepthField depth) {
    std::erase_if(known_, [](const auto& entry) { return entry.first.expired(); });
    known_.insert_or_assign(body, std::move(depth));
}

const render::DepthField& RestDepths::of(const std::shared_ptr<const UncutBody>& body) {
    if (!known_.contains(body)) {
        note(body, render::measureSkinDepth(body->mesh));
    }
    return known_.at(body);
}

}  // namespace kerf::app
