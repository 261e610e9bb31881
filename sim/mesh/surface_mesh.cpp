#include "sim/mesh/surface_mesh.h"

#include <cassert>
#include <stdexcept>
#include <unordered_map>

#include "sim/base/containers.h"

namespace kerf {

namespace {

std::uint64_t directedKey(int a, int b) {
    return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(a)) << 32) |
           static_cast<std::uint32_t>(b);
}

}  // namespace

SurfaceMesh::SurfaceMesh(const SurfaceMesh& other) {
    reserve(withGrowthRoom(other.vertexCount()), withGrowthRoom(other.triangleSlots()));
    *this = other;
}

void SurfaceMesh::reserve(std::size_t vertices, std::size_t triangles) {
    old_.reserve(vertices);
    positions_.reserve(vertices);
    restPositions_.reserve(vertices);
    velocities_.reserve(vertices);
    outgoing_.reserve(vertices);
    copyGroup_.reserve(vertices);
    triangles_.reserve(triangles);
    twins_.reserve(triangles);
    kinds_.reserve(triangles);
    wallLabels_.reserve(triangles);
}

SurfaceMesh SurfaceMesh::fromTriangles(const std::vector<Vec3>& positions,
                                       const std::vector<Triangle>& triangles) {
    SurfaceMesh mesh;
    mesh.reserve(withGrowthRoom(positions.size()), withGrowthRoom(triangles.size()));
    mesh.positions_ = positions;
    mesh.originalVertices_ = static_cast<int>(positions.size());
    mesh.restPositions_ = mesh.positions_;
    mesh.velocities_.assign(mesh.positions_.size(), Vec3::Zero());
    mesh.old_.assign(mesh.positions_.size(), 0);
    mesh.outgoing_.assign(mesh.positions_.size(), -1);
    mesh.copyGroup_.assign(mesh.positions_.size(), -1);
    mesh.triangles_ = triangles;
    mesh.kinds_.assign(mesh.triangles_.size(), SurfaceKind::skin);
    mesh.wallLabels_.assign(mesh.triangles_.size(), -1);
    mesh.twins_.assign(mesh.triangles_.size(), {-1, -1, -1});
    mesh.aliveTriangles_ = static_cast<int>(mesh.triangles_.size());

    std::unordered_map<std::uint64_t, int> halfEdges;
    halfEdges.reserve(mesh.triangles_.size() * 3);
    const int halfEdgeCount = 3 * mesh.triangleSlots();
    for (int h = 0; h < halfEdgeCount; ++h) {
        const int u = mesh.origin(h);
        const int v = mesh.target(h);
        if (!halfEdges.emplace(directedKey(u, v), h).second) {
            throw std::invalid_argument("two triangles run along one edge in the same direction");
        }
        mesh.outgoing_[u] = h;
    }
    for (int h = 0; h < halfEdgeCount; ++h) {
        const auto twin = halfEdges.find(directedKey(mesh.target(h), mesh.origin(h)));
        if (twin == halfEdges.end()) {
            throw std::invalid_argument("an edge has a triangle on one side only");
        }
        mesh.setTwin(h, twin->second);
    }
    return mesh;
}

int SurfaceMesh::findHalfEdge(int u, int v) const {
    const int first = outgoing_[u];
    int h = first;
    while (h >= 0 && target(h) != v) {
        h = rotate(h);
        h = h == first ? -1 : h;
    }
    return h;
}

int SurfaceMesh::addVertex(const Vec3& position, const Vec3& rest, const Vec3& velocity) {
    positions_.push_back(position);
    restPositions_.push_back(rest);
    velocities_.push_back(velocity);
    old_.push_back(0);
    outgoing_.push_back(-1);
    copyGroup_.push_back(-1);
    return vertexCount() - 1;
}

