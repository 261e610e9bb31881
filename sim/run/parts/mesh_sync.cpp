#include "sim/run/parts/mesh_sync.h"

#include "sim/base/containers.h"
#include "sim/base/math.h"
#include "sim/base/pausing.h"
#include "sim/mesh/triangle.h"

namespace kerf {

namespace {

// Of its half size: how much wider than asked the box is within which triangles are collected once
// one was asked for that nobody foresaw.
constexpr double kWidening = 0.5;

}  // namespace

void MeshSync::prefetch(const std::optional<OrientedBox>& box, std::span<const int> vertices) {
    prefetches_ = true;
    prefetched_ = box;
    solver_.measurer().watch(box, vertices);
}

void MeshSync::prefetchAll() {
    prefetchesAll_ = true;
    solver_.measurer().watchAll();
}

void MeshSync::invalidate() {
    forget();
    mesh_->leaveTo(*this);
}

double MeshSync::takePrefetched() {
    const WorkWatch watch;
    const std::optional<OrientedBox> box = std::exchange(prefetched_, std::nullopt);
    const bool watches = std::exchange(prefetches_, false);
    const bool all = std::exchange(prefetchesAll_, false);
    if (all) {
        all_ = solver_.measurer().takeAll();
        mesh_->bringAll();
        all_.reset();
    }
    if (watches) {
        takeWatched(box);
    }
    return watches || all ? watch.milliseconds() : 0;
}

void MeshSync::takeWatched(const std::optional<OrientedBox>& box) {
    const VertexStates watched = solver_.measurer().takeWatched();
    adopt(watched.records);
    if (!box || !watched.complete) {
        return;
    }
    known_ = box;
    const std::vector<int> around = trianglesAround(watched.records);
    triangles_.insert(triangles_.end(), around.begin(), around.end());
    sortUnique(triangles_);
}

std::vector<int> MeshSync::trianglesAround(const std::vector<shared::NearbyVertex>& states) const {
    std::vector<int> found;
    for (const shared::NearbyVertex& state : states) {
        mesh_->forEachOutgoing(static_cast<int>(state.vertex), [&](int h) {
            if (std::ranges::none_of(mesh_->triangle(h / 3),
                                     [this](int v) { return mesh_->isOld(v); })) {
                found.push_back(h / 3);
            }
        });
    }
    sortUnique(found);
    return found;
}

std::vector<int> MeshSync::lookInto(const OrientedBox& box) {
    if (mesh_->isWhole()) {
        return livingTriangles(*mesh_);
    }
    const VertexStates states = solver_.measurer().statesNear(box);
    adopt(states.records);
    return trianglesAround(states.records);
}

void MeshSync::forget() {
    known_.reset();
    triangles_.clear();
}

void MeshSync::adopt(const std::vector<shared::NearbyVertex>& states) {
    for (const shared::NearbyVertex& s : states) {
        if (const int v = static_cast<int>(s.vertex); mesh_->isOld(v)) {
            mesh_->setState(v, Vec3(s.x, s.y, s.z), Vec3(s.vx, s.vy, s.vz));
        }
    }
}

void MeshSync::bring(std::span<const int> vertices) {
    std::vector<int> old;
    std::ranges::copy_if(vertices, std::back_inserter(old),
                         [this](int v) { return mesh_->isOld(v); });
    if (readsAll_) {
        mesh_->bringAll();
        return;
    }
    adopt(solver_.measurer().statesOf(old).records);
}

void MeshSync::bringAll() {
    ++wholeReads_;
    const BodyState state = all_ ? *std::move(all_) : solver_.readState();
    for (int v = 0; v < mesh_->vertexCount(); ++v) {
        if (mesh_->isOld(v)) {
            mesh_->setState(v, state.positions[v].cast<double>(),
                            state.velocities[v].cast<double>());
        }
    }
}

std::vector<int> MeshSync::near(const OrientedBox& box) {
    if (!known_ || !contains(*known_, box)) {
        lookAround(box);
    }
    std::vector<int> found;
    std::ranges::copy_if(triangles_, std::back_inserter(found), [&](int t) {
        return mesh_->alive(t) && mayMeet(box, boxOf(cornersOf(*mesh_, t)));
    });
    return found;
}

/// O(n), of all vertices.
void MeshSync::lookAround(const OrientedBox& box) {
    known_ = box;
    known_->half *= 1 + kWidening;
    triangles_ = livingTriangles(*mesh_);
    std::erase_if(triangles_,
                  [this](int t) { return !mayMeet(*known_, boxOf(cornersOf(*mesh_, t))); });
}

void MeshSync::update(std::span<const int> triangles) {
    triangles_.insert(triangles_.end(), triangles.begin(), triangles.end());
    sortUnique(triangles_);
}

}  // namespace kerf
