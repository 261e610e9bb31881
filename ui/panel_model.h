#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "render/scene/image.h"
#include "sim/base/params.h"
#include "sim/contact/static_box.h"
#include "sim/cut/subdivision_pattern.h"
#include "sim/solve/sweep_strength.h"
#include "ui/action.h"
#include "ui/axes_widget.h"
#include "ui/cut_rows.h"
#include "ui/display_settings.h"
#include "ui/fault_legend.h"
#include "ui/field_legend.h"
#include "ui/file_dialog_state.h"
#include "ui/history.h"
#include "ui/overlay.h"
#include "ui/piece_row.h"
#include "ui/settings.h"
#include "ui/tool_settings.h"

namespace kerf::ui {

/// The model that is open, and how its numbers became the metres of the scene.
struct ModelState {
    std::string name;
    Placement placement;
    Vec3 size = Vec3::Zero();  ///< of the uncut model, along the axes of the scene [m]
    std::string guess;         ///< what was taken for its unit and axis, and why; may be empty
    std::string physics;       ///< what physics makes of that size
    std::string triangles;     ///< how many there are, and how poor they are
    double edge = 0;           ///< the length to propose for edges, in the unit of its file
    double remeshed = 0;       ///< about so many triangles it has with these
    bool crosses = false;      ///< pieces of it may pass through each other, and can be united
    int material = -1;         ///< of PanelModel::materials; -1 where it is none of them
};

/// A material that a body can be given.
struct MaterialRow {
    std::string label;
    std::string tooltip;  ///< its values, their spread and sources
    bool own = false;     ///< of a file of the person's, rather than one that comes with Kerf
};

/// One row of the history: something that can be taken back or brought back.
struct ChangeRow {
    std::string name;
    double time = 0;  ///< simulated, when it happened [s]
};

/// The changes that can be taken back.
struct ChangeList {
    std::vector<ChangeRow> rows;  ///< oldest first
    std::size_t done = 0;         ///< so many of them are in force, the others undone
    int forgotten = 0;            ///< older ones that had to go
    std::size_t bytes = 0;
    std::size_t budget = 0;  ///< [bytes]
};

/// The course on the time line: the session that is played, or what was done so far.
struct PlaybackState {
    int step = 0;
    int steps = 0;
    bool goesBack = false;  ///< whether earlier steps are kept
    bool played = false;    ///< not the present: events are to come by themselves
    bool loop = false;
    std::optional<int> divergedAt;  ///< the first step that came out differently
};

/// Something that happens at a step of the session: what a replay does there and changes nothing,
/// or a change of the body or of a parameter.
struct SessionMark {
    enum class Kind { picture, exported, check, camera, stroke, change };

