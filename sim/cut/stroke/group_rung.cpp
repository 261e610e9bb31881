#include "sim/cut/stroke/group_rung.h"

#include "sim/cut/plan/strip/new_rung.h"
#include "sim/cut/wall_copies.h"

namespace kerf::cut {

bool isInAir(const std::vector<RungNode>& rung) {
    return std::all_of(rung.begin(), rung.end(), [](const RungNode& n) { return n.vertex < 0; });
}

void GroupRung::startTransit() {
    group_.transit = ++stroke_.transit;
    group_.firstVertexOfTransit = body_.mesh.vertexCount();
    group_.past.start(group_.firstVertexOfTransit);
    group_.onSeams.clear();
    group_.sides.clear();
    group_.flushSides.clear();
    group_.leftPlane = false;
    group_.opensSlits = true;
}

Vec3 GroupRung::leastOffsetAt(double s) const {
    const double length = std::min(body_.settings.offset, kLeastOffset) * body_.h();
    return bladeOffset(length, 1, body_.settings.seed, group_.transit, s);
}

RungNode GroupRung::nodeInAir(const Blade& at, double s) const {
    return {pointOn(at, s) + leastOffsetAt(s), s, -1, false};
}

void GroupRung::place(const Blade& at) {
    startTransit();
    set({nodeInAir(at, 0), nodeInAir(at, 1)});
    group_.blade = at;
    group_.lastAdvance = Vec3::Zero();
}

void GroupRung::takeUp(const SlitFront& front, const Blade& at) {
    startTransit();
    std::vector<RungNode> nodes;
    for (const int v : front.vertices) {
        nodes.push_back({body_.mesh.position(v), 0.5, v, v != front.vertices.back()});
        body_.mesh.forEachOutgoing(v, [&](int h) {
            // Walls beside it count as the transit's own.
            const int behind = body_.mesh.target(h);
            if (strokeOf(body_.mesh, h / 3) == front.stroke && !body_.mesh.isOriginal(behind)) {
                group_.firstVertexOfTransit = std::min(group_.firstVertexOfTransit, behind);
            }
        });
    }
    const auto liesOnSkin = [&](int v) {
        bool on = false;
        body_.mesh.forEachOutgoing(
            v, [&](int h) { on = on || body_.mesh.kind(h / 3) == SurfaceKind::skin; });
        return on;
    };
    if (liesOnSkin(front.vertices.front())) {
        nodes.insert(nodes.begin(), nodeInAir(at, 0));
    }
    if (liesOnSkin(front.vertices.back())) {
        nodes.push_back(nodeInAir(at, 1));
    }
    reparametrize(at, body_.h(), nodes);
    set(std::move(nodes));
    group_.blade = at;
    group_.lastAdvance = Vec3::Zero();
    group_.heading = front.heading;
}

/// It stays as far behind the blade as it is: started anew, a blade that is drawn through the body
/// along itself would never be far enough ahead to cut.
void GroupRung::slide(const Blade& to, const std::vector<RungNode>& from) {
    const auto behind = [&](const RungNode& node) -> Vec3 {
        return node.position - pointOn(to, node.s);
    };
    group_.blade = {to.a + behind(from.front()), to.b + behind(from.back())};
    set({{group_.blade.a, 0, -1, false}, {group_.blade.b, 1, -1, false}});
}

void GroupRung::set(std::vector<RungNode> next) {
    group_.rung = std::move(next);
    if (isInAir(group_.rung)) {
        group_.heading = Vec3::Zero();
    }
    tie();
}

void GroupRung::keepOwn(std::vector<RungNode> nodes) {
    std::erase_if(nodes, [&](const RungNode& node) {
        return node.vertex >= 0 && body_.pieces.groupOf(node.vertex) != group_.number;
    });
    if (nodes.size() < 2) {
        // All of the front is in other pieces, both ends too: for this one the blade begins here.
        place(group_.blade);
        return;
    }
    set(std::move(nodes));
}

// While all lies where it rests, ties would hold the rung where it is. They can wait: where they
// are to be made is known also when the body has begun to move.
void GroupRung::tie() {
    group_.edgeLength = body_.edgeLengthAbout(group_.rung);
    group_.tiesWait = body_.atRest && body_.triangles.hasOwnTree();
    if (group_.tiesWait) {
        group_.airTies = {};
        body_.triangles.finder().bounds();  // the tree knows the shape at rest from now on
    } else {
        group_.airTies = tiesIn(SkinShape::current);
    }
}

/// Before the tree hears that anything has moved.
void GroupRung::makeWaitingTies() {
    if (std::exchange(group_.tiesWait, false)) {
        group_.airTies = tiesIn(SkinShape::rest);
    }
}

AirTies GroupRung::tiesIn(SkinShape shape) {
    return {body_.mesh, body_.triangles.finder(), isOuter(), group_.edgeLength, group_.rung, shape};
}

/// Tells the triangles of the group that were there before the stroke, or divide such.
std::function<bool(int)> GroupRung::isOuter() const {
    return [this](int t) {
        return strokeOf(body_.mesh, t) != stroke_.number &&
               body_.pieces.groupOf(body_.mesh.triangle(t)[0]) == group_.number;
    };
}

}  // namespace kerf::cut
