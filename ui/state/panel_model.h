#pragma once

#include "sim/base/math.h"
#include "sim/base/params.h"
#include "sim/base/placement.h"
#include "sim/contact/static_box.h"
#include "sim/cut/cut_types.h"
#include "ui/base/settings.h"
#include "ui/plots/history.h"
#include "ui/plots/plot_math.h"
#include "ui/state/file_dialog_state.h"
#include "ui/state/legends.h"
#include "ui/state/overlay.h"
#include "ui/state/piece_row.h"
#include "ui/state/tool_settings.h"
#include "ui/state/window_state.h"

namespace kerf::ui {

/// One row of what holds or pulls the body: pins that hang together, a motion, the forces on the
/// same vertices, a hand or a retractor.
struct LoadRow {
    std::string_view kind;  ///< "Pin"
    std::string value;      ///< with its unit: "1.5 N"
    std::string detail;     ///< a sentence for the tooltip
    std::size_t vertices = 0;
};

/// What the list of supports and loads shows.
struct LoadsState {
    std::vector<LoadRow> rows;
    int hovered = -1;   ///< of rows; -1 for none
    int selected = -1;  ///< likewise
};

/// The state of the body for several panels.
struct BodyReport {
    double size = 1;               ///< its diagonal at rest [m]
    Bounds bounds;                 ///< at present [m]
    std::vector<StaticBox> boxes;  ///< that it collides with
    int vertices = 0;
    int triangles = 0;
    std::size_t pinned = 0;  ///< pinned vertices and forces
    std::size_t hooks = 0;   ///< of retractors, which hold cuts open
    LoadsState loads;
};

/// One row of the history: a change that can be undone or redone.
struct ChangeRow {
    std::string name;
    double time = 0;  ///< simulated time of the change [s]
};

/// The undo history.
struct ChangeList {
    std::vector<ChangeRow> rows;  ///< oldest first
    std::size_t done = 0;         ///< number of applied ones; the others are undone
    int forgotten = 0;            ///< older ones that were dropped
    bool recallable = false;      ///< undo brings older ones back first, by playing the session
    // Memory [bytes].
    std::size_t bytes = 0;  ///< of undo, in all scenes that are kept
    std::size_t budget = 0;
    std::size_t checkpoints = 0;  ///< of the time line
    std::size_t checkpointBudget = 0;
};

/// A figure of how well cuts came out.
struct CutRow {
    std::string quantity;  ///< "Smallest angle, worst"
    std::string all;       ///< of all cuts, as people read it
    std::string last;      ///< of the last stroke; empty where a stroke has none of its own
    std::string tooltip;   ///< what it means
};

/// The quality of the cuts.
struct CutsState {
    std::vector<CutRow> rows;
    std::string note;                  ///< about them; may be empty
    SubdivisionCounts subdivisions{};  ///< of the surface, since the body was whole
};

/// The state of the looks and the legend.
struct LooksState {
    FieldLegend field;
    std::vector<FaultRow> faults;  ///< that are marked in the view
    /// The view shows a model that can't be cut, with its faults, instead of the body.
    bool showsFaulty = false;
    Vec3 ownSkin = Vec3::Zero();  ///< colours of the look itself (see DisplaySettings::colors)
    Vec3 ownFlesh = Vec3::Zero();
    bool hasOwnColors = false;  ///< the model's file has colours or images
};

/// An open model and its placement.
struct ModelState {
    std::string name;
    Placement placement;
    Vec3 size = Vec3::Zero();  ///< of the uncut model, along the axes of the scene [m]
    std::string guess;         ///< the guess of its unit and axis, and why; may be empty
    std::string physics;       ///< the physics of that size
    std::string triangles;     ///< their number and quality
    double edge = 0;           ///< proposed edge length, in the unit of its file
    double remeshed = 0;       ///< about how many triangles it has then
    bool crosses = false;      ///< its pieces may intersect, and can be united
    int material = -1;         ///< of ModelPanelState::materials; -1 where it is none of them
};

/// A material that a body can be given.
struct MaterialRow {
    std::string label;
    std::string tooltip;  ///< its values, their spread and sources
    bool own = false;     ///< of a user file, not built in
};

/// What the panel of models shows.
struct ModelPanelState {
    std::vector<ModelState> models;      ///< of the scene, by number
    int objects = 0;                     ///< of the only model's file; to part if two or more
    std::vector<MaterialRow> materials;  ///< to choose from
    bool untouched = true;               ///< no cut was made that a placement would undo
    bool live = true;                    ///< small enough to follow a drag
    int faultCount = 0;                  ///< of the open model, marked or not
};

/// What the panel of parameters shows.
struct ParametersState {
    Params now;
    Params start;                    ///< when opened, for the reset button
    int iterations = 1;              ///< of the last step, as given or chosen
    int implicitSteps = 0;           ///< that the last step was made of; 0 while nothing is open
    std::optional<double> residual;  ///< of it: see StepParts
};

/// The timeline: the played session, or what was done so far.
struct PlaybackState {
    int step = 0;
    int steps = 0;
    bool goesBack = false;  ///< whether earlier steps are kept
    bool played = false;    ///< events are still to come
    bool loop = false;
    std::optional<int> divergedAt;  ///< the first step that differed
};

/// A mark at a step of the session: an output or check of a replay, a name, or something that was
/// done.
struct SessionMark {
    enum class Kind {
        // By a person, who may remove them.
        picture,
        exported,
        check,
        camera,
        name,
        // What was done.
        stroke,
        tear,
        hand,    ///< a pull, hooks or pins
        scene,   ///< boxes, placements, exchanges, undo and restart
        change,  ///< of a parameter
    };

