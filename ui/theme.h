#pragma once

#include <imgui.h>

namespace kerf::ui {

/// Colours of the interface. Data lines use the Okabe-Ito palette, which stays apart for every
/// kind of colour vision.
struct Theme {
    static constexpr ImU32 kBlue = IM_COL32(86, 180, 233, 255);
    static constexpr ImU32 kGreen = IM_COL32(0, 158, 115, 255);
    static constexpr ImU32 kOrange = IM_COL32(230, 159, 0, 255);
    static constexpr ImU32 kVermillion = IM_COL32(213, 94, 0, 255);
    static constexpr ImU32 kText = IM_COL32(228, 231, 236, 255);
    static constexpr ImU32 kDimText = IM_COL32(143, 150, 162, 255);
    static constexpr ImU32 kGrid = IM_COL32(255, 255, 255, 18);
    static constexpr ImU32 kFrame = IM_COL32(255, 255, 255, 56);
    static constexpr ImU32 kPlotGround = IM_COL32(30, 34, 43, 255);
    static constexpr ImU32 kMark = IM_COL32(190, 196, 208, 120);
    static constexpr ImU32 kBlade = IM_COL32(64, 224, 190, 255);
};

/// Sets style and colours of the current ImGui context; `scale` is the display's (1 = 96 dpi).
void applyTheme(float scale);

/// Loads DejaVu Sans (Debian package fonts-dejavu-core) at 15 px times `scale`, or ImGui's own
/// bitmap font where it is missing, which is said in the log.
void loadFont(float scale);

}  // namespace kerf::ui
