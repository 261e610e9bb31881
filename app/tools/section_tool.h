#pragma once

#include "app/tools/view_frame.h"
#include "render/scene/overlays.h"

namespace kerf::app {

/// The plane through the middle of `bounds`, across the axis that points most to the eye: the half
/// in front of it is hidden.
render::SectionPlane sectionAcross(const Bounds& bounds, const render::Camera& camera);

/// Poses a section plane by two handles in the view: the middle one shifts it along its normal, the
/// one at the tip of its normal turns it.
class SectionTool {
  public:
    enum Handle { middle, tip };
    static constexpr int kHandles = 2;

    /// Grabs a handle at a pixel. False if there is none; `bounds` are those of the body.
    bool press(const ViewFrame& view, const Vec2& pixel, const render::SectionPlane& plane,
               const Bounds& bounds);
    /// The plane moved with the held handle.
    render::SectionPlane moved(const ViewFrame& view, const Vec2& pixel, render::SectionPlane plane,
                               const Bounds& bounds);
    void release() { held_.reset(); }
    bool holds() const { return held_.has_value(); }

    /// Adds the outline of the plane and its handles.
    void addTo(ui::Overlay& overlay, const ViewFrame& view, const Vec2& pixel,
               const render::SectionPlane& plane, const Bounds& bounds) const;

    /// Positions of the handles [m].
    static std::array<Vec3, kHandles> handles(const render::SectionPlane& plane,
                                              const Bounds& bounds);

  private:
    double shiftTo(const ViewFrame& view, const Vec2& pixel, const render::SectionPlane& plane,
                   const Bounds& bounds) const;

    std::optional<int> held_;   ///< a Handle
    Vec2 last_ = Vec2::Zero();  ///< where the pointer was [px]
};

}  // namespace kerf::app
