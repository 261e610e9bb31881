#include "sim/mesh/triangle_soup.h"

#include <bit>
#include <unordered_map>

#include "sim/base/math.h"
#include "sim/base/placement.h"
#include "sim/mesh/union_find.h"

namespace kerf {

namespace {

using PositionBits = std::array<std::uint64_t, 3>;

/// Adding 0 turns -0 into 0, so that both have the same bits.
PositionBits bitsOf(const Vec3& p) {
    return {std::bit_cast<std::uint64_t>(p.x() + 0.0), std::bit_cast<std::uint64_t>(p.y() + 0.0),
            std::bit_cast<std::uint64_t>(p.z() + 0.0)};
}

/// Only used to look up: the order of the map is never walked.
struct PositionBitsHash {
    std::size_t operator()(const PositionBits& bits) const {
        std::uint64_t hash = 0;
        for (const std::uint64_t b : bits) {
            hash = (hash ^ b) * 0x9E3779B97F4A7C15u;
            hash ^= hash >> 29;
        }
        return hash;
    }
};

/// By vertex: the first one at the same place.
std::vector<int> firstAtPlace(const std::vector<Vec3>& positions) {
    std::unordered_map<PositionBits, int, PositionBitsHash> places;
    std::vector<int> first;
    first.reserve(positions.size());
    for (const Vec3& p : positions) {
        first.push_back(
            places.try_emplace(bitsOf(p), static_cast<int>(first.size())).first->second);
    }
    return first;
}

/// The same soup with other corners, without the vertices that none of them uses. Corner c is at
/// the place of vertex `source[c]`.
TriangleSoup withCorners(const TriangleSoup& soup, std::vector<Triangle> corners,
                         const std::vector<int>& source) {
    TriangleSoup welded{{}, std::move(corners), soup.skin, soup.objects};
    std::vector<int> numbers(source.size(), -1);
    for (Triangle& t : welded.triangles) {
        for (int& corner : t) {
            int& number = numbers[corner];
            if (number < 0) {
                number = static_cast<int>(welded.positions.size());
                welded.positions.push_back(soup.positions[source[corner]]);
            }
            corner = number;
        }
    }
    return welded;
}

/// The lowest corner first; the way around stays.
Triangle turned(Triangle t) {
    std::rotate(t.begin(), std::ranges::min_element(t), t.end());
    return t;
}

/// Decides which corners become one vertex.
class ObjectWelding {
  public:
    explicit ObjectWelding(const TriangleSoup& soup)
        : soup_(soup),
          place_(firstAtPlace(soup.positions)),
          corners_(soup.triangles),
          source_(soup.positions.size()),
          open_(soup.triangles.size()) {
        std::iota(source_.begin(), source_.end(), 0);
        std::iota(open_.begin(), open_.end(), 0);
    }

    TriangleSoup weld() {
        const auto shared = [&](const Triangle& t) { return isShared(t); };
        if (!soup_.objects.empty() || std::ranges::any_of(soup_.triangles, shared)) {
            keepClosed(false);
            if (!soup_.objects.empty()) {
                weldOpen([&](int t) { return soup_.objects[t]; });
                keepClosed(true);
            }
            openAlike();
            weldOpen([](int) { return 0; });
        }
        return withCorners(soup_, std::move(corners_), source_);
    }

  private:
    bool isShared(const Triangle& t) const {
        return std::ranges::any_of(t, [&](int v) { return place_[v] != v; });
    }
    Triangle placesOf(int t) const {
        Triangle places = soup_.triangles[t];
        std::ranges::transform(places, places.begin(), [&](int v) { return place_[v]; });
        return places;
    }
    bool isFlat(int t) const {
        const auto [a, b, c] = placesOf(t);
        return a == b || b == c || c == a;
    }

