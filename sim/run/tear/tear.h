#pragma once

#include <optional>
#include <vector>

#include "sim/run/blade/running_stroke.h"
#include "sim/run/parts/running_body.h"
#include "sim/run/parts/simulation_parts.h"
#include "sim/run/tear/slit_ends.h"
#include "sim/run/tear/weak_spot.h"
#include "sim/run/undo/undo_log.h"

namespace kerf {

/// Tears the body: advances the end of a slit, as a blade would, where the material opens it, and
/// notches the skin where its stress exceeds the strength. See docs/physics.md.
class Tear {
  public:
    /// All must outlive the object.
    Tear(RunningBody& body, SimulationInput& input, UndoLog& log, SimulationOutput& output,
         RunningStroke& stroke)
        : body_(body), input_(input), log_(log), output_(output), stroke_(stroke) {}

    /// Before a step: the vertices that it reads once the body has moved.
    const std::vector<int>& watched();
    /// After the cut of a step.
    void step();

  private:
    bool isOn() const;
    void watchEnds();
    void weakenBonds();
    /// What a slit's end is opened by.
    struct Opening {
        double atFirst = 0;       ///< at its first vertex, of what makes it advance
        double atLast = 0;        ///< at its last
        Vec3 way = Vec3::Zero();  ///< sum of the ways from W- to W+ [m]
        double most() const { return std::max(atFirst, atLast); }
    };
    Opening openingOf(const SlitEnd& end) const;
    double stress() const;
    void note(const Opening& opening);
    double neededAt(int plus, double behind) const;
    double freeReach() const;
    bool goOn();
    bool beginElsewhere();
    bool beginAtWeakSpot();
    StrongPlaces strongPlaces();
    bool notch(const WeakSpot& spot);
    bool mayBegin(const SlitEnd& end) const;
    void noteStuck(const SlitEnd& end);
    CutOutcome advance(const SlitEnd& end, const Opening& opening, bool begins);
    Blade bladeThrough(const Vec3& a, const Vec3& b);
    std::optional<double> wayOut(const Vec3& from, const Vec3& direction);
    CutOutcome cut(const Blade& to);
    void makeRoom();
    void beginStroke();
    void endStroke();
    std::vector<SlitEnd> presentEnds() const;
    const std::vector<SlitEnd>& allEnds();

    RunningBody& body_;
    SimulationInput& input_;
    UndoLog& log_;
    SimulationOutput& output_;
    RunningStroke& stroke_;  ///< of the blade

    // Of the present mesh, for speed alone.
    int revision_ = -1;
    std::vector<SlitEnd> ends_;
    std::vector<int> watched_;
};

}  // namespace kerf
