#include "app/files/jobs/progress_line.h"

#include <gtest/gtest.h>

namespace kerf::app {
namespace {

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
