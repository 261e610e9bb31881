#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "gpu/buffer.h"

namespace kerf::gpu {

/// Results of kernels on their way to the CPU: asked for one by one, sent together into memory that
/// stays mapped, and waited for once, by whoever reads first. Until then the CPU is free. A mark
/// follows what is sent: a driver whose fence tells too early is waited for again.
class ReadBack {
  public:
    ReadBack() = default;
    ~ReadBack();
    ReadBack(const ReadBack&) = delete;
    ReadBack& operator=(const ReadBack&) = delete;

    /// Has the coming send() take the first `bytes` of a buffer, which lives until then. Returns
    /// the place of what was asked for.
    std::size_t ask(const Buffer& from, std::size_t bytes);
    /// Copies on the GPU what was asked for since the last time, as the kernels told so far leave
    /// it. What was sent before is gone then. Throws OutOfMemory; nothing is asked for then.
    void send();

    /// `count` elements of what was asked for, as sent last; waits for the GPU the first time.
    /// They stay until the next send(). Throws std::runtime_error where they never come.
    template <class T>
    std::span<const T> read(std::size_t place, std::size_t count) const {
        return {reinterpret_cast<const T*>(awaited(place, count * sizeof(T))), count};
    }

  private:
    struct Part {
        std::uint32_t buffer = 0;
        std::size_t place = 0;
        std::size_t bytes = 0;
    };
    const std::byte* awaited(std::size_t place, std::size_t bytes) const;
    void reserve(std::size_t bytes);
    void mark();
    bool isMarked() const;
    void wait() const;
    void waitForMark() const;
    void dropFence() const;
    void release();

    std::vector<Part> parts_;  ///< of the coming send()
    std::size_t asked_ = 0;    ///< room that they need [bytes]
    std::uint32_t id_ = 0;
    const std::byte* memory_ = nullptr;
    std::size_t capacity_ = 0;       ///< [bytes]
    mutable void* fence_ = nullptr;  ///< GLsync of what was sent; null once it is there
    std::size_t markPlace_ = 0;      ///< behind what was sent
    std::uint32_t serial_ = 0;       ///< of the send(), which its mark bears
};

}  // namespace kerf::gpu
