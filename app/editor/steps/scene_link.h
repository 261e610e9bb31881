#pragma once

#include "app/editor/steps/scene_at_work.h"
#include "app/link/blade_link.h"

namespace kerf::app {

/// Clients that lead the blade of the open scene, as the pointer does, and are told of its body
/// (docs/link.md).
class SceneLink {
  public:
    /// It will listen at "[ADDRESS:]PORT".
    explicit SceneLink(std::string address) : address_(std::move(address)) {}

    /// Listens, for this scene. Throws InputError if it can't.
    void start(EditorScene& scene);
    /// Disconnects all clients.
    void stop();
    bool isOn() const { return server_.has_value(); }
    /// Leads another scene from now on, if it is on.
    void begin(EditorScene& scene);
    /// Whether a client leads the blade of the scene, so that other strokes wait.
    bool leads(const BusyScene& scene);
    /// Does what has come since the last call, and tells the clients of the body. Returns whether
    /// state() has changed.
    bool follow(EditorScene& scene);
    /// "Link: 1 client on 127.0.0.1:18944"; empty if it is off.
    std::string state() const;
    /// From one call of follow() to the next, where nothing else is to be done [s].
    double pause() const;

  private:
    void lead(const Command& command, EditorScene& scene);

    std::string address_;
    std::optional<LinkServer> server_;
    std::optional<BladeLink> blade_;
    bool leads_ = false;  ///< unless the stroke was cancelled since
};

}  // namespace kerf::app
