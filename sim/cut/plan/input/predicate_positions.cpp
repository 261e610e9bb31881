#include "sim/cut/plan/input/predicate_positions.h"

#include "sim/cut/wall_copies.h"

namespace kerf::cut {

PredicatePositions::PredicatePositions(const StepInput& in)
    : mesh_(in.mesh),
      opening_(!in.opening.empty() ? &in.opening : nullptr),
      closeDistance_(in.attempt.closing * in.h) {}

Vec3 PredicatePositions::at(int v) const {
    if (!pins_.empty()) {
        const auto pin = pins_.find(v);
        if (pin != pins_.end()) {
            return pin->second;
        }
    }
    return withoutPins(v);
}

void PredicatePositions::pinAside(int v, const Vec3& way) {
    asideFrom_[v] = at(v);
    pin(v, at(v) + way);
    asideReach_ = std::max(asideReach_, way.norm());
}

Vec3 PredicatePositions::inStrip(int v) const {
    const auto from = asideFrom_.find(v);
    return from == asideFrom_.end() ? at(v) : from->second;
}

Vec3 PredicatePositions::withoutPins(int v) const {
    const Vec3 position = commonPosition(mesh_, v, closeDistance_);
    return opening_ == nullptr ? position : Vec3(position + opening_->displacement(v));
}

}  // namespace kerf::cut
