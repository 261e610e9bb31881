// Slits, notches and tears in a sheet of gelatin whose ends are drawn apart.
#include <gtest/gtest.h>
#include <spdlog/fmt/fmt.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "sim/base/math.h"
#include "tests/support/run_kerf.h"
#include "tests/support/temporary_folder.h"

namespace kerf {
namespace {

using Json = nlohmann::json;

/// 60 x 6 x 40 mm, in squares of 2 and 3 mm. Corners are written once for each square: readers
/// join them.
std::string sheet() {
    constexpr std::array<int, 3> kCells{30, 2, 20};
    const Vec3 kSize(0.06, 0.006, 0.04);
    std::string text;
    for (int k = 0; k < 3; ++k) {
        const int u = (k + 1) % 3;
        const int v = (k + 2) % 3;
        for (int square = 0; square < 2 * kCells[u] * kCells[v]; ++square) {
            const bool far = square % 2 == 1;
            for (const auto& [du, dv] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}}) {
                Vec3 share = Vec3::Zero();
                share[k] = far ? 0.5 : -0.5;
                const int column = square / 2 % kCells[u] + (far ? du : dv);
                const int row = square / 2 / kCells[u] + (far ? dv : du);
                share[u] = static_cast<double>(column) / kCells[u] - 0.5;
                share[v] = static_cast<double>(row) / kCells[v] - 0.5;
                const Vec3 at = kSize.cwiseProduct(share);
                text += fmt::format("v {:.4f} {:.4f} {:.4f}\n", at.x(), at.y(), at.z());
            }
            text += "f -4 -3 -2 -1\n";
        }
    }
    return text;
}

/// A blade along y, from one place (x, z) to another [m].
using Slit = std::array<double, 4>;

Json bladeAt(int step, double x, double z) {
    return {{"step", step}, {"type", "blade"}, {"a", {x, 0.01, z}}, {"b", {x, -0.01, z}}};
}

/// Slits are made while time stands; then one end is drawn away for 0.3 s.
Json pulledApart(const std::vector<Slit>& slits) {
    Json events = {
        {{"step", 0}, {"type", "hold"}},
        {{"step", 0}, {"type", "pin"}, {"low", {-0.05, -1, -1}}, {"high", {-0.026, 1, 1}}}};
    int step = 1;
    for (const auto& [fromX, fromZ, toX, toZ] : slits) {
        events.push_back(bladeAt(step, fromX, fromZ));
        events.push_back(bladeAt(step + 10, toX, toZ));
        events.push_back({{"step", step + 11}, {"type", "lift"}});
        step += 13;
    }
    events.push_back({{"step", step}, {"type", "run"}});
    events.push_back({{"step", step},
                      {"type", "pin"},
                      {"low", {0.026, -1, -1}},
                      {"high", {0.05, 1, 1}},
                      {"velocity", {0.15, 0, 0}},
                      {"seconds", 0.3}});
    return {{"format", "kerf-session"},
            {"version", 1},
            {"model", {{"path", "sheet.obj"}}},
            {"material", "gelatin"},
            {"params",
             {{"time_step", 0.002},
              {"iterations", "auto"},
              {"iteration_error", 0.05},
              {"floor", nullptr},
              {"gravity", {0, 0, 0}},
              {"tearing", 1},
              {"wall_coarsening", 3}}},
            {"steps", 200},
            {"events", events}};
}

/// The largest number of a column of a CSV file.
double largest(const std::string& csv, const std::string& column) {
    std::istringstream lines(csv);
    const auto cells = [&lines] {
        std::string line;
        std::getline(lines, line);
        std::istringstream stream(line);
        std::vector<std::string> found;
        for (std::string cell; std::getline(stream, cell, ',');) {
            found.push_back(cell);
        }
        return found;
    };
    const std::vector<std::string> head = cells();
    const auto place = std::ranges::find(head, column) - head.begin();
    double most = 0;
    for (std::vector<std::string> row = cells(); !row.empty(); row = cells()) {
        most = std::max(most, row[place].empty() ? 0 : std::stod(row[place]));
    }
    return most;
}

struct Torn {
    Json summary;
    double stress = 0;  ///< largest of all steps, over the strength
};

Torn tear(const std::vector<Slit>& slits) {
    const test::TemporaryFolder folder;
    test::writeText(folder / "sheet.obj", sheet());
    test::writeText(folder / "tear.kerf.json", pulledApart(slits).dump());
    const test::ProgramRun run =
        test::runKerf({"replay", folder / "tear.kerf.json", "--out", folder / "out"});
    EXPECT_EQ(run.exitCode, 0) << run.errors;
    return {Json::parse(test::readBytes(folder / "out/summary.json")),
            largest(test::readBytes(folder / "out/metrics.csv"), "tear_stress")};
}

// 7 pairs of walls passed through each other.
TEST(ReplayTears, ATearThatMeetsASlitCrossesNoWall) {
    const Torn torn = tear({{-0.012, -0.0033, 0.014, -0.0033}, {0.0007, 0.03, 0.0007, 0.004}});
    EXPECT_GE(torn.summary["pieces"].size(), 2U) << "crumbs may be torn off where they meet";
    EXPECT_TRUE(torn.summary["closed_every_step"]);
    EXPECT_EQ(torn.summary["cut_report"]["self_intersections"]["pairs"], 0);
    EXPECT_NEAR(torn.summary["volume_ratio"]["final"].get<double>(), 1, 1e-3);
}

// A blade along a row of vertices leaves slivers, whose stretch was told as the largest: 3.7e7.
TEST(ReplayTears, NoSliverTellsTheStress) {
    const Torn torn = tear({{-0.004, 0.03, -0.004, 0.008}, {0.005, -0.03, 0.005, -0.008}});
    EXPECT_TRUE(torn.summary["closed_every_step"]);
    EXPECT_GT(torn.stress, 1);
    EXPECT_LT(torn.stress, 700);
}

}  // namespace
}  // namespace kerf
