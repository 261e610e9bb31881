#pragma once

#include "sim/base/byte_archive.h"
#include "sim/run/blade/running_stroke.h"
#include "sim/run/parts/box_edit.h"
#include "sim/run/parts/simulation_parts.h"
#include "sim/run/simulation.h"
#include "sim/run/tear/tear.h"
#include "sim/run/undo/undo_log.h"

namespace kerf {

struct Checkpoint::Content {
    SnapshotPointer body;
    SimulationInput input;
    UndoLog log;
    SimulationClock clock;
    StepReport report;
};

/// Parameters and boxes that a simulation was made with; constant.
struct SimulationSetup {
    Params params;
    std::vector<StaticBox> boxes;
};

/// A running simulation. The step is in simulation.cpp, commands in commands.cpp, undo in undo.cpp.
struct Simulation::State {
    State(PreparedBody prepared, std::unique_ptr<GpuSolver> loadedSolver, SimulationSetup with);

    void start();
    const StepReport& step();

    std::string execute(const Command& command);

    Checkpoint checkpoint();
    void goTo(const Checkpoint::Content& then);
    void goTo(const std::vector<std::byte>& bytes);

    const SimulationSetup setup;
    RunningBody body;
    SimulationInput input;
    UndoLog log;
    SimulationOutput output;
    RunningStroke stroke{body, input, log, output};
    Tear tear{body, input, log, output, stroke};
    /// See Simulation::expectPlacement().
    std::shared_ptr<const UncutBody> preparedPlacement;

  private:
    void startRun();
    void startBody();
    void beginAtRest();

    // The phases of a step.
    void noteParamsChanged();
    Surroundings surroundings() const;
    void applyParameters();
    bool sleeps() const;
    void solve();
    void cut();
    bool bladeLooks() const;
    void prefetchCut();
    Vec3 middleOfBlade();
    void noteBladeLoad(const Vec3& middle);
    void noteHeldEdge();
    void moveBody();
    void takeBackLostPieces();
    void guardSteps();
    void lookAfterShape();
    /// sharesInsideOut() if parameters may have caused that, else 0 for all.
    std::vector<double> findInsideOut();
    void drawCollapsedBack(std::vector<double> insideOut);
    void mendFolds();
    void publish();

    /// Carries a command out at once. Returns "", or one sentence if nothing changed. Every kind
    /// has a specialization in commands.cpp, without which nothing compiles.
    template <class Kind>
    std::string carryOut(const Kind& command) = delete;
    std::shared_ptr<const UncutBody> preparedAs(const std::vector<PlacedModel>& models);
    std::shared_ptr<const UncutBody> uncutOf(ByteReader& from);
    void changePins(const std::string& name, Pins after, bool continues);
    std::string apply(BoxEdit edit);
    void setBoxes(std::vector<StaticBox> now);
    void putBladeAway();

    // Undo.
    std::string undo();
    std::string redo();
    void restoreBody(const SnapshotPointer& snapshot);
    void apply(const UndoEntry::ParamChange& change, bool forward);
    void apply(const UndoEntry::MaterialChange& change, bool forward);
    void apply(const UndoEntry::PinChange& change, bool forward);
    void apply(const UndoEntry::BodySnapshotChange& change, bool forward);
    void apply(const UndoEntry::BoxesChange& change, bool forward);

    int lastLossStep_ = -2;  ///< the last step that lost a piece
};

}  // namespace kerf
