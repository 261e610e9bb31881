#pragma once

#include <cstring>

#include "gpu/buffer.h"
#include "gpu/program.h"
#include "shaders/shared/body_records.h"

namespace kerf {

/// Writes scattered elements of buffers: run by run if there are few, otherwise with one upload and
/// one dispatch.
class Scatter {
  public:
    /// Whether gaps between elements may be written, too.
    enum class Gaps { keep, fill };

    /// Compiles the kernel. Throws gpu::ShaderError.
    Scatter();

    /// Resizes `target` to that of `values`, with new elements zero, and writes the elements at
    /// `indices` (ascending) from `values`; the others must be there already. Throws
    /// gpu::OutOfMemory.
    template <class T>
    void write(gpu::Buffer& target, std::span<const T> values,
               std::span<const std::uint32_t> indices) {
        write<T>(target, values.size(), indices, Gaps::fill,
                 [&](std::uint32_t i) { return values[i]; });
    }

    /// Writes like the other write(), to a buffer of `count` elements, the values of
    /// valueOf(index): with Gaps::fill also some that are there already.
    template <class T, class ValueOf>
    void write(gpu::Buffer& target, std::size_t count, std::span<const std::uint32_t> indices,
               Gaps gaps, ValueOf&& valueOf);

  private:
    /// A call costs about as much as copying this many bytes; more calls than the limit below cost
    /// more than a dispatch.
    static constexpr std::size_t kGapBytes = 4096;
    static constexpr std::size_t kMostRuns = 64;

    struct Run {
        std::uint32_t first = 0;
        std::uint32_t end = 0;
    };
    static std::vector<Run> findRuns(std::span<const std::uint32_t> indices, std::size_t widestGap);
    template <class T>
    void addWrites(std::uint32_t index, const T& value);
    /// Executes the writes, in ascending order of words.
    void writeWords(gpu::Buffer& target);
    /// Executes those of them in the bound part of the target.
    void writePart(std::uint32_t firstWord, std::uint32_t wordCount);

    gpu::Program kernel_;
    gpu::Buffer writeBuffer_;
    std::vector<shared::WordWrite> writes_;
};

template <class T, class ValueOf>
void Scatter::write(gpu::Buffer& target, std::size_t count, std::span<const std::uint32_t> indices,
                    Gaps gaps, ValueOf&& valueOf) {
    target.resize(count * sizeof(T));
    const std::vector<Run> runs = findRuns(indices, gaps == Gaps::fill ? kGapBytes / sizeof(T) : 0);
    if (runs.size() > kMostRuns) {
        writes_.clear();
        for (const std::uint32_t index : indices) {
            addWrites<T>(index, valueOf(index));
        }
        writeWords(target);
        return;
    }
    std::vector<T> values;
    for (const Run& run : runs) {
        values.clear();
        for (std::uint32_t i = run.first; i < run.end; ++i) {
            values.push_back(valueOf(i));
        }
        target.write<T>(run.first, values);
    }
}

template <class T>
void Scatter::addWrites(std::uint32_t index, const T& value) {
    constexpr std::size_t kWordBytes = sizeof(std::uint32_t);
    static_assert(sizeof(T) % kWordBytes == 0);
    constexpr std::uint32_t kWords = sizeof(T) / kWordBytes;
    std::array<std::uint32_t, kWords> words;
    std::memcpy(words.data(), &value, sizeof(T));
    for (std::uint32_t k = 0; k < kWords; ++k) {
        writes_.push_back({kWords * index + k, words[k]});
    }
}

}  // namespace kerf
