#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/session/session.h"
#include "bench/lab/fem/solid_solver.h"
#include "sim/base/math.h"
#include "sim/base/params.h"
#include "sim/mesh/triangle_soup.h"

namespace kerf::app {

/// Poisson's ratio of the finite elements: Kerf's bodies have none, and keep their volume.
inline constexpr double kFemPoissonRatio = 0.45;

/// A body that is cut, held and loaded, for Kerf and for finite elements.
struct FemCase {
    std::string name;                  ///< of its folder: "bar-50"
    std::string body;                  ///< "notched bar"
    std::string cut;                   ///< "50 % deep"
    TriangleSoup model;                ///< that Kerf cuts, at rest [m]
    Params params;                     ///< at the start; without gravity
    std::vector<SessionEvent> events;  ///< pins, stroke, load
    int loaded = 0;                    ///< step from which on it may come to rest
    Vec3 pinned = Vec3::Zero();        ///< a point at rest, the vertex nearest to which is pinned
    /// What comes down, at rest; none where the opening counts alone, or the lowest point.
    std::optional<Bounds> probe;
    bool hangs = false;              ///< its lowest point is what comes down
    std::optional<double> cutPlane;  ///< x of the cut
    bool opens = false;              ///< whether the cut has lips that can be measured
    SolidProblem solid;              ///< the same as finite elements
    SolidProblem coarseSolid;        ///< with larger elements, to tell how far these can be trusted
};

/// A bar with notches of four depths, a slab that is drawn apart with an incision and without, a
/// ball that hangs whole and in half. In the order of the report.
std::vector<FemCase> femCases();
/// One of them. The name must be known.
FemCase femCase(const std::string& name);

}  // namespace kerf::app
