#include "sim/run/parts/cohesive_zone.h"

#include "sim/base/containers.h"
#include "sim/mesh/triangle.h"

namespace kerf {

namespace {

// A cohesive zone is about 0.88 E J / s^2 long (Rice 1979).
constexpr double kZoneLength = 0.88;
// Of its reach: up to here a new bond is as stiff as at this opening.
constexpr double kStiffUpTo = 0.02;

/// The labels of the walls at a vertex, but for those of a stroke; ascending.
std::vector<int> labelsBeside(const SurfaceMesh& mesh, int v, int stroke) {
    std::vector<int> labels;
    mesh.forEachOutgoing(v, [&](int h) {
        const int label = mesh.wallLabel(SurfaceMesh::triangleOf(h));
        if (label >= 0 && label / 2 != stroke) {
            labels.push_back(label);
        }
    });
    sortUnique(labels);
    return labels;
}

bool hasWall(const SurfaceMesh& mesh, int v, int label) {
    bool found = false;
    mesh.forEachOutgoing(
        v, [&](int h) { found = found || mesh.wallLabel(SurfaceMesh::triangleOf(h)) == label; });
    return found;
}

}  // namespace

TearLaw tearLaw(const Params& params, double edge) {
    const auto zone = [&](double modulus, double toughness, double strength) {
        return kZoneLength * modulus * toughness / (strength * strength * edge);
    };
    const auto resolved = [&](double modulus, double toughness, double strength) {
        return strength *
               std::sqrt(std::min(1.0, zone(modulus, toughness, strength) / kEdgesInZone));
    };
    const double strength =
        resolved(params.youngsModulus, params.toughness, params.tensileStrength);
    return {params.toughness, strength, params.skinThickness * params.skinToughness,
            params.skinThickness *
                resolved(params.skinModulus, params.skinToughness, params.skinStrength),
            zone(params.youngsModulus, params.toughness, strength)};
}

int facingVertex(const SurfaceMesh& mesh, int v, int otherLabel) {
    const int group = mesh.copyGroup(v);
    if (group < 0) {
        return -1;
    }
    const int stroke = otherLabel / 2;
    const std::vector<int> beside = labelsBeside(mesh, v, stroke);
    int facing = -1;
    for (const int copy : mesh.copiesOfGroup(group)) {
        if (copy == v || !hasWall(mesh, copy, otherLabel)) {
            continue;
        }
        if (labelsBeside(mesh, copy, stroke) == beside) {
            return copy;
        }
        facing = facing < 0 ? copy : facing;
    }
    return facing;
}

void CohesiveZone::bond(const SurfaceMesh& mesh, const CutDelta& delta, int stroke,
                        int firstVertex) {
    const int label = 2 * stroke;
    std::set<int> bonded;
    for (const Bond& bond : bonds_) {
        bonded.insert({bond.plus, bond.minus});
    }
    for (const int t : delta.addedTriangles) {
        if (!mesh.alive(t) || mesh.wallLabel(t) != label) {
            continue;
        }
        for (const int v : mesh.triangle(t)) {
            const int facing = bonded.contains(v) ? -1 : facingVertex(mesh, v, label + 1);
            if (facing >= 0 && !bonded.contains(facing) && std::max(v, facing) >= firstVertex) {
                bonded.insert({v, facing});
                const auto place = std::ranges::lower_bound(bonds_, v, {}, &Bond::plus);
                bonds_.insert(place, {.plus = v, .minus = facing, .label = label});
            }
        }
    }
}

void CohesiveZone::follow(const SurfaceMesh& mesh) {
    std::erase_if(bonds_, [&](const Bond& bond) {
        const bool isGone = mesh.outgoing(bond.plus) < 0 || mesh.outgoing(bond.minus) < 0;
        spent_ += isGone ? bond.taken() : 0;
        return isGone;
    });
    for (Bond& bond : bonds_) {
        weigh(mesh, bond);
    }
}

void CohesiveZone::weigh(const SurfaceMesh& mesh, Bond& bond) const {
    double area = 0;
    double rim = 0;
    // A blade has made the wall of the same stroke where the tear began.
    const auto isTorn = [&](int v) {
        return find(v) != nullptr || facingVertex(mesh, v, bond.label + 1) < 0;
    };
    mesh.forEachOutgoing(bond.plus, [&](int h) {
        const int t = SurfaceMesh::triangleOf(h);
        if (mesh.wallLabel(t) != bond.label || !std::ranges::all_of(mesh.triangle(t), isTorn)) {
            return;
        }
        area += triangleArea(restCornersOf(mesh, t)) / 3;
        for (const int edge : {h, SurfaceMesh::previous(h)}) {
            if (mesh.kind(SurfaceMesh::triangleOf(mesh.twin(edge))) == SurfaceKind::skin) {
                rim += 0.5 *
                       (mesh.restPosition(mesh.target(edge)) - mesh.restPosition(mesh.origin(edge)))
                           .norm();
            }
        }
    });
    bond.force = law_.strength * area + law_.skinStrength * rim;
    bond.energy = law_.toughness * area + law_.skinToughness * rim;
}

void CohesiveZone::noteOpenings(const SurfaceMesh& mesh) {
    for (Bond& bond : bonds_) {
        if (!bond.isBroken()) {
            const double opening = (mesh.position(bond.plus) - mesh.position(bond.minus)).norm();
            bond.widest = std::max(bond.widest, opening);
        }
    }
}

std::vector<shared::PullRecord> CohesiveZone::pulls(
    const std::vector<std::uint32_t>& others) const {
    std::vector<shared::PullRecord> records;
    for (const Bond& bond : bonds_) {
        const auto plus = static_cast<std::uint32_t>(bond.plus);
        const auto minus = static_cast<std::uint32_t>(bond.minus);
        if (bond.isBroken() || std::ranges::binary_search(others, plus) ||
            std::ranges::binary_search(others, minus)) {
            continue;
        }
        const double widest = std::max(bond.widest, kStiffUpTo * bond.reach());
        records.push_back({plus, 0, 0, 0, static_cast<float>(bond.force),
                           static_cast<float>(bond.reach()), static_cast<float>(widest),
                           shared::kFirstBond + minus});
    }
    return records;
}

void CohesiveZone::addVertices(std::vector<int>& vertices) const {
    for (const Bond& bond : bonds_) {
        if (!bond.isBroken()) {
            vertices.insert(vertices.end(), {bond.plus, bond.minus});
        }
    }
}

const CohesiveZone::Bond* CohesiveZone::find(int plus) const {
    const auto place = std::ranges::lower_bound(bonds_, plus, {}, &Bond::plus);
    return place != bonds_.end() && place->plus == plus ? &*place : nullptr;
}

double CohesiveZone::taken() const {
    double sum = spent_;
    for (const Bond& bond : bonds_) {
        sum += bond.taken();
    }
    return sum;
}

}  // namespace kerf
