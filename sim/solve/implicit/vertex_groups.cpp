#include "sim/solve/implicit/vertex_groups.h"

#include <cassert>

#include "shaders/shared/implicit_records.h"

namespace kerf {

namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// How firmly something is held to another, as a share of what holds both.
struct GroupLink {
    std::uint32_t item = 0;
    double strength = 0;
};
using Links = std::vector<std::vector<GroupLink>>;

/// Turns links round, which sorts those of each item; adds up those between the same two.
Links turnedRound(const Links& links) {
    Links turned(links.size());
    for (std::uint32_t item = 0; item < links.size(); ++item) {
        turned[item].reserve(links[item].size() / 2);
        for (const GroupLink& link : links[item]) {
            std::vector<GroupLink>& list = turned[link.item];
            if (!list.empty() && list.back().item == item) {
                list.back().strength += link.strength;
            } else {
                list.push_back({item, link.strength});
            }
        }
    }
    return turned;
}

Links linksOf(const BodyModel& model, std::span<const ConstraintPull> pulls) {
    Links back(model.restPositions.size());
    for (std::size_t v = 0; v < back.size(); ++v) {
        back[v].reserve(3 * (valence(model.incidences[shared::kStretch], v) +
                             valence(model.incidences[shared::kBend], v)));
    }
    std::vector<double> own(back.size(), 0.0);
    for (const ConstraintPull& pull : pulls) {
        std::array<double, 4> norms{};
        std::ranges::transform(pull.gradients, norms.begin(),
                               [](const Vec3& g) { return g.norm(); });
        for (int i = 0; i < pull.count; ++i) {
            const double size = pull.stiffness * norms[i];
            own[pull.vertices[i]] += size * norms[i];
            for (int j = 0; j < pull.count; ++j) {
                if (j != i) {
                    back[pull.vertices[j]].push_back({pull.vertices[i], size * norms[j]});
                }
            }
        }
    }
    Links links = turnedRound(back);
    for (std::size_t v = 0; v < links.size(); ++v) {
        for (GroupLink& link : links[v]) {
            link.strength /= std::max(std::sqrt(own[v] * own[link.item]), 1e-300);
        }
    }
    return links;
}

/// Things that are grouped: vertices, or patches of them.
struct Items {
    Links links;
    std::vector<int> piece;         ///< -1: of none, left out
    std::vector<std::size_t> size;  ///< vertices
    std::vector<Vec3> place;        ///< at rest [m]
};

/// The groups of items while they are made.
class Grouping {
  public:
    explicit Grouping(const Items& items) : items_(items), group_(items.piece.size(), kNone) {}

    bool isFree(std::uint32_t item) const {
        return group_[item] == kNone && items_.piece[item] >= 0;
    }
    /// An empty one.
    std::uint32_t open() {
        groups_.emplace_back();
        sizes_.push_back(0);
        return static_cast<std::uint32_t>(groups_.size() - 1);
    }
    void add(std::uint32_t item, std::uint32_t group) {
        group_[item] = group;
        groups_[group].push_back(item);
        sizes_[group] += items_.size[item];
    }
    std::size_t sizeOf(std::uint32_t group) const { return sizes_[group]; }

    /// Items of groups of fewer than `least` vertices join the group that holds them most firmly,
    /// where that has at most `most` then.
    void dissolveSmall(std::size_t least, std::size_t most) {
        for (std::uint32_t g = 0; g < groups_.size(); ++g) {
            if (sizes_[g] >= least) {
                continue;
            }
            const VertexGroup own = std::exchange(groups_[g], {});
            sizes_[g] = 0;
            for (const std::uint32_t item : own) {
                const std::uint32_t to = firmest(item, g, most);
                add(item, to == kNone ? g : to);
            }
        }
    }

    std::vector<VertexGroup> done() {
        std::erase_if(groups_, [](const VertexGroup& group) { return group.empty(); });
        for (VertexGroup& group : groups_) {
            std::ranges::sort(group);
        }
        return std::move(groups_);
    }

  private:
    std::uint32_t firmest(std::uint32_t item, std::uint32_t own, std::size_t most) const {
        std::map<std::uint32_t, double> strengths;
        for (const GroupLink& link : items_.links[item]) {
            const std::uint32_t g = group_[link.item];
            if (g != kNone && g != own && items_.piece[link.item] == items_.piece[item] &&
                sizes_[g] + items_.size[item] <= most) {
                strengths[g] += link.strength;
            }
        }
        const auto best = std::ranges::max_element(strengths, {}, [](auto& p) { return p.second; });
        return best == strengths.end() ? kNone : best->first;
    }

