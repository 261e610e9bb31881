#include "app/tools/move_tool.h"

#include <Eigen/Geometry>

#include "app/scene/document/rest_of_body.h"
#include "app/scene/readout/cut_preview.h"
#include "app/tools/tool_marks.h"
#include "sim/base/placement.h"
#include "sim/mesh/box_tree.h"
#include "sim/run/simulation.h"
#include "sim/run/start/prepared_body.h"
#include "sim/run/undo/undo_history.h"

namespace kerf::app {
namespace {

constexpr int kMostLiveTriangles = 20'000;  // of a model that follows a drag, not only its end

/// How far along a ray it enters a box, if it does.
double entryInto(const StaticBox& box, const render::Ray& ray) {
    const Eigen::Matrix3d back = box.axes().transpose();
    const Bounds own{-0.5 * box.size, 0.5 * box.size};
    return entryInto(own, {back * (ray.origin - box.center), back * ray.direction}, 1e300);
}

bool isUncut(const EditorScene& scene) {
    const Simulation& simulation = scene.simulation();
    return simulation.report().triangles == simulation.uncut()->mesh.aliveTriangles();
}

bool isPinned(const EditorScene& scene, const SurfacePoint& point) {
    const std::vector<std::uint32_t>& pinned = scene.simulation().pinnedVertices();
    return std::ranges::any_of(
        scene.simulation().meshAsRead().triangle(point.triangle),
        [&](int v) { return std::ranges::binary_search(pinned, static_cast<std::uint32_t>(v)); });
}

/// Of an uncut body.
int modelAt(const EditorScene& scene, const SurfacePoint& point) {
    const int vertex = scene.simulation().meshAsRead().triangle(point.triangle)[0];
    return scene.simulation().uncut()->modelOf(vertex);
}

StaticBox changed(StaticBox box, const GizmoChange& change) {
    box.center += change.by;
    box.size = (box.size + change.grow).cwiseMax(kLeastBoxSize).cwiseMin(kLargestBoxSize);
    if (!change.turn.isIdentity(0)) {
        box.rotate = turnsOf(change.turn * box.axes());
    }
    return box;
}

}  // namespace

// --- What it is put on -------------------------------------------------------------------------

MoveTool::Subject MoveTool::subjectOf(const EditorScene& scene) const {
    const int boxes = static_cast<int>(scene.simulation().boxes().size());
    const bool pins = !scene.simulation().pinnedVertices().empty();
    if (subject_ && (subject_->kind == Kind::model || (subject_->kind == Kind::pins && pins) ||
                     (subject_->kind == Kind::box && subject_->number < boxes))) {
        return *subject_;
    }
    if (boxes > 0) {
        return {Kind::box, boxes - 1};
    }
    return {pins ? Kind::pins : Kind::model};
}

std::optional<GizmoFrame> MoveTool::frameOf(EditorScene& scene) const {
    const Subject subject = subjectOf(scene);
    GizmoFrame frame;
    switch (subject.kind) {
        case Kind::box: {
            const StaticBox& box = scene.simulation().boxes()[subject.number];
            return GizmoFrame{box.center, box.axes(), 0.5 * box.size};
        }
        case Kind::pins:
            frame.at = middleOfPins(scene);
            return frame;
        case Kind::model:
            frame.at = scene.rest().models()[subject.number].bounds.center();
            frame.scales = true;
            break;
    }
    return isUncut(scene) ? std::optional(frame) : std::nullopt;
}

Vec3 MoveTool::middleOfPins(EditorScene& scene) const {
    const std::vector<std::uint32_t>& vertices = scene.simulation().pinnedVertices();
    const int revision = scene.simulation().bodyRevision();
    const bool moved = revision != pins_.revision && (!scene.running() || start_);
    if (vertices != pins_.vertices || moved) {
        Vec3 sum = Vec3::Zero();
        for (const std::uint32_t v : vertices) {
            sum += scene.simulation().mesh().position(static_cast<int>(v));
        }
        pins_ = {vertices, revision, sum / static_cast<double>(vertices.size())};
    }
    return pins_.at;
}

std::optional<MoveTool::Subject> MoveTool::subjectAt(const ToolContext& c) {
    EditorScene& scene = *c.scene;
    const render::Ray ray = c.view.rayThrough(c.pixel);
    std::optional<Subject> found;
    double nearest = std::numeric_limits<double>::max();
    if (const auto point = scene.pick(ray)) {
        found = isPinned(scene, *point) ? Subject{Kind::pins}
                                        : Subject{Kind::model, modelAt(scene, *point)};
        nearest = (point->position - ray.origin).norm();
    }
    const std::vector<StaticBox>& boxes = scene.simulation().boxes();
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        if (const double way = entryInto(boxes[i], ray); way < kMissesBox && way < nearest) {
            found = Subject{Kind::box, static_cast<int>(i)};
            nearest = way;
        }
    }
    return found;
}

