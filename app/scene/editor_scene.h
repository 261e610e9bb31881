#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/scene/cut_quality.h"
#include "app/scene/editor_document.h"
#include "app/scene/editor_readings.h"
#include "app/scene/editor_stroke.h"
#include "app/scene/hooks.h"
#include "app/scene/incision.h"
#include "app/scene/keyframes.h"
#include "app/scene/saved_session.h"
#include "app/scene/session_journal.h"
#include "app/scene/session_playback.h"
#include "app/scene/surface_look.h"
#include "app/scene/thickness_map.h"
#include "app/session/session_change.h"
#include "app/session/session_runner.h"
#include "app/session/skin_follower.h"
#include "app/session/volume_watch.h"
#include "render/renderer.h"
#include "sim/mesh/triangle_quality.h"
#include "sim/run/simulation.h"
#include "sim/solve/sweep_strength.h"
#include "ui/panel_model.h"

namespace kerf::app {

/// An open document as it runs: the simulation, the stroke that is being drawn, the session that
/// is being played, what was done since the start, and what the plots remember.
///
/// A stroke needs steps to cut. While time is paused, each of its poses runs one step, in which
/// time stands unless it is to run while cutting.
class EditorScene {
  public:
    /// Opens `document`, whose body `body` is. Throws gpu::OutOfMemory.
    EditorScene(Document document, BodyUpload body);
    EditorScene(const EditorScene&) = delete;  // the playback points into the document
    EditorScene& operator=(const EditorScene&) = delete;

    /// Executes a command of a person, apart from strokes. Returns "" or one sentence.
    std::string execute(const Command& command);
    /// One step with what is due before it: the session's events, or the next pose of the stroke.
    void step();
    /// Back to the uncut body, paused, with the parameters as they are. Where a session is open, it
    /// will be played from its start, and what was done since cannot be undone.
    void reset();

    // Where the model lies.
    /// Places a model otherwise: in another unit, turned, scaled. It stands on the floor below
    /// where it was, and all models are uncut; the translation of `wanted` does not matter.
    /// `continues`: with the gesture of the placement before. Returns "" or one sentence.
    std::string place(const Placement& wanted, bool continues, int model = 0);
    /// The command by which place() does that.
    Place placeCommand(const Placement& wanted, bool continues, int model = 0);
    /// The models as they lie at rest, the parameters and the boxes, as a session without events.
    Session startOfScene() const;
    /// Whether a person has changed anything since the start.
    bool hasChanged() const { return journal_.firstChange().has_value(); }
    /// Figures of one model of the uncut body at rest.
    struct ModelFigures {
        Bounds bounds;      ///< [m]
        double volume = 0;  ///< [m^3]
        TriangleFigures triangles;
    };
    /// Figures of the uncut body at rest.
    struct RestFigures {
        Bounds bounds;  ///< [m]
        std::vector<ModelFigures> models = {};
    };
    const RestFigures& rest() const { return rest_; }
    /// The edge length to propose for a model of the scene, in the unit of its file.
    double proposedEdge(int model) const;
    /// The view that shows the uncut body: the first one, or one like it after a placement.
    const render::Camera& homeView() const { return homeView_; }
    /// Grows when the uncut body became another one, as by a placement or its undo.
    int placementRevision() const { return placementRevision_; }

    // The stroke.
    /// Its first pose ends the session that is played: a person goes on alone.
    BladeStroke& stroke() { return stroke_; }
    const BladeStroke& stroke() const { return stroke_; }
    /// Steps that the stroke needs for the coming picture so as not to fall behind the hand.
    int strokeSteps() const;

    // Hands that pull at the body. Time runs while they do.
    /// Takes hold with a person's hand of what lies about `at`, along the surface and on one side
    /// of a cut; `wanted` [m] is the most that it reaches. Returns "" or one sentence.
    std::string grab(const Vec3& at, double wanted);
    /// How far such a hand reaches at a point of the surface [m].
    double reachOfHand(const Vec3& at, double wanted);
    /// Hooks both lips of a cut. Returns the first of the two hooks, or one sentence.
    std::variant<int, std::string> hook(const Incision& incision);
    /// Moves a hand to where it is in the coming steps [m].
    void dragTo(const Vec3& to, int hand = kPersonsHand) { dragTo_[hand] = to; }
    /// The person's hand lets go; hooks hold on, and time runs on until they have arrived.
    void letGo();
    bool pulling() const { return pulling_ || settling_ > 0; }
    /// Lets time run on for a while, also in a pause: for what hooks and pins hold to follow them.
    void settle();
    /// The hooks of all retractors, by number.
    std::vector<Hands::Hand> hooks() const { return hooksOf(simulation_.hands()); }
    /// Takes away the retractor that a hook belongs to.
    void removeRetractor(int hook);

