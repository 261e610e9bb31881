#pragma once

#include <span>
#include <vector>

#include "gpu/framebuffer.h"
#include "ui/action.h"
#include "ui/file_dialog.h"
#include "ui/input.h"
#include "ui/item_places.h"
#include "ui/panel_context.h"
#include "ui/panel_model.h"
#include "ui/question_box.h"

namespace kerf::ui {

/// All panels, drawn with Dear ImGui into an off-screen picture. Fed from the editor's own input
/// queue, so that it behaves alike with a window and without one.
class Interface {
  public:
    /// Needs a current OpenGL 4.5 context; `scale` of all lengths and letters: 1 for 96 dpi.
    Interface(Theme theme, float scale);

    /// Another look from the next pass on.
    void restyle(Theme theme, float scale) { context_.restyle(theme, scale); }

    /// One pass over the panels with the input of one batch; the answers of the person. A pass
    /// without draw() is fine: only the last one is shown.
    std::vector<Action> pass(std::span<const InputEvent> events, const PanelModel& model, int width,
                             int height, double elapsedSeconds);
    /// Draws the last pass over `picture`, which must have the size of that pass.
    void draw(const gpu::Framebuffer& picture);

    /// Whether the pointer (or the keyboard) belonged to a panel in the last pass.
    bool ownsPointer() const;
    bool ownsKeyboard() const;
    /// Whether a panel's item is held with the pointer.
    bool isDragging() const;

    /// What the panels hid of the view in the last pass.
    const std::vector<Rect>& covered() const { return covered_; }

    /// Where the named items of the last pass are.
    const ItemPlaces& places() const { return places_; }

  private:
    void noteCovered(const Settings& settings, const Layout& layout);

    PanelContext context_;
    FileDialog fileDialog_;
    QuestionBox questionBox_;
    ItemPlaces places_;
    std::vector<Rect> covered_;
};

}  // namespace kerf::ui
