#include "sim/solve/front_anchors.h"

#include <Eigen/LU>
#include <tuple>

#include "sim/base/containers.h"

namespace kerf {

namespace {

constexpr double kRidge = 1e-3;  // of the trace, towards the identity
constexpr std::size_t kLeastSamples = 4;
constexpr double kSkinReach = 0.8;  // skin nearer than this share of an edge pushes inwards

struct MaterialPoint {
    Vec3 position = Vec3::Zero();
    Vec3 velocity = Vec3::Zero();
};

double weightAt(const Vec3& offset, double edge) {
    const double square = offset.squaredNorm() + edge * edge;
    return 1 / (square * square);
}

/// Where the material that rests at `rest` is now, by moving least squares over `samples`.
MaterialPoint mapFromRest(const SurfaceMesh& mesh, const std::vector<cut::SurfaceSample>& samples,
                          const Vec3& rest, double edge) {
    double weights = 0;
    Vec3 restMean = Vec3::Zero();
    Vec3 currentMean = Vec3::Zero();
    Vec3 velocityMean = Vec3::Zero();
    for (const auto& [v, count] : samples) {
        const double w = count * weightAt(mesh.restPosition(v) - rest, edge);
        weights += w;
        restMean += w * mesh.restPosition(v);
        currentMean += w * mesh.position(v);
        velocityMean += w * mesh.velocity(v);
    }
    restMean /= weights;
    currentMean /= weights;
    velocityMean /= weights;

    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    Eigen::Matrix3d displacement = Eigen::Matrix3d::Zero();
    Eigen::Matrix3d velocity = Eigen::Matrix3d::Zero();
    for (const auto& [v, count] : samples) {
        const double w = count * weightAt(mesh.restPosition(v) - rest, edge);
        const Vec3 a = mesh.restPosition(v) - restMean;
        const Vec3 moved = mesh.position(v) - currentMean - a;
        const Vec3 speed = mesh.velocity(v) - velocityMean;
        spread += w * a * a.transpose();
        displacement += w * moved * a.transpose();
        velocity += w * speed * a.transpose();
    }
    spread += kRidge * spread.trace() * Eigen::Matrix3d::Identity();
    const Vec3 offset = rest - restMean;
    const Vec3 solved = spread.inverse() * offset;
    return {currentMean + offset + displacement * solved, velocityMean + velocity * solved};
}

/// Where the blade's tip stands in the material the front ends inside, on walls of its stroke
/// alone.
bool liesInside(const SurfaceMesh& mesh, int v) {
    bool inside = true;
    const int stroke = mesh.wallLabel(mesh.outgoing(v) / 3) / 2;
    mesh.forEachOutgoing(v, [&](int h) {
        inside &= mesh.kind(h / 3) == SurfaceKind::wall && mesh.wallLabel(h / 3) / 2 == stroke;
    });
    return inside;
}

/// Front vertices with uncut material around them.
std::vector<int> innerFrontVertices(const SurfaceMesh& mesh, const std::vector<RungNode>& rung) {
    std::vector<int> out;
    for (std::size_t i = 0; i < rung.size(); ++i) {
        const bool attached = rung[i].attached || (i > 0 && rung[i - 1].attached);
        if (rung[i].vertex >= 0 && attached && liesInside(mesh, rung[i].vertex)) {
            out.push_back(rung[i].vertex);
        }
    }
    return out;
}

std::vector<cut::SurfaceSample> samplesAround(const SurfaceMesh& mesh,
                                              const cut::StrokeSurface& surface,
                                              const std::vector<int>& front, double edge) {
    return surface.samplesAround(mapped(front, [&](int v) { return mesh.restPosition(v); }), edge);
}

Vec3 limited(const Vec3& velocity, const Vec3& material, double most) {
    const Vec3 relative = velocity - material;
    const double speed = relative.norm();
    return speed > most ? Vec3(material + relative * (most / speed)) : velocity;
}

/// By piece, then copies of one vertex together.
std::vector<int> inOrderOfPieces(std::vector<int> vertices, const SurfaceMesh& mesh,
                                 const std::vector<int>& pieceOfVertex) {
    std::ranges::sort(vertices, {},
                      [&](int v) { return std::tuple(pieceOfVertex[v], mesh.firstCopy(v), v); });
    return vertices;
}

/// Velocities that carry vertices along with their pieces; those of one piece must stand together.
std::vector<Anchor> anchorsOf(const std::vector<int>& vertices, const AnchorFrame& in) {
    std::vector<Anchor> anchors;
    if (vertices.empty()) {
        return anchors;
    }
    const auto all = samplesAround(in.mesh, in.surface, vertices, in.edgeLength);
    int piece = -1;
    int point = -1;
    std::vector<cut::SurfaceSample> samples;
    MaterialPoint now;
    for (const int v : vertices) {
        const bool ofSamePiece = in.pieceOfVertex[v] == piece;
        if (!ofSamePiece) {
            piece = in.pieceOfVertex[v];
            samples.clear();
            cut::forEachOfPiece(all, in.pieceOfVertex, piece,
                                [&](const auto& sample) { samples.push_back(sample); });
        }
        if (samples.size() < kLeastSamples) {
            continue;
        }
        const Vec3& rest = in.mesh.restPosition(v);
        if (!ofSamePiece || in.mesh.firstCopy(v) != point) {
            point = in.mesh.firstCopy(v);
            now = mapFromRest(in.mesh, samples, rest, in.edgeLength);
        }
        const Vec3 free = now.position + in.timeStep * now.velocity;
        const Vec3 target =
            in.surface.insidePosition(rest, free, kSkinReach * in.edgeLength).value_or(free);
        anchors.push_back({v, limited((target - in.mesh.position(v)) / in.timeStep, now.velocity,
                                      in.catchUpSpeed)});
    }
    return anchors;
}

}  // namespace

std::vector<Anchor> findFrontAnchors(const std::vector<RungNode>& rung, const AnchorFrame& in) {
    return anchorsOf(innerFrontVertices(in.mesh, rung), in);
}

std::vector<Anchor> findHiddenAnchors(const std::vector<int>& hidden, const AnchorFrame& in) {
    return anchorsOf(inOrderOfPieces(hidden, in.mesh, in.pieceOfVertex), in);
}

}  // namespace kerf
