#include "sim/cut/patch/patch_surface.h"

#include "sim/cut/plan/strip/strip.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::cut {

namespace {

// Times the number of half-edges: ends what rounding might let go round in circles.
constexpr int kMostTurns = 20;
// Of the squared longest edge: below, a triangle has no area.
constexpr double kNoArea = 1e-9;
constexpr double kSameAngle = 1e-9;

}  // namespace

PatchSurface::PatchSurface(std::vector<PatchNode> nodes, std::vector<Triangle> triangles)
    : nodes_(std::move(nodes)),
      triangles_(std::move(triangles)),
      twins_(triangles_.size(), {-1, -1, -1}) {
    std::map<std::pair<int, int>, int> halfEdges;
    const int count = 3 * sizeOf(triangles_);
    for (int h = 0; h < count; ++h) {
        if (!halfEdges.emplace(std::pair{origin(h), target(h)}, h).second) {
            throw StepFailure{"the patch uses an edge twice"};
        }
        edges_.insert(edgeOf(origin(h), target(h)));
    }
    for (int h = 0; h < count; ++h) {
        const auto found = halfEdges.find({target(h), origin(h)});
        twins_[h / 3][h % 3] = found == halfEdges.end() ? -1 : found->second;
    }
    for (int t = 0; t < sizeOf(triangles_); ++t) {
        mark({t});
    }
}

void PatchSurface::mark(std::initializer_list<int> triangles) {
    for (const int t : triangles) {
        unrelaxed_.insert(unrelaxed_.end(), {3 * t, 3 * t + 1, 3 * t + 2});
    }
}

double PatchSurface::doubleArea(int a, int b, int c) const {
    return cross2(nodes_[b].layout - nodes_[a].layout, nodes_[c].layout - nodes_[a].layout);
}

void PatchSurface::link(int h, int g) {
    twins_[h / 3][h % 3] = g;
    if (g >= 0) {
        twins_[g / 3][g % 3] = h;
    }
}

int PatchSurface::meanOf(std::vector<int> nodes) {
    PatchNode mean;
    for (const int i : nodes) {
        mean.rest += nodes_[i].rest;
        mean.layout += nodes_[i].layout;
        mean.size += nodes_[i].size;
    }
    const double count = sizeOf(nodes);
    mean.rest /= count;
    mean.layout /= count;
    mean.size /= count;
    mean.from = std::move(nodes);
    nodes_.push_back(std::move(mean));
    return sizeOf(nodes_) - 1;
}

int PatchSurface::addTriangle(const Triangle& corners) {
    triangles_.push_back(corners);
    twins_.push_back({-1, -1, -1});
    return 3 * (sizeOf(triangles_) - 1);
}

//        c              abc becomes abm, bcm and cam
//       /|\             .
//      / m \            .
//     a-----b           .
void PatchSurface::splitTriangle(int t) {
    const auto [a, b, c] = triangles_[t];
    const int m = meanOf({a, b, c});
    const auto [ab, bc, ca] = twins_[t];
    const int h = 3 * t;
    const int second = addTriangle({b, c, m});
    const int third = addTriangle({c, a, m});
    triangles_[t] = {a, b, m};
    link(h, ab);
    link(second, bc);
    link(third, ca);
    link(h + 1, second + 2);
    link(second + 1, third + 2);
    link(third + 1, h + 2);
    edges_.insert({edgeOf(a, m), edgeOf(b, m), edgeOf(c, m)});
    mark({t, second / 3, third / 3});
}

//        c              abc and bad become amc, mbc, bmd and mad
//       /|\             .
//      a-m-b            .
//       \|/             .
//        d              .
void PatchSurface::splitEdge(int h) {
    const int g = twin(h);
    const int a = origin(h), b = target(h), c = apex(h), d = apex(g);
    const int bc = twin(SurfaceMesh::next(h)), ca = twin(SurfaceMesh::previous(h));
    const int ad = twin(SurfaceMesh::next(g)), db = twin(SurfaceMesh::previous(g));
    const int m = meanOf({a, b});
    const int amc = 3 * (h / 3);
    const int bmd = 3 * (g / 3);
    triangles_[h / 3] = {a, m, c};
    triangles_[g / 3] = {b, m, d};
    const int mbc = addTriangle({m, b, c});
    const int mad = addTriangle({m, a, d});
    link(amc, mad);
    link(amc + 1, mbc + 2);
    link(amc + 2, ca);
    link(mbc, bmd);
    link(mbc + 1, bc);
    link(bmd + 1, mad + 2);
    link(bmd + 2, db);
    link(mad + 1, ad);
    edges_.erase(edgeOf(a, b));
    edges_.insert({edgeOf(a, m), edgeOf(b, m), edgeOf(c, m), edgeOf(d, m)});
    mark({amc / 3, bmd / 3, mbc / 3, mad / 3});
}

/// Both angles opposite to the edge together are more than 180 degrees, or a triangle beside it has
/// no area; and the other diagonal is better.
bool PatchSurface::shouldTurn(int h) const {
    const int g = twin(h);
    if (g < 0) {
        return false;
    }
    const int a = origin(h), b = target(h), c = apex(h), d = apex(g);
    const Vec2& pa = nodes_[a].layout;
    const Vec2& pb = nodes_[b].layout;
    const double least = kNoArea * (pb - pa).squaredNorm();
    if (c == d || doubleArea(a, d, c) <= least || doubleArea(d, b, c) <= least) {
        return false;
    }
    const auto angleAt = [&](int apex) {
        const Vec2 u = pa - nodes_[apex].layout;
        const Vec2 v = pb - nodes_[apex].layout;
        return std::atan2(std::fabs(cross2(u, v)), u.dot(v));
    };
    const bool flat = doubleArea(a, b, c) <= least || doubleArea(b, a, d) <= least;
    const bool better = flat || angleAt(c) + angleAt(d) > std::numbers::pi + kSameAngle;
    return better && !edges_.contains(edgeOf(c, d));
}

//        c              abc and bad become adc and dbc
//       /|\             .
//      a | b            .
//       \|/             .
//        d              .
void PatchSurface::turn(int h) {
    const int g = twin(h);
    const int a = origin(h), b = target(h), c = apex(h), d = apex(g);
    const int bc = twin(SurfaceMesh::next(h)), ca = twin(SurfaceMesh::previous(h));
    const int ad = twin(SurfaceMesh::next(g)), db = twin(SurfaceMesh::previous(g));
    const int adc = 3 * (h / 3);
    const int dbc = 3 * (g / 3);
    triangles_[h / 3] = {a, d, c};
    triangles_[g / 3] = {d, b, c};
    link(adc, ad);
    link(adc + 1, dbc + 2);
    link(adc + 2, ca);
    link(dbc, db);
    link(dbc + 1, bc);
    edges_.erase(edgeOf(a, b));
    edges_.insert(edgeOf(c, d));
    mark({adc / 3, dbc / 3});
}

void PatchSurface::relax() {
    long turnsLeft = static_cast<long>(kMostTurns) * 3 * sizeOf(triangles_);
    while (!unrelaxed_.empty() && turnsLeft > 0) {
        const int h = unrelaxed_.back();
        unrelaxed_.pop_back();
        if (shouldTurn(h)) {
            turn(h);
            --turnsLeft;
        }
    }
    unrelaxed_.clear();
}

}  // namespace kerf::cut
