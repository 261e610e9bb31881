#pragma once

#include "app/scene/document/editor_document.h"
#include "sim/mesh/triangle_quality.h"
#include "sim/run/simulation.h"

namespace kerf::app {

/// Figures of one model of an uncut body at rest.
struct ModelFigures {
    Bounds bounds;      ///< [m]
    double volume = 0;  ///< [m^3]
    TriangleFigures triangles;
};

/// The uncut body of a scene at rest, with its figures. A placement, or its undo, replaces it.
class RestOfBody {
  public:
    /// `simulation` is that of `document` at its start.
    RestOfBody(const Simulation& simulation, const Document& document);

    /// Takes the present uncut body, if it was replaced.
    void follow(const Simulation& simulation, const Document& document);

    const UncutBody& uncut() const { return *uncut_; }
    const Bounds& bounds() const { return bounds_; }  ///< [m]
    /// By the number of the model.
    const std::vector<ModelFigures>& models() const { return models_; }
    /// The view that shows it: the first one, or one like it after a placement.
    const render::Camera& homeView() const { return homeView_; }
    /// What that view has room for instead of the whole body: the lines of a task [m].
    const std::optional<Bounds>& lines() const { return lines_; }
    /// Grows when it is replaced.
    int revision() const { return revision_; }

  private:
    std::shared_ptr<const UncutBody> uncut_;
    Bounds bounds_;
    std::vector<ModelFigures> models_;
    render::Camera homeView_;
    std::optional<Bounds> lines_;
    int revision_ = 0;
};

}  // namespace kerf::app
