#pragma once

#include <spdlog/fmt/fmt.h>

#include <string>
#include <utility>
#include <vector>

#include "sim/run/box_edit.h"
#include "sim/run/led_blade.h"
#include "sim/run/running_body.h"
#include "sim/run/simulation.h"
#include "sim/run/undo_log.h"

namespace kerf {

struct Moment::Content {
    SnapshotPointer body;
    Params params;
    std::vector<StaticBox> boxes;
    LedBlade blade;
    UndoLog log;
    int stepsDone = 0;
    double time = 0;  ///< [s]
    StepReport report;
};

/// Parameters and boxes that a simulation was made with; constant.
struct SimulationSetup {
    Params params;
    std::vector<StaticBox> boxes;
};

/// A running simulation. Its parts stand in files of their own: the step in simulation.cpp, the
/// course of a stroke in stroke.cpp, commands in commands.cpp, undo in undo.cpp.
struct Simulation::State {
    State(PreparedBody prepared, std::unique_ptr<GpuSolver> loadedSolver, SimulationSetup with);

    void start();
    const StepReport& step();

    std::string execute(const Command& command);

    Moment moment();
    void goTo(const Moment::Content& then);

    std::optional<BladeMotion> bladeBody() const;

    const SimulationSetup setup;
    RunningBody body;

    // Input.
    Params params;
    bool paramsChanged = false;
    std::vector<StaticBox> boxes;
    LedBlade blade;

    UndoLog log;
    SnapshotPointer current;    ///< equal to the state as it is; null where none is known to be
    bool toldTooLarge = false;  ///< for the undo memory, since a body last fit into it

    // Output.
    StepReport report;
    CutResult lastCut;
    std::vector<std::string> messages;
    int stepsDone = 0;
    int bodyRevision = 0;
    double time = 0;        ///< [s]
    int lastLossStep = -2;  ///< the last step that lost a piece

  private:
    void startRun();
    void startBody();
    void beginAtRest();

    // The phases of a step.
    void applyParameters();
    void solve();
    void prefetchCut();
    void moveBody();
    void takeBackLostPieces();
    void cutAll();
    void mendFolds();
    void publish();

    /// Carries a command out at once. Returns "" or one sentence; nothing changed then. Every kind
    /// has a specialization in commands.cpp: without one nothing compiles.
    template <class Kind>
    std::string carryOut(const Kind& command) = delete;

    // The course of a stroke.
    void cut(const MoveBlade& move);
    void cut(const LiftBlade& lift);
    bool mayTouch(const Blade& to);
    void beginStroke();
    void endStroke();
    void accept(const CutResult& result);
    void adopt(const CutDelta& delta);
    void putBladeAway();
    BladePush bladePush() const;
    std::optional<BladeMotion> bladeMotion() const;

    // Undo.
    std::string undo();
    std::string redo();
    SnapshotPointer capture();
    SnapshotPointer captureForUndo();
    void restoreBody(const SnapshotPointer& snapshot);
    void tellOf(UndoLog::Noted noted);
    void apply(const UndoEntry::ParamChange& change, bool forward);
    void apply(const UndoEntry::PinChange& change, bool forward);
    void apply(const UndoEntry::BodySnapshotChange& change, bool forward);
    void apply(const UndoEntry::BoxesChange& change, bool forward);
    std::string apply(BoxEdit edit);
    void setBoxes(std::vector<StaticBox> now);
    /// Something is about to differ from the last snapshot.
    void touch() { current.reset(); }

    template <class... Parts>
    void say(fmt::format_string<Parts...> format, Parts&&... parts) {
        messages.push_back(fmt::format(format, std::forward<Parts>(parts)...));
    }
};

}  // namespace kerf
