#include "app/tools/tool_box.h"

#include "app/scene/editor_stroke.h"
#include "app/tools/tool_marks.h"

namespace kerf::app {
namespace {

constexpr double kLongest = 2;  // end of all sliders, of the body's diagonal

}  // namespace

ToolBox::ToolBox() {
    std::ranges::transform(kToolMakers, tools_.begin(), [](const auto& row) { return row.make(); });
}

void ToolBox::begin(const Bounds& bounds) {
    tools_ = std::move(ToolBox().tools_);
    fitTo(bounds);
}

void ToolBox::fitTo(const Bounds& bounds) {
    settings_.longest = kLongest * bounds.diagonal();
    for (const auto& tool : tools_) {
        tool->fitTo(bounds, settings_);
    }
}

void ToolBox::set(const ui::ToolSettings& wanted, const ToolContext& c) {
    Tool& before = inHand();
    const ui::ToolSettings settingsBefore = settings_;
    settings_ = wanted;
    if (wanted.tool == settingsBefore.tool) {
        before.followSettings(settingsBefore, c);
    } else {
        before.putAway(c);
        c.stroke.cancel();
    }
}

void ToolBox::cancel(const ToolContext& c, bool takesBack) {
    takesBack ? inHand().takeBack(c) : inHand().cancel(c);
    c.stroke.cancel();
}

void ToolBox::addTo(ui::Overlay& overlay, const ToolContext& c) const {
    const bool underWay = c.stroke.drawing() || c.stroke.pending() > 0 || c.scene == nullptr;
    const std::vector<Blade> way = underWay ? c.stroke.wayAhead() : inHand().wayAhead(c);
    if (underWay) {
        addLag(overlay, way, c.view);
    }
    if (!underWay || c.showsAhead) {
        addPreview(overlay, way, c);
    }
    if (c.scene != nullptr) {
        inHand().addTo(overlay, c);
    }
    if (std::string figure = inHand().figure(c.settings); !figure.empty()) {
        overlay.labels.push_back({{c.pixel.x(), c.pixel.y()}, std::move(figure)});
    }
}

}  // namespace kerf::app
