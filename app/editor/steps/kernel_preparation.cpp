#include "app/editor/steps/kernel_preparation.h"

#include <utility>

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
        const auto vertices = static_cast<std::size_t>(scene.simulation().report().vertices);
        warmUp_ = std::make_unique<KernelWarmUp>(scene.simulation().params(), vertices);
    } else if (!warmUp_->advance()) {
        left_ = false;  // What it has compiled stays as long as it does.
    }
}

}  // namespace kerf::app