    const Items& items_;
    std::vector<std::uint32_t> group_;  ///< of each item
    std::vector<VertexGroup> groups_;
    std::vector<std::size_t> sizes_;
};

/// Vertices beside those that are taken, each with a number that changes, of which the least is
/// asked for.
class Fringe {
  public:
    explicit Fringe(std::size_t vertexCount)
        : numbers_(vertexCount, 0.0), listed_(vertexCount, false) {}
    double& operator[](std::uint32_t v) { return numbers_[v]; }
    void add(std::uint32_t v) {
        if (!listed_[v]) {
            listed_[v] = true;
            fringe_.push_back(v);
        }
    }
    /// Of those that are free the first one with the least number; kNone if there is none.
    std::uint32_t first(const Grouping& grouping) {
        std::erase_if(fringe_, [&](std::uint32_t v) { return !grouping.isFree(v); });
        const auto best = std::ranges::min_element(
            fringe_, {}, [&](std::uint32_t v) { return std::pair(numbers_[v], v); });
        return best == fringe_.end() ? kNone : *best;
    }
    /// Leaves none, and their numbers 0.
    void clear() {
        for (const std::uint32_t v : fringe_) {
            numbers_[v] = 0;
            listed_[v] = false;
        }
        fringe_.clear();
    }

  private:
    std::vector<double> numbers_;
    std::vector<std::uint32_t> fringe_;  ///< some of them are taken by now
    std::vector<char> listed_;           ///< by vertex: it is there, or was until it was taken
};

std::vector<VertexGroup> growPatches(const Items& vertices) {
    const Links& links = vertices.links;
    Grouping grouping(vertices);
    Fringe fringe(links.size());  // their free neighbours
    Fringe around(links.size());  // of a patch: how firmly it holds them, negated
    for (std::uint32_t v = 0; v < links.size(); ++v) {
        fringe[v] = static_cast<double>(links[v].size());
    }
    for (std::uint32_t scan = 0; scan < links.size();) {
        std::uint32_t v = fringe.first(grouping);
        if (v == kNone) {
            if (!grouping.isFree(scan)) {
                ++scan;
                continue;
            }
            v = scan;
        }
        const std::uint32_t patch = grouping.open();
        const int piece = vertices.piece[v];
        around.clear();
        while (v != kNone) {
            grouping.add(v, patch);
            for (const GroupLink& link : links[v]) {
                --fringe[link.item];
                fringe.add(link.item);
                if (vertices.piece[link.item] == piece) {
                    around[link.item] -= link.strength;
                    around.add(link.item);
                }
            }
            v = grouping.sizeOf(patch) < kPatchSize ? around.first(grouping) : kNone;
        }
    }
    for (int pass = 0; pass < 3; ++pass) {
        grouping.dissolveSmall(kPatchSize / 3, kMostOfPatch);
    }
    return grouping.done();
}

/// Halves a box along its longest side until what is inside has at most `most` vertices.
void divideBox(const Items& items, VertexGroup inside, std::size_t most,
               std::vector<VertexGroup>& boxes) {
    std::size_t size = 0;
    Bounds bounds;
    for (const std::uint32_t item : inside) {
        size += items.size[item];
        bounds.add(items.place[item]);
    }
    if (size <= most || inside.size() == 1) {
        boxes.push_back(std::move(inside));
        return;
    }
    int axis = 0;
    (bounds.high - bounds.low).maxCoeff(&axis);
    const auto middle = inside.begin() + static_cast<std::ptrdiff_t>(inside.size() / 2);
    std::ranges::nth_element(inside, middle, {}, [&](std::uint32_t item) {
        return std::pair(items.place[item][axis], item);
    });
    divideBox(items, VertexGroup(inside.begin(), middle), most, boxes);
    divideBox(items, VertexGroup(middle, inside.end()), most, boxes);
}

std::vector<std::uint32_t> boxesOf(const Items& items, std::size_t pieceCount, std::size_t most) {
    std::vector<VertexGroup> pieces(pieceCount);
    for (std::uint32_t item = 0; item < items.piece.size(); ++item) {
        if (items.piece[item] >= 0) {
            pieces[items.piece[item]].push_back(item);
        }
    }
    std::vector<VertexGroup> boxes;
    for (VertexGroup& piece : pieces) {
        if (!piece.empty()) {
            divideBox(items, std::move(piece), most, boxes);
        }
    }
    std::vector<std::uint32_t> boxOf(items.piece.size(), kNone);
    for (std::uint32_t b = 0; b < boxes.size(); ++b) {
        for (const std::uint32_t item : boxes[b]) {
            boxOf[item] = b;
        }
    }
    return boxOf;
}

/// Boxes, divided into what hangs together inside each.
std::vector<VertexGroup> connectedBoxes(const Items& items, std::size_t pieceCount,
                                        std::size_t most) {
    const std::vector<std::uint32_t> boxOf = boxesOf(items, pieceCount, most);
    Grouping grouping(items);
    for (std::uint32_t seed = 0; seed < boxOf.size(); ++seed) {
        if (!grouping.isFree(seed)) {
            continue;
        }
        const std::uint32_t part = grouping.open();
        VertexGroup ahead{seed};
        grouping.add(seed, part);
        while (!ahead.empty()) {
            const std::uint32_t item = ahead.back();
            ahead.pop_back();
            for (const GroupLink& link : items.links[item]) {
                if (boxOf[link.item] == boxOf[item] && grouping.isFree(link.item)) {
                    grouping.add(link.item, part);
                    ahead.push_back(link.item);
                }
            }
        }
    }
    grouping.dissolveSmall(std::max<std::size_t>(4, most / 6), 2 * most);
    return grouping.done();
}

Items vertexItems(const BodyModel& model, std::span<const ConstraintPull> pulls) {
    return {linksOf(model, pulls), model.pieceOfVertex,
            std::vector<std::size_t>(model.restPositions.size(), 1), restPlaces(model)};
}

/// Items that are groups of others.
Items groupItems(const Items& of, const std::vector<VertexGroup>& groups) {
    std::vector<std::uint32_t> groupOf(of.piece.size(), kNone);
    for (std::uint32_t g = 0; g < groups.size(); ++g) {
        for (const std::uint32_t item : groups[g]) {
            groupOf[item] = g;
        }
    }
    Items items;
    Links back(groups.size());
    for (std::uint32_t g = 0; g < groups.size(); ++g) {
        std::size_t size = 0;
        Vec3 center = Vec3::Zero();
        for (const std::uint32_t item : groups[g]) {
            size += of.size[item];
            center += static_cast<double>(of.size[item]) * of.place[item];
            for (const GroupLink& link : of.links[item]) {
                if (const std::uint32_t other = groupOf[link.item]; other != g && other != kNone) {
                    back[other].push_back({g, link.strength});
                }
            }
        }
        items.piece.push_back(of.piece[groups[g][0]]);
        items.size.push_back(size);
        items.place.emplace_back(center / static_cast<double>(size));
    }
    items.links = turnedRound(back);
    return items;
}

std::vector<std::vector<std::uint32_t>> regionsOf(const Items& aggregates, std::size_t pieceCount) {
    std::vector<std::size_t> counts(pieceCount, 0);
    std::vector<std::size_t> sizes(pieceCount, 0);
    for (std::size_t a = 0; a < aggregates.piece.size(); ++a) {
        ++counts[aggregates.piece[a]];
        sizes[aggregates.piece[a]] += aggregates.size[a];
    }
    Items many = aggregates;
    std::vector<std::vector<std::uint32_t>> regions;
    for (std::uint32_t a = 0; a < many.piece.size(); ++a) {
        if (counts[many.piece[a]] <= kMostAggregates) {
            many.piece[a] = -1;
            regions.push_back({a});
        }
    }
    if (regions.size() < many.piece.size()) {
        const std::size_t most = *std::ranges::max_element(sizes) / kRegions;
        std::ranges::move(connectedBoxes(many, pieceCount, most), std::back_inserter(regions));
    }
    return regions;
}

}  // namespace

