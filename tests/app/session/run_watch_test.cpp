// The clock of a hand, and the forces of its run.
#include "app/session/hash_trace.h"
#include "app/session/real_time_factor.h"
#include "app/session/task_run.h"
#include "app/session/volume_watch.h"
#include "sim/run/parts/step_report.h"

namespace kerf::app {
namespace {

using ::testing::Field;

std::vector<double> timesOf(const std::string& events) {
    std::vector<double> times;
    const Session session = parseSession(
        sessionWith(R"("params": {"time_step": 0.01}, "events": [)" + events + "]"), "/");
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
        sessionWith(R"("events": [)" + poseAt(0) + "," + poseAt(1) + "," + event(2, "lift") + "," +
                    poseAt(3) + "," + event(4, "undo") + "," + poseAt(5) + "]"),
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

const std::string kA = "aaaaaaaaaaaaaaaa";
const std::string kB = "bbbbbbbbbbbbbbbb";
const std::string kC = "cccccccccccccccc";

class HashTraceTest : public testing::Test {
  protected:
    HashTrace read(const std::string& text) const {
        writeText(folder_ / "hashes.csv", text);
        return HashTrace::read(folder_ / "hashes.csv");
    }

    test::TemporaryFolder folder_;
};

StateHashes hashesOf(const std::string& state, const std::string& part) {
    StateHashes hashes{state, {}};
    hashes.parts.fill(part);
    return hashes;
}

TEST_F(HashTraceTest, ReadsWhatWasWritten) {
    const HashTrace trace = read(hashesHeader() + formatHashes(0, hashesOf(kA, kB)) +
                                 formatHashes(1, hashesOf(kB, kC)));
    ASSERT_EQ(trace.steps(), 2);
    EXPECT_EQ(trace.stateHash(0), kA);
    EXPECT_TRUE(trace.differingParts(1, hashesOf(kB, kC)).empty());
    StateHashes other = hashesOf(kA, kC);
    other.parts[static_cast<std::size_t>(StatePart::velocities)] = kA;
    EXPECT_EQ(trace.differingParts(1, other), std::vector<std::string>{"velocities"});
}

TEST_F(HashTraceTest, NamesWhatAFileDoesNotHoldWhereTheStateAloneDiffers) {
    const HashTrace trace =
        read("step,state_hash,topology_hash,positions_hash\n0," + kA + "," + kB + "," + kB + "\n");
    EXPECT_EQ(trace.differingParts(0, hashesOf(kC, kB)),
              std::vector<std::string>{"velocities or boxes"});
    EXPECT_TRUE(trace.differingParts(0, hashesOf(kA, kB)).empty());
}

TEST_F(HashTraceTest, NamesTheStateWhereAFileHoldsAllPartsAndTheyAgree) {
    const HashTrace trace = read(hashesHeader() + formatHashes(0, hashesOf(kA, kB)));
    EXPECT_EQ(trace.differingParts(0, hashesOf(kC, kB)), std::vector<std::string>{"the state"});
}

TEST_F(HashTraceTest, StepsComeInOrderAndHashesHaveSixteenDigits) {
    EXPECT_THROW(read(hashesHeader() + formatHashes(1, hashesOf(kA, kB))), InputError);
    EXPECT_THROW(read(hashesHeader() + formatHashes(0, hashesOf("abc", kB))), InputError);
    EXPECT_THROW(read("step,state_hash\n0," + kA + "\n"), InputError) << "no topology";
}

Piece pieceOf(double volume, double restVolume) {
    return {100, 52, volume, restVolume, 1};
}

TEST(VolumeWatch, NamesTheFirstStepInWhichTheBodyTurned) {
    VolumeWatch watch;
    EXPECT_FALSE(watch.add(0, {pieceOf(2, 2)}));
    EXPECT_FALSE(watch.add(1, {pieceOf(0.1, 2)}));
    EXPECT_EQ(watch.sentence(), "") << "thin is not lost";
    EXPECT_TRUE(watch.add(2, {pieceOf(-0.1, 2)}));
    EXPECT_EQ(watch.sentence().find("so in"), std::string::npos) << "one step says it all";
    EXPECT_FALSE(watch.add(3, {pieceOf(-0.4, 2)})) << "told already";
    const std::string sentence = watch.sentence();
    EXPECT_TRUE(
        sentence.starts_with("Step 2: the body turned inside out, with -5.0 % of its volume"))
        << sentence;
    EXPECT_TRUE(sentence.ends_with(" It was so in 2 steps.")) << sentence;
}

TEST(VolumeWatch, FlatIsToldAndInsideOutAfterIt) {
    VolumeWatch watch;
    EXPECT_TRUE(watch.add(1, {pieceOf(0.0002, 2)}));
    EXPECT_TRUE(
        watch.sentence().starts_with("Step 1: the body was pressed flat, with 0.0 % of its volume"))
        << watch.sentence();
    EXPECT_FALSE(watch.add(2, {pieceOf(0.0001, 2)}));
    EXPECT_TRUE(watch.add(3, {pieceOf(-0.1, 2)}));
    EXPECT_TRUE(watch.sentence().starts_with("Step 3: the body turned inside out"));
}

TEST(VolumeWatch, APieceCountsWhereTheSumHidesItAndDebrisDoesNot) {
    VolumeWatch watch;
    EXPECT_FALSE(watch.add(0, {pieceOf(1, 1), pieceOf(-1e-6, 1e-5)}));
    EXPECT_EQ(watch.sentence(), "");
    EXPECT_TRUE(watch.add(1, {pieceOf(1, 1), pieceOf(-0.25, 1)}));
    EXPECT_TRUE(watch.sentence().starts_with("Step 1: a piece turned inside out, with -25.0 %"));
}

using ::testing::Optional;

TEST(RealTimeFactor, IsSimulatedTimeOverThatOfTheClock) {
    EXPECT_THAT(realTimeFactor(0.005, 5), Optional(1.0));
    EXPECT_THAT(realTimeFactor(0.005, 50), Optional(0.1));
    EXPECT_EQ(realTimeFactor(0, 5), std::nullopt) << "time is paused";
    EXPECT_EQ(realTimeFactor(0.005, 0), std::nullopt);
}

TEST(RealTimeFactor, HasTwoDigits) {
    EXPECT_EQ(factorText(0.03728), "0.037x");
    EXPECT_EQ(factorText(1), "1x");
    EXPECT_EQ(factorText(123.4), "123x");
}

TEST(RealTimeFactor, OfARunHasTheMiddleAndTheWorstStep) {
    RealTimeFactors factors;
    for (const double ms : {10.0, 40.0, 20.0}) factors.add(0.01, ms, 0);
    factors.add(0, 1000, 1000);
    EXPECT_THAT(factors.median(), Optional(0.5));
    EXPECT_THAT(factors.worst(), Optional(0.25));
    EXPECT_THAT(factors.withDrawing(), Optional(testing::DoubleEq(0.03 / 0.07)))
        << "a pause does not count, nor does what is drawn in it";
    EXPECT_EQ(factors.sentence(),
              "0.03 s simulated in 0.07 s, 0.43x real time (slowest step 0.25x)");
    factors.add(0.01, 10, 80);
    EXPECT_THAT(factors.withDrawing(), Optional(testing::DoubleEq(0.04 / 0.16)));
    EXPECT_THAT(factors.sentence(), HasSubstr("0.25x with pictures"));
    EXPECT_EQ(toJson(factors)["worst"], 0.25);
}

TEST(RealTimeFactor, IsNoneWhereNoTimePassed) {
    RealTimeFactors factors;
    factors.add(0, 10, 10);
    const auto written = toJson(factors);
    for (const char* key : {"median", "worst", "with_drawing"}) {
        EXPECT_TRUE(written.at(key).is_null()) << key;
    }
    EXPECT_EQ(factors.sentence(), "none was simulated");
}

class TimeOfAStep : public GlTest {};

TEST_F(TimeOfAStep, IsTheTimeStepUnlessPaused) {
    Params params;
    params.timeStep = 0.004;
    Simulation simulation(cubeSphere(1), params);
    simulation.step();
    EXPECT_EQ(secondsOfStep(simulation), 0.004);
    simulation.execute(SetTime{false});
    simulation.step();
    EXPECT_EQ(secondsOfStep(simulation), 0);
}

class RealTimeForecastTest : public GlTest {
  protected:
    Params params_ = ofNewScene({});
};

TEST_F(RealTimeForecastTest, IsThatOfTheTimeStepWithItsIterations) {
    params_.timeStep = 0.004;
    const RealTimeForecast forecast = realTimeForecast(cubeSphere(4), params_);
    EXPECT_GT(forecast.factor, 0);
    EXPECT_EQ(forecast.timeStep, 0.004);
    EXPECT_GT(forecast.iterations, 0);
    params_.iterations = 7;
    EXPECT_EQ(realTimeForecast(cubeSphere(4), params_).iterations, 7);
}

TEST_F(RealTimeForecastTest, ABallStandsInForALargeBodyAndItsTimesAreScaled) {
    const RealTimeForecast large = realTimeForecast(cubeSphere(33), params_);
    const RealTimeForecast larger = realTimeForecast(cubeSphere(132), params_);
    EXPECT_GT(larger.factor, 0);
    EXPECT_GT(large.scale, 1);
    EXPECT_GT(larger.scale, 10 * large.scale);
    EXPECT_GE(larger.iterations, large.iterations);
    params_.iterations = 7;
    EXPECT_EQ(realTimeForecast(cubeSphere(33), params_).iterations, 7) << "as it was said";
}

TEST_F(RealTimeForecastTest, OfImplicitStepsTellsTheirNumberWhichNoSizeChanges) {
    params_.solver = SolverMode::implicit;
    params_.timeStep = 0.02;
    const RealTimeForecast large = realTimeForecast(cubeSphere(33), params_);
    const RealTimeForecast larger = realTimeForecast(cubeSphere(66), params_);
    EXPECT_EQ(large.implicitSteps, 2) << "longer than the longest step of any body";
    EXPECT_GT(larger.scale, 3 * large.scale);
    EXPECT_EQ(larger.iterations, large.iterations);
}

}  // namespace
}  // namespace kerf::app
