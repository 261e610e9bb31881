#include <gtest/gtest.h>

#include <charconv>
#include <nlohmann/json.hpp>

#include "app/files/io/file_io.h"
#include "app/session/metrics.h"
#include "tests/support/temporary_folder.h"

namespace kerf::app {
namespace {

using test::readBytes;
using test::TemporaryFolder;
using test::writeText;

double parsed(const std::string& text) {
    double value = 0;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

TEST(FormatNumber, ReadsBackAsTheSameNumber) {
    for (const double value : {0.1, 1.0 / 3, -9.81, 1e-300, 6.02214076e23, 0.99999999999999989}) {
        EXPECT_EQ(parsed(formatNumber(value)), value);
    }
    EXPECT_EQ(formatNumber(0.1), "0.1");
    EXPECT_EQ(formatNumber(0.1f), "0.1");
}

TEST(Metrics, RowsHaveTheColumnsOfTheHeader) {
    MetricsRow row;
    row.report.step = 3;
    row.report.volume = 0.1;
    row.report.closed = false;
    row.frameMs = 2.5;
    row.report.subdivisions = {7, 0, 0, 1, 2, 0, 3};
    row.report.seeds = 2;
    row.report.kineticEnergy = 1.5;
    row.report.potentialEnergy = -0.25;
    EXPECT_EQ(
        metricsHeader(),
        "step,time,volume,volume_ratio,pieces,vertices,triangles,ispcs,touched_triangles,"
        "closed,deform_ms,collide_ms,cut_ms,render_ms,frame_ms,contacts,one_to_four,one_to_three_a,"
        "one_to_two,one_to_three_b,other_patterns,seeds,kinetic_energy,potential_energy,"
        "debris_pieces,debris_volume,strain_energy,lost_pieces,search_ms,search_walk_ms,"
        "search_seeds,search_tests,swept_area,swept_area_at_rest,fracture_energy,blade_force_x,"
        "blade_force_y,blade_force_z,blade_moment_x,blade_moment_y,blade_moment_z,blade_work,"
        "blade_energy,blade_lag,iterations,other_ms,tears,tear_refused,"
        "tear_opening,tear_stress,real_time_factor,implicit_steps,residual\n");
    EXPECT_EQ(formatMetrics(row),
              "3,0,0.1,1,1,0,0,0,0,0,0,0,0,0,2.5,0,7,0,0,1,5,2,1.5,-0.25,0,0,,0,0,0,0,0,0,0,0,,,,,,"
              ",0,0,0,0,2.5,,,,,,1,\n")
        << "with plain PBD there is no energy of strained material";
    row.report.strainEnergy = 0.75;
    row.report.lostPieces = 2;
    row.report.iterations = 6;
    row.report.implicitSteps = 2;
    row.report.residual = 0.125;
    row.report.times = {1, 0.5, 0.25};
    row.report.search = {1.5, 0.25, 2, 80};
    row.report.swept = {0.5, 0.25};
    row.report.fractureEnergy = 40;
    row.report.heldEdge = {0.25, 3, 2};
    row.report.bladeLoad = BladeLoad{Vec3(1, 2, 3), Vec3(4, 5, 6)};
    row.report.tear = TearReport{.opening = 0.5, .stress = 0.25, .failure = "no room"};
    row.simulatedSeconds = 0.005;
    EXPECT_EQ(formatMetrics(row),
              "3,0,0.1,1,1,0,0,0,0,0,1,0.5,0.25,0,2.5,0,7,0,0,1,5,2,1.5,-0.25,0,0,0.75,2,1.5,0.25,"
              "2,80,0.5,0.25,40,1,2,3,4,5,6,2,3,0.25,6,0.75,0,1,0.5,0.25,2,2,0.125\n");
    row.namesToughness = false;
    EXPECT_TRUE(formatMetrics(row).ends_with(
        ",0.5,0.25,,1,2,3,4,5,6,2,3,0.25,6,0.75,0,1,0.5,0.25,2,2,0.125\n"))
        << "nobody said what new surface takes";
}

TEST(Metrics, RangeOfASeries) {
    Range range;
    EXPECT_EQ(range.mean(), 0);
    for (const double value : {4.0, -1.0, 3.0}) range.add(value);
    EXPECT_EQ(range.mean(), 2);
    EXPECT_EQ(range.min(), -1);
    EXPECT_EQ(range.max(), 4);
}

TEST(Metrics, SummaryHoldsWhatScriptsReadFromIt) {
    RunSummary summary;
    summary.renderer = "llvmpipe";
    summary.stateHash = "00000000000000ff";
    summary.before = {12, 20, 12};
    summary.pieces = {Piece{10, 7, 0.5, 0.5, 1}, Piece{14, 9, 0.25, 0.25, 1}};
    MetricsRow row;
    row.frameMs = 10;
    row.simulatedSeconds = 0.005;
    row.report.volumeRatio = 1;
    row.report.search.milliseconds = 3;
    summary.statistics.add(row);
    row.frameMs = 30;
    row.report.volumeRatio = 0.5;
    row.report.subdivisions = {1, 2, 3, 4, 5, 6, 7};
    row.report.closed = false;
    summary.statistics.add(row);
    const auto json = nlohmann::json::parse(formatSummary(summary));
    EXPECT_EQ(json["renderer"], "llvmpipe");
    EXPECT_EQ(json["steps"], 2);
    EXPECT_EQ(json["state_hash"], "00000000000000ff");
    EXPECT_EQ(json["before"]["ispcs"], 12);
    EXPECT_EQ(json["after"]["triangles"], 0);
    EXPECT_EQ(json["pieces"][1]["volume"], 0.25);
    EXPECT_EQ(json["volume_ratio"]["mean"], 0.75);
    EXPECT_EQ(json["subdivisions"]["1-to-3a"], 2);
    EXPECT_EQ(json["subdivisions"]["1-to-3b"], 4);
    EXPECT_EQ(json["subdivisions"]["other"], 18);
    EXPECT_EQ(json["volume_ratio"]["min"], 0.5);
    EXPECT_EQ(json["volume_ratio"]["final"], 0.5);
    EXPECT_EQ(json["fps"]["mean"], 50);
    EXPECT_EQ(json["fps"]["max"], 100);
    EXPECT_EQ(json["real_time_factor"]["median"], 0.5);
    EXPECT_DOUBLE_EQ(json["real_time_factor"]["worst"], 0.005 / 0.03);
    EXPECT_EQ(json["stages_ms"]["cut"]["max"], 0);
    EXPECT_EQ(json["stages_ms"]["search"]["max"], 3);
    EXPECT_EQ(json["closed_every_step"], false);
}

TEST(AtomicFile, AppearsOnlyWhenItIsComplete) {
    const TemporaryFolder folder;
    {
        AtomicFile file(folder / "a.txt");
        file.write("half");
        EXPECT_FALSE(std::filesystem::exists(folder / "a.txt"));
    }
    EXPECT_TRUE(std::filesystem::is_empty(folder.path())) << "an abandoned file leaves nothing";
    writeOutputFile(folder / "a.txt", "whole");
    EXPECT_EQ(readBytes(folder / "a.txt"), "whole");
}

TEST(AtomicFile, KeepsTheOldFileUntilTheNewOneIsComplete) {
    const TemporaryFolder folder;
    writeText(folder / "a.txt", "old");
    {
        AtomicFile file(folder / "a.txt");
        file.write("new");
    }
    EXPECT_EQ(readBytes(folder / "a.txt"), "old");
}

TEST(AtomicFile, FailuresNameTheFileAndTheReason) {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder / "missing/a.txt";
    try {
        writeOutputFile(file, "x");
        FAIL() << "no error";
    } catch (const OutputError& error) {
        EXPECT_EQ(error.what(), file.string() +
                                    ": it could not be written (No such file or directory); that "
                                    "folder doesn't exist or takes no files; choose another one.");
    }
    std::filesystem::create_directory(folder / "a.txt");
    EXPECT_THROW(writeOutputFile(folder / "a.txt", "x"), OutputError);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1)
        << "the hidden file is gone";
}

}  // namespace
}  // namespace kerf::app
