#include "tests/support/fuzz_seed.h"

#include <cstdlib>
#include <iostream>

namespace kerf::test {

std::uint32_t fuzzSeed(std::uint32_t otherwise) {
    const char* text = std::getenv("KERF_FUZZ_SEED");
    const auto seed = text == nullptr ? otherwise : static_cast<std::uint32_t>(std::atol(text));
    std::cout << "seed " << seed << "\n";
    return seed;
}

}  // namespace kerf::test
