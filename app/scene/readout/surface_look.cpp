#include "app/scene/readout/surface_look.h"

#include <spdlog/fmt/fmt.h>

#include "sim/mesh/box_tree.h"
#include "sim/mesh/thickness.h"

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

ThicknessMap::Subject ThicknessMap::Subject::of(const Simulation& simulation) {
    return {simulation.bodyRevision(), simulation.stepCount(), simulation.report().triangles,
            simulation.uncut()};
}

bool ThicknessMap::follow(Simulation& simulation, bool wanted, bool rests) {
    const Subject now = Subject::of(simulation);
    if (job_ && (!wanted || now.revision != working_.revision)) {
        job_.reset();
    }
    bool changed = takeReady();
    if (values_ && !known_.isCutLike(now)) {
        values_.reset();
        known_ = {};
        changed = true;
    }
    if (wanted && rests && !job_ && known_.revision != now.revision) {
        begin(simulation);
    }
    return changed;
}

void ThicknessMap::begin(Simulation& simulation) {
    working_ = Subject::of(simulation);
    auto body = std::make_shared<const SurfaceMesh>(simulation.mesh());
    job_ = std::make_unique<BackgroundJob<render::FieldValues>>([body](WorkProgress& progress) {
        return surfaceThickness(*body, [&progress](double share) {
            progress.enter(fmt::format("{:.0f} %", 100 * share));
        });
    });
}

bool ThicknessMap::takeReady() {
    if (!job_ || !job_->done()) {
        return false;
    }
    values_ = std::make_shared<const render::FieldValues>(job_->take());
    known_ = std::exchange(working_, {});
    job_.reset();
    return true;
}

std::string ThicknessMap::note(const Simulation& simulation) const {
    if (known_.revision == simulation.bodyRevision()) {
        return "";
    }
    const std::string of = values_ ? fmt::format("From step {}. ", known_.step) : "";
    if (job_) {
        return of + "Computing: " + job_->stage();
    }
    return of + "Computed while paused.";
}

}  // namespace kerf::app
