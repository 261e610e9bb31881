#pragma once

#include <stdexcept>

#include "app/scene/timeline/event_log.h"
#include "app/session/headless_session.h"
#include "app/session/metrics.h"
#include "gpu/context.h"

namespace kerf::python {

/// A check of a session did not hold: what() is what a replay says.
class CheckFailure : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// An array that Python reads without copying it; it never changes.
template <class Number>
using SharedArray = std::shared_ptr<const std::vector<Number>>;

/// The triangles of the body that are present, an entry each.
struct TriangleArrays {
    SharedArray<std::int32_t> corners;  ///< three vertices each
    SharedArray<std::uint8_t> isWall;   ///< 1 on the faces that a cut made
    SharedArray<std::int32_t> piece;    ///< number of its piece
    SharedArray<double> restPositions;  ///< three numbers for each vertex, not triangle [m]
};

/// The pieces of the body, an entry each, numbered as in pieces.csv.
struct PieceArrays {
    SharedArray<std::int32_t> triangles;  ///< their number
    SharedArray<std::int32_t> model;      ///< of the scene
    SharedArray<double> volume;           ///< [m^3]
    SharedArray<double> restVolume;       ///< [m^3]
    SharedArray<double> low;              ///< three numbers each, corner of the box around it [m]
    SharedArray<double> high;             ///< the other corner
};

/// The options of a run.
struct RunOptions {
    std::size_t undoBudget = 0;  ///< for changes that can be undone [bytes]
    bool fine = false;           ///< pictures as with `kerf replay --fine`
    bool forces = false;         ///< measures what the body does to the blade's
    bool hashChecks = true;      ///< false: passes over state hashes in the session's checks
};

/// A session that a script runs: its events, if any, and what the script does between the steps, on
/// an OpenGL context of its own. All calls are made on GlThread.
class ScriptedRun {
  public:
    /// Reads the model and begins. Throws InputError, gpu::ContextError, gpu::ShaderError,
    /// gpu::OutOfMemory, MemoryShortage.
    ScriptedRun(app::Session session, const RunOptions& options);
    ~ScriptedRun();
    ScriptedRun(const ScriptedRun&) = delete;
    ScriptedRun& operator=(const ScriptedRun&) = delete;
    /// Makes its context the current one; to be called before anything else.
    void makeCurrent() { context_.makeCurrent(); }

    // What changes it.
    /// Applies an event that is a command, as a session writes it, before the next step. Throws
    /// InputError, and changes nothing then.
    void apply(const std::string& action);
    /// Runs the events that are due and one step. Throws InputError, CheckFailure.
    const app::MetricsRow& step();
    /// Runs the events after the last step of a session.
    void finish();

    /// The current state, to return to; for this run only, as long as it lives.
    struct Snapshot {
        app::SimulationDriver::State state;
        app::EventLog log;
        app::MetricsRow row;
        int step = 0;
    };
    std::shared_ptr<const Snapshot> snapshot();
    void restore(const Snapshot& snapshot);

    // What it is like.
    const app::MetricsRow& row() const { return row_; }
    int stepCount() const { return simulation().stepCount(); }
    int steps() const { return session_.steps; }
    ParamValue param(const std::string& name) const;
    /// The pose of the blade after the next step; none where it is lifted then.
    std::optional<Blade> blade() const;
    std::string stateHash();
    /// Three numbers for each vertex [m].
    SharedArray<double> positions();
    /// Three numbers for each vertex [m/s].
    SharedArray<double> velocities();
    /// See largestStrain(), of each present triangle.
    SharedArray<double> strains();
    const TriangleArrays& triangles();
    PieceArrays pieces() const;
    SharedArray<std::uint32_t> pinnedVertices() const;
    std::vector<StaticBox> boxes() const;
    /// `cut_report` of summary.json as JSON; "null" without a cut.
    std::string cutReport() const;
    /// Sentences about problems in steps, from the start.
    const std::vector<std::string>& messages() const { return messages_; }
    /// Why the body tore in the last step or did not: see kerf::tearSentence().
    std::string tearSentence() const;

    // Files and pictures.
    /// A picture from `view`, JSON as in a session, or the session's own where it is empty. `size`
    /// is a screenshot event in JSON.
    render::Image picture(const std::string& size, const std::string& view);
    /// Writes the export event `event`, JSON, into a folder. Returns the names of the files.
    std::vector<std::string> exportMesh(const std::filesystem::path& folder,
                                        const std::string& event);
    /// Writes everything so far as a session that ends here with a check of the state.
    void saveSession(const std::filesystem::path& file);

    // What happens before a step: see SimulationDriver::applyActions.
    void perform(const Command& command, int event);
    void take(const app::ScreenshotEvent& /*event*/) {}  // a replay writes it, or the script
    void take(const app::ExportEvent& /*event*/) {}
    void take(const app::CameraEvent& /*event*/) {}  // of films alone
    void take(const app::MarkEvent& /*event*/) {}
    void take(const app::CheckEvent& check);

  private:
    Simulation& simulation() { return running_->simulation(); }
    const Simulation& simulation() const { return running_->simulation(); }

    /// A point of the simulation, in the coordinates of the session's file.
    Vec3 inScene(const Vec3& point) const { return point + session_.origin; }
    void tellMessages();
    void warnAbout(const std::vector<std::string>& warnings) const;

    app::Session session_;
    RunOptions options_;
    std::optional<app::SessionSchedule> schedule_;
    gpu::EglContext context_;
    std::unique_ptr<app::HeadlessSession> running_;
    app::EventLog log_;
    app::MetricsRow row_;
    std::vector<std::string> messages_;
    // What was asked for last, and of which revision it is.
    SharedArray<double> positions_;
    int positionsRevision_ = -1;
    TriangleArrays triangles_;
    int trianglesRevision_ = -1;
};

}  // namespace kerf::python
