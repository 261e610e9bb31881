#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

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

/// An open document as it runs: its body, the stroke that is being drawn, the hands that pull, its
/// way through the steps, what was done since the start, and what is read of all that. Each has a
/// part of its own; here stands what joins several of them.
///
/// A stroke needs steps to cut. While time is paused, each of its poses runs one step, in which
/// time stands unless it is to run while cutting.
class EditorScene {
  public:
    /// Opens `document`, whose body `body` is. Throws gpu::OutOfMemory.
    EditorScene(Document document, BodyUpload body);
    ~EditorScene();
    EditorScene(const EditorScene&) = delete;
    EditorScene& operator=(const EditorScene&) = delete;

    /// Executes a command of a person, apart from strokes. Returns "" or one sentence.
    std::string execute(const Command& command);
    /// Places a model otherwise: in another unit, turned, scaled. It stands on the floor below
    /// where it was, and all models are uncut; the translation of `wanted` does not matter.
    /// `continues`: with the gesture of the placement before. Returns "" or one sentence.
    std::string place(const Placement& wanted, bool continues, int model = 0);
    /// One step with what is due before it: the session's events, or the next pose of the stroke.
    void step();
    /// Back to the uncut body, paused, with the parameters as they are. Where a session is open, it
    /// will be played from its start, and what was done since cannot be undone.
    void reset();
    /// Goes to a step of the session or of the past, at once where it is a keyframe; otherwise
    /// SceneTimeline::seekSteps() are left to do. What was done after a step that lies back plays
    /// again from there, until a person takes blade or body in hand: then it is left out.
    void seek(int step);
    /// Starts anew and adds a check of the state now and then.
    void startRecording();
    /// Whether steps are due: time runs, or a stroke or a seek is under way.
    bool running() const;
    /// Steps that the stroke needs for the coming picture so as not to fall behind the hand.
    int strokeSteps() const;
    /// Whether time runs while a stroke is cut in a pause; otherwise it stands, so that the stroke
    /// cuts where it was aimed, and costs no more than the cut.
    bool timeRunsWhileCutting = false;
    /// Finds the point at which a ray meets the body as it is.
    std::optional<SurfacePoint> pick(const render::Ray& ray);
    /// Finds the places where a blade would meet the body on its way.
    const CutPreview& preview(const std::vector<Blade>& way);
    /// Sentences for the person: those of the simulation, and what came out differently.
    std::vector<std::string> takeMessages();
    /// Fills in what the panels show of the scene.
    void describe(ui::PanelModel& model);

    // Its parts.
    const Document& document() const;
    Simulation& simulation();
    const Simulation& simulation() const;
    SceneBody& body();
    const RestOfBody& rest() const;
    /// The stroke; its first pose ends the session that is played: a person goes on alone.
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
    void startAnew();
    void forgetStroke();
    void chooseAsBefore(const Params& before);
    void letTimeRunAsWanted(bool cuts);
    void putUp(const std::vector<StaticBox>& boxes);

    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace kerf::app