    /// The open triangles of one group get one vertex at each place.
    void weldOpen(auto&& groupOf) {
        std::ranges::stable_sort(open_, {}, groupOf);
        std::vector<int> group(place_.size(), -1);  // by place: the last one that met it
        std::vector<int> vertex(place_.size());
        for (const int t : open_) {
            for (int i = 0; i < 3; ++i) {
                const int v = soup_.triangles[t][i];
                const int place = place_[v];
                if (group[place] != groupOf(t)) {
                    group[place] = groupOf(t);
                    vertex[place] = static_cast<int>(source_.size());
                    source_.push_back(v);
                }
                corners_[t][i] = vertex[place];
            }
        }
    }

    /// By corner: a number of the part that these triangles make there.
    UnionFind partsOf(const std::vector<int>& triangles) const {
        UnionFind parts(source_.size());
        for (const int t : triangles) {
            parts.join(corners_[t][0], corners_[t][1]);
            parts.join(corners_[t][0], corners_[t][2]);
        }
        return parts;
    }

    /// What has two triangles at each edge is open no more, or `branching` more than two: nothing
    /// of another object is wanted to close it.
    void keepClosed(bool branching) {
        UnionFind parts = partsOf(open_);
        std::vector<char> isOpen(source_.size(), 0);  // by root
        std::vector<std::pair<int, int>> edges;
        edges.reserve(3 * open_.size());
        for (const int t : open_) {
            for (int i = 0; i < 3; ++i) {
                edges.emplace_back(std::minmax({corners_[t][i], corners_[t][(i + 1) % 3]}));
            }
            char& open = isOpen[parts.root(corners_[t][0])];
            open = isFlat(t) ? 1 : open;
        }
        std::ranges::sort(edges);
        for (std::size_t i = 0, end = 0; i < edges.size(); i = end) {
            for (end = i; end < edges.size() && edges[end] == edges[i]; ++end) {
            }
            char& open = isOpen[parts.root(edges[i].first)];
            open = end - i == 2 || (branching && end - i > 2) ? open : 1;
        }
        std::erase_if(open_, [&](int t) { return isOpen[parts.root(corners_[t][0])] == 0; });
    }

    /// Solids that have the same triangle twice are no neighbours: one is there twice, or within
    /// the other.
    void openAlike() {
        std::vector<int> order = closedTriangles();
        UnionFind parts = partsOf(order);
        std::vector<int> partAt(place_.size(), -1);
        std::vector<char> meets(place_.size(), 0);  // by place: several parts do there
        for (const int t : order) {
            const int part = parts.root(corners_[t][0]);
            for (const int place : placesOf(t)) {
                partAt[place] = partAt[place] < 0 ? part : partAt[place];
                meets[place] = partAt[place] != part ? 1 : meets[place];
            }
        }
        const std::vector<int> closed = order;
        std::erase_if(order, [&](int t) {
            return std::ranges::any_of(placesOf(t), [&](int place) { return meets[place] == 0; });
        });
        const auto key = [&](int t) { return turned(placesOf(t)); };
        std::ranges::sort(order, {}, key);
        std::vector<char> isAlike(source_.size(), 0);  // by root
        for (std::size_t i = 1; i < order.size(); ++i) {
            if (key(order[i - 1]) == key(order[i])) {
                isAlike[parts.root(corners_[order[i - 1]][0])] = 1;
                isAlike[parts.root(corners_[order[i]][0])] = 1;
            }
        }
        std::ranges::copy_if(closed, std::back_inserter(open_),
                             [&](int t) { return isAlike[parts.root(corners_[t][0])] != 0; });
    }

    std::vector<int> closedTriangles() const {
        std::vector<char> isOpen(soup_.triangles.size(), 0);
        for (const int t : open_) {
            isOpen[t] = 1;
        }
        std::vector<int> closed;
        for (std::size_t t = 0; t < isOpen.size(); ++t) {
            if (isOpen[t] == 0) {
                closed.push_back(static_cast<int>(t));
            }
        }
        return closed;
    }

