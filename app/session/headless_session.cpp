#include "app/session/headless_session.h"

#include "app/files/export/export.h"
#include "app/files/import/model_source.h"
#include "app/files/io/errors.h"
#include "app/files/io/memory_means.h"
#include "app/session/scene_origin.h"
#include "app/session/scene_view.h"
#include "render/renderer.h"
#include "sim/base/text.h"
#include "sim/mesh/invariants.h"
#include "sim/run/start/prepared_body.h"

namespace kerf::app {

namespace {

/// A host of SimulationDriver::applyActions.
struct CommandsAlone {
    HeadlessSession& running;

    void perform(const Command& command, int event) const { running.perform(command, event); }
    template <class Event>
    void take(const Event& /*event*/) const {}
};

}  // namespace

void requireMemoryFor(const Session& session, const SurfaceMesh& mesh, std::size_t undoBudget) {
    MemorySettings settings = memorySettings(session.params, !session.boxes.empty());
    settings.undoBudget = undoBudget;
    requireMemory(session.model.name(), memoryNeedOf(BodySize::ofMesh(mesh), settings),
                  memoryMeansOfContext());
}

HeadlessSession::HeadlessSession(const Session& session, ModelMesh model, std::size_t undoBudget,
                                 render::Quality quality)
    : session_(withOrigin(session, model.origin)),
      quality_(quality),
      looks_(std::move(model.looks)),
      simulation_(BodyUpload(PreparedBody(std::move(model.mesh), {}, model.placed)),
                  session_.params, session_.boxes),
      uncut_(simulation_.uncut()),
      restBounds_(meshBounds(simulation_.mesh())),
      driver_(simulation_),
      camera_(sessionCamera(session_, restBounds_)) {
    simulation_.setUndoBudget(undoBudget);
}

HeadlessSession::~HeadlessSession() = default;

std::string HeadlessSession::execute(const Command& command) {
    std::string problem = simulation_.execute(command);
    followPlacement();
    return problem;
}

void HeadlessSession::perform(const Command& command, int event) {
    const std::string problem = execute(command);
    if (!problem.empty()) {
        throw InputError(positionInFile(event) + ": " + problem);
    }
}

void HeadlessSession::perform(const SessionSchedule& schedule) {
    driver_.applyActions(schedule, CommandsAlone{*this});
}

const StepReport& HeadlessSession::stepBy(const SessionSchedule& schedule) {
    perform(schedule);
    return step();
}

void HeadlessSession::goTo(const SimulationDriver::State& state) {
    driver_.goTo(state);
    followPlacement();
}

/// Where the model is placed otherwise now, pictures are of another rest shape.
void HeadlessSession::followPlacement() {
    if (uncut_ == simulation_.uncut()) {
        return;
    }
    uncut_ = simulation_.uncut();
    restBounds_ = meshBounds(uncut_->mesh);
    camera_ = sessionCamera(session_, restBounds_);
    if (renderer_) {
        renderer_->setRestShape(uncut_->mesh);
    }
}

void HeadlessSession::preparePictures() {
    if (!renderer_) {
        renderer_ = std::make_unique<render::Renderer>(quality_);
        renderer_->setRestShape(uncut_->mesh);
    }
}

void HeadlessSession::show(const render::Camera& camera, int width, int height) {
    preparePictures();
    render::SceneView view =
        sceneOf(simulation_, lookOf(session_), restBounds_, driver_.strokePoses());
    view.paint = session_.colors.showOwn() ? skin_.paintOf(simulation_) : nullptr;
    renderer_->draw(view, camera, width, height);
}

render::Image HeadlessSession::draw(const render::Camera& camera, int width, int height) {
    show(camera, width, height);
    return renderer_->readPicture();
}

ExportLooks HeadlessSession::exportLooks() {
    return {carried(looks_, uncut_->mesh, simulation_.mesh()), lookOf(session_)};
}

void HeadlessSession::write(const ExportEvent& event, OutputFolder& folder) {
    const SurfaceMesh& mesh = simulation_.mesh();
    const Placement& placement = simulation_.placement();
    const ExportTarget target{event.file, event.filePerPiece, coordinatesOf(event, placement),
                              folder.pathOf(event.file).parent_path()};
    for (const ExportedFile& file : encodeExport(target, mesh, simulation_.pieces(), exportLooks(),
                                                 {placement, session_.origin})) {
        folder.write(file.file.generic_string(), file.bytes);
    }
}

std::vector<std::string> HeadlessSession::problemsWith(const CheckEvent& check,
                                                       bool withHash) const {
    const CheckDifference other = driver_.compare(check);
    std::vector<std::string> problems;
    if (other.hash && withHash) {
        problems.push_back("the state hash is " + *other.hash + " where the session expects " +
                           *check.hash + "; the replay has diverged");
    }
    if (other.pieces) {
        problems.push_back("the model is in " + counted(*other.pieces, "piece", "pieces") +
                           " where the session expects " + std::to_string(*check.pieces));
    }
    return problems;
}

std::string HeadlessSession::filePrefix() const {
    return session_.fileName.empty() ? "" : session_.fileName + ": ";
}

std::string HeadlessSession::positionInFile(int event) const {
    const std::string place = event < 0 ? "" : "events[" + std::to_string(event) + "] at ";
    return filePrefix() + place + "step " + std::to_string(simulation_.stepCount());
}

}  // namespace kerf::app
