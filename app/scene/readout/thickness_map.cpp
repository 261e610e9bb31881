#include "app/scene/readout/thickness_map.h"

#include <spdlog/fmt/fmt.h>

#include <utility>

#include "sim/mesh/thickness.h"
#include "sim/run/start/prepared_body.h"

namespace kerf::app {

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
