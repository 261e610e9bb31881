#include "app/scene/held_hands.h"

#include <algorithm>
#include <utility>

#include "app/scene/timeline/scene_timeline.h"

namespace kerf::app {
namespace {

constexpr int kSettleSteps = 60;     // for what hooks hold to arrive
constexpr double kTakesAnew = 0.01;  // of the body's diagonal

}  // namespace

std::string HeldHands::grab(const Vec3& at, double wanted) {
    timeline_.takeOver();
    letGo();
    std::string problem = timeline_.perform(Grab{kPersonsHand, at, reachAt(at, wanted), true});
    pulling_ = problem.empty();
    return problem;
}

double HeldHands::reachAt(const Vec3& at, double wanted) {
    Simulation& simulation = body_.simulation;
    Bounds piece = simulation.bounds();
    for (Bounds box : simulation.pieceBounds()) {
        box.widen(1e-3 * box.diagonal());
        if (contains(box, at) && box.diagonal() < piece.diagonal()) {
            piece = box;
        }
    }
    return handRadius(simulation.mesh(), at, wanted, piece);
}

std::variant<int, std::string> HeldHands::hook(const Incision& incision) {
    timeline_.takeOver();
    letGo();
    const std::optional<int> first = freeRetractor(body_.simulation.hands());
    if (!first) {
        return "All retractors are in use; remove one first.";
    }
    const double radius = hookRadius(incision);
    std::string problem = timeline_.perform(Grab{*first, incision.lips[0], radius, true});
    if (problem.empty()) {
        problem = timeline_.perform(Grab{partnerOf(*first), incision.lips[1], radius, true, true});
        if (!problem.empty()) {
            timeline_.perform(Release{*first});
        }
    }
    pulling_ = problem.empty();
    return problem.empty() ? std::variant<int, std::string>(*first) : problem;
}

std::vector<Hands::Hand> HeldHands::hooks() const {
    return hooksOf(body_.simulation.hands());
}

/// A release is no change of its own, but a hook that takes hold anew is one.
void HeldHands::removeRetractor(int hook) {
    timeline_.takeOver();
    const std::vector<Hands::Hand> all = hooks();
    if (const auto hand = std::ranges::find(all, hook, &Hands::Hand::number); hand != all.end()) {
        const Vec3 at = body_.simulation.mesh().position(hand->held.front().vertex);
        timeline_.perform(Grab{hook, at, kTakesAnew * body_.simulation.bounds().diagonal(), true});
    }
    dropRetractor(hook);
}

void HeldHands::dropRetractor(int hook) {
    timeline_.takeOver();
    for (const Hands::Hand& hand : hooks()) {
        if (hand.number == hook || hand.number == partnerOf(hook)) {
            dragTo_.erase(hand.number);
            timeline_.perform(Release{hand.number});
        }
    }
    settle();
}

void HeldHands::settle() {
    settling_ = kSettleSteps;
}

void HeldHands::move() {
    for (const auto& [hand, to] : std::exchange(dragTo_, {})) {
        timeline_.perform(Drag{hand, to});
    }
    settling_ = std::max(0, settling_ - 1);
}

void HeldHands::letGo() {
    dragTo_.erase(kPersonsHand);
    if (std::exchange(pulling_, false)) {
        if (timeline_.perform(Release{kPersonsHand}).empty()) {
            return;
        }
        settle();
    }
}

void HeldHands::letGoForGood() {
    letGo();
    dragTo_.clear();
    settling_ = 0;
}

void HeldHands::forget() {
    pulling_ = false;
    dragTo_.clear();
    settling_ = 0;
}

}  // namespace kerf::app