// --- A drag ------------------------------------------------------------------------------------

std::string MoveTool::press(const ToolContext& c) {
    EditorScene& scene = *c.scene;
    const std::optional<GizmoFrame> frame = frameOf(scene);
    if (frame && gizmo_.press(c.view, c.pixel, *frame)) {
        const Subject subject = subjectOf(scene);
        start_ = Start{.subject = subject,
                       .frame = *frame,
                       .box = {},
                       .placement = scene.simulation().placement(
                           subject.kind == Kind::model ? subject.number : 0),
                       .sent = {}};
        if (subject.kind == Kind::box) {
            start_->box = scene.simulation().boxes()[subject.number];
        }
        return "";
    }
    if (const std::optional<Subject> subject = subjectAt(c)) {
        subject_ = subject;
        if (subject->kind == Kind::model && !isUncut(scene)) {
            return "A cut model can't be moved. Changing its placement under Model resets the "
                   "cuts.";
        }
    }
    return "";
}

void MoveTool::move(const ToolContext& c) {
    if (gizmo_.holds()) {
        wanted_ = gizmo_.moved(c.view, c.pixel, c.modifiers.control);
    }
}

std::string MoveTool::release(const ToolContext& /*c*/) {
    gizmo_.release();
    if (!wanted_) {
        start_.reset();
    }
    return "";
}

void MoveTool::cancel(const ToolContext& /*c*/) {
    gizmo_.release();
    start_.reset();
    wanted_.reset();
}

std::optional<Command> MoveTool::takeCommand(const EditorScene& scene) {
    if (!wanted_ || !start_) {
        return std::nullopt;
    }
    const bool live = start_->subject.kind != Kind::model ||
                      scene.simulation().report().triangles <= kMostLiveTriangles;
    if (!live && gizmo_.holds()) {
        return std::nullopt;
    }
    return commandOf(*wanted_);
}

void MoveTool::noteOutcome(bool done, const EditorScene& scene) {
    const GizmoChange sent = *std::exchange(wanted_, std::nullopt);
    if (done) {
        start_->sent = sent;
        start_->continues = true;
        start_->changes = scene.simulation().history().done();
    }
    if (!gizmo_.holds()) {
        start_.reset();
    }
}

void MoveTool::takeBack(const ToolContext& c) {
    const bool did = gizmo_.holds() && start_ && start_->continues &&
                     start_->changes == c.scene->simulation().history().done();
    cancel(c);
    if (did) {
        c.scene->execute(Undo{});
    }
}

Command MoveTool::commandOf(const GizmoChange& change) const {
    switch (start_->subject.kind) {
        case Kind::box:
            return ChangeBox{start_->subject.number, changed(start_->box, change),
                             start_->continues};
        case Kind::pins:
            return MovePins{change.by - start_->sent.by,
                            turnsOf(change.turn * start_->sent.turn.transpose()),
                            start_->continues};
        case Kind::model:
            break;
    }
    return placed(change);
}

/// The model's middle stays where it is, or goes where the arrow goes.
Command MoveTool::placed(const GizmoChange& change) const {
    Placement placement = start_->placement;
    const Vec3 middle = start_->frame.at;
    const Vec3 arm = middle - placement.translate;
    if (!change.turn.isIdentity(0)) {
        placement.rotate = turnsOf(change.turn * turnOf(placement.rotate));
    }
    placement.scale = std::clamp(placement.scale * change.factor, 1e-6, 1e6);
    const double factor = placement.scale / start_->placement.scale;
    placement.translate = middle + change.by - factor * (change.turn * arm);
    return Place{placement, start_->continues, start_->subject.number};
}

// --- The picture -------------------------------------------------------------------------------

bool MoveTool::isOver(const ToolContext& c, const std::optional<GizmoFrame>& frame) const {
    if (frame && Gizmo::isAt(c.view, c.pixel, *frame)) {
        return true;
    }
    const std::optional<Subject> subject = subjectAt(c);
    return subject && *subject != subjectOf(*c.scene);
}

void MoveTool::addTo(ui::Overlay& overlay, const ToolContext& c) const {
    const std::optional<GizmoFrame> frame = frameOf(*c.scene);
    if (frame) {
        gizmo_.addTo(overlay, c.view, c.pixel, *frame);
    }
    overlay.chooses = isOver(c, frame);
}

ui::Cursor MoveTool::cursor(const ui::Overlay& overlay) const {
    return isOnHandle(overlay) || overlay.chooses ? ui::Cursor::hand : ui::Cursor::arrow;
}

std::unique_ptr<Tool> makeMoveTool() {
    return std::make_unique<MoveTool>();
}

}  // namespace kerf::app
