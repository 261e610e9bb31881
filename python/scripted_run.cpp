#include "python/scripted_run.h"

#include <spdlog/spdlog.h>

#include <nlohmann/json.hpp>

#include "app/files/import/model_source.h"
#include "app/files/io/file_io.h"
#include "app/files/io/memory_means.h"
#include "app/files/io/output_folder.h"
#include "app/scene/timeline/saved_session.h"
#include "app/session/scene_origin.h"
#include "app/session/session.h"
#include "sim/base/stopwatch.h"
#include "sim/body/body_model.h"
#include "sim/mesh/triangle_quality.h"

namespace kerf::python {
namespace {

using app::InputError;

template <class Number>
SharedArray<Number> shared(std::vector<Number> numbers) {
    return std::make_shared<const std::vector<Number>>(std::move(numbers));
}

void append(std::vector<double>& numbers, const Vec3& v) {
    numbers.insert(numbers.end(), v.data(), v.data() + v.size());
}

/// What `get` has for each of `count` vertices, three numbers each.
template <class Get>
SharedArray<double> threeEach(int count, Get get) {
    std::vector<double> numbers;
    numbers.reserve(3 * static_cast<std::size_t>(count));
    for (int v = 0; v < count; ++v) {
        append(numbers, get(v));
    }
    return shared(std::move(numbers));
}

std::vector<int> presentTriangles(const SurfaceMesh& mesh) {
    std::vector<int> slots = livingTriangles(mesh);
    std::erase_if(slots, [&](int t) { return mesh.absent(t); });
    return slots;
}

app::ModelMesh load(const app::Session& session) {
    app::ReadOptions reading;
    reading.means = app::memoryMeans();
    return app::loadSessionModel(session, reading);
}

/// An action of the one kind that is asked for.
template <class Kind>
Kind only(const app::SessionAction& action) {
    const auto* kind = std::get_if<Kind>(&action);
    if (kind == nullptr) {
        throw InputError("type: expected another event.");
    }
    return *kind;
}

}  // namespace

ScriptedRun::ScriptedRun(app::Session session, const RunOptions& options)
    : session_(std::move(session)), options_(options) {
    gpu::enableDebugOutput();
    app::ModelMesh model = load(session_);
    warnAbout(model.remarks);
    session_ = app::withOrigin(std::move(session_), model.origin);
    schedule_.emplace(session_);
    app::requireMemoryFor(session_, model.mesh, options.undoBudget);
    running_ = std::make_unique<app::HeadlessSession>(
        session_, std::move(model), options.undoBudget,
        options.fine ? render::Quality::full : render::Quality::light);
    simulation().feelBlade(options.forces);
    row_.report = simulation().report();
}

ScriptedRun::~ScriptedRun() = default;

void ScriptedRun::warnAbout(const std::vector<std::string>& warnings) const {
    for (const std::string& warning : warnings) {
        spdlog::warn("{}{}", running_ ? running_->filePrefix() : "", warning);
    }
}

void ScriptedRun::tellMessages() {
    for (std::string& message : simulation().takeMessages()) {
        spdlog::warn(message);
        messages_.push_back(std::move(message));
    }
}

// --- What changes it ----------------------------------------------------------------------------

void ScriptedRun::apply(const std::string& action) {
    std::vector<std::string> warnings;
    const std::optional<Command> command =
        app::commandOf(app::countedFrom(app::parseAction(action, warnings), session_.origin));
    warnAbout(warnings);
    if (!command) {
        throw InputError("type: this event is no command.");
    }
    const std::string problem = running_->execute(*command);
    if (!problem.empty()) {
        throw InputError(problem);
    }
    log_.note(stepCount(), *command);
}

void ScriptedRun::perform(const Command& command, int event) {
    running_->perform(command, event);
}

void ScriptedRun::take(const app::CheckEvent& check) {
    const auto problems = running_->problemsWith(check, options_.hashChecks);
    if (!problems.empty()) {
        throw CheckFailure("Step " + std::to_string(stepCount()) + ": " + problems.front() + ".");
    }
}

const app::MetricsRow& ScriptedRun::step() {
    const Stopwatch watch;
    running_->driver().applyActions(*schedule_, *this);
    const StepReport& report = running_->step();
    row_ = {report, 0, watch.milliseconds(), app::namesToughness(session_, simulation().params()),
            app::secondsOfStep(simulation())};
    tellMessages();
    return row_;
}

void ScriptedRun::finish() {
    running_->driver().applyActions(*schedule_, *this);
}

std::shared_ptr<const ScriptedRun::Snapshot> ScriptedRun::snapshot() {
    return std::make_shared<const Snapshot>(
        Snapshot{running_->driver().now(), log_, row_, stepCount()});
}

void ScriptedRun::restore(const Snapshot& snapshot) {
    running_->goTo(snapshot.state);
    log_ = snapshot.log;
    row_ = snapshot.row;
}

// --- What it is like ----------------------------------------------------------------------------

ParamValue ScriptedRun::param(const std::string& name) const {
    return getParam(app::countedFrom(simulation().params(), -session_.origin), name);
}

std::optional<Blade> ScriptedRun::blade() const {
    std::optional<Blade> blade = simulation().comingBlade();
    if (blade) {
        blade = Blade{inScene(blade->a), inScene(blade->b)};
    }
    return blade;
}

std::vector<StaticBox> ScriptedRun::boxes() const {
    return app::countedFrom(simulation().boxes(), -session_.origin);
}

std::string ScriptedRun::stateHash() {
    return simulation().stateHash();
}

SharedArray<double> ScriptedRun::positions() {
    const int now = simulation().bodyRevision();
    if (std::exchange(positionsRevision_, now) != now) {
        const SurfaceMesh& mesh = simulation().mesh();
        positions_ =
            threeEach(mesh.vertexCount(), [&](int v) { return inScene(mesh.position(v)); });
    }
    return positions_;
}

SharedArray<double> ScriptedRun::velocities() {
    const SurfaceMesh& mesh = simulation().mesh();
    return threeEach(mesh.vertexCount(), [&](int v) { return mesh.velocity(v); });
}

SharedArray<double> ScriptedRun::strains() {
    const SurfaceMesh& mesh = simulation().mesh();
    std::vector<double> strains;
    for (const int t : presentTriangles(mesh)) {
        const Triangle& c = mesh.triangle(t);
        strains.push_back(largestStrain(
            {mesh.restPosition(c[0]), mesh.restPosition(c[1]), mesh.restPosition(c[2])},
            {mesh.position(c[0]), mesh.position(c[1]), mesh.position(c[2])}));
    }
    return shared(std::move(strains));
}

const TriangleArrays& ScriptedRun::triangles() {
    const int now = simulation().modelRevision();
    if (std::exchange(trianglesRevision_, now) == now) {
        return triangles_;
    }
    const SurfaceMesh& mesh = simulation().meshAsRead();
    const std::vector<int>& pieceOfVertex = simulation().bodyModel().pieceOfVertex;
    std::vector<std::int32_t> corners;
    std::vector<std::uint8_t> isWall;
    std::vector<std::int32_t> piece;
    for (const int t : presentTriangles(mesh)) {
        const Triangle& triangle = mesh.triangle(t);
        corners.insert(corners.end(), triangle.begin(), triangle.end());
        isWall.push_back(mesh.kind(t) == SurfaceKind::wall ? 1 : 0);
        piece.push_back(pieceOfVertex[triangle[0]]);
    }
    triangles_ = {
        shared(std::move(corners)), shared(std::move(isWall)), shared(std::move(piece)),
        threeEach(mesh.vertexCount(), [&](int v) { return inScene(mesh.restPosition(v)); })};
    return triangles_;
}

PieceArrays ScriptedRun::pieces() const {
    const std::vector<Piece> pieces = simulation().measuredPieces();
    std::vector<std::int32_t> triangles;
    std::vector<std::int32_t> model;
    std::vector<double> volume;
    std::vector<double> restVolume;
    std::vector<double> low;
    std::vector<double> high;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        triangles.push_back(pieces[i].triangles);
        model.push_back(simulation().bodyModel().pieces[i].member);
        volume.push_back(pieces[i].volume);
        restVolume.push_back(pieces[i].restVolume);
        append(low, inScene(simulation().pieceBounds()[i].low));
        append(high, inScene(simulation().pieceBounds()[i].high));
    }
    return {shared(std::move(triangles)),  shared(std::move(model)), shared(std::move(volume)),
            shared(std::move(restVolume)), shared(std::move(low)),   shared(std::move(high))};
}

