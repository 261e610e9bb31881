#include "ui/base/theme.h"

#include <imgui_internal.h>
#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>

#include <cstdio>

#include "gpu/data_path.h"

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

/// Of 255 each, and the opacity.
struct Rgb {
    int red;
    int green;
    int blue;
    float alpha = 1;
};

/// A colour of Dear ImGui in both themes.
struct StyleColor {
    ImGuiCol of;
    Rgb dark;
    Rgb light;
};
constexpr std::array kStyleColors{
    StyleColor{ImGuiCol_WindowBg, {23, 25, 31, 0.94F}, {245, 246, 248, 0.96F}},
    StyleColor{ImGuiCol_PopupBg, {28, 31, 38, 0.98F}, {255, 255, 255, 0.98F}},
    StyleColor{ImGuiCol_Border, {255, 255, 255, 0.14F}, {0, 0, 0, 0.12F}},
    StyleColor{ImGuiCol_ModalWindowDimBg, {0, 0, 0, 0.3F}, {0, 0, 0, 0.1F}},
    StyleColor{ImGuiCol_FrameBg, {41, 46, 57}, {224, 227, 232}},
    StyleColor{ImGuiCol_FrameBgHovered, {50, 57, 71}, {212, 218, 226}},
    StyleColor{ImGuiCol_FrameBgActive, {56, 65, 82}, {200, 209, 220}},
    StyleColor{ImGuiCol_TitleBg, {30, 33, 41}, {230, 233, 238}},
    StyleColor{ImGuiCol_TitleBgActive, {30, 33, 41}, {230, 233, 238}},
    StyleColor{ImGuiCol_CheckMark, {86, 180, 233}, {0, 104, 163}},
    StyleColor{ImGuiCol_SliderGrab, {75, 132, 168}, {110, 160, 196}},
    StyleColor{ImGuiCol_SliderGrabActive, {96, 172, 216}, {0, 114, 178}},
    StyleColor{ImGuiCol_Button, {50, 59, 72}, {214, 219, 226}},
    StyleColor{ImGuiCol_ButtonHovered, {63, 77, 96}, {198, 208, 220}},
    StyleColor{ImGuiCol_ButtonActive, {75, 132, 168}, {160, 190, 214}},
    StyleColor{ImGuiCol_Header, {40, 46, 58}, {222, 226, 232}},
    StyleColor{ImGuiCol_HeaderHovered, {50, 59, 74}, {208, 216, 226}},
    StyleColor{ImGuiCol_HeaderActive, {56, 66, 83}, {196, 208, 221}},
    StyleColor{ImGuiCol_MenuBarBg, {28, 31, 39}, {233, 235, 239}},
    StyleColor{ImGuiCol_Tab, {30, 34, 43}, {229, 232, 237}},
    StyleColor{ImGuiCol_TabUnfocused, {30, 34, 43}, {229, 232, 237}},
    StyleColor{ImGuiCol_TabHovered, {63, 77, 96}, {198, 208, 220}},
    StyleColor{ImGuiCol_TabActive, {50, 59, 72}, {208, 215, 224}},
    StyleColor{ImGuiCol_TabUnfocusedActive, {50, 59, 72}, {208, 215, 224}},
    StyleColor{ImGuiCol_PlotHistogram, {75, 132, 168}, {110, 160, 196}},
    StyleColor{ImGuiCol_Separator, {255, 255, 255, 0.08F}, {0, 0, 0, 0.12F}},
    StyleColor{ImGuiCol_TableHeaderBg, {36, 40, 49}, {228, 231, 236}},
    StyleColor{ImGuiCol_TableBorderLight, {255, 255, 255, 0.07F}, {0, 0, 0, 0.10F}},
    StyleColor{ImGuiCol_TableBorderStrong, {255, 255, 255, 0.07F}, {0, 0, 0, 0.10F}},
    StyleColor{ImGuiCol_TableRowBgAlt, {255, 255, 255, 0.025F}, {0, 0, 0, 0.03F}},
    StyleColor{ImGuiCol_ScrollbarGrab, {60, 67, 80}, {186, 192, 201}},
};

