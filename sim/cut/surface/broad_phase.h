#pragma once

#include "sim/cut/blade.h"
#include "sim/cut/cut_types.h"
#include "sim/mesh/nearest_triangle.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::cut {

/// The axes of a strip, as columns: along the blade, along the farthest of the `points` aside of
/// it, and across both.
Eigen::Matrix3d sweptAxes(const Blade& blade, const std::vector<Vec3>& points);

/// How a broad phase searches; the result does not depend on it.
struct SearchOrder {
    CutSearch way = CutSearch::tree;  ///< how it finds triangles
    SearchWork* work = nullptr;       ///< sums the cost; null: not measured
};

/// Finds the triangles near parts of one strip, from the current positions: what meets the strip's
/// oriented box, binned along the blade. It begins with a small box around the strip, which
/// suffices for most steps, and extends to the margin on demand.
class BroadPhase {
  public:
    /// Looks around a strip that `points` span, for triangles within `margin` [m] of their box that
    /// `counts` accepts, in bins of at least `binSize` [m]. Mesh and finder must stay as they are
    /// while this is used.
    BroadPhase(const SurfaceMesh& mesh, TriangleFinder& finder, const Blade& blade,
               const std::vector<Vec3>& points, double margin, double binSize,
               std::function<bool(int)> counts, SearchOrder order = {});

    /// The triangles whose box meets the box of abc widened by `pad` <= margin; ascending.
    std::vector<int> query(const Vec3& a, const Vec3& b, const Vec3& c, double pad) const;

    /// A triangle near the strip.
    struct Entry {
        int triangle;   ///< slot in the mesh
        Bounds bounds;  ///< its box along the axes of the strip
        int firstBin;   ///< the first bin that the box meets
    };
    /// The triangles found so far, ascending.
    const std::vector<Entry>& entries() const { return entries_; }
    /// Adds all entries that queries between these points, up to `pad` [m], may find.
    void takeAround(std::span<const Vec3> points, double pad) const {
        require(reachOf(points, pad));
    }
    /// Like takeAround(), and returns the places of these in entries(), ascending.
    std::vector<int> cover(std::span<const Vec3> points, double pad) const;
    /// Some of entries(), binned along the blade.
    struct Bins {
        std::vector<int> first;   ///< start of each bin in `places`, then the end of the last
        std::vector<int> places;  ///< places in entries(), bin after bin
    };
    /// Bins these places, which are ascending. Valid until entries are added.
    Bins binsOf(std::span<const int> places) const;
    /// A point in coordinates along the axes of the strip.
    Vec3 toFrame(const Vec3& p) const { return frame_ * p; }
    /// Finds what query() would, among the entries in `bins` and as places in entries(). `box`: the
    /// box to look around, in coordinates of toFrame(). Adds no entries; cover() does.
    void findEntries(const Bounds& box, double pad, const Bins& bins,
                     std::vector<int>& found) const;

  private:
    int binOf(double x) const;
    void take(double margin) const;
    bool add(int triangle) const;
    Bounds reachOf(std::span<const Vec3> points, double pad) const;
    Bounds widened(Bounds box, double pad) const;
    void findIn(const Bounds& bounds, const Bins& bins, std::vector<int>& found) const;
    void require(const Bounds& bounds) const;

    const SurfaceMesh& mesh_;
    TriangleFinder& finder_;
    std::function<bool(int)> counts_;
    SearchOrder order_;
    Eigen::Matrix3d frame_;  ///< rows: along the blade, along the strip, across both
    std::vector<Vec3> points_;
    double margin_;
    double leastBinSize_;
    mutable bool tookAll_ = false;
    mutable Bounds box_;
    mutable double binSize_ = 1;
    mutable std::vector<Entry> entries_;
    mutable Bins bins_;  ///< all entries
};

}  // namespace kerf::cut
