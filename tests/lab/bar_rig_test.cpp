#include "bench/lab/bar_rig.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "bench/lab/bar_experiment.h"
#include "sim/mesh/box_surface.h"
#include "sim/mesh/triangle.h"
#include "tests/support/finite_elements.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/run_kerf.h"
#include "tests/support/temporary_folder.h"

namespace kerf {
namespace {

using app::BenchResult;
using app::BenchRun;
using app::BenchSetting;
using app::SpecimenKind;
using test::ElasticSolid;

constexpr double kDensity = 1000;
constexpr double kGravity = 5;
const Vec3 kBar(0.1, 0.4, 0.1);

/// The bar of the test bench as a solid: its top holds, and each node on its skin has the weight of
/// a third of the area around it, as in Kerf, which acts along `down`.
ElasticSolid hangingSolid(int cells, double poisson, const Vec3& down = -Vec3::UnitY()) {
    ElasticSolid solid = test::solidBox(kBar, {cells, 4 * cells, cells});
    solid.poissonRatio = poisson;
    const TriangleSoup skin = boxSurface(kBar, {cells, 4 * cells, cells});
    std::map<std::array<double, 3>, int> nodeAt;
    for (std::size_t n = 0; n < solid.nodes.size(); ++n) {
        const Vec3& p = solid.nodes[n];
        nodeAt[{p.x(), p.y(), p.z()}] = static_cast<int>(n);
        solid.supported[n].fill(p.y() == kBar.y() / 2);
    }
    const double weight = kDensity * kGravity * kBar.prod();
    const double surface = 2 * (kBar.x() * kBar.y() + kBar.y() * kBar.z() + kBar.z() * kBar.x());
    for (const Triangle& t : skin.triangles) {
        const double area =
            triangleArea(skin.positions[t[0]], skin.positions[t[1]], skin.positions[t[2]]);
        for (const int corner : t) {
            const Vec3& p = skin.positions[corner];
            solid.loads[nodeAt.at({p.x(), p.y(), p.z()})] += weight * area / surface / 3 * down;
        }
    }
    return solid;
}

/// By how much the lower end comes down, over what a bar without clamps would do.
double deflectionOverTheory(const ElasticSolid& solid) {
    const std::vector<Vec3> displacements = test::solveElastic(solid);
    double moved = 0;
    int count = 0;
    double theory = 0;
    for (std::size_t n = 0; n < solid.nodes.size(); ++n) {
        const double below = kBar.y() / 2 - solid.nodes[n].y();
        theory -= solid.loads[n].y() * below / (solid.youngsModulus * kBar.x() * kBar.z());
        if (below == kBar.y()) {
            moved -= displacements[n].y();
            ++count;
        }
    }
    return moved / count / theory;
}

/// How far the lower end moves aside, over what a bar of Euler and Bernoulli would do.
double bendingOverTheory(const ElasticSolid& solid) {
    const std::vector<Vec3> displacements = test::solveElastic(solid);
    const double secondMoment = kBar.z() * std::pow(kBar.x(), 3) / 12;
    double moved = 0;
    int count = 0;
    double theory = 0;
    for (std::size_t n = 0; n < solid.nodes.size(); ++n) {
        const double below = kBar.y() / 2 - solid.nodes[n].y();
        theory += solid.loads[n].x() * below * below * (3 * kBar.y() - below) /
                  (6 * solid.youngsModulus * secondMoment);
        if (below == kBar.y()) {
            moved += displacements[n].x();
            ++count;
        }
    }
    return moved / count / theory;
}

TEST(FiniteElements, StretchUniformlyUnderUniformTension) {
    const Vec3 size(0.2, 0.3, 0.1);
    ElasticSolid solid = test::solidBox(size, {2, 3, 2});
    solid.poissonRatio = 0.4;
    const double stress = 700;
    for (std::size_t n = 0; n < solid.nodes.size(); ++n) {
        for (int axis = 0; axis < 3; ++axis) {
            solid.supported[n][axis] = solid.nodes[n][axis] == -size[axis] / 2;
        }
    }
    const ElasticSolid& s = solid;
    // Consistent loads of the tetrahedra's faces on the upper end.
    for (const std::array<int, 4>& t : s.tetrahedra) {
        std::vector<int> face;
        for (const int n : t) {
            if (s.nodes[n].y() == size.y() / 2) {
                face.push_back(n);
            }
        }
        if (face.size() == 3) {
            const double area = triangleArea(s.nodes[face[0]], s.nodes[face[1]], s.nodes[face[2]]);
            for (const int n : face) {
                solid.loads[n].y() += stress * area / 3;
            }
        }
    }
    const std::vector<Vec3> moved = test::solveElastic(solid);
    const double strain = stress / solid.youngsModulus;
    for (std::size_t n = 0; n < solid.nodes.size(); ++n) {
        const Vec3 from = solid.nodes[n] + size / 2;
        const Vec3 expected = strain * Vec3(-0.4 * from.x(), from.y(), -0.4 * from.z());
        EXPECT_LT((moved[n] - expected).norm(), 1e-12) << n;
    }
}

TEST(FiniteElements, RefuseASolidThatCanMoveFreely) {
    ElasticSolid solid = test::solidBox(kBar, {1, 2, 1});
    solid.loads[0] = Vec3::UnitY();
    EXPECT_THROW(test::solveElastic(solid), std::runtime_error);
}

TEST(FiniteElements, AgreeWithTheFormulaOfTheBarRig) {
    // The clamped top stiffens a little, the more so the less the solid can be compressed.
    EXPECT_NEAR(deflectionOverTheory(hangingSolid(4, 0.0)), 1, 1e-2);
    EXPECT_NEAR(deflectionOverTheory(hangingSolid(4, 0.3)), 1, 0.03);
    EXPECT_NEAR(deflectionOverTheory(hangingSolid(4, 0.45)), 1, 0.08);
}

// Constant-strain tetrahedra are too stiff where they bend, the less the finer they are.
TEST(FiniteElements, ApproachTheFormulaForBending) {
    const double coarse = bendingOverTheory(hangingSolid(3, 0.3, Vec3::UnitX()));
    const double fine = bendingOverTheory(hangingSolid(6, 0.3, Vec3::UnitX()));
    EXPECT_GT(coarse, 0.5);
    EXPECT_GT(fine, coarse + 0.05);
    EXPECT_LT(fine, 1.1);
}

class BarRig : public test::GlTest {};

TEST_F(BarRig, TheBarsModulusIsOfTheParametersSize) {
    const BenchSetting setting{.cells = 3, .trueModulus = false};
    const BenchResult result = app::measureModulus(setting);
    EXPECT_TRUE(result.settled);
    EXPECT_NEAR(result.volumeRatio, 1, 1e-3);
    EXPECT_NEAR(result.effectiveModulus / setting.modulus, 1.5, 0.3) << "docs/physics.md";
}

TEST_F(BarRig, WithATrueModulusABodyIsAsStiffAsTheParameterSays) {
    for (const SpecimenKind kind : {SpecimenKind::hangingBar, SpecimenKind::compressedBlock,
                                    SpecimenKind::shearedBlock, SpecimenKind::hangingCube}) {
        const BenchSetting setting{.kind = kind, .cells = 3};
        const BenchResult result = app::measureModulus(setting);
        EXPECT_TRUE(result.settled);
        EXPECT_FALSE(result.tooFewIterations);
        EXPECT_NEAR(result.volumeRatio, 1, 1e-3);
        EXPECT_NEAR(result.effectiveModulus / setting.modulus, 1, 0.2) << static_cast<int>(kind);
    }
}

// Sweeps add no compliance of their own, as far as the program does not say that they do.
TEST_F(BarRig, WithATrueModulusIterationsBuyNoStiffness) {
    BenchSetting setting{.kind = SpecimenKind::compressedBlock, .cells = 2, .modulus = 1e5};
    const BenchResult many = app::measureModulus(setting);
    setting.iterations = 5;
    const BenchResult few = app::measureModulus(setting);
    EXPECT_FALSE(few.tooFewIterations);
    EXPECT_NEAR(few.effectiveModulus / many.effectiveModulus, 1, 0.03);
    setting.modulus = 1e7;
    const BenchResult tooFew = app::measureModulus(setting);
    EXPECT_TRUE(tooFew.tooFewIterations);
    EXPECT_LT(tooFew.effectiveModulus, 0.75 * setting.modulus);
}

// They buy accuracy: the error falls with the length of a substep.
TEST_F(BarRig, WithATrueModulusIterationsBuyAccuracy) {
    const std::vector<app::AccuracyRun> runs = app::measureAccuracy({10, 20, 40}, {0.005});
    EXPECT_GT(app::orderOf(runs), 0.8);
    EXPECT_LT(runs.back().error, 0.02);
}

TEST(BarReport, TakesTheOrderFromErrorsAndSubsteps) {
    const std::vector<app::AccuracyRun> runs{{10, 0.01, 0.16}, {20, 0.01, 0.04}, {20, 0.005, 0.01}};
    EXPECT_NEAR(app::orderOf(runs), 2, 1e-9);
    EXPECT_NE(app::formatAccuracy(runs).find("| 20 | 0.005 | 0.25 | 1 |"), std::string::npos);
}

// Rays along the normal hold the two faces of a slab apart but let them slide over each other.
TEST_F(BarRig, ABentBarIsTrueToTheParameterAndAWideSlabSofter) {
    BenchSetting setting{.kind = SpecimenKind::bentBar, .cells = 4, .trueModulus = false};
    const BenchResult bar = app::measureModulus(setting);
    setting.kind = SpecimenKind::bentSlab;
    const BenchResult slab = app::measureModulus(setting);
    EXPECT_TRUE(bar.settled);
    EXPECT_TRUE(slab.settled);
    EXPECT_NEAR(bar.effectiveModulus / setting.modulus, 1.2, 0.3) << "docs/physics.md";
    EXPECT_NEAR(slab.effectiveModulus / setting.modulus, 0.6, 0.2) << "docs/physics.md";
}

// The drag is critical for the parameter's modulus; what is softer by far creeps.
TEST_F(BarRig, ABarThatIsMuchSofterThanItsParameterComesToRestAllTheSame) {
    const BenchSetting setting{
        .kind = SpecimenKind::bentBar, .modulus = 1e6, .iterations = 5, .trueModulus = false};
    const BenchResult result = app::measureModulus(setting);
    EXPECT_TRUE(result.settled);
    EXPECT_NEAR(result.effectiveModulus / setting.modulus, 0.09, 0.03) << "docs/physics.md";
}

TEST_F(BarRig, TooFewIterationsMakeAStiffBlockSoft) {
    BenchSetting setting{
        .kind = SpecimenKind::compressedBlock, .cells = 2, .modulus = 1e6, .trueModulus = false};
    setting.iterations = 5;
    const BenchResult few = app::measureModulus(setting);
    setting.iterations = 40;
    const BenchResult many = app::measureModulus(setting);
    EXPECT_GT(many.effectiveModulus, 2 * few.effectiveModulus) << "Jacobi needs small substeps";
    EXPECT_LT(few.effectiveModulus, 0.7 * setting.modulus);
    EXPECT_GT(many.effectiveModulus, setting.modulus);
    EXPECT_TRUE(few.tooFewIterations);
    EXPECT_FALSE(many.tooFewIterations);
}

TEST_F(BarRig, AThinBarInLongStepsIsSoftAndTheProgramSaysSo) {
    const BenchResult result = app::measureModulus(
        {.kind = SpecimenKind::hangingBar, .cells = 2, .iterations = 5, .timeStep = 0.01});
    EXPECT_TRUE(result.settled);
    EXPECT_LT(result.effectiveModulus, 0.9 * 1e5);
    EXPECT_TRUE(result.tooFewIterations);
}

BenchRun runThat(bool settled, double volumeRatio, SpecimenKind kind = SpecimenKind::bentBar) {
    BenchRun run;
    run.setting = {.kind = kind, .cells = 3, .modulus = 1e5};
    run.result.effectiveModulus = 1.25e5;
    run.result.volumeRatio = volumeRatio;
    run.result.settled = settled;
    return run;
}

/// What reportBarRuns left.
struct Reported {
    int exitCode = -1;
    std::string out;
    std::string errors;
    nlohmann::json summary;
    std::string report;
};

Reported reportOf(const std::vector<BenchRun>& runs, bool json = false) {
    const test::TemporaryFolder folder;
    std::ostringstream out;
    std::ostringstream errors;
    app::OutputFolder own(folder.path());
    const int exitCode = app::reportBarRuns(runs, {}, own, json, out, errors);
    return {exitCode, out.str(), errors.str(),
            nlohmann::json::parse(test::readBytes(folder / "summary.json")),
            test::readBytes(folder / "report.md")};
}

TEST(BarReport, SpecimensThatStillMoveAreAFindingAndNoFailure) {
    const Reported reported = reportOf({runThat(true, 1), runThat(false, 1, SpecimenKind::bentSlab),
                                        runThat(false, 1, SpecimenKind::hangingBar)});
    EXPECT_EQ(reported.exitCode, 0);
    EXPECT_EQ(reported.errors,
              "bar: 2 specimens were still moving when time was up, so what stands there is not "
              "final: bent slab, E = 1e+05 Pa, 3 cells, 20 iterations of 0.005 s, true modulus; "
              "hanging bar, "
              "E = 1e+05 Pa, 3 cells, 20 iterations of 0.005 s, true modulus.\n");
    EXPECT_EQ(reported.summary["still_moving"].size(), 2u);
    EXPECT_EQ(reported.summary["tests"].size(), 3u);
    EXPECT_NE(reported.report.find("| bent bar | 1e+05 | - | 1.25 | - | - |"), std::string::npos);
    EXPECT_NE(reported.report.find("| bent slab | 1e+05 | - | 1.25 (still moving) | - | - |"),
              std::string::npos);
    EXPECT_EQ(reported.out, reported.report);
}

TEST(BarReport, LostVolumeIsAFailure) {
    const Reported reported = reportOf({runThat(true, 1), runThat(true, 0.97)}, true);
    EXPECT_EQ(reported.exitCode, 1);
    EXPECT_EQ(reported.errors,
              "bar: bent bar, E = 1e+05 Pa, 3 cells, 20 iterations of 0.005 s, true modulus: the "
              "volume is 97.00 % of what it was.\n");
    EXPECT_EQ(nlohmann::json::parse(reported.out), reported.summary);
    EXPECT_TRUE(reported.summary["still_moving"].empty());
    EXPECT_TRUE(reported.summary["still_moving"].is_array());
    EXPECT_EQ(reportOf({runThat(false, std::nan(""))}).exitCode, 1)
        << "it left the range of numbers";
}

TEST(BarReport, CountsWhatHoldsByWhetherIterationsAreEnough) {
    std::vector<BenchRun> runs{runThat(true, 1), runThat(true, 1), runThat(true, 1)};
    runs[1].result.effectiveModulus = 1.3e5;
    runs[2].result.tooFewIterations = true;
    const app::BarCount enough = app::countBarRuns(runs, true, false);
    EXPECT_EQ(enough.all, 2);
    EXPECT_EQ(enough.within10, 0);
    EXPECT_EQ(enough.within25, 1);
    EXPECT_EQ(app::countBarRuns(runs, true, true).all, 1);
    EXPECT_EQ(app::countBarRuns(runs, false, false).all, 0);
}

TEST(BarReport, TheWholeIsAllCombinations) {
    const std::size_t perModulus = 4 * 5 * 3;
    EXPECT_EQ(app::barSettings(true).size(), 2 * 7 * 3 * perModulus);
    EXPECT_EQ(app::barSettings(false).size(), 2 * 7 * 3 * (3 + 4 + 2 + 1));
}

TEST(BarReport, PutsEachTestInItsPlace) {
    BenchRun run;
    run.setting = {.kind = SpecimenKind::compressedBlock, .cells = 3, .modulus = 1e5};
    run.result.effectiveModulus = 1.25e5;
    run.result.settled = true;
    const std::string report = app::formatBarReport({run});
    EXPECT_NE(report.find("| compressed block | 1e+05 | - | 1.25 | - | - |"), std::string::npos)
        << report;
}

}  // namespace
}  // namespace kerf
