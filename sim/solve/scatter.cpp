#include "sim/solve/scatter.h"

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
    writeBuffer_.assign(writes_);
    writeBuffer_.bindStorage(shared::kWritesBinding);
    target.bindStorageParts(
        shared::kWrittenBinding, sizeof(std::uint32_t), [&](std::size_t first, std::size_t count) {
            writePart(static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(count));
        });
}

void Scatter::writePart(std::uint32_t firstWord, std::uint32_t wordCount) {
    const auto isBelow = [](const shared::WordWrite& write, std::uint64_t word) {
        return write.word < word;
    };
    const auto begin =
        std::lower_bound(writes_.begin(), writes_.end(), std::uint64_t{firstWord}, isBelow);
    const auto end =
        std::lower_bound(begin, writes_.end(), std::uint64_t{firstWord} + wordCount, isBelow);
    if (begin == end) {
        return;
    }
    const auto count = static_cast<std::uint32_t>(end - begin);
    kernel_.setNumbers({static_cast<std::uint32_t>(begin - writes_.begin()), count, firstWord});
    kernel_.dispatch(count);
}

}  // namespace kerf
