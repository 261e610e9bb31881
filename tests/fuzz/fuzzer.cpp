// The entry of libFuzzer into the readers of one format, which KERF_FUZZ_TARGET names:
// scripts/fuzz.
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>

#include "tests/support/fuzz/fuzz_target.h"
#include "tests/support/fuzz/targets.h"

namespace {

const kerf::test::FuzzTarget& chosenTarget() {
    const char* name = std::getenv("KERF_FUZZ_TARGET");
    const auto* target = kerf::test::findFuzzTarget(name == nullptr ? "" : name);
    if (target == nullptr) {
        std::cerr << "KERF_FUZZ_TARGET names no target; there are:\n";
        for (const auto& each : kerf::test::fuzzTargets()) {
            std::cerr << each.name << "\n";
        }
        std::exit(2);
    }
    kerf::test::readModelsInThisProcess();
    return *target;
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer names it
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    static const kerf::test::FuzzTarget& target = chosenTarget();
    const std::string broken =
        target.read(std::string(reinterpret_cast<const char*>(bytes), count)).broken;
    if (!broken.empty()) {
        std::cerr << broken << "\n";
        std::abort();
    }
    return 0;
}
