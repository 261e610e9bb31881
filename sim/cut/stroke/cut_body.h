#pragma once

#include "sim/cut/blade.h"
#include "sim/cut/cut_types.h"
#include "sim/cut/surface/edge_length_field.h"
#include "sim/cut/surface/piece_groups.h"
#include "sim/cut/surface/stroke_surface.h"
#include "sim/mesh/nearest_triangle.h"
#include "sim/mesh/surface_mesh.h"
#include "sim/mesh/triangle_tree.h"

namespace kerf::cut {

/// Finds triangles of a moving body by position: with an external finder, or with its own tree,
/// made on first use.
class TriangleLookup {
  public:
    /// The mesh must outlive the object and its copies.
    explicit TriangleLookup(const SurfaceMesh& mesh) : mesh_(mesh) {}

    /// See Cutter::useFinder().
    void use(TriangleFinder* finder) {
        finder_ = finder;
        tree_.reset();
    }
    bool hasOwnTree() const { return finder_ == nullptr; }
    /// The finder given, or the tree.
    TriangleFinder& finder() {
        if (finder_ == nullptr && !tree_) {
            tree_.emplace(mesh_);
        }
        return finder_ != nullptr ? *finder_ : *tree_;
    }
    /// Follows a change of the mesh; see TriangleFinder::update().
    void update(std::span<const int> triangles) {
        if (finder_ != nullptr || tree_) {
            finder().update(triangles);
        }
    }

    /// See Cutter::boundMotion().
    void boundMotion(double distance) { moved_ = moved_.value_or(0) + distance; }
    /// Whether nothing is known to have moved since noteMotion().
    bool isStill() const { return moved_ == 0; }
    /// Updates the tree by what has moved since the last call.
    void noteMotion() {
        const std::optional<double> most = std::exchange(moved_, std::nullopt);
        if (tree_ && most) {
            tree_->moved(*most);
        } else if (tree_) {
            tree_->movedAnyhow();
        }
    }

  private:
    const SurfaceMesh& mesh_;
    TriangleFinder* finder_ = nullptr;
    std::optional<TriangleTree> tree_;
    std::optional<double> moved_;  ///< upper bound [m]; none if unknown
};

/// The largest distance from the strip at which a triangle can matter, as a share of the edge
/// length about the rung: predicates see vertices displaced, and the rung is routed around skin
/// that moved across it.
inline constexpr double kBroadPhaseMargin = 3;

/// The reason for the blade to wait.
enum class Gate {
    shareOfEdge,  ///< it has moved less than CutSettings::gate
    flush,        ///< it has hardly moved
};

/// One change of the mesh, of which a step may make several.
struct MeshChange {
    /// The slots that were added or removed, or of which a corner changed; each once.
    std::span<const int> triangles;
    int groupOfNewPieces = -1;             ///< the group of pieces that are all new
    std::span<const int> movedVertices{};  ///< old ones that were moved, or got another velocity
    double restMotion = 0;                 ///< largest motion of a vertex at rest [m]
};

/// A body to be cut by strokes: its mesh, its settings, and search structures.
struct CutBody {
    /// The mesh must outlive the object and its copies. O(n).
    CutBody(SurfaceMesh& ofBody, const CutSettings& howFinely);

    /// Updates all search structures. Call it after each change of the mesh, before any search.
    void follow(const MeshChange& change);
    /// Records that the solver moved the body since the last call.
    void noteMotion();
    /// Takes the body as it is when a stroke begins. O(n).
    void beginStroke();
    /// The part of a blade that may reach the body.
    Blade nearBody(const Blade& whole);

    /// The mean edge length h [m].
    double h() const { return edgeLengths->mean(); }
    /// The edge length about the nodes of a rung [m].
    double edgeLengthAbout(const std::vector<RungNode>& nodes) const;
    /// The distance below which a group waits, for an edge length about its rung [m].
    double gateLength(Gate gate, double edge) const;
    /// The distance from the strip within which a step looks, for an edge length there [m].
    double margin(double edge) const;

    SurfaceMesh& mesh;
    CutSettings settings;
    std::shared_ptr<const EdgeLengthField> edgeLengths;  ///< by rest position
    TriangleLookup triangles{mesh};
    GroupedPieces pieces{mesh};
    StrokeSurface surface{mesh};  ///< the surface before the stroke
    bool atRest = false;          ///< the whole body is known to be still in its rest shape
    SearchWork searchWork{};      ///< cost of searches since it was last taken

  private:
    bool liesAtRest(int v) const;
};

}  // namespace kerf::cut
