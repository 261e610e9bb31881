#include "app/editor/view/editor_view.h"

#include "app/scene/document/rest_of_body.h"
#include "app/scene/editor_stroke.h"
#include "app/scene/section_pick.h"
#include "app/tools/measure_tool.h"
#include "app/tools/tool_marks.h"
#include "render/scene/surface_field.h"

namespace kerf::app {
namespace {

constexpr double kClick = 4;  // a drag is longer [px]

/// How far bounds reach beyond the part of a frame that is free, as a share of it; 1 if they don't.
double overflowOf(const ViewFrame& seen, const ui::Rect& free, const Bounds& bounds) {
    const Vec2 middle(free.x + free.width / 2, free.y + free.height / 2);
    double over = 1;
    for (int side = 0; side < 6; ++side) {  // a body hardly fills the corners of its box
        Vec3 point = bounds.center();
        point[side / 2] = (side % 2 == 0 ? bounds.low : bounds.high)[side / 2];
        const auto at = seen.toPixel(point);
        if (!at) {
            return std::numeric_limits<double>::infinity();  // behind the eye
        }
        over = std::max({over, std::abs(at->x - middle.x()) / (free.width / 2),
                         std::abs(at->y - middle.y()) / (free.height / 2)});
    }
    return over;
}

}  // namespace

bool EditorView::resize(int newWidth, int newHeight) {
    const bool other = newWidth != width || newHeight != height;
    if (!other || newWidth <= 0 || newHeight <= 0) {
        return false;
    }
    width = newWidth;
    height = newHeight;
    return true;
}

void EditorView::begin(const EditorScene& scene) {
    const RestOfBody& rest = scene.rest();
    camera = EditorCamera(fitted(rest.homeView(), rest.lines().value_or(rest.bounds())));
    display.begin(scene.document());
    tools.begin(scene.simulation().bounds());
    placement_ = scene.rest().revision();
    restBounds_ = scene.rest().bounds();
}

void EditorView::takeToolsOf(const Task& task) {
    ui::ToolSettings& settings = tools.settings();
    settings.tool = task.depth ? ui::ToolKind::scalpel : ui::ToolKind::stroke;
    settings.stroke.throughAll = true;
    settings.scalpel.depth = task.depth.value_or(settings.scalpel.depth);
}

SavedView EditorView::saved() const {
    const ui::DisplaySettings& shown = display.settings;
    return {camera.destination(),
            rowOf(tools.settings().tool).name,
            std::string(render::infoOf(shown.field.field).name),
            shown.wireframe,
            shown.apart,
            shown.section,
            display.ownLooks()};
}

void EditorView::show(const SavedView& saved) {
    camera = EditorCamera(saved.camera);
    ui::ToolKind& tool = tools.settings().tool;
    for (const ui::ToolRow& row : ui::kToolRows) {
        tool = row.name == saved.tool ? row.tool : tool;
    }
    ui::DisplaySettings& shown = display.settings;
    for (int i = 0; i < render::kSurfaceFields; ++i) {
        const auto field = static_cast<render::SurfaceField>(i);
        shown.field.field = render::infoOf(field).name == saved.field ? field : shown.field.field;
    }
    shown.wireframe = saved.wireframe;
    shown.apart = saved.apart;
    shown.section = saved.section;
    display.setOwnLooks(saved.pieces);
}

void EditorView::beginAgain(const EditorScene& scene) {
    const EditorCamera seen = camera;
    ui::DisplaySettings shown = display.settings;
    shown.apart = 0;
    begin(scene);
    camera = seen;
    display.settings = shown;
}

bool EditorView::follow(const EditorScene& scene) {
    if (placement_ == scene.rest().revision()) {
        return false;
    }
    placement_ = scene.rest().revision();
    const Bounds before = std::exchange(restBounds_, scene.rest().bounds());
    tools.fitTo(scene.simulation().bounds());
    if (tools.inHand().holds()) {
        return true;  // The view stands while the model moves in it.
    }
    const double ratio = restBounds_.diagonal() / before.diagonal();
    render::Camera moved = camera.destination();
    for (Vec3* point : {&moved.eye, &moved.target}) {
        *point = restBounds_.center() + ratio * (*point - before.center());
    }
    camera = EditorCamera(moved);
    return true;
}

ViewFrame EditorView::frame() const {
    ViewFrame seen{camera.shown(), width, height};
    if (free.width > 0) {
        seen.camera.middle = seen.toNdc({free.x + free.width / 2, free.y + free.height / 2});
    }
    return seen;
}

/// The side of the largest square that neither panels nor the hint cover, of the view's height.
double EditorView::freeShare() const {
    return std::max(1.0, double(std::min(free.width, free.height - hint))) / height;
}

render::Camera EditorView::fitted(render::Camera home, const Bounds& bounds) const {
    if (free.width <= 0) {
        return home;
    }
    ViewFrame seen = frame();
    home.middle = seen.camera.middle;
    constexpr double kMost = 2;  // at once: what is near the eye comes into view much sooner
    double over = 0;
    do {
        seen.camera = home;
        over = overflowOf(seen, free, bounds);
        home.zoom(std::min(over, kMost), home.middle, 1);
    } while (over > kMost);
    home.middle = Vec2::Zero();
    return home;
}

void EditorView::flyToFrame(const Bounds& bounds) {
    render::Camera wanted = camera.destination();
    wanted.frame(bounds, free.width > 0 ? freeShare() : 1);
    wanted.pan(0, -0.5 * hint / height);  // up from behind the hint
    camera.flyTo(wanted);
}

void EditorView::showFaulty(const ModelFault& fault, const OpeningOrder& order) {
    hideFaulty();
    if (fault.found() == nullptr || fault.found()->soup.triangles.empty()) {
        return;
    }
    faulty.emplace(FaultyModel{fault, order, FaultyScene(*fault.found(), order.file), camera});
    constexpr double kShare = 0.62;  // of the view's height; the question stands below
    camera = EditorCamera(faulty->scene.camera());
    camera.flyToFrame(faulty->scene.bounds(), kShare);
    camera.advance(EditorCamera::kFlightSeconds);
}

bool EditorView::hideFaulty() {
    if (!faulty) {
        return false;
    }
    camera = faulty->before;
    faulty.reset();
    return true;
}

// --- The pointer -------------------------------------------------------------------------------

void EditorView::move(const ui::PointerMove& move, const BusyScene& scene) {
    const Vec2 from = pointer;
    pointer = {move.x, move.y};
    const bool turned = camera.drag(pointer - from, height);
    if (!scene) {
        return;
    }
    if (turned) {
        camera.keepNear(scene.bounds());
    }
    if (sectionTool.holds() && display.settings.section) {
        display.settings.section =
            sectionTool.moved(frame(), pointer, *display.settings.section, scene.bounds());
        return;
    }
    tools.inHand().move(context(scene, move.modifiers));
}

std::string EditorView::press(const ui::ButtonChange& change, const BusyScene& scene) {
    if (change.button == ui::Button::right) {
        rightPress_ = pointer;
    }
    if (holds() || camera.press(change, mouse) || change.button != ui::Button::left || !scene) {
        return "";
    }
    if (pressSection(scene)) {
        return "";
    }
    if (display.join() && tools.inHand().aims()) {
        return "";  // What was aimed at is elsewhere.
    }
    std::string problem = tools.inHand().press(context(scene, change.modifiers));
    if (tools.settings().tool == ui::ToolKind::move && !holds()) {
        selectLoad(scene);
    }
    return problem;
}

/// The one of which a vertex or a hand is drawn nearest to the pointer; none behind the body.
void EditorView::selectLoad(const BusyScene& scene) {
    EditorScene* const now = scene.atRest();
    if (now == nullptr || display.settings.apart > 0) {
        return;
    }
    constexpr double kBehind = 0.05;  // of the body's diagonal
    const render::Ray ray = frame().rayThrough(pointer);
    const auto seen = pickVisible(*now, ray, display.settings.section);
    const Vec3 farthest = ray.direction * kBehind * scene.bounds().diagonal();
    std::vector<Vec3> places;
    std::vector<int> rows;
    const std::vector<Load>& loads = now->readout().takeLoads();
    const SurfaceMesh& mesh = now->simulation().mesh();
    for (const Load& load : loads) {
        places.insert(places.end(), load.hands.begin(), load.hands.end());
        for (const std::uint32_t v : load.vertices) {
            const Vec3& at = mesh.position(static_cast<int>(v));
            if (!seen || (at - seen->position - farthest).dot(ray.direction) < 0) {
                places.push_back(at);
            }
        }
        rows.resize(places.size(), static_cast<int>(&load - loads.data()));
    }
    // Between its dots, the triangle tells.
    const auto touched = std::ranges::find_if(loads, [&](const Load& load) {
        return seen && std::ranges::any_of(mesh.triangle(seen->triangle), [&](int v) {
                   return std::ranges::count(load.vertices, static_cast<std::uint32_t>(v)) > 0;
               });
    });
    const std::optional<int> found = handleAt(frame(), pointer, places);
    const auto between = touched != loads.end() ? static_cast<int>(touched - loads.begin()) : -1;
    display.select(loads, found ? rows[*found] : between);
}

bool EditorView::pressSection(const BusyScene& scene) {
    const std::optional<render::SectionPlane>& section = display.settings.section;
    return section && sectionTool.press(frame(), pointer, *section, scene.bounds());
}

std::string EditorView::release(ui::Button button, const BusyScene& scene) {
    camera.release(button);
    if (button == ui::Button::right && scene && rightClicks()) {
        if (tools.inHand().takesRightClicks()) {
            tools.inHand().rightClick(context(scene));
        } else {
            selectLoad(scene);
        }
    }
    if (button != ui::Button::left || !scene) {
        return "";
    }
    sectionTool.release();
    return tools.inHand().release(context(scene));
}

bool EditorView::rightClicks() const {
    return (pointer - rightPress_).norm() < kClick;
}

void EditorView::turnWheel(double notches, const BusyScene& scene) {
    if (scene && tools.inHand().turnWheel(notches, context(scene))) {
        return;
    }
    const ViewFrame seen = frame();
    camera.zoom(notches, seen.toNdc(pointer) - seen.camera.middle, seen.aspect());
    if (scene) {
        camera.keepNear(scene.bounds());
    }
}

// --- The tools ---------------------------------------------------------------------------------

ToolContext EditorView::context(const BusyScene& scene, const ui::Modifiers& modifiers) {
    return {frame(),
            pointer,
            modifiers,
            tools.settings(),
            scene.stroke(),
            scene.bounds(),
            display.settings.section,
            scene.atRest(),
            display.settings.cutAhead};
}

void EditorView::setTools(const ui::ToolSettings& settings, const BusyScene& scene) {
    if (settings.tool != tools.settings().tool) {
        display.join();
    }
    tools.set(settings, context(scene));
}

void EditorView::cancelTools(const BusyScene& scene, bool takesBack) {
    sectionTool.release();
    tools.cancel(context(scene), takesBack);
}

ui::Cursor EditorView::cursor(const ui::Overlay& overlay) const {
    const bool drags = camera.dragging() || tools.holdsBody() || sectionTool.holds();
    return drags ? ui::Cursor::hand : tools.inHand().cursor(overlay);
}

ui::Overlay EditorView::overlay(bool inView, const BusyScene& scene) {
    ToolContext seen = context(scene);
    seen.pixel = inView ? pointer : kNowhere;
    ui::Overlay overlay;
    tools.get<MeasureTool>().addMeasures(overlay, seen.view, seen.pixel);
    tools.addTo(overlay, seen);
    if (display.settings.section) {
        sectionTool.addTo(overlay, seen.view, seen.pixel, *display.settings.section, seen.bounds);
    }
    return overlay;
}

}  // namespace kerf::app