    int id = 0;  ///< what RemoveMark asks for
    int step = 0;
    Kind kind = Kind::picture;
    std::string
        text;  ///< name of the file, or what is checked: "2 pieces, state"; none of a camera
};

/// One of the paper's experiments: its figures beside ours.
struct ExperimentCard {
    std::string name;     ///< "sphere768": what OpenExperiment asks for
    std::string label;    ///< "Sphere 768"
    double timeStep = 0;  ///< the paper's [s]
    int iterations = 0;   ///< the paper's
    int triangles = 0;    ///< the paper's, before the cut; 0 where it is not known
    RunFigures paper;
    std::optional<RunFigures> ours;  ///< of the run that is open, or of the last one; none without
    int ourTriangles = 0;            ///< of that run, as it stands
    bool open = false;
};

/// One line of the log.
struct LogLine {
    std::string text;
    bool isError = false;
};

/// Something that takes long while the editor goes on.
struct WorkState {
    std::string title;  ///< "Opening ball.ply"; empty while there is nothing to tell
    std::string stage;  ///< "Building the constraints"
    double seconds = 0;
    /// What is done of it, 0 to 1; none where that is not known.
    std::optional<double> share = std::nullopt;
    bool mayEnd = true;  ///< before it is done, if the person wishes
};

/// A choice that a person has to make before anything else; none where the text is empty.
struct Question {
    std::string title;
    std::string text;
    std::vector<std::string> choices;  ///< Enter takes the first, Esc the last
    std::shared_ptr<const render::Image> picture = nullptr;  ///< what it is about; may be null
    /// It stands at the lower edge of the view, which can be turned meanwhile: what it is about is
    /// seen there.
    bool aside = false;
};

/// An action that a hint offers, with its label there.
struct HintChoice {
    ActionId id{};
    std::string label;
};
/// A sentence that says what to do first or next.
struct Hint {
    std::string text;  ///< empty for no hint
    std::vector<HintChoice> choices;
};

/// All that the panels show: filled by the editor every frame, read only here.
struct PanelModel {
    std::string name;                ///< of what is open; empty while nothing is
    std::vector<ModelState> models;  ///< of the scene, by number
    int objects = 0;                 ///< of the only model's file; fewer than two: nothing to part
    std::vector<MaterialRow> materials;
    bool untouched = true;   ///< no cut was made that a placement would undo
    bool liveModels = true;  ///< small enough to follow a drag
    Params params;           ///< as they are
    Params startParams;      ///< as they were when it was opened: what the reset mark returns to
    std::vector<StaticBox> boxes;           ///< that the body collides with
    double bodySize = 1;                    ///< diagonal of the body at rest [m]
    Bounds bodyBounds;                      ///< of the body as it is [m]
    const SweepStrength* sweeps = nullptr;  ///< of the body; null while nothing is open
    bool playing = false;
    double speed = 1;  ///< of simulated time against the clock
    ChangeList changes;
    ToolSettings tools;
    std::vector<MeasureRow> measures;  ///< oldest first
    std::size_t pinned = 0;            ///< vertices that are held in place
    std::size_t hooks = 0;             ///< of retractors, which hold cuts open
    Overlay overlay;                   ///< of the coming cut
    ViewAxes axes;
    bool orthographic = false;
    PlaybackState playback;
    /// Pictures, exports and checks of the session that would be saved now, by step.
    std::vector<SessionMark> marks;
    std::vector<SessionMark> course;  ///< strokes and changes of it, by step
    bool recording = false;
    bool stroking = false;  ///< the pointer draws a stroke, or poses of one are still to come
    bool helpOpen = false;
    DisplaySettings display;
    FieldLegend fieldLegend;
    std::vector<FaultRow> faults;  ///< that are marked in the view
    /// A model that can't be cut stands in the view, with its faults, instead of the body.
    bool showsFaulty = false;
    int faultCount = 0;           ///< of the open model, marked or not
    Vec3 ownSkin = Vec3::Zero();  ///< colours of the look itself (see DisplaySettings::colors)
    Vec3 ownFlesh = Vec3::Zero();
    bool hasOwnColors = false;  ///< the model's file has colours or images
    int step = 0;
    double time = 0;  ///< simulated [s]
    int vertices = 0;
    int triangles = 0;
    std::string device;  ///< what draws: "llvmpipe"
    Hint hint;
    WorkState work;
    FileDialogState files;
    std::vector<std::filesystem::path> recentFiles;
    Question question;
    std::string toast;  ///< what just happened; empty for none
    bool toastIsError = false;
    float toastOpacity = 1;                 ///< 0 to 1, while it fades
    std::optional<HintChoice> toastChoice;  ///< what can be done about it
    std::vector<LogLine> log;               ///< oldest first
    SubdivisionCounts subdivisions{};       ///< of the surface, since the body was whole
    std::vector<CutRow> cuts;               ///< how well the cuts came out
    std::string cutsNote;                   ///< what is to be said of them; may be empty
    std::vector<PieceRow> pieces;
    int hoveredPiece = -1;             ///< in that list; -1 for none
    const History* history = nullptr;  ///< never null while panels are drawn
    std::optional<RunFigures> paper;   ///< of what is open, where the paper has it
    std::vector<ExperimentCard> experiments;
    PlotView plotView;
    Settings settings;
};

}  // namespace kerf::ui
