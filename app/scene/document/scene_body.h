#pragma once

#include "app/scene/document/rest_of_body.h"
#include "app/session/simulation_driver.h"
#include "sim/run/start/prepared_body.h"
#include "ui/state/action.h"

namespace kerf::app {

/// A document and its running body.
struct SceneBody {
    /// `upload` is the body of `document`. Throws gpu::OutOfMemory.
    SceneBody(Document opened, BodyUpload upload);
    SceneBody(const SceneBody&) = delete;
    SceneBody& operator=(const SceneBody&) = delete;

    Document document;
    Simulation simulation;
    RestOfBody rest;
    SimulationDriver driver{simulation};
    std::vector<std::string> messages;  ///< for the person, besides those of the simulation

    /// Updates the figures of the uncut body after a placement.
    void followPlacement() { rest.follow(simulation, document); }
    /// The command for a new placement of a model, see EditorScene::place().
    Place placeCommand(const Placement& wanted, bool continues, int model) const;
    /// The placed models, the parameters and the boxes, as a session without events.
    Session start() const;
    /// The edge length to propose for a model, in the unit of its file.
    double proposedEdge(int model) const;
    /// What gives the largest model about so many triangles.
    ui::Remesh coarser(int triangles) const;
};

}  // namespace kerf::app
