#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>

#include "sim/run/parts/command.h"
#include "ui/base/settings.h"
#include "ui/plots/plot_math.h"
#include "ui/state/display_settings.h"
#include "ui/state/file_dialog_state.h"
#include "ui/state/tool_settings.h"

namespace kerf::ui {

/// The name of something that a key, a row of a menu or a button asks for: a row of actionTable()
/// (ui/state/action_table.h).
enum class ActionId : std::uint8_t;

/// Undoes or redoes until so many changes are in force.
struct GoToChange {
    std::size_t done = 0;
};
/// Lets simulated time run at another speed, against the clock.
struct SetSpeed {
    double factor = 1;
};

/// Goes to a step of the session that is played.
struct SeekTo {
    int step = 0;
};
/// Takes a picture, an export or a check out of the session, by its SessionMark::id.
struct RemoveMark {
    int id = 0;
};
/// Takes another tool, or another depth or radius of it.
struct SetTools {
    ToolSettings settings;
};

/// Places the model otherwise; where it stands follows, so its translation does not matter.
struct PlaceModel {
    Placement placement;
    bool continues = false;  ///< the same gesture had placed it before
    int model = 0;           ///< of the scene, by number
};
/// Takes a model out of the scene, by number; the first stays.
struct RemoveModel {
    int model = 0;
};
/// Exchanges a model of the scene, by number, for one with even triangles.
struct Remesh {
    int model = 0;
    double edge = 0;  ///< how long theirs are, in the unit of its file; 0: as proposed
};
/// Exchanges a model of the scene, by number, for one whose crossing pieces are one surface.
struct UnitePieces {
    int model = 0;
};
/// Gives a model of the scene a material, both by number; the first stands for all that have none
/// of their own.
struct TakeMaterial {
    int material = 0;
    int model = 0;
};
/// Asks for a file into which the values of the body go as a material.
struct SaveMaterial {};
/// Puts a new box beside the body.
struct PlaceBox {};
/// Gives up the work that takes long.
struct CancelWork {};
/// Shows the body another way.
struct SetDisplay {
    DisplaySettings settings;
};
/// Takes one of the choices of the question that is asked.
struct AnswerQuestion {
    int choice = 0;
};

/// Gives the window another look.
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
/// Takes a measure out of the list, or with 0 all of them.
struct RemoveMeasure {
    int id = 0;
};
/// Writes the measures into the current folder as CSV.
struct ExportMeasures {};
/// Opens the session of one of the paper's experiments.
struct OpenExperiment {
    std::string name;
};
/// The pointer rests on a row of the piece list, -1 on none.
struct HoverPiece {
    int piece = -1;
};
/// Brings a piece into view.
struct FramePiece {
    int piece = 0;
};
/// Writes the list of pieces into the current folder as CSV.
struct ExportPieces {};
/// Shows or hides a piece; it is simulated and cut all the same.
struct ShowPiece {
    int piece = 0;
    bool visible = true;
};

/// All that panels answer with. The editor drains them once per frame; panels change nothing.
using Action =
    std::variant<ActionId, SetParam, GoToChange, SetSpeed, SeekTo, RemoveMark, SetTools, SetDisplay,
                 PlaceModel, RemoveModel, Remesh, UnitePieces, TakeMaterial, SaveMaterial, PlaceBox,
                 ChangeBox, RemoveBox, CancelWork, SetSettings, SetPlotView, ExportPlots,
                 RemoveMeasure, ExportMeasures, OpenExperiment, HoverPiece, FramePiece, ShowPiece,
                 ExportPieces, AnswerQuestion, FileAction>;

}  // namespace kerf::ui
