// Where work may rest, and where not.
#include "sim/base/pausing.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace kerf {
namespace {

/// Asks while the stack is unwound.
struct Asking {
    std::string& answer;
    ~Asking() { answer = problemOfPause(); }
};

TEST(Pausing, IsDoneByWhoeverPausesThisThread) {
    int pauses = 0;
    pausePoint();
    {
        const Pauses pausing([&] { ++pauses; });
        pausePoint();
        EXPECT_EQ(problemOfPause(), "");
    }
    pausePoint();
    EXPECT_EQ(pauses, 1);
}

TEST(Pausing, IsRefusedWhileAnExceptionIsUnderWay) {
    const Pauses pausing([] {});
    std::string thrown;
    std::string handled;
    try {
        const Asking asking{thrown};
        throw std::runtime_error("no room");
    } catch (const std::runtime_error&) {
        handled = problemOfPause();
    }
    EXPECT_EQ(thrown, "an exception is under way");
    EXPECT_EQ(handled, "an exception is under way");
    EXPECT_EQ(problemOfPause(), "");
}

TEST(Pausing, IsRefusedWhereTheCheckSaysSo) {
    std::string left;
    const Pauses pausing([] {}, [&] { return left; });
    EXPECT_EQ(problemOfPause(), "");
    left = "a vertex array";
    EXPECT_EQ(problemOfPause(), "a vertex array");
}

TEST(Pausing, NobodyPausesNothingIsRefused) {
    std::string thrown = "?";
    try {
        const Asking asking{thrown};
        throw std::runtime_error("no room");
    } catch (const std::runtime_error&) {
        pausePoint();
    }
    EXPECT_EQ(thrown, "");
}

#ifndef NDEBUG
TEST(PausingDeathTest, APauseThatIsRefusedEndsTheProgramWhereAssertionsAreOn) {
    const Pauses pausing([] {}, [] { return "a vertex array"; });
    EXPECT_DEATH(pausePoint(), "no place to pause");
}
#endif

}  // namespace
}  // namespace kerf
