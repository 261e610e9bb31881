#pragma once

#include "app/editor/view/body_display.h"
#include "app/scene/document/document_loading.h"
#include "app/scene/document/faulty_scene.h"
#include "app/tools/editor_camera.h"
#include "app/tools/section_tool.h"
#include "app/tools/tool_box.h"
#include "ui/base/layout.h"

namespace kerf::app {

/// A model that can't be cut, shown instead of the scene.
struct FaultyModel {
    ModelFault fault;
    OpeningOrder order;
    FaultyScene scene;
    EditorCamera before;  ///< the camera of the open scene
};

/// The view of the body: camera, display and pointer. Where a function takes a BusyScene, null
/// means that none is open.
struct EditorView {
    int width = 0;  ///< of the picture [px]
    int height = 0;
    ui::Rect free;        ///< area free of panels; without width: all of it [px]
    float hint = 0;       ///< height of the hint at its lower edge [px]
    bool bright = false;  ///< a light scene, for the light theme
    ui::MouseScheme mouse = ui::MouseScheme::kerf;
    Vec2 pointer = Vec2::Zero();  ///< [px]
    EditorCamera camera;
    BodyDisplay display;
    ToolBox tools;
    SectionTool sectionTool;
    std::optional<FaultyModel> faulty;

    /// The frame, with the camera centred on the area free of panels.
    ViewFrame frame() const;
    /// The first view of the scene, with room between the panels for the model, or for the lines
    /// of a task.
    render::Camera homeView(const BusyScene& scene) const {
        return fitted(scene.homeView(), scene.homeBounds());
    }
    /// Flies to a view in which `bounds` fill the area free of panels and hint [m].
    void flyToFrame(const Bounds& bounds);
    /// Returns whether the size has changed. Ignores a side of 0, as of a hidden window.
    bool resize(int newWidth, int newHeight);
    /// Shows a document that was just opened.
    void begin(const EditorScene& scene);
    /// Takes the tool of a task, at its depth.
    void takeToolsOf(const Task& task);
    /// What a saved session keeps of it.
    SavedView saved() const;
    void show(const SavedView& saved);
    /// Shows another scene of the same document in the same view.
    void beginAgain(const EditorScene& scene);
    /// Follows a new placement of the model: what filled the view does so again. Returns whether
    /// there was one.
    bool follow(const EditorScene& scene);

    /// Shows a model with its faults instead of the scene, as far as they are known. Throws
    /// gpu::OutOfMemory.
    void showFaulty(const ModelFault& fault, const OpeningOrder& order);
    /// Shows the scene again. Returns false where nothing else was shown.
    bool hideFaulty();

    // The pointer.
    void move(const ui::PointerMove& move, const BusyScene& scene);
    /// Starts a drag of the view, the blade or the body. Returns "" or one sentence.
    std::string press(const ui::ButtonChange& change, const BusyScene& scene);
    /// Ends the drag of that button. Returns "" or one sentence.
    std::string release(ui::Button button, const BusyScene& scene);
    /// Zooms, unless the tool uses the wheel.
    void turnWheel(double notches, const BusyScene& scene);

    // The tools of its left button.
    /// The context of tools at the present pointer.
    ToolContext context(const BusyScene& scene, const ui::Modifiers& modifiers = {});
    /// Whether a stroke or a pull is in progress, or a handle is held.
    bool holds() const { return tools.inHand().holds() || sectionTool.holds(); }
    /// Whether the release of the right button ends a click, not a drag.
    bool rightClicks() const;
    /// Selects another tool, after releasing the old one, or another depth.
    void setTools(const ui::ToolSettings& settings, const BusyScene& scene);
    /// Cancels the stroke and releases everything; `takesBack` also reverts its effect on the body.
    void cancelTools(const BusyScene& scene, bool takesBack = false);
    /// The shape of the pointer over the view, with the tools' `overlay`.
    ui::Cursor cursor(const ui::Overlay& overlay) const;
    /// The overlay of the tools; `inView`: whether the pointer is over no panel. During a step only
    /// the path of the blade.
    ui::Overlay overlay(bool inView, const BusyScene& scene);

  private:
    double freeShare() const;
    render::Camera fitted(render::Camera home, const Bounds& bounds) const;
    bool pressSection(const BusyScene& scene);
    /// The load at the pointer, or none.
    void selectLoad(const BusyScene& scene);
    Vec2 rightPress_ = Vec2::Zero();  ///< where the right button was pressed [px]
    int placement_ = 0;               ///< displayed EditorScene::placementRevision()
    Bounds restBounds_;               ///< of the body then [m]
};

}  // namespace kerf::app
