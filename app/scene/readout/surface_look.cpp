#include "app/scene/readout/surface_look.h"

#include <algorithm>

#include "sim/mesh/ray_box.h"

namespace kerf::app {
namespace {

constexpr double kMargin = 1e-5;  // of the diagonal: no ray slips by a flat box

bool sameRay(const render::Ray& a, const render::Ray& b) {
    return a.origin == b.origin && a.direction == b.direction;
}

bool samePoses(const std::vector<Blade>& a, const std::vector<Blade>& b) {
    return std::ranges::equal(
        a, b, [](const Blade& p, const Blade& q) { return p.a == q.a && p.b == q.b; });
}

bool passes(const render::Ray& ray, Bounds box) {
    box.widen(kMargin * box.diagonal());
    return entryInto(box, {ray.origin, ray.direction}, 1e300) < kMissesBox;
}

}  // namespace

std::optional<SurfacePoint> SurfaceLook::pick(Simulation& simulation, const render::Ray& ray) {
    if (!passes(ray, simulation.bounds())) {
        return std::nullopt;
    }
    const int revision = simulation.bodyRevision();
    if (pick_.bodyRevision != revision || !sameRay(pick_.ray, ray)) {
        ++searches_;
        const std::vector<int> near = simulation.trianglesIn(boxAbout(ray, simulation.bounds()));
        pick_ = {revision, ray, pickSurface(simulation.meshAsRead(), near, ray)};
    }
    return pick_.point;
}

const CutPreview& SurfaceLook::preview(Simulation& simulation, const std::vector<Blade>& way) {
    const int revision = simulation.bodyRevision();
    if (preview_.bodyRevision != revision || !samePoses(preview_.way, way)) {
        ++searches_;
        const std::vector<int> near =
            way.empty() ? std::vector<int>{} : simulation.trianglesIn(boxAbout(way));
        preview_ = {revision, way, previewCut(simulation.meshAsRead(), near, way)};
    }
    return preview_.cut;
}

}  // namespace kerf::app
