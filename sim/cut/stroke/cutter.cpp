#include "sim/cut/stroke/cutter.h"

#include <cassert>

#include "sim/base/containers.h"
#include "sim/cut/stroke/cut_body.h"
#include "sim/cut/stroke/stroke.h"
#include "sim/cut/surface/broad_phase.h"

namespace kerf {

using cut::GroupStroke;

namespace {

// Boxes of a step's searches may be turned against the box that was prefetched, and lie aside of
// it.
constexpr double kRoomForReach = 1.6;
// Keeps transits apart from those of strokes that an earlier cutter made.
constexpr int kTransitsPerStroke = 1000;

int strokesSoFar(const SurfaceMesh& mesh) {
    int last = -1;
    for (int t = 0; t < mesh.triangleSlots(); ++t) {
        last = std::max(last, mesh.wallLabel(t));
    }
    return last < 0 ? 0 : last / 2 + 1;
}

}  // namespace

struct Cutter::State {
    cut::CutBody body;
    cut::Stroke stroke{};

    template <class Archive>
    void archive(Archive& io) {
        io(body.pieces, body.surface, stroke.number, stroke.transit, stroke.unused);
    }
    /// Takes note of what the solver moved since the last call.
    void noteMotion() {
        if (!body.triangles.isStill()) {
            stroke.makeWaitingTies(body);
        }
        body.noteMotion();
    }
};

Cutter::Cutter(SurfaceMesh& mesh, const CutSettings& settings)
    : state_(std::make_unique<State>(State{cut::CutBody(mesh, settings)})) {
    state_->stroke.number = state_->stroke.unused = strokesSoFar(mesh);
    state_->stroke.transit = kTransitsPerStroke * state_->stroke.number;
}

Cutter::~Cutter() = default;
Cutter::Cutter(Cutter&&) noexcept = default;
Cutter::Cutter(const Cutter& other) : state_(std::make_unique<State>(*other.state_)) {}
Cutter& Cutter::operator=(Cutter&&) noexcept = default;

void Cutter::write(ByteWriter& to) const {
    assert(!inStroke());
    state_->archive(to);
}

Cutter::Cutter(const Cutter& uncut, ByteReader& from)
    : state_(std::make_unique<State>(
          State{cut::CutBody(uncut.state_->body.mesh, uncut.state_->body.settings)})) {
    state_->body.edgeLengths = uncut.state_->body.edgeLengths;
    state_->archive(from);
}

void Cutter::begin(const Blade& blade) {
    state_->noteMotion();
    state_->stroke.begin(state_->body, state_->body.nearBody(blade));
}

void Cutter::goOnFrom(const SlitFront& front, const Blade& blade) {
    state_->noteMotion();
    state_->stroke.goOnFrom(state_->body, front, blade);
}

CutResult Cutter::advance(const Blade& blade) {
    assert(inStroke());
    state_->noteMotion();
    state_->stroke.blade = state_->body.nearBody(blade);
    return state_->stroke.advance(state_->body, cut::Gate::shareOfEdge);
}

CutResult Cutter::finish() {
    assert(inStroke());
    state_->noteMotion();
    return state_->stroke.finish(state_->body);
}

CutDelta Cutter::mend(const std::vector<int>& triangles) {
    assert(!inStroke());
    state_->noteMotion();
    return cut::mend(state_->body, triangles);
}

CutDelta Cutter::removePieceAt(int vertex) {
    assert(!inStroke());
    state_->noteMotion();
    return cut::removePiece(state_->body, state_->body.pieces.labels().ofVertex()[vertex]);
}

void Cutter::prepare() {
    state_->body.surface.prepare();
    state_->body.pieces.measureVolumes();
}

void Cutter::useFinder(TriangleFinder* finder) {
    state_->stroke.makeWaitingTies(state_->body);
    state_->body.triangles.use(finder);
}

void Cutter::boundMotion(double distance) {
    state_->body.triangles.boundMotion(distance);
}

CutSettings& Cutter::settings() {
    return state_->body.settings;
}

SearchWork Cutter::takeSearchWork() {
    return std::exchange(state_->body.searchWork, {});
}

bool Cutter::inStroke() const {
    return state_->stroke.goesOn;
}
int Cutter::strokeNumber() const {
    return state_->stroke.number;
}
OrientedBox Cutter::reach(std::span<const Blade> path, double time) const {
    std::vector<Vec3> points;
    const SurfaceMesh& mesh = state_->body.mesh;
    double edge = state_->body.h();
    for (const GroupStroke& group : state_->stroke.groups) {
        edge = std::max(edge, group.edgeLength);
        std::vector<RungNode> rung = group.rung;
        cut::followMesh(mesh, rung);
        group.airTies.follow(mesh, rung);
        for (const RungNode& node : rung) {
            const bool moves = node.vertex >= 0;
            points.push_back(moves ? Vec3(node.position + time * mesh.velocity(node.vertex))
                                   : node.position);
        }
    }
    for (const Blade& blade : path) {
        points.insert(points.end(), {blade.a, blade.b});
    }
    OrientedBox box = orientedBoxAlong(cut::sweptAxes(path.back(), points), points);
    box.widen(kRoomForReach * state_->body.margin(edge));
    return box;
}

bool Cutter::hasCut() const {
    return inStroke() && state_->stroke.cleanup.has_value();
}

std::vector<int> Cutter::followedVertices() const {
    std::vector<int> vertices;
    const auto lives = [this](int v) { return state_->body.mesh.outgoing(v) >= 0; };
    for (const GroupStroke& group : state_->stroke.groups) {
        group.airTies.addVertices(vertices);
        std::ranges::copy_if(group.past.startVertices(), std::back_inserter(vertices), lives);
        for (const RungNode& node : group.rung) {
            if (node.vertex >= 0) {
                vertices.push_back(node.vertex);
            }
        }
    }
    state_->body.surface.addVertices(vertices);
    if (const std::optional<cut::Cleanup>& cleanup = state_->stroke.cleanup) {
        cleanup->addVertices(vertices);
    }
    sortUnique(vertices);
    return vertices;
}

const cut::StrokeSurface& Cutter::strokeSurface() const {
    return state_->body.surface;
}
double Cutter::edgeLengthAtFront() const {
    return state_->body.edgeLengthAbout(state_->stroke.rung);
}
double Cutter::gateAtFront() const {
    double growth = 1;
    for (const GroupStroke& group : state_->stroke.groups) {
        growth = std::max(growth, cut::rowGrowth(state_->body.settings, group));
    }
    return state_->body.settings.gate * growth;
}
const std::vector<RungNode>& Cutter::rung() const {
    return state_->stroke.rung;
}

}  // namespace kerf