    int id = 0;  ///< for RemoveMark
    int step = 0;
    Kind kind = Kind::picture;
    /// The name of the file, what is checked ("2 pieces, state"), or what was done; none of a
    /// camera.
    std::string text;
};

/// The state of the timeline and the list of marks.
struct SessionPanelState {
    bool unsaved = false;  ///< something was done that no file has
    PlaybackState playback;
    /// Pictures, exports and checks of the session that would be saved now, by step.
    std::vector<SessionMark> marks;
    std::vector<SessionMark> past;  ///< what was done, by step
    PracticeState practice;
};

/// The state of time.
struct TransportState {
    bool playing = false;
    bool recording = false;
    bool seeking = false;   ///< steps are computed to go to another one
    bool pulling = false;   ///< a hand moves the body while time is paused
    bool stroking = false;  ///< the pointer draws a stroke, or poses of one are still to come
    double speed = 1;       ///< wanted, of simulated time against the clock
    /// Simulated seconds over seconds of the clock, lately; none before time ran.
    std::optional<double> realTimeFactor;
    int step = 0;
    double time = 0;         ///< simulated, since the last restart [s]
    bool restarted = false;  ///< there was one
};

/// One line of the log.
struct LogLine {
    std::string text;
    bool isError = false;
};

/// What the list of pieces shows.
struct PiecesState {
    std::vector<PieceRow> rows;
    int hovered = -1;   ///< of rows; -1 for none
    int selected = -1;  ///< likewise
};

/// What the plots show.
struct PlotsState {
    const History* history = nullptr;  ///< never null while panels are drawn
    std::optional<RunFigures> paper;   ///< of the open experiment, if in the paper
    PlotView view;
};

/// The world's axes in the view: x to the right, y up, z towards the viewer; unit.
struct ViewAxes {
    std::array<Vec3, 3> axes{Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
};

/// The content of the view besides the scene.
struct ViewState {
    Overlay overlay;  ///< of the coming cut
    ViewAxes axes;
    bool orthographic = false;
    std::vector<MeasureRow> measures;  ///< oldest first
    std::string device;                ///< what draws: "llvmpipe"
    std::string link;                  ///< "Link: 1 client on 127.0.0.1:18944"; empty if off
};

/// The content of all panels, a part for each: filled by the editor every frame, read only here.
struct PanelModel {
    std::string name;  ///< of the open document; empty for none
    ModelPanelState model;
    ParametersState parameters;
    BodyReport body;
    TransportState transport;
    ChangeList changes;
    ToolSettings tools;
    ViewState view;
    SessionPanelState session;
    DisplaySettings display;
    LooksState looks;
    HelpState help;
    WorkState work;
    FileDialogState files;
    Question question;
    ToastState toast;
    std::vector<LogLine> log;  ///< oldest first
    CutsState cuts;
    PiecesState pieces;
    std::vector<ExperimentCard> experiments;
    PlotsState plots;
    Settings settings;
};

}  // namespace kerf::ui
