#pragma once

#include "sim/run/parts/command.h"

namespace kerf {
class BodyUpload;
class Simulation;
}  // namespace kerf

namespace kerf::render {
struct Ray;
}

namespace kerf::ui {
struct PanelModel;
}

namespace kerf::app {

class BladeStroke;
class HeldHands;
class RestOfBody;
class SceneReadout;
class SceneRecorder;
class SceneTimeline;
struct CutPreview;
struct Document;
struct SceneBody;
struct SurfacePoint;

/// An open, running document: its body, the current stroke, the hands, the timeline, the recorder
/// and the readout. Each is a separate part; this class has what connects several of them.
///
/// A stroke needs steps to cut. While paused, each of its poses runs one step, without time unless
/// time runs while cutting.
class EditorScene {
  public:
    /// Opens `document`, whose body `body` is. Throws gpu::OutOfMemory.
    EditorScene(Document document, BodyUpload body);
    ~EditorScene();
    EditorScene(const EditorScene&) = delete;
    EditorScene& operator=(const EditorScene&) = delete;

    /// Executes a command of a person, apart from strokes. Returns "" or one sentence.
    std::string execute(const Command& command);
    /// Places a model: unit, rotation, scale. It stands on the floor below its old place, and all
    /// models are uncut; the translation of `wanted` is ignored. `continues`: with the gesture of
    /// the previous placement. Returns "" or one sentence.
    std::string place(const Placement& wanted, bool continues, int model = 0);
    /// One step with what is due before it: the session's events, or the next pose of the stroke.
    void step();
    /// Back to the uncut body, paused, with the present parameters. An open session will be played
    /// from its start, or a task from its first cut on, and what was done since cannot be undone.
    void reset();
    /// Seeks to a step of the session or of the past, before its events, at once if it is
    /// kept; otherwise SceneTimeline::seekSteps() are left to do. Later actions play again from
    /// there, until the user cuts or pulls: then they are discarded.
    void seek(int step);
    /// Shows an opened session at its end: at once if that is stored, otherwise by seeking.
    void goToEnd();
    /// SceneTimeline::recall(), at its first step.
    void recallHistory();
    /// Restarts, and adds a check of the state from time to time.
    void startRecording();
    /// Whether steps are due: time runs, or a stroke or a seek is in progress.
    bool running() const;
    /// Steps that the stroke needs in the coming frame to keep up with the pointer.
    int strokeSteps() const;
    /// Whether time runs while a stroke is cut in a pause; otherwise the stroke cuts where it was
    /// aimed, and costs no more than the cut.
    bool timeRunsWhileCutting = false;
    /// Finds the point at which a ray hits the present body.
    std::optional<SurfacePoint> pick(const render::Ray& ray);
    /// Finds where a blade would cut the body on its path.
    const CutPreview& preview(const std::vector<Blade>& way);
    /// Messages for the user: those of the simulation, and differences from checks.
    std::vector<std::string> takeMessages();
    /// Fills in what the panels show of the scene.
    void describe(ui::PanelModel& model);

    // Its parts.
    const Document& document() const;
    Simulation& simulation();
    const Simulation& simulation() const;
    SceneBody& body();
    const RestOfBody& rest() const;
    /// The stroke; its first pose ends the played session.
    BladeStroke& stroke();
    const BladeStroke& stroke() const;
    HeldHands& hands();
    const HeldHands& hands() const;
    SceneTimeline& timeline();
    const SceneTimeline& timeline() const;
    SceneRecorder& recorder();
    const SceneRecorder& recorder() const;
    SceneReadout& readout();
    const SceneReadout& readout() const;

  private:
    std::optional<SetParam> undoneWhileCutting(const Command& command) const;
    void startAnew();
    void forgetStroke();
    void chooseAsBefore(const Params& before);
    void letTimeRunAsWanted(bool cuts);
    void putUp(const std::vector<StaticBox>& boxes);

    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace kerf::app
