#include "app/scene/editor_scene.h"

#include <algorithm>
#include <utility>

#include "app/scene/session_marks.h"
#include "app/scene/size_effect.h"
#include "app/scene/triangle_text.h"
#include "app/session/scene_origin.h"
#include "app/session/scene_view.h"
#include "sim/mesh/piece_figures.h"
#include "ui/unit_text.h"

namespace kerf::app {
namespace {

constexpr std::size_t kStrokeBacklog = 8;   // poses that may wait per step of a picture
constexpr int kMaxStrokeSteps = 4;          // per picture
constexpr int kSettleSteps = 60;            // for what hooks hold to arrive
constexpr int kCheckEvery = 50;             // steps of a recording
constexpr int kPiecesEvery = 10;            // steps between two looks at the pieces' volumes
constexpr int kKeyframes = 48;              // over a session that was opened
constexpr int kMostLiveTriangles = 20'000;  // of a body that follows a drag of its placement

bool takesBodyElsewhere(const Command& command) {
    return std::holds_alternative<Undo>(command) || std::holds_alternative<Redo>(command) ||
           std::holds_alternative<Restart>(command) || std::holds_alternative<Place>(command);
}

/// Of a command that takes the body elsewhere, in the plots.
const char* markOf(const Command& command) {
    if (std::holds_alternative<Undo>(command)) {
        return "undo";
    }
    if (std::holds_alternative<Place>(command)) {
        return "placed";
    }
    return std::holds_alternative<Redo>(command) ? "redo" : "restart";
}

std::vector<EditorScene::ModelFigures> figuresOf(const UncutBody& uncut) {
    const SurfaceMesh& mesh = uncut.mesh;
    std::vector<EditorScene::ModelFigures> figures(uncut.models.size());
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        figures[uncut.modelOf(v)].bounds.add(mesh.restPosition(v));
    }
    for (int t = 0; t < mesh.triangleSlots(); ++t) {
        const auto& [a, b, c] = mesh.triangle(t);
        EditorScene::ModelFigures& model = figures[uncut.modelOf(a)];
        const Vec3& origin = model.bounds.low;
        const Vec3 normal = (mesh.restPosition(b) - origin).cross(mesh.restPosition(c) - origin);
        model.volume += (mesh.restPosition(a) - origin).dot(normal) / 6;
        model.body.triangles.add(restCornersOf(mesh, t));
    }
    return figures;
}

EditorScene::RestFigures restFigures(const UncutBody& uncut) {
    return {meshBounds(uncut.mesh), figuresOf(uncut)};
}

/// The parameters as they are for one model.
Params paramsOf(Params params, int model) {
    for (const char* name : {"youngs_modulus", "density"}) {
        const ParamValue own = getParam(params, ownName(name, model));
        if (!std::holds_alternative<std::monostate>(own)) {
            setParam(params, name, own);
        }
    }
    return params;
}

}  // namespace

EditorScene::EditorScene(Document document, BodyUpload body)
    : document_(std::move(document)),
      homeView_(document_.camera),
      simulation_(std::move(body), document_.session.params, document_.session.boxes),
      rest_(restFigures(*simulation_.uncut())) {
    simulation_.setUndoBudget(kUndoBudget);
    journal_.open(document_.session.events);
    startAnew();
}

/// With a simulation at its start.
void EditorScene::startAnew() {
    playing = false;
    pulling_ = false;
    dragTo_.clear();
    settling_ = 0;
    stroke_.clear();
    runner_.setStrokePoses({});
    readings_.clear();
    volumes_ = {};
    start_ = {};
    seekTarget_.reset();
    followPlacement();
    beginPlayback();
    for (const SetParam& choice : choices_) {
        if (getParam(simulation_.params(), choice.name) != choice.value) {
            perform(choice);
        }
    }
    refreshPieces();
}

/// From its start, where there is a session.
void EditorScene::beginPlayback() {
    const bool loop = playback_ && playback_->loop;
    playback_.reset();
    keyframes_ = Keyframes();
    journal_.restart();
    if (!document_.session.events.empty()) {
        playback_.emplace(document_.session, SessionPlayback::Of::session).loop = loop;
        playback_->extendTo(journal_.lastStep());
        keyframes_ = Keyframes(std::max(1, document_.session.steps / kKeyframes));
    }
}

// --- What is done to the body ------------------------------------------------------------------

