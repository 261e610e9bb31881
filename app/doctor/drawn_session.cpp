#include "app/doctor/drawn_session.h"

#include "app/files/io/errors.h"

namespace kerf::app {
namespace {

/// A host of SessionRunner::applyActions.
struct Performer {
    Simulation& simulation;

    void perform(const Command& command, int /*event*/) const {
        const std::string problem = simulation.execute(command);
        if (!problem.empty()) {
            throw InputError(problem);
        }
    }
    template <class Event>
    void take(const Event& /*event*/) const {}
};

}  // namespace

DrawnSession::DrawnSession(const Session& session, render::Quality quality)
    : session_(session),
      simulation_(loadSessionModel(session).mesh, session.params, session.boxes),
      restBounds_(meshBounds(simulation_.mesh())),
      look_(lookOf(session)),
      renderer_(quality),
      player_(session),
      runner_(simulation_) {
    renderer_.setRestShape(simulation_.mesh());
}

const StepReport& DrawnSession::step() {
    runner_.applyActions(player_, Performer{simulation_});
    return runner_.step();
}

void DrawnSession::draw(int width, int height) {
    renderer_.draw(sceneOf(simulation_, look_, restBounds_, runner_.strokePoses()),
                   sessionCamera(session_, restBounds_), width, height);
}

}  // namespace kerf::app
