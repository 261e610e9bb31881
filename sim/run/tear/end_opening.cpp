#include "sim/run/tear/end_opening.h"

#include "sim/mesh/triangle.h"

namespace kerf {

namespace {

/// Edges between the two walls of a stroke, by their origin on W+.
std::map<int, int> frontEdges(const SurfaceMesh& mesh) {
    std::map<int, int> edges;
    for (int t = 0; t < mesh.triangleSlots(); ++t) {
        const int label = mesh.alive(t) ? mesh.wallLabel(t) : -1;
        if (label < 0 || label % 2 != 0) {
            continue;
        }
        for (int h = 3 * t; h < 3 * t + 3; ++h) {
            if (mesh.wallLabel(SurfaceMesh::triangleOf(mesh.twin(h))) == label + 1) {
                edges.emplace(mesh.origin(h), h);
            }
        }
    }
    return edges;
}

/// Where the nearest point of a line of vertices lies, at rest.
PointBehind placeBehind(const SurfaceMesh& mesh, int v, const std::vector<int>& line) {
    PointBehind nearest{1e300, 0};
    const double parts = static_cast<double>(line.size() - 1);
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const Vec3& from = mesh.restPosition(line[i]);
        const Vec3 along = mesh.restPosition(line[i + 1]) - from;
        const Vec3 off = mesh.restPosition(v) - from;
        const double length = along.squaredNorm();
        const double t = length > 0 ? std::clamp(off.dot(along) / length, 0.0, 1.0) : 0.0;
        if (const double distance = (off - t * along).norm(); distance < nearest.distance) {
            nearest = {distance, (static_cast<double>(i) + t) / parts};
        }
    }
    return nearest;
}

// Opening one edge behind an end at which it advances where walls are free, of the law's reach were
// the cohesive zone as short as can be: linear elasticity at a quarter of the toughness. There a
// reach of more edges than kLongestReach counts as so many, as soft bodies blunt the end.
constexpr double kFreeOpening = 0.4;
constexpr double kLongestReach = 0.6;
constexpr double kLeastOfReach = 0.05;
constexpr double kOneFront = 3;  // edges: an end up to so long advances evenly

/// The reach of the law where walls are free [m].
double freeReach(const TearLaw& law, double edge) {
    const double reach = law.reach() * std::sqrt(kEdgesInZone / law.zone);
    return std::min(reach, std::max(kLongestReach * edge, kLeastOfReach * reach));
}

/// The opening of a point of W+ at which the end of its slit advances, `behind` from it [m]: where
/// walls are bonded, the law's reach at the other end of the zone.
double neededAt(const CohesiveZone& cohesion, double edge, int plus, double behind) {
    const CohesiveZone::Bond* bond = cohesion.find(plus);
    return bond != nullptr && !bond->isBroken()
               ? bond->reach() * std::pow(behind / (cohesion.law().zone * edge), 1.5)
               : kFreeOpening * freeReach(cohesion.law(), edge) * std::sqrt(behind / edge);
}

}  // namespace

std::map<int, PointBehind> pointsBehind(const SurfaceMesh& mesh, const SlitEnd& end, double most) {
    std::map<int, PointBehind> found;
    std::vector<int> open = end.vertices;
    for (std::size_t i = 0; i < open.size(); ++i) {
        mesh.forEachOutgoing(open[i], [&](int h) {
            const int v = mesh.target(h);
            if (mesh.wallLabel(SurfaceMesh::triangleOf(h)) != end.label || found.contains(v) ||
                std::ranges::find(end.vertices, v) != end.vertices.end()) {
                return;
            }
            if (const PointBehind place = placeBehind(mesh, v, end.vertices);
                place.distance <= most) {
                found.emplace(v, place);
                open.push_back(v);
            }
        });
    }
    return found;
}

