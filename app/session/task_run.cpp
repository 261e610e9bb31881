#include "app/session/task_run.h"

#include "app/files/import/model_source.h"
#include "app/session/headless_session.h"
#include "sim/run/simulation.h"
#include "sim/run/start/prepared_body.h"

namespace kerf::app {

namespace {

/// Follows the hand of a session event by event.
class HandClock {
  public:
    explicit HandClock(const Session& session) : timeStep_(session.params.timeStep) {}

    void take(const SessionEvent& event) {
        const int steps = event.step - std::exchange(step_, event.step);
        stepsOfPose_ += steps;
        time_ += steps * timeStep_;
        if (startsAnew(event.action)) {
            poses_.clear();
        } else if (const auto* set = std::get_if<SetParam>(&event.action)) {
            const auto* value = std::get_if<double>(&set->value);
            timeStep_ = set->name == "time_step" && value != nullptr ? *value : timeStep_;
        } else if (const auto* move = std::get_if<MoveBlade>(&event.action)) {
            if (move->seconds && !poses_.empty()) {
                const int since = cuts_ ? std::max(1, stepsOfPose_) : 1;
                time_ = poses_.back().time + since * *move->seconds;
            }
            add(move->blade);
        } else if (cuts_ && std::holds_alternative<LiftBlade>(event.action)) {
            add(poses_.back().blade);
        }
        cuts_ = std::holds_alternative<MoveBlade>(event.action) ||
                (cuts_ && !takesBladeAway(event.action));
    }

    std::vector<HandPose> takePoses() { return std::move(poses_); }

  private:
    void add(const Blade& blade) {
        poses_.push_back({time_, blade, !cuts_});
        stepsOfPose_ = 0;
    }

    double timeStep_;
    double time_ = 0;      ///< of the hand [s]
    int step_ = 0;         ///< of the last event
    int stepsOfPose_ = 0;  ///< since the last pose
    bool cuts_ = false;    ///< the blade is in a stroke
    std::vector<HandPose> poses_;
};

/// What was changed or undone after the first stroke began.
struct Interventions {
    int undos = 0;
    int changes = 0;
};

/// An undo right after a new start brings an earlier cut back, so it counts, too.
Interventions interventionsIn(const Session& session) {
    Interventions found;
    bool begun = false;
    bool begunEver = false;
    for (const SessionEvent& event : session.events) {
        const auto* const set = std::get_if<SetParam>(&event.action);
        if (startsAnew(event.action)) {
            found = {};
            begun = false;
        }
        begun = begun || std::holds_alternative<MoveBlade>(event.action);
        begunEver = begunEver || begun;
        found.undos += begunEver && std::holds_alternative<Undo>(event.action) ? 1 : 0;
        found.changes += begun && set != nullptr && !set->continues ? 1 : 0;
    }
    return found;
}

/// Two meshes, and the model of each of their triangle slots.
struct BothBodies {
    const SurfaceMesh& mesh;
    const SurfaceMesh& uncut;
    std::vector<int> members;
    std::vector<int> uncutMembers;

    explicit BothBodies(const Simulation& simulation)
        : mesh(simulation.meshAsRead()), uncut(simulation.uncut()->mesh) {
        const BodyModel& body = simulation.bodyModel();
        members = membersOf(mesh, [&](int v) { return body.pieces[body.pieceOfVertex[v]].member; });
        uncutMembers = membersOf(uncut, [&](int v) { return simulation.uncut()->modelOf(v); });
    }
    TaskBody of(const Task& task) const { return {task, mesh, uncut, members, uncutMembers}; }

  private:
    static std::vector<int> membersOf(const SurfaceMesh& mesh, const auto& memberOfVertex) {
        std::vector<int> members(mesh.triangleSlots(), 0);
        for (const int t : livingTriangles(mesh)) {
            members[t] = memberOfVertex(mesh.triangle(t)[0]);
        }
        return members;
    }
};

/// The step at which the body was last put back.
int startOf(const Session& session) {
    int start = 0;
    for (const SessionEvent& event : session.events) {
        start = startsAnew(event.action) ? event.step : start;
    }
    return start;
}

}  // namespace

std::vector<HandPose> handOf(const Session& session) {
    HandClock clock(session);
    for (const SessionEvent& event : session.events) {
        clock.take(event);
    }
    return clock.takePoses();
}

void ForceTrace::add(const StepReport& report, double timeStep) {
    while (!samples_.empty() && samples_.back().step >= report.step) {
        samples_.pop_back();
    }
    if (report.bladeLoad) {
        samples_.push_back(
            {report.time - timeStep, report.time, report.bladeLoad->force, report.step});
    }
}

std::optional<Score> scoreOf(const Session& session, const Simulation& simulation,
                             const ForceTrace& forces) {
    const std::vector<HandPose> hand = handOf(session);
    if (!session.task || hand.empty()) {
        return std::nullopt;
    }
    const BothBodies bodies(simulation);
    const Interventions interventions = interventionsIn(session);
    const auto first =
        std::ranges::lower_bound(forces.samples(), startOf(session), {}, &ForceSample::step);
    return scoreOf(TaskRun{bodies.of(*session.task), hand, std::span(first, forces.samples().end()),
                           interventions.undos, interventions.changes});
}

std::optional<Score> runForScore(const Session& session) {
    ModelMesh model = loadSessionModel(session);
    const std::size_t undoBudget = undoesAnything(session) ? kReplayUndoBudget : 0;
    requireMemoryFor(session, model.mesh, undoBudget);
    HeadlessSession running(session, std::move(model), undoBudget, render::Quality::light);
    running.simulation().feelBlade(true);
    const SessionSchedule schedule(running.session());
    ForceTrace forces;
    for (int step = 0; step < session.steps; ++step) {
        const StepReport& report = running.stepBy(schedule);
        forces.add(report, running.simulation().params().timeStep);
    }
    running.perform(schedule);
    return scoreOf(running.session(), running.simulation(), forces);
}

std::filesystem::path scoreFileOf(const std::filesystem::path& session) {
    const std::string name = session.string();
    const std::size_t ending = name.ends_with(kSessionEnding) ? kSessionEnding.size()
                                                              : session.extension().string().size();
    return name.substr(0, name.size() - ending) + std::string(kScoreEnding);
}

std::vector<RimDeviation> rimDeviations(const Task& task, const Simulation& simulation) {
    return rimDeviations(BothBodies(simulation).of(task));
}

}  // namespace kerf::app
