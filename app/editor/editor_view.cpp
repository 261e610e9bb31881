#include "app/editor/editor_view.h"

#include <algorithm>
#include <utility>

#include "app/scene/editor_stroke.h"
#include "app/scene/held_hands.h"
#include "app/scene/rest_of_body.h"
#include "app/scene/section_pick.h"
#include "sim/run/simulation.h"

namespace kerf::app {
namespace {

const Vec2 kNowhere(-1e5, -1e5);  // [px]
constexpr double kClick = 4;      // a drag is longer [px]

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
    camera = EditorCamera(scene.rest().homeView());
    display.begin(scene.document());
    measures.clear();
    bladeTool.fitTo(scene.simulation().bounds());
    pullTool = {};
    retractTool = {};
    moveTool.forget();
    placement_ = scene.rest().revision();
    restBounds_ = scene.rest().bounds();
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
    bladeTool.fitTo(scene.simulation().bounds());
    if (moveTool.holds()) {
        return true;  // The view stands while the model moves in it.
    }
    const double ratio = restBounds_.diagonal() / before.diagonal();
    render::Camera moved = camera.destination();
    for (Vec3* point : {&moved.eye, &moved.target}) {
        *point = restBounds_.center() + ratio * (*point - before.center());
    }
    camera = EditorCamera(moved);
    pullTool = {};
    retractTool = {};
    return true;
}

ViewFrame EditorView::frame() const {
    ViewFrame seen{camera.shown(), width, height};
    if (free.width > 0) {
        seen.camera.middle = seen.toNdc({free.x + free.width / 2, free.y + free.height / 2});
    }
    return seen;
}

void EditorView::flyToFrame(const Bounds& bounds) {
    const bool known = free.width > 0;
    camera.flyToFrame(bounds, known ? std::min(free.width, free.height) / float(height) : 1);
}

// --- The pointer -------------------------------------------------------------------------------

void EditorView::move(const ui::PointerMove& move, EditorScene* scene) {
    const Vec2 from = pointer;
    pointer = {move.x, move.y};
    const bool turned = camera.drag(pointer - from, height);
    if (scene == nullptr) {
        return;
    }
    if (turned) {
        camera.keepNear(scene->simulation().bounds());
    }
    if (sectionTool.holds() && display.settings.section) {
        display.settings.section = sectionTool.moved(frame(), pointer, *display.settings.section,
                                                     scene->simulation().bounds());
        return;
    }
    bladeTool.move(frame(), pointer, move.modifiers, *scene);
    pullTool.move(frame(), pointer, *scene);
    retractTool.move(frame(), pointer, *scene);
    moveTool.move(frame(), pointer, move.modifiers.control);
}

std::string EditorView::press(const ui::ButtonChange& change, EditorScene* scene) {
    if (change.button == ui::Button::right) {
        rightPress_ = pointer;
    }
    if (holds() || camera.press(change, mouse) || change.button != ui::Button::left ||
        scene == nullptr) {
        return "";
    }
    if (pressSection(*scene)) {
        return "";
    }
    const ui::ToolSettings& settings = bladeTool.settings();
    if (display.join() && settings.tool != ui::Tool::stroke) {
        return "";  // What was aimed at is elsewhere.
    }
    if (settings.tool == ui::Tool::measure) {
        pressMeasure(*scene);
        return "";
    }
    if (settings.tool == ui::Tool::retract) {
        return retractTool.press(frame(), pointer, *scene);
    }
    if (settings.tool == ui::Tool::move) {
        return moveTool.press(frame(), pointer, *scene);
    }
    bladeTool.press(frame(), pointer, *scene);
    return pullTool.press(frame(), pointer, settings, change.modifiers, *scene);
}

bool EditorView::pressSection(const EditorScene& scene) {
    const std::optional<render::SectionPlane>& section = display.settings.section;
    return section && sectionTool.press(frame(), pointer, *section, scene.simulation().bounds());
}

void EditorView::pressMeasure(EditorScene& scene) {
    const auto point = pickVisible(scene, frame().rayThrough(pointer), display.settings.section);
    if (point) {
        measures.click(bladeTool.settings().measure, *point, scene);
    }
}

bool EditorView::endsMeasuring() {
    if (bladeTool.settings().tool != ui::Tool::measure) {
        return false;
    }
    if (!measures.dropPending()) {
        bladeTool.choose(ui::Tool::stroke);
    }
    return true;
}

std::string EditorView::release(ui::Button button, EditorScene* scene) {
    camera.release(button);
    if (button == ui::Button::right && scene != nullptr && rightClicks()) {
        removeRetractorAt(pointer, *scene);
    }
    if (button != ui::Button::left || scene == nullptr) {
        return "";
    }
    sectionTool.release();
    bladeTool.release(*scene);
    retractTool.release(*scene);
    moveTool.release();
    return pullTool.release(frame(), *scene);
}

bool EditorView::rightClicks() const {
    return bladeTool.settings().tool == ui::Tool::retract &&
           (pointer - rightPress_).norm() < kClick;
}

void EditorView::removeRetractorAt(const Vec2& pixel, EditorScene& scene) const {
    if (const std::optional<int> hook = RetractTool::hookAt(frame(), pixel, scene)) {
        scene.hands().removeRetractor(*hook);
    }
}

void EditorView::zoom(double notches, EditorScene* scene) {
    const ViewFrame seen = frame();
    camera.zoom(notches, seen.toNdc(pointer) - seen.camera.middle, seen.aspect());
    if (scene != nullptr) {
        camera.keepNear(scene->simulation().bounds());
    }
}

// --- The tools ---------------------------------------------------------------------------------

void EditorView::setTools(const ui::ToolSettings& settings, EditorScene& scene) {
    if (settings.tool != bladeTool.settings().tool) {
        display.join();
        measures.dropPending();
        pullTool.cancel(scene);
        retractTool.release(scene);
        moveTool.drop();
    }
    bladeTool.set(settings, scene);
}

void EditorView::cancelTools(EditorScene& scene) {
    sectionTool.release();
    bladeTool.cancel(scene);
    pullTool.cancel(scene);
    retractTool.cancel(scene);
    moveTool.drop();
}

ui::Cursor EditorView::cursor(const ui::Overlay& overlay) const {
    if (camera.dragging() || holdsBody() || sectionTool.holds()) {
        return ui::Cursor::hand;
    }
    const bool onHandle = std::ranges::any_of(overlay.handles, &ui::Overlay::Handle::hot) ||
                          std::ranges::any_of(overlay.axisLines, &ui::Overlay::AxisLine::hot) ||
                          std::ranges::any_of(overlay.axisDots, &ui::Overlay::AxisDot::hot);
    switch (bladeTool.settings().tool) {
        case ui::Tool::guillotine:
            return onHandle ? ui::Cursor::hand : ui::Cursor::arrow;
        case ui::Tool::move:
            return onHandle || overlay.chooses ? ui::Cursor::hand : ui::Cursor::arrow;
        case ui::Tool::retract:  // Dots show the lips that it would hook.
            return onHandle || !overlay.dots.empty() ? ui::Cursor::hand : ui::Cursor::arrow;
        case ui::Tool::grab:  // Its ring is drawn where there is something to hold.
            return overlay.guides.empty() ? ui::Cursor::arrow : ui::Cursor::hand;
        case ui::Tool::scalpel:
        case ui::Tool::pin:  // So are theirs; Shift draws the box of pins anywhere.
            return overlay.guides.empty() ? ui::Cursor::arrow : ui::Cursor::crosshair;
        case ui::Tool::stroke:
        case ui::Tool::measure:
            break;
    }
    return ui::Cursor::crosshair;
}

ui::Overlay EditorView::overlay(bool inView, bool looks, EditorScene& scene) const {
    const Vec2 at = inView ? pointer : kNowhere;
    ui::Overlay overlay =
        looks ? bladeTool.overlay(frame(), at, scene) : BladeTool::swept(frame(), scene.stroke());
    if (looks) {
        pullTool.addTo(overlay, frame(), at, bladeTool.settings(), scene);
    }
    measures.addTo(overlay, frame(), at);
    if (looks && bladeTool.settings().tool == ui::Tool::retract) {
        retractTool.addTo(overlay, frame(), at, scene);
    }
    if (looks && bladeTool.settings().tool == ui::Tool::move) {
        moveTool.addTo(overlay, frame(), at, scene);
        overlay.chooses = moveTool.isOver(frame(), at, scene);
    }
    if (display.settings.section) {
        sectionTool.addTo(overlay, frame(), at, *display.settings.section,
                          scene.simulation().bounds());
    }
    return overlay;
}

}  // namespace kerf::app
