#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/editor_document.h"
#include "app/editor_stroke.h"
#include "render/renderer.h"
#include "sim/simulation.h"
#include "ui/panel_model.h"

namespace kerf::app {

/// An open document as it runs: the simulation, the stroke that is being drawn, the session that
/// is being played, and what the plots remember.
///
/// A stroke needs steps to cut. While time is paused, each of its poses runs one step, so that the
/// cut opens under the pointer; once the blade is lifted, time stands still again.
class EditorScene {
  public:
    /// Throws gpu::ShaderError, gpu::OutOfMemory.
    explicit EditorScene(Document document);
    EditorScene(const EditorScene&) = delete;  // the player points into the document
    EditorScene& operator=(const EditorScene&) = delete;

    /// What a person does apart from strokes. Returns "" or one sentence.
    std::string execute(const Command& command);
    /// One step with what is due before it: the session's events, or the next pose of the stroke.
    void step();
    /// Back to the uncut body, paused, with the parameters as they are. Where a session is open, it
    /// will be played from its start, and what was done since cannot be undone.
    void reset();

    // The stroke.
    void beginStroke(const StrokeSpace& space, const Vec2& ndc);
    BladeStroke& stroke() { return stroke_; }
    const BladeStroke& stroke() const { return stroke_; }

    bool playing = false;
    /// Whether the session's own events are still to come.
    bool playingBack() const;
    /// Steps that the stroke needs for the coming picture so as not to fall behind the hand.
    int strokeSteps() const;
    /// Notes how fast pictures follow each other while time runs.
    void recordFrameRate(double framesPerSecond);

    const Document& document() const { return document_; }
    Simulation& simulation() { return simulation_; }
    const Simulation& simulation() const { return simulation_; }
    /// As a number of the last report: 1 for an uncut body.
    int pieceCount() const { return simulation_.report().pieces; }
    /// Bounds of the body as it is.
    const Bounds& bounds() const { return simulation_.bounds(); }
    /// Sentences that the simulation left for the person.
    std::vector<std::string> takeMessages() { return simulation_.takeMessages(); }

    /// What the renderer shows.
    render::SceneView view();
    /// What the panels show of it.
    void describe(ui::PanelModel& model);

  private:
    void playSessionEvents();
    void endPlayback();
    void record();
    void refreshPieces();
    void describeChanges(ui::ChangeList& list) const;
    double timeNow() const { return simulation_.report().time - start_.time; }

    Document document_;
    Simulation simulation_;
    std::optional<SessionPlayer> player_;
    BladeStroke stroke_;
    std::vector<SetParam> choices_;  ///< of a person, one per name; a played session keeps them
    /// The last restart: what the panels count from.
    struct Start {
        int step = 0;
        double time = 0;  ///< [s]
    } start_;
    ui::History history_;
    std::vector<ui::PieceRow> pieces_;
    int piecesStep_ = -1;  ///< step that pieces_ tells of
    int piecesTriangles_ = -1;
};

}  // namespace kerf::app
