#include "tests/support/reference/reference_contact.h"

#include <tuple>

#include "sim/mesh/box_tree.h"
#include "sim/mesh/triangle.h"

namespace kerf {

namespace {

Corners cornersOf(const std::array<std::uint32_t, 4>& t, const std::vector<Vec3>& at) {
    return {at[t[0]], at[t[1]], at[t[2]]};
}

Vec3 weighted(const Vec3& weights, const Corners& c) {
    return weights[0] * c[0] + weights[1] * c[1] + weights[2] * c[2];
}

/// Weights of a point of the plane of the triangle, which may lie outside.
Vec3 planeWeights(const Corners& c, const Vec3& p) {
    const Vec3 normal = areaNormal(c);
    const double scale = 1 / normal.squaredNorm();
    const double second = areaNormal(c[0], p, c[2]).dot(normal) * scale;
    const double third = areaNormal(c[0], c[1], p).dot(normal) * scale;
    return {1 - second - third, second, third};
}

/// Of each vertex, of its skin and of its walls: the sum of the area normals over the sum of their
/// lengths; both are the same where there is one kind alone.
std::vector<std::array<Vec3, 2>> vertexNormals(const BodyModel& model,
                                               const std::vector<Vec3>& at) {
    std::vector<std::array<Vec3, 2>> sums(at.size(), {Vec3::Zero(), Vec3::Zero()});
    std::vector<std::array<double, 2>> areas(at.size(), {0.0, 0.0});
    for (const auto& t : model.triangles) {
        const Vec3 normal = areaNormal(cornersOf(t, at));
        for (int k = 0; k < 3; ++k) {
            sums[t[k]][t[3] & 1u] += normal;
            areas[t[k]][t[3] & 1u] += normal.norm();
        }
    }
    for (std::size_t v = 0; v < at.size(); ++v) {
        for (const int kind : {0, 1}) {
            if (areas[v][kind] > 0) {
                sums[v][kind] /= areas[v][kind];
            }
        }
        for (const int kind : {0, 1}) {
            if (!(areas[v][kind] > 0)) {
                sums[v][kind] = sums[v][1 - kind];
            }
        }
    }
    return sums;
}

/// Whether one of two normals opposes that of a triangle, of any length.
bool opposes(const std::array<Vec3, 2>& normals, const Vec3& normal) {
    return std::min(normals[0].dot(normal), normals[1].dot(normal)) <
           shared::kOpposed * normal.norm();
}

/// The shortest column of each vertex, of those that end beside it where none begin [m].
std::vector<double> wallsBehind(const BodyModel& model) {
    std::vector<double> own(model.restPositions.size(), shared::kNoWall);
    std::vector<double> others = own;
    for (const shared::IspcConstraint& column : model.ispcs) {
        own[column.vertex] = std::min<double>(own[column.vertex], column.rest_length);
        for (const std::uint32_t v : {column.t0, column.t1, column.t2}) {
            others[v] = std::min<double>(others[v], column.rest_length);
        }
    }
    for (std::size_t v = 0; v < own.size(); ++v) {
        own[v] = own[v] < shared::kNoWall ? own[v] : others[v];
    }
    return own;
}

}  // namespace

/// A vertex at a triangle in one substep.
struct ReferenceContact::Contact {
    std::array<std::uint32_t, 4> vertices;  ///< the vertex, then the corners
    std::array<double, 4> gains;            ///< 1, then minus the weights of the touched point
    Vec3 normal;
    Vec3 impulse;      ///< so far [m]
    double least = 0;  ///< change of the gap by displacements [m]
    double push = 0;   ///< [m]

