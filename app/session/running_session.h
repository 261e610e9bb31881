#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/files/io/output_folder.h"
#include "app/session/session.h"
#include "app/session/session_runner.h"
#include "app/session/skin_follower.h"
#include "render/scene/image.h"
#include "render/scene/quality.h"
#include "sim/run/simulation.h"

namespace kerf::render {
class Renderer;
}

namespace kerf::app {

/// Throws MemoryShortage where a session of this body, with so many bytes for changes that can be
/// undone, does not fit into the memory that there is with the OpenGL context that is current.
void requireMemoryFor(const Session& session, const SurfaceMesh& mesh, std::size_t undoBudget);

/// A session without a window: its simulation, led by commands and steps, and pictures and meshes
/// of it. Replays and the Python module drive this one class, so both come to the same bits.
class RunningSession {
  public:
    /// Uploads `model`, which is loadSessionModel(session), to the OpenGL context that is current,
    /// where all else is called too. Pictures are of `quality`. Throws gpu::ShaderError,
    /// gpu::OutOfMemory.
    RunningSession(const Session& session, ModelMesh model, std::size_t undoBudget,
                   render::Quality quality);
    ~RunningSession();
    RunningSession(const RunningSession&) = delete;  // parts of it refer to one another
    RunningSession& operator=(const RunningSession&) = delete;

    /// Applies a command before the coming step. Returns "" or one sentence; nothing changed then.
    std::string execute(const Command& command);
    /// Applies a command of the session, of the event with that SessionEvent::number. Throws
    /// InputError with its position in the file where it can't be performed.
    void perform(const Command& command, int event);
    /// Runs one step.
    const StepReport& step() { return runner_.step(); }
    /// Performs what the session says before the coming step, but for its pictures, exports and
    /// checks, and runs that. Throws as perform().
    const StepReport& stepBy(const SessionPlayer& player);

    /// The present, to come back to: with the poses that the running stroke left, and with what the
    /// blade was told to do in the coming step.
    struct Place {
        Moment moment;
        std::vector<BladeAction> bladeActions;
        std::vector<Blade> strokePoses;
    };
    Place here();
    void goTo(const Place& place);

    /// The camera of the session, or its default one for the model as it was placed last.
    const render::Camera& camera() const { return camera_; }
    /// Gets ready to draw, which measures the model; draw() does so too, but for the first picture
    /// only.
    void preparePictures();
    /// Draws it as it stands before the coming step, the sides in pixels.
    void show(const render::Camera& camera, int width, int height);
    /// The same, as a picture.
    render::Image draw(const render::Camera& camera, int width, int height);
    /// Writes the files of an export into a folder, with the looks of the model. Throws
    /// OutputError.
    void write(const ExportEvent& event, OutputFolder& folder);

    /// Where a check before the coming step does not hold, that as clauses; the state hash counts
    /// where it is `withHash`.
    std::vector<std::string> problemsWith(const CheckEvent& check, bool withHash) const;
    /// "first-cut.kerf.json: events[3] at step 12", as far as it is known; `event` is
    /// SessionEvent::number.
    std::string placeInFile(int event) const;
    /// "first-cut.kerf.json: "; "" for a session that lies in no file.
    std::string filePrefix() const;

    /// The session, counted from the origin of the simulation.
    const Session& session() const { return session_; }
    Simulation& simulation() { return simulation_; }
    const Simulation& simulation() const { return simulation_; }
    SessionRunner& runner() { return runner_; }
    /// The uncut body, as it was placed last. Never null.
    const std::shared_ptr<const UncutBody>& uncut() const { return uncut_; }

  private:
    void followPlacement();

    const Session session_;
    const render::Quality quality_;
    const OwnLooks looks_;  ///< of the uncut body
    SkinFollower skin_{looks_};
    std::unique_ptr<render::Renderer> renderer_;  ///< where pictures are taken
    Simulation simulation_;
    std::shared_ptr<const UncutBody> uncut_;  ///< that the pictures tell of
    Bounds restBounds_;                       ///< of it
    SessionRunner runner_;
    render::Camera camera_;
};

}  // namespace kerf::app
