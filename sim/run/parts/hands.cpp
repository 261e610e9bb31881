#include "sim/run/parts/hands.h"

#include <spdlog/fmt/fmt.h>

#include "sim/base/placement.h"
#include "sim/mesh/surface_patch.h"

namespace kerf {

namespace {

std::string emptyHand(int number) {
    return fmt::format("Hand {} holds nothing; let it grab first.", number);
}

/// What a hand that grabs would hold, whoever else does; ascending.
std::vector<int> withinReach(const Grab& grab, const SurfaceMesh& mesh) {
    if (grab.alongSurface) {
        return surfacePatch(mesh, grab.at, grab.radius);
    }
    std::vector<int> vertices;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        if (contains(Ball{grab.at, grab.radius}, mesh.position(v)) && mesh.outgoing(v) >= 0) {
            vertices.push_back(v);
        }
    }
    return vertices;
}

shared::PullRecord pullOf(const Hands::Hand& hand, const Hands::Held& held, double timeStep) {
    const Vec3f target = (hand.to + held.offset).cast<float>();
    const Vec3f motion = ((hand.to - hand.from) / timeStep).cast<float>();
    return {static_cast<std::uint32_t>(held.vertex),
            target.x(),
            target.y(),
            target.z(),
            motion.x(),
            motion.y(),
            motion.z(),
            0};
}

}  // namespace

std::string Hands::grab(const Grab& grab, const SurfaceMesh& mesh) {
    if (!grab.at.allFinite() || !(grab.radius > 0)) {
        return "A grab needs a finite point and a radius above 0.";
    }
    Hand hand{grab.hand, grab.at, grab.at, {}};
    for (const int v : withinReach(grab, mesh)) {
        const Hand* own = find(grab.hand);
        const bool free =
            !holds(v) ||
            (own && std::ranges::any_of(own->held, [v](const Held& h) { return h.vertex == v; }));
        if (free) {
            hand.held.push_back({v, mesh.position(v) - grab.at});
        }
    }
    if (hand.held.empty()) {
        return fmt::format("No free vertex lies within {:g} m of the hand; move it closer.",
                           grab.radius);
    }
    release({grab.hand});
    const auto place = std::ranges::lower_bound(hands_, hand.number, {}, &Hand::number);
    hands_.insert(place, std::move(hand));
    return "";
}

std::string Hands::drag(const Drag& drag) {
    if (!drag.to.allFinite()) {
        return "A drag needs a finite point.";
    }
    Hand* hand = find(drag.hand);
    if (hand == nullptr) {
        return emptyHand(drag.hand);
    }
    hand->to = drag.to;
    return "";
}

std::string Hands::release(const Release& release) {
    const auto removed =
        std::erase_if(hands_, [&](const Hand& hand) { return hand.number == release.hand; });
    return removed > 0 ? "" : emptyHand(release.hand);
}

void Hands::forgetDead(const SurfaceMesh& mesh) {
    for (Hand& hand : hands_) {
        std::erase_if(hand.held, [&](const Held& held) { return mesh.outgoing(held.vertex) < 0; });
    }
    std::erase_if(hands_, [](const Hand& hand) { return hand.held.empty(); });
}

std::vector<shared::PullRecord> Hands::advance(double timeStep) {
    std::vector<shared::PullRecord> pulls;
    for (Hand& hand : hands_) {
        for (const Held& held : hand.held) {
            pulls.push_back(pullOf(hand, held, timeStep));
        }
        hand.from = hand.to;
    }
    return pulls;
}

std::vector<std::uint32_t> Hands::heldVertices() const {
    std::vector<std::uint32_t> vertices;
    for (const Hand& hand : hands_) {
        for (const Held& held : hand.held) {
            vertices.push_back(static_cast<std::uint32_t>(held.vertex));
        }
    }
    return vertices;
}

Hands::Hand* Hands::find(int number) {
    const auto found = std::ranges::find(hands_, number, &Hand::number);
    return found == hands_.end() ? nullptr : &*found;
}

bool Hands::holds(int vertex) const {
    return std::ranges::any_of(hands_, [vertex](const Hand& hand) {
        return std::ranges::any_of(hand.held,
                                   [vertex](const Held& held) { return held.vertex == vertex; });
    });
}

}  // namespace kerf
