#pragma once

#include <span>
#include <vector>

#include "sim/body/body_model.h"
#include "sim/body/ispc_builder.h"
#include "sim/body/ray_tree.h"
#include "sim/body/record_editor.h"
#include "sim/body/segment_grid.h"
#include "sim/mesh/piece_labels.h"

namespace kerf {

/// Finds the ISPCs that a cut spoils, and casts new ones: by a tree over the rest shape, a grid of
/// their rest segments, and lists of those that end on each triangle.
class IspcSet {
  public:
    /// Casts the ISPCs of all vertices into `model`, of which all but the ISPCs must be there.
    IspcSet(const SurfaceMesh& mesh, BodyModel& model);

    /// Follows a change of the mesh; see BodyUpdater for what is kept.
    void update(BodyModel& model, std::span<const int> changed, const LabelChange& labels,
                RecordEditor<shared::IspcConstraint>& editor);

  private:
    using Editor = RecordEditor<shared::IspcConstraint>;

    std::vector<int> verticesToCast(const BodyModel& model, std::span<const int> changed,
                                    const LabelChange& labels);
    void addCrossed(const BodyModel& model, std::span<const int> changed,
                    std::vector<int>& vertices) const;
    void addSeparated(const BodyModel& model, const LabelChange& labels,
                      std::vector<int>& vertices) const;
    bool isSeparated(const BodyModel& model, int vertex) const;
    template <class F>
    void forEachEndingOn(int triangle, F&& f) const;

    void remember(const CastIspc& ispc, int slot);
    void forget(int vertex, int triangle);
    void refillGrid(const BodyModel& model);
    void addToGrid(const shared::IspcConstraint& ispc);

    const SurfaceMesh& mesh_;
    RayTree tree_;
    SegmentGrid grid_;
    std::vector<int> waiting_;   ///< vertices whose ray met an absent wall, until it is patched
    std::vector<int> ofVertex_;  ///< slot of each vertex's ISPC, -1 for none
    // Those that end on one triangle, as a linked list of their vertices.
    std::vector<int> firstOn_;  ///< by mesh slot
    std::vector<int> next_;     ///< by vertex
    std::vector<int> previous_;
};

}  // namespace kerf