void SurfaceMesh::noteTorn(int firstVertex) {
    torn_.resize(static_cast<std::size_t>(vertexCount()), 0);
    for (int v = firstVertex; v < vertexCount(); ++v) {
        const int first = firstCopy(v);
        torn_[v] = first >= firstVertex || isTorn(first) ? 1 : 0;
    }
}

int SurfaceMesh::addTriangle(const Triangle& corners, SurfaceKind kind, int wallLabel) {
    triangles_.push_back(corners);
    twins_.push_back({-1, -1, -1});
    kinds_.push_back(kind);
    wallLabels_.push_back(wallLabel);
    ++aliveTriangles_;
    return triangleSlots() - 1;
}

void SurfaceMesh::removeTriangle(int t) {
    triangles_[t][0] = -1;
    --aliveTriangles_;
}

void SurfaceMesh::leaveTo(VertexSource& source) {
    source_ = &source;
    std::ranges::fill(old_, 1);
}

void SurfaceMesh::setState(int v, const Vec3& position, const Vec3& velocity) {
    positions_[v] = position;
    velocities_[v] = velocity;
    old_[v] = 0;
}

void SurfaceMesh::bring(std::span<const int> vertices) const {
    if (std::ranges::any_of(vertices, [this](int v) { return isOld(v); })) {
        source_->bring(vertices);
    }
}

void SurfaceMesh::bringAll() const {
    if (source_ != nullptr) {
        source_->bringAll();
        assert(std::ranges::none_of(old_, [](std::uint8_t old) { return old != 0; }));
        source_ = nullptr;
    }
}

void SurfaceMesh::removeVertex(int v) {
    bring({&v, 1});
    leaveCopies(v);
    outgoing_[v] = -1;
    velocities_[v] = Vec3::Zero();
}

int SurfaceMesh::groupOf(int v) {
    if (copyGroup_[v] < 0) {
        copyGroup_[v] = static_cast<int>(copyMembers_.size());
        copyMembers_.emplace_back().reserve(2);
        copyMembers_.back().push_back(v);
    }
    return copyGroup_[v];
}

void SurfaceMesh::joinCopies(int a, int b) {
    const int keep = groupOf(a);
    if (a != b && copyGroup_[b] < 0) {
        copyGroup_[b] = keep;
        copyMembers_[keep].push_back(b);
        return;
    }
    const int join = copyGroup_[b];
    if (keep == join) {
        return;
    }
    for (const int v : copyMembers_[join]) {
        copyGroup_[v] = keep;
        copyMembers_[keep].push_back(v);
    }
    copyMembers_[join].clear();
}

void SurfaceMesh::leaveCopies(int v) {
    if (copyGroup_[v] >= 0) {
        std::vector<int>& members = copyMembers_[copyGroup_[v]];
        members.erase(std::find(members.begin(), members.end(), v));
        copyGroup_[v] = -1;
    }
}

int valence(const SurfaceMesh& mesh, int v) {
    int count = 0;
    mesh.forEachOutgoing(v, [&](int) { ++count; });
    return count;
}

bool hidden(const SurfaceMesh& mesh, int v) {
    if (mesh.openStroke() < 0 || mesh.outgoing(v) < 0) {
        return false;
    }
    bool allAbsent = true;
    mesh.forEachOutgoing(v, [&](int h) { allAbsent = allAbsent && mesh.absent(h / 3); });
    return allAbsent;
}

std::vector<int> livingTriangles(const SurfaceMesh& mesh) {
    std::vector<int> slots;
    slots.reserve(mesh.aliveTriangles());
    for (int t = 0; t < mesh.triangleSlots(); ++t) {
        if (mesh.alive(t)) {
            slots.push_back(t);
        }
    }
    return slots;
}

std::vector<int> absentTriangles(const SurfaceMesh& mesh) {
    std::vector<int> slots;
    for (int t = 0; t < mesh.triangleSlots() && mesh.openStroke() >= 0; ++t) {
        if (mesh.alive(t) && mesh.absent(t)) {
            slots.push_back(t);
        }
    }
    return slots;
}

}  // namespace kerf
