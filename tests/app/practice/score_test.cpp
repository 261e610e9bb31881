#include "app/practice/score.h"

#include "app/practice/advice.h"

namespace kerf::app {
namespace {

/// A cube of 1 m that is cut 0.3 m deep along a line, by a hand that takes 2 s.
class ScoreTest : public testing::Test {
  protected:
    ScoreTest() {
        task_.name = "Cube";
        task_.lines = {{{{-0.5, 0.5, 0.013}, {0.5, 0.5, 0.013}}}};
        task_.reach = 0.1;
        task_.depth = 0.3;
        task_.band = 0.01;
        for (int i = 0; i <= 200; ++i) {
            const double share = i / 200.0;
            const double x = 0.07 * share * share * share * (10 - 15 * share + 6 * share * share);
            hand_.push_back({3 + 2 * share, {{x, 1, 0}, {x, 0, 0}}, i == 0});
        }
    }

    void cut(double depth = 0.3, double z = 0.013) {
        const CutCheck check =
            runStroke(cutter_, mesh_,
                      straightStroke({0.01, 0.5 + (0.2 - depth) / 2, z}, Vec3::UnitX(),
                                     -Vec3::UnitY(), 2, 0.2 + depth, 30));
        ASSERT_EQ(check.problem, "");
        ASSERT_EQ(check.refused, 0);
    }
    void push(double seconds, double step, const Vec3& force) {
        for (const double end = now_ + seconds; now_ < end - 1e-9; now_ += step) {
            forces_.push_back({now_, now_ + step, force});
        }
    }
    TaskRun run() {
        members_.assign(mesh_.triangleSlots(), 0);
        uncutMembers_.assign(uncut_.triangleSlots(), 0);
        return {{task_, mesh_, uncut_, members_, uncutMembers_}, hand_, forces_};
    }
    Score score() { return scoreOf(run()); }

    Task task_;
    SurfaceMesh uncut_ = box(Vec3::Ones(), 6);
    SurfaceMesh mesh_ = uncut_;
    Cutter cutter_{mesh_, CutSettings{}};
    std::vector<HandPose> hand_;
    std::vector<ForceSample> forces_;
    double now_ = 0;  ///< simulated time [s]

