#include "ui/toast.h"

#include <imgui.h>

#include "ui/offer.h"
#include "ui/theme.h"

namespace kerf::ui {

void drawToast(const PanelModel& model, const Rect& view, std::vector<Action>& actions) {
    if (model.toast.text.empty()) {
        return;
    }
    const float line = ImGui::GetFontSize();
    BannerStyle style{.accent = palette().of(model.toast.isError ? Hue::vermillion : Hue::blue),
                      .opacity = model.toast.opacity};
    if (model.toast.choice) {
        style.takesInput = true;
        drawOffer("toast", {model.toast.text, {*model.toast.choice}}, view, view.y + 5 * line, style,
                  actions);
    } else {
        drawBanner("toast", model.toast.text, view.x + view.width / 2, view.y + 2.5F * line, view.width,
                   style);
    }
}

}  // namespace kerf::ui
