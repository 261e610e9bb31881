#include <gtest/gtest.h>

#include "app/files/jobs/background_job.h"

namespace kerf::app {
namespace {

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

}  // namespace
}  // namespace kerf::app
