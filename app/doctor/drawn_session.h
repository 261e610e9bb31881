#pragma once

#include "app/session/scene_view.h"
#include "app/session/session.h"
#include "app/session/session_runner.h"
#include "render/renderer.h"
#include "sim/run/simulation.h"

namespace kerf::app {

/// A session that is played step by step and drawn as it goes; its pictures, exports and checks are
/// passed over. Needs a current context.
class DrawnSession {
  public:
    /// Throws as Simulation does, and InputError where the session's model can't be read.
    DrawnSession(const Session& session, render::Quality quality);

    bool isOver() const { return simulation_.stepCount() >= session_.steps; }
    /// Performs what the session says before the next step, and does that. Throws InputError where
    /// something can't be performed.
    const StepReport& step();
    void draw(int width, int height);
    /// What was drawn last.
    render::Image picture() { return renderer_.readPicture(); }
    Simulation& simulation() { return simulation_; }

  private:
    const Session& session_;
    Simulation simulation_;
    Bounds restBounds_;
    render::BodyLook look_;
    render::Renderer renderer_;
    SessionPlayer player_;
    SessionRunner runner_;
};

}  // namespace kerf::app
