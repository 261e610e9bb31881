#pragma once

#include <optional>
#include <span>
#include <vector>

#include "sim/mesh/surface_mesh.h"
#include "sim/mesh/triangle_finder.h"
#include "sim/solve/gpu_solver.h"

namespace kerf {

/// Keeps a mesh up to date with the GPU where it is read. What a step of the blade will need comes
/// back with the measure of the body: the vertices near the strip, found by the kernel, and a list
/// of others. Whatever else is read is fetched then, so results never depend on what was
/// prefetched.
class MeshSync final : public VertexSource, public TriangleFinder {
  public:
    /// The solver must outlive the object. followMesh() comes first.
    explicit MeshSync(GpuSolver& solver) : solver_(solver) {}
    /// From now on this mesh is kept up to date, which must live as long as it is.
    void followMesh(SurfaceMesh& mesh) {
        mesh_ = &mesh;
        forget();
    }

    /// From now on what nobody foresaw is read with all of the body, since all is about to be read,
    /// or alone.
    void readAllAtOnce(bool wanted) { readsAll_ = wanted; }
    /// Before the measure of a step: the box that the blade will look into, and vertices that will
    /// be read wherever they are.
    void prefetch(const OrientedBox& box, std::span<const int> vertices);
    /// Before the measure of a step: all will be read.
    void prefetchAll();
    /// The solver has moved the body.
    void invalidate();
    /// After the measure: takes what was asked for. Returns how long that took [ms].
    double takePrefetched();
    /// The mesh has become another one, of which nothing is old.
    void forget();
    /// Number of times that all of the body came back.
    int wholeReads() const { return wholeReads_; }

    /// Brings what lies in `box` back. Returns its triangles, ascending, and perhaps others; all
    /// there are where nothing is old.
    std::vector<int> lookInto(const OrientedBox& box);

    void bring(std::span<const int> vertices) override;
    void bringAll() override;

    std::vector<int> near(const OrientedBox& box) override;
    /// Bounds of the body as the last measure saw it [m].
    Bounds bounds() override { return bounds_; }
    void setBounds(const Bounds& bounds) { bounds_ = bounds; }
    void update(std::span<const int> triangles) override;

  private:
    void adopt(const std::vector<shared::NearbyVertex>& states);
    void takeWatched(const OrientedBox& box);
    /// Triangles around the vertices of which nothing is old, ascending.
    std::vector<int> trianglesAround(const std::vector<shared::NearbyVertex>& states) const;
    void lookAround(const OrientedBox& box);

    SurfaceMesh* mesh_ = nullptr;
    GpuSolver& solver_;
    std::optional<OrientedBox> prefetched_;
    bool prefetchesAll_ = false;
    std::optional<BodyState> all_;  ///< came with the measure, as the mesh takes it
    /// The box in which near() knows all triangles, by the vertices around which they lie and by
    /// those that changed since.
    std::optional<OrientedBox> known_;
    std::vector<int> triangles_;  ///< ascending; some may be dead, or far away
    Bounds bounds_;
    int wholeReads_ = 0;
    bool readsAll_ = false;  ///< see readAllAtOnce()
};

}  // namespace kerf
