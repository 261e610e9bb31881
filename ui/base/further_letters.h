#pragma once

#include <imgui.h>

#include <set>
#include <string>
#include <string_view>

namespace kerf::ui {

/// Letters that texts need beyond those that are always loaded, as Chinese ones in names of files.
/// They come from Kerf's font, or from fonts of the system, which fontconfig's fc-match finds.
class FurtherLetters {
  public:
    /// Notes the letters of a text in UTF-8 that the current context lacks.
    void note(std::string_view text);
    /// Whether any were noted since the last merge().
    bool wanted() const { return wanted_; }
    /// Adds them to the last font of the atlas, from `first` and fonts of the system.
    void merge(ImFontAtlas& atlas, const std::string& first, float pixels);
    /// Builds the atlas. Logs once that letters have no font. Returns false if a font of the system
    /// can't be read: none is used from then on.
    bool build(ImFontAtlas& atlas);

  private:
    std::set<ImWchar> letters_;
    ImVector<ImWchar> ranges_;  ///< of `letters_`; the atlas refers to it
    std::set<int> blocks_;      ///< of letters for which a font was looked for
    std::set<std::string> fonts_;
    bool wanted_ = false;
    bool told_ = false;
};

}  // namespace kerf::ui
