// The panels, from the upper left to the lower edge of the window. Each reads its part of the model
// and adds what is asked for to the actions.
#pragma once

#include "sim/base/params.h"
#include "ui/base/layout.h"
#include "ui/plots/plot.h"
#include "ui/state/action.h"
#include "ui/state/panel_model.h"

namespace kerf::ui {

/// Draws a menu per group of the table of actions, in the menu bar of the panel that is being
/// drawn.
void drawMenuBar(const PanelModel& model, std::vector<Action>& actions);

/// Draws the buttons that play, pause, step, reset and record, the simulated time and its pace.
void drawTransport(const PanelModel& model, std::vector<Action>& actions);

/// Draws the heading of a collapsible section. `id` is its name in Settings::folded. Returns false
/// if collapsed: then draw nothing of it.
bool beginSection(const char* id, const char* title, const Settings& settings,
                  std::vector<Action>& actions);

/// Draws a card for each of the paper's experiments, its figures beside ours; a click opens it.
void drawExperiments(const std::vector<ExperimentCard>& experiments, std::vector<Action>& actions);

/// Draws the open model's unit, up axis, rotation and scale, which a click or a drag changes, and
/// the physics of its size.
void drawModel(const ModelPanelState& model, const ParametersState& parameters,
               const DisplaySettings& display, std::vector<Action>& actions);

/// Draws the buttons of the tools and the settings of the one that is chosen.
void drawTools(const PanelModel& model, std::vector<Action>& actions);

/// Draws the kind of the measuring tool, and the list of measurements. Returns whether `tools`
/// changed.
bool drawMeasureRows(const std::vector<MeasureRow>& measures, ToolSettings& tools,
                     std::vector<Action>& actions);

/// Whether a parameter has a row: those of tearing only while the body tears, those of its skin
/// where it has one.
bool isShown(const ParamInfo& info, const Params& now);

/// Draws a row per parameter of paramTable(): the four most used on top, the rest under "More".
/// Each returns a SetParam command.
void drawParameters(const ParametersState& parameters, std::vector<Action>& actions);

/// Draws the per-model parameters of model `model` of the scene, not the first; shows the common
/// value if it has none.
void drawOwnParameters(int model, const ParametersState& parameters, std::vector<Action>& actions);

/// A remark about a parameter at present, such as what a step is made of with the implicit solver;
/// "" for none.
std::string remarkOn(const ParamInfo& info, const ParametersState& parameters);

/// What the last step was made of: "20 iterations", or with the implicit solver "2 implicit steps
/// of 2.5 ms, 6 iterations".
std::string partsOfStep(const ParametersState& parameters);

/// The printf format of a slider: decimals that suit the range, and the unit ("%.4f s"). It does
/// not follow the value, since ImGui rounds to it and scales logarithmic sliders by it.
std::string sliderFormat(const ParamInfo& info);

/// Draws the toggles of the overlays, and the choosers of the body's colours.
void drawDisplay(const PanelModel& model, std::vector<Action>& actions);

/// Draws a legend of the colours of overlays, and of a quantity on the body, at the right of the
/// view, while any is shown: below the axes and what the editor says, or at the top.
void drawLegend(const LooksState& looks, const DisplaySettings& display, const Rect& view,
                bool belowBoxes, float scale);

/// Draws the quality of the cuts: the figures of all of them beside those of the last stroke.
void drawCuts(const CutsState& cuts);

/// Draws the choosers of the window's theme and scale.
void drawWindowRows(const Settings& settings, std::vector<Action>& actions);

/// Draws a colour that can be chosen, and once it is a mark that resets it to `own`. Returns
/// whether it changed.
bool chooseColor(const char* label, std::optional<Vec3>& chosen, const Vec3& own,
                 const char* tooltip);

/// Draws a row per thing that holds or pulls the body, with its value and a button that removes it.
/// Hovered rows return an action, clicked ones are selected.
void drawLoads(const LoadsState& loads, std::vector<Action>& actions);

/// Draws a row per piece: an eye that hides it, its colour, triangles, volume and share of its rest
/// volume. Hovered rows return an action, clicked ones select and frame their piece; a selected one
/// can be coloured and exported.
void drawPieces(const PiecesState& pieces, const DisplaySettings& display,
                std::vector<Action>& actions);
/// The height [px] in which drawPieces() shows all rows without scrolling, in the current window.
float piecesHeight(const PiecesState& pieces, const DisplaySettings& display);

/// The plots chosen in the settings. They refer to the model.
std::vector<PlotSpec> chosenPlots(const PlotsState& state, const Settings& settings);

/// Draws a line of buttons and the chosen plots, together `height` pixels high; they scroll where
/// they would get too small to read.
void drawPlots(const PlotsState& state, const TransportState& transport, const Settings& settings,
               float height, std::vector<Action>& actions);

/// Draws the time by stage: last, mean, smallest, largest, and the share of all stages, as in the
/// paper's table 3.
void drawStages(const History& history, const SubdivisionCounts& subdivisions);
/// The shares of the stages in a line: "Deform 62 %, Collide 9 %".
std::string sharesOfStages(const History& history);

/// Draws the list of changes, oldest first, and the memory that their undo takes. A click goes to
/// that change.
void drawChanges(const PanelModel& model, std::vector<Action>& actions);

/// Draws the rows of the menu that adds pictures, checks and exports to the session.
void drawSessionAdditions(std::vector<Action>& actions);

/// Draws the pictures, exports and checks of the session, each with a button that removes it.
void drawSessionMarks(const SessionPanelState& session, std::vector<Action>& actions);

/// Draws the task of the session, who practises, and the score once the try is finished.
void drawPractice(const PracticeState& practice, const Settings& settings,
                  std::vector<Action>& actions);

/// Draws the boxes that the body collides with, one foldable group each, and a button for another
/// one.
void drawBoxes(const BodyReport& body, std::vector<Action>& actions);

/// Draws the messages so far, scrolled to the newest at the bottom.
void drawLog(const std::vector<LogLine>& log);

/// Draws the timeline in `rect`: a slider to seek to any step with ticks for strokes and changes,
/// and above it a mark for each picture, export and check.
void drawTimeline(const SessionPanelState& session, const Rect& rect, std::vector<Action>& actions);

/// A mark for display: "Picture ball-120.png".
std::string labelOf(const SessionMark& mark);

}  // namespace kerf::ui
