#pragma once

#include "sim/base/byte_archive.h"
#include "sim/base/math.h"
#include "sim/body/body_model.h"
#include "sim/body/ispc_builder.h"
#include "sim/body/record_editor.h"
#include "sim/mesh/piece_labels.h"

namespace kerf {

/// Numbered segments by the cells of a grid that they pass. Segments are never removed: callers
/// must check those that they find.
class SegmentGrid {
  public:
    SegmentGrid() = default;
    /// `box` should hold the segments (others are filed at its border); `count`: about how many.
    SegmentGrid(const Bounds& box, int count);

    void add(int id, const Vec3& from, const Vec3& to);
    /// The ids of segments that pass a cell of one of the boxes. Ascending.
    std::vector<int> find(std::span<const Bounds> boxes) const;
    /// Whether it has grown until a new grid would be much smaller.
    bool overfull() const { return entries_ > kMostGrowth * entriesExpected_; }

  private:
    using Cell = std::array<int, 3>;
    static constexpr long kMostGrowth = 3;

    Cell cellOf(const Vec3& p) const;
    int indexOf(const Cell& cell) const {
        return (cell[2] * perAxis_ + cell[1]) * perAxis_ + cell[0];
    }
    void addCells(const Bounds& box, std::vector<int>& cells) const;

    Bounds box_;
    int perAxis_ = 1;
    Vec3 cellSize_ = Vec3::Ones();
    std::vector<std::vector<int>> cells_;
    long entries_ = 0;
    long entriesExpected_ = 0;
};

/// Finds the ISPCs that a cut invalidates, and casts new ones: with a tree over the rest shape, a
/// grid of their rest segments, and lists of those that end on each triangle.
class IspcSet {
  public:
    /// Casts the ISPCs of all vertices into `model`, which must be complete except for them.
    IspcSet(const SurfaceMesh& mesh, BodyModel& model);
    /// Reads what write() wrote, for a mesh and model that are as they were then.
    IspcSet(const SurfaceMesh& mesh, const BodyModel& model, ByteReader& from);
    void write(ByteWriter& to) { archive(to); }

    IspcRays rays() const { return rays_; }
    /// Recasts all, in the directions of `rays`.
    void castAnew(BodyModel& model, IspcRays rays, RecordEditor<shared::IspcConstraint>& editor);

    /// Follows a change of the mesh; see BodyUpdater for what is kept.
    void update(BodyModel& model, std::span<const int> changed, const LabelChange& labels,
                RecordEditor<shared::IspcConstraint>& editor);

  private:
    using Editor = RecordEditor<shared::IspcConstraint>;

    template <class Archive>
    void archive(Archive& io) {
        io(rays_, waiting_, ofRay_, rayOf_, firstOn_, next_, previous_);
    }

    // A ray is raysPerVertex() times its vertex, plus which of its rays it is.
    int vertexOf(int ray) const { return ray / raysPerVertex(rays_); }
    std::optional<CastIspc> cast(const IspcCaster& caster, const BodyModel& model, int ray) const;
    void makeRoom();
    void castRays(BodyModel& model, std::span<const int> rays, Editor& editor);
    std::vector<int> raysToCast(const BodyModel& model, std::span<const int> changed,
                                const LabelChange& labels);
    void addRaysOf(int vertex, std::vector<int>& rays) const;
    void addCrossed(const BodyModel& model, std::span<const int> changed,
                    std::vector<int>& rays) const;
    void addSeparated(const BodyModel& model, const LabelChange& labels,
                      std::vector<int>& rays) const;
    bool isSeparated(const BodyModel& model, int ray) const;
    template <class F>
    void forEachEndingOn(int triangle, F&& f) const;

    void remember(const CastIspc& ispc, int ray, int slot);
    void forget(int ray, int triangle);
    void refillGrid(const BodyModel& model);
    void addToGrid(const shared::IspcConstraint& ispc, int ray);

    const SurfaceMesh& mesh_;
    RayTree tree_;
    SegmentGrid grid_;
    IspcRays rays_ = IspcRays::alongNormal;
    std::vector<int> waiting_;  ///< rays that met an absent wall, until it is patched
    std::vector<int> ofRay_;    ///< slot of each ray's ISPC, -1 for none
    std::vector<int> rayOf_;    ///< by slot
    // Those that end on one triangle, as a linked list of their rays.
    std::vector<int> firstOn_;  ///< by mesh slot
    std::vector<int> next_;     ///< by ray
    std::vector<int> previous_;
};

}  // namespace kerf
