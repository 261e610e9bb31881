#include "sim/solve/implicit/implicit_body.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "shaders/shared/body_records.h"
#include "sim/base/mapped.h"

namespace kerf {

namespace {

using shared::uint;
using shared::vec4;

constexpr int kModes = AggregateFrame::kModes;
static_assert(kModes == shared::kAggregateModes);

vec4 texel(const Vec3& v) {
    return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z()), 0};
}

/// The mode of rest_inverse.h that the kernels have as `row`: they go by axes first.
int modeOfRow(int row) {
    return 3 * (row % 4) + row / 4;
}

/// The aggregates of all pieces, one after the other, with their members.
struct Members {
    std::vector<shared::ImplicitAggregate> aggregates;
    std::vector<shared::ImplicitMember> members;
    std::vector<std::array<uint, 2>> patches;  ///< first and end of their members
    std::vector<vec4> shares;                  ///< of the modes 3 to 11, by member
    std::vector<vec4> inverses;                ///< three texels a block
};

/// Appends a vertex whose place in its patch is `seat`.
void appendMember(uint v, const Seat& seat, const Eigen::MatrixXd& inverse, Members& lists) {
    const uint count = static_cast<uint>(inverse.rows() / 3);
    const uint patch = static_cast<uint>(seat.group);
    const uint first = static_cast<uint>(lists.members.size()) - static_cast<uint>(seat.place);
    lists.members.push_back(
        {v, patch, first + (count << 24), static_cast<uint>(lists.inverses.size() / 3)});
    lists.patches[patch] = {first, first + count};
    for (uint other = 0; other < count; ++other) {
        for (int row = 0; row < 3; ++row) {  // which is a column, too
            lists.inverses.push_back(texel(inverse.block<3, 1>(3 * other, 3 * seat.place + row)));
        }
    }
}

Members membersOf(const BodyModel& model, const VertexGroups& groups, const RestInverse& inverse) {
    const std::vector<Seat> seats = seatsOf(groups.patches, model.restPositions.size());
    Members lists;
    lists.patches.resize(groups.patches.size());
    for (const CoarsePiece& piece : inverse.pieces) {
        for (const uint a : piece.aggregates) {
            const VertexGroup& vertices = groups.aggregates[a];
            const uint first = static_cast<uint>(lists.members.size());
            for (const uint v : vertices) {
                appendMember(v, seats[v], inverse.patches[seats[v].group], lists);
                const Vec3 rest = model.restPositions[v].cast<double>();
                lists.shares.push_back(texel(inverse.frames[a].sharesAt(rest).tail<3>()));
            }
            lists.aggregates.push_back({first, static_cast<uint>(lists.members.size()),
                                        static_cast<uint>(model.pieceOfVertex[vertices[0]]), 0});
        }
    }
    return lists;
}

/// Four columns of a row of the kernels, those of an aggregate along an axis.
vec4 coarseTexel(const CoarsePiece& piece, uint aggregate, int row, uint other, int axis) {
    const auto& [places, matrix] = piece.inverse;
    const auto ofRow = matrix.col(kModes * places[aggregate] + modeOfRow(row));  // as its column
    std::array<float, 4> values{};
    for (int m = 0; m < 4; ++m) {
        values[m] = static_cast<float>(ofRow[kModes * places[other] + modeOfRow(4 * axis + m)]);
    }
    return {values[0], values[1], values[2], values[3]};
}

/// The rows of all aggregates. Fills in where those of each begin, and which each piece has.
std::vector<vec4> coarseTexels(const RestInverse& inverse,
                               std::vector<shared::ImplicitAggregate>& aggregates,
                               std::vector<shared::ImplicitPiece>& pieces) {
    std::vector<vec4> texels;
    uint done = 0;
    for (const CoarsePiece& piece : inverse.pieces) {
        const uint count = static_cast<uint>(piece.aggregates.size());
        pieces[aggregates[done].piece].first_aggregate = done;
        pieces[aggregates[done].piece].aggregate_count = count;
        for (uint a = 0; a < count; ++a) {
            aggregates[done + a].coarse = static_cast<uint>(texels.size());
            for (int row = 0; row < kModes; ++row) {
                for (uint other = 0; other < count; ++other) {
                    for (const int axis : {0, 1, 2}) {
                        texels.push_back(coarseTexel(piece, a, row, other, axis));
                    }
                }
            }
        }
        done += count;
    }
    return texels;
}

}  // namespace

