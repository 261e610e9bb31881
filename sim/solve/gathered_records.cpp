#include "sim/solve/gathered_records.h"

#include "sim/base/containers.h"
#include "sim/solve/implicit/constraint_pull.h"

namespace kerf {

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
