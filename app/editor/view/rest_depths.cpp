#include "app/editor/view/rest_depths.h"

namespace kerf::app {

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
