// The entry of libFuzzer into the readers of one format, which KERF_FUZZ_TARGET names:
// scripts/fuzz. Where KERF_FUZZ_ENDING is an extension of models, texts become files of that alone.
// KERF_FUZZ_TALLY names a file for what was counted.
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <iostream>

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

/// Of all processes of a run, those that crash too.
struct Tally {
    std::atomic<std::uint64_t> runs;
    std::atomic<std::uint64_t> read;
    std::atomic<std::uint64_t> judged;
};

Tally& sharedTally() {
    static Tally own{};
    const char* name = std::getenv("KERF_FUZZ_TALLY");
    const int file = name == nullptr ? -1 : ::open(name, O_RDWR | O_CREAT, 0666);
    if (file < 0 || ::ftruncate(file, sizeof(Tally)) != 0) {
        return own;
    }
    void* const shared =
        ::mmap(nullptr, sizeof(Tally), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    return shared == MAP_FAILED ? own : *static_cast<Tally*>(shared);
}

std::optional<std::uint8_t> chosenKind() {
    const char* ending = std::getenv("KERF_FUZZ_ENDING");
    const std::span endings = kerf::test::modelEndings();
    const auto found = std::ranges::find(endings, ending == nullptr ? "" : ending);
    return found == endings.end()
               ? std::nullopt
               : std::optional(static_cast<std::uint8_t>(found - endings.begin()));
}

/// Models that were read in this process. libFuzzer keeps whatever is new to it, and most of that
/// is refused.
std::vector<std::string>& modelsRead() {
    static std::vector<std::string> models;
    return models;
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer names it
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* bytes, std::size_t count, std::size_t most);

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer names it
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* bytes, std::size_t count,
                                               std::size_t most, unsigned seed) {
    static const std::optional<std::uint8_t> kind = chosenKind();
    const std::vector<std::string>& models = modelsRead();
    if (!models.empty() && seed % 2 == 0) {
        const std::string& model = models[seed / 2 % models.size()];
        count = std::min(model.size(), most);
        std::copy_n(model.begin(), count, bytes);
    }
    const std::size_t mutated = LLVMFuzzerMutate(bytes, count, most);
    if (kind && mutated > 0) {
        bytes[0] = *kind;
    }
    return mutated;
}

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer names it
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    static const kerf::test::FuzzTarget& target = chosenTarget();
    static Tally& tally = sharedTally();
    const kerf::test::FuzzOutcome outcome =
        target.read(std::string(reinterpret_cast<const char*>(bytes), count));
    constexpr std::size_t kMostKept = 1000;
    if (outcome.read && modelsRead().size() < kMostKept) {
        modelsRead().emplace_back(reinterpret_cast<const char*>(bytes), count);
    }
    ++tally.runs;
    tally.read += outcome.read ? 1 : 0;
    tally.judged += outcome.judged ? 1 : 0;
    if (!outcome.broken.empty()) {
        std::cerr << outcome.broken << "\n";
        std::abort();
    }
    return 0;
}
