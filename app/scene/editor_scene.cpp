#include "app/scene/editor_scene.h"

#include "app/scene/document/editor_document.h"
#include "app/scene/editor_stroke.h"
#include "app/scene/held_hands.h"
#include "app/scene/readout/scene_readout.h"
#include "app/scene/timeline/scene_recorder.h"
#include "sim/run/start/prepared_body.h"
#include "sim/run/undo/undo_history.h"

namespace kerf::app {
namespace {

constexpr std::size_t kStrokeBacklog = 8;  // poses that may wait per step of a picture
constexpr int kMaxStrokeSteps = 4;         // per picture

bool takesBodyElsewhere(const Command& command) {
    return std::holds_alternative<Undo>(command) || std::holds_alternative<Redo>(command) ||
           std::holds_alternative<Restart>(command) || std::holds_alternative<Place>(command);
}

/// Of a command after which the body is another, in the plots.
const char* markOf(const Command& command) {
    if (std::holds_alternative<Undo>(command)) {
        return "undo";
    }
    if (std::holds_alternative<Place>(command)) {
        return "placed";
    }
    if (std::holds_alternative<RemovePiece>(command)) {
        return "deleted";
    }
    return std::holds_alternative<Redo>(command) ? "redo" : "restart";
}

/// The step of it; the last one of a session without cuts.
int firstCut(const Session& session) {
    const auto first = std::ranges::find_if(session.events, [](const SessionEvent& event) {
        return std::holds_alternative<MoveBlade>(event.action);
    });
    return first == session.events.end() ? session.steps : first->step;
}

}  // namespace

struct EditorScene::Parts {
    Parts(Document document, BodyUpload upload) : body(std::move(document), std::move(upload)) {}

