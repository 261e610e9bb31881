// Steps that are due by the clock.
#include "app/editor/steps/scene_at_work.h"
#include "app/editor/steps/step_clock.h"
#include "app/editor/view/input_queue.h"
#include "app/editor/view/redraw.h"
#include "sim/base/pausing.h"

namespace kerf::app {
namespace {

constexpr double kTimeStep = 0.005;
constexpr double kPicture = 0.011;  // [s]

TEST(StepClock, TimeThatStoodIsNotCaughtUpWith) {
    StepClock clock(true, 1);
    clock.elapse(10);
    clock.stop();
    clock.elapse(kPicture);
    clock.passTime(kTimeStep);
    EXPECT_EQ(clock.due(), 2);
}

TEST(StepClock, MoreThanATenthOfASecondIsNotCaughtUpWith) {
    for (const double step : {0.001, kTimeStep, 0.02}) {
        StepClock clock(true, 1);
        clock.elapse(10);
        clock.passTime(step);
        EXPECT_NEAR(clock.due() * step, 0.1, 1.01 * step)
            << "a small step is no reason to fall behind";
    }
}

TEST(StepClock, FasterTimeIsDueSooner) {
    StepClock clock(true, 1);
    clock.setSpeed(4);
    clock.elapse(kPicture);
    clock.passTime(kTimeStep);
    EXPECT_EQ(clock.due(), 8);
}

TEST(StepClock, APauseIsNoFrameTime) {
    StepClock clock(true, 1);
    EXPECT_TRUE(clock.starts());
    EXPECT_EQ(clock.measure().all, 0);
    clock.elapse(kPicture);
    EXPECT_EQ(clock.measure().all, kPicture);
    clock.elapse(1);
    clock.stop();
    clock.elapse(kPicture);
    EXPECT_EQ(clock.measure().all, 0);
}

constexpr double kAll = 1000;

TEST(TimeLeft, IsUnknownBeforeThereIsARate) {
    TimeLeft left;
    EXPECT_FALSE(left.at(0, 0, kAll));
    EXPECT_FALSE(left.at(1, 0, kAll));
    EXPECT_FALSE(left.at(2, 7, 0)) << "without an end";
}

TEST(TimeLeft, OfASteadyRateRunsDownWithTheClock) {
    TimeLeft left;
    left.at(0, 0, kAll);
    for (int second = 1; second < 100; ++second) {
        EXPECT_NEAR(left.at(second, 10 * second, kAll).value(), 100 - second, 1);
    }
}

// It was taken from the last step alone: 35 s, 7 s, 194 s, 14 s in a row.
TEST(TimeLeft, DoesNotJumpWhereStepsTakeUnlikeTimes) {
    TimeLeft left;
    double now = 0;
    left.at(now, 0, kAll);
    std::optional<double> before;
    for (int step = 1; step <= 600; ++step) {
        now += step % 10 == 0 ? 0.5 : 0.05;
        const std::optional<double> shown = left.at(now, step, kAll);
        if (before && now > 3) {
            EXPECT_LT(std::abs(*shown - *before), 5) << step;
        }
        before = shown;
    }
    EXPECT_NEAR(*before, 0.095 * 400, 8);
}

TEST(TimeLeft, FollowsALongStepByTheClock) {
    TimeLeft left;
    left.at(0, 0, 10);
    left.at(40, 1, 10);
    const double then = left.at(80, 2, 10).value();
    EXPECT_NEAR(left.at(90, 2, 10).value(), then - 10, 5);
}

TEST(TimeLeft, BeginsAnewWithOtherWork) {
    TimeLeft left;
    ui::WorkState work{.title = "Cutting", .stage = "", .done = 1, .all = 2};
    left.follow(work);
    work.done = 2;
    left.follow(work);
    EXPECT_TRUE(work.left);
    work.title = "Exporting";
    left.follow(work);
    EXPECT_FALSE(work.left);
}

TEST(TimeText, SaysWhatItIs) {
    const auto text = [](std::optional<double> left) {
        ui::WorkState work{.title = "", .stage = "", .seconds = 12.2};
        work.left = left;
        return timeText(work);
    };
    EXPECT_EQ(text(std::nullopt), ", 12 s so far");
    EXPECT_EQ(text(18.2), ", about 20 s left");
    EXPECT_EQ(text(3.2), ", about 4 s left");
    EXPECT_EQ(text(0.4), ", almost done");
    EXPECT_EQ(text(200), ", about 3 min left");
}

Redraw drawn() {
    Redraw redraw(true);
    redraw.takeScene();
    while (redraw.pending()) {
        redraw.countUpdate(true);
    }
    return redraw;
}

TEST(Redraw, AtFirstAllIsDrawn) {
    Redraw redraw(true);
    EXPECT_TRUE(redraw.takeScene());
    EXPECT_TRUE(redraw.pending()) << "the panels";
    EXPECT_FALSE(drawn().takeScene());
}

TEST(Redraw, PanelsSettleInTwoQuietUpdates) {
    Redraw redraw = drawn();
    redraw.panels();
    redraw.countUpdate(true);
    EXPECT_TRUE(redraw.pending());
    redraw.countUpdate(false);  // something was said or done meanwhile
    redraw.countUpdate(true);
    EXPECT_TRUE(redraw.pending());
    redraw.countUpdate(true);
    EXPECT_FALSE(redraw.pending());
    EXPECT_FALSE(redraw.takeScene());
}

TEST(Redraw, ASceneThatChangedIsShownByThePanelsToo) {
    Redraw redraw = drawn();
    redraw.scene();
    EXPECT_TRUE(redraw.takeScene());
    EXPECT_FALSE(redraw.takeScene());
    EXPECT_TRUE(redraw.pending());
}

TEST(Redraw, StepsWaitUntilTheyAreToBeShown) {
    Redraw redraw = drawn();
    redraw.steps();
    EXPECT_TRUE(redraw.stepsPending());
    EXPECT_FALSE(redraw.pending()) << "the panels are drawn with them";
    EXPECT_FALSE(redraw.takeScene(false));
    EXPECT_FALSE(redraw.takeShown());
    EXPECT_TRUE(redraw.takeScene(true));
    EXPECT_FALSE(redraw.stepsPending());
    EXPECT_TRUE(redraw.takeShown());
    EXPECT_FALSE(redraw.takeShown());
    redraw.steps();
    redraw.scene();
    EXPECT_TRUE(redraw.takeScene(false)) << "what else has changed shows at once, and they with it";
    EXPECT_FALSE(redraw.stepsPending());
}

TEST(Redraw, WhatIsPutOffIsPendingNoMoreAndDrawnOnceItIsAskedFor) {
    Redraw redraw = drawn();
    redraw.steps();
    redraw.putOff();
    redraw.putOff();
    EXPECT_FALSE(redraw.stepsPending());
    EXPECT_TRUE(redraw.takeScene());
    EXPECT_FALSE(redraw.takeScene());
}

using ui::Button;
using ui::ButtonChange;
using ui::InputEvent;
using ui::Key;
using ui::KeyChange;
using ui::PointerMove;
using ui::Wheel;

const InputEvent kMove = PointerMove{1, 2, {}};
const InputEvent kDown = ButtonChange{Button::left, true, {}};
const InputEvent kUp = ButtonChange{Button::left, false, {}};

InputEvent key(Key k, bool down) {
    return KeyChange{k, down, {}};
}

std::vector<std::size_t> batchSizes(const std::vector<InputEvent>& events) {
    InputQueue queue;
    for (const InputEvent& event : events) {
        queue.push(event);
    }
    std::vector<std::size_t> sizes;
    while (!queue.empty()) {
        sizes.push_back(queue.takeBatch().size());
    }
    return sizes;
}

TEST(InputQueue, TakesInABatchWhatDoesNotDependOnAPictureBetween) {
    using Events = std::vector<InputEvent>;
    const InputEvent wheel = Wheel{0, 1};
    const InputEvent a = key(Key::a, true);
    const InputEvent aUp = key(Key::a, false);
    const InputEvent b = key(Key::b, true);
    for (const auto& [name, events, sizes] :
         std::vector<std::tuple<const char*, Events, std::vector<std::size_t>>>{
             {"moves", {kMove, kMove, kMove}, {3}},
             {"buttons", {kMove, kDown, kMove, kMove, kUp, kMove}, {1, 1, 2, 1, 1}},
             {"a fast click", {kDown, kUp, kDown, kUp}, {1, 1, 1, 1}},
             {"the wheel", {kMove, wheel, wheel, kDown}, {3, 1}},
             {"a key down and up", {a, aUp}, {1, 1}},
             {"a key up, another down", {aUp, b, kMove}, {3}},
             {"two keys down", {a, b, kMove}, {1, 2}},
             {"a lost focus", {kMove, ui::FocusLost{}, kMove}, {1, 1, 1}}}) {
        EXPECT_EQ(batchSizes(events), sizes) << name;
    }
}

TEST(InputQueue, NothingIsLostAndTheOrderIsKept) {
    const unsigned seed = 7;
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    InputQueue queue;
    for (int i = 0; i < 1000; ++i) {
        // The x of moves and the code of characters number the events.
        switch (random() % 3) {
            case 0:
                queue.push(PointerMove{double(i), 0, {}});
                break;
            case 1:
                queue.push(ButtonChange{Button::left, i % 2 == 0, {}});
                break;
            default:
                queue.push(ui::Character{static_cast<std::uint32_t>(i)});
        }
    }
    std::size_t taken = 0;
    double last = -1;
    while (!queue.empty()) {
        const std::vector<InputEvent> batch = queue.takeBatch();
        ASSERT_FALSE(batch.empty());
        int moves = 0;
        int buttons = 0;
        for (const InputEvent& event : batch) {
            if (const auto* move = std::get_if<PointerMove>(&event)) {
                ASSERT_GT(move->x, last);
                last = move->x;
                ++moves;
            } else if (const auto* typed = std::get_if<ui::Character>(&event)) {
                ASSERT_GT(typed->code, last);
                last = typed->code;
            } else {
                ++buttons;
            }
        }
        ASSERT_TRUE(buttons == 0 || (buttons == 1 && moves == 0));
        taken += batch.size();
    }
    EXPECT_EQ(taken, 1000U);
}

// Work that rests between two portions, on a stack of its own.

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
    EXPECT_THAT(done, ElementsAre(0, 1, 2));
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
