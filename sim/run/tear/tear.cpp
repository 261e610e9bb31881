#include "sim/run/tear/tear.h"

#include "sim/base/containers.h"
#include "sim/run/blade/cut_followers.h"
#include "sim/run/parts/led_blade.h"
#include "sim/run/tear/tear_blade.h"

namespace kerf {

namespace {

// Edges of walls.
constexpr double kNotchDepth = 0.8;
constexpr double kNotchAbove = 0.3;
constexpr double kNearEnds = 3;      // no place near an end is a weak spot
constexpr int kPause = 10;           // steps without an advance until another slit may tear
constexpr double kNearlyOpen = 0.7;  // of what makes an end advance: the skin bears no more
constexpr int kPatience = 400;       // steps without an advance until a tear has ended
constexpr int kLooksForSpots = 5;    // steps
constexpr int kRestAfterNotch = 20;  // steps, in which it relieves the skin
constexpr int kRest = 30;            // steps until what failed is tried again

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
    return input_.params.tearing != 0 && mayTear(input_.params) && input_.timeRuns;
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
        for (const auto& [v, place] : pointsBehind(mesh, end, kEdgesInZone * body_.wallEdge)) {
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
        tell();
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
    noteSlits();
    tear.idle = advanced ? 0 : tear.idle + 1;
    tear.rest = std::max(tear.rest - 1, 0);
    if (advanced || tear.rest == 0) {
        tear.stuck.clear();
    }
    if (tear.idle > kPatience || !standsInMaterial(body_.cutter->rung())) {
        endStroke();  // none of a blade
    }
}

/// The openings of slits that this step had no use for are told, too.
void Tear::noteSlits() {
    const std::vector<SlitEnd> ends = allEnds();
    output_.report.tear->hasSlit = !ends.empty();
    if (output_.report.tear->opening == 0) {
        std::ranges::for_each(ends, [this](const SlitEnd& end) { openingAt(end); });
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
    for (const SlitEnd& end : presentEnds()) {
        const EndOpening opening = openingAt(end);
        if (opening.most() > 1) {
            return advance(end, opening, false);
        }
    }
    return false;
}

/// Returns whether the end of another slit does, the one that is opened most.
bool Tear::beginElsewhere() {
    SlitEnd found;
    EndOpening most{1, 1};
    for (const SlitEnd& end : allEnds()) {
        const EndOpening opening = mayBegin(end) ? openingAt(end) : EndOpening{};
        if (opening.most() > most.most()) {
            most = opening;
            found = end;
        }
    }
    return !found.vertices.empty() && advance(found, most, true);
}

bool Tear::mayBegin(const SlitEnd& end) const {
    const TearStroke& tear = body_.memory.tear;
    return std::ranges::find(tear.stuck, end.vertices.front()) == tear.stuck.end() &&
           !(tear.goesOn && shareVertices(end, body_.cutter->rung()));
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
    const std::vector<std::uint32_t> held = body_.heldVertices();
    std::vector<int> vertices(held.begin(), held.end());
    body_.memory.cohesion.addVertices(vertices);
    for (const SlitEnd& end : allEnds()) {
        vertices.insert(vertices.end(), end.vertices.begin(), end.vertices.end());
    }
    StrongPlaces strong{{}, kNearEnds * body_.wallEdge};
    for (const int v : vertices) {
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
    const Blade to = bladeThrough(body_, deep - half, deep + half);
    const Vec3 back = -(kNotchDepth + kNotchAbove) * in;
    body_.cutter->begin({to.a + back, to.b + back});
    body_.memory.beginStroke(
        {.number = body_.cutter->strokeNumber(), .firstTriangle = body_.mesh().triangleSlots()});
    beginStroke();
    const bool cuts = cut(to);
    endStroke();
    return cuts;
}

/// Notes the largest, too.
EndOpening Tear::openingAt(const SlitEnd& end) {
    EndOpening opening = openingOf(body_.mesh(), body_.memory.cohesion, body_.wallEdge, end);
    double& most = output_.report.tear->opening;
    most = std::max(most, opening.most());
    return opening;
}

/// Returns whether it cuts. An end that can't advance rests.
bool Tear::advance(const SlitEnd& end, const EndOpening& opening, bool begins) {
    const std::optional<TearBlade> blade = bladeOf(body_, end, opening);
    if (blade && begins) {
        makeRoom();
        body_.cutter->goOnFrom({end.vertices, end.label / 2, blade->heading}, blade->from);
        beginStroke();
    }
    const bool cuts = blade && cut(blade->to);
    if (!cuts) {
        endStroke();
        body_.memory.tear.stuck.push_back(end.vertices.front());
        body_.memory.tear.rest = kRest;
    }
    return cuts;
}

/// The largest stress of the skin, as a share of the strength.
double Tear::stress() const {
    return body_.memory.measure.largestStretch / leastStretch(input_.params);
}

/// Returns whether it cuts.
bool Tear::cut(const Blade& to) {
    const CutResult result = body_.cutter->advance(to);
    followStep(result, body_, log_.history(), output_);
    if (result.outcome != CutOutcome::cut) {
        output_.report.tear->failure =
            result.reason.empty() ? "no material ahead of the slit" : result.reason;
        tell();
    }
    return result.outcome == CutOutcome::cut;
}

/// Says why nothing tears, once until another reason holds.
void Tear::tell() {
    std::string why = tearSentence(output_.report, input_.params, false);
    if (!why.empty() && why != told_) {
        output_.say("{}", told_ = std::move(why));
    }
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
