#include "sim/mesh/triangle_tree.h"

#include <iterator>
#include <utility>

namespace kerf {

TriangleTree::TriangleTree(const SurfaceMesh& mesh) : mesh_(mesh) {
    tree_ = LazyBoxTree(
        livingTriangles(mesh), [this](int t) { return boundsOf(t); },
        LazyBoxTree::Joining::divided);
}

std::vector<int> TriangleTree::near(const OrientedBox& box) {
    const MeetingBoxes boxes(box);
    return find([&](const Bounds& bounds) { return boxes.mayMeet(bounds); });
}

void TriangleTree::catchUp() {
    if (std::exchange(lost_, false)) {
        tree_.refit([this](int t) { return boundsOf(t); });
    }
}

void TriangleTree::update(std::span<const int> triangles) {
    tree_.erase(triangles);
    std::vector<int> living;
    std::ranges::copy_if(triangles, std::back_inserter(living),
                         [this](int t) { return mesh_.alive(t); });
    tree_.insert(living, [this](int t) { return boundsOf(t); });
}

}  // namespace kerf
