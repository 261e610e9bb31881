#include "sim/cut/stroke/cut_body.h"

#include "sim/cut/stroke/ladder.h"

namespace kerf::cut {

namespace {

// A blade is taken for as long as two diagonals of the body to both sides. Walls are at most a
// twelfth of one long, so no shorter blade needs a look at the body.
constexpr double kBladeReach = 2;  // diagonals
constexpr double kLongBlade = 24;  // h
// The way that the end of a stroke cuts although it is below the gate, as a share of the edge
// length around, and how many times the blade's offset it is at least.
constexpr double kLeastFlush = 0.01;
constexpr double kLeastFlushOffsets = 4;

EdgeLengthField edgeLengthsOf(const SurfaceMesh& mesh, const CutSettings& settings) {
    return settings.wallEdgeLength > 0 ? EdgeLengthField(settings.wallEdgeLength)
                                       : EdgeLengthField::ofSkin(mesh);
}

}  // namespace

CutBody::CutBody(SurfaceMesh& ofBody, const CutSettings& howFinely)
    : mesh(ofBody),
      settings(howFinely),
      edgeLengths(std::make_shared<EdgeLengthField>(edgeLengthsOf(mesh, settings))) {}

// Whatever is looked up in the mesh during a step has its row here, and nowhere else. No row reads
// what another one brings up to date. What follows a step as a whole stands in
// sim/run/blade/cut_followers.cpp.
void CutBody::follow(const MeshChange& change) {
    triangles.update(change.triangles);
    pieces.update(change.triangles, change.groupOfNewPieces);
    surface.follow(change.triangles, change.restMotion);
    atRest = atRest &&
             std::ranges::all_of(change.movedVertices, [this](int v) { return liesAtRest(v); });
}

void CutBody::noteMotion() {
    if (!triangles.isStill()) {
        atRest = false;
        pieces.noteMotion();
    }
    triangles.noteMotion();
}

void CutBody::beginStroke() {
    atRest = true;
    for (int v = 0; v < mesh.vertexCount() && atRest; ++v) {
        atRest = liesAtRest(v);
    }
    surface.beginStroke();
}

bool CutBody::liesAtRest(int v) const {
    return mesh.outgoing(v) < 0 || (!mesh.isOld(v) && mesh.position(v) == mesh.restPosition(v) &&
                                    mesh.velocity(v).isZero(0));
}

/// What reaches farther says nothing about the cut, but walls are laid out from end to end: one of
/// 200 km that turned took minutes a step and got twenty times as many vertices.
Blade CutBody::nearBody(const Blade& whole) {
    const Vec3 way = whole.b - whole.a;
    const double length = way.norm();
    if (length <= kLongBlade * h()) {
        return whole;
    }
    const Bounds body = triangles.finder().bounds();
    const double beside = (body.center() - whole.a).dot(way) / length;
    const double from = std::max(beside - kBladeReach * body.diagonal(), 0.0);
    const double to = std::min(beside + kBladeReach * body.diagonal(), length);
    if (from >= to) {
        return whole;
    }
    return {from > 0 ? Vec3(whole.a + way * (from / length)) : whole.a,
            to < length ? Vec3(whole.a + way * (to / length)) : whole.b};
}

/// The median over what the nodes rest in, in steps of half an octave: what was looked up for one
/// length serves for a while. That of the whole body in the air.
double CutBody::edgeLengthAbout(const std::vector<RungNode>& nodes) const {
    std::vector<double> lengths;
    for (const RungNode& node : nodes) {
        if (node.vertex >= 0 && !edgeLengths->isEven()) {
            lengths.push_back(edgeLengths->localEdgeLength(mesh.restPosition(node.vertex)));
        }
    }
    if (lengths.empty()) {
        return h();
    }
    const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
    std::nth_element(lengths.begin(), middle, lengths.end());
    return h() * std::exp2(0.5 * std::round(2 * std::log2(*middle / h())));
}

double CutBody::gateLength(Gate gate, double edge) const {
    return gate == Gate::shareOfEdge
               ? settings.gate * edge
               : std::max(kLeastFlush * edge, kLeastFlushOffsets * settings.offset * h());
}

double CutBody::margin(double edge) const {
    return kBroadPhaseMargin * edge + largestOffsetScale() * settings.offset * h();
}

}  // namespace kerf::cut