void applyColors(Theme theme, ImGuiStyle& style) {
    const bool light = theme == Theme::light;
    light ? ImGui::StyleColorsLight(&style) : ImGui::StyleColorsDark(&style);
    ImVec4* const c = style.Colors;
    for (const StyleColor& color : kStyleColors) {
        const Rgb& rgb = light ? color.light : color.dark;
        c[color.of] = ImColor(rgb.red, rgb.green, rgb.blue);
        c[color.of].w = rgb.alpha;
    }
    c[ImGuiCol_Text] = ImGui::ColorConvertU32ToFloat4(palette().text);
    c[ImGuiCol_TextDisabled] = ImGui::ColorConvertU32ToFloat4(palette().dimText);
    c[ImGuiCol_ChildBg] = c[ImGuiCol_TableRowBg] = c[ImGuiCol_ScrollbarBg] = {0, 0, 0, 0};
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

constexpr std::size_t kMost = 8000;  // letters; an atlas has no room for all of Unicode
constexpr int kBlockBits = 12;       // Letters so near to each other share a font.

/// The file of the system's font for a letter and those beside it; "" without fontconfig.
std::string fontWith(ImWchar letter) {
    const std::string command =
        fmt::format("fc-match -f '%{{file}}' ':charset={:x}' 2>/dev/null", unsigned{letter});
    const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "re"), pclose);
    std::array<char, 4096> file{};
    const bool found = pipe && std::fgets(file.data(), file.size(), pipe.get()) != nullptr;
    const std::string name = found ? file.data() : "";
    const bool scalable =
        name.ends_with(".ttf") || name.ends_with(".otf") || name.ends_with(".ttc");
    return scalable ? name : "";
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

void FurtherLetters::note(std::string_view text) {
    const ImFont& font = *ImGui::GetIO().Fonts->Fonts[0];
    const char* at = text.data();
    const char* const end = at + text.size();
    while ((at = std::find_if(at, end, [](char c) { return (c & 0x80) != 0; })) != end) {
        unsigned code = 0;
        at += std::max(1, ImTextCharFromUtf8(&code, at, end));
        const auto letter = static_cast<ImWchar>(code);
        if (code < IM_UNICODE_CODEPOINT_INVALID && letters_.size() < kMost &&
            font.FindGlyphNoFallback(letter) == nullptr) {
            wanted_ |= letters_.insert(letter).second;
        }
    }
}

void FurtherLetters::merge(ImFontAtlas& atlas, const std::string& first, float pixels) {
    wanted_ = false;
    if (letters_.empty()) {
        return;
    }
    ImFontGlyphRangesBuilder builder;
    std::ranges::for_each(letters_, [&](ImWchar letter) { builder.AddChar(letter); });
    ranges_.clear();
    builder.BuildRanges(&ranges_);
    ImFontConfig config;
    config.MergeMode = true;
    atlas.AddFontFromFileTTF(first.c_str(), pixels, &config, ranges_.Data);
    for (const ImWchar letter : letters_) {
        if (blocks_.insert(letter >> kBlockBits).second) {
            fonts_.insert(fontWith(letter));
        }
    }
    fonts_.erase("");
    for (const std::string& font : fonts_) {
        atlas.AddFontFromFileTTF(font.c_str(), pixels, &config, ranges_.Data);
    }
}

bool FurtherLetters::build(ImFontAtlas& atlas) {
    if (letters_.empty()) {
        return true;  // It is built when it is needed.
    }
    if (!atlas.Build()) {
        fonts_.clear();
        return false;
    }
    const bool missing = std::ranges::any_of(letters_, [&](ImWchar letter) {
        return atlas.Fonts[0]->FindGlyphNoFallback(letter) == nullptr;
    });
    if (missing && !std::exchange(told_, true)) {
        spdlog::warn("No font has some letters of names: install one, such as fonts-noto-cjk.");
    }
    return true;
}

}  // namespace kerf::ui