std::optional<EndFrame> frameOf(const SurfaceMesh& mesh, const SlitEnd& end,
                                const VertexPositions& at) {
    Vec3 side = Vec3::Zero();
    Vec3 behind = Vec3::Zero();
    for (std::size_t i = 0; i + 1 < end.vertices.size(); ++i) {
        const int u = end.vertices[i];
        const int v = end.vertices[i + 1];
        const int h = mesh.findHalfEdge(u, v);
        if (h >= 0) {
            const Vec3& p = at[mesh.apex(h)];
            const Vec3& q = at[mesh.apex(mesh.twin(h))];
            side -= unitNormal<Vec3>(at[u], at[v], p) + unitNormal<Vec3>(at[u], at[v], q);
            behind += p + q - at[u] - at[v];
        }
    }
    EndFrame frame;
    frame.along = (at[end.vertices.back()] - at[end.vertices.front()]).stableNormalized();
    const Vec3 across = side - frame.along * side.dot(frame.along);
    frame.heading = frame.along.cross(across).stableNormalized();
    frame.heading *= frame.heading.dot(behind) > 0 ? -1 : 1;
    frame.side = across.stableNormalized();
    return frame.heading.isZero(0) ? std::nullopt : std::optional(frame);
}

std::optional<EndFrame> restFrameOf(const SurfaceMesh& mesh, const SlitEnd& end, double length) {
    std::optional<EndFrame> frame = frameOf(mesh, end, VertexPositions::atRest(mesh));
    if (!frame) {
        return frame;
    }
    const Vec3& first = mesh.restPosition(end.vertices.front());
    const Vec3& last = mesh.restPosition(end.vertices.back());
    Vec3 ahead = Vec3::Zero();
    for (const auto& [v, place] : pointsBehind(mesh, end, length)) {
        ahead += first + place.share * (last - first) - mesh.restPosition(v);
    }
    ahead -= frame->along * frame->along.dot(ahead);
    if (!ahead.isZero(0)) {
        frame->heading = ahead.normalized();
        frame->side -= frame->heading * frame->heading.dot(frame->side);
        frame->side.normalize();
    }
    return frame;
}

Vec3 presentWay(const SurfaceMesh& mesh, const SlitEnd& end, int from, const Vec3& way) {
    DeformationField field(VertexPositions::atRest(mesh), VertexPositions::current(mesh));
    mesh.forEachOutgoing(from, [&](int h) {
        const int t = SurfaceMesh::triangleOf(h);
        if (mesh.wallLabel(t) / 2 != end.label / 2 || mesh.wallLabel(t) < 0) {
            field.add(mesh.triangle(t));
        }
    });
    return field.along(way);
}

double restLength(const SurfaceMesh& mesh, const SlitEnd& end) {
    return (mesh.restPosition(end.vertices.back()) - mesh.restPosition(end.vertices.front()))
        .norm();
}

std::vector<SlitEnd> findSlitEnds(const SurfaceMesh& mesh) {
    std::map<int, int> edges = frontEdges(mesh);
    std::set<int> inside;
    for (const auto& [origin, h] : edges) {
        inside.insert(mesh.target(h));
    }
    std::vector<SlitEnd> ends;
    const auto follow = [&](int start) {
        SlitEnd& end = ends.emplace_back(SlitEnd{{start}, 0});
        std::vector<int>& line = end.vertices;
        for (auto edge = edges.find(start); edge != edges.end(); edge = edges.find(line.back())) {
            end.label = mesh.wallLabel(SurfaceMesh::triangleOf(edge->second));
            line.push_back(mesh.target(edge->second));
            edges.erase(edge);
        }
    };
    const std::map<int, int> all = edges;
    for (const auto& [origin, h] : all) {
        if (!inside.contains(origin)) {
            follow(origin);
        }
    }
    while (!edges.empty()) {
        follow(edges.begin()->first);
    }
    return ends;
}

EndOpening openingOf(const SurfaceMesh& mesh, const CohesiveZone& cohesion, double edge,
                     const SlitEnd& end) {
    EndOpening opening;
    double ofFirst = 1e-300;
    double ofLast = 1e-300;
    const bool even = restLength(mesh, end) < kOneFront * edge;
    for (const auto& [v, place] : pointsBehind(mesh, end, kEdgesInZone * edge)) {
        const int facing = facingVertex(mesh, v, end.label + 1);
        if (facing < 0) {
            continue;
        }
        const Vec3 way = mesh.position(v) - mesh.position(facing);
        const double share = even ? 0.5 : place.share;
        const double open =
            way.norm() / std::max(neededAt(cohesion, edge, v, place.distance), 1e-12);
        opening.atFirst += (1 - share) * place.distance * open;
        opening.atLast += share * place.distance * open;
        ofFirst += (1 - share) * place.distance;
        ofLast += share * place.distance;
        opening.way += way;
    }
    opening.atFirst /= ofFirst;
    opening.atLast /= ofLast;
    return opening;
}

}  // namespace kerf
