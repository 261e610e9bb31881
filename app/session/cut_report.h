#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sim/mesh/surface_mesh.h"
#include "sim/mesh/triangle_quality.h"
#include "sim/run/parts/stroke_record.h"
#include "sim/run/simulation.h"

namespace kerf::app {

/// How well cuts came out: those of one stroke, or of all. What is measured is the rest shape, so
/// it does not matter how the body lies.
struct CutFigures {
    StrokeRecord steps;     ///< what the steps did
    ShapeFigures walls;     ///< walls, of both sides
    ShapeFigures skin;      ///< skin that was divided
    double woundArea = 0;   ///< of the walls, of both sides [m^2]
    int slitEdges = 0;      ///< edges along which a slit ends inside of the material
    double slitLength = 0;  ///< of these edges [m]

    /// All triangles that were made.
    ShapeFigures triangles() const;
    /// The area of the wound against twice the area that the blade swept in the material at rest;
    /// none where it swept nothing.
    std::optional<double> woundToSwept() const;
};

/// Pairs of triangles that pass through each other, deeper than floats round coordinates; those of
/// cuts deeper than a thousandth of an edge, as the sides of a wall may be divided differently.
struct CrossingPairs {
    int all = 0;
    int ofCuts = 0;  ///< of these: a cut has made one of the two, at least
};

/// The quality of all cuts of a body, by which methods are compared.
struct CutReport {
    CutFigures all;
    std::vector<CutFigures> strokes;  ///< of those that met the body, in their order
    /// By how much the rest volume of all pieces, with the debris that was removed, is more than
    /// that of the uncut body, as a share of it.
    double volumeError = 0;
    CrossingPairs crossings;  ///< of the rest shape
};

/// A body and how it was cut, for reportOn().
struct CutBodyView {
    const SurfaceMesh& mesh;
    const SurfaceMesh& uncut;               ///< with the same slots
    std::span<const StrokeRecord> strokes;  ///< since it was whole
};

/// Measures what the strokes made of a body; none where none of them met it. Reads the rest shape
/// alone. O(n log n).
std::optional<CutReport> reportOn(const CutBodyView& body);
/// Measures the cuts of the body of a simulation as it is.
std::optional<CutReport> reportOnCuts(const Simulation& simulation);

/// Pairs of triangles of the model that pass through each other as the body lies now, deeper than
/// rounding, and do not at rest. O(n log n).
int countSkinCrossings(const SurfaceMesh& mesh, const SurfaceMesh& uncut);
/// "" or a sentence for people about such pairs, with what helps.
std::string remarkOnCrossings(Simulation& simulation);

/// `cut_report` of summary.json (docs/session-format.md).
nlohmann::ordered_json toJson(const CutReport& report);
/// The report in one line.
std::string describeCuts(const CutReport& report);

}  // namespace kerf::app
