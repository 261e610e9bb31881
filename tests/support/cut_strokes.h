#pragma once

#include "sim/cut/stroke/cutter.h"
#include "sim/mesh/invariants.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::test {

/// The positions of a blade over one stroke, the first where it is put down.
using Stroke = std::vector<Blade>;

/// A blade of length `length` along `along` that travels `distance` in direction `travel`, at the
/// middle of its way through `center`.
Stroke straightStroke(const Vec3& center, const Vec3& along, const Vec3& travel, double length,
                      double distance, int steps);

/// For positions that stay doubles between steps.
CutSettings exactSettings();

/// How many triangles there are, and how many of them are slivers: quality is height over longest
/// edge.
struct SliverCount {
    int triangles = 0;
    int below002 = 0;   ///< quality below 0.02
    int below0001 = 0;  ///< quality below 0.001
    void add(const SliverCount& other);
};

/// The new triangles of a stroke.
struct StrokeQuality {
    SliverCount skin;
    SliverCount walls;
    void add(const StrokeQuality& other);
    SliverCount all() const;
};

/// Counts the living ones of `triangles`, at current positions.
StrokeQuality qualityOf(const SurfaceMesh& mesh, const std::vector<int>& triangles);

/// What a stroke did, and the first invariant that broke ("" while all hold).
struct CutCheck {
    int steps = 0;
    int cuts = 0;
    int refused = 0;
    int retried = 0;
    int resumed = 0;
    int tries = 0;
    CleanupStatistics cleanup;  ///< of the whole stroke
    double volumeChange = 0;    ///< by steps and clean-up of the stroke, relative, the larger of
                                ///< current and rest
    StrokeQuality quality;      ///< of all triangles that it added or changed
    std::string problem;
    std::string unmirrored;  ///< checkMirroredWalls after the stroke
    std::string reason;      ///< of the last refusal
};

/// Runs between two steps, before the blade moves: deforms the mesh, rounds positions.
using BetweenSteps = std::function<void(SurfaceMesh&, int step)>;

/// Runs one stroke with `cutter` and checks every step: closed 2-manifold, volume and rest volume
/// unchanged (relative 1e-9 and what the clean-up admits), front edges there and unsplit, the delta
/// names every triangle at a new, moved or dead vertex, a step with an empty delta leaves every
/// byte, pieces never join, and the clean-up alone changes no number of pieces.
CutCheck runStroke(Cutter& cutter, SurfaceMesh& mesh, const Stroke& stroke,
                   const BetweenSteps& between = {});
CutCheck runStroke(SurfaceMesh& mesh, const CutSettings& settings, const Stroke& stroke);
/// Leads the blade along a stroke to its end; `see` is given the result of each step.
template <class See>
void eachStep(Cutter& cutter, const Stroke& stroke, See&& see) {
    cutter.begin(stroke.front());
    for (std::size_t i = 1; i < stroke.size(); ++i) {
        see(cutter.advance(stroke[i]));
    }
    see(cutter.finish());
}
/// All invariants held, and no step was refused.
void expectSound(const CutCheck& check);

/// Everything that a mesh holds, as text of bytes: equal exactly where the meshes are.
std::string fingerprint(const SurfaceMesh& mesh);

/// (I7) "" where every wall triangle has its mirror on the other side, compared by groups of
/// copies.
std::string checkMirroredWalls(const SurfaceMesh& mesh);
/// (I5) "" where every attached edge of the rung is an edge of the mesh between two walls.
std::string checkFront(const SurfaceMesh& mesh, const std::vector<RungNode>& rung);
/// Half-edges between the two walls of one stroke, on W+: the ends of slits inside the body.
std::vector<int> slitHalfEdges(const SurfaceMesh& mesh, int stroke);
int slitEdges(const SurfaceMesh& mesh, int stroke);
/// How many pieces there are.
int piecesOf(const SurfaceMesh& mesh);
/// Pieces with vertices farther than `distance` [m] from what the blade swept on both of its sides:
/// a stroke right through leaves none.
int piecesOnBothSides(const SurfaceMesh& mesh, const Stroke& stroke, double distance);
/// Ends of slits of all strokes that lie apart from the front of `rung`.
std::vector<int> strayedHalfEdges(const SurfaceMesh& mesh, const std::vector<RungNode>& rung);

struct HalfSpaceVolumes {
    double above = 0;
    double below = 0;
};
/// Volumes of the mesh on both sides of a plane, from clipped triangles (independent of the
/// cutter).
HalfSpaceVolumes clipVolumes(const SurfaceMesh& mesh, const Vec3& point, const Vec3& normal);
/// Mean signed distance of a piece's vertices to the plane.
double meanSide(const SurfaceMesh& mesh, const PieceMap& map, int piece, const Vec3& point,
                const Vec3& normal);

}  // namespace kerf::test
