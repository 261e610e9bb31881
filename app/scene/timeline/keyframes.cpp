#include "app/scene/timeline/keyframes.h"

#include "app/scene/document/editor_document.h"

namespace kerf::app {

bool Keyframes::wants(int step, std::size_t bytes) const {
    return step % spacing_ == 0 && !byStep_.contains(step) && fits(bytes);
}

bool Keyframes::fits(std::size_t bytes) const {
    return byStep_.empty() || 2 * bytes <= kKeyframeBudget;
}

void Keyframes::keep(int step, Keyframe keyframe, std::size_t bytes) {
    byStep_.emplace(step, std::move(keyframe));
    if (bytes * byStep_.size() > kKeyframeBudget && byStep_.size() > 2) {
        thinOut();
    }
}

/// The first one stays: the session can always be played from its start.
void Keyframes::thinOut() {
    spacing_ *= 2;
    std::erase_if(byStep_, [this](const auto& entry) { return entry.first % spacing_ != 0; });
}

int Keyframes::stepBefore(int step) const {
    const auto after = byStep_.upper_bound(step);
    return after == byStep_.begin() ? -1 : std::prev(after)->first;
}

const Keyframe* Keyframes::before(int step) const {
    const int found = stepBefore(step);
    return found < 0 ? nullptr : &byStep_.at(found);
}

void Keyframes::changedAt(int step, std::size_t commandsDone) {
    std::erase_if(byStep_, [&](const auto& entry) {
        const bool later = entry.first == step && entry.second.commandsDone > commandsDone;
        return entry.first > step || later;
    });
}

}  // namespace kerf::app
