#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/model_source.h"
#include "render/camera.h"
#include "sim/command.h"
#include "sim/params.h"

namespace kerf::app {

/// Scale, then rotate (XYZ Euler, degrees), then translate.
struct Placement {
    double scale = 1;
    Vec3 rotate = Vec3::Zero();
    Vec3 translate = Vec3::Zero();
};

struct ModelReference {
    std::string builtin;         ///< or
    std::filesystem::path path;  ///< absolute once read
    std::string sha256;          ///< optional
};

struct ScreenshotEvent {
    std::string file;
    int width = 1280;
    int height = 720;
};
struct ExportEvent {
    std::string file;
};
struct CheckEvent {
    std::optional<std::string> hash;
    std::optional<int> pieces;
};

/// A blade event is a key pose: between two of them the ends move linearly, a quad per step.
using SessionAction =
    std::variant<MoveBlade, LiftBlade, SetParam, ScreenshotEvent, ExportEvent, CheckEvent>;

struct SessionEvent {
    int step = 0;
    SessionAction action;
};

/// A *.kerf.json file: start state, commands, checks. See docs/session-format.md.
struct Session {
    ModelReference model;
    Placement placement;
    Params params;
    int steps = 0;
    std::vector<SessionEvent> events;  ///< by step, the file's order within one
    std::optional<render::Camera> view;
    std::vector<std::string> warnings;  ///< unknown extra keys
};

/// Reads and checks a session. Throws InputError naming the place in the file
/// ("events[3].a: expected three numbers").
Session readSession(const std::filesystem::path& file);
Session parseSession(const std::string& text, const std::filesystem::path& baseFolder);
/// Text of a session file; throws InputError rather than write a number that is not finite.
std::string formatSession(const Session& session);

/// The model of a session, placed in the world.
SurfaceMesh loadSessionModel(const Session& session);

/// The commands of one step, blade poses interpolated between key poses. `cursor` style: call with
/// rising steps.
class SessionPlayer {
  public:
    explicit SessionPlayer(const Session& session);
    /// Everything that happens before step `step`, in order, the interpolated blade pose included.
    std::vector<SessionAction> actionsAt(int step) const;

  private:
    const Session* session_;
};

}  // namespace kerf::app
