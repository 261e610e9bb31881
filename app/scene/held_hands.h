#pragma once

#include "app/scene/incision.h"
#include "app/scene/timeline/hooks.h"

namespace kerf::app {

class SceneTimeline;
struct SceneBody;

/// Hands that pull at the body of a scene: the user's, and the hooks of retractors. Time runs
/// meanwhile, also in a pause.
class HeldHands {
  public:
    static constexpr int kPersonsHand = 0;  ///< its number among the hands
    /// How fast a hand moves in simulated time, at most, whatever the pointer does while the body
    /// is in slow motion [m/s]: 1 m/s, the peak speed of a person who reaches for something without
    /// haste; about a body of more than a metre its `diagonal` [m] in a second.
    static double usualSpeed(double diagonal) { return std::max(1.0, diagonal); }

    /// Both must outlive it.
    HeldHands(SceneBody& body, SceneTimeline& timeline) : body_(body), timeline_(timeline) {}

    /// Grabs with the user's hand around `at`, along the surface and on one side of a cut; `wanted`
    /// [m] is the largest reach. Returns "" or one sentence.
    std::string grab(const Vec3& at, double wanted);
    /// The reach of such a hand at a point of the surface [m].
    double reachAt(const Vec3& at, double wanted);
    /// Hooks both lips of a cut. Returns the first of the two hooks, or one sentence.
    std::variant<int, std::string> hook(const Incision& incision);
    /// From now on hands move no faster than that [m/s].
    void limitSpeed(double speed) { speed_ = speed; }
    /// Moves a hand to a place in the coming steps [m].
    void dragTo(const Vec3& to, int hand = kPersonsHand) { dragTo_[hand] = to; }
    /// Releases the user's hand; hooks hold on, and time runs until they have arrived.
    void letGo();
    /// The same, once the hand is where it was dragged to.
    void letGoThere();
    bool pulling() const { return pulling_ || settling_ > 0 || !dragTo_.empty(); }
    /// How far the places that hands were dragged to are from where they are, at most [m].
    double ahead() const;
    /// Runs time for a while, so that the body follows hooks and pins.
    void settle();
    /// The hooks of all retractors, by number.
    std::vector<Hands::Hand> hooks() const;
    /// Removes the retractor of a hook, as a change that can be undone.
    void removeRetractor(int hook);
    /// Removes it as if it had not been.
    void dropRetractor(int hook);

    /// Moves them before a step.
    void move();
    /// Stops all motion of hands.
    void letGoForGood();
    /// Drops them, after a jump in time.
    void forget();

  private:
    /// Moves a hand on its way; whether it has arrived.
    bool moveOn(int hand, const Vec3& to);

    SceneBody& body_;
    SceneTimeline& timeline_;
    double speed_ = std::numeric_limits<double>::infinity();  ///< at most [m/s]
    bool pulling_ = false;
    bool letsGo_ = false;         ///< the user's hand, once it has arrived
    int settling_ = 0;            ///< steps of time left for what was released or hooked
    std::map<int, Vec3> dragTo_;  ///< targets of hands, until commanded
};

}  // namespace kerf::app