SharedArray<std::uint32_t> ScriptedRun::pinnedVertices() const {
    return shared(simulation().pinnedVertices());
}

std::string ScriptedRun::tearSentence() const {
    const StepReport& report = simulation().report();
    return kerf::tearSentence(report, simulation().params(), report.tear && report.tear->advanced);
}

std::string ScriptedRun::cutReport() const {
    const std::optional<app::CutReport> report = app::reportOnCuts(simulation());
    return report ? app::toJson(*report).dump() : "null";
}

// --- Files and pictures -------------------------------------------------------------------------

render::Image ScriptedRun::picture(const std::string& size, const std::string& view) {
    std::vector<std::string> warnings;
    const auto event = only<app::ScreenshotEvent>(app::parseAction(size, warnings));
    const render::Camera camera =
        view.empty() ? running_->camera()
                     : app::countedFrom(app::parseCamera(view, warnings), session_.origin);
    warnAbout(warnings);
    return running_->draw(camera, event.width, event.height);
}

std::vector<std::string> ScriptedRun::exportMesh(const std::filesystem::path& folder,
                                                 const std::string& event) {
    std::vector<std::string> warnings;
    const auto wanted = only<app::ExportEvent>(app::parseAction(event, warnings));
    app::OutputFolder output(folder);
    running_->write(wanted, output);
    return output.written();
}

void ScriptedRun::saveSession(const std::filesystem::path& file) {
    if (!session_.events.empty()) {
        throw InputError(
            "This simulation plays a session, which is a file already; only what a script does "
            "from a model on can be saved.");
    }
    app::Session saved = app::sessionAsSaved(session_, log_).session;
    saved.steps = std::max(stepCount(), 1);
    const bool ran = stepCount() > 0;
    if (ran) {
        saved.events.push_back(
            {saved.steps,
             app::CheckEvent{stateHash(), static_cast<int>(simulation().pieces().pieces.size())}});
    }
    app::writeOutputFile(file,
                         app::formatSession(saved, std::filesystem::absolute(file).parent_path()));
}

}  // namespace kerf::python
