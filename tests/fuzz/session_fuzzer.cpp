// The entry of libFuzzer into the reader of sessions: scripts/fuzz.
#include <cstdlib>
#include <iostream>

#include "tests/support/session_fuzz.h"

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer names it
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    const std::string broken =
        kerf::test::brokenPromise(std::string(reinterpret_cast<const char*>(bytes), count));
    if (!broken.empty()) {
        std::cerr << broken << "\n";
        std::abort();
    }
    return 0;
}
