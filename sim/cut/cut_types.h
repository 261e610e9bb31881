#pragma once

#include "sim/base/math.h"
#include "sim/base/params.h"

namespace kerf {

/// How a triangle was divided: the four patterns of the paper (its Figure 4), and others.
enum class SubdivisionPattern {
    oneToFour,    ///< the cut ends inside: one edge node, one inner node, four triangles
    oneToThreeA,  ///< two edge nodes, three triangles
    oneToTwo,     ///< from a vertex to the opposite edge, two triangles
    oneToThreeB,  ///< from a vertex to an inner node, three triangles
    twoKinks,     ///< the curve starts and ends inside the triangle
    twoSegments,  ///< two segments of curves
    more          ///< any other way
};
/// The number of enumerators of SubdivisionPattern.
inline constexpr int kSubdivisionPatterns = 7;
/// How many of them, the first ones, are the paper's.
inline constexpr int kPaperPatterns = 4;

/// The number of divided triangles, by SubdivisionPattern.
using SubdivisionCounts = std::array<int, kSubdivisionPatterns>;

/// The name of a pattern: "1-to-4", "1-to-3a", "1-to-2", "1-to-3b" as in the paper; "two kinks",
/// "two segments", "more".
const char* nameOf(SubdivisionPattern pattern);

/// Adds `part` to `sum`, pattern by pattern.
void addTo(SubdivisionCounts& sum, const SubdivisionCounts& part);
/// The number of triangles with a pattern other than the paper's four.
int otherPatterns(const SubdivisionCounts& counts);

/// The outcome of one step. Only `cut` changes the mesh. The end of a stroke may clean up in any
/// outcome; see the delta.
enum class CutOutcome {
    air,          ///< the blade swept no material
    waiting,      ///< it moved less than the gate; the next step starts from the same rung
    withdrawing,  ///< it moves backwards inside its own slit
    cut,          ///< the mesh was cut
    refused,      ///< no valid result was found; `reason` says why, the next step reaches farther
};

/// The change of the mesh: all that the solver, the attributes and the GPU need.
struct CutDelta {
    std::vector<int> removedTriangles;  ///< slots that are dead now
    std::vector<int> addedTriangles;    ///< new slots
    /// Living old triangles with another vertex or a moved one as a corner.
    std::vector<int> changedTriangles;
    /// Vertices from this index to mesh.vertexCount() are new; some may have no triangle.
    int firstNewVertex = 0;
    /// Living old vertices whose position, rest position or velocity the clean-up changed.
    std::vector<int> movedVertices;
    /// Old vertices that the clean-up removed from all triangles.
    std::vector<int> deadVertices;

    /// Whether no triangle changed.
    bool empty() const {
        return removedTriangles.empty() && addedTriangles.empty() && changedTriangles.empty();
    }
};

/// Counts of the clean-up of slivers.
struct CleanupStatistics {
    int collapses = 0;  ///< collapsed edges, all copies of an edge counted once
    int flips = 0;      ///< flipped edges, all copies of an edge counted once
    int slides = 0;     ///< vertices that slid, all copies of a vertex counted once
    /// An upper bound of the share of the body's volume and rest volume, both together, that the
    /// stroke's clean-up has changed so far.
    double volumeSpent = 0;
};

/// Pieces that were removed when a stroke ended (CutSettings::debrisVolume).
struct Debris {
    int pieces = 0;     ///< their number
    double volume = 0;  ///< their volume at rest [m^3]

    void add(const Debris& other) {
        pieces += other.pieces;
        volume += other.volume;
    }
};

/// The area that the blade swept inside the material, of one side [m^2].
struct SweptArea {
    double asItLay = 0;  ///< in the shape when it was cut
    double atRest = 0;   ///< the same material at rest

