#include "ui/base/caption.h"

#include <imgui.h>

#include <cmath>

namespace kerf::ui {

render::Image drawCaption(PicturePainter& painter, const std::string& text) {
    painter.makeCurrent();
    const ImVec2 padding = ImGui::GetStyle().WindowPadding;
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    return painter.draw(static_cast<int>(std::ceil(size.x + 2 * padding.x)),
                        static_cast<int>(std::ceil(size.y + 2 * padding.y)),
                        [&] { ImGui::TextUnformatted(text.c_str()); });
}

}  // namespace kerf::ui
