#pragma once

#include "app/files/export/mesh_formats.h"
#include "app/files/import/model_faults.h"
#include "app/practice/task.h"
#include "render/scene/body_look.h"
#include "render/scene/camera.h"
#include "sim/base/params.h"
#include "sim/base/placement.h"
#include "sim/run/parts/command.h"

namespace kerf {

class SurfaceMesh;
}

namespace kerf::app {

struct ModelMesh;
struct ReadOptions;

/// Limits of a session file; beyond them it is refused.
inline constexpr std::uintmax_t kMaxSessionBytes = 64u << 20;
inline constexpr int kMaxSteps = 1'000'000;
inline constexpr int kMaxPictureSize = 8192;          ///< [pixels], each way
inline constexpr double kMaxSessionCoordinate = 1e8;  ///< [m]

/// Files that every replay writes into its output folder; a session's own ones have other names.
inline constexpr const char* kMetricsFile = "metrics.csv";
inline constexpr const char* kSummaryFile = "summary.json";
inline constexpr const char* kMeshFile = "final.ply";
/// Files that a replay writes only on request.
inline constexpr const char* kHashesFile = "hashes.csv";
inline constexpr const char* kPiecesFile = "pieces.csv";
/// All of them.
inline constexpr std::array kReplayFiles{kMetricsFile, kSummaryFile, kMeshFile, kHashesFile,
                                         kPiecesFile};

/// Moves a mesh at rest: positions and rest positions.
void place(SurfaceMesh& mesh, const Placement& placement);

/// The model of a session, and its repairs before it is cut.
struct ModelReference : Mending {
    std::string builtin;                       ///< name of a builtin model, or
    std::filesystem::path path;                ///< absolute once read
    std::string sha256;                        ///< optional
    std::optional<int> object = std::nullopt;  ///< see ReadOptions

