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

void Scatter::writeWords(gpu::Buffer& target) {
    const auto count = static_cast<std::uint32_t>(writes_.size());
    writeBuffer_.assign(writes_);
    writeBuffer_.bindStorage(shared::kWritesBinding);
    target.bindStorage(shared::kWrittenBinding);
    kernel_.set("writeCount", count);
    kernel_.dispatch(count, shared::kGroupSize);
    gpu::storageBarrier();
}

}  // namespace kerf
