#include "app/scene/editor_scene.h"

#include <algorithm>
#include <utility>

#include "app/session/scene_view.h"
#include "sim/body/rest_geometry.h"

namespace kerf::app {
namespace {

constexpr std::size_t kStrokeBacklog = 8;         // poses that may wait per step of a picture
constexpr int kMaxStrokeSteps = 4;                // per picture
constexpr std::size_t kUndoBudget = 512'000'000;  // [bytes]
constexpr int kPersonsHand = 0;                   // its number among the hands
constexpr int kCheckEvery = 50;                   // steps of a recording
constexpr int kPiecesEvery = 10;                  // steps between two looks at the pieces' volumes

bool takesBodyElsewhere(const Command& command) {
    return std::holds_alternative<Undo>(command) || std::holds_alternative<Redo>(command) ||
           std::holds_alternative<Restart>(command);
}

/// Of a command that takes the body elsewhere, in the plots.
const char* markOf(const Command& command) {
    if (std::holds_alternative<Undo>(command)) {
        return "undo";
    }
    return std::holds_alternative<Redo>(command) ? "redo" : "restart";
}

}  // namespace

EditorScene::EditorScene(Document document, BodyUpload body)
    : document_(std::move(document)),
      edgeLength_(meanRestEdgeLength(document_.mesh)),
      simulation_(std::move(body), document_.session.params, document_.session.boxes) {
    simulation_.setUndoBudget(kUndoBudget);
    startAnew();
}

/// With a simulation at its start.
void EditorScene::startAnew() {
    playing = false;
    pulling_ = false;
    dragTo_.reset();
    stroke_.clear();
    runner_.setStrokePoses({});
    journal_.clear();
    readings_.clear();
    volumes_ = {};
    start_ = {};
    seekTarget_.reset();
    const bool loop = playback_ && playback_->loop;
    playback_.reset();
    if (!document_.session.events.empty()) {
        playback_.emplace(document_.session).loop = loop;
    }
    for (const SetParam& choice : choices_) {
        if (getParam(simulation_.params(), choice.name) != choice.value) {
            perform(choice);
        }
    }
    refreshPieces();
}

// --- What is done to the body ------------------------------------------------------------------

/// The one way in which anything reaches the simulation.
std::string EditorScene::perform(const Command& command) {
    std::string problem = simulation_.execute(command);
    if (problem.empty()) {
        journal_.note(simulation_.stepCount(), command);
    }
    return problem;
}

std::string EditorScene::execute(const Command& command) {
    if (takesBodyElsewhere(command)) {
        takeBlade();
        letGo();
        stroke_.clear();
        runner_.setStrokePoses({});
    } else if (playback_) {
        playback_->changedAt(simulation_.stepCount());
    }
    const Params before = simulation_.params();
    std::string problem = perform(command);
    if (problem.empty() && takesBodyElsewhere(command)) {
        followUndo(before);
        volumes_ = {};
        releaseAllHands();
        readings_.addJump(timeNow(), simulation_);
        readings_.mark(timeNow(), markOf(command));
        refreshPieces();
    }
    if (const auto* set = std::get_if<SetParam>(&command); set != nullptr && problem.empty()) {
        std::erase_if(choices_, [&](const SetParam& old) { return old.name == set->name; });
        choices_.push_back(*set);
    }
    return problem;
}

/// What an undo took back, or a redo brought back, is chosen no more, or again.
void EditorScene::followUndo(const Params& before) {
    for (SetParam& choice : choices_) {
        const ParamValue now = getParam(simulation_.params(), choice.name);
        if (now != getParam(before, choice.name)) {
            choice.value = now;
        }
    }
}

std::string EditorScene::grab(const Vec3& at, double radius) {
    takeBlade();
    letGo();
    std::string problem = perform(Grab{kPersonsHand, at, radius});
    pulling_ = problem.empty();
    return problem;
}

void EditorScene::moveHand() {
    if (pulling_ && dragTo_) {
        perform(Drag{kPersonsHand, *dragTo_});
    }
    dragTo_.reset();
}

void EditorScene::letGo() {
    dragTo_.reset();
    if (std::exchange(pulling_, false)) {
        perform(Release{kPersonsHand});
    }
}

/// After an undo or a redo hands may hold what nobody drags any more.
void EditorScene::releaseAllHands() {
    while (!simulation_.hands().empty()) {
        perform(Release{simulation_.hands().front().number});
    }
}

void EditorScene::takeBlade() {
    if (playingBack()) {
        releaseAllHands();
        if (simulation_.blade()) {
            perform(LiftBlade{});
        }
    }
    playback_.reset();
    seekTarget_.reset();
}

void EditorScene::reset() {
    if (!document_.session.events.empty()) {
        simulation_.reset();
        startAnew();
        return;
    }
    playing = false;
    letGo();
    stroke_.clear();
    runner_.setStrokePoses({});
    perform(Restart{});
    start_ = {simulation_.stepCount(), simulation_.report().time};
    readings_.clear();
    volumes_ = {};
    refreshPieces();
}

void EditorScene::step() {
    keepKeyframe();
    if (const std::optional<Command> command = stroke_.next()) {
        perform(*command);
    } else if (playingBack()) {
        playSessionEvents();
    }
    moveHand();
    const int piecesBefore = pieceCount();
    const StepReport& report = runner_.step();
    if (report.pieces != piecesBefore) {
        readings_.mark(timeNow(), "cut");
    }
    readings_.addStep(timeNow(), simulation_);
    watchVolumes(report);
    checkNowAndThen();
    wrapPlayback();
}

void EditorScene::watchVolumes(const StepReport& report) {
    if (!report.open && volumes_.add(report.step, simulation_.measuredPieces())) {
        messages_.push_back(volumes_.sentence());
    }
}

int EditorScene::strokeSteps() const {
    const int backlog = static_cast<int>((stroke_.pending() + kStrokeBacklog - 1) / kStrokeBacklog);
    return std::min(backlog, kMaxStrokeSteps);
}

// --- The session that is played ----------------------------------------------------------------

bool EditorScene::playingBack() const {
    return playback_.has_value() && simulation_.stepCount() < playback_->steps();
}

/// What the events of a played session do here: what goes wrong is a message.
struct EditorScene::PlaybackHost {
    EditorScene& scene;

