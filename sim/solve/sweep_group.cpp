#include "sim/solve/sweep_group.h"

#include <algorithm>
#include <string>

#include "gpu/fetched_buffer.h"
#include "gpu/gl_check.h"
#include "shaders/shared/sweep_bindings.h"
#include "sim/solve/gathered_records.h"

namespace kerf {

namespace {

using gpu::TexelFormat;
using shared::uint;

// On llvmpipe more threads than run side by side, so that each has fewer turns.
constexpr uint kThreadsOfImages = 128;
constexpr std::size_t kMostVerticesOfImages = 16384;

std::size_t roundedUp(std::size_t count, std::size_t size) {
    return (count + size - 1) / size;
}

std::size_t mostEntries(const Incidence& incidence, std::size_t vertices) {
    std::size_t most = 0;
    for (std::size_t v = 0; v < vertices; ++v) {
        most = std::max<std::size_t>(most, valence(incidence, static_cast<uint>(v)));
    }
    return most;
}

}  // namespace

std::size_t mostTurnsOfSweep(const BodyModel& model, uint threads) {
    const std::size_t vertices = roundedUp(model.restPositions.size(), threads) + 1;
    std::size_t turns = 2 + 2 * vertices;  // of the sweeps, the prediction and the last gathering
    forEachType(model, [&](auto row, const auto& constraints) {
        const Incidence& incidence = model.incidences[row.kType];
        const std::size_t entries = mostEntries(incidence, model.restPositions.size());
        constexpr std::size_t kEnds = 3;  // of its two loops, and where a pair is cut in two
        turns += vertices * (1 + entries + kEnds) + roundedUp(constraints.size(), threads) + 1;
    });
    return turns;
}

void SweepGroup::setBody(const BodyModel& model) {
    const std::size_t most = way_ == gpu::KernelWay::images
                                 ? kMostVerticesOfImages
                                 : std::size_t{shared::kSharedSweepVertices};
    const bool fits = model.restPositions.size() <= most;
    sweepsAtOnce_ = fits ? static_cast<uint>(kMostTurns / mostTurnsOfSweep(model, threads_)) : 0;
}

uint SweepGroup::threadsFor(gpu::KernelWay way) {
    return way == gpu::KernelWay::images ? kThreadsOfImages
                                         : gpu::threadsOfGroup(gpu::queryDevice());
}

void SweepGroup::step(SolverBody& body) {
    if (!kernel_) {
        kernel_ = gpu::fetchingKernel("sim/sweeps.comp", way_,
                                      {{"SWEEP_GROUP", std::to_string(threads_) + "u"}});
    }
    bind(body);
    const uint sweeps = body.uniforms.sweeps;
    for (uint first = 0; first < sweeps; first += sweepsAtOnce_) {
        kernel_->setNumbers({first, std::min(first + sweepsAtOnce_, sweeps)});
        kernel_->dispatch(1);
        ++body.dispatches;
    }
}

void SweepGroup::bind(const SolverBody& body) const {
    body.uniformBuffer.bindStorage(shared::kUniformsBinding);
    const auto bindState = [&](const gpu::Buffer& buffer, uint binding) {
        buffer.bindStorage(binding);
        if (way_ == gpu::KernelWay::images) {
            buffer.bindImage(binding, TexelFormat::float32x4);
        }
    };
    const auto bindRecords = [&](const gpu::Buffer& buffer, uint unit, TexelFormat format) {
        gpu::bindFetched(buffer, unit, format, way_);
    };
    bindState(body.state.positions, shared::kPositionsBinding);
    bindState(body.state.velocities, shared::kVelocitiesBinding);
    bindState(body.state.displacement, shared::kDisplacementBinding);
    bindState(body.state.previous, shared::kSweptBinding);
    bindState(body.state.corrections, shared::kSweepCorrectionsBinding);
    bindRecords(body.model.links, shared::kSweepLinksUnit, TexelFormat::uint32x4);
    bindAllConstraints(body.model.constraints, bindRecords);
}

}  // namespace kerf
