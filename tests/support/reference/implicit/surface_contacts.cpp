#include "tests/support/reference/implicit/surface_contacts.h"

#include "sim/contact/contact_solver.h"
#include "sim/mesh/triangle.h"

namespace kerf {

namespace {

constexpr std::uint64_t kOfSurface = 1;  // of ContactRow::memory, added to twice the vertex

double fastestOf(const ReferenceState& state) {
    Bounds speeds;
    for (const Vec3& v : state.velocities) {
        speeds.add(v);
    }
    return speeds.diagonal();
}

}  // namespace

SurfaceContacts::SurfaceContacts(const BodyModel& model, double friction,
                                 std::optional<double> floor, bool pieces)
    : model_(model), friction_(friction), floor_(floor), pieces_(pieces) {}

ContactRows SurfaceContacts::find(const ReferenceState& state, double step) {
    ContactRows rows;
    if (floor_.has_value()) {
        addFloor(state, step, rows);
    }
    if (pieces_) {
        addSurfaces(state, step, rows);
    }
    return rows;
}

void SurfaceContacts::addFloor(const ReferenceState& state, double step, ContactRows& rows) const {
    const double near = 0.02 * model_.diagonal;
    for (std::uint32_t v = 0; v < state.positions.size(); ++v) {
        const double gap = state.positions[v].y() - *floor_;
        if (model_.pieceOfVertex[v] >= 0 && gap < near - 1.5 * step * state.velocities[v].y()) {
            ContactRow row;
            row.count = 1;
            row.vertices = {v};
            row.weights = {1};
            row.gap = gap;
            row.friction = friction_;
            row.memory = 2 * std::uint64_t{v};
            rows.push_back(row);
        }
    }
}

void SurfaceContacts::addSurfaces(const ReferenceState& state, double step,
                                  ContactRows& rows) const {
    ContactSettings settings = contactSettings(Params{});
    settings.substep = step;
    settings.substeps = 1;
    const double edge = contactEdgeLength(model_);
    const shared::ContactUniforms uniforms = contactUniforms(settings, edge, fastestOf(state));
    const ReferenceContact contact(model_, uniforms, {});
    const auto candidates = contact.findCandidates(state);
    const auto ahead = [&](std::uint32_t v) -> Vec3 {
        return state.positions[v] + step * state.velocities[v];
    };
    for (std::uint32_t v = 0; v < candidates.size(); ++v) {
        double least = 1e300;
        ContactRow row;
        for (const ReferenceCandidate& candidate : candidates[v]) {
            const auto& t = model_.triangles[candidate.triangle];
            const Corners there{ahead(t[0]), ahead(t[1]), ahead(t[2])};
            const Vec3 weights = closestWeights(ahead(v), there[0], there[1], there[2]);
            const Vec3 away =
                ahead(v) - weights[0] * there[0] - weights[1] * there[1] - weights[2] * there[2];
            if (away.squaredNorm() >= shared::kNearerBy * least) {
                continue;
            }
            least = away.squaredNorm();
            const Corners here{state.positions[t[0]], state.positions[t[1]], state.positions[t[2]]};
            const double lateral = away.cross(unitNormal(there[0], there[1], there[2])).norm();
            row.count = lateral <= shared::kLateralSlack * edge ? 4 : 0;
            row.vertices = {v, t[0], t[1], t[2]};
            row.weights = {1, -weights[0], -weights[1], -weights[2]};
            row.normal = unitNormal(here[0], here[1], here[2]);
            row.gap = row.normal.dot(state.positions[v] - here[0]) - candidate.thickness;
        }
        if (row.count > 0) {
            row.friction = friction_;
            row.memory = 2 * std::uint64_t{v} + kOfSurface;
            rows.push_back(row);
        }
    }
}

}  // namespace kerf
