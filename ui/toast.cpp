#include "ui/toast.h"

#include <imgui.h>

#include "ui/theme.h"
#include "ui/widgets.h"

namespace kerf::ui {

void drawToast(const PanelModel& model, const Rect& view) {
    if (model.toast.empty()) {
        return;
    }
    const float line = ImGui::GetFontSize();
    drawBanner("toast", model.toast, view.x + view.width / 2, view.y + 2.5F * line, view.width,
               {.accent = palette().of(model.toastIsError ? Hue::vermillion : Hue::blue),
                .opacity = model.toastOpacity});
}

}  // namespace kerf::ui
