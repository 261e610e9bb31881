#pragma once

#include <glad/gl.h>
#include <imgui.h>

#include <bit>

#include "gpu/framebuffer.h"
#include "render/scene/image.h"
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

/// Draws the content of a panel into pictures without a window, for reports and exports.
class PicturePainter {
  public:
    /// Needs a current OpenGL 4.5 context; text is 15 px high times `scale`.
    explicit PicturePainter(Theme theme = Theme::dark, float scale = 1);

    /// A picture of `width` x `height` pixels. `content` adds items to a panel that fills it; it is
    /// called twice.
    render::Image draw(int width, int height, const std::function<void()>& content);
    /// Makes the fonts and colours of this painter current, to measure text before drawing.
    void makeCurrent() const { context_.makeCurrent(); }

  private:
    PanelContext context_;
};

/// A texture with a picture, for Dear ImGui. Needs a current OpenGL 4.5 context.
inline gpu::Texture textureOf(const render::Image& image) {
    gpu::Texture texture(GL_RGBA8, image.width, image.height);
    glTextureSubImage2D(texture.id(), 0, 0, 0, image.width, image.height, GL_RGBA, GL_UNSIGNED_BYTE,
                        image.pixels.data());
    return texture;
}

inline ImTextureID idOf(const gpu::Texture& texture) {
    return std::bit_cast<ImTextureID>(static_cast<std::uintptr_t>(texture.id()));
}

/// A line of text on a panel's ground, as large as it needs, to be pasted onto a picture.
render::Image drawCaption(PicturePainter& painter, const std::string& text);

}  // namespace kerf::ui