    void perform(const Command& command, int) { tell(scene.perform(command)); }
    void take(const CheckEvent& check) {
        tell(scene.playback_->compare(check, scene.runner_.compare(check),
                                      scene.simulation_.stepCount()));
    }
    template <class Event>
    void take(const Event&) {}  // pictures and exports are a replay's: a person only watches

    void tell(std::string message) {
        if (!message.empty()) {
            scene.messages_.push_back(std::move(message));
        }
    }
};

void EditorScene::playSessionEvents() {
    runner_.applyActions(playback_->player(), PlaybackHost{*this});
}

void EditorScene::keepKeyframe() {
    const int step = simulation_.stepCount();
    if (playback_ && playback_->wantsKeyframe(step)) {
        playback_->keep(step, {simulation_.moment(), journal_.mark(), runner_.strokePoses()},
                        snapshotBytes(simulation_.mesh()));
    }
}

void EditorScene::seek(int step) {
    if (!playback_) {
        return;
    }
    step = std::clamp(step, 0, playback_->steps());
    const int from = playback_->keyframeStepBefore(step);
    const int now = simulation_.stepCount();
    if (from >= 0 && (step < now || from > now)) {
        goTo(from, *playback_->keyframeBefore(step));
    }
    seekTarget_ = step;
}

void EditorScene::goTo(int step, const Keyframe& keyframe) {
    simulation_.goTo(keyframe.moment);
    journal_.goBackTo(keyframe.journal);
    runner_.setStrokePoses(keyframe.strokePoses);
    stroke_.clear();
    pulling_ = false;
    dragTo_.reset();
    playback_->wentTo(step);
    readings_.forgetAfter(timeNow());
    refreshPieces();
}

int EditorScene::seekSteps() const {
    return seekTarget_ ? std::max(0, *seekTarget_ - simulation_.stepCount()) : 0;
}

void EditorScene::toggleLoop() {
    if (playback_) {
        playback_->loop = !playback_->loop;
    }
}

/// At its end a session stops once, or begins again.
void EditorScene::wrapPlayback() {
    if (seekSteps() == 0) {
        seekTarget_.reset();
    }
    if (!playback_ || simulation_.stepCount() != playback_->steps()) {
        return;
    }
    playSessionEvents();
    if (playing && playback_->loop) {
        seek(0);
        seekTarget_.reset();
    } else {
        playing = false;
    }
}

// --- Recording ---------------------------------------------------------------------------------

void EditorScene::startRecording() {
    const std::vector<StaticBox> boxes = simulation_.boxes();
    simulation_.reset();
    playback_.reset();
    document_.session.events.clear();
    startAnew();
    putUp(boxes);
    recording_ = true;
}

/// Instead of the boxes there are.
void EditorScene::putUp(const std::vector<StaticBox>& boxes) {
    if (boxes == simulation_.boxes()) {
        return;
    }
    while (!simulation_.boxes().empty()) {
        perform(RemoveBox{0});
    }
    for (const StaticBox& box : boxes) {
        perform(AddBox{box});
    }
}

void EditorScene::checkNowAndThen() {
    const int step = simulation_.stepCount();
    if (recording_ && step % kCheckEvery == 0) {
        journal_.note(step, CheckEvent{simulation_.stateHash(), pieceCount()});
    }
}

Session EditorScene::recordedSession(const render::Camera& camera,
                                     const render::ChosenColors& colors) {
    Session session = document_.session;
    session.warnings.clear();
    session.events = journal_.events();
    session.steps = std::max(1, simulation_.stepCount());
    if (simulation_.stepCount() > 0) {
        session.events.push_back(
            {session.steps, CheckEvent{simulation_.stateHash(), pieceCount()}});
    }
    session.view = camera;
    session.colors = colors;
    return session;
}

// --- What is shown -----------------------------------------------------------------------------

std::vector<std::string> EditorScene::takeMessages() {
    std::vector<std::string> messages = simulation_.takeMessages();
    messages.insert(messages.end(), messages_.begin(), messages_.end());
    messages_.clear();
    return messages;
}

void EditorScene::recordPicture(double elapsedSeconds, double renderMs) {
    readings_.addPicture(timeNow(), elapsedSeconds, renderMs);
}

render::SceneView EditorScene::view() {
    return sceneOf(simulation_, lookOf(document_.session), document_.restBounds,
                   runner_.strokePoses());
}

void EditorScene::refreshPieces() {
    pieces_.clear();
    for (const Piece& piece : simulation_.measuredPieces()) {
        pieces_.push_back({piece.triangles, piece.volume,
                           piece.restVolume > 0 ? piece.volume / piece.restVolume : 0});
    }
    piecesStep_ = simulation_.stepCount();
    piecesTriangles_ = simulation_.report().triangles;
}

void EditorScene::describeChanges(ui::ChangeList& list) const {
    const UndoHistory& history = simulation_.history();
    list.rows.clear();
    for (const UndoEntry& entry : history.entries()) {
        list.rows.push_back({entry.name, entry.time});
    }
    list.done = history.done();
    list.forgotten = history.forgotten();
    list.bytes = history.bytes();
    list.budget = history.budget();
}

void EditorScene::describe(ui::PanelModel& model) {
    const int age = simulation_.stepCount() - piecesStep_;
    const bool recut = simulation_.report().triangles != piecesTriangles_;
    if (recut || age >= kPiecesEvery || (age != 0 && !playing)) {
        refreshPieces();
    }
    const StepReport& report = simulation_.report();
    model.name = document_.name;
    model.params = simulation_.params();
    model.startParams = document_.session.params;
    model.boxes = simulation_.boxes();
    model.bodySize = document_.restBounds.diagonal();
    model.edgeLength = edgeLength_;
    model.playing = playing;
    model.stroking = stroke_.drawing() || stroke_.pending() > 0;
    model.step = simulation_.stepCount() - start_.step;
    model.time = timeNow();
    describeChanges(model.changes);
    model.vertices = report.vertices;
    model.triangles = report.triangles;
    model.subdivisions = simulation_.subdivisions();
    model.pieces = pieces_;
    model.history = &readings_.history();
    model.recording = recording_;
    describePlayback(model.playback);
}

void EditorScene::describePlayback(ui::PlaybackState& state) const {
    if (playback_) {
        state = {simulation_.stepCount(), playback_->steps(), playback_->loop,
                 playback_->divergedAt()};
    }
}

}  // namespace kerf::app
