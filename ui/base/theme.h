#pragma once

#include <imgui.h>

namespace kerf::ui {

/// The two looks of the window.
enum class Theme { dark, light };

/// Hues of data, by their index in Palette::hues: the Okabe-Ito palette, which is safe for every
/// kind of colour vision. Nothing depends on hue alone.
enum class Hue { blue, orange, green, vermillion, purple, yellow, cyan, gray };
inline constexpr int kHues = 8;

/// Colours of a theme without an entry in ImGui's style.
struct Palette {
    std::array<ImU32, kHues> hues{};  ///< of curves and marks
    ImU32 text = 0;
    ImU32 dimText = 0;
    ImU32 grid = 0;
    ImU32 frame = 0;  ///< around plots
    ImU32 plotGround = 0;
    ImU32 mark = 0;         ///< lines of events and references
    ImU32 splitter = 0;     ///< under the pointer
    ImU32 primary = 0;      ///< background of the default button
    ImU32 primaryText = 0;  ///< on it
    ImU32 blade = 0;

    ImU32 of(Hue hue) const { return hues[static_cast<std::size_t>(hue)]; }
};

/// The palette of the panel context that is current.
const Palette& palette();

/// The colour of a piece in curves, in its chip and in the view; the same in both themes. `index`
/// is that in the list of pieces.
ImU32 pieceColor(int index);

/// Sets style and colours of the current ImGui context; `scale` is the display's (1 = 96 dpi).
void applyTheme(Theme theme, float scale);
/// Makes palette() return the colours of a theme.
void usePalette(Theme theme);

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

/// Loads DejaVu Sans (that of the archive, or of Debian's fonts-dejavu-core) at 15 px times
/// `scale`, or ImGui's bitmap font if it is missing, which is logged; and further letters.
void loadFont(float scale, FurtherLetters& letters);
/// The larger font of headings, of basic Latin letters.
ImFont* headingFont();

}  // namespace kerf::ui
