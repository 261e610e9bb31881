#include "sim/cut/cleanup/workspace.h"

#include "sim/base/containers.h"
#include "sim/cut/cleanup/copies.h"
#include "sim/mesh/invariants.h"
#include "sim/mesh/triangle.h"

namespace kerf::cut {

namespace {

// Nothing within this share of the edge length of the rung is changed.
constexpr double kRungReach = 0.1;

/// Both lists sorted.
std::vector<int> without(const std::vector<int>& list, const std::vector<int>& others) {
    std::vector<int> result;
    std::set_difference(list.begin(), list.end(), others.begin(), others.end(),
                        std::back_inserter(result));
    return result;
}

void join(std::vector<int>& list, const std::vector<int>& others) {
    list.insert(list.end(), others.begin(), others.end());
    sortUnique(list);
}

/// The part of `vertices` that is older than the step.
std::vector<int> olderThan(int firstNew, const std::vector<int>& vertices) {
    std::vector<int> result;
    std::copy_if(vertices.begin(), vertices.end(), std::back_inserter(result),
                 [&](int v) { return v < firstNew; });
    return result;
}

}  // namespace

Workspace::Workspace(SurfaceMesh& m, const EdgeLengthField& edgeLengths)
    : mesh(m),
      edgeLengths_(edgeLengths),
      edgeLength_(edgeLengths.mean()),
      bodyVolume_(std::fabs(meshVolume(m))),
      restVolume_(std::fabs(meshRestVolume(m))) {
    followMesh();
}

bool Workspace::isKept(const std::vector<int>& copies) const {
    return !judgesAtRest_ && std::ranges::any_of(copies, [&](int v) {
        return mesh.isOriginal(v) && !isBesideCut(v);
    });
}

bool Workspace::isBesideCut(int v) const {
    const Vec3& p = mesh.position(v);
    bool isBeside = false;
    mesh.forEachOutgoing(v, [&](int h) {
        const int a = mesh.target(h);
        const int b = mesh.isOriginal(mesh.apex(h)) ? a : mesh.apex(h);
        isBeside |=
            !mesh.isOriginal(a) &&
            distanceToSegment(p, mesh.position(a), mesh.position(b)) <= kGoodEdge * edgeLength_;
    });
    return isBeside;
}

double Workspace::edgeLengthAt(int triangle) const {
    const Triangle& c = mesh.triangle(triangle);
    const auto atRest = [&](int v) -> const Vec3& {
        return judgesAtRest_ ? mesh.position(v) : mesh.restPosition(v);
    };
    return edgeLengths_.localEdgeLength((atRest(c[0]) + atRest(c[1]) + atRest(c[2])) / 3);
}

void Workspace::exchangeShapes() {
    judgesAtRest_ = !judgesAtRest_;
    mesh.exchangeShapes();
    std::swap(bodyVolume_, restVolume_);
    std::swap(spent_.current, spent_.rest);
}

void Workspace::followMesh() {
    deviation_.resize(mesh.vertexCount(), 0.0);
    onRungIn_.resize(mesh.vertexCount(), -1);
}

void Workspace::keepAround(const std::vector<RungNode>& rung) {
    ++round_;
    rung_.clear();
    for (const RungNode& node : rung) {
        rung_.push_back(node.position);
        if (node.vertex >= 0) {
            for (const int copy : livingCopies(mesh, node.vertex)) {
                onRungIn_[copy] = round_;
            }
        }
    }
}

bool Workspace::trianglesTouchRung(const std::vector<int>& triangles) const {
    Bounds bounds;
    for (const int t : triangles) {
        for (const int v : mesh.triangle(t)) {
            if (onRungIn_[v] == round_) {
                return true;
            }
            bounds.add(mesh.position(v));
        }
    }
    const double reach = 0.5 * bounds.diagonal() + kRungReach * edgeLength_;
    for (std::size_t k = 0; k + 1 < rung_.size(); ++k) {
        if (distanceToSegment(bounds.center(), rung_[k], rung_[k + 1]) < reach) {
            return true;
        }
    }
    return false;
}

bool Workspace::touchesRung(const std::vector<OneRing>& rings) const {
    return std::any_of(rings.begin(), rings.end(),
                       [&](const OneRing& ring) { return trianglesTouchRung(ring.before); });
}

double Workspace::deviationAt(const std::vector<int>& copies) const {
    double most = 0;
    for (const int v : copies) {
        most = std::max(most, deviation_[v]);
    }
    return most;
}

void Workspace::setDeviation(const std::vector<int>& copies, double deviation) {
    for (const int v : copies) {
        deviation_[v] = deviation;
    }
}

VolumeDefect Workspace::most(double share) const {
    const double ofOther = judgesAtRest_ ? kCrumpled : 1.0;
    return {share * bodyVolume_, ofOther * share * restVolume_};
}

VolumeDefect Workspace::mostPerOperation() const {
    return most(kVolumePerOperation);
}

bool Workspace::allows(const VolumeDefect& defect, bool wallsOnly) const {
    const VolumeDefect once = most((wallsOnly ? kWallsCancel : 1.0) * kVolumePerOperation);
    const VolumeDefect inAll = most(kVolumePerStroke);
    return defect.current <= once.current && defect.rest <= once.rest &&
           spent_.current + defect.current <= inAll.current &&
           spent_.rest + defect.rest <= inAll.rest;
}

void Workspace::spend(const VolumeDefect& defect) {
    spent_.current += defect.current;
    spent_.rest += defect.rest;
}

double Workspace::volumeSpent() const {
    return spent_.current / bodyVolume_ + spent_.rest / restVolume_;
}

void Workspace::moveVertex(const OneRing& ring) {
    restMotion_ += judgesAtRest_ ? (ring.position - mesh.position(ring.vertex)).norm()
                                 : (ring.rest - mesh.restPosition(ring.vertex)).norm();
    mesh.setPosition(ring.vertex, ring.position);
    mesh.setRestPosition(ring.vertex, ring.rest);
    mesh.setVelocity(ring.vertex, ring.velocity);
    moved_.push_back(ring.vertex);
    mesh.forEachOutgoing(ring.vertex, [&](int spoke) { noteChanged(spoke / 3); });
}

void Workspace::removeTriangle(int triangle) {
    mesh.removeTriangle(triangle);
    removedTriangles_.push_back(triangle);
}

void Workspace::removeVertex(int vertex) {
    mesh.removeVertex(vertex);
    deadVertices_.push_back(vertex);
}

std::vector<int> Workspace::takeChanged() {
    allChanged_.insert(allChanged_.end(), changed_.begin(), changed_.end());
    return std::exchange(changed_, {});
}

void Workspace::moveChangesTo(CutDelta& delta) {
    takeChanged();
    sortUnique(allChanged_);
    sortUnique(removedTriangles_);
    std::vector<int> added = delta.addedTriangles;
    sortUnique(added);
    join(delta.removedTriangles, without(removedTriangles_, added));
    delta.addedTriangles = without(added, removedTriangles_);
    join(delta.changedTriangles, allChanged_);
    delta.changedTriangles =
        without(without(delta.changedTriangles, removedTriangles_), delta.addedTriangles);
    join(delta.deadVertices, olderThan(delta.firstNewVertex, deadVertices_));
    join(delta.movedVertices, olderThan(delta.firstNewVertex, moved_));
    delta.movedVertices = without(delta.movedVertices, delta.deadVertices);
    for (std::vector<int>* list : {&allChanged_, &removedTriangles_, &deadVertices_, &moved_}) {
        list->clear();
    }
}

}  // namespace kerf::cut
