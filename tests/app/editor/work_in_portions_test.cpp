// Work that rests between two portions, on a stack of its own.
#include <gmock/gmock.h>

#include <stdexcept>

#include "app/editor/steps/scene_at_work.h"
#include "sim/base/pausing.h"

namespace kerf::app {
namespace {

TEST(WorkInPortions, RestsAtPausePointsAndGoesOnWhereItWas) {
    std::vector<int> done;
    WorkInPortions work;
    work.begin([&] {
        for (int i = 0; i < 3; ++i) {
            done.push_back(i);
            pausePoint();
        }
    });
    EXPECT_TRUE(work.underWay());
    EXPECT_TRUE(done.empty()) << "nothing is done before goOn()";
    for (int i = 1; i <= 3; ++i) {
        work.goOn(0);
        EXPECT_EQ(done.size(), i);
        EXPECT_TRUE(work.underWay());
        EXPECT_FALSE(work.isWorking());
    }
    work.goOn(0);
    EXPECT_FALSE(work.underWay());
    EXPECT_THAT(done, testing::ElementsAre(0, 1, 2));
}

TEST(WorkInPortions, GoesOnToItsEndWhereThereIsTime) {
    int done = 0;
    WorkInPortions work;
    const auto count = [&] {
        for (int i = 0; i < 100; ++i) {
            ++done;
            pausePoint();
        }
    };
    work.begin(count);
    work.goOn(0);
    EXPECT_EQ(done, 1);
    work.finish();
    EXPECT_EQ(done, 100);
    work.begin(count);
    work.goOn(60);
    EXPECT_EQ(done, 200);
    EXPECT_FALSE(work.underWay());
}

TEST(WorkInPortions, ThrowsWhereItGoesOnWhatTheWorkThrows) {
    WorkInPortions work;
    work.begin([] {
        pausePoint();
        throw std::runtime_error("no room");
    });
    work.goOn(0);
    EXPECT_THROW(work.goOn(0), std::runtime_error);
    EXPECT_FALSE(work.underWay());
    EXPECT_FALSE(work.isWorking());
    bool done = false;
    work.begin([&] { done = true; });
    work.finish();
    EXPECT_TRUE(done);
}

TEST(WorkInPortions, UnwindsItsStackWhereItIsGivenUp) {
    struct Mark {
        bool& gone;
        ~Mark() { gone = true; }
    };
    bool gone = false;
    bool wentOn = false;
    {
        WorkInPortions work;
        work.begin([&] {
            const Mark mark{gone};
            pausePoint();
            wentOn = true;
        });
        work.goOn(0);
        EXPECT_FALSE(gone);
    }
    EXPECT_TRUE(gone);
    EXPECT_FALSE(wentOn);
}

TEST(WorkInPortions, IsNotPausedByWhatOthersDoMeanwhile) {
    WorkInPortions work;
    work.begin([] { pausePoint(); });
    work.goOn(0);
    pausePoint();  // of another body that is drawn meanwhile: nobody rests
    EXPECT_TRUE(work.underWay());
    EXPECT_FALSE(work.isWorking());
    work.finish();
    EXPECT_FALSE(work.underWay());
}

TEST(WorkInPortions, AsksItsCheckAtAPause) {
    std::string problem;
    WorkInPortions work([] { return "a vertex array"; });
    work.begin([&] { problem = problemOfPause(); });
    work.finish();
    EXPECT_EQ(problem, "a vertex array");
    EXPECT_EQ(problemOfPause(), "") << "nobody pauses this thread now";
}

TEST(WorkInPortions, LeavesTheTimeOfItsPausesOutOfWhatItTook) {
    double took = 0;
    WorkInPortions work;
    work.begin([&] {
        const WorkWatch watch;
        pausePoint();
        took = watch.seconds();
    });
    work.goOn(0);
    const Stopwatch pause;
    while (pause.seconds() < 0.05) {
    }
    work.finish();
    EXPECT_LT(took, 0.04);
}

}  // namespace
}  // namespace kerf::app
