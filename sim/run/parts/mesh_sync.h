#pragma once

#include "sim/mesh/nearest_triangle.h"
#include "sim/mesh/surface_mesh.h"
#include "sim/solve/gpu_solver.h"

namespace kerf {

/// Keeps a mesh up to date with the GPU where it is read. What a step of the blade will need is
/// read back with the measure of the body: the vertices near the strip, found by the kernel, and a
/// list of others. All else is fetched when read, so results never depend on prefetching.
class MeshSync final : public VertexSource, public TriangleFinder {
  public:
    /// The solver must outlive the object. Call followMesh() first.
    explicit MeshSync(GpuSolver& solver) : solver_(solver) {}
    /// Keeps this mesh up to date from now on; it must outlive that.
    void followMesh(SurfaceMesh& mesh) {
        mesh_ = &mesh;
        forget();
    }

    /// Whether what was not prefetched is read with the whole body, since all is about to be read,
    /// or alone.
    void readAllAtOnce(bool wanted) { readsAll_ = wanted; }
    /// Before the measure of a step: the box that the blade will search, if any, and other vertices
    /// that will be read.
    void prefetch(const std::optional<OrientedBox>& box, std::span<const int> vertices);
    /// Before the measure of a step: all will be read.
    void prefetchAll();
    /// The solver has moved the body.
    void invalidate();
    /// After the measure: takes what was prefetched. Returns how long that took [ms].
    double takePrefetched();
    /// The mesh was replaced by one without stale state.
    void forget();
    /// How often the whole body was read back.
    int wholeReads() const { return wholeReads_; }

    /// Reads `box` back. Returns its triangles, ascending, and perhaps others; all triangles if
    /// nothing is stale.
    std::vector<int> lookInto(const OrientedBox& box);

    void bring(std::span<const int> vertices) override;
    void bringAll() override;

    std::vector<int> near(const OrientedBox& box) override;
    /// Bounds of the body in the last measure [m].
    Bounds bounds() override { return bounds_; }
    void setBounds(const Bounds& bounds) { bounds_ = bounds; }
    void update(std::span<const int> triangles) override;

  private:
    void adopt(const std::vector<shared::NearbyVertex>& states);
    void takeWatched(const std::optional<OrientedBox>& box);
    /// Triangles around the vertices without stale state, ascending.
    std::vector<int> trianglesAround(const std::vector<shared::NearbyVertex>& states) const;
    void lookAround(const OrientedBox& box);

    SurfaceMesh* mesh_ = nullptr;
    GpuSolver& solver_;
    bool prefetches_ = false;
    std::optional<OrientedBox> prefetched_;
    bool prefetchesAll_ = false;
    std::optional<BodyState> all_;  ///< came with the measure, as the mesh takes it
    /// The box in which near() knows all triangles, from their vertices and from later changes.
    std::optional<OrientedBox> known_;
    std::vector<int> triangles_;  ///< ascending; some may be dead, or far away
    Bounds bounds_;
    int wholeReads_ = 0;
    bool readsAll_ = false;  ///< see readAllAtOnce()
};

}  // namespace kerf