    SceneBody body;
    SceneTimeline timeline{body};
    BladeStroke stroke;
    HeldHands hands{body, timeline};
    SceneRecorder recorder{body, timeline};
    SceneReadout readout{body, timeline};
    std::vector<SetParam> choices;  ///< of a person, one per name; a played session keeps them
};

EditorScene::EditorScene(Document document, BodyUpload body)
    : parts_(std::make_unique<Parts>(std::move(document), std::move(body))) {
    simulation().setUndoBudget(kUndoBudget);
    startAnew();
}

EditorScene::~EditorScene() = default;

/// With a simulation at its start.
void EditorScene::startAnew() {
    hands().forget();
    forgetStroke();
    timeline().startAnew();
    for (const SetParam& choice : parts_->choices) {
        if (getParam(simulation().params(), choice.name) != choice.value) {
            timeline().perform(choice);
        }
    }
    readout().startAnew();
}

void EditorScene::forgetStroke() {
    stroke().clear();
    body().driver.forgetStroke();
}

// --- What is done to the body ------------------------------------------------------------------

std::string EditorScene::place(const Placement& wanted, bool continues, int model) {
    return execute(body().placeCommand(wanted, continues, model));
}

/// The parameter that an undo during a played stroke reverts: as a change of it, since an undo
/// would end the stroke.
std::optional<SetParam> EditorScene::undoneWhileCutting(const Command& command) const {
    const UndoHistory& history = simulation().history();
    if (!std::holds_alternative<Undo>(command) || !timeline().playingBack() ||
        !simulation().blade() || !history.canUndo()) {
        return std::nullopt;
    }
    const auto* change = std::get_if<UndoEntry::ParamChange>(&history.lastDone().change);
    return change ? std::optional(SetParam{change->param, change->before, true}) : std::nullopt;
}

std::string EditorScene::execute(const Command& command) {
    if (const std::optional<SetParam> reverted = undoneWhileCutting(command)) {
        return execute(*reverted);
    }
    if (std::holds_alternative<Redo>(command) && !simulation().history().canRedo()) {
        return timeline().perform(command);  // is refused, and changes nothing
    }
    if (std::holds_alternative<MovePins>(command)) {
        timeline().takeOver();
        hands().settle();
    }
    if (takesBodyElsewhere(command)) {
        if (!timeline().playsOnAfter(command)) {
            timeline().takeOver();
        }
        hands().letGoForGood();
        forgetStroke();
    }
    const bool removes = std::holds_alternative<RemovePiece>(command);
    if (removes && !simulation().blade()) {
        timeline().takeOver();
    }
    const Params before = simulation().params();
    const bool bladeIsDown = simulation().blade() && simulation().bladeActions().empty();
    std::string problem = timeline().perform(command);
    if (!problem.empty() && bladeIsDown && takesBodyElsewhere(command)) {
        timeline().perform(LiftBlade{});  // its stroke has been forgotten
    }
    if (problem.empty() && takesBodyElsewhere(command)) {
        chooseAsBefore(before);
        timeline().releaseHandsButHooks();
    }
    if (problem.empty() && (takesBodyElsewhere(command) || removes)) {
        readout().addJump(markOf(command));
    }
    if (const auto* set = std::get_if<SetParam>(&command); set != nullptr && problem.empty()) {
        std::erase_if(parts_->choices, [&](const SetParam& old) { return old.name == set->name; });
        parts_->choices.push_back(*set);
    }
    return problem;
}

/// What an undo took back, or a redo brought back, is chosen no more, or again.
void EditorScene::chooseAsBefore(const Params& before) {
    for (SetParam& choice : parts_->choices) {
        const ParamValue now = getParam(simulation().params(), choice.name);
        if (now != getParam(before, choice.name)) {
            choice.value = now;
        }
    }
}

void EditorScene::reset() {
    if (!document().session.events.empty()) {
        simulation().reset();
        startAnew();
        if (document().session.task) {
            seek(firstCut(document().session));  // A cut before it would discard the pins.
        }
        return;
    }
    timeline().playing = false;
    timeline().takeOver();
    hands().letGoForGood();
    forgetStroke();
    timeline().perform(Restart{});
    timeline().countFromHere();
    readout().startAnew();
}

// --- Steps -------------------------------------------------------------------------------------

void EditorScene::step() {
    timeline().keepCheckpoint();
    const std::optional<Command> pose = stroke().next();
    if (pose) {
        timeline().takeOver();
        timeline().perform(*pose);
    } else if (timeline().playingBack() && timeline().playEvents()) {
        readout().startAnew();
    }
    hands().move();
    letTimeRunAsWanted(pose.has_value());
    const int piecesBefore = simulation().report().pieces;
    const StepReport& report = body().driver.step();
    body().followPlacement();  // by an event of the session
    readout().addStep(report, piecesBefore);
    timeline().noteTear(report);
    recorder().checkNowAndThen();
    const SceneTimeline::StepEnd end = timeline().endStep();
    if (end.countsAnew) {
        readout().startAnew();
    }
    if (end.loops) {
        seek(0);
        timeline().stopSeeking();
    }
}

/// A session that is played says itself when time stands.
void EditorScene::letTimeRunAsWanted(bool cuts) {
    const bool runs = timeline().playing || hands().pulling() || timeRunsWhileCutting || !cuts ||
                      document().session.task;
    if (!timeline().playingBack() && simulation().timeRuns() != runs) {
        timeline().perform(SetTime{runs});
    }
}

bool EditorScene::running() const {
    return timeline().playing || hands().pulling() || stroke().pending() > 0 ||
           timeline().seekSteps() > 0;
}

int EditorScene::strokeSteps() const {
    const int backlog =
        static_cast<int>((stroke().pending() + kStrokeBacklog - 1) / kStrokeBacklog);
    return std::min(backlog, kMaxStrokeSteps);
}

void EditorScene::seek(int step) {
    if (timeline().playback() == nullptr && timeline().goesBack(step)) {
        timeline().playing = false;
        hands().letGo();
        stroke().clear();
        if (simulation().blade()) {
            timeline().perform(LiftBlade{});
        }
        timeline().playPast();
    }
    if (const auto jump = timeline().seek(step)) {
        stroke().clear();
        hands().forget();
        readout().goBack(jump->countsAnew);
    }
}

void EditorScene::goToEnd() {
    if (document().session.events.empty()) {
        return;
    }
    timeline().noteReopened();
    const std::optional<StoredEnd> end = std::exchange(body().document.end, std::nullopt);
    if (end && timeline().goTo(*end)) {
        readout().startAnew();
    } else {
        seek(document().session.steps);
    }
}

void EditorScene::recallHistory() {
    timeline().recall();
    stroke().clear();
    hands().forget();
    readout().startAnew();
}

void EditorScene::startRecording() {
    const std::vector<StaticBox> boxes = simulation().boxes();
    const std::vector<PlacedModel> models = rest().uncut().models;
    simulation().reset();
    timeline().forgetSession();
    startAnew();
    putUp(boxes);
    for (int m = 0; m < simulation().modelCount(); ++m) {
        if (simulation().placement(m) != models[m].placement) {
            timeline().perform(Place{models[m].placement, false, m});
        }
    }
    recorder().start();
}

/// Instead of the boxes there are.
void EditorScene::putUp(const std::vector<StaticBox>& boxes) {
    if (boxes == simulation().boxes()) {
        return;
    }
    while (!simulation().boxes().empty()) {
        timeline().perform(RemoveBox{0});
    }
    for (const StaticBox& box : boxes) {
        timeline().perform(AddBox{box});
    }
}

// --- What is shown -----------------------------------------------------------------------------

std::optional<SurfacePoint> EditorScene::pick(const render::Ray& ray) {
    return readout().look().pick(simulation(), ray);
}

const CutPreview& EditorScene::preview(const std::vector<Blade>& way) {
    return readout().look().preview(simulation(), way);
}

std::vector<std::string> EditorScene::takeMessages() {
    std::vector<std::string> messages = simulation().takeMessages();
    const std::vector<std::string> own = std::exchange(body().messages, {});
    messages.insert(messages.end(), own.begin(), own.end());
    return messages;
}

void EditorScene::describe(ui::PanelModel& model) {
    readout().describe(model);
    model.transport.stroking = stroke().drawing() || stroke().pending() > 0;
    model.transport.recording = recorder().recording();
}

// --- Its parts ---------------------------------------------------------------------------------

const Document& EditorScene::document() const {
    return parts_->body.document;
}
Simulation& EditorScene::simulation() {
    return parts_->body.simulation;
}
const Simulation& EditorScene::simulation() const {
    return parts_->body.simulation;
}
SceneBody& EditorScene::body() {
    return parts_->body;
}
const RestOfBody& EditorScene::rest() const {
    return parts_->body.rest;
}
BladeStroke& EditorScene::stroke() {
    return parts_->stroke;
}
const BladeStroke& EditorScene::stroke() const {
    return parts_->stroke;
}
HeldHands& EditorScene::hands() {
    return parts_->hands;
}
const HeldHands& EditorScene::hands() const {
    return parts_->hands;
}
SceneTimeline& EditorScene::timeline() {
    return parts_->timeline;
}
const SceneTimeline& EditorScene::timeline() const {
    return parts_->timeline;
}
SceneRecorder& EditorScene::recorder() {
    return parts_->recorder;
}
const SceneRecorder& EditorScene::recorder() const {
    return parts_->recorder;
}
SceneReadout& EditorScene::readout() {
    return parts_->readout;
}
const SceneReadout& EditorScene::readout() const {
    return parts_->readout;
}

}  // namespace kerf::app
