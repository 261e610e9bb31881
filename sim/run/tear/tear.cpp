#include "sim/run/tear/tear.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "sim/base/sort_unique.h"
#include "sim/run/blade/cut_followers.h"
#include "sim/run/parts/led_blade.h"

namespace kerf {

namespace {

// Openings one edge behind an end at which it advances, of the law's reach: where walls are bonded,
// and where they are free, as linear elasticity has it at a quarter of the toughness.
constexpr double kBondedOpening = 0.15;
constexpr double kFreeOpening = 0.4;
// Edges of walls.
constexpr double kLooksBack = 1.6;  // where the openings are taken
constexpr double kStraight = 0.6;   // an end may leave a straight line
constexpr double kOneFront = 3;     // an end up to so long advances evenly
constexpr double kOverhang = 0.7;   // the blade stands out of the skin
constexpr double kNearEnds = 3;     // no place near an end is a weak spot
constexpr double kMostTurn = 0.6;   // of the heading in an advance [rad]
constexpr double kFollows = 0.5;    // of an opening that advances, where one end follows the other
constexpr int kPatience = 400;      // steps without an advance until a tear has ended
constexpr int kMostFailures = 3;    // in a row
constexpr int kRest = 50;           // steps, after so many failures

/// The direction of the largest tension about the end of a slit whose walls opened and slid by
/// `way`: Erdogan and Sih (1963), with stress intensities in proportion to the displacements.
Vec3 wayOfLargestTension(const EndFrame& frame, const Vec3& way) {
    const double opened = std::max(way.dot(frame.side), 0.0);
    const double slid = way.dot(frame.heading);
    if (std::abs(slid) <= 1e-6 * way.norm()) {
        return frame.heading;
    }
    const double root = std::sqrt(opened * opened + 8 * slid * slid);
    const double angle =
        std::clamp(2 * std::atan((opened - root) / (4 * slid)), -kMostTurn, kMostTurn);
    return std::cos(angle) * frame.heading + std::sin(angle) * frame.side;
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

/// Through the ends of a slit's end, and out of the skin there.
Blade bladeThrough(const SurfaceMesh& mesh, const SlitEnd& end, const Vec3& a, const Vec3& b,
                   double edge) {
    const Vec3 out = kOverhang * edge * (b - a).stableNormalized();
    return {touchesSkin(mesh, end.vertices.front()) ? Vec3(a - out) : a,
            touchesSkin(mesh, end.vertices.back()) ? Vec3(b + out) : b};
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
    if (!isOn()) {
        return watched_;
    }
    const SurfaceMesh& mesh = body_.mesh();
    for (const SlitEnd& end : allEnds()) {
        watched_.insert(watched_.end(), end.vertices.begin(), end.vertices.end());
        for (const auto& [v, place] : pointsBehind(mesh, end, kLooksBack * body_.wallEdge)) {
            const int facing = facingVertex(mesh, v, end.label + 1);
            watched_.insert(watched_.end(), {v, std::max(facing, v)});
        }
    }
    body_.memory.cohesion.addVertices(watched_);
    sortUnique(watched_);
    return watched_;
}

void Tear::step() {
    TearStroke& tear = body_.memory.tear;
    CohesiveZone& cohesion = body_.memory.cohesion;
    if (!isOn()) {
        endStroke();
        return;
    }
    cohesion.setLaw(tearLaw(input_.params, body_.wallEdge));
    const double taken = cohesion.taken();
    cohesion.noteOpenings(body_.mesh());
    output_.report.fractureEnergy += cohesion.taken() - taken;
    if (!tear.goesOn && standsInMaterial(body_.cutter->rung())) {
        return;  // a blade cuts
    }
    tear.rest = std::max(tear.rest - 1, 0);
    output_.report.tear = TearReport{.stress = stress()};
    const bool advanced = goOn() || (tear.rest == 0 && (beginElsewhere() || beginAtWeakSpot()));
    output_.report.tear->advanced = advanced;
    tear.idle = advanced ? 0 : tear.idle + 1;
    if (tear.idle > kPatience || !standsInMaterial(body_.cutter->rung())) {
        endStroke();
    }
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
            tear.rest = kRest;
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
        if (body_.memory.tear.goesOn && shareVertices(end, body_.cutter->rung())) {
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
    body_.memory.tear.rest = cuts ? 0 : kRest;
    return cuts;
}

/// Returns whether the skin is notched where it is stretched most.
bool Tear::beginAtWeakSpot() {
    if (stress() < 1) {
        return false;
    }
    StrongPlaces strong{body_.heldVertices(), {}, kNearEnds * body_.wallEdge};
    for (const SlitEnd& end : allEnds()) {
        for (const int v : end.vertices) {
            strong.ends.push_back(body_.mesh().restPosition(v));
        }
    }
    body_.mesh().bringAll();
    const std::optional<WeakSpot> spot =
        findWeakSpot(body_.mesh(), leastStretch(input_.params), strong);
    if (!spot) {
        return false;
    }
    endStroke();
    const Notch notch = notchAt(*spot, body_.wallEdge);
    body_.cutter->begin(notch.from);
    body_.memory.tear = {.goesOn = true, .firstVertex = body_.mesh().vertexCount()};
    const bool cuts = cut(notch.to) == CutOutcome::cut;
    endStroke();
    body_.memory.tear.rest = cuts ? 0 : kRest;
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
               : kFreeOpening * cohesion.law().reach() * std::sqrt(edges);
}

CutOutcome Tear::advance(const SlitEnd& end, const Opening& opening, bool begins) {
    const SurfaceMesh& mesh = body_.mesh();
    const double edge = body_.wallEdge;
    const std::optional<EndFrame> frame = frameOf(mesh, end);
    if (!frame) {
        return CutOutcome::air;
    }
    const Vec3 a = mesh.position(end.vertices.front());
    const Vec3 b = mesh.position(end.vertices.back());
    if (begins) {
        endStroke();
        body_.cutter->goOnFrom({end.vertices, end.label / 2, frame->heading},
                               bladeThrough(mesh, end, a, b, edge));
        body_.memory.tear = {.goesOn = true, .firstVertex = mesh.vertexCount()};
    }
    const Vec3 way = edge * wayOfLargestTension(*frame, opening.way);
    return cut(bladeThrough(mesh, end, a + advanceBy(opening.atFirst, opening.atLast) * way,
                            b + advanceBy(opening.atLast, opening.atFirst) * way, edge));
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
    accept(result);
    if (result.outcome != CutOutcome::cut) {
        output_.report.tear->failure = result.reason;
    }
    return result.outcome;
}

/// Ends whatever stroke there is.
void Tear::endStroke() {
    if (body_.cutter->inStroke() && (body_.memory.tear.goesOn || isOn())) {
        accept(body_.cutter->finish());
    }
    body_.memory.tear = {};
}

void Tear::accept(const CutResult& result) {
    output_.report.search.add(body_.cutter->takeSearchWork());
    if (!result.delta.empty()) {
        followCut(result.delta, body_, log_.history(), output_);
    }
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
        ends_ = findSlitEnds(body_.mesh(), kStraight * body_.wallEdge);
    }
    return ends_;
}

}  // namespace kerf
