#include "app/editor_scene.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <type_traits>

#include "app/scene_view.h"

namespace kerf::app {
namespace {

constexpr std::size_t kStrokeBacklog = 8;         // poses that may wait per step of a picture
constexpr int kMaxStrokeSteps = 4;                // per picture
constexpr std::size_t kUndoBudget = 512'000'000;  // [bytes]
constexpr int kPiecesEvery = 10;                  // steps between two looks at the pieces' volumes

/// The command of an event that has one; pictures, exports and checks have none.
std::optional<Command> commandOf(const SessionAction& action) {
    const auto convert = [](const auto& event) -> std::optional<Command> {
        if constexpr (std::is_constructible_v<Command, decltype(event)>) {
            return Command(event);
        } else {
            return std::nullopt;
        }
    };
    return std::visit(convert, action);
}

bool takesBodyElsewhere(const Command& command) {
    return std::holds_alternative<Undo>(command) || std::holds_alternative<Redo>(command) ||
           std::holds_alternative<Restart>(command);
}

}  // namespace

EditorScene::EditorScene(Document document)
    : document_(std::move(document)), simulation_(document_.mesh, document_.session.params) {
    simulation_.setUndoBudget(kUndoBudget);
    player_.emplace(document_.session);
    refreshPieces();
}

std::string EditorScene::execute(const Command& command) {
    if (takesBodyElsewhere(command)) {
        endPlayback();
        stroke_.clear();
    }
    std::string problem = simulation_.execute(command);
    if (problem.empty() && takesBodyElsewhere(command)) {
        record();
        refreshPieces();
    }
    if (const auto* set = std::get_if<SetParam>(&command); set != nullptr && problem.empty()) {
        std::erase_if(choices_, [&](const SetParam& old) { return old.name == set->name; });
        choices_.push_back(*set);
    }
    return problem;
}

bool EditorScene::playingBack() const {
    return player_.has_value() && !document_.session.events.empty() &&
           simulation_.stepCount() <= document_.session.steps;
}

void EditorScene::endPlayback() {
    if (playingBack() && simulation_.blade()) {
        simulation_.execute(LiftBlade{});
    }
    player_.reset();
}

void EditorScene::playSessionEvents() {
    if (!playingBack()) {
        return;
    }
    // Screenshots, exports and checks are the replay's business: a person only watches here.
    for (const SessionAction& action : player_->actionsAt(simulation_.stepCount())) {
        const std::optional<Command> command = commandOf(action);
        if (!command) {
            continue;
        }
        if (const std::string problem = simulation_.execute(*command); !problem.empty()) {
            spdlog::warn("step {}: {}", simulation_.stepCount(), problem);
        }
    }
}

void EditorScene::step() {
    if (const std::optional<Command> command = stroke_.next()) {
        simulation_.execute(*command);
    } else {
        playSessionEvents();
    }
    const int piecesBefore = pieceCount();
    const StepReport& report = simulation_.step();
    if (report.pieces != piecesBefore) {
        history_.marks.push_back({timeNow(), "cut"});
    }
    record();
}

void EditorScene::record() {
    const StepReport& report = simulation_.report();
    history_.volumePercent.push_back({timeNow(), 100 * report.volumeRatio});
}

void EditorScene::recordFrameRate(double framesPerSecond) {
    history_.framesPerSecond.push_back({timeNow(), framesPerSecond});
}

void EditorScene::reset() {
    playing = false;
    stroke_.clear();
    if (document_.session.events.empty()) {
        simulation_.execute(Restart{});
        start_ = {simulation_.stepCount(), simulation_.report().time};
    } else {
        simulation_.reset();
        for (const SetParam& choice : choices_) {
            simulation_.execute(choice);
        }
        start_ = {};
        player_.emplace(document_.session);
    }
    history_.clear();
    refreshPieces();
}

void EditorScene::beginStroke(const StrokeSpace& space, const Vec2& ndc) {
    endPlayback();
    stroke_.begin(space, ndc);
}

int EditorScene::strokeSteps() const {
    const int backlog = static_cast<int>((stroke_.pending() + kStrokeBacklog - 1) / kStrokeBacklog);
    return std::min(backlog, kMaxStrokeSteps);
}

render::SceneView EditorScene::view() {
    return sceneOf(simulation_, document_.session.model.name(), document_.restBounds,
                   stroke_.sweep());
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
    model.playing = playing;
    model.stroking = stroke_.drawing() || stroke_.pending() > 0;
    model.step = simulation_.stepCount() - start_.step;
    model.time = timeNow();
    describeChanges(model.changes);
    model.vertices = report.vertices;
    model.triangles = report.triangles;
    model.stages.deform = report.deformMs;
    model.stages.collide = report.collideMs;
    model.stages.cut = report.cutMs;
    model.subdivisions = simulation_.subdivisions();
    model.pieces = pieces_;
    model.history = &history_;
    if (playingBack()) {
        model.playback = "session: step " + std::to_string(model.step) + " of " +
                         std::to_string(document_.session.steps);
    }
}

}  // namespace kerf::app