    void setWeights(const Vec3& weights) { gains = {1, -weights[0], -weights[1], -weights[2]}; }
};

ReferenceContact::ReferenceContact(const BodyModel& model, const shared::ContactUniforms& uniforms,
                                   std::vector<double> inverseMass)
    : model_(model), uniforms_(uniforms), inverseMass_(std::move(inverseMass)) {
    for (const Vec3f& p : model.restPositions) {
        rest_.push_back(p.cast<double>());
    }
    restNormals_ = vertexNormals(model, rest_);
    walls_ = wallsBehind(model);
    touchesWall_.assign(rest_.size(), false);
    for (const auto& t : model.triangles) {
        for (int k = 0; k < 3 && (t[3] & 1u) != 0; ++k) {
            touchesWall_[t[k]] = true;
        }
    }
}

std::vector<std::vector<ReferenceCandidate>> ReferenceContact::findCandidates(
    const ReferenceState& state) const {
    const std::vector<std::array<Vec3, 2>> normals = vertexNormals(model_, state.positions);
    std::vector<std::vector<ReferenceCandidate>> all(state.positions.size());
    std::vector<int> triangles(model_.triangles.size());
    std::iota(triangles.begin(), triangles.end(), 0);
    const auto boundsOf = [&](int t) {
        Bounds bounds;
        for (const Vec3& corner : cornersOf(model_.triangles[t], state.positions)) {
            bounds.add(corner);
        }
        return bounds;
    };
    BoxTree tree(triangles, boundsOf);
    for (std::uint32_t v = 0; v < all.size(); ++v) {
        const int piece = model_.pieceOfVertex[v];
        if (piece < 0 || isChip(piece)) {
            continue;
        }
        Bounds around;
        around.add(state.positions[v]);
        around.widen(uniforms_.margin);
        tree.find(
            boundsOf, [&](const Bounds& box) { return box.overlaps(around); },
            [&](int t) {
                const Vec3 normal = areaNormal(cornersOf(model_.triangles[t], state.positions));
                const bool opposed = opposes(normals[v], normal);
                ReferenceCandidate candidate;
                if (opposed && consider(v, t, state, candidate)) {
                    all[v].push_back(candidate);
                }
            });
        std::ranges::sort(
            all[v], {}, [](const ReferenceCandidate& c) { return std::tuple(c.key, c.triangle); });
        all[v].resize(std::min<std::size_t>(all[v].size(), shared::kCandidatesPerPoint));
    }
    return all;
}

bool ReferenceContact::consider(std::uint32_t vertex, std::uint32_t triangle,
                                const ReferenceState& state, ReferenceCandidate& candidate) const {
    const auto& t = model_.triangles[triangle];
    const int piece = static_cast<int>(t[3] >> 8);
    if (std::find(t.begin(), t.begin() + 3, vertex) != t.begin() + 3 || isChip(piece)) {
        return false;
    }
    const Corners corners = cornersOf(t, state.positions);
    const Vec3& p = state.positions[vertex];
    const Vec3 speed = state.velocities[vertex] -
                       weighted(Vec3::Constant(1.0 / 3), cornersOf(t, state.velocities));
    const double range =
        std::min<double>(uniforms_.margin, uniforms_.reach + uniforms_.interval * speed.norm());
    const Vec3 weights = closestWeights(p, corners[0], corners[1], corners[2]);
    const double away = (p - weighted(weights, corners)).norm();
    if (away > range || (piece == model_.pieceOfVertex[vertex] && !mayTouch(vertex, triangle))) {
        return false;
    }
    const double depth = areaNormal(corners).normalized().dot(corners[0] - p);
    const double wall =
        weights[0] * walls_[t[0]] + weights[1] * walls_[t[1]] + weights[2] * walls_[t[2]];
    if (depth > 0 && depth > shared::kDeepInWall * wall) {
        return false;
    }
    const Corners rest = cornersOf(t, rest_);
    const Vec3 restWeights = closestWeights(rest_[vertex], rest[0], rest[1], rest[2]);
    const double separation = (rest_[vertex] - weighted(restWeights, rest)).norm();
    candidate = {triangle,
                 uniforms_.thickness * std::clamp(separation / uniforms_.h - 0.5, 0.0, 1.0),
                 away / range};
    return true;
}

bool ReferenceContact::mayTouch(std::uint32_t vertex, std::uint32_t triangle) const {
    const auto& t = model_.triangles[triangle];
    const Corners rest = cornersOf(t, rest_);
    const Vec3 normal = areaNormal(rest).normalized();
    const Vec3 weights = closestWeights(rest_[vertex], rest[0], rest[1], rest[2]);
    const double separation = (rest_[vertex] - weighted(weights, rest)).norm();
    const double height = normal.dot(rest_[vertex] - rest[0]);
    const bool opposed = opposes(restNormals_[vertex], normal);
    if (separation < shared::kNearInRest * std::max<double>(uniforms_.h, longestEdge(rest))) {
        return (t[3] & 1u) != 0 && touchesWall_[vertex] && opposed &&
               height >= -shared::kSlabDepth * uniforms_.h;
    }
    return !(opposed && height < -0.5 * separation && separation < shared::kArmWidth * uniforms_.h);
}

bool ReferenceContact::detect(std::uint32_t vertex,
                              const std::vector<ReferenceCandidate>& candidates,
                              const ReferenceState& state, Contact& contact) const {
    const auto at = [&](std::uint32_t v) -> Vec3 {
        return state.positions[v] + state.displacements[v];
    };
    double least = 1e300;
    double thickness = 0;
    double lateral = 0;
    for (const ReferenceCandidate& candidate : candidates) {
        const auto& t = model_.triangles[candidate.triangle];
        const Corners corners{at(t[0]), at(t[1]), at(t[2])};
        const Vec3 weights = closestWeights(at(vertex), corners[0], corners[1], corners[2]);
        const Vec3 away = at(vertex) - weighted(weights, corners);
        if (away.squaredNorm() < shared::kNearerBy * least) {
            least = away.squaredNorm();
            lateral = away.cross(areaNormal(corners).normalized()).norm();
            thickness = candidate.thickness;
            contact.vertices = {vertex, t[0], t[1], t[2]};
        }
    }
    const Vec3& own = state.positions[vertex];
    const Corners touched{state.positions[contact.vertices[1]],
                          state.positions[contact.vertices[2]],
                          state.positions[contact.vertices[3]]};
    contact.normal = areaNormal(touched).normalized();
    const double before = contact.normal.dot(own - touched[0]);
    contact.setWeights(planeWeights(touched, own - before * contact.normal));
    Vec3 slip = Vec3::Zero();
    for (int k = 0; k < 4; ++k) {
        slip += contact.gains[k] * state.displacements[contact.vertices[k]];
    }
    const double gap = before + contact.normal.dot(slip);
    const double hair = shared::kHair * uniforms_.h;
    const double lowest = std::min(before, std::max(thickness, hair));
    contact.least = lowest - before;
    const double reached = std::max(gap, lowest);
    const double approach = std::max(lowest - gap, 0.0);
    contact.push = std::clamp(std::max(std::min(approach, hair) - reached,
                                       shared::kThicknessRate * (thickness - reached)),
                              0.0, static_cast<double>(uniforms_.lift_speed) * uniforms_.substep);
    const Vec3 along = slip - slip.dot(contact.normal) * contact.normal;
    const double held = std::min(along.norm(), uniforms_.friction * approach);
    contact.impulse = approach * contact.normal -
                      (along.norm() > 0 ? Vec3(held / along.norm() * along) : Vec3::Zero());
    if (approach > 0) {
        const double lever = std::clamp<double>(before, -uniforms_.thickness, uniforms_.thickness);
        const Vec3 aside = -lever / approach * (contact.impulse - approach * contact.normal);
        contact.setWeights(planeWeights(touched, own - before * contact.normal + aside));
    }
    return (approach > 0 || contact.push > 0) && lateral <= shared::kLateralSlack * uniforms_.h &&
           gap >= -uniforms_.margin;
}

int ReferenceContact::respond(const std::vector<std::vector<ReferenceCandidate>>& candidates,
                              ReferenceState& state) const {
    std::vector<Contact> contacts;
    std::vector<double> taken(state.positions.size(), 0.0);
    for (std::uint32_t v = 0; v < candidates.size(); ++v) {
        Contact contact;
        if (!candidates[v].empty() && detect(v, candidates[v], state, contact)) {
            contacts.push_back(contact);
            for (int k = 0; k < 4; ++k) {
                taken[contact.vertices[k]] += std::fabs(contact.gains[k]);
            }
        }
    }
    std::vector<Vec3> changes;
    for (const Contact& contact : contacts) {
        changes.push_back(contact.impulse);
        apply(contact, taken, contact.push * contact.normal, state.positions);
    }
    applyAll(contacts, taken, changes, state.displacements);
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        changes[i] = goOn(contacts[i], state.displacements) - contacts[i].impulse;
    }
    applyAll(contacts, taken, changes, state.displacements);
    return static_cast<int>(contacts.size());
}

