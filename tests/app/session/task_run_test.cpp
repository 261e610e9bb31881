// The clock of a hand, and the forces of its run.
#include "app/session/task_run.h"

#include <gmock/gmock.h>

#include "sim/run/parts/step_report.h"
#include "tests/support/session_samples.h"

namespace kerf::app {
namespace {

using ::testing::ElementsAre;
using ::testing::Field;

std::vector<double> timesOf(const std::string& events) {
    std::vector<double> times;
    const Session session = parseSession(
        test::sessionWith(R"("params": {"time_step": 0.01}, "events": [)" + events + "]"), "/");
    std::ranges::transform(handOf(session), std::back_inserter(times), &HandPose::time);
    return times;
}

std::string poseAt(int step, const std::string& more = "") {
    return R"({"step": )" + std::to_string(step) +
           R"(, "type": "blade", "a": [0, 0, 0], "b": [0, 0, 1])" + more + "}";
}
std::string event(int step, const std::string& type) {
    return R"({"step": )" + std::to_string(step) + R"(, "type": ")" + type + "\"}";
}

void expectTimes(const std::vector<double>& times, const std::vector<double>& wanted) {
    ASSERT_EQ(times.size(), wanted.size());
    for (std::size_t i = 0; i < times.size(); ++i) {
        EXPECT_NEAR(times[i], wanted[i], 1e-12) << i;
    }
}

TEST(TaskRun, AHandTakesTheTimeOfItsSteps) {
    expectTimes(timesOf(poseAt(2) + "," + poseAt(5) + "," + event(6, "lift") + "," + poseAt(9)),
                {0.02, 0.05, 0.06, 0.09});
}

TEST(TaskRun, AHandTakesTheSecondsThatItsPosesGive) {
    expectTimes(
        timesOf(poseAt(1) + "," + poseAt(3, R"(, "seconds": 0.5)") + "," + event(4, "lift") + "," +
                poseAt(7, R"(, "seconds": 2)") + "," + poseAt(8, R"(, "seconds": 0.1)")),
        {0.01, 1.01, 1.02, 3.02, 3.12});
}

TEST(TaskRun, AHandFollowsTheTimeStepAndARestart) {
    const std::string slower = R"({"step": 1, "type": "set", "name": "time_step", "value": 0.02})";
    expectTimes(timesOf(poseAt(0) + "," + slower + "," + poseAt(2)), {0, 0.03});
    expectTimes(timesOf(poseAt(0) + "," + poseAt(4) + "," + event(5, "restart") + "," + poseAt(6) +
                        "," + poseAt(7)),
                {0.06, 0.07});
}

TEST(TaskRun, PosesBeginStrokes) {
    const std::vector<HandPose> hand = handOf(parseSession(
        test::sessionWith(R"("events": [)" + poseAt(0) + "," + poseAt(1) + "," + event(2, "lift") +
                          "," + poseAt(3) + "," + event(4, "undo") + "," + poseAt(5) + "]"),
        "/"));
    EXPECT_THAT(hand, ElementsAre(Field(&HandPose::begins, true), Field(&HandPose::begins, false),
                                  Field(&HandPose::begins, false), Field(&HandPose::begins, true),
                                  Field(&HandPose::begins, true)));
}

TEST(TaskRun, AStepThatRunsAgainReplacesItsForceAndWhatCameLater) {
    ForceTrace trace;
    for (const int step : {0, 1, 2, 3, 2}) {
        StepReport report;
        report.step = step;
        report.time = 0.01 * (step + 1);
        report.bladeLoad = BladeLoad{Vec3(step, 0, 0), Vec3::Zero()};
        trace.add(report, 0.01);
    }
    ASSERT_EQ(trace.samples().size(), 3U);
    EXPECT_NEAR(trace.samples().back().begin, 0.02, 1e-12);
    EXPECT_EQ(trace.samples().back().force.x(), 2);
    StepReport restarted;
    restarted.step = 0;
    trace.add(restarted, 0.01);
    EXPECT_TRUE(trace.samples().empty());
}

}  // namespace
}  // namespace kerf::app
