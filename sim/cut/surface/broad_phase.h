#pragma once

#include <functional>
#include <span>
#include <vector>

#include "sim/cut/blade.h"
#include "sim/mesh/surface_mesh.h"
#include "sim/mesh/triangle_finder.h"

namespace kerf::cut {

/// Along the blade (first column), along the farthest of the `points` aside of it, and across both.
Eigen::Matrix3d sweepAxes(const Blade& blade, const std::vector<Vec3>& points);

/// Finds the triangles near parts of one sweep, from the current positions: what meets the oriented
/// box of the sweep, binned along the blade. It begins with little around the sweep, which most
/// steps do with, and takes all within the margin once somebody asks for more.
class BroadPhase {
  public:
    /// `points` span the sweep; triangles within `margin` [m] of their box are found, of those that
    /// `counts` lets pass. Mesh and finder must stay as they are while this is used.
    BroadPhase(const SurfaceMesh& mesh, TriangleFinder& finder, const Blade& blade,
               const std::vector<Vec3>& points, double margin, double binSize,
               std::function<bool(int)> counts);

    /// Triangles whose box meets the box of abc widened by `pad` <= margin; ascending.
    std::vector<int> query(const Vec3& a, const Vec3& b, const Vec3& c, double pad) const;

    /// Those that were taken so far; ascending.
    struct Entry {
        int triangle;
        Bounds bounds;  ///< along the axes of the sweep
        int firstBin;
    };
    const std::vector<Entry>& entries() const { return entries_; }
    /// From now on queries between these points, up to `pad`, take no more entries.
    void takeAround(std::span<const Vec3> points, double pad) const {
        require(reachOf(points, pad));
    }
    /// The same; the places of those that they may find in entries(), ascending.
    std::vector<int> cover(std::span<const Vec3> points, double pad) const;
    /// Some of entries(), by where they lie along the blade.
    struct Bins {
        std::vector<int> first;   ///< of each bin in `places`, and behind the last
        std::vector<int> places;  ///< in entries(), bin after bin
    };
    /// Of these places, ascending. They hold until more entries are taken.
    Bins binsOf(std::span<const int> places) const;
    /// A point along the axes of the sweep.
    Vec3 toFrame(const Vec3& p) const { return frame_ * p; }
    /// The same as query(), as places in entries(), of those in `bins`; `box`: of what is looked
    /// for, toFrame(). Takes no more entries: cover() does.
    void findEntries(const Bounds& box, double pad, const Bins& bins,
                     std::vector<int>& found) const;

  private:
    int binOf(double x) const;
    void take(double margin) const;
    void add(int triangle) const;
    Bounds reachOf(std::span<const Vec3> points, double pad) const;
    Bounds widened(Bounds box, double pad) const;
    void findIn(const Bounds& bounds, const Bins& bins, std::vector<int>& found) const;
    void require(const Bounds& bounds) const;

    const SurfaceMesh& mesh_;
    TriangleFinder& finder_;
    std::function<bool(int)> counts_;
    Eigen::Matrix3d frame_;  ///< rows: along the blade, along the sweep, across both
    std::vector<Vec3> points_;
    double margin_;
    double leastBinSize_;
    mutable bool tookAll_ = false;
    mutable Bounds box_;
    mutable double binSize_ = 1;
    mutable std::vector<Entry> entries_;
    mutable Bins bins_;  ///< of all entries
};

}  // namespace kerf::cut
