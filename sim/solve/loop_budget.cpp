#include "sim/solve/loop_budget.h"

#include <algorithm>
#include <array>

#include "sim/solve/gathered_records.h"

namespace kerf {

namespace {

using shared::kSumRows;

std::size_t roundedUp(std::size_t count, std::size_t size) {
    return (count + size - 1) / size;
}

/// Of a loop: the turn that finds that there is no more to do counts too.
std::size_t loop(std::size_t times, std::size_t turnsInside = 0) {
    return times * (1 + turnsInside) + 1;
}

/// The turns of each loop in which a vertex gathers constraints of a type, at most two; the lists
/// of those that pull are read by pairs.
using GatherTurns = std::array<std::size_t, 2>;

GatherTurns gatherTurns(const Spokes::Range& range, Spokes) {
    return {loop(range.end - range.first), 0};
}
GatherTurns gatherTurns(const Shares::Range& range, Shares) {
    return {loop(roundedUp(range.end - range.first, 2)), 0};
}
GatherTurns gatherTurns(const WingPulls::Range& range, WingPulls) {
    return {loop(roundedUp(range.apexes - range.first, 2)),
            loop(roundedUp(range.end - (range.apexes & ~1u), 2))};
}

/// Of the threads that run side by side from vertex `first` on.
template <class Gather>
std::size_t turnsSideBySide(Gather gather, const Incidence& incidence, std::size_t first,
                            std::size_t end) {
    GatherTurns most{};
    for (std::size_t v = first; v < end; ++v) {
        const auto range = rangeAt(gather, incidence, static_cast<std::uint32_t>(v));
        const GatherTurns turns = gatherTurns(range, gather);
        most = {std::max(most[0], turns[0]), std::max(most[1], turns[1])};
    }
    return most[0] + most[1];
}

/// Of the loops in which vertices gather, in the stretch that needs most.
std::size_t turnsOfLists(const BodyModel& model, const GroupShape& group) {
    const std::size_t vertices = model.restPositions.size();
    const std::size_t stretch =
        std::max<std::size_t>(roundedUp(vertices, group.threads) * group.sideBySide, 1);
    std::vector<std::size_t> turns(roundedUp(vertices, stretch) + 1, 0);
    for (std::size_t first = 0; first < vertices; first += group.sideBySide) {
        const std::size_t end = std::min<std::size_t>(first + group.sideBySide, vertices);
        forEachType(model, [&](auto row, const auto&) {
            turns[first / stretch] += turnsSideBySide(typename decltype(row)::Gathers{},
                                                      model.incidences[row.kType], first, end);
        });
    }
    return *std::ranges::max_element(turns);
}

std::size_t loopOver(std::size_t count, const GroupShape& group, std::size_t turnsInside = 0) {
    return loop(roundedUp(count, group.threads), turnsInside);
}

}  // namespace

std::size_t turnsOfSweep(const BodyModel& model, const GroupShape& group) {
    constexpr std::size_t kLoopsOverVertices = 1 + kConstraintTypes;  // with the prediction
    std::size_t turns = 1 + kLoopsOverVertices * loopOver(model.restPositions.size(), group);
    forEachType(model, [&](auto row, const auto& constraints) {
        const bool pulls = decltype(row)::Gathers::kPulls > 0;
        turns += pulls ? loopOver(constraints.size(), group) : 0;
    });
    return turns + turnsOfLists(model, group);
}

std::size_t turnsOfSubstep(const BodyModel& model, std::size_t blocks, const GroupShape& group) {
    constexpr std::size_t kMoreLoopsOverVertices = 2;  // settling twice where hands pull, and pulls
    std::size_t corners = 0;
    for (std::size_t v = 0; v < model.restPositions.size(); ++v) {
        corners = std::max<std::size_t>(corners, valence(model.neighbours, v));
    }
    return turnsOfSweep(model, group) +
           kMoreLoopsOverVertices * loopOver(model.restPositions.size(), group) +
           loop(blocks, loopOver(shared::kPageSize, group, loop(roundedUp(corners, 2)))) +
           loopOver(blocks * kSumRows, group, loop(shared::kPageSize / kSumRows)) +
           loopOver(model.pieces.size(), group, 1) + loop(blocks, loop(kSumRows));
}

}  // namespace kerf
