#include "bench/lab/fem/fem_experiment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/files/import/model_source.h"
#include "app/session/session.h"
#include "render/scene/image.h"
#include "sim/mesh/box_surface.h"
#include "sim/mesh/invariants.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/run_kerf.h"
#include "tests/support/temporary_folder.h"

namespace kerf {
namespace {

using app::FemCase;
using app::FemResult;
using app::FemSetting;
using app::LoadedSurface;

LoadedSurface boxAt(const Vec3& size, const Vec3& moved) {
    const TriangleSoup soup = boxSurface(size, {2, 2, 2});
    LoadedSurface surface{soup.positions, soup.positions, soup.triangles, {}, {}};
    surface.walls.assign(soup.triangles.size(), false);
    for (Vec3& p : surface.positions) {
        p += moved;
    }
    return surface;
}

TEST(LoadedSurface, SagIsWhatAPartComesDownByInTheMean) {
    const Vec3 size(1, 1, 1);
    LoadedSurface surface = boxAt(size, Vec3::Zero());
    for (std::size_t v = 0; v < surface.rest.size(); ++v) {
        surface.positions[v].y() -= surface.rest[v].x() + surface.rest[v].z();
    }
    Bounds end{{0.5, -1, -1}, {0.5, 1, 1}};
    EXPECT_NEAR(app::sagOf(surface, end), 0.5, 1e-12);
    EXPECT_NEAR(app::volumeRatioOf(surface), 1, 1e-12);
}

TEST(LoadedSurface, ShapesThatAreAsideDifferByHowFarTheyAre) {
    const LoadedSurface here = boxAt({1, 1, 1}, Vec3::Zero());
    EXPECT_LT(app::shapeDeviation(here, here).largest, 1e-12);
    const app::ShapeDeviation aside = app::shapeDeviation(here, boxAt({1, 1, 1}, {0.1, 0, 0}));
    EXPECT_NEAR(aside.largest, 0.1, 1e-12);
    EXPECT_GT(aside.mean, 0);
    EXPECT_LT(aside.mean, 0.1);
    const app::ShapeDeviation larger = app::shapeDeviation(here, boxAt({1.4, 1, 1}, Vec3::Zero()));
    EXPECT_NEAR(larger.largest, 0.2, 1e-12);
}

TEST(LoadedSurface, AnOpeningIsMeasuredInTheMiddleOfTheUpperSide) {
    LoadedSurface surface;
    const auto addPair = [&](double y, double z, double gap) {
        const int first = static_cast<int>(surface.rest.size());
        surface.rest.insert(surface.rest.end(), 2, Vec3(0, y, z));
        surface.positions.emplace_back(0, y, z);
        surface.positions.emplace_back(gap, y, z);
        surface.lips.push_back({first, first + 1});
    };
    addPair(1, -1, 0.1);
    addPair(1, 3, 0.5);
    addPair(0.5, 0, 9);  // below
    EXPECT_NEAR(app::openingOf(surface), 0.2, 1e-12);
    EXPECT_EQ(app::openingOf(boxAt({1, 1, 1}, Vec3::Zero())), 0) << "not cut";
}

FemResult resultOf(double sag, double opening, double largest) {
    FemResult result;
    result.name = "bar-50";
    result.body = "notched bar";
    result.cut = "50 % of its height";
    result.setting = "20 iterations";
    result.kerf = {sag, opening, 1.02};
    result.elements = {0.010, 0.002, 1};
    result.coarse = {0.0098, 0.0019, 1};
    result.shape = {largest, largest / 4};
    result.diagonal = 0.4;
    return result;
}

TEST(FemReport, MarksWhatIsBeyondABar) {
    EXPECT_TRUE(resultOf(0.0114, 0.0018, 0.019).holds());
    EXPECT_FALSE(resultOf(0.0116, 0.0018, 0.019).holds()) << "sag";
    EXPECT_FALSE(resultOf(0.0114, 0.0016, 0.019).holds()) << "opening";
    EXPECT_FALSE(resultOf(0.0114, 0.0018, 0.021).holds()) << "shape";
    EXPECT_FALSE(resultOf(std::nan(""), 0.0018, 0.019).holds());
    FemResult grown = resultOf(0.0114, 0.0018, 0.019);
    grown.kerf.volumeRatio = 1.2;
    EXPECT_FALSE(grown.holds());
    const std::string report =
        app::formatFemReport({resultOf(0.0114, 0.0018, 0.019), resultOf(0.0116, 0.0018, 0.021)});
    EXPECT_NE(report.find("| 11.40 | 10.00 | +14.0 | 1.80 | 2.00 | -10.0 | 102.00 | 100.00 | +2.0 "
                          "| 4.75 | 1.19 | yes |"),
              std::string::npos)
        << report;
    EXPECT_NE(report.find("| 11.60 | 10.00 | +16.0 ! |"), std::string::npos) << report;
    EXPECT_NE(report.find("| 5.25 ! | 1.31 | no |"), std::string::npos) << report;
    EXPECT_NE(report.find("| 20 iterations | 1 of 2 | 2 of 2 | 2 of 2 | 1 of 2 | 1 of 2 |"),
              std::string::npos)
        << report;
    EXPECT_NE(report.find("| notched bar | 50 % of its height | -2.0 | -5.0 |"), std::string::npos)
        << "larger elements; " << report;
}

TEST(FemCases, AreTheSameBodiesForBoth) {
    for (const FemCase& each : app::femCases()) {
        const LoadedSurface elements =
            app::surfaceOf(each.solid.mesh, each.solid.mesh.nodes, each.cutPlane);
        const SurfaceMesh kerf =
            SurfaceMesh::fromTriangles(each.model.positions, each.model.triangles);
        double outside = 0;  // of Kerf's whole body, that the elements reach to
        for (const Vec3& p : elements.rest) {
            outside = std::max(outside, (p.cwiseAbs() - meshBounds(kerf).high).maxCoeff());
        }
        EXPECT_LT(outside, 1e-12) << each.name;
        const double share = each.name == "ball-half" ? 0.5 : 1;
        EXPECT_NEAR(solidVolume(each.solid.mesh, each.solid.mesh.nodes), share * meshVolume(kerf),
                    1e-12)
            << each.name;
        EXPECT_EQ(each.opens, !each.solid.mesh.lips.empty()) << each.name;
        int held = 0;
        for (const Hold& hold : each.solid.held) {
            held += hold[0] ? 1 : 0;
        }
        EXPECT_GT(held, 20) << each.name;
    }
}

class FemExperiment : public test::GlTest {};

// With the larger elements, to be quick.
TEST_F(FemExperiment, CutsABarAndComparesItAtRest) {
    const test::TemporaryFolder folder;
    app::OutputFolder out(folder.path());
    FemCase bar = app::femCase("bar-50");
    bar.solid = bar.coarseSolid;
    const std::vector<FemResult> results =
        app::runFemCases({bar}, app::femSettings().first(1), out);
    ASSERT_EQ(results.size(), 1u);
    const FemResult& result = results.front();
    EXPECT_TRUE(result.settled);
    // Finite elements of a bar that is whole sag by 15 mm.
    EXPECT_GT(*result.elements.sag, 0.015);
    EXPECT_GT(*result.elements.opening, 0.001);
    const double share = *result.kerf.sag / *result.elements.sag;  // Kerf is softer at a notch
    EXPECT_GT(share, 0.5);
    EXPECT_LT(share, 2);
    EXPECT_GT(*result.kerf.opening, 0.001);
    EXPECT_NEAR(result.kerf.volumeRatio, 1, 1e-3);
    EXPECT_GT(result.shape.largest, result.shape.mean);
    EXPECT_LT(result.shapeShare(), 0.1);
    EXPECT_GT(render::readPng(folder / result.picture).width, 3 * 600);

    // The session is an ordinary one: a replay comes to the same bits.
    const test::ProgramRun replay =
        test::runKerf({"replay", folder / result.session, "--out", folder / "replay", "--json"});
    ASSERT_EQ(replay.exitCode, 0) << replay.errors;
    EXPECT_EQ(nlohmann::json::parse(replay.out)["state_hash"], result.stateHash);
}

}  // namespace
}  // namespace kerf
