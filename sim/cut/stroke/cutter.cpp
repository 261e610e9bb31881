#include "sim/cut/stroke/cutter.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "sim/base/sort_unique.h"
#include "sim/cut/cut_change.h"
#include "sim/cut/stroke/cutter_state.h"
#include "sim/cut/stroke/ladder.h"
#include "sim/cut/stroke/step_result.h"
#include "sim/cut/surface/piece_groups.h"

namespace kerf {

using cut::GroupStroke;

namespace {

// Boxes of a step's searches may be turned against the box that was prefetched, and lie aside of
// it.
constexpr double kRoomForReach = 1.6;
// A blade is taken for as long as two diagonals of the body to both sides. Walls are at most a
// twelfth of one long, so no shorter blade needs a look at the body.
constexpr double kBladeReach = 2;  // diagonals
constexpr double kLongBlade = 24;  // h
// Keeps transits apart from those of strokes that an earlier cutter made.
constexpr int kTransitsPerStroke = 1000;

cut::EdgeLengthField edgeLengthsOf(const SurfaceMesh& mesh, const CutSettings& settings) {
    return settings.wallEdgeLength > 0 ? cut::EdgeLengthField(settings.wallEdgeLength)
                                       : cut::EdgeLengthField::ofSkin(mesh);
}

int strokesSoFar(const SurfaceMesh& mesh) {
    int last = -1;
    for (int t = 0; t < mesh.triangleSlots(); ++t) {
        last = std::max(last, mesh.wallLabel(t));
    }
    return last < 0 ? 0 : last / 2 + 1;
}

/// Of a body that was cut before, the volumes were carried through the cuts: equal to those summed
/// anew but for the rounding of sums.
double sumOfRestVolumes(const PieceLabels& measured) {
    double sum = 0;
    for (const PieceContent& piece : measured.pieces()) {
        sum += std::fabs(piece.restVolume);
    }
    return sum;
}

}  // namespace

void Cutter::State::start(const Blade& at) {
    blade = at;
    inStroke = true;
    stroke += madeWalls;  // a stroke that only met air leaves its number to the next
    madeWalls = false;
    firstTriangle = mesh.triangleSlots();
    atRest = true;
    for (int v = 0; v < mesh.vertexCount() && atRest; ++v) {
        atRest = liesAtRest(v);
    }
    surface.beginStroke();
    cleanup.reset();
    groups.clear();
    groupOfPiece = cut::groupPieces(mesh, pieces, kParted * h, {});
    groupsHold = true;
    pieces.measureVolumes(mesh);
    restVolume = sumOfRestVolumes(pieces);
    mesh.setOpenStroke(settings.openCut ? stroke : -1);
    for (const int v : lowestVertices({groupOfPiece.begin(), groupOfPiece.end()})) {
        GroupStroke& group = groups.emplace_back();
        group.vertex = v;
        group.number = groupOfVertex(v);
        placeRung(at, group);
    }
    joinRungs();
}

bool Cutter::State::liesAtRest(int v) const {
    return mesh.outgoing(v) < 0 || (!mesh.isOld(v) && mesh.position(v) == mesh.restPosition(v) &&
                                    mesh.velocity(v).isZero(0));
}

void Cutter::State::noteMotion() {
    const std::optional<double> most = std::exchange(moved, std::nullopt);
    const bool still = most == 0;
    for (GroupStroke& group : groups) {
        if (!still) {
            makeWaitingTies(group);
        }
    }
    atRest = atRest && still;
    groupsHold = groupsHold && still;
    if (!tree) {
        return;
    }
    if (most) {
        tree->moved(*most);
    } else {
        tree->movedAnyhow();
    }
}

TriangleFinder& Cutter::State::findTriangles() {
    if (finder != nullptr) {
        return *finder;
    }
    if (!tree) {
        tree.emplace(mesh);
    }
    return *tree;
}

double Cutter::State::margin(double edge) const {
    return kBroadPhaseMargin * edge + cut::largestOffsetScale() * settings.offset * h;
}

double Cutter::State::gateLength(Gate gate, double edge) const {
    return gate == Gate::shareOfEdge
               ? settings.gate * edge
               : std::max(kLeastFlush * edge, kLeastFlushOffsets * settings.offset * h);
}

/// The median over what the nodes rest in, in steps of half an octave: what was looked up for one
/// length serves for a while. That of the whole body in the air.
double Cutter::State::edgeLengthAbout(const std::vector<RungNode>& nodes) const {
    std::vector<double> lengths;
    for (const RungNode& node : nodes) {
        if (node.vertex >= 0 && !edgeLengths->isEven()) {
            lengths.push_back(edgeLengths->localEdgeLength(mesh.restPosition(node.vertex)));
        }
    }
    if (lengths.empty()) {
        return h;
    }
    const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
    std::nth_element(lengths.begin(), middle, lengths.end());
    return h * std::exp2(0.5 * std::round(2 * std::log2(*middle / h)));
}

/// After each change of the mesh, before anything is looked up in it. `changed`: each once. Pieces
/// that come off stay in the group until they part.
void Cutter::State::follow(const std::vector<int>& changed, int groupOfNewPieces) {
    if (finder != nullptr || tree) {
        findTriangles().update(changed);
    }
    groupsHold = false;
    const std::vector<int> source = pieces.update(mesh, changed).source;
    const std::vector<int> before = std::exchange(groupOfPiece, {});
    for (const int piece : source) {
        groupOfPiece.push_back(piece < 0 ? groupOfNewPieces : before[piece]);
    }
}

/// What reaches farther says nothing about the cut, but walls are laid out from end to end: one of
/// 200 km that turned took minutes a step and got twenty times as many vertices.
Blade Cutter::State::nearBody(const Blade& whole) {
    const Vec3 way = whole.b - whole.a;
    const double length = way.norm();
    if (length <= kLongBlade * h) {
        return whole;
    }
    const Bounds body = findTriangles().bounds();
    const double beside = (body.center() - whole.a).dot(way) / length;
    const double from = std::max(beside - kBladeReach * body.diagonal(), 0.0);
    const double to = std::min(beside + kBladeReach * body.diagonal(), length);
    if (from >= to) {
        return whole;
    }
    return {from > 0 ? Vec3(whole.a + way * (from / length)) : whole.a,
            to < length ? Vec3(whole.a + way * (to / length)) : whole.b};
}

CutResult Cutter::State::advanceAll(const Blade& to, Gate gate) {
    if ((to.b - to.a).norm() <= kStandingStill * h) {
        return outcome(CutOutcome::waiting);
    }
    for (GroupStroke& group : groups) {
        cut::followMesh(mesh, group.rung);
        group.airTies.follow(mesh, group.rung);
    }
    divideGroups();
    CutResult sum;
    for (GroupStroke& group : groups) {
        addTo(sum, advance(to, gate, group));
    }
    joinRungs();
    if (sum.outcome == CutOutcome::cut) {
        cleanUpBehindFront(sum);
        tieRungs();
    }
    return sum;
}

Cutter::Cutter(SurfaceMesh& mesh, const CutSettings& settings)
    : state_(std::make_unique<State>(State{
          mesh, settings, std::make_shared<cut::EdgeLengthField>(edgeLengthsOf(mesh, settings))})) {
    state_->stroke = strokesSoFar(mesh);
    state_->transit = kTransitsPerStroke * state_->stroke;
}

Cutter::~Cutter() = default;
Cutter::Cutter(Cutter&&) noexcept = default;
Cutter::Cutter(const Cutter& other) : state_(std::make_unique<State>(*other.state_)) {}
Cutter& Cutter::operator=(Cutter&&) noexcept = default;

void Cutter::begin(const Blade& blade) {
    state_->noteMotion();
    state_->start(state_->nearBody(blade));
}

CutResult Cutter::advance(const Blade& blade) {
    assert(state_->inStroke);
    state_->noteMotion();
    state_->blade = state_->nearBody(blade);
    return state_->advanceAll(state_->blade, Gate::shareOfEdge);
}

CutResult Cutter::finish() {
    State& state = *state_;
    assert(state.inStroke);
    state.noteMotion();
    CutResult result = state.advanceAll(state.blade, Gate::flush);
    state.inStroke = false;
    state.groups.clear();
    state.rung.clear();
    if (result.outcome != CutOutcome::cut) {
        result.delta.firstNewVertex = state.mesh.vertexCount();
    }
    state.cleanUpAtEnd(result);
    state.closeWounds(result);
    state.removeDebris(result);
    return result;
}

CutDelta Cutter::mend(const std::vector<int>& triangles) {
    assert(!state_->inStroke);
    state_->noteMotion();
    CutDelta delta;
    delta.firstNewVertex = state_->mesh.vertexCount();
    if (state_->settings.cleanUp) {
        state_->mend(triangles, delta);
    }
    return delta;
}

void Cutter::prepare() {
    state_->surface.prepare();
    state_->pieces.measureVolumes(state_->mesh);
}

void Cutter::useFinder(TriangleFinder* finder) {
    for (GroupStroke& group : state_->groups) {
        state_->makeWaitingTies(group);
    }
    state_->finder = finder;
    state_->tree.reset();
}

void Cutter::boundMotion(double distance) {
    state_->moved = state_->moved.value_or(0) + distance;
}

void Cutter::setWallCoarsening(double factor) {
    state_->settings.wallCoarsening = factor;
}

void Cutter::setDebrisVolume(double share) {
    state_->settings.debrisVolume = share;
}

void Cutter::setOpenCut(bool open) {
    state_->settings.openCut = open;
}

void Cutter::setSearch(CutSearch search) {
    state_->settings.search = search;
}

SearchWork Cutter::takeSearchWork() {
    return std::exchange(state_->searchWork, {});
}

bool Cutter::inStroke() const {
    return state_->inStroke;
}
OrientedBox Cutter::reach(std::span<const Blade> path, double time) const {
    std::vector<Vec3> points;
    const SurfaceMesh& mesh = state_->mesh;
    double edge = state_->h;
    for (const GroupStroke& group : state_->groups) {
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
    box.widen(kRoomForReach * state_->margin(edge));
    return box;
}

std::vector<int> Cutter::followedVertices() const {
    std::vector<int> vertices;
    for (const GroupStroke& group : state_->groups) {
        group.airTies.addVertices(vertices);
        for (const RungNode& node : group.rung) {
            if (node.vertex >= 0) {
                vertices.push_back(node.vertex);
            }
        }
    }
    state_->surface.addVertices(vertices);
    sortUnique(vertices);
    return vertices;
}

const cut::StrokeSurface& Cutter::strokeSurface() const {
    return state_->surface;
}
double Cutter::edgeLengthAtFront() const {
    return state_->edgeLengthAbout(state_->rung);
}
const std::vector<RungNode>& Cutter::rung() const {
    return state_->rung;
}

}  // namespace kerf
