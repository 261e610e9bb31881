#pragma once

#include "app/scene/readout/cut_preview.h"

namespace kerf::app {

/// A place at which the two lips of a cut face each other.
struct Incision {
    std::array<Vec3, 2> lips;     ///< points of the skin beside the cut [m]
    Vec3 across = Vec3::UnitX();  ///< unit: from the first lip to the second, along the skin
    double away = 0;              ///< distance of the rim of the first lip [m]
    double gap = 0;               ///< between the two rims, across [m]
    double length = 0;            ///< of the cut in the skin: diagonal of the box around it [m]
    double edgeLength = 0;        ///< of the skin there, mean [m]
};

/// The place of a cut nearest to a point of the surface, with the lip of that point first. None if
/// no cut is within `reach` [m]. O(triangles).
std::optional<Incision> incisionNear(const SurfaceMesh& mesh, const Vec3& point, double reach);

/// The radius of hooks that hold such lips [m].
double hookRadius(const Incision& incision);

/// The radius of a hand at a point [m]: `wanted`, or less if a piece or a lip there is small.
/// `piece` is the box around the piece. O(triangles).
double handRadius(const SurfaceMesh& mesh, const Vec3& point, double wanted, const Bounds& piece);

}  // namespace kerf::app
