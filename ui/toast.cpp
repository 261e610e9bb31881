#include <imgui.h>

#include "ui/base/theme.h"
#include "ui/over_view.h"

namespace kerf::ui {

void drawToast(const ToastState& toast, const Rect& view, std::vector<Action>& actions) {
    if (toast.text.empty()) {
        return;
    }
    const float line = ImGui::GetFontSize();
    BannerStyle style{.accent = palette().of(toast.isError ? Hue::vermillion : Hue::blue),
                      .opacity = toast.opacity};
    if (toast.choice) {
        style.takesInput = true;
        drawOffer("toast", {toast.text, {*toast.choice}}, view, view.y + 5 * line, style, actions);
    } else {
        drawBanner("toast", toast.text, view.x + view.width / 2, view.y + 2.5F * line, view.width,
                   style);
    }
}

}  // namespace kerf::ui
