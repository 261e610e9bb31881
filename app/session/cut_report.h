#pragma once

#include <nlohmann/json_fwd.hpp>

#include "sim/mesh/surface_mesh.h"
#include "sim/mesh/triangle_quality.h"
#include "sim/run/parts/step_report.h"
#include "sim/run/simulation.h"

namespace kerf::app {

/// The quality of the cuts of one stroke, or of all, measured in the rest shape.
struct CutFigures {
    StrokeRecord steps;     ///< results of the steps
    ShapeFigures walls;     ///< walls, of both sides
    ShapeFigures skin;      ///< skin that was divided
    double woundArea = 0;   ///< of the walls, of both sides [m^2]
    int slitEdges = 0;      ///< edges at the ends of slits inside the material
    double slitLength = 0;  ///< of these edges [m]

    /// All triangles that were made.
    ShapeFigures triangles() const;
    /// The area of the wound over twice the area swept by the blade in the material at rest; none
    /// if it swept nothing.
    std::optional<double> woundToSwept() const;
};

/// Pairs of intersecting triangles, deeper than float rounding; those of cuts deeper than a
/// thousandth of an edge, since the sides of a wall may be divided differently.
struct CrossingPairs {
    int all = 0;
    int ofCuts = 0;  ///< of these: with a triangle made by a cut
};

/// The quality of all cuts of a body, by which methods are compared.
struct CutReport {
    CutFigures all;
    std::vector<CutFigures> strokes;  ///< of those that met the body, in their order
    /// The excess of the rest volume of all pieces and removed debris over that of the uncut body,
    /// as a share of it.
    double volumeError = 0;
    CrossingPairs crossings;  ///< of the rest shape
};

/// A body and its strokes, for reportOn().
struct CutBodyView {
    const SurfaceMesh& mesh;
    const SurfaceMesh& uncut;               ///< with the same slots
    std::span<const StrokeRecord> strokes;  ///< since it was whole
};

/// Measures the cuts of a body; none if no stroke met it. Reads only the rest shape. O(n log n).
std::optional<CutReport> reportOn(const CutBodyView& body);
/// Measures the cuts of the present body of a simulation.
std::optional<CutReport> reportOnCuts(const Simulation& simulation);

/// The number of pairs of the model's triangles that intersect at present, deeper than rounding,
/// and not at rest. O(n log n).
int countSkinCrossings(const SurfaceMesh& mesh, const SurfaceMesh& uncut);
/// "" or a sentence for people about such pairs, with what helps.
std::string remarkOnCrossings(Simulation& simulation);

/// `cut_report` of summary.json (docs/session-format.md).
nlohmann::ordered_json toJson(const CutReport& report);
/// The report in one line.
std::string describeCuts(const CutReport& report);

}  // namespace kerf::app