void MatrixBuffers::assign(const BodyModel& model, std::span<const uint> places,
                           std::span<const std::vector<uint>> pagesOfPieces) {
    const RowLists lists = rowListsOf(model);
    rows.assign(lists.rows);
    blockList.assign(lists.others);
    diagonal.assign(lists.diagonal);
    blockShares.assign(lists.shares);
    rowOrder.assign(kerf::rowOrder(lists, places));
    spokeOwners.assign(kerf::spokeOwners(model));
    blockCount = static_cast<uint>(lists.others.size());
    blocks.resize(std::max<std::size_t>(3 * lists.blockCount, 1) * sizeof(vec4));
    const FactorPlaces ofFactors(model);
    firstFactor = ofFactors.first;
    factors.resize(std::max<std::size_t>(ofFactors.count, 1) * sizeof(vec4));
    pulls.resize((ofFactors.count / 8 + 1) * sizeof(vec4));

    std::vector<std::array<uint, 2>> table;
    for (uint piece = 0; piece < pagesOfPieces.size(); ++piece) {
        for (const uint page : pagesOfPieces[piece]) {
            table.push_back({page, piece});
        }
    }
    pageTable.assign(table);
    pageCount = static_cast<uint>(table.size());
}

void InverseBuffers::assign(const BodyModel& model, const VertexGroups& groups,
                            const RestInverse& inverse,
                            std::span<const std::vector<uint>> pagesOfPieces) {
    std::vector<shared::ImplicitPiece> records;
    uint page = 0;
    for (const std::vector<uint>& pages : pagesOfPieces) {
        const uint count = static_cast<uint>(pages.size());
        const uint piece = static_cast<uint>(records.size());
        records.push_back({page, count, 0, 0, piece, shared::kNoPiece, 0, 0});
        page += count;
    }
    Members lists = membersOf(model, groups, inverse);
    patchCount = static_cast<uint>(lists.patches.size());
    aggregateCount = static_cast<uint>(lists.aggregates.size());
    coarse.assign(coarseTexels(inverse, lists.aggregates, records));
    pieces.assign(records);
    aggregates.assign(lists.aggregates);
    members.assign(lists.members);
    memberShares.assign(lists.shares);
    patches.assign(lists.patches);
    patchInverse.assign(lists.inverses);
    turned.resize(std::max<std::size_t>(lists.members.size(), 1) * sizeof(vec4));
    turns.resize(std::max(patchCount + aggregateCount, 1U) * sizeof(vec4));
    modes.resize(std::max(3 * aggregateCount, 1U) * sizeof(vec4));
}

void ContactBuffers::assign(const BodyModel& model, std::span<const double> firm, uint pages) {
    constexpr double kFarthest = 0.25;  // of the diagonal, that contacts are pressed together
    const std::size_t vertexCount = std::max<std::size_t>(firm.size(), 1);
    makeRows(shared::kRowsOfVertex * vertexCount);
    keptSlips.resize(shared::kRowsOfVertex * vertexCount * sizeof(vec4));
    forces.resize(vertexCount * sizeof(std::array<int, 4>));
    forces.clear();
    list.resize(std::max(shared::kRowsOfPage * pages, 1U) * sizeof(uint));
    std::vector<uint> own(std::max<std::size_t>(model.pieces.size(), 1));
    std::iota(own.begin(), own.end(), 0U);
    unjoined.assign(own);
    parents.resize(own.size() * sizeof(uint));
    reaches.resize(own.size() * sizeof(shared::Reach));
    firmness.assign(std::vector<float>(firm.begin(), firm.end()));
    firmest = firm.empty() ? 0 : *std::ranges::max_element(firm);
    farthest = kFarthest * model.diagonal;
}

void ContactBuffers::makeRows(std::size_t count) {
    rows.resize(count * sizeof(shared::ContactRow));
    rowVertices.resize(count * sizeof(std::array<uint, 4>));
    states.resize(count * sizeof(shared::RowState));
    relatives.resize(count * sizeof(vec4));
}

void StageVectors::makeRoom(std::size_t vertexCount, std::size_t aggregates, std::size_t pieces) {
    motions.resize(std::max<std::size_t>(aggregates, 1) * sizeof(shared::AggregateMotion));
    spins.resize(2 * std::max<std::size_t>(pieces, 1) * sizeof(vec4));
    total.resize(2 * vertexCount * sizeof(vec4));
    for (gpu::Buffer* vector : {&residual, &answer, &direction, &image, &way, &firstWay, &force,
                                &pressure, &pressureImage, &drift}) {
        vector->resize(vertexCount * sizeof(vec4));
    }
}

void StageVectors::makeSlots(uint slots, uint pages, uint aggregates) {
    productSums.resize(std::max(slots * pages, 1U) * sizeof(shared::ProductSums));
    answerSums.resize(std::max(slots * aggregates, 1U) * sizeof(shared::AnswerSums));
}

}  // namespace kerf
