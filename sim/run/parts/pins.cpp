#include "sim/run/parts/pins.h"

#include "sim/body/piece_masses.h"

namespace kerf {
namespace {

std::array<double, 3> restPositionOf(const SurfaceMesh& mesh, std::uint32_t vertex) {
    const Vec3& p = mesh.restPosition(static_cast<int>(vertex));
    return {p.x(), p.y(), p.z()};
}

}  // namespace

bool HeldVertices::holds(int vertex) const {
    return std::ranges::binary_search(vertices_, static_cast<std::uint32_t>(vertex));
}

void HeldVertices::collectPlaces(const SurfaceMesh& mesh) {
    positions_.clear();
    for (const std::uint32_t v : vertices_) {
        positions_.insert(restPositionOf(mesh, v));
    }
}

int HeldVertices::change(const Region& region, bool holds, const SurfaceMesh& mesh) {
    std::vector<std::uint32_t> after;
    int changed = 0;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const bool before = this->holds(v);
        const bool chosen = mesh.outgoing(v) >= 0 && contains(region, mesh.position(v));
        changed += chosen && before != holds;
        if (chosen ? holds : before) {
            after.push_back(static_cast<std::uint32_t>(v));
        }
    }
    vertices_ = std::move(after);
    collectPlaces(mesh);
    return changed;
}

bool HeldVertices::follow(const SurfaceMesh& mesh, const CutDelta& delta) {
    if (vertices_.empty()) {
        return false;
    }
    const auto isDead = [&](std::uint32_t v) { return mesh.outgoing(static_cast<int>(v)) < 0; };
    bool changed = std::erase_if(vertices_, isDead) > 0;
    for (int v = delta.firstNewVertex; v < mesh.vertexCount(); ++v) {
        const auto vertex = static_cast<std::uint32_t>(v);
        if (!isDead(vertex) && positions_.contains(restPositionOf(mesh, vertex))) {
            vertices_.push_back(vertex);
            changed = true;
        }
    }
    collectPlaces(mesh);
    return changed;
}

int Pins::change(const Pin& pin, const SurfaceMesh& mesh) {
    int changed = fixed_.change(pin.region, pin.pinned, mesh);
    for (Motion& motion : motions_) {
        changed += motion.held.change(pin.region, false, mesh);
    }
    std::erase_if(motions_, [](const Motion& motion) { return motion.held.empty(); });
    if (pin.velocity) {
        constexpr double kForever = std::numeric_limits<double>::infinity();
        Motion motion{++lastNumber_, *pin.velocity, pin.seconds.value_or(kForever), {}, {}, {}};
        changed += motion.held.change(pin.region, true, mesh);
        motion.start(mesh);
        motions_.push_back(std::move(motion));
    }
    return changed;
}

int Pins::change(const ApplyForce& apply, const SurfaceMesh& mesh) {
    if (apply.newtons == Vec3::Zero()) {
        int changed = 0;
        for (Force& force : forces_) {
            changed += force.held.change(apply.region, false, mesh);
        }
        std::erase_if(forces_, [](const Force& force) { return force.held.empty(); });
        return changed;
    }
    const bool wider = apply.continues && !forces_.empty();
    Force force = wider ? forces_.back() : Force{};
    force.newtons = apply.newtons;
    const int changed = force.held.change(apply.region, true, mesh);
    if (changed > 0) {
        forces_.resize(forces_.size() - (wider ? 1 : 0));
        forces_.push_back(std::move(force));
    }
    return changed;
}

bool Pins::follow(const SurfaceMesh& mesh, const CutDelta& delta) {
    for (Motion& motion : motions_) {
        motion.follow(mesh, delta);
    }
    for (Force& force : forces_) {
        force.held.follow(mesh, delta);
    }
    std::erase_if(motions_, [](const Motion& motion) { return motion.held.empty(); });
    std::erase_if(forces_, [](const Force& force) { return force.held.empty(); });
    return fixed_.follow(mesh, delta);
}

void Pins::goOnFrom(const Pins& now, const SurfaceMesh& mesh) {
    for (Motion& motion : motions_) {
        const auto same = std::ranges::find(now.motions_, motion.number, &Motion::number);
        motion.left = same != now.motions_.end() ? same->left : motion.left;
        motion.start(mesh);
    }
}

void Pins::Motion::start(const SurfaceMesh& mesh) {
    moved.setZero();
    starts.clear();
    for (const std::uint32_t v : held.vertices()) {
        starts[restPositionOf(mesh, v)] = mesh.position(static_cast<int>(v));
    }
}

/// The clean-up moves vertices within the material.
void Pins::Motion::follow(const SurfaceMesh& mesh, const CutDelta& delta) {
    held.follow(mesh, delta);
    for (const std::uint32_t v : held.vertices()) {
        if (const auto rest = restPositionOf(mesh, v); !starts.contains(rest)) {
            starts[rest] = mesh.position(static_cast<int>(v)) - moved;
        }
    }
}

Pins::Course Pins::advance(double timeStep, const SurfaceMesh& mesh) {
    std::map<std::uint32_t, std::pair<Vec3, Vec3>> places;
    for (Motion& motion : motions_) {
        const double time = std::min(timeStep, motion.left);
        const Vec3 way = time * motion.velocity;
        for (const std::uint32_t v : motion.held.vertices()) {
            places[v] = {motion.starts.at(restPositionOf(mesh, v)) + motion.moved, way / timeStep};
        }
        motion.moved += way;
        motion.left -= time;
    }
    Course course;
    for (const auto& [vertex, place] : places) {
        course.vertices.push_back(vertex);
        course.from.push_back(place.first.cast<float>());
        course.velocities.push_back(place.second.cast<float>());
    }
    return course;
}

std::vector<shared::PullRecord> Pins::accelerations(const BodyModel& model, double density,
                                                    const std::vector<std::uint32_t>& others,
                                                    double drawnLength) const {
    std::map<std::uint32_t, Vec3> sums;
    for (const Force& force : forces_) {
        const auto& vertices = force.held.vertices();
        const double mass =
            std::accumulate(vertices.begin(), vertices.end(), 0.0,
                            [&](double sum, std::uint32_t v) { return sum + unitMass(model, v); });
        for (const std::uint32_t v : vertices) {
            if (mass > 0 && !std::ranges::binary_search(others, v)) {
                sums.try_emplace(v, Vec3::Zero()).first->second += force.newtons / (density * mass);
            }
        }
    }
    std::vector<shared::PullRecord> records;
    for (const auto& [vertex, acceleration] : sums) {
        const Vec3f a = acceleration.cast<float>();
        const Vec3f arrow = (drawnLength * acceleration.normalized()).cast<float>();
        records.push_back(
            {vertex, arrow.x(), arrow.y(), arrow.z(), a.x(), a.y(), a.z(), shared::kForcePull});
    }
    return records;
}

bool Pins::moves() const {
    return std::ranges::any_of(motions_, [](const Motion& motion) { return motion.left > 0; });
}

std::size_t Pins::count() const {
    std::size_t sum = fixed_.vertices().size();
    for (const Motion& motion : motions_) {
        sum += motion.held.vertices().size();
    }
    for (const Force& force : forces_) {
        sum += force.held.vertices().size();
    }
    return sum;
}

}  // namespace kerf
