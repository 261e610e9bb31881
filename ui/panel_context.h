#pragma once

struct ImGuiContext;

namespace kerf::ui {

/// A Dear ImGui context with Kerf's theme and font that draws through OpenGL, without a window.
class PanelContext {
  public:
    /// Needs a current OpenGL 4.5 context; `scale` is the display's (1 = 96 dpi). Throws
    /// std::runtime_error.
    explicit PanelContext(float scale);
    ~PanelContext();
    PanelContext(const PanelContext&) = delete;
    PanelContext& operator=(const PanelContext&) = delete;

    /// Makes it the one that ImGui's functions mean.
    void makeCurrent() const;

  private:
    ImGuiContext* context_ = nullptr;
};

}  // namespace kerf::ui
