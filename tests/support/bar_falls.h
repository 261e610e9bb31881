#pragma once

#include "sim/base/params.h"
#include "sim/contact/static_box.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::test {

/// A body falls on a level bar of square section, much longer than itself.
struct BarFall {
    std::string model = "sphere768";  ///< see builtin()
    double width = 0.01;              ///< of the bar [m]
    double modulus = 1e4;             ///< Young's [Pa]
    double height = 1;                ///< of the fall [m]
    double roll = 0;                  ///< of the bar about itself [degrees]
    double aside = 0.03;              ///< of the body's middle from the bar's [m]
    std::optional<double> floor;      ///< height against the bar's middle; none [m]
    double seconds = 1.2;             ///< from the touch on
};

struct BarFigures {
    int steps = 0;
    int pierced = 0;         ///< steps after which some of the bar's middle line was in the body
    double longest = 0;      ///< the most of it that was [m]
    double longestLast = 0;  ///< the same at the end [m]
    double leastVolume = 1;  ///< share of rest
    double lastVolume = 1;
    double fastest = 0;  ///< vertex after the touch [m/s]
};

/// How much of the line along the middle of a bar's longest axis lies inside a closed mesh [m].
double lengthInside(const SurfaceMesh& mesh, const StaticBox& bar);

/// Plays it with a Simulation on the GL context that is current.
BarFigures fallOnBar(const BarFall& fall, Params params);
std::string text(const BarFigures& figures);

}  // namespace kerf::test
