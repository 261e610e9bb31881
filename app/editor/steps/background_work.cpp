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

}  // namespace kerf::app
