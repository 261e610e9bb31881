#pragma once

#include "sim/run/simulation.h"
#include "ui/state/panel_model.h"

namespace kerf::app {

/// What holds or pulls a body.
struct Load {
    enum class Kind : std::uint8_t { pin, motion, force, hand };

    Kind kind = Kind::pin;
    std::vector<std::uint32_t> vertices;  ///< that it acts on
    Vec3 value = Vec3::Zero();            ///< how far it moved [m], or the force [N]
    int hand = -1;                        ///< its number; of a retractor that of its first hook
    int motion = -1;                      ///< its number
    std::vector<Vec3> hands{};            ///< where they are [m]
    ui::LoadRow row{};

    /// What its row tells is no matter.
    bool operator==(const Load& other) const {
        return kind == other.kind && hand == other.hand && motion == other.motion &&
               vertices == other.vertices;
    }
};

/// All that holds or pulls a body.
class LoadTable {
  public:
    /// Takes what does so now. Places are told from `origin` [m].
    void follow(const Simulation& simulation, const Vec3& origin);
    const std::vector<Load>& loads() const { return loads_; }

  private:
    void addPins(const Simulation& simulation);
    void addForce(const Pins::Force& force);
    void addHand(const Hands::Hand& hand, const Vec3& origin);

    std::vector<Load> loads_;
    std::vector<std::uint32_t> fixed_;              ///< pinned vertices that don't move
    std::vector<std::vector<std::uint32_t>> pins_;  ///< these, in parts that hang together
    int model_ = -1;                                ///< revision that those are of
};

/// The row of a load that was listed before as `load`; -1 if it is gone.
int rowOf(const Load& load, const std::vector<Load>& now);

/// The commands that take a pin, a motion or a force away, as one change.
std::vector<Command> removalOf(const Load& load, Simulation& simulation);

}  // namespace kerf::app
