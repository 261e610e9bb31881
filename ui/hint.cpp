#include "ui/hint.h"

#include <imgui.h>

#include "ui/theme.h"
#include "ui/widgets.h"

namespace kerf::ui {

void drawHint(const PanelModel& model, const Rect& view) {
    if (model.hint.empty() || model.stroking || model.helpOpen) {
        return;
    }
    const float line = ImGui::GetFontSize();
    const float y = model.name.empty() ? view.y + view.height / 2 : view.y + view.height - 2 * line;
    drawBanner("hint", model.hint, view.x + view.width / 2, y, view.width,
               {.accent = palette().blade, .opacity = 1});
}

}  // namespace kerf::ui
