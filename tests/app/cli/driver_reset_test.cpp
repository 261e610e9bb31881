// A reset of the graphics driver without a window; with one: tests/app/window/editor_kill_test.cpp.
#include <gmock/gmock.h>

#include "tests/support/run_kerf.h"
#include "tests/support/small_sessions.h"
#include "tests/support/temporary_folder.h"

namespace kerf {
namespace {

TEST(DriverReset, EndsAReplayWithASentence) {
    const test::TemporaryFolder folder;
    test::writeText(folder / "test.kerf.json", test::smallSession());
    test::writeText(folder / "lose", "");
    const test::ProgramRun run =
        test::runKerf({"replay", folder / "test.kerf.json", "--out", folder / "out"},
                      {{"KERF_LOSE_CONTEXT", (folder / "lose").string()}});
    EXPECT_EQ(run.exitCode, 4);
    EXPECT_THAT(run.errors, testing::HasSubstr("The graphics driver was reset"));
    EXPECT_FALSE(std::filesystem::exists(folder / "out" / "summary.json"));
}

}  // namespace
}  // namespace kerf
