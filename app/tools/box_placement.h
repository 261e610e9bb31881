#pragma once

#include "app/tools/view_frame.h"
#include "sim/contact/static_box.h"
#include "ui/base/layout.h"

namespace kerf::app {

/// A cube of a third of the body's size beside it, on the floor or level with its underside.
/// `body` are its bounds, `floor` is a height, `direction` is horizontal [m].
StaticBox boxBeside(const Bounds& body, std::optional<double> floor,
                    const Vec3& direction = Vec3::UnitX());

/// Such a cube on the side of the body where it is most visible: whole in the area free of panels
/// [px], and beside the body rather than before or behind it.
StaticBox boxInView(const Bounds& body, std::optional<double> floor, const ViewFrame& view,
                    const ui::Rect& free);

/// Whether a box is entirely visible there [px].
bool isInView(const StaticBox& box, const ViewFrame& view, const ui::Rect& free);

/// The box between two points of the view: across the axis nearest to the line of sight it is in
/// the plane through the middle of `body`, along that axis it spans all of `body`.
Bounds boxBetween(const ViewFrame& view, const Vec2& from, const Vec2& to, const Bounds& body);

}  // namespace kerf::app
