#include "app/scene/readout/scene_readout.h"

#include "app/scene/document/editor_document.h"
#include "app/scene/document/size_effect.h"
#include "app/scene/document/triangle_text.h"
#include "app/scene/timeline/hooks.h"
#include "app/scene/timeline/session_marks.h"
#include "app/session/scene_origin.h"
#include "app/session/scene_view.h"
#include "sim/mesh/invariants.h"
#include "sim/mesh/piece_figures.h"
#include "sim/run/undo/undo_history.h"
#include "ui/base/unit_text.h"

namespace kerf::app {
namespace {

constexpr int kMostLiveTriangles = 20'000;  // of a body that follows a drag of its placement

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

void MarkTable::follow(const EventLog& log) {
    const std::size_t entries = log.entries().size();
    if (revision_ != log.revision() || entries_ != entries) {
        marks_ = marksOf(log);
        past_ = pastMarks(log);
        revision_ = log.revision();
        entries_ = entries;
    }
}

// --- What is read as it goes -------------------------------------------------------------------

void SceneReadout::startAnew() {
    readings_.clear();
    volumes_ = {};
    pieces_.refresh(body_.simulation);
}

void SceneReadout::addStep(const StepReport& report, int piecesBefore) {
    if (report.pieces != piecesBefore) {
        readings_.mark(timeline_.time(), report.tear && report.tear->advanced ? "tear" : "cut");
    }
    forces_.add(report, body_.simulation.params().timeStep);
    readings_.addStep(timeline_.time(), body_.simulation);
    addPoint();
    if (!report.open && volumes_.add(report.step, body_.simulation.measuredPieces())) {
        body_.messages.push_back(volumes_.sentence());
    }
}

void SceneReadout::addJump(const char* name) {
    volumes_ = {};
    readings_.addJump(timeline_.time(), body_.simulation);
    readings_.mark(timeline_.time(), name);
    addPoint();
    pieces_.refresh(body_.simulation);
}

void SceneReadout::goBack(bool countsAnew) {
    if (countsAnew) {
        readings_.clear();
    }
    readings_.forgetAfter(timeline_.time());
    pieces_.refresh(body_.simulation);
}

void SceneReadout::plot(std::optional<SurfaceAnchor> point) {
    point_ = std::move(point);
    readings_.forgetPoint();
    addPoint();
}

/// Of a point whose material was cut away there are no more values.
void SceneReadout::addPoint() {
    const SurfaceMesh& mesh = body_.simulation.meshAsRead();
    if (point_ && !point_->follow(mesh)) {
        point_.reset();
    }
    if (point_) {
        readings_.addPoint(timeline_.time(), valuesAt(mesh, *point_));
    }
}

void SceneReadout::addPicture(const FrameTime& frame, double renderMs) {
    readings_.addPicture(timeline_.time(), frame, renderMs);
}

// --- What is shown -----------------------------------------------------------------------------

bool SceneReadout::followPieceSums(bool wanted) {
    const bool due = wanted && !pieces_.isAddedUp(body_.simulation);
    if (due) {
        pieces_.addUp(body_.simulation);
    }
    return due;
}

const std::vector<ui::PieceRow>& SceneReadout::measurePieces() {
    pieces_.addUp(body_.simulation);
    return pieces_.rows();
}

const std::vector<Load>& SceneReadout::takeLoads() {
    loads_.follow(body_.simulation, body_.document.session.origin);
    return loads_.loads();
}

SceneReadout::MarksPointer SceneReadout::marks(bool faults, int load) {
    constexpr render::DisplayColor kColor{86, 180, 233};
    MarksPointer base = faults && body_.document.faults.any() ? faultMarks() : MarksPointer();
    if (load < 0 || load >= static_cast<int>(loads().size())) {
        return base;
    }
    auto all = base ? *base : std::vector<render::Marks>{};
    all.push_back({"", kColor, {}, loads()[load].vertices});
    const std::size_t vertices = body_.simulation.bodyView().vertexCount;
    std::erase_if(all.back().dots, [&](std::uint32_t v) { return v >= vertices; });
    if (!allMarks_ || *allMarks_ != all) {
        allMarks_ = std::make_shared<const std::vector<render::Marks>>(std::move(all));
    }
    return allMarks_;
}

const SceneReadout::MarksPointer& SceneReadout::faultMarks() {
    const int triangles = body_.simulation.report().triangles;
    if (std::exchange(marksTriangles_, triangles) != triangles) {
        const SurfaceMesh& now = body_.simulation.meshAsRead();
        const SurfaceMesh& opened = body_.rest.uncut().mesh;
        const auto cornersOf = [&](int t) {
            const bool whole = now.alive(t) && now.triangle(t) == opened.triangle(t);
            return whole ? std::optional(opened.triangle(t)) : std::nullopt;
        };
        faultMarks_ = std::make_shared<const std::vector<render::Marks>>(
            marksOf(body_.document.faults, cornersOf));
    }
    return faultMarks_;
}

render::SceneView SceneReadout::view() {
    render::SceneView view = sceneOf(body_.simulation, lookOf(body_.document.session),
                                     body_.rest.bounds(), body_.driver.strokePoses());
    view.paint = skin_.paintOf(body_.simulation);
    view.field.values = thickness_.values();
    return view;
}

void SceneReadout::describe(ui::PanelModel& model) {
    const Simulation& simulation = body_.simulation;
    pieces_.follow(simulation, timeline_.playing);
    const StepReport& report = simulation.report();
    model.name = body_.document.name;
    describeModels(model);
    const Vec3 toScene = -body_.document.session.origin;
    model.parameters.now = countedFrom(simulation.params(), toScene);
    model.parameters.start = countedFrom(body_.document.session.params, toScene);
    model.body.boxes = countedFrom(simulation.boxes(), toScene);
    model.body.pinned = simulation.pinnedVertices().size() + simulation.forces().size();
    model.body.hooks = hooksOf(simulation.hands()).size();
    std::ranges::transform(takeLoads(), std::back_inserter(model.body.loads.rows), &Load::row);
    model.body.size = body_.rest.bounds().diagonal();
    model.body.bounds = simulation.bounds();
    model.parameters.iterations = report.iterations;
    model.parameters.implicitSteps = report.implicitSteps;
    model.parameters.residual = report.residual;
    model.transport.playing = timeline_.playing;
    model.transport.step = simulation.stepCount();
    model.transport.restarted = timeline_.start().step > 0;
    model.transport.time = timeline_.time();
    model.transport.realTimeFactor = readings_.realTimeFactor();
    describeChanges(model.changes);
    model.body.vertices = report.vertices;
    model.body.triangles = report.triangles;
    model.cuts.subdivisions = simulation.subdivisions();
    model.cuts.rows = cuts_.rows();
    model.cuts.note = cuts_.note();
    model.pieces.rows = pieces_.rows();
    model.plots.history = &readings_.history();
    timeline_.describe(model.session.playback);
    marks_.follow(timeline_.log());
    model.session.marks = marks_.marks();
    model.session.past = marks_.past();
}

void SceneReadout::describeChanges(ui::ChangeList& list) const {
    const UndoHistory& history = body_.simulation.history();
    for (const UndoEntry& entry : history.entries()) {
        list.rows.push_back({ui::withRaisedDigits(entry.name), entry.time});
    }
    list.done = history.done();
    list.forgotten = history.forgotten();
    list.recallable = timeline_.hasForgotten();
    list.bytes = history.bytes();
    list.budget = history.budget();
    list.checkpoints = timeline_.checkpointBytes();
    list.checkpointBudget = kCheckpointBudget;
}

void SceneReadout::describeModels(ui::PanelModel& model) const {
    const Simulation& simulation = body_.simulation;
    const Session& session = body_.document.session;
    const repair::Faults& faults = body_.document.faults;
    for (int m = 0; m < simulation.modelCount(); ++m) {
        const ModelFigures& figures = body_.rest.models()[m];
        ui::ModelState state;
        state.name = m == 0 ? session.model.name() : session.moreModels[m - 1].model.name();
        state.placement = simulation.placement(m);
        state.size = figures.bounds.high - figures.bounds.low;
        state.physics =
            sizeEffect(state.size.y(), figures.volume, paramsOf(simulation.params(), m));
        state.triangles = trianglesText(figures.triangles);
        const ModelReference& reference = m == 0 ? session.model : session.moreModels[m - 1].model;
        state.edge = body_.proposedEdge(m);
        state.remeshed = trianglesOf(figures.triangles,
                                     proposedEdge(figures.triangles, figures.bounds.diagonal()));
        state.crosses =
            !reference.repair && faults.of(repair::FaultKind::crossingTriangle).count() > 0;
        model.model.models.push_back(std::move(state));
    }
    model.model.models.front().guess = body_.document.guess ? body_.document.guess->sentence : "";
    model.model.objects = static_cast<int>(body_.document.objects.size());
    model.model.faultCount = 0;
    for (const repair::FaultLocations& places : faults.places) {
        model.model.faultCount += places.count();
    }
    model.model.untouched =
        simulation.report().triangles == body_.rest.uncut().mesh.aliveTriangles();
    model.model.live = simulation.report().triangles <= kMostLiveTriangles;
}

namespace {

constexpr int kRefreshEvery = 10;  // steps

}  // namespace

void PieceTable::refresh(const Simulation& simulation) {
    const bool same = isAddedUp(simulation);
    const std::vector<ui::PieceRow> before = std::exchange(rows_, {});
    const std::vector<Bounds>& bounds = simulation.pieceBounds();
    double all = 0;
    for (const Piece& piece : simulation.measuredPieces()) {
        ui::PieceRow row;
        row.triangles = piece.triangles;
        row.volume = piece.volume;
        row.share = piece.restVolume > 0 ? piece.volume / piece.restVolume : 0;
        const std::size_t p = rows_.size();
        row.bounds = p < bounds.size() ? bounds[p] : Bounds{};
        row.sums = same && p < before.size() ? before[p].sums : std::nullopt;
        all += piece.volume;
        rows_.push_back(row);
    }
    for (ui::PieceRow& row : rows_) {
        row.shareOfAll = all > 0 ? row.volume / all : 0;
    }
    step_ = simulation.stepCount();
    triangles_ = simulation.report().triangles;
}

void PieceTable::follow(const Simulation& simulation, bool playing) {
    const int age = simulation.stepCount() - step_;
    const bool recut = simulation.report().triangles != triangles_;
    if (recut || age >= kRefreshEvery || (age != 0 && !playing)) {
        refresh(simulation);
    }
}

void PieceTable::addUp(Simulation& simulation) {
    refresh(simulation);
    const std::vector<int> triangles = simulation.trianglesOfPieces();
    const SurfaceMesh& mesh = simulation.mesh();
    const PieceShells shells(mesh);
    for (std::size_t p = 0; p < rows_.size(); ++p) {
        if (triangles[p] >= 0) {
            const PieceFigures figures = figuresOfPiece(mesh, shells, triangles[p]);
            rows_[p].sums = {figures.skinArea, figures.cutArea, figures.centroid};
        }
    }
    sumsRevision_ = simulation.bodyRevision();
}

}  // namespace kerf::app
