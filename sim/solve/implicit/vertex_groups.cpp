#include "sim/solve/implicit/vertex_groups.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "shaders/shared/implicit_records.h"

namespace kerf {

namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// How firmly something is held to another, as a share of what holds both.
struct Link {
    std::uint32_t item = 0;
    double strength = 0;
};
using Links = std::vector<std::vector<Link>>;

/// Ascending, each once.
void mergeLinks(std::vector<Link>& links) {
    std::ranges::stable_sort(links, {}, &Link::item);
    std::size_t kept = 0;
    for (std::size_t k = 0; k < links.size(); ++k) {
        if (kept > 0 && links[kept - 1].item == links[k].item) {
            links[kept - 1].strength += links[k].strength;
        } else {
            links[kept++] = links[k];
        }
    }
    links.resize(kept);
}

Links linksOf(const BodyModel& model, const TypeModuli& moduli) {
    const std::vector<Vec3> rest = restPlaces(model);
    Links links(rest.size());
    std::vector<double> own(rest.size(), 0.0);
    forEachPull(model, moduli, bendSteepness(model), rest, [&](const ConstraintPull& pull) {
        for (int i = 0; i < pull.count; ++i) {
            const double size = pull.stiffness * pull.gradients[i].norm();
            own[pull.vertices[i]] += size * pull.gradients[i].norm();
            for (int j = 0; j < pull.count; ++j) {
                if (j != i) {
                    links[pull.vertices[i]].push_back(
                        {pull.vertices[j], size * pull.gradients[j].norm()});
                }
            }
        }
    });
    for (std::size_t v = 0; v < links.size(); ++v) {
        mergeLinks(links[v]);
        for (Link& link : links[v]) {
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
        for (const Link& link : items_.links[item]) {
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

/// The free vertices beside those that are taken, those with the fewest free neighbours first.
class Fringe {
  public:
    explicit Fringe(const Links& links) : links_(links), on_(links.size(), false) {
        for (const auto& list : links) {
            freeAround_.push_back(list.size());
        }
    }
    /// `v` is free no longer.
    template <class IsFree>
    void take(std::uint32_t v, const IsFree& isFree) {
        remove(v);
        for (const Link& link : links_[v]) {
            const std::uint32_t w = link.item;
            remove(w);
            --freeAround_[w];
            if (isFree(w)) {
                fringe_.insert({freeAround_[w], w});
                on_[w] = true;
            }
        }
    }
    /// kNone if there is none.
    std::uint32_t first() const { return fringe_.empty() ? kNone : fringe_.begin()->second; }

  private:
    void remove(std::uint32_t v) {
        if (on_[v]) {
            fringe_.erase({freeAround_[v], v});
            on_[v] = false;
        }
    }

    const Links& links_;
    std::vector<std::size_t> freeAround_;
    std::set<std::pair<std::size_t, std::uint32_t>> fringe_;
    std::vector<bool> on_;
};

/// The free vertex of the same piece that most holds to a patch, or kNone.
template <class IsFree>
std::uint32_t firmestAround(std::map<std::uint32_t, double>& around, const IsFree& isFree) {
    std::erase_if(around, [&](const auto& entry) { return !isFree(entry.first); });
    const auto best = std::ranges::max_element(around, {}, [](auto& p) { return p.second; });
    return best == around.end() ? kNone : best->first;
}

std::vector<VertexGroup> growPatches(const Items& vertices) {
    const Links& links = vertices.links;
    Grouping grouping(vertices);
    Fringe fringe(links);
    const auto isFree = [&](std::uint32_t v) { return grouping.isFree(v); };
    for (std::uint32_t scan = 0; scan < links.size();) {
        std::uint32_t v = fringe.first();
        if (v == kNone) {
            if (!isFree(scan)) {
                ++scan;
                continue;
            }
            v = scan;
        }
        const std::uint32_t patch = grouping.open();
        const int piece = vertices.piece[v];
        std::map<std::uint32_t, double> around;
        while (v != kNone) {
            grouping.add(v, patch);
            fringe.take(v, isFree);
            for (const Link& link : links[v]) {
                if (vertices.piece[link.item] == piece) {
                    around[link.item] += link.strength;
                }
            }
            v = grouping.sizeOf(patch) < kPatchSize ? firmestAround(around, isFree) : kNone;
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
            for (const Link& link : items.links[item]) {
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

Items vertexItems(const BodyModel& model, const TypeModuli& moduli) {
    return {linksOf(model, moduli),
            model.pieceOfVertex,
            std::vector<std::size_t>(model.restPositions.size(), 1),
            {}};
}

Items patchItems(const Items& vertices, const std::vector<VertexGroup>& patches,
                 std::span<const Vec3f> rest) {
    std::vector<std::uint32_t> patchOf(vertices.piece.size(), kNone);
    for (std::uint32_t p = 0; p < patches.size(); ++p) {
        for (const std::uint32_t v : patches[p]) {
            patchOf[v] = p;
        }
    }
    Items items;
    items.links.resize(patches.size());
    for (std::uint32_t p = 0; p < patches.size(); ++p) {
        Vec3 center = Vec3::Zero();
        for (const std::uint32_t v : patches[p]) {
            center += rest[v].cast<double>() / static_cast<double>(patches[p].size());
            for (const Link& link : vertices.links[v]) {
                if (const std::uint32_t other = patchOf[link.item]; other != p && other != kNone) {
                    items.links[p].push_back({other, link.strength});
                }
            }
        }
        mergeLinks(items.links[p]);
        items.piece.push_back(vertices.piece[patches[p][0]]);
        items.size.push_back(patches[p].size());
        items.place.push_back(center);
    }
    return items;
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

VertexGroups groupVertices(const BodyModel& model, const TypeModuli& moduli,
                           std::size_t aggregateSize) {
    assert(2 * aggregateSize <= shared::kMostMembers);
    const Items vertices = vertexItems(model, moduli);
    VertexGroups groups{growPatches(vertices), {}};
    const Items patches = patchItems(vertices, groups.patches, model.restPositions);
    groups.aggregates = connectedBoxes(patches, model.pieces.size(), aggregateSize);
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
