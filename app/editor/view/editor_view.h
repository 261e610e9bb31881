#pragma once

#include <optional>
#include <string>

#include "app/editor/view/body_display.h"
#include "app/scene/document/document_loading.h"
#include "app/scene/document/faulty_scene.h"
#include "app/tools/editor_camera.h"
#include "app/tools/section_tool.h"
#include "app/tools/tool_box.h"
#include "ui/base/layout.h"

namespace kerf::app {

/// A model that can't be cut as it is, in the view instead of the scene.
struct FaultyModel {
    ModelFault fault;
    OpeningOrder order;
    FaultyScene scene;
    EditorCamera before;  ///< the camera of what is open
};

/// The view of the body: from where it is seen, how it is shown, and what the pointer does there.
/// Where a function takes a BusyScene, null means that none is open.
struct EditorView {
    int width = 0;  ///< of the picture [px]
    int height = 0;
    ui::Rect free;        ///< what the panels leave of it; without width: all of it [px]
    bool bright = false;  ///< a light scene, for the light theme
    ui::MouseScheme mouse = ui::MouseScheme::kerf;
    Vec2 pointer = Vec2::Zero();  ///< [px]
    EditorCamera camera;
    BodyDisplay display;
    ToolBox tools;
    SectionTool sectionTool;
    std::optional<FaultyModel> faulty;

    /// The camera looks at the middle of what the panels leave free.
    ViewFrame frame() const;
    /// Flies to where `bounds` fill what the panels leave free [m].
    void flyToFrame(const Bounds& bounds);
    /// Whether this is another size than before. Ignores a side of 0, as of a hidden window.
    bool resize(int newWidth, int newHeight);
    /// Shows a document that was just opened.
    void begin(const EditorScene& scene);
    /// Shows another scene of the same document, seen as the one before.
    void beginAgain(const EditorScene& scene);
    /// Comes along where the model was placed otherwise: what had filled the view does so again.
    /// Whether it was.
    bool follow(const EditorScene& scene);

    /// Shows a model with its faults instead of the scene, as far as they are known. Throws
    /// gpu::OutOfMemory.
    void showFaulty(const ModelFault& fault, const OpeningOrder& order);
    /// Shows the scene again. Returns false where nothing else was shown.
    bool hideFaulty();

    // The pointer.
    void move(const ui::PointerMove& move, const BusyScene& scene);
    /// Takes hold of the view, the blade or the body. Returns "" or one sentence.
    std::string press(const ui::ButtonChange& change, const BusyScene& scene);
    /// Lets go of what that button holds. Returns "" or one sentence.
    std::string release(ui::Button button, const BusyScene& scene);
    void zoom(double notches, const BusyScene& scene);

    // The tools of its left button.
    /// What they go by while the pointer is where it is.
    ToolContext context(const BusyScene& scene, const ui::Modifiers& modifiers = {});
    /// Whether a stroke or a pull is under way, or a handle is held.
    bool holds() const { return tools.inHand().holds() || sectionTool.holds(); }
    /// Whether the right button, which goes up, was no drag but a click for the tool.
    bool rightClicks() const;
    /// Takes another tool, which lets go, or another depth.
    void setTools(const ui::ToolSettings& settings, const BusyScene& scene);
    /// Gives up the stroke and lets go of everything; `takesBack` what that did to the body too.
    void cancelTools(const BusyScene& scene, bool takesBack = false);
    /// The shape of the pointer over the view, where the tools show `overlay`.
    ui::Cursor cursor(const ui::Overlay& overlay) const;
    /// What the tools show over the body; `inView` tells whether the pointer is over no panel.
    /// In the midst of a step no more than where the blade goes.
    ui::Overlay overlay(bool inView, const BusyScene& scene);

  private:
    bool pressSection(const BusyScene& scene);
    Vec2 rightPress_ = Vec2::Zero();  ///< where the right button went down [px]
    int placement_ = 0;               ///< EditorScene::placementRevision() that is shown
    Bounds restBounds_;               ///< of the body then [m]
};

}  // namespace kerf::app
