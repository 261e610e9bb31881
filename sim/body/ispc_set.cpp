#include "sim/body/ispc_set.h"

#include <algorithm>
#include <utility>

#include "sim/base/sort_unique.h"

namespace kerf {

namespace {

Bounds restBounds(const SurfaceMesh& mesh) {
    Bounds bounds;
    for (const Vec3& p : mesh.restPositions()) {
        bounds.add(p);
    }
    return bounds;
}

std::vector<int> newWalls(const SurfaceMesh& mesh, std::span<const int> changed) {
    std::vector<int> walls;
    for (const int t : changed) {
        if (mesh.alive(t) && mesh.kind(t) == SurfaceKind::wall) {
            walls.push_back(t);
        }
    }
    return walls;
}

}  // namespace

IspcSet::IspcSet(const SurfaceMesh& mesh, BodyModel& model)
    : mesh_(mesh), tree_(mesh, livingTriangles(mesh)) {
    tree_.prepareToUpdate();
    const int vertices = mesh.vertexCount();
    ofVertex_.assign(vertices, -1);
    next_.assign(vertices, -1);
    previous_.assign(vertices, -1);
    firstOn_.assign(mesh.triangleSlots(), -1);
    const IspcCaster caster(mesh, tree_, model.pieceOfVertex, model.edgeLength);
    for (int v = 0; v < vertices; ++v) {
        if (const std::optional<CastIspc> ispc = caster.cast(v, model.vertexAreas[v])) {
            remember(*ispc, static_cast<int>(model.ispcs.size()));
            model.ispcs.push_back(ispc->constraint);
            model.ispcMeshTriangle.push_back(ispc->meshTriangle);
        }
    }
    refillGrid(model);
}

void IspcSet::refillGrid(const BodyModel& model) {
    grid_ = SegmentGrid(restBounds(mesh_), static_cast<int>(model.ispcs.size()));
    for (const shared::IspcConstraint& ispc : model.ispcs) {
        addToGrid(ispc);
    }
}

void IspcSet::addToGrid(const shared::IspcConstraint& ispc) {
    const int v = static_cast<int>(ispc.vertex);
    grid_.add(v, mesh_.restPosition(v), restEnd(mesh_, ispc));
}

void IspcSet::remember(const CastIspc& ispc, int slot) {
    const int v = static_cast<int>(ispc.constraint.vertex);
    ofVertex_[v] = slot;
    next_[v] = firstOn_[ispc.meshTriangle];
    previous_[v] = -1;
    if (next_[v] >= 0) {
        previous_[next_[v]] = v;
    }
    firstOn_[ispc.meshTriangle] = v;
}

void IspcSet::forget(int vertex, int triangle) {
    ofVertex_[vertex] = -1;
    if (previous_[vertex] >= 0) {
        next_[previous_[vertex]] = next_[vertex];
    } else {
        firstOn_[triangle] = next_[vertex];
    }
    if (next_[vertex] >= 0) {
        previous_[next_[vertex]] = previous_[vertex];
    }
}

template <class F>
void IspcSet::forEachEndingOn(int triangle, F&& f) const {
    for (int v = firstOn_[triangle]; v >= 0; v = next_[v]) {
        f(v);
    }
}

void IspcSet::update(BodyModel& model, std::span<const int> changed, const LabelChange& labels,
                     Editor& editor) {
    ofVertex_.resize(mesh_.vertexCount(), -1);
    next_.resize(mesh_.vertexCount(), -1);
    previous_.resize(mesh_.vertexCount(), -1);
    firstOn_.resize(mesh_.triangleSlots(), -1);
    tree_.update(changed);
    const std::vector<int> vertices = verticesToCast(model, changed, labels);
    for (const int v : vertices) {
        if (const int slot = ofVertex_[v]; slot >= 0) {
            forget(v, model.ispcMeshTriangle[slot]);
            editor.remove(slot);
        }
    }
    const IspcCaster caster(mesh_, tree_, model.pieceOfVertex, model.edgeLength);
    for (const int v : vertices) {
        const std::optional<CastIspc> ispc = caster.cast(v, model.vertexAreas[v]);
        if (ispc && mesh_.absent(ispc->meshTriangle)) {
            waiting_.push_back(v);
        } else if (ispc) {
            const int slot = editor.add(ispc->constraint);
            model.ispcMeshTriangle.resize(model.ispcs.size(), -1);
            model.ispcMeshTriangle[slot] = ispc->meshTriangle;
            remember(*ispc, slot);
            addToGrid(ispc->constraint);
        }
    }
    editor.close([&](int from, int to) {
        model.ispcMeshTriangle[to] = model.ispcMeshTriangle[from];
        ofVertex_[model.ispcs[to].vertex] = to;
    });
    model.ispcMeshTriangle.resize(model.ispcs.size());
    if (grid_.overfull()) {
        refillGrid(model);
    }
}

/// Vertices whose ISPC must be cast, ascending.
std::vector<int> IspcSet::verticesToCast(const BodyModel& model, std::span<const int> changed,
                                         const LabelChange& labels) {
    std::vector<int> vertices;
    if (mesh_.openStroke() < 0) {
        vertices = std::exchange(waiting_, {});
    }
    for (const int t : changed) {
        forEachEndingOn(t, [&](int v) { vertices.push_back(v); });
        if (mesh_.alive(t)) {
            vertices.insert(vertices.end(), mesh_.triangle(t).begin(), mesh_.triangle(t).end());
        }
    }
    addSeparated(model, labels, vertices);
    sortUnique(vertices);
    const std::size_t known = vertices.size();
    addCrossed(model, changed, vertices);
    if (vertices.size() > known) {
        sortUnique(vertices);
    }
    return vertices;
}

bool IspcSet::isSeparated(const BodyModel& model, int vertex) const {
    const int slot = ofVertex_[vertex];
    return slot >= 0 && model.pieceOfVertex[vertex] != model.pieceOfVertex[model.ispcs[slot].t0];
}

void IspcSet::addSeparated(const BodyModel& model, const LabelChange& labels,
                           std::vector<int>& vertices) const {
    const auto check = [&](int v) {
        if (isSeparated(model, v)) {
            vertices.push_back(v);
        }
    };
    for (const LabelMove& move : labels.moves) {
        check(move.vertex);
        if (labels.piecesChanged && move.from >= 0) {
            mesh_.forEachOutgoing(move.vertex, [&](int h) { forEachEndingOn(h / 3, check); });
        }
    }
}

/// Of those that are not in `vertices` (ascending) yet.
void IspcSet::addCrossed(const BodyModel& model, std::span<const int> changed,
                         std::vector<int>& vertices) const {
    const std::vector<int> walls = newWalls(mesh_, changed);
    std::vector<Bounds> boxes(walls.size());
    for (std::size_t i = 0; i < walls.size(); ++i) {
        for (const int v : mesh_.triangle(walls[i])) {
            boxes[i].add(mesh_.restPosition(v));
        }
    }
    const RayTree wallTree(mesh_, walls);
    const auto known = static_cast<std::ptrdiff_t>(vertices.size());
    for (const int v : grid_.find(boxes)) {
        const int slot = ofVertex_[v];
        if (slot < 0 || std::binary_search(vertices.begin(), vertices.begin() + known, v)) {
            continue;
        }
        if (wallTree.crosses(mesh_.restPosition(v), restEnd(mesh_, model.ispcs[slot]))) {
            vertices.push_back(v);
        }
    }
}

}  // namespace kerf
