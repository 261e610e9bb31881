#include "sim/solve/implicit/implicit_body.h"

#include "shaders/shared/body_records.h"
#include "sim/base/containers.h"

namespace kerf {

namespace {

using shared::uint;
using shared::vec4;

constexpr int kModes = AggregateFrame::kModes;
static_assert(kModes == shared::kAggregateModes);

template <class T>
uint countOf(const std::vector<T>& list) {
    return static_cast<uint>(list.size());
}

vec4 texel(const Vec3& v) {
    return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z()), 0};
}

/// The mode of rest_inverse.h that the kernels have as `row`: they go by axes first.
int modeOfRow(int row) {
    return 3 * (row % 4) + row / 4;
}

/// The aggregates of all pieces, one after the other by regions, with their members.
struct Members {
    std::vector<std::uint32_t> order;  ///< their numbers
    std::vector<shared::ImplicitAggregate> aggregates;
    std::vector<shared::ImplicitRegion> regions;
    std::vector<vec4> levels;  ///< of each aggregate two texels: see kLevelsUnit
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

void appendLevel(const AggregateFrame& own, const AggregateFrame& region, uint number,
                 Members& lists) {
    vec4 offset = texel((own.center - region.center).cwiseQuotient(region.size));
    offset.w = static_cast<float>(number);
    lists.levels.push_back(offset);
    lists.levels.push_back(texel(own.size.cwiseQuotient(region.size)));
}

Members membersOf(const BodyModel& model, const VertexGroups& groups, const RestInverse& inverse) {
    const std::vector<Seat> seats = seatsOf(groups.patches, model.restPositions.size());
    Members lists;
    lists.patches.resize(groups.patches.size());
    const auto appendAggregate = [&](uint a) {
        const VertexGroup& vertices = groups.aggregates[a];
        const uint first = countOf(lists.members);
        for (const uint v : vertices) {
            appendMember(v, seats[v], inverse.patches[seats[v].group], lists);
            const Vec3 rest = model.restPositions[v].cast<double>();
            lists.shares.push_back(texel(inverse.frames[a].sharesAt(rest).tail<3>()));
        }
        lists.order.push_back(a);
        lists.aggregates.push_back({first, countOf(lists.members),
                                    static_cast<uint>(model.pieceOfVertex[vertices[0]]), 0});
    };
    for (const CoarsePiece& piece : inverse.pieces) {
        const uint firstRegion = countOf(lists.regions);
        for (const uint r : piece.regions) {
            shared::ImplicitRegion region{countOf(lists.aggregates),
                                          0,
                                          countOf(lists.members),
                                          0,
                                          firstRegion,
                                          countOf(piece.regions),
                                          0,
                                          0};
            for (const uint a : groups.regions[r]) {
                appendAggregate(a);
                appendLevel(inverse.frames[a], inverse.regionFrames[r], countOf(lists.regions),
                            lists);
            }
            region.end = countOf(lists.aggregates);
            region.members_end = countOf(lists.members);
            lists.regions.push_back(region);
        }
    }
    return lists;
}

/// What contacts of each piece push with at most.
std::vector<ContactBuffers::Most> mostOf(const BodyModel& model, std::span<const double> firmness,
                                         std::span<const double> masses) {
    constexpr double kDeepest = 0.25;  // of the diagonal
    std::vector<Bounds> bounds(model.pieces.size());
    std::vector<ContactBuffers::Most> most(model.pieces.size());
    for (std::size_t v = 0; v < firmness.size(); ++v) {
        if (const int piece = model.pieceOfVertex[v]; piece >= 0) {
            bounds[piece].add(model.restPositions[v].cast<double>());
            most[piece].firmness = std::max(most[piece].firmness, firmness[v]);
            most[piece].mass = std::max(most[piece].mass, masses[v]);
        }
    }
    for (std::size_t p = 0; p < most.size(); ++p) {
        most[p].depth = bounds[p].empty() ? 0 : kDeepest * bounds[p].diagonal();
    }
    return most;
}

/// Four columns of a row of the kernels, those of an aggregate along an axis.
template <class Row>
vec4 coarseTexel(const Row& ofRow, Eigen::Index first, int axis) {
    std::array<float, 4> values{};
    for (int m = 0; m < 4; ++m) {
        values[m] = static_cast<float>(ofRow[first + modeOfRow(4 * axis + m)]);
    }
    return {values[0], values[1], values[2], values[3]};
}

/// Appends the rows of a region.
void appendRows(const CoarsePiece& piece, uint region, std::vector<vec4>& texels) {
    const auto& [places, matrix] = piece.inverse;
    for (int row = 0; row < kModes; ++row) {
        const auto ofRow = matrix.col(kModes * places[region] + modeOfRow(row));  // as its column
        for (const int place : places) {
            for (const int axis : {0, 1, 2}) {
                texels.push_back(coarseTexel(ofRow, kModes * place, axis));
            }
        }
    }
}

/// Appends the rows of an aggregate by itself.
void appendRows(const CoarseMatrix::Block& own, std::vector<vec4>& texels) {
    for (int row = 0; row < kModes; ++row) {
        for (const int axis : {0, 1, 2}) {
            texels.push_back(coarseTexel(own.col(modeOfRow(row)), 0, axis));
        }
    }
}

/// The rows of all regions, then those of aggregates where there is a level between. Fills in where
/// those of each begin.
std::vector<vec4> coarseTexels(const RestInverse& inverse, bool hasLevelBetween, Members& lists) {
    std::vector<vec4> texels;
    uint done = 0;
    for (const CoarsePiece& piece : inverse.pieces) {
        for (uint r = 0; r < piece.regions.size(); ++r) {
            shared::ImplicitRegion& region = lists.regions[done];
            region.coarse = lists.aggregates[region.first].coarse = countOf(texels);
            appendRows(piece, r, texels);
            ++done;
        }
    }
    for (std::size_t a = 0; hasLevelBetween && a < lists.order.size(); ++a) {
        lists.aggregates[a].coarse = countOf(texels);
        appendRows(inverse.own[lists.order[a]], texels);
    }
    return texels;
}

/// Fills in which aggregates each piece has.
void countAggregates(std::span<const shared::ImplicitAggregate> aggregates,
                     std::vector<shared::ImplicitPiece>& pieces) {
    for (uint a = 0; a < aggregates.size(); ++a) {
        shared::ImplicitPiece& piece = pieces[aggregates[a].piece];
        piece.first_aggregate = piece.aggregate_count == 0 ? a : piece.first_aggregate;
        ++piece.aggregate_count;
    }
}

}  // namespace

