// `kerf inspect` of models that are hollow or broken.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/support/model_defects.h"
#include "tests/support/run_kerf.h"
#include "tests/support/shapes.h"
#include "tests/support/temporary_folder.h"

namespace kerf {
namespace {

using test::ProgramRun;
using test::runKerf;

class Inspect : public ::testing::Test {
  protected:
    std::string file(const std::string& name) const { return folder / name; }
    void write(const std::string& name, const TriangleSoup& soup) const {
        test::writeText(folder / name, test::objText(soup));
    }
    static nlohmann::json reportOf(const std::string& model) {
        return nlohmann::json::parse(runKerf({"inspect", model, "--json"}).out);
    }

    test::TemporaryFolder folder;
};

TEST_F(Inspect, AHollowModelIsOnePieceWithACavity) {
    write("hollow.obj", test::joined(test::boxSoup(Vec3(2, 2, 2)), test::boxSoup(), Vec3::Zero()));
    const ProgramRun run = runKerf({"inspect", file("hollow.obj")});
    EXPECT_EQ(run.exitCode, 0) << run.errors;
    EXPECT_NE(run.out.find("turned 1 shell inside another one inwards"), std::string::npos);
    const auto report = reportOf(file("hollow.obj"));
    EXPECT_EQ(report["cavities"], 1);
    EXPECT_EQ(report["pieces"], 1);
    EXPECT_NEAR(report["volume"].get<double>(), 7, 1e-9);
}

TEST_F(Inspect, RepairsWhatIsBroken) {
    TriangleSoup soup = test::soundBall();
    test::modelDefects().at("large hole")(soup);
    test::modelDefects().at("doubles")(soup);
    write("broken.obj", soup);
    EXPECT_EQ(runKerf({"inspect", file("broken.obj")}).exitCode, 3);
    EXPECT_TRUE(reportOf(file("broken.obj"))["repairable"]);
    const ProgramRun run = runKerf({"inspect", file("broken.obj"), "--repair", file("mended.ply")});
    EXPECT_EQ(run.exitCode, 0) << run.errors;
    EXPECT_NE(run.out.find("filled 1 hole"), std::string::npos) << run.out;
    EXPECT_EQ(runKerf({"inspect", file("mended.ply")}).exitCode, 0);
}

TEST_F(Inspect, WritesNothingOfWhatCannotBeRepaired) {
    write("sheet.obj", {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 0}},
                        {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}});
    const ProgramRun run = runKerf({"inspect", file("sheet.obj"), "--repair", file("out.ply")});
    EXPECT_EQ(run.exitCode, 3);
    EXPECT_NE(run.errors.find("after the repair still"), std::string::npos) << run.errors;
    EXPECT_FALSE(std::filesystem::exists(folder / "out.ply"));
    EXPECT_EQ(runKerf({"inspect", "sphere80", "--repair", file("none/out.ply")}).exitCode, 5);
    EXPECT_EQ(runKerf({"inspect", "sphere80", "--repair", file("out.txt")}).exitCode, 2);
}

TEST_F(Inspect, MakesEvenTriangles) {
    ASSERT_EQ(
        runKerf({"inspect", "sphere80", "--remesh", file("fine.ply"), "--edge", "0.1"}).exitCode,
        0);
    const auto fine = reportOf(file("fine.ply"));
    EXPECT_EQ(fine["cuttable"], true);
    EXPECT_GT(fine["triangles"], 500);
    EXPECT_NEAR(fine["volume"].get<double>(), 0.4573, 0.0046);
    EXPECT_EQ(runKerf({"inspect", "sphere80", "--edge", "0.1"}).exitCode, 2);
}

}  // namespace
}  // namespace kerf
