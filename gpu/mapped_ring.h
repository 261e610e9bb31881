#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace kerf::gpu {

/// A few slots of mapped memory where kernels leave small results for the CPU, which then reads
/// them without a copy and waits for no more than the kernels that wrote the slot. Any number of
/// slots may be on their way at once; a slot is written again kSlots turns later.
class MappedRing {
  public:
    static constexpr int kSlots = 3;

    MappedRing() = default;
    ~MappedRing();
    MappedRing(const MappedRing&) = delete;
    MappedRing& operator=(const MappedRing&) = delete;

    /// Room for `bytes` in each slot. Where there is less, a new ring of zero bits takes the place
    /// of this one (half as large again): what slots hold is gone, and so is what spans show.
    /// Throws OutOfMemory, the ring then unchanged.
    void reserve(std::size_t bytes);

    /// Turns to the next slot, binds it as shader storage to `binding` and returns its number. What
    /// it held stays until kernels overwrite it.
    int bindNext(std::uint32_t binding);
    /// Starts the kernels that write this slot, which were told before: the CPU may wait for them.
    void fence();

    /// The first `count` elements of a slot that was fenced; waits for the GPU until they are
    /// there. They stay until the slot is bound again or the ring grows.
    template <class T>
    std::span<const T> read(int slot, std::size_t count) const {
        return {reinterpret_cast<const T*>(awaited(slot, count * sizeof(T))), count};
    }

    std::size_t capacity() const { return capacity_; }  ///< of a slot [bytes]

  private:
    const std::byte* awaited(int slot, std::size_t bytes) const;
    void dropFence(int slot);
    void release();

    std::uint32_t id_ = 0;
    const std::byte* memory_ = nullptr;
    std::size_t capacity_ = 0;
    std::size_t stride_ = 0;              ///< from slot to slot [bytes]
    int slot_ = kSlots - 1;               ///< bound last
    std::array<void*, kSlots> fences_{};  ///< GLsync of each slot; null before its first turn
};

}  // namespace kerf::gpu
