#include "sim/cut/cleanup/workspace.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "sim/cut/cleanup/limits.h"
#include "sim/cut/cleanup/material.h"
#include "sim/mesh/invariants.h"

namespace kerf::cut {

namespace {

void sortUnique(std::vector<int>& list) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
}

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

Workspace::Workspace(SurfaceMesh& m, double edge)
    : mesh(m),
      h(edge),
      bodyVolume_(std::fabs(meshVolume(m))),
      restVolume_(std::fabs(meshRestVolume(m))) {
    followMesh();
}

void Workspace::followMesh() {
    deviation_.resize(mesh.vertexCount(), 0.0);
    lockedIn_.resize(mesh.vertexCount(), -1);
}

void Workspace::lockOnly(const std::vector<RungNode>& rung) {
    ++round_;
    for (const RungNode& node : rung) {
        if (node.vertex < 0) {
            continue;
        }
        for (const int copy : livingCopies(mesh, node.vertex)) {
            lockedIn_[copy] = round_;
        }
    }
}

bool Workspace::touchesLocked(const std::vector<Patch>& patches) const {
    const auto hasLockedCorner = [&](int t) {
        const Triangle& corners = mesh.triangle(t);
        return std::any_of(corners.begin(), corners.end(), [&](int v) { return isLocked(v); });
    };
    return std::any_of(patches.begin(), patches.end(), [&](const Patch& patch) {
        return std::any_of(patch.before.begin(), patch.before.end(), hasLockedCorner);
    });
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

VolumeDefect Workspace::mostPerOperation() const {
    return {kVolumePerOperation * bodyVolume_, kVolumePerOperation * restVolume_};
}

bool Workspace::allows(const VolumeDefect& defect, bool wallsOnly) const {
    const double scale = wallsOnly ? kWallsCancel : 1.0;
    const VolumeDefect most = mostPerOperation();
    return defect.current <= scale * most.current && defect.rest <= scale * most.rest &&
           spent_.current + defect.current <= kVolumePerStroke * bodyVolume_ &&
           spent_.rest + defect.rest <= kVolumePerStroke * restVolume_;
}

void Workspace::spend(const VolumeDefect& defect) {
    spent_.current += defect.current;
    spent_.rest += defect.rest;
}

double Workspace::volumeSpent() const {
    return std::max(spent_.current / bodyVolume_, spent_.rest / restVolume_);
}

void Workspace::moveVertex(const Patch& patch) {
    mesh.setPosition(patch.vertex, patch.position);
    mesh.setRestPosition(patch.vertex, patch.rest);
    mesh.setVelocity(patch.vertex, patch.velocity);
    moved_.push_back(patch.vertex);
    mesh.forEachOutgoing(patch.vertex, [&](int spoke) { noteChanged(spoke / 3); });
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
