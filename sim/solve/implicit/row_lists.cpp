#include "sim/solve/implicit/row_lists.h"

#include "shaders/shared/body_records.h"

namespace kerf {

namespace {

using shared::uint;

/// What a constraint adds to the block in a column.
struct Share {
    uint column = 0;
    uint word = 0;
};

uint shareOf(uint firstFactor, uint row, uint column) {
    return firstFactor / 2 << shared::kSlotBits | row << 2 | column;
}

void addSpokes(const BodyModel& model, uint v, uint first, std::vector<Share>& shares) {
    const Incidence& incidence = model.incidences[shared::kStretch];
    for (uint place = incidence.ranges[v].first; place < incidence.ranges[v].end; ++place) {
        const uint entry = incidence.entries[place];
        const EdgeConstraint& edge = model.edges[entry / 4];
        shares.push_back({v, shareOf(first + 2 * place, 0, 0)});
        shares.push_back({entry % 4 == 0 ? edge.b : edge.a, shareOf(first + 2 * place, 0, 1)});
    }
}

template <class Constraint>
void addOthers(const std::vector<Constraint>& constraints, const Incidence& incidence, uint v,
               uint first, std::vector<Share>& shares) {
    for (uint place = incidence.ranges[v].first; place < incidence.ranges[v].end; ++place) {
        const uint entry = incidence.entries[place];
        uint slot = 0;
        for (const uint column : verticesOf(constraints[entry / 4])) {
            shares.push_back({column, shareOf(first + entry / 4 * 4, entry % 4, slot++)});
        }
    }
}

/// Of a row while it is made.
struct RowParts {
    std::vector<Share> shares;  ///< in the order of types and constraints
    std::vector<uint> columns;
    std::vector<uint> places;  ///< by column: where its next share goes; 0 between rows
};

/// Appends the row of a vertex, sorted by columns; shares stay in their order.
void appendRow(const BodyModel& model, const FactorPlaces& factors, uint v, RowParts& parts,
               RowLists& lists) {
    auto& [shares, columns, places] = parts;
    shares.clear();
    columns.clear();
    addSpokes(model, v, factors.first[shared::kStretch], shares);
    addOthers(model.bends, model.incidences[shared::kBend], v, factors.first[shared::kBend],
              shares);
    addOthers(model.ispcs, model.incidences[shared::kIspc], v, factors.first[shared::kIspc],
              shares);
    for (const Share& share : shares) {
        if (places[share.column]++ == 0) {
            columns.push_back(share.column);
        }
    }
    std::ranges::sort(columns);
    const uint first = static_cast<uint>(lists.blocks.size());
    uint end = static_cast<uint>(lists.shares.size());
    for (const uint column : columns) {
        const uint begin = std::exchange(end, end + places[column]);
        if (column == v) {
            lists.own[v] = {begin, end};
        } else {
            const uint place = static_cast<uint>(lists.blocks.size());
            lists.blocks.push_back({place, column, begin, end});
        }
        places[column] = begin;
    }
    lists.rows[v] = {first, static_cast<uint>(lists.blocks.size())};
    lists.shares.resize(end);
    for (const Share& share : shares) {
        lists.shares[places[share.column]++] = share.word;
    }
    for (const uint column : columns) {
        places[column] = 0;
    }
}

/// Those with many shares first, group by group of threads: threads beside each other end together.
void sortByShares(std::vector<shared::ImplicitBlock>& blocks) {
    for (std::size_t first = 0; first < blocks.size(); first += shared::kGroupSize) {
        const std::size_t count = std::min<std::size_t>(shared::kGroupSize, blocks.size() - first);
        std::ranges::sort(std::span(blocks).subspan(first, count), {},
                          [](const shared::ImplicitBlock& b) {
                              return std::uint64_t{b.first - b.end} << 32 | b.place;
                          });
    }
}

}  // namespace

FactorPlaces::FactorPlaces(const BodyModel& model) {
    constexpr uint kAligned = 4;
    forEachType(model, [&](auto row, const auto& constraints) {
        const std::size_t ofType = row.kType == shared::kStretch
                                       ? 2 * model.incidences[row.kType].entries.size()
                                       : 4 * constraints.size();
        first[row.kType] = count;
        count += (static_cast<uint>(ofType) + kAligned - 1) / kAligned * kAligned;
    });
}

RowLists rowListsOf(const BodyModel& model) {
    const FactorPlaces factors(model);
    RowParts parts;
    parts.places.resize(model.restPositions.size(), 0);
    RowLists lists;
    lists.rows.resize(model.restPositions.size());
    lists.own.resize(model.restPositions.size());
    for (uint v = 0; v < lists.rows.size(); ++v) {
        if (model.pieceOfVertex[v] >= 0) {
            appendRow(model, factors, v, parts, lists);
        }
    }
    sortByShares(lists.blocks);
    return lists;
}

std::vector<uint> spokeOwners(const BodyModel& model) {
    const Incidence& incidence = model.incidences[shared::kStretch];
    std::vector<uint> owners(incidence.entries.size(), shared::kNoVertex);
    for (uint v = 0; v < incidence.ranges.size(); ++v) {
        const auto& [first, end] = incidence.ranges[v];
        std::fill(owners.begin() + first, owners.begin() + end, v);
    }
    return owners;
}

std::vector<uint> rowOrder(const RowLists& lists, std::span<const uint> places) {
    const auto lengthOf = [&](uint v) {
        return v == shared::kNoVertex
                   ? -1
                   : static_cast<int>(lists.rows[v].end) - static_cast<int>(lists.rows[v].first);
    };
    std::vector<uint> order(places.begin(), places.end());
    for (std::size_t page = 0; page < order.size(); page += shared::kPageSize) {
        const auto first = order.begin() + static_cast<std::ptrdiff_t>(page);
        std::stable_sort(first, first + shared::kPageSize,
                         [&](uint a, uint b) { return lengthOf(a) > lengthOf(b); });
    }
    return order;
}

}  // namespace kerf
