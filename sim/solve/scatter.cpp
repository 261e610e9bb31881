#include "sim/solve/scatter.h"

#include <algorithm>
#include <cassert>

#include "shaders/shared/bindings.h"

namespace kerf {

Scatter::Scatter() : kernel_(gpu::Program::compute("sim/scatter.comp")) {}

std::vector<Scatter::Run> Scatter::findRuns(std::span<const std::uint32_t> indices,
                                            std::size_t widestGap) {
    std::vector<Run> runs;
    assert(std::is_sorted(indices.begin(), indices.end()));
    for (const std::uint32_t index : indices) {
        if (!runs.empty() && index <= runs.back().end + widestGap) {
            runs.back().end = index + 1;
        } else {
            runs.push_back({index, index + 1});
        }
    }
    return runs;
}

void Scatter::patch(gpu::Buffer& target) {
    const auto count = static_cast<std::uint32_t>(patches_.size());
    patchBuffer_.assign(patches_);
    patchBuffer_.bindStorage(shared::kPatchesBinding);
    target.bindStorage(shared::kPatchedBinding);
    kernel_.set("patchCount", count);
    kernel_.dispatch(count, shared::kGroupSize);
    gpu::storageBarrier();
}

}  // namespace kerf
