#pragma once

#include "app/files/export/export_mesh.h"
#include "app/files/io/output_folder.h"
#include "app/session/session.h"
#include "app/session/simulation_driver.h"
#include "app/session/skin_follower.h"
#include "render/scene/image.h"
#include "render/scene/scene.h"
#include "sim/run/simulation.h"

namespace kerf::render {
class Renderer;
}

namespace kerf::app {

/// Throws MemoryShortage if a session of this body, with `undoBudget` bytes of history, does not
/// fit into the free memory with the current OpenGL context.
void requireMemoryFor(const Session& session, const SurfaceMesh& mesh, std::size_t undoBudget);

/// A session without a window: its simulation, driven by commands and steps, and its pictures and
/// meshes. Replays and the Python module use this class, so both give the same bits.
class HeadlessSession {
  public:
    /// Uploads `model`, which is loadSessionModel(session), to the current OpenGL context, which
    /// all functions need. Pictures are of `quality`. Throws gpu::ShaderError, gpu::OutOfMemory.
    HeadlessSession(const Session& session, ModelMesh model, std::size_t undoBudget,
                    render::Quality quality);
    ~HeadlessSession();
    HeadlessSession(const HeadlessSession&) = delete;  // parts of it refer to one another
    HeadlessSession& operator=(const HeadlessSession&) = delete;

    /// Applies a command before the coming step. Returns "", or one sentence if nothing changed.
    std::string execute(const Command& command);
    /// Applies a command of the session's event with that SessionEvent::number. Throws InputError
    /// with its position in the file if it fails.
    void perform(const Command& command, int event);
    /// Runs one step.
    const StepReport& step() { return driver_.step(); }
    /// Performs what the session says before the coming step, except for its pictures, exports and
    /// checks. Throws like the above.
    void perform(const SessionSchedule& schedule);
    /// The same, and then runs that step.
    const StepReport& stepBy(const SessionSchedule& schedule);

    /// Goes to a state that driver() gave.
    void goTo(const SimulationDriver::State& state);

    /// The camera of the session, or the default one for the present placement of the model.
    const render::Camera& camera() const { return camera_; }
    /// Prepares drawing, which measures the model; otherwise the first draw() does so.
    void preparePictures();
    /// Draws the state before the coming step, with sides in pixels.
    void show(const render::Camera& camera, int width, int height);
    /// Returns a picture of the state before the coming step, with sides in pixels.
    render::Image draw(const render::Camera& camera, int width, int height);
    /// The looks to export the present body with.
    ExportLooks exportLooks();
    /// Writes the files of an export into a folder, with the looks of the model. Throws
    /// OutputError.
    void write(const ExportEvent& event, OutputFolder& folder);

    /// The failures of a check before the coming step, as clauses; `withHash` includes the state
    /// hash.
    std::vector<std::string> problemsWith(const CheckEvent& check, bool withHash) const;
    /// "first-cut.kerf.json: events[3] at step 12", as far as it is known; `event` is
    /// SessionEvent::number.
    std::string positionInFile(int event) const;
    /// "first-cut.kerf.json: "; "" for a session without a file.
    std::string filePrefix() const;

    /// The session, relative to the origin of the simulation.
    const Session& session() const { return session_; }
    Simulation& simulation() { return simulation_; }
    const Simulation& simulation() const { return simulation_; }
    SimulationDriver& driver() { return driver_; }
    /// The uncut body in its last placement. Never null.
    const std::shared_ptr<const UncutBody>& uncut() const { return uncut_; }

  private:
    void followPlacement();

    const Session session_;
    const render::Quality quality_;
    const OwnLooks looks_;  ///< of the uncut body
    SkinFollower skin_{looks_};
    std::unique_ptr<render::Renderer> renderer_;  ///< for pictures
    Simulation simulation_;
    std::shared_ptr<const UncutBody> uncut_;  ///< that the pictures tell of
    Bounds restBounds_;                       ///< of it
    SimulationDriver driver_;
    render::Camera camera_;
};

}  // namespace kerf::app
