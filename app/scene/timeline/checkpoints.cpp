#include "app/scene/timeline/checkpoints.h"

#include "app/scene/document/editor_document.h"

namespace kerf::app {

bool Checkpoints::wants(int step, std::size_t bytes) const {
    return step % spacing_ == 0 && !byStep_.contains(step) && fits(bytes);
}

bool Checkpoints::fits(std::size_t bytes) const {
    return byStep_.empty() || 2 * bytes <= kCheckpointBudget;
}

void Checkpoints::keep(int step, SceneCheckpoint checkpoint, std::size_t bytes) {
    byStep_.emplace(step, Kept{std::move(checkpoint), bytes});
    if (this->bytes() > kCheckpointBudget && byStep_.size() > 2) {
        thinOut();
    }
}

std::size_t Checkpoints::bytes() const {
    return std::transform_reduce(byStep_.begin(), byStep_.end(), std::size_t{0}, std::plus<>(),
                                 [](const auto& entry) { return entry.second.bytes; });
}

/// The first one stays: the session can always be played from its start.
void Checkpoints::thinOut() {
    spacing_ *= 2;
    std::erase_if(byStep_, [this](const auto& entry) { return entry.first % spacing_ != 0; });
}

int Checkpoints::stepBefore(int step, bool any) const {
    auto after = byStep_.upper_bound(step);
    while (after != byStep_.begin()) {
        const auto& [at, kept] = *--after;
        if (at < step || any || kept.checkpoint.commandsDone == 0) {
            return at;
        }
    }
    return -1;
}

void Checkpoints::changedAt(int step, std::size_t commandsDone) {
    std::erase_if(byStep_, [&](const auto& entry) {
        const auto& [at, kept] = entry;
        return at > step || (at == step && kept.checkpoint.commandsDone > commandsDone);
    });
}

}  // namespace kerf::app
