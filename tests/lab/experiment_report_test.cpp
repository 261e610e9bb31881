// What report.md says of runs, without running any.
#include "bench/lab/experiment/experiment_report.h"

#include <gtest/gtest.h>

#include "bench/lab/experiment/report_figures.h"
#include "bench/lab/experiment/report_sections.h"
#include "gpu/data_path.h"
#include "shaders/shared/bindings.h"
#include "shaders/shared/body_records.h"

namespace kerf::app {
namespace {

/// As if an experiment had run so many steps of a frame each.
ExperimentResult resultOf(const char* name, double volumeRatio = 1) {
    ExperimentResult result;
    result.paper = findPaperExperiment(name);
    result.session = paperSession(*result.paper, false);
    result.summary.renderer = "some GPU";
    MetricsRow row;
    row.report.volumeRatio = volumeRatio;
    row.report.deformMs = 3;
    row.report.collideMs = 4;
    row.report.cutMs = 1;
    row.frameMs = 8;
    result.summary.statistics.add(row);
    return result;
}

ReportData dataOf(std::vector<ExperimentResult> results) {
    ReportData data;
    data.results = std::move(results);
    return data;
}

std::string reportOf(const ReportData& data) {
    return formatExperimentReport(data, readShaderInventory(gpu::shaderRoot()));
}

void expectHas(const std::string& report, const std::string& text) {
    EXPECT_NE(report.find(text), std::string::npos) << text << "\nis missing in\n" << report;
}
void expectLacks(const std::string& report, const std::string& text) {
    EXPECT_EQ(report.find(text), std::string::npos) << text << "\nstands in\n" << report;
}

TEST(ExperimentReport, NamesWhatDidNotHoldAndWhatIsToBeKnown) {
    ExperimentResult result = resultOf("octopus");
    result.summary.failures = {"Step 7: the volume is not finite any more."};
    result.summary.remarks = {"Step 0: 1 iteration is too few."};
    const std::string report = reportOf(dataOf({result}));
    expectHas(report, "- Octopus: Step 7: the volume");
    expectHas(report, "## Remarks\n\n- Octopus: Step 0: 1 iteration is too few.\n");
    expectHas(report, "some GPU");
    expectHas(report, "91.1");
}

TEST(ExperimentReport, DerivesThePreviousMethodFromTheGains) {
    EXPECT_NEAR(*findPaperExperiment("sphere768")->previousFps(), 108.4, 0.05);
    EXPECT_NEAR(*findPaperExperiment("octopus")->previousFps(), 51.7, 0.05);
    EXPECT_NEAR(*findPaperExperiment("banana")->previousFps(), 32.1, 0.05);
    EXPECT_FALSE(findPaperExperiment("sphere20")->previousFps());
    expectHas(performanceSection(dataOf({resultOf("banana")})), "| Banana | 32.1 | 51.8 | 61.37 |");
    expectHas(performanceSection(dataOf({resultOf("sphere20")})),
              "| Sphere 20 | above 172.1 | 172.1 | - |");
}

TEST(ExperimentReport, HasTheFiguresOfTheRunsAlone) {
    const std::string spheres = reportOf(dataOf({resultOf("sphere20"), resultOf("sphere768")}));
    expectHas(spheres, "](figures/figure-5a.png)");
    expectHas(spheres, "](figures/figure-7c.png)");
    expectHas(spheres, "**Figure 5.** Cutting simulation: (a) Sphere 20: time step 0.005 s");
    expectLacks(spheres, "**Figure 6.**");
    expectLacks(spheres, "figure-5b");
    expectLacks(spheres, "**Figure 2.**");
    const std::string banana = reportOf(dataOf({resultOf("banana")}));
    expectHas(banana, "](figures/figure-8b.png)");
    expectLacks(banana, "**Figure 5.**");
}

TEST(ExperimentReport, SaysThatVolumeIsHeldByAConstraint) {
    ReportData data = dataOf({resultOf("octopus")});
    expectHas(differencesSection(data), "a constraint of its own");
    expectHas(differencesSection(data), "100.00 % where the paper has 91.1 %: a constraint");
    data.published = true;
    expectLacks(differencesSection(data), "a constraint of its own");
}

TEST(ExperimentReport, SaysWhyAFigureIsFarFromThePapers) {
    const std::string close = differencesSection(dataOf({resultOf("sphere20", 0.996)}));
    expectLacks(close, "far from the paper's");
    ExperimentResult slow = resultOf("sphere20", 0.9);
    slow.summary.statistics.frameMs.add(80);
    const std::string far = differencesSection(dataOf({slow}));
    expectHas(far, "22.7 frames a second are 0.13 of the paper's 172.1");
    expectHas(far, "falls to 90.0 % where the paper speaks of negligible change");
}

TEST(ExperimentReport, SaysWhichStageTakesTheTime) {
    expectHas(differencesSection(dataOf({resultOf("sphere20")})), "the other way round");
    ExperimentResult cutting = resultOf("sphere20");
    cutting.summary.statistics.cutMs.add(100);
    expectHas(differencesSection(dataOf({cutting})), "So it is here.");
}

TEST(ExperimentReport, ComparesTheHalvesOfFigureTwo) {
    ReportData data = dataOf({resultOf("sphere768")});
    data.figure2.emplace();
    data.figure2->without.pictureVolume = 0.44;
    expectHas(methodSection(data, readShaderInventory(gpu::shaderRoot())),
              "As in the paper, the halves collapse");
    expectHas(methodSection(data, readShaderInventory(gpu::shaderRoot())),
              "(a): the volume is 44.00 % in the picture");
    data.figure2->without.pictureVolume = 0.96;
    data.published = true;
    expectHas(methodSection(data, readShaderInventory(gpu::shaderRoot())),
              "the bends of plain PBD hold the skin up alone");
}

TEST(ExperimentReport, ListsEverySetting) {
    const std::string settings = settingsSection(dataOf({resultOf("octopus"), resultOf("banana")}));
    for (const ParamInfo& info : paramTable()) {
        expectHas(settings, "`" + std::string(info.name) + "`");
    }
    expectHas(settings, "| `youngs_modulus`, Pa | 300000 | 500000 |");
    expectHas(settings, "| gravity after the cut, m/s^2 | [0, -9.81, 0] from step 120 |");
}

SearchRun searchOf(const char* way, double searchMs) {
    MetricsRow row;
    row.frameMs = 10 + searchMs;
    row.report.cutMs = 1 + searchMs;
    row.report.search = {searchMs, searchMs / 2, 3, 768};
    SearchRun run{way, {}};
    run.times.add(row);
    return run;
}

TEST(ExperimentReport, ComparesTheWaysToSearch) {
    ExperimentResult result = resultOf("sphere768");
    result.searches = {searchOf("tree", 0), searchOf("adjacency", 1), searchOf("all", 6)};
    const std::string section = searchSection(dataOf({result}));
    expectHas(section, "| Sphere 768 | adjacency | 768 | 1.000 (1.000 to 1.000) | 0.500");
    expectHas(section, "| Sphere 768 | 48.06 | 45.45 | 52.38 | 366.67 |");
    const std::string without = searchSection(dataOf({resultOf("sphere768")}));
    expectHas(without, "| Sphere 768 | - | - | - | - |");
}

TEST(ExperimentReport, CountsRightAfterTheCutAndAtTheEnd) {
    ExperimentResult result = resultOf("sphere768");
    result.summary.before = {386, 768, 386};
    result.afterStroke = {960, 1760, 900};
    result.summary.after = {930, 1696, 880};
    expectHas(cuttingSection(dataOf({result})),
              "| 386 / 960 / 930 | 768 / 1760 / 1696 | 386 / 900 / 880 | 768 |");
}

TEST(StrokeTimes, HaveTheSpreadOfTheMeansOfTheRuns) {
    ExperimentResult result = resultOf("sphere20");
    for (const double frameMs : {10.0, 20.0, 40.0}) {
        MetricsRow row;
        row.frameMs = frameMs;
        result.strokes.emplace_back().add(row);
    }
    const StrokeRates rates = strokeRates(result);
    EXPECT_DOUBLE_EQ(rates.least, 25);
    EXPECT_DOUBLE_EQ(rates.most, 100);
    EXPECT_NEAR(rates.mean, (100 + 50 + 25) / 3.0, 1e-9);
}

TEST(ShaderInventory, ReadsBuffersAndGroupsFromTheShaders) {
    const ShaderInventory shaders = readShaderInventory(gpu::shaderRoot());
    const auto binding = [&](const std::string& name) {
        const auto found = std::ranges::find(shaders.buffers, name, &ShaderBuffer::name);
        return found == shaders.buffers.end() ? -1 : found->binding;
    };
    EXPECT_EQ(binding("Positions"), static_cast<int>(shared::kPositionsBinding));
    EXPECT_EQ(binding("Entries"), static_cast<int>(shared::kEntriesBinding));
    EXPECT_EQ(shaders.threads, static_cast<int>(shared::kGroupSize));
    EXPECT_GT(shaders.kernels, 20);
    for (const ShaderBuffer& buffer : shaders.buffers) {
        EXPECT_FALSE(buffer.size.empty() || buffer.contents.empty()) << buffer.name;
    }
}

class PaperMoments : public ::testing::TestWithParam<PaperExperiment> {};

TEST_P(PaperMoments, FollowTheCourseOfTheExperiment) {
    const Session session = paperSession(GetParam(), false);
    const Moments at = momentsOf(session);
    EXPECT_LT(at.blade, at.lift);
    EXPECT_LT(at.lift, at.gravity);
    EXPECT_LT(at.gravity, at.end);
    const std::vector<ReportPicture> cutting = cuttingPictures(session);
    ASSERT_EQ(cutting.size(), 4u);
    EXPECT_GT(cutting[1].step, at.blade);
    EXPECT_LT(cutting[1].step, at.lift);
    EXPECT_GT(cutting[2].step, at.lift) << "the stroke is over";
    EXPECT_GT(cutting[3].step, at.gravity) << "the pieces fall";
    const std::vector<ReportPicture> falling = fallPictures(session);
    ASSERT_EQ(falling.size(), 3u);
    EXPECT_GT(falling.front().step, cutting.back().step);
    EXPECT_EQ(falling.back().step, at.end);
}

TEST_P(PaperMoments, AStrokeAloneTakesNoPictures) {
    const Session session = paperSession(GetParam(), false);
    const Session stroke = strokeAlone(withPictures(session, cuttingPictures(session), 100));
    EXPECT_EQ(stroke.steps, momentsOf(session).lift + 1);
    EXPECT_TRUE(pictureFiles(stroke).empty());
    for (const SessionEvent& event : stroke.events) {
        EXPECT_LE(event.step, stroke.steps);
        EXPECT_FALSE(std::holds_alternative<CheckEvent>(event.action));
    }
}

INSTANTIATE_TEST_SUITE_P(All, PaperMoments, ::testing::ValuesIn(paperExperiments()),
                         [](const auto& each) { return std::string(each.param.name); });

TEST(PaperFigures, HaveThePapersNumbers) {
    const auto file = [](FigurePart (*part)(const PaperExperiment&), const char* name) {
        return part(*findPaperExperiment(name)).file();
    };
    EXPECT_EQ(file(cuttingFigure, "sphere80"), "figures/figure-5b.png");
    EXPECT_EQ(file(cuttingFigure, "octopus"), "figures/figure-6a.png");
    EXPECT_EQ(file(fallFigure, "banana"), "figures/figure-8b.png");
    EXPECT_EQ(volumeFigure(*findPaperExperiment("banana")).label(), "(e)");
}

}  // namespace
}  // namespace kerf::app