void ReferenceContact::applyAll(const std::vector<Contact>& contacts,
                                const std::vector<double>& taken, const std::vector<Vec3>& changes,
                                std::vector<Vec3>& vectors) const {
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        apply(contacts[i], taken, changes[i], vectors);
    }
}

void ReferenceContact::apply(const Contact& contact, const std::vector<double>& taken,
                             const Vec3& change, std::vector<Vec3>& vectors) const {
    double weight = 0;
    for (int k = 0; k < 4; ++k) {
        const std::uint32_t v = contact.vertices[k];
        weight += taken[v] * inverseMass_[v] * std::fabs(contact.gains[k]);
    }
    for (int k = 0; k < 4 && weight > 0; ++k) {
        const std::uint32_t v = contact.vertices[k];
        vectors[v] += contact.gains[k] * inverseMass_[v] / weight * change;
    }
}

Vec3 ReferenceContact::goOn(const Contact& contact, const std::vector<Vec3>& displacements) const {
    Vec3 wanted = contact.impulse;
    for (int k = 0; k < 4; ++k) {
        wanted -= contact.gains[k] * displacements[contact.vertices[k]];
    }
    const double pressed = std::max(contact.normal.dot(wanted) + contact.least, 0.0);
    const Vec3 along = wanted - contact.normal.dot(wanted) * contact.normal;
    const double held = std::min(along.norm(), uniforms_.friction * pressed);
    return pressed * contact.normal +
           (along.norm() > 0 ? Vec3(held / along.norm() * along) : Vec3::Zero());
}

}  // namespace kerf
