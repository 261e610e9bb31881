#include "app/files/child_runs.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace kerf::app
