#pragma once

namespace kerf::gpu {

/// Words that a kernel gets with a dispatch: the block of shaders/sim/base/numbers.glsl.
using DispatchNumbers = std::array<std::uint32_t, 4>;

/// The numbers of a program's dispatches, each combination once, in a buffer of which a dispatch
/// sees a part. A part is written once, before anything reads it, so that no driver can mix up the
/// numbers of dispatches.
class NumbersTable {
  public:
    NumbersTable() = default;
    ~NumbersTable();
    NumbersTable(const NumbersTable&) = delete;
    NumbersTable& operator=(const NumbersTable&) = delete;

    /// Selects what bind() binds from now on. Throws OutOfMemory.
    void choose(const DispatchNumbers& numbers);
    /// Binds the chosen numbers as that block; nothing before any were chosen.
    void bind() const;

  private:
    void begin();

    std::map<DispatchNumbers, std::size_t> places_;  ///< in the buffer [bytes]
    std::size_t stride_ = 0;                         ///< between two places [bytes]
    std::size_t chosen_ = 0;
    std::uint32_t buffer_ = 0;
};

}  // namespace kerf::gpu
