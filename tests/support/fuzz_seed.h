#pragma once

namespace kerf::test {

/// The seed of a random test: KERF_FUZZ_SEED, or `otherwise` where that is not set. Prints it, so
/// that a run can be repeated.
std::uint32_t fuzzSeed(std::uint32_t otherwise);

}  // namespace kerf::test
