#pragma once

#include "sim/base/math.h"
#include "sim/cut/blade.h"

namespace kerf {

/// The size of the plate behind a blade's edge [m].
struct BladeSize {
    double width = 0;      ///< how far it reaches back from the edge AB
    double thickness = 0;  ///< of the plate, behind the bevel
};

/// The motion of a blade since it was placed, which determines the place of its body. The body
/// trails the edge like a towed point, as long as the edge moves ahead within 45 degrees; drawn
/// back or sideways, a blade of its whole width keeps its direction. The body is never wider than
/// the distance ahead so far, so it stays in what the edge has swept.
struct BladeTrail {
    Blade edge;
    Vec3 back = Vec3::Zero();  ///< from the edge to the back, unit, square to AB; zero at first
    double way = 0;            ///< ahead since it was placed, less that drawn back [m]
    double farthest = 0;       ///< the largest way so far [m]

    /// The present width.
    double widthOf(const BladeSize& size) const { return std::min(size.width, farthest); }
};

/// The trail after the edge has moved to `to`. `width`: of the whole body, at which it trails [m].
BladeTrail ledTo(const BladeTrail& trail, const Blade& to, double width);

/// Axes of a blade: the middle of its edge, and unit columns along AB, to the back, and across the
/// flat sides.
struct BladeFrame {
    Vec3 origin = Vec3::Zero();
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
    double halfLength = 0;  ///< of the edge [m]
};

/// The body of a blade during a time step. In the coordinates of its frames (along AB, to the back,
/// across) it is the points with |x| <= half length, front <= y <= back,
/// |z| <= half thickness * min(1, (y - front) / bevel).
struct BladeMotion {
    std::vector<BladeFrame> frames;  ///< between substeps, the first and the last included
    double front = 0;
    double back = 0;
    double bevel = 0;  ///< [m], > 0
    double halfThickness = 0;

    /// Half of the thickness at y [m].
    double halfAt(double y) const;
    /// y where the box of the plate begins: behind the bevel, if that leaves much of it.
    double shoulder() const;
    /// The middle of that box, as a mean over the step.
    Vec3 middle() const;
    /// Around all frames [m].
    Bounds bounds() const;
};

/// The body of a blade that passes `trails` (at least one) evenly in a time step of `substeps`. It
/// begins `front` behind the edge, and its bevel is at least `leastBevel` long [m].
BladeMotion motionOf(std::span<const BladeTrail> trails, const BladeSize& size, double front,
                     double leastBevel, int substeps);

/// Share of the width that is ground.
inline constexpr double kBladeBevel = 0.3;

/// The mean load of a body on the blade over a time step.
struct BladeLoad {
    Vec3 force = Vec3::Zero();  ///< [N]
    /// About the middle of the plate behind the bevel; without a plate, of the commanded edge [N
    /// m].
    Vec3 moment = Vec3::Zero();
};

/// The resistance of the material against the edge after a time step, with `blade_feels`.
struct HeldEdge {
    double lag = 0;     ///< mean lag of the edge behind its command [m]
    double energy = 0;  ///< in the spring between both [J]
    double work = 0;    ///< of the blade in the step, against the edge only [J]
};

}  // namespace kerf
