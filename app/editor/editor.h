#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "app/editor/storage/editor_options.h"
#include "app/scene/document/editor_document.h"
#include "gpu/framebuffer.h"
#include "render/scene/image.h"
#include "ui/base/cursor.h"
#include "ui/base/input.h"
#include "ui/base/item_rects.h"
#include "ui/state/panel_model.h"

namespace kerf::app {

class EditorScene;

/// The editor behind a window or without one: events in, pictures out. It needs a current OpenGL
/// 4.5 context with loaded functions. Each frame() takes the input in batches through the panels,
/// drains what they and the keys ask for, steps the simulation and draws.
class Editor {
  public:
    /// Opens `document`, or nothing. Throws gpu::ShaderError, gpu::OutOfMemory.
    Editor(const EditorOptions& options, std::optional<Document> document);
    ~Editor();
    Editor(const Editor&) = delete;
    Editor& operator=(const Editor&) = delete;

    /// Puts input into the queue for the next frame.
    void post(ui::InputEvent event);
    /// Changes the size of the picture [px]; ignored where a side is 0, as of a hidden window.
    void resize(int width, int height);
    /// Changes the scale of the display, as the window moves to another one; 1 = 96 dpi.
    void setScale(float scale);
    /// Makes one picture, `elapsedSeconds` after the one before.
    void frame(double elapsedSeconds);
    /// Goes on with what the scene is doing, where no picture is due before it is done. False where
    /// one is, or nothing is under way.
    bool workOn();
    /// Time for which nothing will change without input [s]; 0 while something moves.
    double idleSeconds() const;

    /// Whether a file is on its way in or out, or a model to another place; what is open goes on
    /// meanwhile.
    bool working() const;
    /// The person wants to leave, as by the window's own button: asks about work that is not saved.
    void askToLeave();
    /// Whether the person asked to leave and nothing is left to be saved.
    bool closing() const;

    /// The scene and the panels, as the window shows them.
    const gpu::Framebuffer& picture() const;
    /// The shape of the pointer as it stands.
    ui::Cursor cursor() const;
    /// A copy of picture() in main memory; draws it first where frames are not drawn.
    render::Image readPicture() const;
    /// The title of the window: "Kerf - NAME - N pieces".
    std::string title() const;
    /// The model that the panels showed in the last frame.
    const ui::PanelModel& panels() const;

    /// The rectangles of the named items of the panels [px].
    const ui::ItemRects& itemRects() const;
    /// The scene that is open, for tests that look into it; null while none is.
    EditorScene* scene();

    /// Begins to open a model or a session, which takes some frames. What cannot be opened is said
    /// in the view and changes nothing.
    void open(const std::filesystem::path& file);

    /// All that an editor holds (app/editor/editor_state.h).
    struct State;

  private:
    std::unique_ptr<State> state_;
};

}  // namespace kerf::app
