#pragma once

#include "gpu/framebuffer.h"
#include "ui/base/input.h"
#include "ui/base/layout.h"
#include "ui/base/panel_context.h"
#include "ui/command_box.h"
#include "ui/file_dialog.h"
#include "ui/question_box.h"
#include "ui/start_page.h"
#include "ui/state/action.h"
#include "ui/state/panel_model.h"

namespace kerf::ui {

/// All panels, drawn with Dear ImGui into an off-screen frame. Fed from the editor's input queue,
/// so that it behaves the same with and without a window.
class Interface {
  public:
    /// Needs a current OpenGL 4.5 context. `scale` is that of all lengths and letters, 1 for 96
    /// dpi.
    Interface(Theme theme, float scale);

    /// Changes theme and scale from the next update on.
    void restyle(Theme theme, float scale) { context_.restyle(theme, scale); }

    /// Lays the panels out with the input of one batch, and returns the user's actions. An update
    /// without draw() is fine: only the last one is shown.
    std::vector<Action> update(std::span<const InputEvent> events, const PanelModel& model,
                               int width, int height, double elapsedSeconds);
    /// Draws the last update over `picture`, which must have the size of that update.
    void draw(const gpu::Framebuffer& picture);

    /// Whether the pointer belonged to a panel in the last update.
    bool ownsPointer() const;
    /// Whether it was over the view, beside a question with Question::aside.
    bool pointsBesideQuestion() const;
    /// Whether the keyboard belonged to a panel in the last update.
    bool ownsKeyboard() const;
    /// Whether a key belonged to the time line in the last update, under the pointer.
    bool ownsKey(Key key) const;
    /// Whether a panel's item is held with the pointer.
    bool isDragging() const;

    /// The shape of the pointer over the panels in the last update.
    Cursor cursor() const;

    /// The part of the picture that the panels left free in the last update [px].
    const Rect& freeView() const { return freeView_; }
    /// How much of its lower edge the hint covered then [px].
    float hintHeight() const { return hintHeight_; }
    /// The parts of the view that the panels covered in the last update [px].
    const std::vector<Rect>& covered() const { return covered_; }

    /// The rectangles of the named items in the last update [px].
    const ItemRects& itemRects() const { return itemRects_; }

  private:
    void noteCovered(const Settings& settings, const Layout& layout);
    void feed(const InputEvent& event);

    PanelContext context_;
    FileDialog fileDialog_;
    QuestionBox questionBox_;
    CommandBox commandBox_;
    StartPage startPage_;
    ItemRects itemRects_;
    std::vector<Rect> covered_;
    Rect freeView_;
    Rect timeline_;
    float hintHeight_ = 0;
    bool closesPopup_ = false;  ///< Esc was pressed for it only
};

}  // namespace kerf::ui
