#pragma once

#include "gpu/framebuffer.h"
#include "render/scene/image.h"
#include "ui/base/input.h"
#include "ui/base/settings.h"

namespace kerf::app {

/// The icon of the window, 64 x 64 pixels: a fruit with a bright blade through it, transparent.
/// Throws InputError where it is missing.
render::Image windowIcon();

/// A GLFW window with an OpenGL 4.5 core context, current on its thread, with functions loaded. It
/// only forwards input to a function, and shows finished frames. One at a time.
class Window {
  public:
    /// Takes its former place if that is still on a monitor, otherwise the work area up to 1600 x
    /// 900 at scale 1. Throws gpu::ContextError without a window or OpenGL 4.5.
    explicit Window(const std::string& title, const ui::WindowPlace& former = {});
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    /// Sets the function that gets all input, positions in pixels of the picture.
    void onInput(std::function<void(ui::InputEvent)> receive);
    /// Width of the picture [px]; 0 while the window is hidden.
    int width() const;
    /// Height of the picture [px]; 0 while the window is hidden.
    int height() const;
    /// Scale of the display, 1 = 96 dpi: as the desktop names it, otherwise by scaleOf() the
    /// monitor.
    float scale() const;
    /// The present place, for the next start.
    const ui::WindowPlace& place() const;

    void setTitle(const std::string& title);
    void setCursor(ui::Cursor cursor);
    /// Whether the user requested to close the window.
    bool closing() const;
    /// Whether nobody sees it: it is minimised.
    bool hidden() const;
    /// Cancels that request.
    void stayOpen();
    /// Whether the window was resized or uncovered since the last call (true the first time).
    bool takeDamage();
    /// Forwards the events so far; waits up to `seconds` for one.
    void waitEvents(double seconds);
    /// Shows a picture of the window's size.
    void show(const gpu::Framebuffer& picture);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Runs the editor in a window, until it is closed; returns 0. Problems with `file` are shown
/// there. Throws InputError if it is missing, gpu::ContextError without a window or OpenGL 4.5.
int runEditor(const std::optional<std::filesystem::path>& file);

}  // namespace kerf::app
