#include "app/tools/retract_tool.h"

#include "app/scene/document/rest_of_body.h"
#include "app/scene/editor_scene.h"
#include "app/scene/held_hands.h"
#include "app/scene/readout/cut_preview.h"
#include "app/tools/tool_marks.h"
#include "sim/base/text.h"
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

std::string RetractTool::press(const ToolContext& c) {
    if (const std::optional<int> hook = hookAt(c)) {
        takeAgain(*hook, *c.scene);
        return "";
    }
    return hookLips(c);
}

std::string RetractTool::hookLips(const ToolContext& c) {
    const auto point = c.scene->pick(c.view.rayThrough(c.pixel));
    if (!point) {
        return std::string(kBesideModel);
    }
    const std::optional<Incision> incision = incisionAt(point->position, *c.scene);
    if (!incision) {
        return "There is no cut nearby. Press on the skin beside a cut.";
    }
    const std::variant<int, std::string> hooked = c.scene->hands().hook(*incision);
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
void RetractTool::move(const ToolContext& c) {
    if (!drag_) {
        return;
    }
    const Vec3 way = c.view.onPlaneThrough(drag_->at, c.pixel) - drag_->at;
    const double wanted = drag_->isNew ? way.norm() : -2 * way.dot(drag_->across);
    const double widest = kWidest * c.scene->rest().bounds().diagonal();
    drag_->by = std::clamp(wanted, -drag_->before, std::max(0.0, widest - drag_->before));
    moveHooks(*c.scene);
}

void RetractTool::moveHooks(EditorScene& scene) const {
    const Vec3 half = 0.5 * drag_->by * drag_->across;
    scene.hands().dragTo(drag_->from[0] - half, drag_->hooks[0]);
    scene.hands().dragTo(drag_->from[1] + half, drag_->hooks[1]);
    scene.hands().settle();
}

std::string RetractTool::release(const ToolContext& c) {
    if (drag_) {
        drag_.reset();
        c.scene->hands().letGo();
    }
    return "";
}

void RetractTool::cancel(const ToolContext& c) {
    if (!drag_) {
        return;
    }
    if (drag_->isNew) {
        c.scene->hands().dropRetractor(drag_->hooks[0]);
    } else {
        drag_->by = 0;
        moveHooks(*c.scene);
    }
    release(c);
}

void RetractTool::rightClick(const ToolContext& c) {
    if (const std::optional<int> hook = hookAt(c)) {
        c.scene->hands().removeRetractor(*hook);
    }
}

void RetractTool::removeOne(const ToolContext& c) {
    release(c);
    const std::vector<Hands::Hand> hooks = c.scene->hands().hooks();
    if (!hooks.empty()) {
        c.scene->hands().removeRetractor(hookAt(c).value_or(hooks.back().number));
    }
}

std::optional<int> RetractTool::hookAt(const ToolContext& c) {
    const std::vector<Hands::Hand> hooks = c.scene->hands().hooks();
    std::vector<Vec3> points;
    std::ranges::transform(hooks, std::back_inserter(points), &Hands::Hand::to);
    const std::optional<int> at = handleAt(c.view, c.pixel, points);
    return at ? std::optional(hooks[*at].number) : std::nullopt;
}

void RetractTool::addTo(ui::Overlay& overlay, const ToolContext& c) const {
    const std::optional<int> hot = drag_ ? drag_->hooks[0] : hookAt(c);
    const std::vector<Hands::Hand> hooks = c.scene->hands().hooks();
    for (const Hands::Hand& hook : hooks) {
        const auto other = std::ranges::find(hooks, partnerOf(hook.number), &Hands::Hand::number);
        if (other != hooks.end() && hook.number < other->number) {
            c.view.addLine(hook.to, other->to, overlay.swept);
        }
        if (const auto at = c.view.toPixel(hook.to)) {
            const bool isHot = hot == hook.number || hot == partnerOf(hook.number);
            overlay.handles.push_back({*at, isHot});
            if (drag_ && hot == hook.number) {
                overlay.labels.push_back({*at, lengthText(drag_->before + drag_->by)});
            }
        }
    }
    if (!hot) {
        addLips(overlay, c);
    }
}

/// Where that needs no look at a body that moves, or a large one.
void RetractTool::addLips(ui::Overlay& overlay, const ToolContext& c) {
    const auto point =
        isCostlyToFollow(*c.scene) ? std::nullopt : c.scene->pick(c.view.rayThrough(c.pixel));
    if (!point) {
        return;
    }
    if (const std::optional<Incision> incision = incisionAt(point->position, *c.scene)) {
        for (const Vec3& lip : incision->lips) {
            if (const auto at = c.view.toPixel(lip)) {
                overlay.dots.push_back(*at);
            }
        }
    }
}

/// Dots show the lips that it would hook.
ui::Cursor RetractTool::cursor(const ui::Overlay& overlay) const {
    return isOnHandle(overlay) || !overlay.dots.empty() ? ui::Cursor::hand : ui::Cursor::arrow;
}

std::unique_ptr<Tool> makeRetractTool() {
    return std::make_unique<RetractTool>();
}

}  // namespace kerf::app
