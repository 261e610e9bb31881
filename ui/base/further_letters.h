#pragma once

#include <imgui.h>

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace kerf::ui {

/// Letters that texts need beyond those that are always loaded, as Chinese ones in names of files.
/// They come from Kerf's font, or from fonts of the system, which fontconfig's fc-match finds.
class FurtherLetters {
  public:
    /// Notes the letters of a text in UTF-8 that the current context lacks.
    void note(std::string_view text);
    /// Whether any were noted since the last merge().
    bool wanted() const { return wanted_; }
    /// Adds them to the last font of the atlas, from `first` and the fonts found so far.
    void merge(ImFontAtlas& atlas, const std::string& first, float pixels);
    /// Looks for a font with letters that the atlas lacks after that. Returns whether to load all
    /// fonts again. Letters that no font has are logged once.
    bool findMore(ImFontAtlas& atlas);

  private:
    struct FontFile {
        std::string file;
        int index = 0;  ///< of the font in the file
        bool operator==(const FontFile&) const = default;
    };
    static FontFile match(const std::vector<ImWchar>& letters);

    std::set<ImWchar> letters_;
    ImVector<ImWchar> ranges_;  ///< of `letters_`; the atlas refers to it
    std::vector<FontFile> fonts_;
    bool wanted_ = false;
    bool told_ = false;  ///< that letters are missing
};

}  // namespace kerf::ui
