#include "sim/cut/cleanup/material.h"

#include <algorithm>

namespace kerf::cut {

namespace {

int sheetOf(const SurfaceMesh& mesh, int t) {
    return mesh.kind(t) == SurfaceKind::wall ? mesh.wallLabel(t) / 2 : -1;
}

MaterialEdge& edgeIn(MaterialStar& star, int neighbour) {
    for (MaterialEdge& edge : star.edges) {
        if (edge.neighbour == neighbour) {
            return edge;
        }
    }
    star.edges.push_back({neighbour, {}});
    return star.edges.back();
}

void addSide(MaterialStar& star, int neighbour, const MaterialEdge::Side& side) {
    MaterialEdge& edge = edgeIn(star, neighbour);
    if (std::find(edge.sides.begin(), edge.sides.end(), side) == edge.sides.end()) {
        edge.sides.push_back(side);
    }
}

}  // namespace

MaterialEdgeType MaterialEdge::type() const {
    if (sides.size() == 1) {
        return MaterialEdgeType::tip;
    }
    if (sides.size() == 2 && sides[0].sheet == sides[1].sheet) {
        return sides[0].sheet < 0 ? MaterialEdgeType::skin : MaterialEdgeType::wall;
    }
    const bool touchesSkin =
        std::any_of(sides.begin(), sides.end(), [](const Side& side) { return side.sheet < 0; });
    return touchesSkin ? MaterialEdgeType::rim : MaterialEdgeType::crossing;
}

bool MaterialEdge::hasApex(int point) const {
    return std::any_of(sides.begin(), sides.end(),
                       [&](const Side& side) { return side.apex == point; });
}

const MaterialEdge* MaterialStar::edgeTo(int neighbour) const {
    for (const MaterialEdge& edge : edges) {
        if (edge.neighbour == neighbour) {
            return &edge;
        }
    }
    return nullptr;
}

int MaterialStar::featureCount() const {
    return static_cast<int>(std::count_if(
        edges.begin(), edges.end(), [](const MaterialEdge& edge) { return edge.isFeature(); }));
}

bool MaterialStar::isCorner() const {
    std::vector<MaterialEdgeType> types;
    for (const MaterialEdge& edge : edges) {
        if (edge.isFeature()) {
            types.push_back(edge.type());
        }
    }
    return !types.empty() && !(types.size() == 2 && types[0] == types[1]);
}

MaterialStar starOf(const SurfaceMesh& mesh, int vertex) {
    MaterialStar star;
    star.point = mesh.materialPoint(vertex);
    star.copies = livingCopies(mesh, vertex);
    for (const int copy : star.copies) {
        mesh.forEachOutgoing(copy, [&](int h) {
            const int target = mesh.materialPoint(mesh.target(h));
            const int apex = mesh.materialPoint(mesh.apex(h));
            const int sheet = sheetOf(mesh, h / 3);
            addSide(star, target, {apex, sheet});
            addSide(star, apex, {target, sheet});
        });
    }
    return star;
}

std::vector<int> livingCopies(const SurfaceMesh& mesh, int vertex) {
    if (mesh.mateGroup(vertex) < 0) {
        return {vertex};
    }
    std::vector<int> living;
    for (const int copy : mesh.matesOfGroup(mesh.mateGroup(vertex))) {
        if (mesh.outgoing(copy) >= 0) {
            living.push_back(copy);
        }
    }
    return living;
}

}  // namespace kerf::cut