    const TriangleSoup& soup_;
    std::vector<int> place_;  ///< by vertex: the first one there
    std::vector<Triangle> corners_;
    std::vector<int> source_;  ///< by corner: the vertex at its place
    std::vector<int> open_;    ///< triangles that are in no closed part yet
};

/// Objects that have a vertex in common become one; numbered in the order of the first of each.
void joinObjects(TriangleSoup& welded) {
    if (welded.objects.empty()) {
        return;
    }
    UnionFind together(*std::ranges::max_element(welded.objects) + 1);
    std::vector<int> objectAt(welded.positions.size(), -1);
    for (std::size_t t = 0; t < welded.triangles.size(); ++t) {
        for (const int v : welded.triangles[t]) {
            objectAt[v] = objectAt[v] < 0 ? welded.objects[t] : objectAt[v];
            together.join(objectAt[v], welded.objects[t]);
        }
    }
    for (int& object : welded.objects) {
        object = together.root(object);
    }
}

using Cells = std::array<int, 3>;

/// A corner of the grid: indices along the three axes.
struct Corner {
    Cells at{};
};

Vec3 position(const Corner& corner, const Vec3& size, const Cells& cells) {
    Vec3 p;
    for (int axis = 0; axis < 3; ++axis) {
        p[axis] = size[axis] * (static_cast<double>(corner.at[axis]) / cells[axis] - 0.5);
    }
    return p;
}

/// One face, with corners of its own: welding joins the faces.
void addFace(TriangleSoup& soup, int axis, bool upper, const Vec3& size, const Cells& cells) {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    const int first = static_cast<int>(soup.positions.size());
    const int row = cells[v] + 1;
    for (int i = 0; i <= cells[u]; ++i) {
        for (int j = 0; j <= cells[v]; ++j) {
            Corner corner;
            corner.at[axis] = upper ? cells[axis] : 0;
            corner.at[u] = i;
            corner.at[v] = j;
            soup.positions.push_back(position(corner, size, cells));
        }
    }
    const auto add = [&](int a, int b, int c) {
        soup.triangles.push_back(upper ? Triangle{a, b, c} : Triangle{a, c, b});
    };
    for (int i = 0; i < cells[u]; ++i) {
        for (int j = 0; j < cells[v]; ++j) {
            const int a = first + i * row + j;
            const int b = a + row;
            const int c = b + 1;
            const int d = a + 1;
            if ((i + j) % 2 == 0) {
                add(a, b, c);
                add(a, c, d);
            } else {
                add(a, b, d);
                add(b, c, d);
            }
        }
    }
}

}  // namespace

TriangleSoup weldExactly(const TriangleSoup& soup) {
    const std::vector<int> place = firstAtPlace(soup.positions);
    std::vector<Triangle> corners = soup.triangles;
    for (Triangle& t : corners) {
        std::ranges::transform(t, t.begin(), [&](int v) { return place[v]; });
    }
    return withCorners(soup, std::move(corners), place);
}

TriangleSoup weldObjects(const TriangleSoup& soup) {
    TriangleSoup welded = ObjectWelding(soup).weld();
    joinObjects(welded);
    return welded;
}

Vec3 floatOrigin(const TriangleSoup& soup) {
    return soup.positions.empty() ? Vec3(Vec3::Zero()) : originOf(boxOf(soup.positions));
}

void roundToFloats(TriangleSoup& soup) {
    const Vec3 origin = floatOrigin(soup);
    for (Vec3& p : soup.positions) {
        p = origin + nearestFloats(p - origin);
    }
    soup = weldObjects(soup);
}

void turnTriangle(TriangleSoup& soup, int t) {
    std::swap(soup.triangles[t][1], soup.triangles[t][2]);
    TriangleAttributes turned = attributesOf(soup.skin, t);
    std::swap(turned.uvs[1], turned.uvs[2]);
    std::swap(turned.colors[1], turned.colors[2]);
    setAttributes(soup.skin, t, turned);
}

TriangleSoup boxSurface(const Vec3& size, const Cells& cells) {
    TriangleSoup soup;
    for (int axis = 0; axis < 3; ++axis) {
        addFace(soup, axis, false, size, cells);
        addFace(soup, axis, true, size, cells);
    }
    return weldExactly(soup);
}

}  // namespace kerf
