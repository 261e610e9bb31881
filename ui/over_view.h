// What is drawn over the view and around the panels.
#pragma once

#include "ui/base/layout.h"
#include "ui/base/widgets.h"
#include "ui/state/action.h"
#include "ui/state/panel_model.h"

namespace kerf::ui {

/// Draws a hint what to do next into the view: at its lower edge, or in its middle if nothing is
/// open. Only the buttons of its choices take input.
void drawHint(const PanelModel& model, const Rect& view, std::vector<Action>& actions);

/// If no side panel is shown: draws a button with the key that shows them, in place of the menu.
void drawPanelsHint(const Settings& settings, const Rect& view, std::vector<Action>& actions);

/// Draws a sentence above a row of buttons, in the middle of `view` and down to `bottom` [px]. The
/// buttons are noted as NAME.KEY.
void drawOffer(const char* name, const Hint& hint, const Rect& view, float bottom,
               const BannerStyle& style, std::vector<Action>& actions);

/// Draws a message at the upper edge of the view, with a button for a possible action. It fades.
void drawToast(const ToastState& toast, const Rect& view, std::vector<Action>& actions);

/// Draws long work, its stage and its time, at the upper edge of the view, with a button to cancel
/// it if possible; nothing if the title is empty.
void drawWork(const WorkState& work, const Rect& view, std::vector<Action>& actions);

/// A line about the document: its name, its size, how often pieces were lost, whether time runs.
std::string statusText(const PanelModel& model);

/// Draws one line: statusText(), and at its right the device that draws and the key of the help.
void drawStatusBar(const PanelModel& model, const Rect& rect);

/// Draws all keys and gestures, made from the table of actions, over everything while the help is
/// open.
void drawHelp(const PanelModel& model, std::vector<Action>& actions);

/// Whether a view is large enough for the cross of axes.
bool hasRoomForAxes(const Rect& view, float scale);
/// A small cross of the world's axes in the upper right corner of the view. A click on one of its
/// six ends looks from there. `scale` is the display's
/// (1 = 96 dpi).
void drawAxes(const ViewAxes& axes, const Rect& view, float scale, std::vector<Action>& actions);

/// Draws the edges between the side panels and the view: a drag sets the width, a drag to the side
/// hides the panel; an arrow shows it again.
void drawEdges(const Settings& settings, const Layout& layout, float scale,
               std::vector<Action>& actions);

/// Draws a bar across the panel that is being drawn, under the last item. While it is dragged it
/// returns its position as a share of `height` below `top` [px], between 0 and 1.
std::optional<double> horizontalSplitter(const char* id, float top, float height);

/// Height of a horizontal splitter, spacing included [px].
float splitterHeight();

}  // namespace kerf::ui
