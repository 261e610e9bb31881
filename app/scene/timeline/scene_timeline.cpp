#include "app/scene/timeline/scene_timeline.h"

#include "app/scene/timeline/hooks.h"
#include "app/scene/timeline/saved_session.h"
#include "app/session/scene_origin.h"
#include "sim/base/containers.h"
#include "sim/run/parts/snapshot.h"
#include "sim/run/parts/step_report.h"
#include "sim/run/undo/undo_history.h"
#include "ui/state/panel_model.h"

namespace kerf::app {
namespace {

constexpr int kCheckpoints = 48;  // over a session that was opened

}  // namespace

SceneTimeline::SceneTimeline(SceneBody& body) : body_(body) {
    log_.open(body_.document.session.events);
}

void SceneTimeline::startAnew() {
    playing = false;
    start_ = {};
    seekTarget_.reset();
    undoBegins_.reset();
    reopened_ = false;
    body_.followPlacement();
    beginPlayback();
}

void SceneTimeline::beginPlayback() {
    const bool loop = playback_ && playback_->loop;
    playback_.reset();
    checkpoints_ = Checkpoints();
    log_.restart();
    const Session& session = body_.document.session;
    if (!session.events.empty()) {
        playback_.emplace(session, SessionPlayback::Of::session).loop = loop;
        playback_->extendTo(log_.lastStep());
        checkpoints_ = Checkpoints(std::max(1, session.steps / kCheckpoints));
    }
}

void SceneTimeline::forgetSession() {
    playback_.reset();
    body_.document.session.events.clear();
    log_.clear();
}

void SceneTimeline::countFromHere() {
    start_ = {body_.simulation.stepCount(), body_.simulation.report().time};
}

std::string SceneTimeline::perform(const Command& wanted) {
    const Command command = asReplayed(wanted, body_.document.session.origin);
    const bool isDown = body_.simulation.blade().has_value();
    const bool misses =
        isDown && std::holds_alternative<LiftBlade>(command) && strokesThatMet() == metBefore_;
    if (!isDown && std::holds_alternative<MoveBlade>(command)) {
        metBefore_ = strokesThatMet();
    }
    keepCheckpoint();
    std::string problem = body_.simulation.execute(command);
    if (problem.empty()) {
        const int step = body_.simulation.stepCount();
        if (playback_) {
            checkpoints_.changedAt(step, log_.commandsDone(step));
            playback_->extendTo(step);
        }
        log_.note(step, command);
        if (misses) {
            log_.noteMiss();
        }
        body_.followPlacement();
    }
    return problem;
}

long SceneTimeline::strokesThatMet() const {
    return std::ranges::count_if(body_.simulation.strokes(), &StrokeRecord::metBody);
}

void SceneTimeline::extendTo(int step) {
    if (playback_) {
        playback_->extendTo(step);
    }
}

// --- The session that is played ----------------------------------------------------------------

bool SceneTimeline::playingBack() const {
    return playback_.has_value() && body_.simulation.stepCount() < playback_->steps();
}

bool SceneTimeline::playsOnAfter(const Command& command) const {
    const Simulation& simulation = body_.simulation;
    const UndoHistory& history = simulation.history();
    const bool undo = std::holds_alternative<Undo>(command);
    const bool redo = std::holds_alternative<Redo>(command);
    if (simulation.blade() || !simulation.hands().empty() || (!undo && !redo)) {
        return false;
    }
    if (undo ? !history.canUndo() : !history.canRedo()) {
        return true;  // nothing happens
    }
    const UndoEntry& entry = undo ? history.lastDone() : history.firstUndone();
    return !std::holds_alternative<UndoEntry::BodySnapshotChange>(entry.change);
}

void SceneTimeline::takeOver() {
    if (!playback_) {
        return;
    }
    const int step = body_.simulation.stepCount();
    if (log_.takeOver(step, movesOnTheirWay()) > 0 && playback_->isPast()) {
        tell("Everything after step " + std::to_string(step) +
             " was discarded, because you continued from there.");
    }
    checkpoints_.changedAt(step, log_.commandsDone(step));
    playback_.reset();
    seekTarget_.reset();
    releaseHandsButHooks();
    if (body_.simulation.blade()) {
        perform(LiftBlade{});
    }
}

void SceneTimeline::releaseHandsButHooks() {
    std::vector<int> numbers = mapped(body_.simulation.hands(), &Hands::Hand::number);
    std::erase_if(numbers, isHook);
    for (const int number : numbers) {
        perform(Release{number});
    }
}

/// The poses before the last step of the moves of a played session that have not come to their end.
std::vector<PlayedAction> SceneTimeline::movesOnTheirWay() const {
    if (!playingBack()) {
        return {};
    }
    const Simulation& simulation = body_.simulation;
    std::vector<PlayedAction> poses =
        playback_->schedule().posesBetweenKeys(simulation.stepCount() - 1);
    const auto isGone = [&](const PlayedAction& pose) {
        const auto* drag = std::get_if<Drag>(&pose.action);
        return drag != nullptr
                   ? std::ranges::count(simulation.hands(), drag->hand, &Hands::Hand::number) == 0
                   : !simulation.blade();
    };
    std::erase_if(poses, isGone);
    return poses;
}

void SceneTimeline::tell(std::string message) {
    if (!message.empty()) {
        body_.messages.push_back(std::move(message));
    }
}

/// What goes wrong is a message, and the session goes on.
bool SceneTimeline::playEvents() {
    const int step = body_.simulation.stepCount();
    bool countsAnew = false;
    while (LogEntry* entry = log_.takeDue(step)) {
        countsAnew |= play(*entry);
    }
    for (const PlayedAction& pose : playback_->schedule().posesBetweenKeys(step)) {
        tell(body_.simulation.execute(*commandOf(pose.action)));
    }
    return countsAnew;
}

/// Pictures and exports are a replay's: a person only watches.
bool SceneTimeline::play(LogEntry& entry) {
    const SessionAction& action = entry.event.action;
    bool countsAnew = false;
    if (const std::optional<Command> command = commandOf(action)) {
        std::string problem = body_.simulation.execute(*command);
        log_.noteFailure(entry, !problem.empty());
        tell(std::move(problem));
        countsAnew = std::holds_alternative<Restart>(*command) && playback_->isPast();
        if (countsAnew) {
            countFromHere();
        }
    } else if (const auto* check = std::get_if<CheckEvent>(&action)) {
        const CheckDifference difference = body_.driver.compare(*check);
        if (entry.doubtful) {
            log_.noteFound(entry, corrected(*check, difference));
        } else {
            tell(playback_->compare(*check, difference, body_.simulation.stepCount()));
        }
    }
    return countsAnew;
}

// --- Seeking -----------------------------------------------------------------------------------

SceneCheckpoint SceneTimeline::now() const {
    return {body_.driver.now(), log_.commandsDone(body_.simulation.stepCount()), start_};
}

void SceneTimeline::keepCheckpoint() {
    const int step = body_.simulation.stepCount();
    const std::size_t bytes = snapshotBytes(body_.simulation.meshAsRead());
    if (checkpoints_.wants(step, bytes)) {
        checkpoints_.keep(step, now(), bytes);
    }
}

std::optional<SceneTimeline::Jump> SceneTimeline::seek(int step) {
    if (!playback_) {
        return std::nullopt;
    }
    step = std::clamp(step, 0, playback_->steps());
    const int end = playback_->steps();
    const int from = checkpoints_.stepBefore(step, step == end);
    const int now = body_.simulation.stepCount();
    std::optional<Jump> jump;
    if (from >= 0 && (step < now || from > now)) {
        jump = goTo(from, checkpoints_.at(from));
    }
    seekTarget_ = step;
    if (jump && from == end) {
        jump->countsAnew |= playEvents();
        endPast();
    }
    return jump;
}

bool SceneTimeline::goesBack(int step) const {
    return step < body_.simulation.stepCount() && checkpoints_.stepBefore(step, false) >= 0;
}

void SceneTimeline::playPast() {
    Session past = sessionAsSaved(body_.document.session, log_).session;
    past.steps = body_.simulation.stepCount();
    playback_.emplace(std::move(past), SessionPlayback::Of::past);
}

SceneTimeline::Jump SceneTimeline::goTo(int step, const SceneCheckpoint& checkpoint) {
    const int before = std::exchange(start_, checkpoint.start).step;
    body_.driver.goTo(checkpoint.state);
    body_.followPlacement();
    log_.goTo(step, checkpoint.commandsDone);
    return {before != start_.step};
}

/// Then also the start is kept, to seek back.
bool SceneTimeline::goTo(const StoredEnd& end) {
    keepCheckpoint();
    Simulation& simulation = body_.simulation;
    if (!playback_ || !simulation.goTo(end.checkpoint) ||
        simulation.stepCount() != playback_->steps()) {
        simulation.reset();
        return false;
    }
    body_.followPlacement();
    start_ = {end.startStep, end.startTime};
    log_.goTo(simulation.stepCount(), log_.entries().size());
    undoBegins_ = simulation.stepCount();
    if (const std::size_t bytes = snapshotBytes(simulation.mesh()); checkpoints_.fits(bytes)) {
        checkpoints_.keep(simulation.stepCount(), now(), bytes);
    }
    return true;
}

bool SceneTimeline::hasForgotten() const {
    return undoBegins_ && body_.simulation.stepCount() >= *undoBegins_ &&
           !body_.simulation.history().canUndo();
}

void SceneTimeline::recall() {
    const int now = body_.simulation.stepCount();
    if (!playback_) {
        playPast();
    }
    undoBegins_.reset();
    checkpoints_.changedAt(0, std::numeric_limits<std::size_t>::max());
    goTo(0, checkpoints_.at(0));
    seekTarget_ = now;
}

int SceneTimeline::seekSteps() const {
    return seekTarget_ ? std::max(0, *seekTarget_ - body_.simulation.stepCount()) : 0;
}

void SceneTimeline::toggleLoop() {
    if (playback_) {
        playback_->loop = !playback_->loop;
    }
}

void SceneTimeline::noteTear(const StepReport& report) {
    if (!report.tear || !report.tear->advanced) {
        return;
    }
    if (std::abs(report.step - toreLast_) > kTearPause) {
        log_.noteTear(report.step);
    }
    toreLast_ = report.step;
}

SceneTimeline::StepEnd SceneTimeline::endStep() {
    if (seekSteps() == 0) {
        seekTarget_.reset();
    }
    const int step = body_.simulation.stepCount();
    if (playback_ && step > playback_->steps() && goesOn()) {
        playback_->extendTo(step);
    } else if (playback_ && step == playback_->steps()) {
        return endSession();
    }
    return {};
}

SceneTimeline::StepEnd SceneTimeline::endSession() {
    const StepEnd end{playEvents(), playing && playback_->loop};
    if (!end.loops) {
        playing = false;
        endPast();
    }
    return end;
}

/// The present is reached again.
void SceneTimeline::endPast() {
    if (playback_->isPast()) {
        playback_.reset();
        seekTarget_.reset();
    }
}

void SceneTimeline::describe(ui::PlaybackState& state) const {
    state.step = body_.simulation.stepCount();
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
