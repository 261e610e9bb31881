#include "sim/solve/gathered_records.h"

#include <algorithm>
#include <cmath>

#include "sim/base/sort_unique.h"
#include "sim/body/incidence.h"

namespace kerf {

namespace {

using shared::uint;

/// What `recordAt` says of each place of the lists that is in use.
template <class Record, class RecordAt>
std::vector<Record> recordsOf(const BodyModel& model, const Incidence& incidence,
                              RecordAt&& recordAt) {
    std::vector<Record> records(incidence.entries.size());
    for (const IncidenceRange& range : incidence.ranges) {
        for (uint place = range.first; place < range.end; ++place) {
            records[place] = recordAt(model, place);
        }
    }
    return records;
}

bool isEndOfEdge(uint entry) {
    return entry % 4 < 2;
}

void fillBendList(BendLists& lists, const BodyModel& model, uint vertex) {
    const IncidenceRange& range = model.bendIncidence.ranges[vertex];
    const auto begin = lists.entries.begin() + range.first;
    const auto end = std::copy(model.bendIncidence.entries.begin() + range.first,
                               model.bendIncidence.entries.begin() + range.end, begin);
    const auto apexes = std::stable_partition(begin, end, isEndOfEdge);
    std::transform(begin, end, begin, [](uint entry) { return 2 * (entry / 4) + entry % 2; });
    lists.ranges[vertex] = {range.first, range.first + static_cast<uint>(apexes - begin), range.end,
                            0};
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

shared::Spoke spokeAt(const BodyModel& model, uint place) {
    const uint entry = model.edgeIncidence.entries[place];
    const EdgeConstraint& edge = model.edges[entry / 4];
    const uint other = entry % 4 == 0 ? edge.b : edge.a;
    return {other, edge.rest_length, edge.geometry, valence(model.edgeIncidence, other)};
}

std::vector<shared::Spoke> allSpokes(const BodyModel& model) {
    return recordsOf<shared::Spoke>(model, model.edgeIncidence, spokeAt);
}

std::vector<uint> changedSpokes(const BodyModel& model, const BodyChange& change) {
    std::vector<uint> vertices = change.edgeLists;
    for (const uint e : change.edges) {
        vertices.insert(vertices.end(), {model.edges[e].a, model.edges[e].b});
    }
    for (const uint v : change.edgeLists) {
        for (const uint place : placesOf(model.edgeIncidence, {v})) {
            vertices.push_back(spokeAt(model, place).other);
        }
    }
    sortUnique(vertices);
    return placesOf(model.edgeIncidence, vertices);
}

shared::BendRecord bendRecord(const BendConstraint& bend) {
    const double angle = bend.rest_angle;
    return {bend.v0,
            bend.v1,
            bend.v2,
            bend.v3,
            static_cast<float>(std::cos(angle)),
            static_cast<float>(std::sin(angle)),
            bend.geometry,
            0};
}

std::vector<shared::BendRecord> allBendRecords(const BodyModel& model) {
    std::vector<shared::BendRecord> records(model.bends.size());
    std::transform(model.bends.begin(), model.bends.end(), records.begin(), bendRecord);
    return records;
}

void BendLists::assign(const BodyModel& model) {
    ranges.assign(model.bendIncidence.ranges.size(), {});
    entries.assign(model.bendIncidence.entries.size(), 0);
    for (uint v = 0; v < ranges.size(); ++v) {
        fillBendList(*this, model, v);
    }
}

void BendLists::update(const BodyModel& model, const std::vector<uint>& vertices) {
    ranges.resize(model.bendIncidence.ranges.size());
    entries.resize(model.bendIncidence.entries.size());
    for (const uint v : vertices) {
        fillBendList(*this, model, v);
    }
}

shared::IspcShare ispcShareAt(const BodyModel& model, uint place) {
    const uint entry = model.ispcIncidence.entries[place];
    const shared::IspcConstraint& ispc = model.ispcs[entry / 4];
    const std::array<float, 4> weights{1.0f, -(1.0f - ispc.b1 - ispc.b2), -ispc.b1, -ispc.b2};
    return {entry / 4, weights[entry % 4]};
}

std::vector<shared::IspcShare> allIspcShares(const BodyModel& model) {
    return recordsOf<shared::IspcShare>(model, model.ispcIncidence, ispcShareAt);
}

std::vector<uint> changedIspcShares(const BodyModel& model, const BodyChange& change) {
    std::vector<uint> vertices = change.ispcLists;
    for (const uint i : change.ispcs) {
        const auto corners = verticesOf(model.ispcs[i]);
        vertices.insert(vertices.end(), corners.begin(), corners.end());
    }
    sortUnique(vertices);
    return placesOf(model.ispcIncidence, vertices);
}

}  // namespace kerf
