#include "sim/solve/solver_model.h"

#include <type_traits>

#include "sim/base/containers.h"
#include "sim/base/pausing.h"
#include "sim/cut/wall_copies.h"
#include "sim/solve/float_vectors.h"
#include "sim/solve/implicit/constraint_pull.h"

namespace kerf {

namespace {

using gpu::TexelFormat;
using shared::uint;

static_assert(kConstraintTypes <= 1 + shared::kMostPullingTypes, "links need another texel");

shared::VertexLinks linksOf(const BodyModel& model, std::size_t v) {
    const int piece = model.pieceOfVertex[v];
    shared::VertexLinks links{{}, piece < 0 ? shared::kNoPiece : static_cast<uint>(piece)};
    for (uint type = 1; type < kConstraintTypes; ++type) {
        links.counts[type - 1] = valence(model.incidences[type], v);
    }
    return links;
}

std::vector<shared::VertexLinks> vertexLinks(const BodyModel& model) {
    std::vector<shared::VertexLinks> links(model.restPositions.size());
    for (std::size_t v = 0; v < links.size(); ++v) {
        links[v] = linksOf(model, v);
    }
    return links;
}

/// Of what the member is made of that `vertex` belongs to: a compliance falls with the modulus.
template <class Record>
Record ofMaterial(Record record, const BodyModel& model, uint vertex) {
    if constexpr (requires { record.geometry; }) {
        record.geometry = static_cast<float>(record.geometry / model.memberOf(vertex).modulus);
    }
    return record;
}

template <class Constraint>
auto materialRecordOf(const Constraint& constraint, const BodyModel& model) {
    return ofMaterial(recordOf(constraint, model.restPositions), model, verticesOf(constraint)[0]);
}

template <class Constraint>
auto recordsOf(const BodyModel& model, const std::vector<Constraint>& list) {
    return mapped(list, [&](const Constraint& c) { return materialRecordOf(c, model); });
}

template <class Constraint>
void updateRecords(const BodyModel& model, const std::vector<Constraint>& list,
                   const std::vector<uint>& slots, gpu::Buffer& records, Scatter& scatter) {
    using Record = std::decay_t<decltype(recordOf(list[0], model.restPositions))>;
    scatter.write<Record>(records, list.size(), slots, Scatter::Gaps::fill,
                          [&](uint slot) { return materialRecordOf(list[slot], model); });
}

/// A texel has so many bytes, but never more than four words.
constexpr TexelFormat texelsOf(std::size_t bytes) {
    return bytes < 16 ? TexelFormat::uint32x2 : TexelFormat::uint32x4;
}

/// What lies at a place of the lists of a type.
template <class Gather, class Constraint>
auto entryOf(Gather gather, const BodyModel& model, const std::vector<Constraint>& list,
             const Incidence& incidence, uint place) {
    const auto entry = entryAt(gather, list, incidence, place);
    if constexpr (requires { entry.other; }) {
        return ofMaterial(entry, model, entry.other);
    } else {
        return entry;
    }
}

template <class Gather, class Constraint>
void assignLists(Gather gather, const BodyModel& model, const std::vector<Constraint>& list,
                 const Incidence& incidence, ConstraintBuffers& buffers) {
    std::vector<typename Gather::Range> ranges(incidence.ranges.size());
    std::vector<typename Gather::Entry> entries(incidence.entries.size());
    for (uint v = 0; v < ranges.size(); ++v) {
        ranges[v] = rangeAt(gather, incidence, v);
        for (uint place = ranges[v].first; place < ranges[v].end; ++place) {
            entries[place] = entryOf(gather, model, list, incidence, place);
        }
    }
    buffers.ranges.assign(ranges);
    buffers.entries.assign(entries);
    buffers.rangeTexels = texelsOf(sizeof(typename Gather::Range));
    buffers.entryTexels = texelsOf(2 * sizeof(typename Gather::Entry));  // lists are read by pairs
}

template <class Gather, class Constraint>
void updateLists(Gather gather, const BodyModel& model, const std::vector<Constraint>& list,
                 const Incidence& incidence, const std::vector<uint>& vertices,
                 ConstraintBuffers& buffers, Scatter& scatter) {
    scatter.write<typename Gather::Range>(buffers.ranges, incidence.ranges.size(), vertices,
                                          Scatter::Gaps::fill,
                                          [&](uint v) { return rangeAt(gather, incidence, v); });
    scatter.write<typename Gather::Entry>(
        buffers.entries, incidence.entries.size(), changedPlaces(gather, list, incidence, vertices),
        Scatter::Gaps::keep,
        [&](uint place) { return entryOf(gather, model, list, incidence, place); });
}

}  // namespace

void IncidenceBuffers::assign(const Incidence& incidence) {
    ranges.assign(incidence.ranges);
    entries.assign(incidence.entries);
}

void IncidenceBuffers::update(const Incidence& incidence, const std::vector<uint>& vertices,
                              Scatter& scatter) {
    scatter.write<IncidenceRange>(ranges, incidence.ranges, vertices);
    scatter.write<uint>(entries, incidence.entries, placesOf(incidence, vertices));
}

void SolverModel::takeVertices(const BodyModel& model) {
    areas.assign(model.vertexAreas.begin(), model.vertexAreas.end());
    pieceOf = model.pieceOfVertex;
    diagonal = boundsOf(model.restPositions).diagonal();
    wallEdge = wallEdgeFor(model.edgeLength, model.diagonal);
}

void SolverModel::uploadRestShape(const BodyModel& model) {
    restPositions.assign(packed(model.restPositions));
    cutSkinNormals.assign(packed(model.cutSkinNormals));
    links.assign(vertexLinks(model));
    areaBuffer.assign(areas);
}

void SolverModel::uploadRecords(const BodyModel& model, uint type) {
    forEachType(model, [&](auto row, const auto& list) {
        if constexpr (decltype(row)::Gathers::kPulls > 0) {
            if (row.kType == type) {
                constraints[type].records.assign(recordsOf(model, list));
            }
        }
    });
}

void SolverModel::uploadLists(const BodyModel& model, uint type) {
    forEachType(model, [&](auto row, const auto& list) {
        if (row.kType == type) {
            assignLists(typename decltype(row)::Gathers{}, model, list, model.incidences[type],
                        constraints[type]);
        }
    });
}

void SolverModel::uploadConstraints(const BodyModel& model) {
    for (uint type = 0; type < kConstraintTypes; ++type) {
        uploadRecords(model, type);
        uploadLists(model, type);
    }
}

void SolverModel::uploadTriangleLists(const BodyModel& model) {
    triangleIncidence.assign(model.triangleIncidence);
    neighbours.assign(model.neighbours);
}

void SolverModel::update(const BodyModel& model, const BodyChange& change, Scatter& scatter) {
    updateVertices(model, change, scatter);
    scatter.write<std::array<uint, 4>>(triangles, model.triangles, change.triangles.slots);
    updateConstraints(model, change, scatter);
    pausePoint();
    triangleIncidence.update(model.triangleIncidence, change.triangles.vertices, scatter);
    neighbours.update(model.neighbours, change.neighbourLists, scatter);
}

void SolverModel::updateVertices(const BodyModel& model, const BodyChange& change,
                                 Scatter& scatter) {
    const std::size_t n = model.restPositions.size();
    areas.resize(n);
    pieceOf.resize(n, -1);
    for (const uint v : change.vertices) {
        areas[v] = static_cast<float>(model.vertexAreas[v]);
        pieceOf[v] = model.pieceOfVertex[v];
    }
    const auto fill = Scatter::Gaps::fill;
    scatter.write<shared::VertexLinks>(links, n, change.vertices, fill,
                                       [&](uint v) { return linksOf(model, v); });
    scatter.write<shared::vec4>(restPositions, n, change.vertices, fill,
                                [&](uint v) { return packed(model.restPositions[v], 0.0f); });
    scatter.write<shared::vec4>(cutSkinNormals, n, change.vertices, fill,
                                [&](uint v) { return packed(model.cutSkinNormals[v], 0.0f); });
    scatter.write<float>(areaBuffer, areas, change.vertices);
}

void SolverModel::updateConstraints(const BodyModel& model, const BodyChange& change,
                                    Scatter& scatter) {
    forEachType(model, [&](auto row, const auto& list) {
        pausePoint();
        using Gather = typename decltype(row)::Gathers;
        const ListChange& changed = change.constraints[row.kType];
        if constexpr (Gather::kPulls > 0) {
            updateRecords(model, list, changed.slots, constraints[row.kType].records, scatter);
        }
        updateLists(Gather{}, model, list, model.incidences[row.kType], changed.vertices,
                    constraints[row.kType], scatter);
    });
}

namespace {

using shared::uint;

bool isEndOfEdge(uint entry) {
    return entry % 4 < 2;
}

/// How many bends of a list the vertex is an end of the edge of.
uint endsOfEdges(const Incidence& incidence, const IncidenceRange& range) {
    const auto first = incidence.entries.begin();
    return static_cast<uint>(std::count_if(first + range.first, first + range.end, isEndOfEdge));
}

}  // namespace

std::vector<uint> placesOf(const Incidence& incidence, const std::vector<uint>& vertices) {
    std::vector<uint> places;
    for (const uint v : vertices) {
        for (uint k = incidence.ranges[v].first; k < incidence.ranges[v].end; ++k) {
            places.push_back(k);
        }
    }
    std::sort(places.begin(), places.end());  // lists that grew have moved
    return places;
}

shared::BendRecord recordOf(const BendConstraint& bend, const std::vector<Vec3f>& rest) {
    const double angle = bend.rest_angle;
    return {bend.v0,
            bend.v1,
            bend.v2,
            bend.v3,
            static_cast<float>(std::cos(angle)),
            static_cast<float>(std::sin(angle)),
            bend.geometry,
            static_cast<float>(steepnessAtRest(bend, rest))};
}

shared::BendRange rangeAt(WingPulls, const Incidence& incidence, uint vertex) {
    const IncidenceRange& range = incidence.ranges[vertex];
    return {range.first, range.first + endsOfEdges(incidence, range), range.end, 0};
}

shared::Spoke entryAt(Spokes, const std::vector<EdgeConstraint>& edges, const Incidence& incidence,
                      uint place) {
    const uint entry = incidence.entries[place];
    const EdgeConstraint& edge = edges[entry / 4];
    const uint other = entry % 4 == 0 ? edge.b : edge.a;
    return {other, edge.rest_length, edge.geometry, valence(incidence, other)};
}

/// The places of a list have the entries of ends first, else in their order.
uint entryAt(WingPulls, const std::vector<BendConstraint>& bends, const Incidence& incidence,
             uint place) {
    const uint own = incidence.entries[place];
    const IncidenceRange& range = incidence.ranges[verticesOf(bends[own / 4])[own % 4]];
    const uint apexes = range.first + endsOfEdges(incidence, range);
    const bool end = place < apexes;
    uint left = place - (end ? range.first : apexes);
    auto entry = incidence.entries.begin() + range.first;
    for (; isEndOfEdge(*entry) != end || left-- > 0; ++entry) {
    }
    return 2 * (*entry / 4) + *entry % 2;
}

std::vector<uint> changedPlaces(Spokes, const std::vector<EdgeConstraint>& edges,
                                const Incidence& incidence, std::vector<uint> vertices) {
    for (const uint place : placesOf(incidence, vertices)) {
        vertices.push_back(entryAt(Spokes{}, edges, incidence, place).other);
    }
    sortUnique(vertices);
    return placesOf(incidence, vertices);
}

}  // namespace kerf
