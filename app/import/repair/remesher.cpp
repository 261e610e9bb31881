#include "app/import/repair/remesher.h"

#include "sim/base/containers.h"
#include "sim/mesh/nearest_triangle.h"
#include "sim/repair/soup_editing.h"

namespace kerf::app {

namespace {

constexpr double kLong = 4.0 / 3;   // of the wanted length: divided
constexpr double kShort = 4.0 / 5;  // of the wanted length: collapses
// Cosine by which a triangle may turn at most when a vertex of it moves.
constexpr double kLeastTurn = 0.5;
// A change makes no triangle flatter than this that was better.
constexpr double kLeastQuality = 0.25;
constexpr double kFlatter = 0.8;
constexpr int kRegularValence = 6;
constexpr double kRounding = 1e-9;  // of a volume

bool has(const Triangle& t, int v) {
    return t[0] == v || t[1] == v || t[2] == v;
}

int cornerBeside(const Triangle& t, int a, int b) {
    return t[0] != a && t[0] != b ? t[0] : t[1] != a && t[1] != b ? t[1] : t[2];
}

Triangle replaced(Triangle t, int from, int to) {
    std::ranges::replace(t, from, to);
    return t;
}

/// Height over longest edge, times 2 over the square root of 3: 1 for an even triangle.
double qualityOf(const Corners& at) {
    return 2.31 * triangleArea(at) / longestEdgeSquare(at);
}

/// Whether a runs to b in the triangle.
bool runs(const Triangle& t, int a, int b) {
    return (t[0] == a && t[1] == b) || (t[1] == a && t[2] == b) || (t[2] == a && t[0] == b);
}

}  // namespace

Remesher::Remesher(TriangleSoup& soup, const Order& order)
    : soup_(soup),
      order_(order),
      cosHard_(order.hardAngle > 180 ? -2 : std::cos(order.hardAngle * std::numbers::pi / 180)),
      free_(order.free),
      wanted_(order.edge),
      fixed_(soup.positions.size(), 0),
      at_(soup.positions.size()) {
    free_.resize(soup.triangles.size(), order.free.empty() ? 1 : 0);
    for (int t = 0; t < static_cast<int>(soup.triangles.size()); ++t) {
        for (const int v : soup.triangles[t]) {
            at_[v].push_back(t);
            fixed_[v] = free_[t] == 0 ? 1 : fixed_[v];
        }
    }
}

void Remesher::run() {
    for (int round = 0; round < order_.rounds; ++round) {
        if (order_.onRound) {
            order_.onRound(round);
        }
        divideLong();
        collapseShort();
        flipEdges();
        relax();
    }
    pack();
}

// --- What there is ---------------------------------------------------------------------------

std::vector<std::pair<int, int>> Remesher::freeEdges() const {
    std::vector<std::pair<int, int>> edges;
    for (std::size_t t = 0; t < soup_.triangles.size(); ++t) {
        const Triangle& c = soup_.triangles[t];
        for (int i = 0; i < 3 && c[0] >= 0 && free_[t] != 0; ++i) {
            edges.emplace_back(std::minmax(c[i], c[(i + 1) % 3]));
        }
    }
    sortUnique(edges);
    return edges;
}

/// The free triangles of an edge; empty where one is not free, or there are not two.
std::vector<int> Remesher::trianglesAt(int a, int b) const {
    std::vector<int> found;
    for (const int t : at_[a]) {
        if (has(soup_.triangles[t], b)) {
            found.push_back(t);
        }
    }
    const bool both = found.size() == 2 && free_[found[0]] != 0 && free_[found[1]] != 0;
    return both ? found : std::vector<int>{};
}

double Remesher::length(int a, int b) const {
    return (soup_.positions[a] - soup_.positions[b]).norm();
}

Corners Remesher::cornersOf(const Triangle& t) const {
    return {soup_.positions[t[0]], soup_.positions[t[1]], soup_.positions[t[2]]};
}

Vec3 Remesher::normalOf(const Triangle& t) const {
    return unitNormal(soup_.positions[t[0]], soup_.positions[t[1]], soup_.positions[t[2]]);
}

bool Remesher::isHard(const std::vector<int>& both) const {
    return normalOf(soup_.triangles[both[0]]).dot(normalOf(soup_.triangles[both[1]])) < cosHard_;
}

std::vector<int> Remesher::neighboursOf(int v) const {
    std::vector<int> found;
    for (const int t : at_[v]) {
        for (const int other : soup_.triangles[t]) {
            if (other != v) {
                found.push_back(other);
            }
        }
    }
    sortUnique(found);
    return found;
}

/// The other ends of the hard edges of a vertex that is not fixed.
std::vector<int> Remesher::hardEndsAt(int v) const {
    std::vector<int> ends;
    if (cosHard_ < -1) {
        return ends;
    }
    for (const int other : neighboursOf(v)) {
        const std::vector<int> both = trianglesAt(v, other);
        if (both.empty() || isHard(both)) {
            ends.push_back(other);
        }
    }
    return ends;
}

// --- Edges that are too long -----------------------------------------------------------------

void Remesher::divideLong() {
    for (const auto& [a, b] : freeEdges()) {
        const std::vector<int> both = trianglesAt(a, b);
        if (!both.empty() && length(a, b) > kLong * wanted_[both[0]]) {
            divide(a, b, both);
        }
    }
}

void Remesher::divide(int a, int b, const std::vector<int>& both) {
    const int middle = static_cast<int>(soup_.positions.size());
    soup_.positions.push_back(0.5 * (soup_.positions[a] + soup_.positions[b]));
    at_.emplace_back();
    fixed_.push_back(0);
    for (const int t : both) {
        const Triangle before = soup_.triangles[t];
        setTriangle(t, replaced(before, b, middle));
        addTriangle(replaced(before, a, middle), t);
    }
}

// --- Edges that are too short ----------------------------------------------------------------

void Remesher::collapseShort() {
    for (const auto& [a, b] : freeEdges()) {
        const std::vector<int> both = trianglesAt(a, b);
        if (both.empty() || length(a, b) >= kShort * wanted_[both[0]]) {
            continue;
        }
        if (mayCollapse(a, b)) {
            collapse(a, b);
        } else if (mayCollapse(b, a)) {
            collapse(b, a);
        }
    }
}

bool Remesher::mayCollapse(int gone, int stays) const {
    if (isFixed(gone)) {
        return false;
    }
    const std::vector<int> ends = hardEndsAt(gone);
    if (!ends.empty() && (ends.size() != 2 || std::ranges::find(ends, stays) == ends.end())) {
        return false;
    }
    const std::vector<int> mine = neighboursOf(gone);
    const std::vector<int> theirs = neighboursOf(stays);
    std::vector<int> common;
    std::ranges::set_intersection(mine, theirs, std::back_inserter(common));
    if (common.size() != 2 || at_[common[0]].size() <= 3 || at_[common[1]].size() <= 3) {
        return false;
    }
    const double most = kLong * wanted_[at_[gone].front()];
    const bool tooLong =
        std::ranges::any_of(mine, [&](int v) { return v != stays && length(v, stays) > most; });
    return !tooLong && staysGood(gone, stays, soup_.positions[stays]);
}

/// Whether the triangles of a vertex, but those at `except`, keep their side where it moves, and
/// none becomes much flatter than the flattest was.
bool Remesher::staysGood(int v, int except, const Vec3& at) const {
    double before = kLeastQuality;
    double after = kLeastQuality;
    for (const int t : at_[v]) {
        const Triangle& corners = soup_.triangles[t];
        before = std::min(before, qualityOf(cornersOf(corners)));
        if (except >= 0 && has(corners, except)) {
            continue;
        }
        Corners moved = cornersOf(corners);
        moved[corners[0] == v ? 0 : corners[1] == v ? 1 : 2] = at;
        after = std::min(after, qualityOf(moved));
        const Vec3 normal = unitNormal(moved[0], moved[1], moved[2]);
        if (normal.dot(normalOf(corners)) <= kLeastTurn) {
            return false;
        }
    }
    return after >= kFlatter * before;
}

void Remesher::collapse(int gone, int stays) {
    for (const int t : std::vector<int>(at_[gone])) {
        if (has(soup_.triangles[t], stays)) {
            removeTriangle(t);
        } else {
            setTriangle(t, replaced(soup_.triangles[t], gone, stays));
        }
    }
}

// --- Valences --------------------------------------------------------------------------------

void Remesher::flipEdges() {
    for (const auto& [a, b] : freeEdges()) {
        const std::vector<int> both = trianglesAt(a, b);
        if (!both.empty() && !isHard(both)) {
            flip(a, b, both);
        }
    }
}

bool Remesher::improves(int a, int b, int c, int d) const {
    const auto deviation = [&](int v, int change) {
        const int off = static_cast<int>(at_[v].size()) + change - kRegularValence;
        return off * off;
    };
    return deviation(a, -1) + deviation(b, -1) + deviation(c, 1) + deviation(d, 1) <
           deviation(a, 0) + deviation(b, 0) + deviation(c, 0) + deviation(d, 0);
}

void Remesher::flip(int a, int b, const std::vector<int>& both) {
    const int first = runs(soup_.triangles[both[0]], a, b) ? both[0] : both[1];
    const int second = first == both[0] ? both[1] : both[0];
    const int c = cornerBeside(soup_.triangles[first], a, b);
    const int d = cornerBeside(soup_.triangles[second], a, b);
    const Triangle newFirst{a, d, c};
    const Triangle newSecond{d, b, c};
    const std::vector<int> around = neighboursOf(c);
    const bool known = std::ranges::binary_search(around, d);
    const bool possible = c != d && !known && at_[a].size() > 3 && at_[b].size() > 3;
    if (!possible || !keepsFacing(both, newFirst, newSecond)) {
        return;
    }
    const double before = leastQuality(soup_.triangles[both[0]], soup_.triangles[both[1]]);
    const double after = leastQuality(newFirst, newSecond);
    const bool better =
        before < kLeastQuality ? after > before : after >= kLeastQuality && improves(a, b, c, d);
    if (!better) {
        return;
    }
    setTriangle(first, newFirst);
    setTriangle(second, newSecond);
}

double Remesher::leastQuality(const Triangle& first, const Triangle& second) const {
    return std::min(qualityOf(cornersOf(first)), qualityOf(cornersOf(second)));
}

bool Remesher::keepsFacing(const std::vector<int>& both, const Triangle& first,
                           const Triangle& second) const {
    return std::ranges::all_of(both, [&](int t) {
        const Vec3 normal = normalOf(soup_.triangles[t]);
        return normalOf(first).dot(normal) > kLeastTurn &&
               normalOf(second).dot(normal) > kLeastTurn;
    });
}

// --- Places ----------------------------------------------------------------------------------

void Remesher::relax() {
    for (int v = 0; v < static_cast<int>(at_.size()); ++v) {
        if (at_[v].empty() || isFixed(v)) {
            continue;
        }
        if (const std::optional<Vec3> middle = middleOf(v)) {
            const Vec3 at = order_.project ? order_.project(*middle) : *middle;
            if (staysGood(v, -1, at)) {
                soup_.positions[v] = at;
            }
        }
    }
}

/// The middle of the neighbours, along the surface, or of those along a hard line.
std::optional<Vec3> Remesher::middleOf(int v) const {
    const std::vector<int> ends = hardEndsAt(v);
    const Vec3& own = soup_.positions[v];
    if (ends.size() == 2) {
        const Vec3 along = (soup_.positions[ends[1]] - soup_.positions[ends[0]]).stableNormalized();
        const Vec3 way = 0.5 * (soup_.positions[ends[0]] + soup_.positions[ends[1]]) - own;
        return own + along.dot(way) * along;
    }
    if (!ends.empty()) {
        return std::nullopt;
    }
    Vec3 sum = Vec3::Zero();
    Vec3 normal = Vec3::Zero();
    const std::vector<int> around = neighboursOf(v);
    for (const int other : around) {
        sum += soup_.positions[other];
    }
    for (const int t : at_[v]) {
        const Triangle& c = soup_.triangles[t];
        normal += areaNormal(soup_.positions[c[0]], soup_.positions[c[1]], soup_.positions[c[2]]);
    }
    const Vec3 way = sum / static_cast<double>(around.size()) - own;
    normal.stableNormalize();
    return own + (order_.project ? Vec3(way - normal.dot(way) * normal) : way);
}

// --- Changes ---------------------------------------------------------------------------------

void Remesher::setTriangle(int t, const Triangle& corners) {
    for (const int v : soup_.triangles[t]) {
        if (!has(corners, v)) {
            std::erase(at_[v], t);
        }
    }
    for (const int v : corners) {
        if (!has(soup_.triangles[t], v)) {
            at_[v].push_back(t);
        }
    }
    soup_.triangles[t] = corners;
}

int Remesher::addTriangle(const Triangle& corners, int like) {
    const int t = static_cast<int>(soup_.triangles.size());
    repair::addTriangle(soup_, corners, attributesOf(soup_.skin, like));
    free_.push_back(1);
    wanted_.push_back(wanted_[like]);
    for (const int v : corners) {
        at_[v].push_back(t);
    }
    return t;
}

void Remesher::removeTriangle(int t) {
    for (const int v : soup_.triangles[t]) {
        std::erase(at_[v], t);
    }
    soup_.triangles[t] = {-1, -1, -1};
}

void Remesher::pack() {
    repair::keepTriangles(soup_, [this](int t) { return soup_.triangles[t][0] >= 0; });
    repair::dropUnusedVertices(soup_);
}

namespace {

/// By the lowest corner of each part, which stays the order of parts.
std::vector<double> partVolumes(const TriangleSoup& soup) {
    return repair::volumesOf(soup, repair::partsOf(soup));
}

std::vector<Vec3> normalsOf(const TriangleSoup& soup) {
    std::vector<Vec3> normals(soup.positions.size(), Vec3::Zero());
    for (const Triangle& t : soup.triangles) {
        const Vec3 normal =
            areaNormal(soup.positions[t[0]], soup.positions[t[1]], soup.positions[t[2]]);
        for (const int v : t) {
            normals[v] += normal;
        }
    }
    for (Vec3& normal : normals) {
        normal.stableNormalize();
    }
    return normals;
}

/// Edges of a round surface cut corners: it moves out by what that has cost, a hair everywhere.
void restoreVolumes(TriangleSoup& soup, const std::vector<double>& wanted) {
    const std::vector<int> parts = repair::partsOf(soup);
    const std::vector<double> volumes = repair::volumesOf(soup, parts);
    const std::vector<double> areas = repair::areasOf(soup, parts);
    if (volumes.size() != wanted.size()) {
        return;
    }
    std::vector<int> partOfVertex(soup.positions.size(), -1);
    for (std::size_t t = 0; t < parts.size(); ++t) {
        for (const int v : soup.triangles[t]) {
            partOfVertex[v] = parts[t];
        }
    }
    const std::vector<Vec3> normals = normalsOf(soup);
    for (std::size_t v = 0; v < normals.size(); ++v) {
        const int part = partOfVertex[v];
        const double lost = wanted[part] - volumes[part];
        if (std::abs(lost) > kRounding * std::abs(wanted[part])) {
            soup.positions[v] += lost / areas[part] * normals[v];
        }
    }
}

}  // namespace

void remesh(TriangleSoup& soup, double edge, const std::function<void(int round)>& onRound) {
    const TriangleSoup original{soup.positions, soup.triangles, {}};
    std::vector<int> all(original.triangles.size());
    std::iota(all.begin(), all.end(), 0);
    const auto cornersOf = [&original](int t) {
        const auto& [a, b, c] = original.triangles[t];
        return Corners{original.positions[a], original.positions[b], original.positions[c]};
    };
    NearestTriangle nearest(all, cornersOf);
    Remesher::Order order;
    order.edge.assign(soup.triangles.size(), edge);
    order.onRound = onRound;
    order.project = [&](const Vec3& p) {
        const Corners at = cornersOf(nearest.find(p));
        const Vec3 weights = closestWeights(p, at[0], at[1], at[2]);
        return Vec3(weights[0] * at[0] + weights[1] * at[1] + weights[2] * at[2]);
    };
    soup.skin.uvs.clear();
    soup.skin.colors.clear();
    Remesher(soup, order).run();
    restoreVolumes(soup, partVolumes(original));
}

}  // namespace kerf::app
