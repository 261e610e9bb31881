#pragma once

#include "shaders/shared/body_records.h"
#include "shaders/shared/constraints.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf {

/// A stretching constraint: C = |p_a - p_b| - rest_length, compliance alpha = geometry / E_stretch
/// with geometry = L^2 / (t (A1 + A2)). The solver reads it as two Spokes.
struct EdgeConstraint {
    std::uint32_t a;
    std::uint32_t b;
    float rest_length;  ///< [m]
    float geometry;     ///< [1/m]
};

/// A bending constraint: C is the signed dihedral angle of the edge v0 v1 with apexes v2 (left) and
/// v3 (right), flat 0, convex > 0, less the rest angle. Compliance alpha = geometry / E_bend with
/// geometry = 1 / (0.3 t^3 / 12). The solver reads it as a BendRecord.
struct BendConstraint {
    std::uint32_t v0;
    std::uint32_t v1;
    std::uint32_t v2;
    std::uint32_t v3;
    float rest_angle;  ///< [rad]
    float geometry;    ///< [1/m^3]
};

using shared::IncidenceRange;
using shared::IspcConstraint;
using shared::kConstraintTypes;

/// The elements that touch each vertex, in a fixed order: entries[ranges[v].first .. ranges[v].end)
/// are 4 * element + slot (slot: which of the element's vertices v is), ascending. The lists have
/// room to grow.
struct Incidence {
    std::vector<IncidenceRange> ranges;  ///< shape [vertexCount]
    std::vector<std::uint32_t> entries;

    /// Writes or reads all of it (ByteArchive).
    template <class Archive>
    void archive(Archive& io) {
        io(ranges, entries);
    }
};

// The vertices of a constraint; the place of each is its slot (see Incidence).
inline std::array<std::uint32_t, 2> verticesOf(const EdgeConstraint& c) {
    return {c.a, c.b};
}
inline std::array<std::uint32_t, 4> verticesOf(const BendConstraint& c) {
    return {c.v0, c.v1, c.v2, c.v3};
}
/// The vertices of an ISPC: its own first, then those of the triangle that its ray ends on.
inline std::array<std::uint32_t, 4> verticesOf(const IspcConstraint& c) {
    return {c.vertex, c.t0, c.t1, c.t2};
}

// The shares of its vertices in the pull of a constraint whose vertices gather Shares.
inline std::array<float, 4> weightsOf(const IspcConstraint& c) {
    return {1.0f, -(1.0f - c.b1 - c.b2), -c.b1, -c.b2};
}

// How vertices gather: the range and the entries of a list on the GPU, and the pulls per
// constraint. See constraints.h.
struct Spokes {
    using Range = IncidenceRange;
    using Entry = shared::Spoke;
    static constexpr std::uint32_t kPulls = 0;
};
struct WingPulls {
    using Range = shared::BendRange;
    using Entry = std::uint32_t;
    static constexpr std::uint32_t kPulls = 2;
};
struct Shares {
    using Range = IncidenceRange;
    using Entry = shared::ConstraintShare;
    static constexpr std::uint32_t kPulls = 1;
};

/// The constraints of a body: for each row of constraints.h a list by its name, and the constraints
/// at each vertex.
struct ConstraintLists {
#define KERF_LIST(number, Name, list, Constraint, Gather) std::vector<Constraint> list;
    KERF_CONSTRAINTS(KERF_LIST)
#undef KERF_LIST
    std::array<Incidence, kConstraintTypes> incidences;
};

/// A row of constraints.h.
template <std::uint32_t kNumber, class Gather>
struct ConstraintRow {
    static constexpr std::uint32_t kType = kNumber;
    using Gathers = Gather;
};

/// Calls f(row, list) for each row of constraints.h, in their order.
template <class Lists, class F>
void forEachType(Lists& lists, F&& f) {
#define KERF_VISIT(number, Name, list, Constraint, Gather) \
    f(ConstraintRow<number, Gather>{}, lists.list);
    KERF_CONSTRAINTS(KERF_VISIT)
#undef KERF_VISIT
}

/// The vertices of an entry of BodyModel::triangles.
inline std::array<std::uint32_t, 3> verticesOf(const std::array<std::uint32_t, 4>& triangle) {
    return {triangle[0], triangle[1], triangle[2]};
}

/// The capacity of a list of `count` entries, with a reserve.
inline std::uint32_t incidenceRoom(std::uint32_t count) {
    constexpr std::uint32_t kStep = 4;
    return (count + kStep - 1) / kStep * kStep;
}

/// The elements that touch each vertex, ascending by element and slot (a counting sort).
template <class Element>
Incidence buildIncidence(const std::vector<Element>& elements, std::size_t vertexCount) {
    Incidence incidence;
    incidence.ranges.assign(vertexCount, {});
    for (const Element& element : elements) {
        for (const std::uint32_t v : verticesOf(element)) {
            ++incidence.ranges[v].end;
        }
    }
    std::uint32_t first = 0;
    for (IncidenceRange& range : incidence.ranges) {
        const std::uint32_t room = incidenceRoom(range.end);
        range = {first, first};
        first += room;
    }
    incidence.entries.resize(first);
    for (std::size_t e = 0; e < elements.size(); ++e) {
        std::uint32_t slot = 0;
        for (const std::uint32_t v : verticesOf(elements[e])) {
            incidence.entries[incidence.ranges[v].end++] =
                static_cast<std::uint32_t>(4 * e) + slot++;
        }
    }
    return incidence;
}

/// Number of elements that touch vertex v.
inline std::uint32_t valence(const Incidence& incidence, std::size_t v) {
    return incidence.ranges[v].end - incidence.ranges[v].first;
}

/// Whether at least one of the two triangles beside the edge is part of the body's surface.
inline bool isPresentEdge(const SurfaceMesh& mesh, int h) {
    return !mesh.absent(h / 3) || !mesh.absent(mesh.twin(h) / 3);
}

/// Calls f(h) for one half-edge of each present edge: the lower one.
template <class F>
void forEachEdge(const SurfaceMesh& mesh, F&& f) {
    for (int h = 0; h < 3 * mesh.triangleSlots(); ++h) {
        if (mesh.alive(h / 3) && h < mesh.twin(h) && isPresentEdge(mesh, h)) {
            f(h);
        }
    }
}

/// The stretching constraint of the edge of a half-edge, in the rest shape. `thickness`: of the
/// shell [m]; `skin`: extra thickness where it is no wall [m].
EdgeConstraint edgeConstraint(const SurfaceMesh& mesh, int halfEdge, double thickness,
                              double skin = 0);

/// The bending constraint of the edge of a half-edge; none where a triangle beside it is absent or
/// a sliver (height below 5 % of its longest edge), whose normal is noise.
std::optional<BendConstraint> bendConstraint(const SurfaceMesh& mesh, int halfEdge,
                                             double thickness);

}  // namespace kerf
