#pragma once

#include "app/practice/score.h"
#include "app/session/session.h"

namespace kerf {
class Simulation;
struct StepReport;
}  // namespace kerf

namespace kerf::app {

/// The poses of the hand in a session since the body was last put back, by its own time: a pose
/// comes `seconds` per step after the one before, the first one of a stroke `seconds` after the
/// last lift; without these, as long after it as was simulated.
std::vector<HandPose> handOf(const Session& session);

/// The forces on the blade in a run, by step. A step that runs again takes the place of the earlier
/// one and of all behind it.
class ForceTrace {
  public:
    /// After a step of this length [s].
    void add(const StepReport& report, double timeStep);
    const std::vector<ForceSample>& samples() const { return samples_; }

  private:
    std::vector<ForceSample> samples_;
};

/// The score of a session that a simulation has run, with both relative to the same origin; none
/// without a task, or before a stroke. Call it between strokes.
std::optional<Score> scoreOf(const Session& session, const Simulation& simulation,
                             const ForceTrace& forces);
/// Runs a session of a model's file for its score, in the current OpenGL context. Throws as
/// loadSessionModel() and HeadlessSession do.
std::optional<Score> runForScore(const Session& session);
/// Where the score of a session lies, if it has one: beside it, with an ending of its own.
std::filesystem::path scoreFileOf(const std::filesystem::path& session);
inline constexpr std::string_view kScoreEnding = ".score.json";
/// The rim of what was cut of the body of a task.
std::vector<RimDeviation> rimDeviations(const Task& task, const Simulation& simulation);

}  // namespace kerf::app
