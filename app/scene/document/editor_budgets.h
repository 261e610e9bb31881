#pragma once

#include <cstdint>

namespace kerf::app {

/// The memory that undo may take in the editor [bytes].
inline constexpr std::uint64_t kUndoBudget = 512'000'000;
/// The memory that keyframes may take there, see Keyframes [bytes].
inline constexpr std::uint64_t kKeyframeBudget = 256'000'000;

}  // namespace kerf::app