    /// Whether time runs while a stroke is cut in a pause; otherwise it stands, so that the stroke
    /// cuts where it was aimed, and costs no more than the cut.
    bool timeRunsWhileCutting = false;

    // The course: the session that is played, or what was done since the start.
    bool playing = false;
    /// Whether steps are due: time runs, or a stroke or a seek is under way.
    bool running() const;
    /// Tells whether events of the session are still to come.
    bool playingBack() const;
    /// Goes to a step of it, at once where it is a keyframe; otherwise seekSteps() are left to do.
    /// What was done after a step that lies back plays again from there, until a person takes
    /// blade or body in hand: then it is left out.
    void seek(int step);
    /// Whether what was done after the present is still to come.
    bool inThePast() const { return playback_ && playback_->isPast(); }
    int seekSteps() const;
    void stopSeeking() { seekTarget_.reset(); }
    void toggleLoop();

    // Recording.
    /// Starts anew and adds a check of the state now and then.
    void startRecording();
    void stopRecording() { recording_ = false; }
    bool recording() const { return recording_; }
    /// Writes down all that was done since the start, as a session that ends here with a check of
    /// the state. A session that is played is written whole, with what a person added, wherever it
    /// stands; it keeps its view. Other documents get `camera`, unless useView() gave one to them.
    SavedSession savedSession(const render::Camera& camera, const render::ChosenColors& colors,
                              SavedAs purpose = SavedAs::session);
    /// What has become since the last call of the events that savedSession() would have, but for
    /// its last check; all of them where `whole`.
    SessionChange takeChange(bool whole);
    /// That session without events.
    Session sessionWithoutEvents(const render::Camera& camera,
                                 const render::ChosenColors& colors) const;
    /// Grows with all that a person does that a saved session would have.
    int deeds() const { return journal_.deeds() + (document_.inFile ? 0 : 1); }
    /// The view for the pictures of the session.
    void useView(const render::Camera& camera) { chosenView_ = camera; }

    // Pictures, exports and checks of the session.
    /// The present in the session, to add a picture of it later on.
    JournalPlace here() const { return journal_.here(simulation_.stepCount()); }
    /// The last place in the session as it would be saved now.
    JournalPlace end() const;
    /// Whether a replay of the session would take any.
    bool takesPictures() const;
    /// Adds a picture under a name of its own, which it returns.
    std::string addPicture(const JournalPlace& place);
    /// Adds an export of the body as it is under a name of its own, which it returns.
    std::string addExport();
    /// Adds a check of the state as it is.
    void addCheck();
    /// From there a film of the session shall be seen at this step.
    void addCamera(const render::Camera& camera);
    /// Takes out one of those by its ui::SessionMark::id.
    void removeMark(int id) { journal_.remove(id); }

    /// Notes a picture while time runs: how long after the one before it came [s], and how long it
    /// took to draw [ms].
    void recordPicture(double elapsedSeconds, double renderMs);
    const EditorReadings& readings() const { return readings_; }

    const Document& document() const { return document_; }
    Simulation& simulation() { return simulation_; }
    const Simulation& simulation() const { return simulation_; }
    /// The point at which a ray meets the body as it is.
    std::optional<SurfacePoint> pick(const render::Ray& ray) {
        return look_.pick(simulation_, ray);
    }
    /// The places where a blade would meet the body on its way.
    const CutPreview& preview(const std::vector<Blade>& way) {
        return look_.preview(simulation_, way);
    }
    /// Lets the thickness of the body be worked out where it is `wanted` and time stands. True
    /// where it is another than in the last view().
    bool followThickness(bool wanted) { return thickness_.follow(simulation_, wanted, !running()); }
    const ThicknessMap& thickness() const { return thickness_; }
    /// Lets the quality of the cuts be measured where it is `wanted`, between strokes. True where
    /// the panels have something else to show.
    bool followCuts(bool wanted) { return cuts_.follow(simulation_, wanted); }
    const CutQuality& cuts() const { return cuts_; }
    /// Adds up areas and middles of the pieces where they are `wanted`, while time stands and
    /// nothing is cut. True where they are other ones than before.
    bool followPieceSums(bool wanted);
    /// The pieces as they are now, with their sums.
    const std::vector<ui::PieceRow>& measurePieces();
    /// Number of searches through the triangles that pick() and preview() needed, for tests.
    int surfaceSearches() const { return look_.searches(); }
    /// Number of pieces after the last step: 1 for an uncut body.
    int pieceCount() const { return simulation_.report().pieces; }
    /// Bounds of the body as it is.
    const Bounds& bounds() const { return simulation_.bounds(); }
    /// Sentences for the person: those of the simulation, and what came out differently.
    std::vector<std::string> takeMessages();

