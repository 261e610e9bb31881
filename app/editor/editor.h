#pragma once

#include "app/editor/storage/editor_options.h"
#include "app/scene/document/editor_document.h"
#include "gpu/framebuffer.h"
#include "render/scene/image.h"
#include "ui/base/input.h"
#include "ui/base/layout.h"
#include "ui/state/panel_model.h"

namespace kerf::app {

class EditorScene;

/// The editor behind a window or without one: events in, pictures out. It needs a current OpenGL
/// 4.5 context with loaded functions. Each frame() passes the input in batches to the panels,
/// carries out the actions of panels and keys, steps the simulation and draws.
class Editor {
  public:
    /// Opens `document`, or nothing. Throws gpu::ShaderError, gpu::OutOfMemory.
    Editor(const EditorOptions& options, std::optional<Document> document);
    ~Editor();
    Editor(const Editor&) = delete;
    Editor& operator=(const Editor&) = delete;

    /// Queues input for the next frame.
    void post(ui::InputEvent event);
    /// Changes the size of the frame [px]; ignored if a side is 0, as for a hidden window.
    void resize(int width, int height);
    /// Changes the scale of the display, when the window moves to another one; 1 = 96 dpi.
    void setScale(float scale);
    /// Draws no frame but for a picture that was asked for, while nobody sees the window.
    void hide(bool hidden);
    /// Keeps the place of the window in the settings, when it closes.
    void keepPlace(const ui::WindowPlace& place);
    /// Makes one frame, `elapsedSeconds` after the previous one.
    void frame(double elapsedSeconds);
    /// Continues the scene's work, and begins more steps while they can't keep up with the clock,
    /// if no frame is due before that. False if one is, or without work.
    bool workOn();
    /// Looks whether the files of the open models were changed by other programs; about once a
    /// second. An offer to reload them is shown by the next frame.
    void lookAtFiles();
    /// Time until something changes without input [s]; 0 while something moves.
    double idleSeconds() const;

    /// Whether a file is being read or written, or a model being placed, in the background.
    bool working() const;
    /// Requests to quit, as by the window's close button: asks about unsaved work.
    void askToLeave();
    /// Whether quitting was requested and nothing is left to be saved.
    bool closing() const;

    /// The scene and the panels, as shown in the window.
    const gpu::Framebuffer& picture() const;
    /// The present shape of the pointer.
    ui::Cursor cursor() const;
    /// A copy of picture() in main memory; draws it first if frames are not drawn.
    render::Image readPicture() const;
    /// The title of the window: "Kerf - NAME - N pieces".
    std::string title() const;
    /// The model that the panels showed in the last frame.
    const ui::PanelModel& panels() const;

    /// The rectangles of the named items of the panels [px].
    const ui::ItemRects& itemRects() const;
    /// The open scene, for tests; null if none is open.
    EditorScene* scene();

    /// Begins to open a model or a session, which takes some frames. Failures are shown in the view
    /// and change nothing.
    void open(const std::filesystem::path& file);

    /// All that an editor holds (app/editor/editor_state.h).
    struct State;

  private:
    std::unique_ptr<State> state_;
};

}  // namespace kerf::app
