#include "sim/mesh/triangle_tree.h"

namespace kerf {

TriangleTree::TriangleTree(const SurfaceMesh& mesh) : mesh_(mesh) {
    tree_ = BoxTree(
        livingTriangles(mesh), [this](int t) { return boundsOf(t); }, BoxTree::Joining::divided);
    tree_.prepareToEdit();
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

// Where a cut gave a corner a vertex of its own the triangle has not moved, and stays.
void TriangleTree::update(std::span<const int> triangles) {
    std::vector<int> others;
    others.reserve(triangles.size());
    std::ranges::copy_if(triangles, std::back_inserter(others),
                         [this](int t) { return !mesh_.alive(t) || !tree_.holds(t, boundsOf(t)); });
    tree_.erase(others);
    std::erase_if(others, [this](int t) { return !mesh_.alive(t); });
    tree_.insert(others, [this](int t) { return boundsOf(t); });
}

}  // namespace kerf