    /// The file that holds the model. Throws InputError for an unknown builtin name.
    std::filesystem::path file() const;
    /// Its display name: the builtin's, or the file's without its extension.
    std::string name() const;
};

/// A model of a scene after the first.
struct FurtherModel {
    ModelReference model;
    Placement placement;
    std::optional<Vec3> color;  ///< of its skin if the file has none, in display colours
};

/// A PNG of the scene before the step. `file` is relative to the output folder.
struct ScreenshotEvent {
    std::string file;
    int width = 1280;  ///< [pixels]
    int height = 720;  ///< [pixels]
};
/// The mesh before the step: a file of meshFormats() below the output folder.
struct ExportEvent {
    std::string file;
    bool filePerPiece = false;               ///< see pieceFile()
    std::optional<Coordinates> coordinates;  ///< see coordinatesOf()
};
/// The coordinates of an export. By default the model's own if its placement has a unit, else those
/// of the scene, as in sessions before there were units.
Coordinates coordinatesOf(const ExportEvent& event, const Placement& placement);

/// A check of the state before the step: what is set must hold.
struct CheckEvent {
    std::optional<std::string> hash;
    std::optional<int> pieces;
};

/// A camera key of films and strips: see CameraPath. Screenshots keep the view.
struct CameraEvent {
    render::Camera camera;
};

/// A name for a place on the time line. Replays ignore it.
struct MarkEvent {
    std::string name;
};

/// A variant with more alternatives behind its own.
template <class Variant, class... More>
struct Extended;
template <class... Kinds, class... More>
struct Extended<std::variant<Kinds...>, More...> {
    using Type = std::variant<Kinds..., More...>;
};

/// The action of a session event: a command, or one that changes no simulation. A blade event is a
/// key pose: between two of them the ends move linearly, a quad per step. So do hands from their
/// grab or drag to their next drag. See event_table.h for their fields.
using SessionAction =
    Extended<Command, ScreenshotEvent, ExportEvent, CheckEvent, CameraEvent, MarkEvent>::Type;

/// Something that happens before a step.
struct SessionEvent {
    int step = 0;  ///< applied before this step; equal to Session::steps: after the last one
    SessionAction action;
    int number = -1;  ///< in the file's list, from 0; -1 without a file
};

/// How the editor shows a piece.
struct ShownPiece {
    bool hidden = false;
    std::optional<Vec3> color;  ///< in display colours, instead of its look
    bool operator==(const ShownPiece&) const = default;
};

/// What the editor showed when it saved a session. Replays ignore it.
struct SavedView {
    render::Camera camera;
    std::string tool;   ///< the name of a ui::ToolRow; an unknown one is ignored
    std::string field;  ///< the name of a render::FieldInfo; an unknown one is ignored
    bool wireframe = false;
    double apart = 0;  ///< see ui::DisplaySettings
    std::optional<render::SectionPlane> section;
    std::vector<ShownPiece> pieces;  ///< the first ones; the others look as always
};

/// How the names of session files end.
inline constexpr std::string_view kSessionEnding = ".kerf.json";

/// A *.kerf.json file: start state, commands, checks. See docs/session-format.md.
struct Session {
    std::string fileName;  ///< without its folder, for errors; empty without a file
    /// The origin of its positions [m]; 0 when read and written: see withOrigin().
    Vec3 origin = Vec3::Zero();
    ModelReference model;
    Placement placement;
    std::vector<FurtherModel> moreModels;  ///< models 1, 2, ... of the scene
    /// The built-in material with its values and look at the start; empty: none.
    std::string material;
    Params params;
    std::vector<StaticBox> boxes;  ///< at the start
    std::optional<Task> task;      ///< to practise; a session in which it was done is a try
    int steps = 0;
    std::vector<SessionEvent> events;  ///< by step, the file's order within one
    std::optional<render::Camera> view;
    render::ChosenColors colors;        ///< of the view, with the look, instead of the model's own
    std::optional<SavedView> editor;    ///< for reopening it
    std::vector<std::string> warnings;  ///< unknown extra keys, files of one name
};

/// Removes one of the further models from the scene, with its own parameters; those behind it move
/// up.
void takeModelOut(Session& session, int model);

/// The command of an action; none if it changes no simulation.
std::optional<Command> commandOf(const SessionAction& action);
/// The files of its models, the first one's first.
std::vector<std::filesystem::path> modelFiles(const Session& session);
/// The file below the output folder that an action writes; null for none.
const std::string* fileOf(const SessionAction& action);
/// The files of its screenshot events, each once.
std::vector<std::string> pictureFiles(const Session& session);
/// Whether an action restarts the body, so that no hand holds it any more.
bool startsAnew(const SessionAction& action);
/// Whether an action removes the blade, so that the next pose places it again.
bool takesBladeAway(const SessionAction& action);

/// The undo memory of a replay [bytes]: a run made within the editor's budget must not fail.
inline constexpr std::size_t kReplayUndoBudget = std::size_t{4} << 30;
/// The length of its first blade [m]; none without one.
std::optional<double> bladeLengthOf(const Session& session);
/// Whether a session has undo events, so that changes must be kept.
bool undoesAnything(const Session& session);

/// Reads and checks a session. Throws InputError naming the file and the place in it
/// ("first-cut.kerf.json: events[3].a: expected three numbers.").
Session readSession(const std::filesystem::path& file);
/// Reads and checks the text of a session, whose model paths are relative to `baseFolder`. Throws
/// InputError naming the place in it.
Session parseSession(const std::string& text, const std::filesystem::path& baseFolder);
/// Reads a single event of a session, without its step: {"type": "lift"}. Unknown extra keys go to
/// `warnings`. Throws InputError naming the type and the key ("grab.radius: expected a number
/// (1e-09 to 1e+06).").
SessionAction parseAction(const std::string& text, std::vector<std::string>& warnings);
/// Reads the camera of a single `view`, which must have no colours. Throws InputError ("view.eye:
/// expected three numbers.").
render::Camera parseCamera(const std::string& text, std::vector<std::string>& warnings);
/// Sets a parameter to a value written as in a session: 0.5, [0, -9.81, 0], null, "pbd". A bare
/// word is a text. Throws InputError, naming the parameter, without a change.
void setParamFromText(Params& params, const std::string& name, const std::string& value);
/// Throws InputError if a parameter at the start belongs to a missing model.
void requireModelsOfParams(const Session& session);
/// Text of a session file in `baseFolder` (if given, model paths become relative to it). Throws
/// InputError rather than write what parseSession() would refuse.
std::string formatSession(const Session& session, const std::filesystem::path& baseFolder = {});

/// An event as in the list of a session file, on one line. Throws InputError like formatSession().
std::string formatEvent(const SessionEvent& event);

/// The placed models of a session, as one mesh, relative to ModelMesh::origin. Throws InputError,
/// also if a sha256 differs, or a model is too small, or too far from the others, for floats.
ModelMesh loadSessionModel(const Session& session, const ReadOptions& options);
ModelMesh loadSessionModel(const Session& session);

/// The session's view, or the default one: from the front right above, with `bounds` in the middle
/// and room for falling pieces.
render::Camera sessionCamera(const Session& session, const Bounds& bounds);

/// The camera path of films and strips, from the session's camera events; empty without any.
render::CameraPath cameraPathOf(const Session& session);

/// An action of a session before a step.
struct PlayedAction {
    SessionAction action;
    int number = -1;  ///< SessionEvent::number; between two key poses, that of the later one
};

/// The commands of one step, blade poses interpolated between key poses.
class SessionSchedule {
  public:
    /// The session must outlive the schedule.
    explicit SessionSchedule(const Session& session);
    /// All actions before step `step`, in order; between two key poses the blade's pose comes last.
    /// `step` equal to session.steps: after the run.
    std::vector<PlayedAction> actionsAt(int step) const;
    /// The poses among them between two key poses: first the blade's, then those of hands.
    std::vector<PlayedAction> posesBetweenKeys(int step) const;

  private:
    /// The blade, or a hand, moves from one key pose to the next.
    struct KeyMove {
        int firstStep = 0;
        int lastStep = 0;
        int number = -1;                                ///< of the later key pose
        std::function<SessionAction(double share)> at;  ///< the pose after a share of the way
    };
    void collectBladeMoves();
    void collectHandMoves();

    const Session* session_;
    std::vector<KeyMove> moves_;  ///< the blade's first
};

/// A change of the events of a session being made, with positions as in its file.
struct SessionChange {
    std::size_t from = 0;  ///< number of unchanged entries
    /// All behind those. None for an entry that is not saved.
    std::vector<std::optional<SessionEvent>> events;
    int steps = 0;  ///< of the present session
};

}  // namespace kerf::app
