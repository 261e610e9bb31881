#include "ui/base/further_letters.h"

#include <imgui_internal.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>

#include "sim/base/text.h"

namespace kerf::ui {
namespace {

constexpr std::size_t kMost = 8000;        // letters; an atlas has no room for all of Unicode
constexpr std::size_t kMostFonts = 8;      // of the system
constexpr std::size_t kMostAskedFor = 64;  // letters in a question

/// What a command writes, or "".
std::string outputOf(const std::string& command) {
    const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "re"), pclose);
    std::string text;
    std::array<char, 4096> part{};
    while (pipe != nullptr && std::fgets(part.data(), part.size(), pipe.get()) != nullptr) {
        text += part.data();
    }
    return text;
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
        const bool known = code > IM_UNICODE_CODEPOINT_MAX ||
                           code == IM_UNICODE_CODEPOINT_INVALID ||
                           font.FindGlyphNoFallback(letter) != nullptr;
        if (!known && letters_.size() < kMost && letters_.insert(letter).second) {
            wanted_ = true;
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
    for (const FontFile& font : fonts_) {
        config.FontNo = font.index;
        atlas.AddFontFromFileTTF(font.file.c_str(), pixels, &config, ranges_.Data);
    }
}

bool FurtherLetters::findMore(ImFontAtlas& atlas) {
    if (letters_.empty() || told_) {
        return false;
    }
    if (!atlas.Build()) {
        fonts_.pop_back();  // It can't be read.
        told_ = true;
        return true;
    }
    std::vector<ImWchar> missing;
    std::ranges::copy_if(letters_, std::back_inserter(missing), [&](ImWchar letter) {
        return atlas.Fonts[0]->FindGlyphNoFallback(letter) == nullptr;
    });
    if (missing.empty()) {
        return false;
    }
    const FontFile found = match(missing);
    if (!found.file.empty() && fonts_.size() < kMostFonts &&
        std::ranges::find(fonts_, found) == fonts_.end()) {
        fonts_.push_back(found);
        return true;
    }
    told_ = true;
    spdlog::warn(
        "No font has {}, which names here need: install fonts for them, as "
        "fonts-noto-cjk",
        counted(missing.size(), "letter", "letters"));
    return false;
}

/// The font of the system that has most of these letters; none without fontconfig.
FurtherLetters::FontFile FurtherLetters::match(const std::vector<ImWchar>& letters) {
    std::string command = "fc-match -f '%{index} %{file}' ':charset=";
    char code[16];
    for (std::size_t i = 0; i < std::min(letters.size(), kMostAskedFor); ++i) {
        std::snprintf(code, sizeof code, "%x ", static_cast<unsigned>(letters[i]));
        command += code;
    }
    const std::string answer = outputOf(command + "' 2>/dev/null");
    const std::size_t space = answer.find(' ');
    const std::string file = space == std::string::npos ? "" : answer.substr(space + 1);
    const bool scalable = file.ends_with(".ttf") || file.ends_with(".otf") ||
                          file.ends_with(".ttc") || file.ends_with(".otc");
    // The upper half of an index names an instance of a variable font.
    return scalable ? FontFile{file, std::atoi(answer.c_str()) & 0xffff} : FontFile{};
}

}  // namespace kerf::ui
