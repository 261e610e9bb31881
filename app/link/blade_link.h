#pragma once

#include "app/link/link_server.h"
#include "sim/base/stopwatch.h"
#include "sim/run/parts/command.h"

namespace kerf {
class Simulation;
}

namespace kerf::app {

// A direction in the axes of OpenIGTLink (right, anterior, superior), and back: Kerf's x points to
// the right, y is superior, and z, towards who looks from the front, is posterior.
inline Vec3 toRas(const Vec3& v) {
    return {v.x(), -v.z(), v.y()};
}
inline Vec3 fromRas(const Vec3& v) {
    return {v.x(), v.z(), -v.y()};
}
inline constexpr double kMillimetres = 1000;  ///< in a metre

/// Leads the blade of a simulation by the poses of a tool "Blade", and tells the clients of the
/// body (docs/link.md).
class BladeLink {
  public:
    /// For a blade of this length [m] and a simulation whose positions count from `origin`. Tells
    /// of the body so many times a second.
    BladeLink(LinkServer& server, double bladeLength, const Vec3& origin, int bodies)
        : server_(server), bladeLength_(bladeLength), origin_(origin), bodies_(bodies) {}

    /// Receives until so many seconds have passed since the last call, and a client has joined.
    /// With 0 it takes what has come, and waits for nobody.
    /// Returns what the blade does in the coming step, by the newest pose; nothing: it stays.
    std::vector<Command> await(double seconds);
    /// Lifts the blade if it is down.
    std::vector<Command> lift();
    /// Whether all clients have left.
    bool isOver() const { return server_.clients() == 0; }
    /// Tells of the state after a step.
    void tell(Simulation& simulation);
    /// Tells something in words.
    void tell(const std::string& device, const std::string& text);

  private:
    void take(const IgtlMessage& message);
    Command moveTo(const IgtlPose& pose);
    IgtlMessage bodyOf(Simulation& simulation) const;

    LinkServer& server_;
    double bladeLength_;
    Vec3 origin_;
    int bodies_;                      ///< a second
    std::optional<IgtlPose> newest_;  ///< since the last step
    bool lifts_ = false;              ///< before that
    bool isDown_ = false;
    Stopwatch sinceStep_;
    Stopwatch sinceBody_;     ///< was sent
    Stopwatch sinceCommand_;  ///< of the blade
    int steps_ = 0;           ///< since then
    int greeted_ = 0;         ///< clients
};

}  // namespace kerf::app
