#include "sim/run/tear/tear.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "sim/base/sort_unique.h"
#include "sim/mesh/ray_box.h"
#include "sim/mesh/triangle.h"
#include "sim/run/blade/cut_followers.h"
#include "sim/run/parts/led_blade.h"

namespace kerf {

namespace {

// Openings one edge behind an end at which it advances, of the law's reach: where walls are bonded,
// and where they are free, as linear elasticity has it at a quarter of the toughness; there a reach
// of more edges than kLongestReach counts as so many, as soft bodies blunt the end.
constexpr double kBondedOpening = 0.15;
constexpr double kFreeOpening = 0.4;
constexpr double kLongestReach = 0.6;
constexpr double kLeastOfReach = 0.05;
// Edges of walls.
constexpr double kNotchDepth = 0.8;
constexpr double kNotchAbove = 0.3;
constexpr double kLooksBack = 1.6;  // where the openings are taken
constexpr double kOneFront = 3;     // an end up to so long advances evenly
constexpr double kOverhang = 0.7;   // the blade stands out of the skin
constexpr double kLeastEnd = 0.5;   // of a length that advances
constexpr double kNearEnds = 3;     // no place near an end is a weak spot
// Of the heading by slip alone, over 1 less half its share of the displacements [rad]: 140 degrees.
constexpr double kTurn = 2.44;
constexpr double kTwist = 0.5;       // of mode III against mode I, at Poisson's ratio 0.5
constexpr double kFollows = 0.5;     // of an opening that advances, where one end follows the other
constexpr int kPause = 10;           // steps without an advance until another slit may tear
constexpr double kNearlyOpen = 0.7;  // of what makes an end advance: the skin bears no more
constexpr int kPatience = 400;       // steps without an advance until a tear has ended
constexpr int kMostFailures = 3;     // in a row
constexpr int kLooksForSpots = 5;    // steps
constexpr int kRestAfterNotch = 20;  // steps, in which it relieves the skin
constexpr int kRest = 100;           // steps until what failed is tried again

/// The angle by which the end of a slit turns towards W+ in an edge, whose walls opened and slid by
/// `way`: Richard, Fulland and Sander (2005), with stress intensities in proportion to the
/// displacements. It takes the length of the cohesive zone, within which no kink is resolved.
double turnOf(const EndFrame& frame, const Vec3& way) {
    const double slid = way.dot(frame.heading);
    const double twisted = kTwist * std::abs(way.dot(frame.along));
    const double sum = std::max(way.dot(frame.side), 0.0) + std::abs(slid) + twisted;
    const double share = sum > 0 ? std::abs(slid) / sum : 0;
    const double turn = (kTurn - 0.5 * kTurn * share) * share;
    return (slid > 0 ? -turn : turn) / kEdgesInZone;
}

double lengthOf(const SurfaceMesh& mesh, const SlitEnd& end) {
    return (mesh.restPosition(end.vertices.back()) - mesh.restPosition(end.vertices.front()))
        .norm();
}

/// How far an end of the blade goes, in edges.
double advanceBy(double opening, double other) {
    const double needed = other > 1 ? kFollows : 1;
    return opening < needed ? 0 : std::min(opening, 1.0);
}

/// How far an end reaches ahead of the line between its first and last vertex [m].
double depthOf(const SurfaceMesh& mesh, const SlitEnd& end, const EndFrame& frame) {
    double most = 0;
    for (const int v : end.vertices) {
        const Vec3 off = mesh.position(v) - mesh.position(end.vertices.front());
        most = std::max(most, off.dot(frame.heading));
    }
    return most;
}

/// At which the skin begins to tear.
double leastStretch(const Params& params) {
    const double flesh = params.tensileStrength / params.youngsModulus;
    return params.skinThickness > 0 ? std::max(flesh, params.skinStrength / params.skinModulus)
                                    : flesh;
}

bool shareVertices(const SlitEnd& end, const std::vector<RungNode>& rung) {
    return std::ranges::any_of(rung, [&](const RungNode& node) {
        return node.vertex >= 0 &&
               std::ranges::find(end.vertices, node.vertex) != end.vertices.end();
    });
}

}  // namespace

bool Tear::isOn() const {
    return input_.params.tearing != 0 && input_.params.toughness > 0 && input_.timeRuns &&
           input_.params.solver != SolverMode::pbd && input_.params.openCut == 0;
}

const std::vector<int>& Tear::watched() {
    watched_.clear();
    body_.memory.cohesion.addVertices(watched_);
    if (isOn()) {
        watchEnds();
    }
    sortUnique(watched_);
    return watched_;
}

void Tear::watchEnds() {
    const SurfaceMesh& mesh = body_.mesh();
    for (const SlitEnd& end : allEnds()) {
        watched_.insert(watched_.end(), end.vertices.begin(), end.vertices.end());
        for (const auto& [v, place] : pointsBehind(mesh, end, kLooksBack * body_.wallEdge)) {
            const int facing = facingVertex(mesh, v, end.label + 1);
            watched_.insert(watched_.end(), {v, std::max(facing, v)});
        }
    }
}

void Tear::step() {
    TearStroke& tear = body_.memory.tear;
    weakenBonds();
    if (!isOn()) {
        endStroke();
        return;
    }
    body_.memory.cohesion.setLaw(tearLaw(input_.params, body_.wallEdge));
    if (!tear.goesOn && standsInMaterial(body_.cutter->rung())) {
        return;  // a blade cuts
    }
    output_.report.tear = TearReport{.stress = stress()};
    const bool advanced =
        goOn() || (tear.idle >= kPause && (beginElsewhere() || beginAtWeakSpot()));
    output_.report.tear->advanced = advanced;
    tear.idle = advanced ? 0 : tear.idle + 1;
    tear.rest = std::max(tear.rest - 1, 0);
    if (advanced || tear.rest == 0) {
        tear.stuck.clear();
    }
    if (tear.idle > kPatience || !standsInMaterial(body_.cutter->rung())) {
        endStroke();  // none of a blade
    }
}

/// Those of earlier tears too, once nothing tears on.
void Tear::weakenBonds() {
    CohesiveZone& cohesion = body_.memory.cohesion;
    const double taken = cohesion.taken();
    cohesion.noteOpenings(body_.mesh());
    output_.report.fractureEnergy += cohesion.taken() - taken;
}

/// Returns whether the tear in progress advances.
bool Tear::goOn() {
    TearStroke& tear = body_.memory.tear;
    for (const SlitEnd& end : presentEnds()) {
        const Opening opening = openingOf(end);
        note(opening);
        if (opening.most() <= 1) {
            continue;
        }
        const bool cuts = advance(end, opening, false) == CutOutcome::cut;
        tear.failures = cuts ? 0 : tear.failures + 1;
        if (tear.failures >= kMostFailures) {
            endStroke();
            noteStuck(end);
        }
        return cuts;
    }
    return false;
}

/// Returns whether the end of another slit does, the one that is opened most.
bool Tear::beginElsewhere() {
    const SlitEnd* found = nullptr;
    Opening most;
    most.atFirst = 1;
    for (const SlitEnd& end : allEnds()) {
        if (!mayBegin(end)) {
            continue;
        }
        const Opening opening = openingOf(end);
        note(opening);
        if (opening.most() > most.most()) {
            most = opening;
            found = &end;
        }
    }
    if (found == nullptr) {
        return false;
    }
    const SlitEnd end = *found;
    const bool cuts = advance(end, most, true) == CutOutcome::cut;
    if (!cuts) {
        endStroke();
        noteStuck(end);
    }
    return cuts;
}

bool Tear::mayBegin(const SlitEnd& end) const {
    const TearStroke& tear = body_.memory.tear;
    return lengthOf(body_.mesh(), end) >= kLeastEnd * body_.wallEdge &&
           std::ranges::find(tear.stuck, end.vertices.front()) == tear.stuck.end() &&
           !(tear.goesOn && shareVertices(end, body_.cutter->rung()));
}

void Tear::noteStuck(const SlitEnd& end) {
    body_.memory.tear.stuck.push_back(end.vertices.front());
    body_.memory.tear.rest = kRest;
}

/// Returns whether the skin is notched where it is stretched most.
bool Tear::beginAtWeakSpot() {
    if (output_.clock.stepsDone % kLooksForSpots != 0 || stress() < 1 ||
        output_.report.tear->opening > kNearlyOpen || body_.memory.tear.rest > 0) {
        return false;
    }
    body_.mesh().bringAll();
    const std::optional<WeakSpot> spot =
        findWeakSpot(body_.mesh(), leastStretch(input_.params), strongPlaces());
    if (!spot) {
        return false;
    }
    const bool cuts = notch(*spot);
    body_.memory.tear.rest = cuts ? kRestAfterNotch : kRest;
    return cuts;
}

/// What is held, what tears already, and around that.
StrongPlaces Tear::strongPlaces() {
    StrongPlaces strong{{}, kNearEnds * body_.wallEdge};
    for (const std::uint32_t v : body_.heldVertices()) {
        strong.places.push_back(body_.mesh().restPosition(static_cast<int>(v)));
    }
    std::vector<int> torn;
    body_.memory.cohesion.addVertices(torn);
    for (const SlitEnd& end : allEnds()) {
        torn.insert(torn.end(), end.vertices.begin(), end.vertices.end());
    }
    for (const int v : torn) {
        strong.places.push_back(body_.mesh().restPosition(v));
    }
    return strong;
}

/// Presses a blade into the skin. Returns whether it cuts.
bool Tear::notch(const WeakSpot& spot) {
    makeRoom();
    const Vec3 in = -body_.wallEdge * spot.normal;
    const Vec3 half = body_.wallEdge * spot.along;
    const Vec3 deep = spot.at + kNotchDepth * in;
    const Blade to = bladeThrough(deep - half, deep + half);
    const Vec3 back = -(kNotchDepth + kNotchAbove) * in;
    body_.cutter->begin({to.a + back, to.b + back});
    body_.memory.beginStroke(
        {.number = body_.cutter->strokeNumber(), .firstTriangle = body_.mesh().triangleSlots()});
    beginStroke();
    const bool cuts = cut(to) == CutOutcome::cut;
    endStroke();
    return cuts;
}

Tear::Opening Tear::openingOf(const SlitEnd& end) const {
    const SurfaceMesh& mesh = body_.mesh();
    Opening opening;
    double ofFirst = 1e-300;
    double ofLast = 1e-300;
    const bool even = lengthOf(mesh, end) < kOneFront * body_.wallEdge;
    for (const auto& [v, place] : pointsBehind(mesh, end, kLooksBack * body_.wallEdge)) {
        const int facing = facingVertex(mesh, v, end.label + 1);
        if (facing < 0) {
            continue;
        }
        const Vec3 way = mesh.position(v) - mesh.position(facing);
        const double share = even ? 0.5 : place.share;
        const double open = way.norm() / std::max(neededAt(v, place.distance), 1e-12);
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

/// The opening of a point of W+ at which the end of its slit advances, `behind` from it [m].
double Tear::neededAt(int plus, double behind) const {
    const CohesiveZone& cohesion = body_.memory.cohesion;
    const CohesiveZone::Bond* bond = cohesion.find(plus);
    const double edges = behind / body_.wallEdge;
    return bond != nullptr && !bond->isBroken()
               ? kBondedOpening * bond->reach() * edges * std::sqrt(edges)
               : kFreeOpening * freeReach() * std::sqrt(edges);
}

/// The reach of the law where walls are free [m].
double Tear::freeReach() const {
    const double reach = body_.memory.cohesion.law().reach();
    return std::min(reach, std::max(kLongestReach * body_.wallEdge, kLeastOfReach * reach));
}

CutOutcome Tear::advance(const SlitEnd& end, const Opening& opening, bool begins) {
    const SurfaceMesh& mesh = body_.mesh();
    const std::optional<EndFrame> frame = frameOf(mesh, end);
    const std::optional<EndFrame> rest = restFrameOf(mesh, end, kEdgesInZone * body_.wallEdge);
    if (!frame || !rest) {
        return CutOutcome::air;
    }
    // Where the end is a bay of the uncut material, the blade goes straight below all of it.
    const Vec3 deepest = depthOf(mesh, end, *frame) * frame->heading;
    const Vec3 a = mesh.position(end.vertices.front()) + deepest;
    const Vec3 b = mesh.position(end.vertices.back()) + deepest;
    if (begins) {
        makeRoom();
        const Vec3 out = kOverhang * body_.wallEdge * frame->along;
        body_.cutter->goOnFrom({end.vertices, end.label / 2, frame->heading},
                               {a - deepest - out, b - deepest + out});
        beginStroke();
    }
    const double turn = turnOf(*frame, opening.way);
    const Vec3 way =
        body_.wallEdge * (std::cos(turn) * rest->heading + std::sin(turn) * rest->side);
    const auto goal = [&](int v, double own, double other) -> Vec3 {
        return presentPlace(mesh, end, v, mesh.restPosition(v) + advanceBy(own, other) * way);
    };
    const int first = end.vertices.front();
    const int last = end.vertices.back();
    return cut(bladeThrough(deepest + goal(first, opening.atFirst, opening.atLast),
                            deepest + goal(last, opening.atLast, opening.atFirst)));
}

/// The blade along a line in the body, out of its skin on both sides.
Blade Tear::bladeThrough(const Vec3& a, const Vec3& b) {
    const Vec3 middle = 0.5 * (a + b);
    const Vec3 axis = (b - a).stableNormalized();
    const double length = (b - a).norm();
    const double overhang = kOverhang * body_.wallEdge;
    const auto out = [&](const Vec3& direction) -> Vec3 {
        const double way = wayOut(middle, direction).value_or(0.5 * length);
        return middle + (way + overhang) * direction;
    };
    return {out(-axis), out(axis)};
}

/// How far it is out of the body; none from outside of it [m].
std::optional<double> Tear::wayOut(const Vec3& from, const Vec3& direction) {
    const SurfaceMesh& mesh = body_.mesh();
    const std::array<Vec3, 2> line{from, from + body_.memory.measure.bounds.diagonal() * direction};
    double nearest = 1e300;
    bool leaves = false;
    for (const int t : body_.trianglesNear(line)) {
        const Corners corners = cornersOf(mesh, t);
        const std::optional<LineHit> hit = hitOf(corners, from, direction, 0);
        if (hit && hit->distance > 0 && hit->distance < nearest) {
            nearest = hit->distance;
            leaves = areaNormal(corners).dot(direction) > 0;
        }
    }
    return leaves ? std::optional(nearest) : std::nullopt;
}

/// The largest stress of the skin, as a share of the strength.
double Tear::stress() const {
    return body_.memory.measure.largestStretch / leastStretch(input_.params);
}

void Tear::note(const Opening& opening) {
    double& most = output_.report.tear->opening;
    most = std::max(most, opening.most());
}

CutOutcome Tear::cut(const Blade& to) {
    const CutResult result = body_.cutter->advance(to);
    followTear(result, body_, log_.history(), output_);
    if (result.outcome != CutOutcome::cut) {
        output_.report.tear->failure =
            result.reason.empty() ? "no material lies ahead of the slit" : result.reason;
    }
    return result.outcome;
}

/// Ends whatever stroke there is: of another tear, or of a blade in the air.
void Tear::makeRoom() {
    endStroke();
    if (body_.cutter->inStroke()) {
        stroke_.end();
    }
}

void Tear::beginStroke() {
    TearStroke& tear = body_.memory.tear;
    tear.goesOn = true;
    tear.firstVertex = body_.mesh().vertexCount();
    tear.failures = 0;
}

void Tear::endStroke() {
    endTear(body_, log_.history(), output_);
}

std::vector<SlitEnd> Tear::presentEnds() const {
    std::vector<SlitEnd> ends;
    if (!body_.memory.tear.goesOn) {
        return ends;
    }
    const std::vector<RungNode>& rung = body_.cutter->rung();
    for (std::size_t i = 0; i < rung.size(); ++i) {
        if (!rung[i].attached) {
            continue;
        }
        if (i == 0 || !rung[i - 1].attached) {
            ends.push_back({{rung[i].vertex}, 2 * body_.cutter->strokeNumber()});
        }
        ends.back().vertices.push_back(rung[i + 1].vertex);
    }
    return ends;
}

const std::vector<SlitEnd>& Tear::allEnds() {
    if (revision_ != body_.modelRevision) {
        revision_ = body_.modelRevision;
        ends_ = findSlitEnds(body_.mesh());
    }
    return ends_;
}

}  // namespace kerf
