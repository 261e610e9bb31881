#pragma once

#include "sim/run/parts/command.h"
#include "ui/base/settings.h"
#include "ui/plots/plot_math.h"
#include "ui/state/file_dialog_state.h"
#include "ui/state/task_draft.h"
#include "ui/state/tool_settings.h"

namespace kerf::ui {

/// The name of something that a key, a row of a menu or a button asks for: a row of actionTable()
/// (ui/state/action_table.h).
enum class ActionId : std::uint8_t;

/// Undoes or redoes until `done` changes are applied.
struct GoToChange {
    std::size_t done = 0;
};
/// Sets the speed of simulated time relative to the clock.
struct SetSpeed {
    double factor = 1;
};

/// Seeks to a step of the played session.
struct SeekTo {
    int step = 0;
};
/// Removes a picture, an export or a check from the session, by its SessionMark::id.
struct RemoveMark {
    int id = 0;
};
/// Renames a place on the time line, by its SessionMark::id.
struct RenameMark {
    int id = 0;
    std::string name;
};
/// Selects another tool, or another depth or radius of it.
struct SetTools {
    ToolSettings settings;
};

/// Changes the placement of the model; its translation follows and is ignored.
struct PlaceModel {
    Placement placement;
    bool continues = false;  ///< part of the previous gesture
    int model = 0;           ///< of the scene, by number
};
/// Removes a model from the scene, by number; not the first.
struct RemoveModel {
    int model = 0;
};
/// Remeshes a model of the scene, by number.
struct Remesh {
    int model = 0;
    double edge = 0;  ///< edge length, in the unit of its file; 0: as proposed
};
/// Unites the intersecting pieces of a model of the scene, by number.
struct UnitePieces {
    int model = 0;
};
/// Gives a model of the scene a material, both by number; the first model's applies to all without
/// their own.
struct TakeMaterial {
    int material = 0;
    int model = 0;
};
/// Asks for a file to save the body's values as a material.
struct SaveMaterial {};
/// Adds a box beside the body.
struct PlaceBox {};
/// Cancels the long work.
struct CancelWork {};
/// Changes the display of the body.
struct SetDisplay {
    DisplaySettings settings;
};
/// Answers the open question.
struct AnswerQuestion {
    int choice = 0;
    double number = 0;  ///< of Question::number
};

/// Changes the settings of the window.
struct SetSettings {
    Settings settings;
};
/// Shows another part of the time axis in all plots.
struct SetPlotView {
    PlotView view;
};
/// Writes the plots that are shown into the current folder.
struct ExportPlots {
    bool asPicture = false;  ///< as PNG; otherwise their values as CSV
};
/// Removes a measurement from the list, or with 0 all.
struct RemoveMeasure {
    int id = 0;
};
/// Writes the measurements into the current folder as CSV.
struct ExportMeasures {};
/// Opens the session of one of the paper's experiments.
struct OpenExperiment {
    std::string name;
};
/// Opens a scene of the start page, by its place there.
struct OpenStartScene {
    std::size_t card = 0;
};
/// The pointer hovers over a row of the piece list, -1 for none.
struct HoverPiece {
    int piece = -1;
};
/// Selects a piece, -1 for none.
struct SelectPiece {
    int piece = -1;
};
/// Gives a piece a colour in the view, or its look again.
struct ColorPiece {
    int piece = 0;
    std::optional<Vec3> color;  ///< in display colours, 0 to 1
};
/// Asks for a file to export the selected piece.
struct ExportSelectedPiece {};
/// The pointer hovers over a row of the supports and loads, -1 for none.
struct HoverLoad {
    int load = -1;
};
/// Selects a row of the supports and loads, -1 for none.
struct SelectLoad {
    int load = -1;
};
/// Removes what that row shows from the body.
struct RemoveLoad {
    std::size_t load = 0;
};
/// Brings a piece into view.
struct FramePiece {
    int piece = 0;
};
/// Writes the list of pieces into the current folder as CSV.
struct ExportPieces {};
/// Shows or hides a piece; hidden ones are still simulated and cut.
struct ShowPiece {
    int piece = 0;
    bool visible = true;
};

/// Changes the task that is being made.
struct ChangeTask {
    TaskDraft draft;
};

/// All actions of panels. The editor executes them once per frame; panels change nothing.
using Action =
    std::variant<ActionId, SetParam, GoToChange, SetSpeed, SeekTo, RemoveMark, RenameMark, SetTools,
                 SetDisplay, PlaceModel, RemoveModel, Remesh, UnitePieces, TakeMaterial,
                 SaveMaterial, PlaceBox, ChangeBox, RemoveBox, RemovePiece, CancelWork, SetSettings,
                 SetPlotView, ExportPlots, RemoveMeasure, ExportMeasures, OpenExperiment,
                 OpenStartScene, HoverPiece, SelectPiece, FramePiece, ShowPiece, ColorPiece,
                 ExportSelectedPiece, ExportPieces, HoverLoad, SelectLoad, RemoveLoad,
                 AnswerQuestion, FileAction, ChangeTask>;

}  // namespace kerf::ui
