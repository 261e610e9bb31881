#pragma once

#include <string_view>

#include "ui/base/further_letters.h"
#include "ui/base/theme.h"

struct ImGuiContext;

namespace kerf::ui {

/// A Dear ImGui context with Kerf's theme and font that draws through OpenGL, without a window.
class PanelContext {
  public:
    /// Needs a current OpenGL 4.5 context; `scale` is the display's (1 = 96 dpi). Throws
    /// std::runtime_error.
    PanelContext(Theme theme, float scale);
    ~PanelContext();
    PanelContext(const PanelContext&) = delete;
    PanelContext& operator=(const PanelContext&) = delete;

    /// Makes this context current for ImGui's functions and palette().
    void makeCurrent() const;
    /// Changes theme and scale from the next update on, at no cost if nothing changes.
    void restyle(Theme theme, float scale);
    float scale() const { return scale_; }
    /// Notes the letters of a text that is to be drawn.
    void note(std::string_view text) { letters_.note(text); }
    /// Loads noted letters that the font lacks; call it before a frame begins.
    void loadNoted();

  private:
    void reloadFont();

    FurtherLetters letters_;
    ImGuiContext* context_ = nullptr;
    Theme theme_ = Theme::dark;
    float scale_ = 1;
};

}  // namespace kerf::ui
