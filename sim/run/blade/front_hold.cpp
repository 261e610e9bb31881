#include "sim/run/blade/front_hold.h"

#include <algorithm>
#include <utility>

#include "sim/run/parts/led_blade.h"

namespace kerf {

FrontHold::FrontHold(RunningBody& body, double timeStep) : body_(body) {
    if (body_.mesh().openStroke() >= 0) {
        carryHidden(timeStep);
        return;
    }
    if (!standsInMaterial(body_.cutter->rung())) {
        return;
    }
    anchors_ = findFrontAnchors(body_.cutter->rung(), frame(timeStep));
    for (const Anchor& anchor : anchors_) {
        body_.solver.masses().anchor(anchor.vertex, anchor.velocity.cast<float>());
    }
}

void FrontHold::release() {
    for (const Anchor& anchor : std::exchange(anchors_, {})) {
        body_.solver.masses().release(anchor.vertex);
    }
}

void FrontHold::carryHidden(double timeStep) {
    std::vector<Anchor> found = findHiddenAnchors(body_.updater->hiddenVertices(), frame(timeStep));
    std::ranges::sort(found, {}, &Anchor::vertex);
    std::vector<std::uint32_t> vertices;
    std::vector<Vec3f> velocities;
    for (const Anchor& anchor : found) {
        vertices.push_back(static_cast<std::uint32_t>(anchor.vertex));
        velocities.push_back(anchor.velocity.cast<float>());
    }
    if (!vertices.empty()) {
        body_.solver.masses().carry(vertices, velocities);
    }
}

AnchorFrame FrontHold::frame(double timeStep) const {
    return {body_.mesh(), body_.updater->pieceOfMeshVertex(), body_.cutter->edgeLengthAtFront(),
            body_.cutter->strokeSurface(), timeStep};
}

}  // namespace kerf
