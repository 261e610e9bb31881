#pragma once

#include "sim/run/blade/running_stroke.h"
#include "sim/run/parts/running_body.h"
#include "sim/run/parts/simulation_parts.h"
#include "sim/run/tear/end_opening.h"
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
    void noteSlits();
    void weakenBonds();
    EndOpening openingAt(const SlitEnd& end);
    double stress() const;
    bool goOn();
    bool beginElsewhere();
    bool beginAtWeakSpot();
    StrongPlaces strongPlaces();
    bool notch(const WeakSpot& spot);
    bool mayBegin(const SlitEnd& end) const;
    bool advance(const SlitEnd& end, const EndOpening& opening, bool begins);
    bool cut(const Blade& to);
    void tell();
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
    std::string told_;  ///< the last reason
};

}  // namespace kerf
