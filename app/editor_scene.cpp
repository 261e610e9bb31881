#include "app/editor_scene.h"

#include <spdlog/spdlog.h>

#include <algorithm>

namespace kerf::app {
namespace {

constexpr std::size_t kStrokeBacklog = 8;  // poses that may wait per step of a picture
constexpr int kMaxStrokeSteps = 4;         // per picture
constexpr int kPiecesEvery = 10;           // steps between two looks at the pieces' volumes

bool isCommand(const SessionAction& action) {
    return std::holds_alternative<MoveBlade>(action) || std::holds_alternative<LiftBlade>(action) ||
           std::holds_alternative<SetParam>(action);
}

/// The command of an event that has one.
Command asCommand(const SessionAction& action) {
    if (const auto* move = std::get_if<MoveBlade>(&action)) {
        return *move;
    }
    if (const auto* set = std::get_if<SetParam>(&action)) {
        return *set;
    }
    return LiftBlade{};
}

}  // namespace

EditorScene::EditorScene(Document document)
    : document_(std::move(document)), simulation_(document_.mesh, document_.session.params) {
    player_.emplace(document_.session);
    refreshPieces();
}

std::string EditorScene::choose(const SetParam& choice) {
    std::string problem = simulation_.execute(choice);
    if (problem.empty()) {
        std::erase_if(choices_, [&](const SetParam& old) { return old.name == choice.name; });
        choices_.push_back(choice);
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
        if (!isCommand(action)) {
            continue;
        }
        if (const std::string problem = simulation_.execute(asCommand(action)); !problem.empty()) {
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
        history_.marks.push_back({report.time, "cut"});
    }
    record();
}

void EditorScene::record() {
    const StepReport& report = simulation_.report();
    history_.volumePercent.push_back({report.time, 100 * report.volumeRatio});
}

void EditorScene::recordFrameRate(double framesPerSecond) {
    history_.framesPerSecond.push_back({simulation_.report().time, framesPerSecond});
}

void EditorScene::reset() {
    playing = false;
    stroke_.clear();
    simulation_.reset();
    for (const SetParam& choice : choices_) {
        simulation_.execute(choice);
    }
    history_.clear();
    player_.emplace(document_.session);
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
    render::SceneView view;
    view.body = simulation_.bodyView();
    view.material = render::materialFor(document_.session.model.name());
    view.restBounds = document_.restBounds;
    view.floor = simulation_.params().floor;
    view.blade = simulation_.blade();
    view.sweep = stroke_.sweep();
    view.focus = bounds();
    return view;
}

void EditorScene::refreshPieces() {
    pieces_.clear();
    for (const Piece& piece : simulation_.pieces().pieces) {
        pieces_.push_back({piece.triangles, piece.volume,
                           piece.restVolume > 0 ? piece.volume / piece.restVolume : 0});
    }
    piecesStep_ = simulation_.stepCount();
    piecesTriangles_ = simulation_.report().triangles;
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
    model.step = simulation_.stepCount();
    model.time = report.time;
    model.vertices = report.vertices;
    model.triangles = report.triangles;
    model.stages.deform = report.deformMs;
    model.stages.collide = report.collideMs;
    model.stages.cut = report.cutMs;
    model.pieces = pieces_;
    model.history = &history_;
    if (playingBack()) {
        model.playback = "session: step " + std::to_string(model.step) + " of " +
                         std::to_string(document_.session.steps);
    }
}

}  // namespace kerf::app