/// The one way in which anything that a person does reaches the simulation.
std::string EditorScene::perform(const Command& wanted) {
    const Command command = asReplayed(wanted, document_.session.origin);
    std::string problem = simulation_.execute(command);
    if (problem.empty()) {
        const int step = simulation_.stepCount();
        if (playback_) {
            keyframes_.changedAt(step, journal_.commandsDone(step));
            playback_->extendTo(step);
        }
        journal_.note(step, command);
        followPlacement();
    }
    return problem;
}

std::string EditorScene::place(const Placement& wanted, bool continues, int model) {
    return execute(placeCommand(wanted, continues, model));
}

Place EditorScene::placeCommand(const Placement& wanted, bool continues, int model) {
    const PlacementMap map(simulation_.placement(model));
    const std::vector<PlacedModel>& models = uncut_->models;
    const int last = model + 1;
    const int end =
        last < simulation_.modelCount() ? models[last].firstVertex : uncut_->mesh.vertexCount();
    std::vector<Vec3> own;
    own.reserve(end - models[model].firstVertex);
    for (int v = models[model].firstVertex; v < end; ++v) {
        own.push_back(map.toModel(uncut_->mesh.restPosition(v)));
    }
    const Bounds& bounds = rest_.models[model].bounds;
    Vec3 ground = bounds.center();
    ground.y() = simulation_.params().floor.value_or(bounds.low.y());
    return {standing(wanted, own, ground), continues, model};
}

Session EditorScene::startOfScene() const {
    Session start;
    start.origin = document_.session.origin;
    start.model = document_.session.model;
    start.placement = simulation_.placement();
    start.moreModels = document_.session.moreModels;
    for (std::size_t m = 0; m < start.moreModels.size(); ++m) {
        start.moreModels[m].placement = simulation_.placement(static_cast<int>(m) + 1);
    }
    start.params = simulation_.params();
    start.boxes = simulation_.boxes();
    start.colors = document_.session.colors;
    return start;
}

/// What was told of the uncut body is told of the one that there is now.
void EditorScene::followPlacement() {
    if (uncut_ == simulation_.uncut()) {
        return;
    }
    uncut_ = simulation_.uncut();
    rest_ = restFigures(*uncut_);
    const bool asOpened = uncut_->models == document_.placed;
    homeView_ = asOpened ? document_.camera : sessionCamera(Session{}, rest_.bounds);
    ++placementRevision_;
}

