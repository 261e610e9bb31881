#include "app/scene/held_hands.h"

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
    std::erase_if(dragTo_, [this](const auto& drag) { return moveOn(drag.first, drag.second); });
    if (letsGo_ && !dragTo_.contains(kPersonsHand)) {
        letGo();
    }
    settling_ = std::max(0, settling_ - 1);
}

bool HeldHands::moveOn(int hand, const Vec3& to) {
    const std::vector<Hands::Hand>& hands = body_.simulation.hands();
    const auto at = std::ranges::find(hands, hand, &Hands::Hand::number);
    const Vec3 way = at == hands.end() ? Vec3(Vec3::Zero()) : Vec3(to - at->to);
    const double farthest = speed_ * body_.simulation.params().timeStep;
    const bool arrives = way.norm() <= farthest;
    timeline_.perform(Drag{hand, arrives ? to : Vec3(at->to + farthest / way.norm() * way)});
    return arrives;
}

double HeldHands::ahead() const {
    double most = 0;
    for (const Hands::Hand& hand : body_.simulation.hands()) {
        if (const auto drag = dragTo_.find(hand.number); drag != dragTo_.end()) {
            most = std::max(most, (drag->second - hand.to).norm());
        }
    }
    return most;
}

void HeldHands::letGoThere() {
    letsGo_ = pulling_ && std::isfinite(speed_) && dragTo_.contains(kPersonsHand);
    if (!letsGo_) {
        letGo();
    }
}

void HeldHands::letGo() {
    letsGo_ = false;
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
    pulling_ = letsGo_ = false;
    dragTo_.clear();
    settling_ = 0;
}

}  // namespace kerf::app
