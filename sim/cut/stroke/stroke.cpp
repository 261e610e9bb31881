// A stroke as a whole: how it begins, what a step is for all groups of pieces, how it ends.

#include "sim/cut/stroke/stroke.h"

#include "sim/cut/stroke/group_rung.h"
#include "sim/cut/stroke/group_step.h"
#include "sim/cut/stroke/ladder.h"

namespace kerf::cut {

namespace {

// The distance between copies, as a share of h, from which on their pieces are cut apart.
constexpr double kParted = 1e-3;

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

void Stroke::begin(CutBody& body, const Blade& at) {
    blade = at;
    goesOn = true;
    mayResume = true;
    number = unused;  // a stroke that only met air leaves its number to the next
    cleanup.reset();
    groups.clear();
    body.beginStroke();
    body.pieces.group(kParted * body.h());
    body.pieces.measureVolumes();
    start = {body.mesh.triangleSlots(), sumOfRestVolumes(body.pieces.labels())};
    body.mesh.setOpenStroke(body.settings.openCut ? number : -1);
    for (const int v : body.pieces.lowestVertices(body.pieces.groups())) {
        GroupStroke& group = groups.emplace_back();
        group.vertex = v;
        group.number = body.pieces.groupOf(v);
        GroupRung(body, *this, group).place(at);
    }
    joinRungs();
}

void Stroke::goOnFrom(CutBody& body, const SlitFront& front, const Blade& at) {
    begin(body, at);
    number = front.stroke;
    mayResume = false;  // what holds the walls together would not hold those that cross them
    for (GroupStroke& group : groups) {
        if (group.number == body.pieces.groupOf(front.vertices.front())) {
            GroupRung(body, *this, group).takeUp(front, at);
        }
    }
    joinRungs();
}

CutResult Stroke::advance(CutBody& body, Gate gate) {
    if ((blade.b - blade.a).norm() <= kStandingStill * body.h()) {
        return outcome(CutOutcome::waiting);
    }
    for (GroupStroke& group : groups) {
        followMesh(body.mesh, group.rung);
        group.airTies.follow(body.mesh, group.rung);
    }
    divideGroups(body);
    CutResult sum;
    for (GroupStroke& group : groups) {
        addTo(sum, takeStep(body, *this, group, gate));
    }
    joinRungs();
    if (sum.outcome == CutOutcome::cut) {
        sum.statistics.cleanup = cleanUpBehindFront(body, sum.delta);
        holdLivingVertices(body);
        for (GroupStroke& group : groups) {
            GroupRung(body, *this, group).tie();  // the skin beside any of them may have changed
        }
    }
    return sum;
}

CutResult Stroke::finish(CutBody& body) {
    CutResult result = advance(body, Gate::flush);
    goesOn = false;
    groups.clear();
    rung.clear();
    if (result.outcome != CutOutcome::cut) {
        result.delta.firstNewVertex = body.mesh.vertexCount();
    }
    addTo(result.statistics.cleanup, cleanUpAtEnd(body, result.delta));
    result.statistics.closing = closeWounds(body, result.delta);
    result.statistics.debris = removeDebris(body, result.delta);
    return result;
}

void Stroke::makeWaitingTies(CutBody& body) {
    for (GroupStroke& group : groups) {
        GroupRung(body, *this, group).makeWaitingTies();
    }
}

// Pieces that have parted since go on apart, each with its own part of the rung. A piece that has
// gone (debris) takes its group along.
void Stroke::divideGroups(CutBody& body) {
    const GroupedPieces& pieces = body.pieces;
    const std::optional<std::vector<int>> before = body.pieces.divide(kParted * body.h());
    if (!before) {
        return;
    }
    std::map<int, int> placeOfNumber;  // in `groups`, by the number before
    std::set<int> parted = pieces.groups();
    for (int i = 0; i < sizeOf(groups); ++i) {
        placeOfNumber[groups[i].number] = i;
        groups[i].number = pieces.groupOf(groups[i].vertex);
        parted.erase(groups[i].number);
    }
    std::set<int> divided;
    for (const int v : pieces.lowestVertices(std::move(parted))) {
        const int parent = placeOfNumber.at((*before)[pieces.labels().ofVertex()[v]]);
        GroupStroke part = groups[parent];
        part.vertex = v;
        part.number = pieces.groupOf(v);
        groups.push_back(std::move(part));
        GroupRung(body, *this, groups.back()).keepOwn(groups[parent].rung);
        divided.insert(parent);
    }
    for (const int parent : divided) {
        GroupRung(body, *this, groups[parent]).keepOwn(groups[parent].rung);
    }
    std::erase_if(groups, [](const GroupStroke& group) { return group.number < 0; });
}

/// The clean-up may have taken the vertex away by which a group is known.
void Stroke::holdLivingVertices(const CutBody& body) {
    for (GroupStroke& group : groups) {
        if (body.mesh.outgoing(group.vertex) < 0) {
            const std::vector<int> living = body.pieces.lowestVertices({group.number});
            group.vertex = living.empty() ? group.vertex : living.front();
        }
    }
}

void Stroke::joinRungs() {
    rung.clear();
    for (const GroupStroke& group : groups) {
        rung.insert(rung.end(), group.rung.begin(), group.rung.end());
    }
}

}  // namespace kerf::cut