    /// Adds another part.
    void add(const SweptArea& other) {
        asItLay += other.asItLay;
        atRest += other.atRest;
    }
};

/// The closing of the wounds at the end of a stroke of the open cut.
struct WoundClosing {
    int patches = 0;         ///< wounds with a patch on either side
    int patchTriangles = 0;  ///< triangles of all patches, both sides
    int removedWalls = 0;    ///< absent triangles that the patches replace
    int slits = 0;           ///< wounds that end in the body; they keep the closed cut's walls
    int unpatched = 0;       ///< other wounds that keep these walls, for `reason`
    std::string reason;      ///< why the last of the unpatched wounds has no patch
};

/// Counts of one step.
struct CutStatistics {
    int cutPieces = 0;             ///< pieces of the body that were cut
    int refusedPieces = 0;         ///< pieces whose step was refused
    int resumed = 0;               ///< pieces with the cut restarted behind their front
    int touchedTriangles = 0;      ///< surface triangles that the strip met
    int wallTriangles = 0;         ///< new wall triangles, both sides
    int splitVertices = 0;         ///< copies of vertices that were made
    int tries = 0;                 ///< levels of the retry ladder used
    SubdivisionCounts patterns{};  ///< surface triangles by subdivision
    int seeds = 0;                 ///< groups of neighbours among the touched triangles
    SweptArea swept;               ///< inside the material, before clean-up
    double volumeChange = 0;       ///< signed, by the step before clean-up and rounding [m^3]
    CleanupStatistics cleanup;     ///< the clean-up after the step, or after the stroke
    Debris debris;                 ///< pieces removed when the stroke ended
    WoundClosing closing;          ///< wounds closed when the stroke ended
};

/// The result of one movement of the blade.
struct CutResult {
    CutOutcome outcome = CutOutcome::air;  ///< one for all pieces (addTo)
    CutDelta delta;                        ///< the change of the mesh
    CutStatistics statistics;              ///< sums over all pieces
    /// Why the last failed try of the step failed; empty if the first one succeeded.
    std::string reason;
};

/// One node of the rung, the last polyline of the blade: a mesh vertex or an air point.
struct RungNode {
    Vec3 position = Vec3::Zero();  ///< [m]
    double s = 0;                  ///< parameter along AB, 0 at A
    int vertex = -1;               ///< mesh vertex, -1 in the air
    bool attached = false;         ///< the edge to the next node is a front edge of the mesh
};

/// The end of a slit: where both of its walls meet.
struct SlitFront {
    std::vector<int> vertices;    ///< along it, from A to B, at least two
    int stroke = 0;               ///< that made it, as in wall labels
    Vec3 heading = Vec3::Zero();  ///< away from the slit, unit
};

/// How finely a cutter works.
struct CutSettings {
    /// Uniform edge length h of new walls [m]. 0 takes that of the surrounding skin at rest
    /// (EdgeLengthField), at most a twelfth of the body's diagonal: coarse bodies get walls finer
    /// than their skin.
    double wallEdgeLength = 0;
    /// A step that advances less than this share of the edge length around waits.
    double gate = 0.5;
    /// Fixed offset of the blade per transit, as a share of the mean edge length. 1e-3 is too small
    /// to see and large enough for float positions; curves of several cuts stay that far apart. A
    /// cut exactly in its plane takes less, down to about 1e-10 with double positions.
    double offset = 1e-3;
    /// Nodes closer than this share of the mean edge length are one: 1e-9 for doubles, 1e-5 for
    /// floats.
    double tolerance = 1e-5;
    std::uint64_t seed = 1;  ///< seed of the offsets
    /// Whether to remove the slivers that a cut leaves, behind the front after each step and at the
    /// end.
    bool cleanUp = true;
    /// Edges of new walls grow from their rim inwards, up to this many times the local edge length
    /// (WallGrading); 1: all are as long as those around.
    double wallCoarsening = 1;
    /// When a stroke has ended, pieces that it cut are removed if below this share of the body's
    /// rest volume, except the largest piece; 0 keeps all.
    double debrisVolume = 0;
    /// The paper's course: the walls of a stroke are absent from the body (SurfaceMesh::absent)
    /// while it lasts, and patches close the wounds when it has ended.
    bool openCut = false;
    /// How the triangles near the strip are found; the cut is the same.
    CutSearch search = CutSearch::tree;
};

/// The cost of searches for the triangles near the strip, over all pieces and tries of a step.
struct SearchWork {
    double milliseconds = 0;      ///< wall clock
    double walkMilliseconds = 0;  ///< of it, until the end of the walk from the first seed
    int seeds = 0;   ///< groups of neighbours that needed a seed (CutSearch::adjacency)
    long tests = 0;  ///< triangles that were tested

    /// Adds another search.
    void add(const SearchWork& other) {
        milliseconds += other.milliseconds;
        walkMilliseconds += other.walkMilliseconds;
        seeds += other.seeds;
        tests += other.tests;
    }
};

}  // namespace kerf

namespace kerf::cut {

/// Thrown inside one try of a step, before anything was changed.
struct StepFailure {
    const char* reason;  ///< why the try failed
};

/// An undirected pair of ids, the lower one first.
using Edge = std::pair<int, int>;
/// The undirected pair of a and b.
inline Edge edgeOf(int a, int b) {
    return a < b ? Edge{a, b} : Edge{b, a};
}

/// The size of a container as an int.
template <class Container>
int sizeOf(const Container& container) {
    return static_cast<int>(container.size());
}

}  // namespace kerf::cut
