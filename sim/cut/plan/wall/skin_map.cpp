#include "sim/cut/plan/wall/skin_map.h"

#include <Eigen/Dense>

namespace kerf::cut {

namespace {

constexpr double kRidge = 1e-3;
// Fewer samples do not determine an affine map.
constexpr int kLeastSamples = 4;

struct Sample {
    double weight;
    Vec3 position;
    Vec3 offset;  ///< rest - position: the identity is its zero
    Vec3 velocity;
};

/// Calls visit(node) for each corner of the sheets on the surface or on the old front.
template <class Visit>
void forEachRimNode(const std::vector<WallSheet>& sheets, const std::vector<CutNode>& nodes,
                    Visit&& visit) {
    for (const WallSheet& sheet : sheets) {
        for (const Triangle& t : sheet.triangles) {
            for (const int id : t) {
                if (nodes[id].kind != NodeKind::wall) {
                    visit(nodes[id]);
                }
            }
        }
    }
}

std::vector<SurfaceSample> samplesAround(const StepInput& in, const std::vector<WallSheet>& sheets,
                                         const std::vector<CutNode>& nodes) {
    std::vector<Vec3> places;
    forEachRimNode(sheets, nodes, [&](const CutNode& node) { places.push_back(node.rest); });
    if (places.empty()) {  // a cut that begins inside: nothing says yet where that rests
        places.push_back(nodes[sheets.front().triangles.front()[0]].position);
    }
    return in.surface.samplesAround(std::move(places), in.h);
}

std::vector<Sample> samplesOf(const StepInput& in, const std::vector<SurfaceSample>& all,
                              int piece) {
    std::vector<Sample> samples;
    samples.reserve(all.size());
    forEachOfPiece(all, in.pieceOfVertex, piece, [&](const SurfaceSample& sample) {
        const int v = sample.vertex;
        const Vec3& position = in.mesh.position(v);
        samples.push_back(
            {sample.weight, position, in.mesh.restPosition(v) - position, in.mesh.velocity(v)});
    });
    return samples;
}

// For chips without any skin vertex of their own.
std::vector<Sample> rimSamples(const WallSheet& sheet, const std::vector<CutNode>& nodes) {
    std::vector<Sample> samples;
    forEachRimNode({sheet}, nodes, [&](const CutNode& node) {
        samples.push_back({1, node.position, node.rest - node.position, node.velocity});
    });
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
        const double w = sample.weight / (distance * distance);
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

void mapNode(const std::vector<Sample>& samples, double h, CutNode& node) {
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

void keepNode(CutNode& node) {
    node.rest = node.position;
    node.velocity = Vec3::Zero();
}

}  // namespace

std::vector<CutNode> mapFromSkin(const StepInput& in, const std::vector<WallSheet>& sheets,
                                 std::vector<CutNode> nodes) {
    if (in.atRest) {
        for (CutNode& node : nodes) {
            if (node.kind == NodeKind::wall) {
                keepNode(node);
            }
        }
        return nodes;
    }
    const std::vector<SurfaceSample> all = samplesAround(in, sheets, nodes);
    std::vector<bool> mapped(nodes.size(), false);
    for (const WallSheet& sheet : sheets) {
        std::vector<Sample> samples = samplesOf(in, all, sheet.piece);
        if (sizeOf(samples) < kLeastSamples) {
            samples = rimSamples(sheet, nodes);
        }
        const bool atRest = areAtRest(samples);
        for (const Triangle& t : sheet.triangles) {
            for (const int id : t) {
                CutNode& node = nodes[id];
                if (node.kind == NodeKind::wall && !mapped[id]) {
                    atRest ? keepNode(node) : mapNode(samples, in.h, node);
                    mapped[id] = true;
                }
            }
        }
    }
    return nodes;
}

}  // namespace kerf::cut
