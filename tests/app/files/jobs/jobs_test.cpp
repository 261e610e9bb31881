#include "app/files/jobs/background_job.h"
#include "app/files/jobs/child_runs.h"
#include "app/files/jobs/progress_line.h"

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
    const fs::path program = folder / "program";
    writeText(program, "#!/bin/sh\necho a\nsleep 0.2\nprintf 'b\\nc\\nd'\n");
    fs::permissions(program, fs::perms::owner_all);
    const Variable chosen("KERF_EXECUTABLE", program);
    std::vector<int> counts;
    const ChildOutcome outcome = runChild({}, {}, [&](int count) { counts.push_back(count); });
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_THAT(counts, ElementsAre(1, 3)) << "a line without an end is none yet";
}

int alive = 0;

struct Job {
    explicit Job(bool& wasCancelled) : cancelled(&wasCancelled) { ++alive; }
    ~Job() { --alive; }
    Job(const Job&) = delete;
    Job& operator=(const Job&) = delete;
    void cancel() { *cancelled = true; }
    bool done() const { return ended; }

    bool* cancelled;
    bool ended = false;
};

TEST(CurrentJob, AnotherOneGivesUpTheOneBefore) {
    bool first = false;
    bool second = false;
    CurrentJob<Job> jobs;
    EXPECT_FALSE(jobs.cancel());
    jobs.start(std::make_unique<Job>(first));
    Job* const before = jobs.now();
    jobs.start(std::make_unique<Job>(second));
    EXPECT_TRUE(first);
    EXPECT_FALSE(second);
    jobs.forgetEnded();
    EXPECT_EQ(alive, 2) << "its thread still works";
    before->ended = true;
    jobs.forgetEnded();
    EXPECT_EQ(alive, 1);
}

TEST(CurrentJob, HandsOverWhatIsUnderWay) {
    bool cancelled = false;
    CurrentJob<Job> jobs;
    jobs.start(std::make_unique<Job>(cancelled));
    EXPECT_NE(jobs.take(), nullptr);
    EXPECT_EQ(jobs.now(), nullptr);
    EXPECT_FALSE(jobs.cancel());
    EXPECT_FALSE(cancelled);
}

TEST(ProgressText, TellsHowMuchIsDone) {
    EXPECT_EQ(progressText(0, 120, 0), "step 0 of 120 (0 %)");
    EXPECT_EQ(progressText(30, 120, 0.5), "step 30 of 120 (25 %)") << "no rate to go by yet";
    EXPECT_EQ(progressText(0, 120, 30), "step 0 of 120 (0 %)");
}

TEST(ProgressText, TellsWhatIsLeftByTheRateSoFar) {
    EXPECT_EQ(progressText(30, 120, 40), "step 30 of 120 (25 %), about 2 min left");
    EXPECT_EQ(progressText(60, 120, 33), "step 60 of 120 (50 %), about 35 s left");
    EXPECT_EQ(progressText(110, 120, 33), "step 110 of 120 (91 %), about 3 s left");
    EXPECT_EQ(progressText(12, 120, 600), "step 12 of 120 (10 %), about 90 min left");
}

}  // namespace
}  // namespace kerf::app
