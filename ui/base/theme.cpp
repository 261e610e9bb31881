#include "ui/base/theme.h"

#include <spdlog/spdlog.h>

#include <filesystem>

#include "gpu/data_path.h"
#include "ui/base/further_letters.h"

namespace kerf::ui {
namespace {

constexpr const char* kSystemFont = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
constexpr float kFontPixels = 15;
constexpr float kHeadingPixels = 24;

constexpr Palette kDark{
    .hues = {IM_COL32(86, 180, 233, 255), IM_COL32(230, 159, 0, 255), IM_COL32(0, 176, 128, 255),
             IM_COL32(226, 106, 20, 255), IM_COL32(204, 121, 167, 255), IM_COL32(240, 228, 66, 255),
             IM_COL32(64, 224, 208, 255), IM_COL32(176, 182, 192, 255)},
    .text = IM_COL32(228, 231, 236, 255),
    .dimText = IM_COL32(150, 157, 169, 255),
    .grid = IM_COL32(255, 255, 255, 18),
    .frame = IM_COL32(255, 255, 255, 56),
    .plotGround = IM_COL32(30, 34, 43, 255),
    .mark = IM_COL32(190, 196, 208, 130),
    .splitter = IM_COL32(86, 180, 233, 200),
    .primary = IM_COL32(38, 104, 143, 255),
    .primaryText = IM_COL32(255, 255, 255, 255),
    .blade = IM_COL32(64, 224, 190, 255),
};

// The same hues, darker where they would fade on a white ground.
constexpr Palette kLight{
    .hues = {IM_COL32(0, 114, 178, 255), IM_COL32(206, 132, 0, 255), IM_COL32(0, 138, 100, 255),
             IM_COL32(198, 82, 0, 255), IM_COL32(176, 84, 134, 255), IM_COL32(150, 138, 0, 255),
             IM_COL32(0, 140, 150, 255), IM_COL32(96, 100, 108, 255)},
    .text = IM_COL32(26, 29, 35, 255),
    .dimText = IM_COL32(92, 99, 110, 255),
    .grid = IM_COL32(0, 0, 0, 20),
    .frame = IM_COL32(0, 0, 0, 70),
    .plotGround = IM_COL32(255, 255, 255, 255),
    .mark = IM_COL32(60, 66, 78, 140),
    .splitter = IM_COL32(0, 114, 178, 200),
    .primary = IM_COL32(0, 104, 163, 255),
    .primaryText = IM_COL32(255, 255, 255, 255),
    .blade = IM_COL32(0, 150, 125, 255),
};

const Palette* paletteNow = &kDark;

ImVec4 rgb(int red, int green, int blue, float alpha = 1) {
    return {static_cast<float>(red) / 255, static_cast<float>(green) / 255,
            static_cast<float>(blue) / 255, alpha};
}

void applyDarkColors(ImVec4* c) {
    c[ImGuiCol_WindowBg] = rgb(23, 25, 31, 0.94F);
    c[ImGuiCol_PopupBg] = rgb(28, 31, 38, 0.98F);
    c[ImGuiCol_Border] = rgb(255, 255, 255, 0.06F);
    c[ImGuiCol_ModalWindowDimBg] = rgb(0, 0, 0, 0.3F);
    c[ImGuiCol_FrameBg] = rgb(41, 46, 57);
    c[ImGuiCol_FrameBgHovered] = rgb(50, 57, 71);
    c[ImGuiCol_FrameBgActive] = rgb(56, 65, 82);
    c[ImGuiCol_TitleBg] = c[ImGuiCol_TitleBgActive] = rgb(30, 33, 41);
    c[ImGuiCol_CheckMark] = rgb(86, 180, 233);
    c[ImGuiCol_SliderGrab] = rgb(75, 132, 168);
    c[ImGuiCol_SliderGrabActive] = rgb(96, 172, 216);
    c[ImGuiCol_Button] = rgb(50, 59, 72);
    c[ImGuiCol_ButtonHovered] = rgb(63, 77, 96);
    c[ImGuiCol_ButtonActive] = rgb(75, 132, 168);
    c[ImGuiCol_Header] = rgb(40, 46, 58);
    c[ImGuiCol_HeaderHovered] = rgb(50, 59, 74);
    c[ImGuiCol_HeaderActive] = rgb(56, 66, 83);
    c[ImGuiCol_MenuBarBg] = rgb(28, 31, 39);
    c[ImGuiCol_Tab] = c[ImGuiCol_TabUnfocused] = rgb(30, 34, 43);
    c[ImGuiCol_TabHovered] = rgb(63, 77, 96);
    c[ImGuiCol_TabActive] = c[ImGuiCol_TabUnfocusedActive] = rgb(50, 59, 72);
    c[ImGuiCol_PlotHistogram] = rgb(75, 132, 168);
    c[ImGuiCol_Separator] = rgb(255, 255, 255, 0.08F);
    c[ImGuiCol_TableHeaderBg] = rgb(36, 40, 49);
    c[ImGuiCol_TableBorderLight] = c[ImGuiCol_TableBorderStrong] = rgb(255, 255, 255, 0.07F);
    c[ImGuiCol_TableRowBgAlt] = rgb(255, 255, 255, 0.025F);
    c[ImGuiCol_ScrollbarGrab] = rgb(60, 67, 80);
}

void applyLightColors(ImVec4* c) {
    c[ImGuiCol_WindowBg] = rgb(245, 246, 248, 0.96F);
    c[ImGuiCol_PopupBg] = rgb(255, 255, 255, 0.98F);
    c[ImGuiCol_Border] = rgb(0, 0, 0, 0.12F);
    c[ImGuiCol_ModalWindowDimBg] = rgb(0, 0, 0, 0.1F);
    c[ImGuiCol_FrameBg] = rgb(224, 227, 232);
    c[ImGuiCol_FrameBgHovered] = rgb(212, 218, 226);
    c[ImGuiCol_FrameBgActive] = rgb(200, 209, 220);
    c[ImGuiCol_TitleBg] = c[ImGuiCol_TitleBgActive] = rgb(230, 233, 238);
    c[ImGuiCol_CheckMark] = rgb(0, 104, 163);
    c[ImGuiCol_SliderGrab] = rgb(110, 160, 196);
    c[ImGuiCol_SliderGrabActive] = rgb(0, 114, 178);
    c[ImGuiCol_Button] = rgb(214, 219, 226);
    c[ImGuiCol_ButtonHovered] = rgb(198, 208, 220);
    c[ImGuiCol_ButtonActive] = rgb(160, 190, 214);
    c[ImGuiCol_Header] = rgb(222, 226, 232);
    c[ImGuiCol_HeaderHovered] = rgb(208, 216, 226);
    c[ImGuiCol_HeaderActive] = rgb(196, 208, 221);
    c[ImGuiCol_MenuBarBg] = rgb(233, 235, 239);
    c[ImGuiCol_Tab] = c[ImGuiCol_TabUnfocused] = rgb(229, 232, 237);
    c[ImGuiCol_TabHovered] = rgb(198, 208, 220);
    c[ImGuiCol_TabActive] = c[ImGuiCol_TabUnfocusedActive] = rgb(208, 215, 224);
    c[ImGuiCol_PlotHistogram] = rgb(110, 160, 196);
    c[ImGuiCol_Separator] = rgb(0, 0, 0, 0.12F);
    c[ImGuiCol_TableHeaderBg] = rgb(228, 231, 236);
    c[ImGuiCol_TableBorderLight] = c[ImGuiCol_TableBorderStrong] = rgb(0, 0, 0, 0.10F);
    c[ImGuiCol_TableRowBgAlt] = rgb(0, 0, 0, 0.03F);
    c[ImGuiCol_ScrollbarGrab] = rgb(186, 192, 201);
}

void applyColors(Theme theme, ImGuiStyle& style) {
    ImVec4* c = style.Colors;
    if (theme == Theme::light) {
        ImGui::StyleColorsLight(&style);
        applyLightColors(c);
    } else {
        ImGui::StyleColorsDark(&style);
        applyDarkColors(c);
    }
    c[ImGuiCol_Text] = ImGui::ColorConvertU32ToFloat4(palette().text);
    c[ImGuiCol_TextDisabled] = ImGui::ColorConvertU32ToFloat4(palette().dimText);
    c[ImGuiCol_ChildBg] = c[ImGuiCol_TableRowBg] = c[ImGuiCol_ScrollbarBg] = rgb(0, 0, 0, 0);
}

void applySizes(ImGuiStyle& style) {
    style.WindowRounding = 6;
    style.FrameRounding = 4;
    style.GrabRounding = 4;
    style.PopupRounding = 5;
    style.ScrollbarRounding = 4;
    style.ScrollbarSize = 10;
    style.WindowBorderSize = 1;
    style.PopupBorderSize = 1;
    style.WindowPadding = {12, 10};
    style.FramePadding = {8, 4};
    style.ItemSpacing = {8, 6};
    style.ItemInnerSpacing = {7, 4};
    style.CellPadding = {6, 3};
    style.GrabMinSize = 11;
    style.WindowTitleAlign = {0, 0.5F};
}

/// The font that the archive of any Linux brings along, else the system's.
std::filesystem::path fontFile() {
    const std::filesystem::path own = gpu::dataPath("assets/fonts/DejaVuSans.ttf");
    return std::filesystem::exists(own) ? own : kSystemFont;
}

}  // namespace

const Palette& palette() {
    return *paletteNow;
}

ImU32 pieceColor(int index) {
    return kDark.hues[static_cast<std::size_t>(index) % kHues];
}

void usePalette(Theme theme) {
    paletteNow = theme == Theme::light ? &kLight : &kDark;
}

void applyTheme(Theme theme, float scale) {
    usePalette(theme);
    ImGuiStyle& style = ImGui::GetStyle();
    style = ImGuiStyle{};
    applyColors(theme, style);
    applySizes(style);
    // Empty boxes are too pale to be seen on a light ground without a line around them.
    style.FrameBorderSize = theme == Theme::light ? 1 : 0;
    style.ScaleAllSizes(scale);
}

void loadFont(float scale, FurtherLetters& letters) {
    // Latin, Greek (for micro), general punctuation, arrows and geometric shapes.
    static constexpr ImWchar kRanges[] = {0x0020, 0x00FF, 0x0391, 0x03C9, 0x2010,
                                          0x2044, 0x2190, 0x21FF, 0x2212, 0x2212,
                                          0x2248, 0x2265, 0x25A0, 0x25FF, 0};
    static constexpr ImWchar kHeadingRanges[] = {0x0020, 0x007E, 0};
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    atlas.Clear();
    const std::filesystem::path font = fontFile();
    if (std::filesystem::exists(font)) {
        ImFontConfig config;
        config.OversampleH = 2;
        atlas.AddFontFromFileTTF(font.c_str(), kFontPixels * scale, &config, kRanges);
        letters.merge(atlas, font, kFontPixels * scale);
        atlas.AddFontFromFileTTF(font.c_str(), kHeadingPixels * scale, nullptr, kHeadingRanges);
        return;
    }
    spdlog::warn("{} is missing: install fonts-dejavu-core for a legible interface", kSystemFont);
    ImFontConfig config;
    config.SizePixels = 13 * scale;
    atlas.AddFontDefault(&config);
}

ImFont* headingFont() {
    return ImGui::GetIO().Fonts->Fonts.back();
}

}  // namespace kerf::ui
