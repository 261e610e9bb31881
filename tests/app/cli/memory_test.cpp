// What the verbs say of memory, and what they do where it does not do.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "tests/support/run_kerf.h"
#include "tests/support/temporary_folder.h"

namespace kerf {
namespace {

using test::ProgramRun;
using test::runKerf;
using ::testing::HasSubstr;

class Memory : public ::testing::Test {
  protected:
    void SetUp() override {
        test::writeText(folder / "fall.kerf.json",
                        R"({"format": "kerf-session", "version": 1,
                            "model": {"builtin": "sphere768"}, "params": {"floor": -0.6},
                            "steps": 2, "events": []})");
    }
    ProgramRun replay(const std::map<std::string, std::string>& environment) const {
        return runKerf({"replay", folder / "fall.kerf.json", "--out", folder / "out"}, environment);
    }

    test::TemporaryFolder folder;
};

TEST_F(Memory, InspectTellsWhatAModelNeeds) {
    const ProgramRun run = runKerf({"inspect", "banana"});
    EXPECT_EQ(run.exitCode, 0) << run.errors;
    EXPECT_THAT(run.out, HasSubstr("memory     about"));
    const auto bytes = [](const std::string& model) {
        return nlohmann::json::parse(
            runKerf({"inspect", model, "--json"}, {{"KERF_MEMORY_BYTES", "123000000"}})
                .out)["memory_bytes"];
    };
    const auto banana = bytes("banana");
    EXPECT_EQ(banana["free"], 123'000'000);
    EXPECT_GT(banana["needed"], bytes("sphere20")["needed"]);
    EXPECT_GT(banana["graphics"], bytes("sphere20")["graphics"]);
}

TEST_F(Memory, AReplayBeyondTheMeansIsRefusedBeforeItBegins) {
    for (const char* bytes : {"0", "1000000", "200000000"}) {
        const ProgramRun run = replay({{"KERF_MEMORY_BYTES", bytes}});
        EXPECT_EQ(run.exitCode, 5) << bytes << ": " << run.errors;
        EXPECT_THAT(run.errors, HasSubstr("cutting it needs about"));
        EXPECT_THAT(run.errors, HasSubstr("--remesh"));
        EXPECT_EQ(std::ranges::count(run.errors, '\n'), 1) << run.errors;
        EXPECT_FALSE(std::filesystem::exists(folder / "out" / "summary.json"));
    }
    EXPECT_EQ(replay({{"KERF_MEMORY_BYTES", "20000000000"}}).exitCode, 0);
}

/// Whatever the limit is, a run ends well or with one sentence, and never by a signal.
TEST_F(Memory, NoLimitOfTheProcessEndsInACrash) {
    for (const std::uint64_t megabytes : {400, 700, 1000, 1400, 2000, 4000}) {
        const ProgramRun run = runKerf(
            {"replay", folder / "fall.kerf.json", "--out", folder / std::to_string(megabytes)}, {},
            megabytes << 20);
        EXPECT_TRUE(run.exitCode == 0 || run.exitCode == 5)
            << megabytes << " MB: " << run.exitCode << " " << run.errors;
        EXPECT_EQ(run.errors.empty(), run.exitCode == 0) << run.errors;
    }
}

}  // namespace
}  // namespace kerf
