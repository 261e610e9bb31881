#include "sim/solve/implicit/row_lists.h"

#include <algorithm>
#include <functional>

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

/// Appends the row of a vertex; its shares in the order of types and constraints.
void appendRow(const BodyModel& model, const FactorPlaces& factors, uint v, RowLists& lists) {
    std::vector<Share> shares;
    addSpokes(model, v, factors.first[shared::kStretch], shares);
    addOthers(model.bends, model.incidences[shared::kBend], v, factors.first[shared::kBend],
              shares);
    addOthers(model.ispcs, model.incidences[shared::kIspc], v, factors.first[shared::kIspc],
              shares);
    std::ranges::stable_sort(shares, {}, &Share::column);
    const uint first = lists.blockCount;
    for (std::size_t k = 0; k < shares.size();) {
        const uint column = shares[k].column;
        shared::ImplicitBlock block{lists.blockCount++, column,
                                    static_cast<uint>(lists.shares.size()), 0};
        for (; k < shares.size() && shares[k].column == column; ++k) {
            lists.shares.push_back(shares[k].word);
        }
        block.end = static_cast<uint>(lists.shares.size());
        if (column == v) {
            lists.diagonal[v] = block;
        } else {
            lists.others.push_back(block);
        }
    }
    lists.rows[v] = {first, lists.blockCount};
}

/// Those with many shares first, group by group of threads: threads beside each other end together.
void sortByShares(std::vector<shared::ImplicitBlock>& blocks) {
    for (std::size_t first = 0; first < blocks.size(); first += shared::kGroupSize) {
        const std::size_t count = std::min<std::size_t>(shared::kGroupSize, blocks.size() - first);
        std::ranges::stable_sort(std::span(blocks).subspan(first, count), std::ranges::greater{},
                                 [](const shared::ImplicitBlock& b) { return b.end - b.first; });
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
    RowLists lists;
    lists.rows.resize(model.restPositions.size());
    lists.diagonal.resize(model.restPositions.size());
    for (uint v = 0; v < lists.rows.size(); ++v) {
        if (model.pieceOfVertex[v] >= 0) {
            appendRow(model, factors, v, lists);
        }
    }
    sortByShares(lists.others);
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