  private:
    std::vector<int> members_;
    std::vector<int> uncutMembers_;
};

const FigureRow& rowOf(const std::string& key) {
    return *std::ranges::find(figureRows(), key, &FigureRow::key);
}

double valueOf(const Score& score, const std::string& key) {
    return valueOf(rowOf(key), score).value();
}

TEST_F(ScoreTest, EachFigureOfTheTableIsItsOwn) {
    std::set<std::string> keys;
    std::set<std::string> labels;
    for (const FigureRow& row : figureRows()) {
        EXPECT_TRUE(keys.insert(row.key).second) << row.key;
        EXPECT_TRUE(labels.insert(row.label).second) << row.label;
    }
    EXPECT_EQ(keys.size(), 21U);
    // Each member has another value, so no row may show that of another.
    const Score all{
        {1, 2, 3, 4, 5, 6, 7, 8, 9, 10}, {11, 12, 13, 14, 15, 16, 21}, {17, 18}, 19, 20, {}};
    std::set<double> values;
    for (const FigureRow& row : figureRows()) {
        EXPECT_TRUE(values.insert(valueOf(row, all).value()).second) << row.key;
        EXPECT_FALSE(valueOf(row, Score{})) << row.key;
    }
    EXPECT_EQ(valueOf(all, "spared_cut"), 8);
    EXPECT_EQ(valueOf(all, "excised_volume"), 10);
    EXPECT_EQ(valueOf(all, "idle_time"), 16);
    EXPECT_EQ(valueOf(all, "wobble"), 21);
    EXPECT_EQ(valueOf(all, "force_mean"), 18);
}

TEST_F(ScoreTest, OnlyWhatATaskAsksForHasALimit) {
    task_.limits = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};
    const auto limit = [&](const std::string& key) { return limitOf(rowOf(key), task_); };
    EXPECT_EQ(limit("deviation_max"), 1);
    EXPECT_EQ(limit("deviation_mean"), 11);
    EXPECT_EQ(limit("length_under"), 2);
    EXPECT_EQ(limit("length_over"), 2);
    EXPECT_EQ(limit("depth_in_band"), 3);
    EXPECT_FALSE(limit("margin_least") || limit("taken") || limit("path"));
    EXPECT_EQ(limit("undos"), 0) << "of all tasks";
    task_.spare = {1};
    task_.take = 1;
    EXPECT_EQ(limit("margin_least"), 4);
    EXPECT_EQ(limit("taken"), 1);
    task_.depth.reset();
    EXPECT_FALSE(limit("depth_in_band"));
    task_.lines.clear();
    EXPECT_FALSE(limit("deviation_max") || limit("length_under"));
    EXPECT_FALSE(limit("wobble"));
    EXPECT_EQ(limit("force_max"), 10);
}

TEST_F(ScoreTest, ACutWithinAllLimitsPasses) {
    cut();
    push(0.5, 0.005, {0, 2, 0});
    task_.spareRegions = {Ball{Vec3(0, 0, 0.3), 0.1}};
    task_.path = 0.07;
    task_.limits = {.deviation = 0.002,
                    .ends = 0.004,
                    .inBand = 0.9,
                    .margin = 0.1,
                    .seconds = 2.5,
                    .idle = 0.5,
                    .economy = 0.9,
                    .smoothness = -6,
                    .wobble = 1e-4,
                    .newtons = 2.1,
                    .meanDeviation = 0.001};
    const Score score = this->score();
    EXPECT_THAT(score.violations, IsEmpty());
    EXPECT_TRUE(score.passed());
    EXPECT_NEAR(valueOf(score, "depth_mean"), 0.3, 2e-3);
    EXPECT_NEAR(valueOf(score, "time"), 2, 1e-9);
}

TEST_F(ScoreTest, EachLimitThatIsNotKeptIsNamed) {
    cut(0.4, 0.033);
    push(0.5, 0.005, {0, 2, 0});
    task_.spareRegions = {Ball{Vec3(0, 0.2, 0.3), 0.1}};
    task_.take = 0;
    task_.spare = {0};
    task_.path = 0.035;
    task_.limits = {.deviation = 0.002,
                    .ends = {},
                    .inBand = 0.9,
                    .margin = 0.2,
                    .seconds = 1.5,
                    .idle = {},
                    .economy = 0.9,
                    .smoothness = -2,
                    .wobble = {},
                    .newtons = 1.9,
                    .meanDeviation = 0.015};
    TaskRun run = this->run();
    run.undos = 1;
    run.changes = 2;
    const Score score = scoreOf(run);
    EXPECT_FALSE(score.passed());
    EXPECT_THAT(
        score.violations,
        ElementsAre(HasSubstr("Mean deviation: "), "Largest deviation: 20.00 mm (at most 2.00 mm).",
                    "Depth within limits: 0.0 % (at least 90.0 %).",
                    "Least margin: 0.00 mm (at least 200.00 mm).",
                    "Structures damaged: 1 (at most 0).", "Taken out whole: no (must be yes).",
                    "Time: 2.00 s (at most 1.50 s).",
                    "Economy of the path: 50.0 % (at least 90.0 %).", HasSubstr("Smoothness: -5."),
                    "Largest force: 2000.0 mN (at most 1900.0 mN).",
                    "Undone changes: 1 (at most 0).", "Parameters changed: 2 (at most 0)."));
}

TEST_F(ScoreTest, HalfACutAndNoCutDoNotPass) {
    task_.limits.deviation = 0.002;
    task_.limits.ends = 0.004;
    EXPECT_THAT(score().violations,
                ElementsAre("Largest deviation: not measured (at most 2.00 mm).",
                            "Line missed: 1000.00 mm (at most 4.00 mm)."));
    runStroke(cutter_, mesh_,
              straightStroke({0, 0.5, 0.013}, Vec3::UnitX(), -Vec3::UnitY(), 0.5, 0.4, 24));
    EXPECT_THAT(score().violations, ElementsAre(HasSubstr("Line missed: 5")));
    task_.lines[0].points = {{-0.1, 0.5, 0.013}, {0.1, 0.5, 0.013}};
    EXPECT_THAT(score().violations, ElementsAre(HasSubstr("Cut off the line: ")));
    task_.limits = {};
    EXPECT_TRUE(score().passed()) << "no limit";
}

TEST_F(ScoreTest, AdviceSaysWhatToDoNextTime) {
    task_.limits.deviation = 0.002;
    task_.limits.ends = 0.05;
    task_.limits.inBand = 0.9;
    EXPECT_EQ(adviceOn(score(), task_),
              "Set Depth to 300 mm. Begin at one end of the line, and go on to the other.");
    cut(0.4, 0.033);
    EXPECT_EQ(adviceOn(score(), task_),
              "Set Depth to 300 mm. Slow down, and stay between the thin lines: you were up to 20 "
              "mm beside it.");
    task_.depth = 0.4;
    task_.lines[0].points.insert(task_.lines[0].points.begin() + 1, Vec3(0, 0.5, 0.1));
    EXPECT_THAT(adviceOn(score(), task_), HasSubstr("Slow down at the bend."));
    task_.limits = {};
    EXPECT_EQ(adviceOn(score(), task_), "");
    task_.take = 0;
    EXPECT_EQ(adviceOn(score(), task_), "Cut right through, so that it comes out whole.");
    task_.lines[0].closed = true;
    EXPECT_THAT(adviceOn(score(), task_), HasSubstr("end there across your first cut."));
    Score undone;
    undone.undos = 1;
    EXPECT_THAT(adviceOn(undone, task_), HasSubstr("Try again"));
}

TEST_F(ScoreTest, EachLimitThatATaskCanHaveHasItsAdvice) {
    task_.limits = {1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};
    task_.spare = {0};
    task_.take = 0;
    for (const FigureRow& row : figureRows()) {
        Score score;
        for (const FigureRow& other : figureRows()) {
            score.*other.value = other.better > 0 ? 2 : 0;
        }
        score.*row.value = row.better > 0 ? 0 : 2;
        EXPECT_EQ(adviceOn(score, task_).empty(), !limitOf(row, task_)) << row.key;
    }
}

TEST_F(ScoreTest, WhatIsNotMeasuredDoesNotPass) {
    cut();
    task_.limits.newtons = 2;
    task_.limits.economy = 0.5;
    EXPECT_THAT(score().violations,
                ElementsAre("Economy of the path: not measured (at least 50.0 %).",
                            "Largest force: not measured (at most 2000.0 mN)."));
}

TEST_F(ScoreTest, AModelToBeSparedMustNotBeCut) {
    task_.spare = {0};
    EXPECT_TRUE(score().passed());
    task_.limits.margin = 0.01;
    EXPECT_THAT(score().violations, ElementsAre("Least margin: not measured (at least 10.00 mm)."));
    task_.limits.margin.reset();
    cut();
    EXPECT_THAT(score().violations, ElementsAre("Structures damaged: 1 (at most 0)."));
}

TEST_F(ScoreTest, ForceIsTheMeanOverWindowsOfTime) {
    EXPECT_FALSE(score().forceMax || score().forceMean);
    push(0.2, 0.005, Vec3::Zero());
    EXPECT_FALSE(score().forceMax) << "no load";
    push(0.1, 0.005, {0, 3, 4});
    push(0.2, 0.005, Vec3::Zero());
    push(0.05, 0.005, {1, 0, 0});
    EXPECT_NEAR(*score().forceMax, 5, 1e-9);
    EXPECT_NEAR(*score().forceMean, (5 + 5 + 1) / 3.0, 1e-9) << "of windows with a load";
    forces_.push_back({now_, now_ + 0.005, {0, 0, 100}});
    EXPECT_NEAR(*score().forceMax, 10, 1e-9) << "a jolt of a tenth of a window";
}

TEST_F(ScoreTest, ForceDoesNotDependOnTheTimeStep) {
    for (const double step : {0.0005, 0.002, 0.005, 0.0125, 0.02, 0.1, 0.5}) {
        forces_.clear();
        now_ = 0;
        push(0.5, step, {0, 2, 0});
        push(0.5, step, {0, -1, 0});
        EXPECT_NEAR(*score().forceMax, 2, 1e-6) << step;
        EXPECT_NEAR(*score().forceMean, 1.5, 1e-6) << step;
    }
    forces_.clear();
    for (int i = 0; i < 40; ++i) {
        forces_.push_back({0.005 * i, 0.005 * (i + 1), {i % 2 == 0 ? 7.0 : -7.0, 0, 0}});
    }
    EXPECT_FALSE(score().forceMax) << "chatter is no force";
}

TEST_F(ScoreTest, WithoutALineTheMiddleOfTheBodyIsThePivot) {
    task_.lines.clear();
    hand_.clear();
    for (int i = 0; i <= 100; ++i) {  // turns about the origin
        const Vec3 way(std::cos(0.02 * i), std::sin(0.02 * i), 0);
        hand_.push_back({0.01 * i, {-way, way}, i == 0});
    }
    EXPECT_NEAR(*score().path, 0, 1e-9);
}

TEST_F(ScoreTest, PeopleReadMillimetresAndPercent) {
    const auto unitOf = [](const std::string& key) { return rowOf(key).unit; };
    EXPECT_EQ(formatFigure(unitOf("deviation_max"), 0.0024149), "2.41");
    EXPECT_EQ(formatFigure(unitOf("depth_in_band"), 0.8766), "87.7");
    EXPECT_EQ(formatFigure(unitOf("excised_volume"), 1.2345e-6), "1.234");
    EXPECT_EQ(formatFigure(unitOf("force_max"), 0.25), "250.0");
    EXPECT_EQ(formatFigure(unitOf("smoothness"), -5.32), "-5.3");
    EXPECT_EQ(formatFigure(unitOf("taken"), 1), "yes");
    EXPECT_EQ(formatFigure(unitOf("taken"), 0), "no");
    EXPECT_EQ(formatFigure(unitOf("taken"), std::nullopt), "");
}

TEST_F(ScoreTest, FilesHaveAllFiguresInSIUnits) {
    cut();
    task_.person = "A. Learner";
    task_.date = "2026-11-28T10:15:00Z";
    task_.limits.seconds = 1;
    const Score score = this->score();
    const auto json = toJson(score, task_);
    for (const FigureRow& row : figureRows()) {
        ASSERT_TRUE(json.contains(row.key)) << row.key;
    }
    EXPECT_EQ(json.size(), figureRows().size() + 6);
    EXPECT_EQ(json["limits"].dump(), R"({"spared_cut":0.0,"time":1.0,"undos":0.0,"changes":0.0})");
    EXPECT_EQ(json["task"], "Cube");
    EXPECT_EQ(json["person"], "A. Learner");
    EXPECT_EQ(json["date"], "2026-11-28T10:15:00Z");
    EXPECT_EQ(json["depth_mean"].get<double>(), *score.depthMean) << "not rounded";
    EXPECT_TRUE(json["taken"].is_null());
    EXPECT_TRUE(json["force_max"].is_null());
    EXPECT_EQ(json["violations"].size(), 1U);
    EXPECT_EQ(json["passed"], false);
    EXPECT_EQ(json["undos"], 0);
    Score taken;
    taken.taken = 0;
    EXPECT_EQ(toJson(taken, task_)["taken"], false);
    EXPECT_EQ(toJson(taken, task_)["passed"], true);
}

TEST_F(ScoreTest, TheSameRunHasTheSameScoreToTheBit) {
    cut();
    push(0.5, 0.005, {0, 2, 0.1});
    task_.spareRegions = {Ball{Vec3(0, 0, 0.3), 0.1}};
    const auto json = toJson(score(), task_);
    EXPECT_EQ(toJson(score(), task_).dump(), json.dump());
    std::ranges::for_each(hand_, [](HandPose& pose) { pose.time += 1; });
    EXPECT_EQ(toJson(score(), task_)["force_mean"], json["force_mean"]);
}

}  // namespace
}  // namespace kerf::app
