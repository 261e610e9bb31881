#pragma once

#include <map>
#include <string>
#include <variant>
#include <vector>

#include "app/scene/incision.h"
#include "app/scene/timeline/hooks.h"

namespace kerf::app {

class SceneTimeline;
struct SceneBody;

/// Hands that pull at the body of a scene: a person's own, and the hooks of retractors. Time runs
/// while they do, also in a pause.
class HeldHands {
  public:
    static constexpr int kPersonsHand = 0;  ///< its number among the hands

    /// Both must outlive it.
    HeldHands(SceneBody& body, SceneTimeline& timeline) : body_(body), timeline_(timeline) {}

    /// Takes hold with a person's hand of what lies about `at`, along the surface and on one side
    /// of a cut; `wanted` [m] is the most that it reaches. Returns "" or one sentence.
    std::string grab(const Vec3& at, double wanted);
    /// How far such a hand reaches at a point of the surface [m].
    double reachAt(const Vec3& at, double wanted);
    /// Hooks both lips of a cut. Returns the first of the two hooks, or one sentence.
    std::variant<int, std::string> hook(const Incision& incision);
    /// Moves a hand to where it is in the coming steps [m].
    void dragTo(const Vec3& to, int hand = kPersonsHand) { dragTo_[hand] = to; }
    /// The person's hand lets go; hooks hold on, and time runs on until they have arrived.
    void letGo();
    bool pulling() const { return pulling_ || settling_ > 0; }
    /// Lets time run on for a while: for what hooks and pins hold to follow them.
    void settle();
    /// The hooks of all retractors, by number.
    std::vector<Hands::Hand> hooks() const;
    /// Takes away the retractor that a hook belongs to.
    void removeRetractor(int hook);

    /// Moves them on before a step.
    void move();
    /// Nothing that was held goes on moving.
    void letGoForGood();
    /// Forgets them, where the body is at another moment.
    void forget();

  private:
    SceneBody& body_;
    SceneTimeline& timeline_;
    bool pulling_ = false;
    int settling_ = 0;            ///< steps that time runs on for what was let go or hooked
    std::map<int, Vec3> dragTo_;  ///< where hands are to go, until they are told
};

}  // namespace kerf::app
