#include "ui/theme.h"

#include <spdlog/spdlog.h>

#include <filesystem>

namespace kerf::ui {
namespace {

constexpr const char* kFontFile = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
constexpr float kFontPixels = 15;

ImVec4 rgb(int red, int green, int blue, float alpha = 1) {
    return {static_cast<float>(red) / 255, static_cast<float>(green) / 255,
            static_cast<float>(blue) / 255, alpha};
}

void applyColors(ImGuiStyle& style) {
    ImVec4* c = style.Colors;
    c[ImGuiCol_Text] = ImGui::ColorConvertU32ToFloat4(Theme::kText);
    c[ImGuiCol_TextDisabled] = ImGui::ColorConvertU32ToFloat4(Theme::kDimText);
    c[ImGuiCol_WindowBg] = rgb(23, 25, 31, 0.93F);
    c[ImGuiCol_ChildBg] = rgb(0, 0, 0, 0);
    c[ImGuiCol_PopupBg] = rgb(28, 31, 38, 0.98F);
    c[ImGuiCol_Border] = rgb(255, 255, 255, 0.06F);
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
    c[ImGuiCol_Header] = rgb(42, 49, 61);
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
    c[ImGuiCol_TableRowBg] = rgb(0, 0, 0, 0);
    c[ImGuiCol_TableRowBgAlt] = rgb(255, 255, 255, 0.025F);
    c[ImGuiCol_ScrollbarBg] = rgb(0, 0, 0, 0);
    c[ImGuiCol_ScrollbarGrab] = rgb(60, 67, 80);
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
    style.FrameBorderSize = 0;
    style.WindowPadding = {12, 10};
    style.FramePadding = {8, 4};
    style.ItemSpacing = {8, 7};
    style.ItemInnerSpacing = {7, 4};
    style.CellPadding = {6, 3};
    style.GrabMinSize = 11;
    style.WindowTitleAlign = {0, 0.5F};
}

}  // namespace

void applyTheme(float scale) {
    ImGuiStyle& style = ImGui::GetStyle();
    style = ImGuiStyle{};
    ImGui::StyleColorsDark(&style);
    applyColors(style);
    applySizes(style);
    style.ScaleAllSizes(scale);
}

void loadFont(float scale) {
    // Latin, Greek (for micro), general punctuation, arrows and geometric shapes.
    static constexpr ImWchar kRanges[] = {0x0020, 0x00FF, 0x0391, 0x03C9, 0x2010,
                                          0x2044, 0x2190, 0x21FF, 0x2212, 0x2212,
                                          0x2248, 0x2265, 0x25A0, 0x25FF, 0};
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    if (std::filesystem::exists(kFontFile)) {
        ImFontConfig config;
        config.OversampleH = 2;
        atlas.AddFontFromFileTTF(kFontFile, kFontPixels * scale, &config, kRanges);
        return;
    }
    spdlog::warn("{} is missing: install fonts-dejavu-core for a legible interface", kFontFile);
    ImFontConfig config;
    config.SizePixels = 13 * scale;
    atlas.AddFontDefault(&config);
}

}  // namespace kerf::ui
