#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "app/files/import/own_looks.h"
#include "render/scene/skin_paint.h"
#include "sim/mesh/triangle.h"
#include "sim/run/simulation.h"

namespace kerf::app {

/// Paints a body with its model's own colours and follows whatever changes its triangles: cuts,
/// undo, placements. What has not changed is not looked for again.
class SkinFollower {
  public:
    /// The looks of the uncut body, which must stay.
    explicit SkinFollower(const OwnLooks& looks) : looks_(looks) {}

    /// The paint for the body as it is, where Simulation::isWhole(); null where the model has no
    /// colours.
    std::shared_ptr<const render::SkinPaint> paintOf(const Simulation& simulation);

  private:
    /// What a triangle of skin had, and where its corners rested then.
    struct Known {
        Corners corners;
        TriangleAttributes attributes;
    };
    void beginWith(const std::shared_ptr<const UncutBody>& uncut);
    std::vector<render::PaintedTriangle> follow(const BodyModel& model);
    const TriangleAttributes& attributesOf(int slot, const Corners& corners);

    const OwnLooks& looks_;
    std::shared_ptr<const UncutBody> uncut_;  ///< that `carrier_` looks at
    std::optional<SkinCarrier> carrier_;
    std::vector<std::optional<Known>> known_;  ///< by slot of the mesh
    int revision_ = -1;                        ///< of the model that `paint_` is for
    std::shared_ptr<const render::SkinPaint> paint_;
};

}  // namespace kerf::app
