#include "ui/hint.h"

#include <imgui.h>

#include "ui/offer.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace kerf::ui {

void drawHint(const PanelModel& model, const Rect& view, std::vector<Action>& actions) {
    const Hint& hint = model.hint;
    if (hint.text.empty() || model.stroking || model.helpOpen) {
        return;
    }
    const float line = ImGui::GetFontSize();
    const float y = model.name.empty() ? view.y + view.height / 2 : view.y + view.height - 2 * line;
    if (!hint.choices.empty()) {
        drawOffer("hint", hint, view, y + line / 2,
                  {.accent = palette().blade, .opacity = 1, .takesInput = true}, actions);
        return;
    }
    drawBanner("hint", hint.text, view.x + view.width / 2, y, view.width,
               {.accent = palette().blade, .opacity = 1});
}

}  // namespace kerf::ui
