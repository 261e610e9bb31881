#include <imgui.h>

#include "ui/base/theme.h"
#include "ui/over_view.h"
#include "ui/state/action_table.h"

namespace kerf::ui {

void drawHint(const PanelModel& model, const Rect& view, std::vector<Action>& actions) {
    const Hint& hint = model.help.hint;
    if (hint.text.empty() || model.transport.stroking || model.help.open) {
        return;
    }
    const float line = ImGui::GetFontSize();
    const float y = view.y + view.height - 2 * line;
    if (!hint.choices.empty()) {
        drawOffer("hint", hint, view, y + line / 2,
                  {.accent = palette().blade, .opacity = 1, .takesInput = true}, actions);
        return;
    }
    drawBanner("hint", hint.text, view.x + view.width / 2, y, view.width,
               {.accent = palette().blade, .opacity = 1});
}

void drawPanelsHint(const Settings& settings, const Rect& view, std::vector<Action>& actions) {
    if (settings.showsPanels()) {
        return;
    }
    const std::string label = "Show panels   " + std::string(keyOf(ActionId::togglePanels));
    const Rect place{view.x + bannerPadding(), view.y + bannerPadding(), buttonWidth(label),
                     ImGui::GetFrameHeight()};
    beginBanner("panels", place, {.opacity = 1, .takesInput = true});
    if (button(label.c_str(), "panels.show", "Show the menu and the panels")) {
        actions.emplace_back(ActionId::togglePanels);
    }
    endBanner();
}

}  // namespace kerf::ui
