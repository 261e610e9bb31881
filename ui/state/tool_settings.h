#pragma once

#include "render/scene/body_look.h"
#include "render/scene/overlays.h"
#include "render/scene/scene.h"
#include "render/scene/surface_field.h"
#include "sim/body/skin_normals.h"
#include "ui/base/input.h"

namespace kerf::ui {

/// The kind of measurement by clicks.
enum class MeasureKind : std::uint8_t { distance, angle, piece, point };
std::string_view nameOf(MeasureKind kind);

/// One measured number.
struct MeasureFigure {
    std::string quantity;  ///< "distance", "angle", "skin area", "cut area", "volume", "strain"
    double value = 0;      ///< [m, degrees, m^2, m^3, share, m/s]
    std::string unit;      ///< of value: "m", "deg", "m2", "m3", "", "m/s"
    double ownValue = 0;   ///< in the numbers of the model's own file
    std::string ownUnit;   ///< "mm", "mm2"; empty if it is the same
    std::string text;      ///< for display: "12.3 cm (123 mm in its file)"
};

/// A measurement in the list: a distance, an angle, a piece with its areas and its volume, or the
/// point that is plotted.
struct MeasureRow {
    int id = 0;  ///< for RemoveMeasure
    MeasureKind kind = MeasureKind::distance;
    std::vector<MeasureFigure> figures;
    bool isOld = false;  ///< the body has moved since its areas were computed
};

/// The measurements as a table: id,measure,quantity,value,unit,value_in_file,unit_in_file.
std::string measuresAsCsv(const std::vector<MeasureRow>& measures);

/// The tool of the left button in the view: it moves a blade in one of three ways, or touches the
/// body.
enum class ToolKind : std::uint8_t {
    stroke,      ///< along the line of sight, wherever the pointer goes
    scalpel,     ///< upright on the surface under the pointer: incisions
    guillotine,  ///< posed by handles and brought straight down
    grab,        ///< pulls at the body
    pin,         ///< holds parts of the body in place, or frees them
    retract,     ///< holds cuts open by hooks
    move,        ///< moves, turns and resizes boxes, pins and the model by a gizmo
    measure,     ///< measures distances, angles, areas and volumes by clicks
};

/// One row of the table of tools for panel, actions and hints. Their implementation is in
/// app/tools.
struct ToolRow {
    ToolKind tool;
    Key key;  ///< that selects it
    std::string_view keyText;
    const char* name;        ///< on its button
    std::string_view label;  ///< of the action that selects it
    std::string_view hint;   ///< until its first use
    bool leadsBlade = false;
    bool readsBody = true;          ///< or changes it, so it waits for a step to end
    std::string_view trigger = {};  ///< what ActionId::bringDown does with it, if anything
};

/// All tools in the order of their buttons.
inline constexpr std::array kToolRows{
    ToolRow{ToolKind::stroke, Key::c, "C", "Stroke", "Stroke: cut along the view",
            "Drag with the left button all the way across the model to cut it.", true, false},
    ToolRow{ToolKind::scalpel, Key::s, "S", "Scalpel", "Scalpel: follow the surface",
            "Drag over the model to cut along its surface. The ring shows the depth.", true},
    ToolRow{ToolKind::guillotine, Key::g, "G", "Guillotine",
            "Guillotine: place a blade and drop it",
            "Drag the four handles to place the blade, then:", true, false, "Drop the blade"},
    ToolRow{ToolKind::grab, Key::d, "D", "Grab", "Grab: pull the body",
            "Drag the model to pull it. Time runs while you hold it."},
    ToolRow{ToolKind::pin, Key::p, "P", "Pin", "Pin: hold parts in place",
            "Drag over the model to fix it in place. Shift+drag pins a box, Ctrl+drag unpins."},
    ToolRow{ToolKind::retract, Key::y, "Y", "Retract", "Retract: hold a cut open",
            "Press beside a cut and drag: two hooks pull it open and hold it. Right-click a hook "
            "to remove both."},
    ToolRow{ToolKind::move, Key::u, "U", "Move", "Move: boxes, pins and the model",
            "Click a box, pins or the uncut model, then drag an arrow, a ring or a square."},
    ToolRow{ToolKind::measure, Key::m, "M", "Measure", "Measure: distances, angles, pieces",
            "Click on the body to measure. Esc ends it."},
};
inline constexpr int kTools = static_cast<int>(kToolRows.size());
/// The initial tool, to which Esc returns.
inline constexpr ToolKind kFirstTool = ToolKind::stroke;

constexpr const ToolRow& rowOf(ToolKind tool) {
    return kToolRows[static_cast<std::size_t>(tool)];
}
/// Whether a table has one row for each ToolKind, in the same order.
template <class Table>
constexpr bool coversTools(const Table& rows) {
    int next = 0;
    return std::ranges::all_of(rows, [&](const auto& row) { return int(row.tool) == next++; }) &&
           next == kTools;
}
static_assert(coversTools(kToolRows), "a tool has no row, or not at its place");

// The settings of each tool that has any. Lengths in metres.
struct StrokeSettings {
    bool throughAll = true;  ///< the blade reaches beyond the body
    double depth = 0.3;      ///< otherwise its end behind the nearest point of the body
};
struct ScalpelSettings {
    double depth = 0.1;  ///< below the surface
};
struct GuillotineSettings {
    double length = 1;
    double drop = 1;     ///< how far it goes down
    double lowered = 0;  ///< share of that, 0 to 1
};
struct GrabSettings {
    double radius = 0.1;  ///< of the hand
};
/// What the pin tool does to what it brushes over.
enum class PinKind { hold, move, push };
inline constexpr std::array<std::string_view, 3> kPinKinds{"Fix", "Move", "Push"};
struct PinSettings {
    double radius = 0.1;  ///< of the brush
    PinKind kind = PinKind::hold;
    Vec3 velocity{0, 0.1, 0};  ///< of what is moved [m/s]
    double seconds = 0;        ///< for how long, 0: for good [s]
    Vec3 newtons{0, 1, 0};     ///< on what is pushed [N]
};

/// The selected tool and the settings of all, shown and changed by the tools panel.
struct ToolSettings {
    ToolKind tool = kFirstTool;
    StrokeSettings stroke;
    ScalpelSettings scalpel;
    GuillotineSettings guillotine;
    GrabSettings grab;
    PinSettings pin;
    MeasureKind measure = MeasureKind::distance;
    double longest = 3;  ///< end of all sliders [m]
};

/// The display of the body. It does not affect the simulation.
struct DisplaySettings {
    render::Quality quality = render::Quality::full;
    bool wireframe = false;
    bool cutLines = true;   ///< a dark line along the rim of each cut, so that closed ones show
    bool cutAhead = false;  ///< triangles that a stroke under way will cut
    /// Distance at which the pieces are drawn from each other; 1 doubles that of their middles.
    double apart = 0;
    bool pieceDetails = false;  ///< the list of pieces has all its columns
    render::Overlays overlays;
    render::FieldChoice field;                    ///< shown by its colours instead of the look
    std::optional<render::SectionPlane> section;  ///< opens the view of the body
    render::ChosenColors colors;                  ///< look and colours instead of the model's own
    /// Faces that meet at more than this angle have a hard edge between them [degrees].
    double hardEdges = kHardEdgeAngle;
    bool operator==(const DisplaySettings&) const = default;
};

}  // namespace kerf::ui