    /// What is poor about the triangles of the model as it was opened; see Document::faults.
    const repair::Faults& faults() const { return document_.faults; }
    /// The same as marks on the body as it is, as far as those triangles are still whole.
    const std::shared_ptr<const std::vector<render::Marks>>& faultMarks();

    /// The scene for the renderer.
    render::SceneView view();
    /// Fills in what the panels show of the scene.
    void describe(ui::PanelModel& model);

  private:
    static constexpr int kPersonsHand = 0;  ///< its number among the hands

    std::string perform(const Command& wanted);
    void followUndo(const Params& before);
    void followPlacement();
    void moveHands();
    void releaseHandsButHooks();
    void letGoForGood();
    bool playsOnAfter(const Command& command) const;
    void letTimeRunAsWanted(bool cuts);
    void takeBlade();
    std::vector<PlayedAction> movesOnTheirWay() const;
    void playSessionEvents();
    void play(JournalEntry& entry);
    void tell(std::string message);
    void keepKeyframe();
    void goTo(int step, const Keyframe& keyframe);
    bool goesBack(int step) const;
    void playPast();
    void endPast();
    void countFromHere();
    void beginPlayback();
    void wrapPlayback();
    void atEndOfSession();
    void addMark(const JournalPlace& place, SessionAction action);
    bool isUntouched() const;
    int stepsAsSaved() const;
    bool endsNow() const;
    CheckEvent checkOfNow();
    void setView(Session& session, const render::Camera& camera,
                 const render::ChosenColors& colors) const;
    void startAnew();
    void putUp(const std::vector<StaticBox>& boxes);
    void checkNowAndThen();
    void watchVolumes(const StepReport& report);
    void refreshPieces();
    void describeModels(ui::PanelModel& model) const;
    void describeChanges(ui::ChangeList& list) const;
    void describePlayback(ui::PlaybackState& state) const;
    void describeMarks(ui::PanelModel& model);
    double timeNow() const { return simulation_.report().time - start_.time; }

    Document document_;
    render::Camera homeView_;
    Simulation simulation_;
    std::shared_ptr<const UncutBody> uncut_ = simulation_.uncut();
    RestFigures rest_;  ///< of `uncut_`
    SweepStrength sweeps_;
    int placementRevision_ = 0;
    SessionRunner runner_{simulation_};
    /// Of a session with events, or of the past, until a person cuts.
    std::optional<SessionPlayback> playback_;
    Keyframes keyframes_;
    std::optional<int> seekTarget_;
    BladeStroke stroke_;
    std::vector<SetParam> choices_;  ///< of a person, one per name; a played session keeps them
    bool pulling_ = false;
    int settling_ = 0;            ///< steps that time runs on for what was let go or hooked
    std::map<int, Vec3> dragTo_;  ///< where hands are to go, until they are told
    SessionJournal journal_;
    std::optional<render::Camera> chosenView_;
    bool recording_ = false;
    bool recorded_ = false;  ///< the document was begun anew by a recording
    CountStart start_;
    SurfaceLook look_;
    SkinFollower skin_{document_.looks};
    ThicknessMap thickness_;
    CutQuality cuts_;
    EditorReadings readings_;
    VolumeWatch volumes_;
    std::shared_ptr<const std::vector<render::Marks>> faultMarks_;
    int marksTriangles_ = -1;  ///< of the body that those are of
    std::vector<std::string> messages_;
    std::vector<ui::PieceRow> pieces_;
    int sumsRevision_ = -1;  ///< of the body that the sums in pieces_ are of
    int piecesStep_ = -1;    ///< step that pieces_ tells of
    int piecesTriangles_ = -1;
    std::vector<ui::SessionMark> marks_;
    std::vector<ui::SessionMark> course_;
    int marksRevision_ = -1;        ///< of the journal that both tell of
    std::size_t marksEntries_ = 0;  ///< its length then
};

}  // namespace kerf::app
