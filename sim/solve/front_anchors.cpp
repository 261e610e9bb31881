#include "sim/solve/front_anchors.h"

#include <Eigen/LU>
#include <algorithm>
#include <optional>

#include "sim/mesh/closest_point.h"

namespace kerf {

namespace {

constexpr double kRidge = 1e-3;  // of the trace, towards the identity
constexpr std::size_t kLeastSamples = 4;
constexpr double kMaxCatchUpSpeed = 1;  // relative to the material [m/s]
constexpr double kSkinReach = 0.8;      // skin nearer than this share of an edge pushes inwards,
constexpr double kKeptDepth = 0.5;      // until this share of the depth at rest is left

struct MaterialPoint {
    Vec3 position;
    Vec3 velocity;
};

double weightAt(const Vec3& offset, double edge) {
    const double square = offset.squaredNorm() + edge * edge;
    return 1 / (square * square);
}

/// Where the material that rests at `rest` is now, by moving least squares over `samples`.
MaterialPoint mapFromRest(const SurfaceMesh& mesh, const std::vector<int>& samples,
                          const Vec3& rest, double edge) {
    double weights = 0;
    Vec3 restMean = Vec3::Zero();
    Vec3 currentMean = Vec3::Zero();
    Vec3 velocityMean = Vec3::Zero();
    for (const int v : samples) {
        const double w = weightAt(mesh.restPosition(v) - rest, edge);
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
    for (const int v : samples) {
        const double w = weightAt(mesh.restPosition(v) - rest, edge);
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

struct SkinPoint {
    int triangle = -1;
    Vec3 weights = Vec3::Zero();
    double distance = 0;
};

Vec3 restPoint(const SurfaceMesh& mesh, const Triangle& t, const Vec3& weights) {
    return weights[0] * mesh.restPosition(t[0]) + weights[1] * mesh.restPosition(t[1]) +
           weights[2] * mesh.restPosition(t[2]);
}

bool nearBox(const SurfaceMesh& mesh, const Triangle& t, const Vec3& point, double reach) {
    const Vec3& a = mesh.restPosition(t[0]);
    const Vec3& b = mesh.restPosition(t[1]);
    const Vec3& c = mesh.restPosition(t[2]);
    const Vec3 low = a.cwiseMin(b).cwiseMin(c);
    const Vec3 high = a.cwiseMax(b).cwiseMax(c);
    return ((low - point).array() <= reach).all() && ((point - high).array() <= reach).all();
}

/// The nearest point of the surface that the piece had before the stroke, around `vertex` at rest,
/// within `reach`.
std::optional<SkinPoint> nearestSkin(const SurfaceMesh& mesh, const BodyModel& model, int vertex,
                                     double reach) {
    const Vec3& rest = mesh.restPosition(vertex);
    const int stroke = mesh.wallLabel(mesh.outgoing(vertex) / 3) / 2;
    std::optional<SkinPoint> nearest;
    for (int t = 0; t < mesh.triangleSlots(); ++t) {
        const bool ownWall = mesh.kind(t) == SurfaceKind::wall && mesh.wallLabel(t) / 2 == stroke;
        if (!mesh.alive(t) || ownWall) {
            continue;
        }
        const Triangle& corners = mesh.triangle(t);
        if (!nearBox(mesh, corners, rest, reach) ||
            model.pieceOfVertex[corners[0]] != model.pieceOfVertex[vertex] ||
            std::find(corners.begin(), corners.end(), vertex) != corners.end()) {
            continue;
        }
        const Vec3 weights =
            closestWeights(rest, mesh.restPosition(corners[0]), mesh.restPosition(corners[1]),
                           mesh.restPosition(corners[2]));
        const double distance = (restPoint(mesh, corners, weights) - rest).norm();
        if (distance <= reach && (!nearest || distance < nearest->distance)) {
            nearest = SkinPoint{t, weights, distance};
        }
    }
    return nearest;
}

/// `position`, pushed in where it comes too close to the skin or leaves it.
Vec3 keptInside(const SurfaceMesh& mesh, const BodyModel& model, int vertex, const Vec3& position) {
    const auto skin = nearestSkin(mesh, model, vertex, kSkinReach * model.edgeLength);
    if (!skin) {
        return position;
    }
    const Triangle& t = mesh.triangle(skin->triangle);
    const Vec3& a = mesh.position(t[0]);
    const Vec3 normal = (mesh.position(t[1]) - a).cross(mesh.position(t[2]) - a).stableNormalized();
    const Vec3 onSkin = skin->weights[0] * a + skin->weights[1] * mesh.position(t[1]) +
                        skin->weights[2] * mesh.position(t[2]);
    const double excess = normal.dot(position - onSkin) + kKeptDepth * skin->distance;
    return excess > 0 ? Vec3(position - excess * normal) : position;
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

std::vector<int> skinOfPiece(const SurfaceMesh& mesh, const BodyModel& model, int piece,
                             int skinVertices) {
    std::vector<int> out;
    for (int v = 0; v < std::min(skinVertices, mesh.vertexCount()); ++v) {
        if (model.pieceOfVertex[v] == piece) {
            out.push_back(v);
        }
    }
    return out;
}

Vec3 limited(const Vec3& velocity, const Vec3& material) {
    const Vec3 relative = velocity - material;
    const double speed = relative.norm();
    return speed > kMaxCatchUpSpeed ? Vec3(material + relative * (kMaxCatchUpSpeed / speed))
                                    : velocity;
}

}  // namespace

std::vector<Anchor> findFrontAnchors(const SurfaceMesh& mesh, const BodyModel& model,
                                     const std::vector<RungNode>& rung, int skinVertices,
                                     double timeStep) {
    std::vector<Anchor> anchors;
    int piece = -1;
    std::vector<int> samples;
    for (const int v : innerFrontVertices(mesh, rung)) {
        if (model.pieceOfVertex[v] != piece) {
            piece = model.pieceOfVertex[v];
            samples = skinOfPiece(mesh, model, piece, skinVertices);
        }
        if (samples.size() < kLeastSamples) {
            continue;
        }
        const MaterialPoint now =
            mapFromRest(mesh, samples, mesh.restPosition(v), model.edgeLength);
        const Vec3 target = keptInside(mesh, model, v, now.position + timeStep * now.velocity);
        anchors.push_back({v, limited((target - mesh.position(v)) / timeStep, now.velocity)});
    }
    return anchors;
}

}  // namespace kerf
