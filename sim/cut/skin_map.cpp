#include "sim/cut/skin_map.h"

#include <Eigen/Dense>
#include <algorithm>

namespace kerf::cut {

namespace {

constexpr double kRidge = 1e-3;
// Fewer samples do not determine an affine map.
constexpr int kLeastSamples = 4;
constexpr int kMostSamples = 2000;

struct Sample {
    Vec3 position;
    Vec3 offset;  ///< rest - position: the identity is its zero
    Vec3 velocity;
};

std::vector<Sample> skinSamples(const StepInput& in, int piece) {
    std::vector<Sample> samples;
    for (const int v : in.samples) {
        if (in.pieceOfVertex[v] == piece) {
            const Vec3& position = in.mesh.position(v);
            samples.push_back({position, in.mesh.restPosition(v) - position, in.mesh.velocity(v)});
        }
    }
    return samples;
}

// For chips without any skin vertex of their own.
std::vector<Sample> rimSamples(const WallSheet& sheet, const std::vector<Node>& nodes) {
    std::vector<Sample> samples;
    for (const Triangle& t : sheet.triangles) {
        for (const int id : t) {
            const Node& node = nodes[id];
            if (node.kind != NodeKind::wall) {
                samples.push_back({node.position, node.rest - node.position, node.velocity});
            }
        }
    }
    return samples;
}

/// Weighted sums about the node.
struct Moments {
    double weight = 0;
    Vec3 position = Vec3::Zero();
    Vec3 offset = Vec3::Zero();
    Vec3 velocity = Vec3::Zero();
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    Eigen::Matrix3d offsetByPosition = Eigen::Matrix3d::Zero();
    Eigen::Matrix3d velocityByPosition = Eigen::Matrix3d::Zero();
};

Moments momentsAbout(const Vec3& center, const std::vector<Sample>& samples, double h) {
    Moments m;
    for (const Sample& sample : samples) {
        const Vec3 q = sample.position - center;
        const double distance = q.squaredNorm() + h * h;
        const double w = 1 / (distance * distance);
        const Vec3 wq = w * q;
        m.weight += w;
        m.position += wq;
        m.offset += w * sample.offset;
        m.velocity += w * sample.velocity;
        m.spread += wq * q.transpose();
        m.offsetByPosition += sample.offset * wq.transpose();
        m.velocityByPosition += sample.velocity * wq.transpose();
    }
    return m;
}

/// The body lies still in its rest shape: every map fitted to it is the identity.
bool areAtRest(const std::vector<Sample>& samples) {
    return std::ranges::all_of(
        samples, [](const Sample& s) { return s.offset.isZero(0) && s.velocity.isZero(0); });
}

void mapNode(const std::vector<Sample>& samples, double h, Node& node) {
    const Moments m = momentsAbout(node.position, samples, h);
    const Vec3 center = m.position / m.weight;
    const Vec3 offset = m.offset / m.weight;
    const Vec3 velocity = m.velocity / m.weight;
    Eigen::Matrix3d spread = m.spread - m.position * center.transpose();
    spread.diagonal().array() += kRidge * spread.trace() + 1e-30;
    const Vec3 lever = spread.ldlt().solve(-center);
    node.rest =
        node.position + offset + (m.offsetByPosition - m.offset * center.transpose()) * lever;
    node.velocity = velocity + (m.velocityByPosition - m.velocity * center.transpose()) * lever;
}

void keepNode(Node& node) {
    node.rest = node.position;
    node.velocity = Vec3::Zero();
}

}  // namespace

std::vector<int> thinByPiece(const std::vector<int>& vertices,
                             const std::vector<int>& pieceOfVertex) {
    std::vector<std::vector<int>> byPiece;
    for (const int v : vertices) {
        const int piece = pieceOfVertex[v];
        if (piece >= sizeOf(byPiece)) {
            byPiece.resize(piece + 1);
        }
        if (piece >= 0) {
            byPiece[piece].push_back(v);
        }
    }
    std::vector<int> thinned;
    for (const std::vector<int>& ofPiece : byPiece) {
        const int stride = 1 + (sizeOf(ofPiece) - 1) / kMostSamples;
        for (int i = 0; i < sizeOf(ofPiece); i += stride) {
            thinned.push_back(ofPiece[i]);
        }
    }
    return thinned;
}

void mapFromSkin(const StepInput& in, const std::vector<WallSheet>& sheets, CutCurves& curves) {
    std::vector<bool> mapped(curves.nodes.size(), false);
    for (const WallSheet& sheet : sheets) {
        std::vector<Sample> samples = skinSamples(in, sheet.piece);
        if (sizeOf(samples) < kLeastSamples) {
            samples = rimSamples(sheet, curves.nodes);
        }
        const bool atRest = areAtRest(samples);
        for (const Triangle& t : sheet.triangles) {
            for (const int id : t) {
                Node& node = curves.nodes[id];
                if (node.kind == NodeKind::wall && !mapped[id]) {
                    atRest ? keepNode(node) : mapNode(samples, in.h, node);
                    mapped[id] = true;
                }
            }
        }
    }
}

}  // namespace kerf::cut
