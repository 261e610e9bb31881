#include "app/files/jobs/child_runs.h"

#include <gmock/gmock.h>

#include "app/files/jobs/background_job.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/variable.h"

namespace kerf::app {
namespace {

ChildOutcome outcomeOf(int exitCode, int signal, const std::string& log) {
    ChildOutcome outcome;
    outcome.exitCode = exitCode;
    outcome.signal = signal;
    outcome.log = log;
    return outcome;
}

TEST(ChildRuns, TheEndOfAChildIsOneClause) {
    EXPECT_EQ(sentenceAbout(outcomeOf(0, 0, "")), "it ended with exit code 0");
    EXPECT_EQ(sentenceAbout(outcomeOf(3, 0, "info: cut\nkerf: the disk is full\n")),
              "it ended with exit code 3: the disk is full");
    EXPECT_EQ(sentenceAbout(outcomeOf(-1, 9, "")), "it was ended by signal 9");
}

TEST(ChildRuns, AFolderIsLeftOutOfWhatAChildSaid) {
    const auto outcome = outcomeOf(3, 0, "kerf: /a/b/x.ply and /a/b/y.ply differ\n");
    EXPECT_EQ(sentenceAbout(outcome, "/a/b"), "it ended with exit code 3: x.ply and y.ply differ");
}

TEST(ChildRuns, TheLinesOfAChildAreCountedAsTheyCome) {
    const test::TemporaryFolder folder;
    const std::filesystem::path program = folder / "program";
    test::writeText(program, "#!/bin/sh\necho a\nsleep 0.2\nprintf 'b\\nc\\nd'\n");
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    const test::Variable chosen("KERF_EXECUTABLE", program);
    std::vector<int> counts;
    const ChildOutcome outcome = runChild({}, {}, [&](int count) { counts.push_back(count); });
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_THAT(counts, testing::ElementsAre(1, 3)) << "a line without an end is none yet";
}

}  // namespace
}  // namespace kerf::app