std::string EditorScene::execute(const Command& command) {
    if (std::holds_alternative<MovePins>(command)) {
        takeBlade();
        settle();
    }
    if (takesBodyElsewhere(command)) {
        if (!playsOnAfter(command)) {
            takeBlade();
        }
        letGoForGood();
        stroke_.clear();
        runner_.setStrokePoses({});
    }
    const Params before = simulation_.params();
    const bool bladeIsDown = simulation_.blade().has_value();
    std::string problem = perform(command);
    if (!problem.empty() && bladeIsDown && !simulation_.blade()) {
        perform(LiftBlade{});  // an undo with nothing to undo puts the blade away
    }
    if (problem.empty() && takesBodyElsewhere(command)) {
        followUndo(before);
        volumes_ = {};
        releaseHandsButHooks();
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

std::string EditorScene::grab(const Vec3& at, double wanted) {
    takeBlade();
    letGo();
    std::string problem = perform(Grab{kPersonsHand, at, reachOfHand(at, wanted), true});
    pulling_ = problem.empty();
    return problem;
}

double EditorScene::reachOfHand(const Vec3& at, double wanted) {
    Bounds piece = simulation_.bounds();
    for (Bounds box : simulation_.pieceBounds()) {
        box.widen(1e-3 * box.diagonal());
        if (contains(box, at) && box.diagonal() < piece.diagonal()) {
            piece = box;
        }
    }
    return handRadius(simulation_.mesh(), at, wanted, piece);
}

std::variant<int, std::string> EditorScene::hook(const Incision& incision) {
    takeBlade();
    letGo();
    const std::optional<int> first = freeRetractor(simulation_.hands());
    if (!first) {
        return "All retractors are in use; remove one first.";
    }
    const double radius = hookRadius(incision);
    std::string problem = perform(Grab{*first, incision.lips[0], radius, true});
    if (problem.empty()) {
        problem = perform(Grab{partnerOf(*first), incision.lips[1], radius, true, true});
        if (!problem.empty()) {
            perform(Release{*first});
        }
    }
    pulling_ = problem.empty();
    return problem.empty() ? std::variant<int, std::string>(*first) : problem;
}

void EditorScene::removeRetractor(int hook) {
    takeBlade();
    for (const Hands::Hand& hand : hooks()) {
        if (hand.number == hook || hand.number == partnerOf(hook)) {
            dragTo_.erase(hand.number);
            perform(Release{hand.number});
        }
    }
    settle();
}

void EditorScene::settle() {
    settling_ = kSettleSteps;
}

void EditorScene::moveHands() {
    for (const auto& [hand, to] : std::exchange(dragTo_, {})) {
        perform(Drag{hand, to});
    }
    settling_ = std::max(0, settling_ - 1);
}

void EditorScene::letGo() {
    dragTo_.erase(kPersonsHand);
    if (std::exchange(pulling_, false)) {
        if (perform(Release{kPersonsHand}).empty()) {
            return;
        }
        settle();
    }
}

/// Nothing that was held goes on moving.
void EditorScene::letGoForGood() {
    letGo();
    dragTo_.clear();
    settling_ = 0;
}

/// After an undo or a redo hands may hold what nobody drags any more.
void EditorScene::releaseHandsButHooks() {
    std::vector<int> numbers;
    for (const Hands::Hand& hand : simulation_.hands()) {
        numbers.push_back(hand.number);
    }
    std::erase_if(numbers, isHook);
    for (const int number : numbers) {
        perform(Release{number});
    }
}

/// Whether a session that is played goes on after an undo or a redo: between two strokes and
/// pulls, where no shape comes back.
bool EditorScene::playsOnAfter(const Command& command) const {
    const UndoHistory& history = simulation_.history();
    const bool undo = std::holds_alternative<Undo>(command);
    const bool redo = std::holds_alternative<Redo>(command);
    if (simulation_.blade() || !simulation_.hands().empty() || (!undo && !redo)) {
        return false;
    }
    if (undo ? !history.canUndo() : !history.canRedo()) {
        return true;  // nothing happens
    }
    const UndoEntry& entry = undo ? history.lastDone() : history.firstUndone();
    return !std::holds_alternative<UndoEntry::BodySnapshotChange>(entry.change);
}

/// A person takes the blade or the body in hand: what is left of a played session is off.
void EditorScene::takeBlade() {
    if (!playback_) {
        return;
    }
    const int step = simulation_.stepCount();
    if (journal_.takeOver(step, movesOnTheirWay()) > 0 && playback_->isPast()) {
        messages_.push_back("What was done after step " + std::to_string(step) +
                            " is left out: another way goes on from here.");
    }
    keyframes_.changedAt(step, journal_.commandsDone(step));
    playback_.reset();
    seekTarget_.reset();
    releaseHandsButHooks();
    if (simulation_.blade()) {
        perform(LiftBlade{});
    }
}

/// The poses before the last step of the moves of a played session that have not come to their end.
std::vector<PlayedAction> EditorScene::movesOnTheirWay() const {
    if (!playingBack()) {
        return {};
    }
    std::vector<PlayedAction> poses =
        playback_->player().posesBetweenKeys(simulation_.stepCount() - 1);
    const auto isGone = [&](const PlayedAction& pose) {
        const auto* drag = std::get_if<Drag>(&pose.action);
        return drag != nullptr
                   ? std::ranges::count(simulation_.hands(), drag->hand, &Hands::Hand::number) == 0
                   : !simulation_.blade();
    };
    std::erase_if(poses, isGone);
    return poses;
}

void EditorScene::reset() {
    if (!document_.session.events.empty()) {
        simulation_.reset();
        startAnew();
        return;
    }
    playing = false;
    takeBlade();
    letGoForGood();
    stroke_.clear();
    runner_.setStrokePoses({});
    perform(Restart{});
    countFromHere();
}

void EditorScene::countFromHere() {
    start_ = {simulation_.stepCount(), simulation_.report().time};
    readings_.clear();
    volumes_ = {};
    refreshPieces();
}

void EditorScene::step() {
    keepKeyframe();
    const std::optional<Command> pose = stroke_.next();
    if (pose) {
        takeBlade();
        perform(*pose);
    } else if (playingBack()) {
        playSessionEvents();
    }
    moveHands();
    letTimeRunAsWanted(pose.has_value());
    const int piecesBefore = pieceCount();
    const StepReport& report = runner_.step();
    followPlacement();  // by an event of the session
    if (report.pieces != piecesBefore) {
        readings_.mark(timeNow(), "cut");
    }
    readings_.addStep(timeNow(), simulation_);
    watchVolumes(report);
    checkNowAndThen();
    wrapPlayback();
}

/// A session that is played says itself when time stands.
void EditorScene::letTimeRunAsWanted(bool cuts) {
    const bool runs = playing || pulling() || timeRunsWhileCutting || !cuts;
    if (!playingBack() && simulation_.timeRuns() != runs) {
        perform(SetTime{runs});
    }
}

void EditorScene::watchVolumes(const StepReport& report) {
    if (!report.open && volumes_.add(report.step, simulation_.measuredPieces())) {
        messages_.push_back(volumes_.sentence());
    }
}

bool EditorScene::running() const {
    return playing || pulling() || stroke_.pending() > 0 || seekSteps() > 0;
}

int EditorScene::strokeSteps() const {
    const int backlog = static_cast<int>((stroke_.pending() + kStrokeBacklog - 1) / kStrokeBacklog);
    return std::min(backlog, kMaxStrokeSteps);
}

// --- The session that is played ----------------------------------------------------------------

bool EditorScene::playingBack() const {
    return playback_.has_value() && simulation_.stepCount() < playback_->steps();
}

void EditorScene::tell(std::string message) {
    if (!message.empty()) {
        messages_.push_back(std::move(message));
    }
}

/// What goes wrong is a message, and the session goes on.
void EditorScene::playSessionEvents() {
    const int step = simulation_.stepCount();
    while (JournalEntry* entry = journal_.takeDue(step)) {
        play(*entry);
    }
    for (const PlayedAction& pose : playback_->player().posesBetweenKeys(step)) {
        tell(simulation_.execute(*commandOf(pose.action)));
    }
}

/// Pictures and exports are a replay's: a person only watches.
void EditorScene::play(JournalEntry& entry) {
    const SessionAction& action = entry.event.action;
    if (const std::optional<Command> command = commandOf(action)) {
        std::string problem = simulation_.execute(*command);
        journal_.noteFailure(entry, !problem.empty());
        tell(std::move(problem));
        if (std::holds_alternative<Restart>(*command) && playback_->isPast()) {
            countFromHere();
        }
    } else if (const auto* check = std::get_if<CheckEvent>(&action)) {
        const CheckDifference difference = runner_.compare(*check);
        if (entry.doubtful) {
            journal_.noteFound(entry, corrected(*check, difference));
        } else {
            tell(playback_->compare(*check, difference, simulation_.stepCount()));
        }
    }
}

void EditorScene::keepKeyframe() {
    const int step = simulation_.stepCount();
    const std::size_t bytes = snapshotBytes(simulation_.mesh());
    if (keyframes_.wants(step, bytes)) {
        keyframes_.keep(
            step,
            {simulation_.moment(), journal_.commandsDone(step), runner_.strokePoses(), start_},
            bytes);
    }
}

void EditorScene::seek(int step) {
    if (!playback_ && goesBack(step)) {
        playPast();
    }
    if (!playback_) {
        return;
    }
    step = std::clamp(step, 0, playback_->steps());
    const int from = keyframes_.stepBefore(step);
    const int now = simulation_.stepCount();
    if (from >= 0 && (step < now || from > now)) {
        goTo(from, *keyframes_.before(step));
    }
    seekTarget_ = step;
}

bool EditorScene::goesBack(int step) const {
    return step < simulation_.stepCount() && keyframes_.stepBefore(step) >= 0;
}

/// What was done since the start is a session that can be played, too.
void EditorScene::playPast() {
    playing = false;
    letGo();
    stroke_.clear();
    if (simulation_.blade()) {
        perform(LiftBlade{});
    }
    Session past = sessionAsSaved(document_.session, journal_).session;
    past.steps = simulation_.stepCount();
    playback_.emplace(std::move(past), SessionPlayback::Of::past);
}

void EditorScene::goTo(int step, const Keyframe& keyframe) {
    if (std::exchange(start_, keyframe.start).step != keyframe.start.step) {
        readings_.clear();
    }
    simulation_.goTo(keyframe.moment);
    followPlacement();
    journal_.goTo(step, keyframe.commandsDone);
    runner_.setStrokePoses(keyframe.strokePoses);
    stroke_.clear();
    pulling_ = false;
    dragTo_.clear();
    settling_ = 0;
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

/// At its end a session stops once, or begins again. What a person changed goes on.
void EditorScene::wrapPlayback() {
    if (seekSteps() == 0) {
        seekTarget_.reset();
    }
    const int step = simulation_.stepCount();
    if (playback_ && step > playback_->steps() && journal_.firstChange()) {
        playback_->extendTo(step);
    } else if (playback_ && step == playback_->steps()) {
        atEndOfSession();
    }
}

void EditorScene::atEndOfSession() {
    playSessionEvents();
    if (playing && playback_->loop) {
        seek(0);
        seekTarget_.reset();
    } else {
        playing = false;
        endPast();
    }
}

/// The present is reached again.
void EditorScene::endPast() {
    if (playback_->isPast()) {
        playback_.reset();
        seekTarget_.reset();
    }
}

// --- Recording ---------------------------------------------------------------------------------

void EditorScene::startRecording() {
    const std::vector<StaticBox> boxes = simulation_.boxes();
    const std::vector<PlacedModel> models = uncut_->models;
    simulation_.reset();
    playback_.reset();
    document_.session.events.clear();
    journal_.clear();
    startAnew();
    putUp(boxes);
    for (int m = 0; m < simulation_.modelCount(); ++m) {
        if (simulation_.placement(m) != models[m].placement) {
            perform(Place{models[m].placement, false, m});
        }
    }
    recording_ = recorded_ = true;
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
        journal_.note(step, checkOfNow());
    }
}

CheckEvent EditorScene::checkOfNow() {
    return {simulation_.stateHash(), pieceCount()};
}

/// Whether it is a session without events to which nobody did anything.
bool EditorScene::isUntouched() const {
    return document_.session.steps > 0 && !recorded_ && !journal_.firstChange();
}

SavedSession EditorScene::savedSession(const render::Camera& camera,
                                       const render::ChosenColors& colors, SavedAs purpose) {
    SavedSession saved = sessionAsSaved(document_.session, journal_, purpose);
    Session& session = saved.session;
    session.steps = stepsAsSaved();
    if (purpose == SavedAs::session && endsNow()) {
        session.events.push_back({session.steps, checkOfNow()});
    }
    setView(session, camera, colors);
    return saved;
}

Session EditorScene::sessionWithoutEvents(const render::Camera& camera,
                                          const render::ChosenColors& colors) const {
    const Session& opened = document_.session;
    Session session;
    session.origin = opened.origin;
    session.model = opened.model;
    session.placement = opened.placement;
    session.moreModels = opened.moreModels;
    session.params = opened.params;
    session.boxes = opened.boxes;
    session.view = opened.view;
    session.steps = stepsAsSaved();
    setView(session, camera, colors);
    return session;
}

SessionChange EditorScene::takeChange(bool whole) {
    const ChangedPart::Splice splice = journal_.takeChanged(whole);
    SessionChange change{splice.at, splice.dropped, {}, stepsAsSaved()};
    change.added.reserve(splice.added);
    for (std::size_t i = splice.at; i < splice.at + splice.added; ++i) {
        change.added.push_back(eventAsSaved(journal_.entries()[i], hasChanged()));
        if (std::optional<SessionEvent>& event = change.added.back()) {
            event->action = countedFrom(event->action, -document_.session.origin);
        }
    }
    return change;
}

int EditorScene::stepsAsSaved() const {
    if (isUntouched() && (!playback_ || playback_->isPast())) {
        return std::max(document_.session.steps, journal_.lastStep());
    }
    return playback_ ? playback_->steps() : std::max(1, simulation_.stepCount());
}

/// Whether a session that is saved now ends with what a person did last.
bool EditorScene::endsNow() const {
    const int step = simulation_.stepCount();
    if (playback_) {
        return journal_.firstChange() && step > document_.session.steps &&
               step == playback_->steps();
    }
    return step > 0 && !isUntouched();
}

/// The pictures of a session that was opened depend on its view.
void EditorScene::setView(Session& session, const render::Camera& camera,
                          const render::ChosenColors& colors) const {
    const bool keepsView = !document_.session.events.empty() || isUntouched();
    if (chosenView_) {
        session.view = chosenView_;
    } else if (!keepsView) {
        session.view = camera;
    } else if (!session.view && colors.any()) {
        session.view = document_.camera;  // the one that it has of itself
    }
    session.colors = colors;
}

// --- Pictures, exports and checks of the session -----------------------------------------------

JournalPlace EditorScene::end() const {
    const auto& entries = journal_.entries();
    return {stepsAsSaved(), entries.empty() ? 0 : entries.back().id};
}

bool EditorScene::takesPictures() const {
    return std::ranges::any_of(journal_.entries(), [](const JournalEntry& entry) {
        return std::holds_alternative<ScreenshotEvent>(entry.event.action);
    });
}

std::string EditorScene::addPicture(const JournalPlace& place) {
    std::string file = freeOutputName(journal_, document_.name, place.step, ".png");
    addMark(place, ScreenshotEvent{file});
    return file;
}

std::string EditorScene::addExport() {
    const JournalPlace place = here();
    std::string file = freeOutputName(journal_, document_.name, place.step, ".ply");
    addMark(place, ExportEvent{file, false, Coordinates::model});
    return file;
}

void EditorScene::addCheck() {
    addMark(here(), checkOfNow());
}

void EditorScene::addCamera(const render::Camera& camera) {
    addMark(here(), CameraEvent{camera});
}

void EditorScene::addMark(const JournalPlace& place, SessionAction action) {
    journal_.add(place, std::move(action));
    if (playback_) {
        playback_->extendTo(place.step);
    }
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
    render::SceneView view =
        sceneOf(simulation_, lookOf(document_.session), rest_.bounds, runner_.strokePoses());
    view.paint = skin_.paintOf(simulation_);
    view.field.values = thickness_.values();
    return view;
}

const std::shared_ptr<const std::vector<render::Marks>>& EditorScene::faultMarks() {
    const int triangles = simulation_.report().triangles;
    if (std::exchange(marksTriangles_, triangles) != triangles) {
        const SurfaceMesh& now = simulation_.meshAsRead();
        const SurfaceMesh& opened = uncut_->mesh;
        const auto cornersOf = [&](int t) {
            const bool whole = now.alive(t) && now.triangle(t) == opened.triangle(t);
            return whole ? std::optional(opened.triangle(t)) : std::nullopt;
        };
        faultMarks_ = std::make_shared<const std::vector<render::Marks>>(
            marksOf(document_.faults, cornersOf));
    }
    return faultMarks_;
}

bool EditorScene::followPieceSums(bool wanted) {
    const bool due = wanted && !running() && sumsRevision_ != simulation_.bodyRevision();
    if (due) {
        measurePieces();
    }
    return due;
}

const std::vector<ui::PieceRow>& EditorScene::measurePieces() {
    refreshPieces();
    const std::vector<int> triangles = simulation_.trianglesOfPieces();
    const SurfaceMesh& mesh = simulation_.mesh();
    const PieceShells shells(mesh);
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
        if (triangles[p] >= 0) {
            const PieceFigures figures = figuresOfPiece(mesh, shells, triangles[p]);
            pieces_[p].sums = {figures.skinArea, figures.cutArea, figures.centroid};
        }
    }
    sumsRevision_ = simulation_.bodyRevision();
    return pieces_;
}

void EditorScene::refreshPieces() {
    const bool same = sumsRevision_ == simulation_.bodyRevision();
    const std::vector<ui::PieceRow> before = std::exchange(pieces_, {});
    const std::vector<Bounds>& bounds = simulation_.pieceBounds();
    double all = 0;
    for (const Piece& piece : simulation_.measuredPieces()) {
        ui::PieceRow row;
        row.triangles = piece.triangles;
        row.volume = piece.volume;
        row.share = piece.restVolume > 0 ? piece.volume / piece.restVolume : 0;
        const std::size_t p = pieces_.size();
        row.bounds = p < bounds.size() ? bounds[p] : Bounds{};
        row.sums = same && p < before.size() ? before[p].sums : std::nullopt;
        all += piece.volume;
        pieces_.push_back(row);
    }
    for (ui::PieceRow& row : pieces_) {
        row.shareOfAll = all > 0 ? row.volume / all : 0;
    }
    piecesStep_ = simulation_.stepCount();
    piecesTriangles_ = simulation_.report().triangles;
}

void EditorScene::describeChanges(ui::ChangeList& list) const {
    const UndoHistory& history = simulation_.history();
    for (const UndoEntry& entry : history.entries()) {
        list.rows.push_back({ui::withRaisedDigits(entry.name), entry.time});
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
    if (simulation_.isWhole()) {
        sweeps_.follow(simulation_.bodyModel(), simulation_.params());
    }
    const StepReport& report = simulation_.report();
    model.name = document_.name;
    describeModels(model);
    const Vec3 toScene = -document_.session.origin;
    model.parameters.now = countedFrom(simulation_.params(), toScene);
    model.parameters.start = countedFrom(document_.session.params, toScene);
    model.body.boxes = countedFrom(simulation_.boxes(), toScene);
    model.body.pinned = simulation_.pinnedVertices().size();
    model.body.hooks = hooks().size();
    model.body.size = rest_.bounds.diagonal();
    model.body.bounds = simulation_.bounds();
    model.parameters.sweeps = &sweeps_;
    model.transport.playing = playing;
    model.transport.stroking = stroke_.drawing() || stroke_.pending() > 0;
    model.transport.step = simulation_.stepCount() - start_.step;
    model.transport.time = timeNow();
    describeChanges(model.changes);
    model.body.vertices = report.vertices;
    model.body.triangles = report.triangles;
    model.cuts.subdivisions = simulation_.subdivisions();
    model.cuts.rows = cuts_.rows();
    model.cuts.note = cuts_.note();
    model.pieces.rows = pieces_;
    model.plots.history = &readings_.history();
    model.transport.recording = recording_;
    describePlayback(model.session.playback);
    describeMarks(model);
}

double EditorScene::proposedEdge(int model) const {
    const auto& [bounds, volume, triangles] = rest_.models[model];
    const Placement& placement = simulation_.placement(model);
    return kerf::proposedEdge(triangles, bounds.diagonal()) /
           (placement.metresPerUnit() * placement.scale);
}

void EditorScene::describeModels(ui::PanelModel& model) const {
    const Session& session = document_.session;
    for (int m = 0; m < simulation_.modelCount(); ++m) {
        const ModelFigures& figures = rest_.models[m];
        ui::ModelState state;
        state.name = m == 0 ? session.model.name() : session.moreModels[m - 1].model.name();
        state.placement = simulation_.placement(m);
        state.size = figures.bounds.high - figures.bounds.low;
        state.physics =
            sizeEffect(state.size.y(), figures.volume, paramsOf(simulation_.params(), m));
        state.triangles = trianglesText(figures.triangles);
        const ModelReference& reference = m == 0 ? session.model : session.moreModels[m - 1].model;
        state.edge = proposedEdge(m);
        state.remeshed = trianglesOf(
            figures.triangles, kerf::proposedEdge(figures.triangles, figures.bounds.diagonal()));
        state.crosses = !reference.repair &&
                        document_.faults.of(repair::FaultKind::crossingTriangle).count() > 0;
        model.model.models.push_back(std::move(state));
    }
    model.model.models.front().guess = document_.guess ? document_.guess->sentence : "";
    model.model.objects = static_cast<int>(document_.objects.size());
    model.model.faultCount = 0;
    for (const repair::FaultPlaces& places : document_.faults.places) {
        model.model.faultCount += places.count();
    }
    model.model.untouched = simulation_.report().triangles == uncut_->mesh.aliveTriangles();
    model.model.live = simulation_.report().triangles <= kMostLiveTriangles;
}

void EditorScene::describeMarks(ui::PanelModel& model) {
    const std::size_t entries = journal_.entries().size();
    if (marksRevision_ != journal_.revision() || marksEntries_ != entries) {
        marks_ = marksOf(journal_);
        course_ = courseOf(journal_);
        marksRevision_ = journal_.revision();
        marksEntries_ = entries;
    }
    model.session.marks = marks_;
    model.session.course = course_;
}

void EditorScene::describePlayback(ui::PlaybackState& state) const {
    state.step = simulation_.stepCount();
    state.steps = state.step;
    state.goesBack = playback_ || goesBack(state.step - 1);
    if (playback_) {
        state.steps = playback_->steps();
        state.played = true;
        state.loop = playback_->loop;
        state.divergedAt = playback_->divergedAt();
    }
}

}  // namespace kerf::app
