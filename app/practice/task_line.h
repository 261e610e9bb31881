#pragma once

#include <span>
#include <vector>

#include "app/practice/task.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::app {

/// The living triangles of a model. `members`: the model of each triangle slot of the mesh.
std::vector<int> trianglesOfModel(int model, const SurfaceMesh& mesh, std::span<const int> members);

/// The plane across a line, in which `into` lies.
struct LineSection {
    double toEnd = 0;  ///< from the nearer end of the line, infinite where it is closed [m]
    Vec3 top;          ///< where `into` meets the uncut body [m]
    Vec3 along;        ///< unit normal of the plane
    Vec3 aside;        ///< unit direction in it, across `into`
};

/// Where a point lies beside a line.
struct PlaceAtLine {
    double distance;  ///< from the line [m]
    bool isBeyond;    ///< an open end, from which the distance is then
};

/// A line of a task as it is seen along `into`; its lengths too are measured so.
class LineCurve {
  public:
    explicit LineCurve(const TaskLine& line);

    const TaskLine& line() const { return line_; }
    double length() const { return starts_.back(); }  ///< [m]
    double depthOf(const Vec3& x, const Vec3& top) const { return (x - top).dot(into_); }
    PlaceAtLine nearest(const Vec3& x) const;
    double sectionStep() const;  ///< [m]
    /// Sections in the middles of equal parts of the line, where the uncut body lies under it.
    /// O(sections * triangles).
    std::vector<LineSection> sections(const SurfaceMesh& uncut, std::span<const int> members) const;

  private:
    Vec3 flat(const Vec3& x) const { return x - x.dot(into_) * into_; }
    LineSection sectionAt(double s) const;

    const TaskLine& line_;
    Vec3 into_;
    std::vector<Vec3> points_;    ///< as seen along `into`; the first again where it is closed
    std::vector<double> starts_;  ///< length of the line up to each of these [m]
};

}  // namespace kerf::app
