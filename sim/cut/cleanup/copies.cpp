#include "sim/cut/cleanup/copies.h"

namespace kerf::cut {

namespace {

SharedEdge& edgeIn(SharedStar& star, int neighbour) {
    for (SharedEdge& edge : star.edges) {
        if (edge.neighbour == neighbour) {
            return edge;
        }
    }
    star.edges.push_back({neighbour, {}});
    return star.edges.back();
}

void addFace(SharedStar& star, int neighbour, const SharedEdge::Face& face) {
    SharedEdge& edge = edgeIn(star, neighbour);
    if (std::find(edge.faces.begin(), edge.faces.end(), face) == edge.faces.end()) {
        edge.faces.push_back(face);
    }
}

}  // namespace

SharedEdgeType SharedEdge::type() const {
    if (faces.size() == 1) {
        return SharedEdgeType::tip;
    }
    if (faces.size() == 2 && faces[0].stroke == faces[1].stroke) {
        return faces[0].stroke < 0 ? SharedEdgeType::skin : SharedEdgeType::wall;
    }
    const bool touchesSkin =
        std::any_of(faces.begin(), faces.end(), [](const Face& face) { return face.stroke < 0; });
    return touchesSkin ? SharedEdgeType::rim : SharedEdgeType::crossing;
}

bool SharedEdge::hasApex(int point) const {
    return std::any_of(faces.begin(), faces.end(),
                       [&](const Face& face) { return face.apex == point; });
}

const SharedEdge* SharedStar::edgeTo(int neighbour) const {
    for (const SharedEdge& edge : edges) {
        if (edge.neighbour == neighbour) {
            return &edge;
        }
    }
    return nullptr;
}

int SharedStar::featureCount() const {
    return static_cast<int>(std::count_if(edges.begin(), edges.end(),
                                          [](const SharedEdge& edge) { return edge.isFeature(); }));
}

bool SharedStar::isCorner() const {
    std::vector<SharedEdgeType> types;
    for (const SharedEdge& edge : edges) {
        if (edge.isFeature()) {
            types.push_back(edge.type());
        }
    }
    return !types.empty() && !(types.size() == 2 && types[0] == types[1]);
}

SharedStar starOf(const SurfaceMesh& mesh, int vertex) {
    SharedStar star;
    star.point = mesh.firstCopy(vertex);
    star.copies = livingCopies(mesh, vertex);
    for (const int copy : star.copies) {
        mesh.forEachOutgoing(copy, [&](int h) {
            const int target = mesh.firstCopy(mesh.target(h));
            const int apex = mesh.firstCopy(mesh.apex(h));
            const int stroke = strokeOf(mesh, h / 3);
            addFace(star, target, {apex, stroke});
            addFace(star, apex, {target, stroke});
        });
    }
    return star;
}

}  // namespace kerf::cut