std::vector<Seat> seatsOf(const std::vector<VertexGroup>& groups, std::size_t vertexCount) {
    std::vector<Seat> seats(vertexCount);
    for (std::size_t g = 0; g < groups.size(); ++g) {
        for (std::size_t k = 0; k < groups[g].size(); ++k) {
            seats[groups[g][k]] = {static_cast<int>(g), static_cast<int>(k)};
        }
    }
    return seats;
}

VertexGroup VertexGroups::verticesOf(const std::vector<std::uint32_t>& region) const {
    VertexGroup vertices;
    for (const std::uint32_t a : region) {
        vertices.insert(vertices.end(), aggregates[a].begin(), aggregates[a].end());
    }
    return vertices;
}

VertexGroups groupVertices(const BodyModel& model, std::span<const ConstraintPull> pulls,
                           std::size_t aggregateSize) {
    assert(2 * aggregateSize <= shared::kMostMembers);
    const Items vertices = vertexItems(model, pulls);
    VertexGroups groups{growPatches(vertices), {}, {}};
    const Items patches = groupItems(vertices, groups.patches);
    groups.aggregates = connectedBoxes(patches, model.pieces.size(), aggregateSize);
    groups.regions = regionsOf(groupItems(patches, groups.aggregates), model.pieces.size());
    for (VertexGroup& aggregate : groups.aggregates) {
        VertexGroup members;
        for (const std::uint32_t patch : aggregate) {
            members.insert(members.end(), groups.patches[patch].begin(),
                           groups.patches[patch].end());
        }
        aggregate = std::move(members);
    }
    return groups;
}

}  // namespace kerf
