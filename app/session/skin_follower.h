#pragma once

#include "app/files/import/own_looks.h"
#include "render/scene/skin_paint.h"
#include "sim/mesh/triangle.h"
#include "sim/run/simulation.h"

namespace kerf::app {

/// Paints a body with its model's own colours and follows changes of its triangles: cuts, undo,
/// placements. Unchanged ones are reused.
class SkinFollower {
  public:
    /// The looks of the uncut body, which must outlive it.
    explicit SkinFollower(const OwnLooks& looks) : looks_(looks) {}

    /// The paint for the present body, if Simulation::isWhole(); null if the model has no colours.
    std::shared_ptr<const render::SkinPaint> paintOf(const Simulation& simulation);

  private:
    /// The attributes of a triangle of skin, and its corners at rest then.
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
