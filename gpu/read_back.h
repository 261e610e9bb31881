#pragma once

#include "gpu/buffer.h"

namespace kerf::gpu {

/// Asynchronous read-back of kernel results: requested one by one, copied together into mapped
/// memory, and waited for once, by the first read. Until then the CPU is free. A mark follows the
/// data, for drivers whose fence signals too early.
class ReadBack {
  public:
    ReadBack() = default;
    ~ReadBack();
    ReadBack(const ReadBack&) = delete;
    ReadBack& operator=(const ReadBack&) = delete;

    /// Requests the first `bytes` of a buffer, which must live until send(). Returns their place.
    std::size_t ask(const Buffer& from, std::size_t bytes);
    /// Copies the requested data on the GPU, after all kernels so far. Earlier data is lost. Throws
    /// OutOfMemory, and drops the requests.
    void send();

    /// `count` elements of a request in the last send(); waits for the GPU the first time. They
    /// stay until the next send(). Throws std::runtime_error if they never arrive.
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
    mutable void* fence_ = nullptr;  ///< GLsync of the data; null once it has arrived
    Buffer markSource_;
    std::size_t markPlace_ = 0;  ///< after the data
    std::uint32_t serial_ = 0;   ///< of the send(), which its mark bears
};

}  // namespace kerf::gpu
