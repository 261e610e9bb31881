#include "app/tools/retract_tool.h"

#include <algorithm>

#include "app/scene/cut_preview.h"
#include "app/scene/held_hands.h"
#include "app/scene/rest_of_body.h"
#include "app/tools/tool_limits.h"
#include "sim/base/quantity_text.h"
#include "sim/run/simulation.h"

namespace kerf::app {
namespace {

constexpr double kBesideACut = 0.25;  // of the body's diagonal, from a press to the cut
constexpr double kWidest = 0.6;       // of the body's diagonal

std::optional<Incision> incisionAt(const Vec3& point, EditorScene& scene) {
    const double reach = kBesideACut * scene.rest().bounds().diagonal();
    return incisionNear(scene.simulation().mesh(), point, reach);
}

}  // namespace

std::string RetractTool::press(const ViewFrame& view, const Vec2& pixel, EditorScene& scene) {
    if (const std::optional<int> hook = hookAt(view, pixel, scene)) {
        takeAgain(*hook, scene);
        return "";
    }
    return hookLips(view, pixel, scene);
}

std::string RetractTool::hookLips(const ViewFrame& view, const Vec2& pixel, EditorScene& scene) {
    const auto point = scene.pick(view.rayThrough(pixel));
    if (!point) {
        return "";
    }
    const std::optional<Incision> incision = incisionAt(point->position, scene);
    if (!incision) {
        return "No cut is near that place. Press on the skin beside a cut.";
    }
    const std::variant<int, std::string> hooked = scene.hands().hook(*incision);
    if (const auto* problem = std::get_if<std::string>(&hooked)) {
        return *problem;
    }
    const int first = std::get<int>(hooked);
    drag_ = Opening{.hooks = {first, partnerOf(first)},
                    .from = incision->lips,
                    .across = incision->across,
                    .at = point->position,
                    .before = incision->gap};
    return "";
}

void RetractTool::takeAgain(int hook, const EditorScene& scene) {
    const std::vector<Hands::Hand> hooks = scene.hands().hooks();
    const auto taken = std::ranges::find(hooks, hook, &Hands::Hand::number);
    const auto other = std::ranges::find(hooks, partnerOf(hook), &Hands::Hand::number);
    if (taken == hooks.end() || other == hooks.end() || taken->to == other->to) {
        return;
    }
    drag_ = Opening{.hooks = {hook, partnerOf(hook)},
                    .from = {taken->to, other->to},
                    .across = (other->to - taken->to).normalized(),
                    .at = taken->to,
                    .isNew = false,
                    .before = (other->to - taken->to).norm()};
}

/// A new retractor opens wherever the pointer goes; a hook that is taken again follows it.
void RetractTool::move(const ViewFrame& view, const Vec2& pixel, EditorScene& scene) {
    if (!drag_) {
        return;
    }
    const Vec3 way = view.onPlaneThrough(drag_->at, pixel) - drag_->at;
    const double wanted = drag_->isNew ? way.norm() : -2 * way.dot(drag_->across);
    const double widest = kWidest * scene.rest().bounds().diagonal();
    drag_->by = std::clamp(wanted, -drag_->before, std::max(0.0, widest - drag_->before));
    moveHooks(scene);
}

void RetractTool::moveHooks(EditorScene& scene) const {
    const Vec3 half = 0.5 * drag_->by * drag_->across;
    scene.hands().dragTo(drag_->from[0] - half, drag_->hooks[0]);
    scene.hands().dragTo(drag_->from[1] + half, drag_->hooks[1]);
    scene.hands().settle();
}

void RetractTool::release(EditorScene& scene) {
    if (drag_) {
        drag_.reset();
        scene.hands().letGo();
    }
}

void RetractTool::cancel(EditorScene& scene) {
    if (!drag_) {
        return;
    }
    if (drag_->isNew) {
        scene.hands().removeRetractor(drag_->hooks[0]);
    } else {
        drag_->by = 0;
        moveHooks(scene);
    }
    release(scene);
}

std::optional<int> RetractTool::hookAt(const ViewFrame& view, const Vec2& pixel,
                                       const EditorScene& scene) {
    std::optional<int> nearest;
    double least = kHandleReach;
    for (const Hands::Hand& hook : scene.hands().hooks()) {
        const auto at = view.toPixel(hook.to);
        const double away = at ? (Vec2(at->x, at->y) - pixel).norm() : least;
        if (away < least) {
            least = away;
            nearest = hook.number;
        }
    }
    return nearest;
}

void RetractTool::addTo(ui::Overlay& overlay, const ViewFrame& view, const Vec2& pixel,
                        EditorScene& scene) const {
    const std::optional<int> hot = drag_ ? drag_->hooks[0] : hookAt(view, pixel, scene);
    const std::vector<Hands::Hand> hooks = scene.hands().hooks();
    for (const Hands::Hand& hook : hooks) {
        const auto other = std::ranges::find(hooks, partnerOf(hook.number), &Hands::Hand::number);
        if (other != hooks.end() && hook.number < other->number) {
            view.addLine(hook.to, other->to, overlay.swept);
        }
        if (const auto at = view.toPixel(hook.to)) {
            const bool isHot = hot == hook.number || hot == partnerOf(hook.number);
            overlay.handles.push_back({*at, isHot});
            if (drag_ && hot == hook.number) {
                overlay.labels.push_back({*at, lengthText(drag_->before + drag_->by)});
            }
        }
    }
    if (!hot) {
        addLips(overlay, view, pixel, scene);
    }
}

/// Where that needs no look at a body that moves, or a large one.
void RetractTool::addLips(ui::Overlay& overlay, const ViewFrame& view, const Vec2& pixel,
                          EditorScene& scene) const {
    const bool costly =
        scene.running() || scene.simulation().report().triangles > kMostPreviewTriangles;
    const auto point = costly ? std::nullopt : scene.pick(view.rayThrough(pixel));
    if (!point) {
        return;
    }
    if (const std::optional<Incision> incision = incisionAt(point->position, scene)) {
        for (const Vec3& lip : incision->lips) {
            if (const auto at = view.toPixel(lip)) {
                overlay.dots.push_back(*at);
            }
        }
    }
}

}  // namespace kerf::app
