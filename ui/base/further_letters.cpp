#include "ui/base/further_letters.h"

#include <imgui_internal.h>
#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <utility>

namespace kerf::ui {
namespace {

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
