#pragma once

#include <optional>
#include <span>
#include <utility>

#include "sim/mesh/surface_mesh.h"
#include "sim/mesh/triangle_finder.h"
#include "sim/mesh/triangle_tree.h"

namespace kerf::cut {

/// Looks up triangles of a moving body by where they lie: by a finder that somebody else keeps, or
/// by a tree of its own, made when it is first asked.
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
    /// Whether it is known that nothing has moved since noteMotion().
    bool isStill() const { return moved_ == 0; }
    /// Lets the tree follow what has moved since the last call.
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
    std::optional<double> moved_;  ///< how far at most [m]; none where nobody has said
};

}  // namespace kerf::cut
