#pragma once

#include "sim/base/params.h"
#include "sim/mesh/triangle_soup.h"

namespace kerf::test {

/// A body of walls of one thickness, with a diagonal of 0.1 m around the origin: "plate", "tube",
/// "cup", "fins" or "shell" (with a cavity). `wall`: their thickness as a share of the diagonal.
TriangleSoup thinSoup(const std::string& shape, double wall);

/// A body of thin walls that is cut while it is held, and then left to itself.
struct WallScene {
    std::string shape;
    double wall = 0.1;   ///< share of the diagonal
    std::string cut;     ///< "slanted", "flush" (along a face of a wall) or "twice"
    std::string motion;  ///< "rests", "falls" or "drawn"
    double timeStep = 0.005;
    double seconds = 0.3;  ///< after the cut
};

/// All scenes of the neighbourhood, or every `nth`.
std::vector<WallScene> wallScenes(int nth = 1);

struct WallFigures {
    int pieces = 0;
    int triangles = 0;
    double leastVolume = 1;  ///< in any step, as a share of the uncut body's
    double mostVolume = 1;
    // Pairs of triangles that pass through each other, the most in a look every 20 ms, less those
    // after the cut.
    int crossings = 0;      ///< deeper than floats round, of walls than a thousandth of an edge
    int deepCrossings = 0;  ///< deeper than a twentieth of the wall
    bool closed = true;
    int messages = 0;
    double wallTime = 0;  ///< [s]

    /// Whether the volume kept within 2 %, and nothing crosses deeply that did not after the cut.
    bool isRight() const;
};
WallFigures playWalls(const WallScene& scene, Params params);

std::string text(const WallScene& scene);
std::string text(const WallFigures& figures);

}  // namespace kerf::test
