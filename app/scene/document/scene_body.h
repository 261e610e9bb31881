#pragma once

#include <string>
#include <vector>

#include "app/scene/document/rest_of_body.h"
#include "app/session/session_runner.h"
#include "sim/run/start/body_upload.h"

namespace kerf::app {

/// A document and its body as it runs.
struct SceneBody {
    /// `upload` is the body of `document`. Throws gpu::OutOfMemory.
    SceneBody(Document opened, BodyUpload upload);
    SceneBody(const SceneBody&) = delete;
    SceneBody& operator=(const SceneBody&) = delete;

    Document document;
    Simulation simulation;
    RestOfBody rest;
    SessionRunner runner{simulation};
    std::vector<std::string> messages;  ///< for the person, besides those of the simulation

    /// What was told of the uncut body is told of the one that there is now.
    void followPlacement() { rest.follow(simulation, document); }
    /// The command that places a model otherwise, see EditorScene::place().
    Place placeCommand(const Placement& wanted, bool continues, int model) const;
    /// The models as they lie at rest, the parameters and the boxes, as a session without events.
    Session start() const;
    /// The edge length to propose for a model, in the unit of its file.
    double proposedEdge(int model) const;
};

}  // namespace kerf::app
