#pragma once

#include "sim/cut/cut_types.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::test {

/// Cuts a mesh that has a loop of edges in the plane y = 0 along that loop, without the cutter:
/// the upper half gets copies of the loop's vertices, both halves a fan of wall triangles around
/// the origin. The loop must go once around the origin.
class HandCut {
  public:
    explicit HandCut(SurfaceMesh& mesh) : mesh_(mesh) {
        delta_.firstNewVertex = mesh.vertexCount();
        findSeam();
        copyLoop();
        const int low = mesh_.addVertex(Vec3::Zero(), Vec3::Zero(), Vec3::Zero());
        const int high = mesh_.addVertex(Vec3::Zero(), Vec3::Zero(), Vec3::Zero());
        mesh_.joinCopies(low, high);
        relabelUpperHalf();
        std::vector<int> lowerSide;
        for (const int h : seam_) {
            lowerSide.push_back(mesh_.twin(h));
        }
        close(seam_, high, 0);
        close(lowerSide, low, 1);
    }

    const CutDelta& delta() const { return delta_; }

  private:
    bool above(int h) const {
        double y = 0;
        for (const int v : mesh_.triangle(h / 3)) {
            y += mesh_.restPosition(v).y();
        }
        return y > 0;
    }
    bool onPlane(int v) const { return std::abs(mesh_.restPosition(v).y()) < 1e-12; }

    /// Half-edges of upper triangles that lie in the plane.
    void findSeam() {
        for (int h = 0; h < 3 * mesh_.triangleSlots(); ++h) {
            if (onPlane(mesh_.origin(h)) && onPlane(mesh_.target(h)) && above(h)) {
                seam_.push_back(h);
            }
        }
    }

    void copyLoop() {
        for (const int h : seam_) {
            const int v = mesh_.origin(h);
            copyOf_[v] = mesh_.addVertex(mesh_.position(v), mesh_.restPosition(v), Vec3::Zero());
            mesh_.joinCopies(v, copyOf_[v]);
        }
    }

    void relabelUpperHalf() {
        const int slots = mesh_.triangleSlots();
        for (int t = 0; t < slots; ++t) {
            if (!above(3 * t)) {
                continue;
            }
            bool changed = false;
            for (int k = 0; k < 3; ++k) {
                if (const auto copy = copyOf_.find(mesh_.triangle(t)[k]); copy != copyOf_.end()) {
                    mesh_.setOutgoing(copy->second, 3 * t + k);
                    mesh_.setCorner(t, k, copy->second);
                    changed = true;
                }
            }
            if (changed) {
                delta_.changedTriangles.push_back(t);
            }
        }
    }

    /// A wall triangle on each of the border half-edges, all meeting in `center`.
    void close(const std::vector<int>& border, int center, int label) {
        std::map<int, int> spokeFrom;
        std::map<int, int> spokeTo;
        for (const int h : border) {
            const int a = mesh_.target(h);
            const int b = mesh_.origin(h);
            const int t = mesh_.addTriangle({a, b, center}, SurfaceKind::wall, label);
            delta_.addedTriangles.push_back(t);
            mesh_.setTwin(3 * t, h);
            mesh_.setTwin(h, 3 * t);
            mesh_.setOutgoing(a, 3 * t);
            mesh_.setOutgoing(center, 3 * t + 2);
            spokeFrom[b] = 3 * t + 1;
            spokeTo[a] = 3 * t + 2;
        }
        for (const auto& [v, h] : spokeFrom) {
            mesh_.setTwin(h, spokeTo.at(v));
            mesh_.setTwin(spokeTo.at(v), h);
        }
    }

    SurfaceMesh& mesh_;
    CutDelta delta_;
    std::vector<int> seam_;
    std::map<int, int> copyOf_;
};

}  // namespace kerf::test