void MatrixBuffers::assign(const BodyModel& model, std::span<const uint> places,
                           std::span<const std::vector<uint>> pagesOfPieces) {
    const RowLists lists = rowListsOf(model);
    rows.assign(lists.rows);
    blockList.assign(lists.blocks);
    ownShares.assign(lists.own);
    blockShares.assign(lists.shares);
    rowOrder.assign(kerf::rowOrder(lists, places));
    spokeOwners.assign(kerf::spokeOwners(model));
    blockCount = countOf(lists.blocks);
    blocks.resize(3 * std::max<std::size_t>(blockCount, 1) * sizeof(vec4));
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
    std::vector<shared::ImplicitPiece>& records = pieceRecords;
    records.clear();
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
    countAggregates(lists.aggregates, records);
    regionCount = groups.hasLevelBetween() ? countOf(lists.regions) : 0;
    coarse.assign(coarseTexels(inverse, groups.hasLevelBetween(), lists));
    regions.assign(lists.regions);
    levels.assign(lists.levels);
    aggregates.assign(lists.aggregates);
    members.assign(lists.members);
    memberShares.assign(lists.shares);
    patches.assign(lists.patches);
    patchInverse.assign(lists.inverses);
    turned.resize(std::max<std::size_t>(lists.members.size(), 1) * sizeof(vec4));
    turns.resize(std::max(patchCount + aggregateCount + regionCount, 1U) * sizeof(vec4));
    modes.resize(std::max(3 * (aggregateCount + 2 * regionCount), 1U) * sizeof(vec4));
}

void ContactBuffers::assign(const BodyModel& model, std::span<const double> firm,
                            std::span<const double> masses, uint pages) {
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
    most = mostOf(model, firm, masses);
}

void ContactBuffers::makeRows(std::size_t count) {
    rows.resize(count * sizeof(shared::ContactRow));
    rowVertices.resize(count * sizeof(std::array<uint, 4>));
    states.resize(count * sizeof(shared::RowState));
    relatives.resize(count * sizeof(vec4));
}

void ImplicitBody::setForceUnits(double stiffness) {
    constexpr double kMostUnits = 1e9;  // that forces add up to in integers
    for (std::size_t p = 0; p < contact.most.size(); ++p) {
        const ContactBuffers::Most& most = contact.most[p];
        const double force = most.depth * (most.firmness + stiffness * most.mass);
        inverse.pieceRecords[p].force_unit =
            static_cast<float>(std::max(force, 1e-20) / kMostUnits);
    }
    inverse.pieces.assign(inverse.pieceRecords);
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
