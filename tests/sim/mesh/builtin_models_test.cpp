#include <gtest/gtest.h>

#include <cstdlib>

#include "sim/mesh/invariants.h"
#include "sim/repair/soup_inspection.h"
#include "tests/paths.h"
#include "tests/support/nightly.h"
#include "tests/support/shapes.h"
#include "tests/support/temporary_folder.h"

namespace kerf {
namespace {

namespace fs = std::filesystem;

struct Expected {
    std::string name;
    int vertices;
    int triangles;
    double maxEdgeRatio;    ///< longest to shortest edge of the whole model
    double minHeightRatio;  ///< height to longest edge of the worst triangle
};

std::ostream& operator<<(std::ostream& out, const Expected& expected) {
    return out << expected.name;
}

class BuiltinModel : public ::testing::TestWithParam<Expected> {};

struct Evenness {
    double shortest = std::numeric_limits<double>::max();
    double longest = 0;
    double heightRatio = 1;
};

Evenness measureEvenness(const TriangleSoup& soup) {
    Evenness even;
    for (const auto& [a, b, c] : soup.triangles) {
        const Vec3 ab = soup.positions[b] - soup.positions[a];
        const Vec3 bc = soup.positions[c] - soup.positions[b];
        const Vec3 ca = soup.positions[a] - soup.positions[c];
        const double longest = std::max({ab.norm(), bc.norm(), ca.norm()});
        even.shortest = std::min({even.shortest, ab.norm(), bc.norm(), ca.norm()});
        even.longest = std::max(even.longest, longest);
        even.heightRatio = std::min(even.heightRatio, ab.cross(ca).norm() / (longest * longest));
    }
    return even;
}

TEST_P(BuiltinModel, HasItsCounts) {
    const MeshReport report = inspectTriangles(test::builtinSoup(GetParam().name));
    EXPECT_EQ(report.vertices, GetParam().vertices);
    EXPECT_EQ(report.triangles, GetParam().triangles);
}

TEST_P(BuiltinModel, IsOneClosedPieceWithoutHandles) {
    const TriangleSoup soup = test::builtinSoup(GetParam().name);
    const MeshReport report = inspectTriangles(soup);
    EXPECT_TRUE(report.cuttable) << report.problem;
    EXPECT_EQ(report.pieces, 1);
    EXPECT_EQ(report.vertices - report.triangles / 2, 2) << "Euler characteristic";
    EXPECT_EQ(checkClosedManifold(test::builtin(GetParam().name)), "");
}

TEST_P(BuiltinModel, IsEvenlyMeshed) {
    const Evenness even = measureEvenness(test::builtinSoup(GetParam().name));
    EXPECT_LT(even.longest / even.shortest, GetParam().maxEdgeRatio);
    EXPECT_GT(even.heightRatio, GetParam().minHeightRatio);
}

TEST_P(BuiltinModel, IsAboutAMetreLongAroundTheOrigin) {
    const Bounds bounds = inspectTriangles(test::builtinSoup(GetParam().name)).bounds;
    EXPECT_LT(bounds.center().norm(), 1e-5);
    EXPECT_NEAR((bounds.high - bounds.low).maxCoeff(), 1, 0.2);
}

INSTANTIATE_TEST_SUITE_P(Assets, BuiltinModel,
                         ::testing::Values(Expected{"sphere20", 12, 20, 1.001, 0.86},
                                           Expected{"sphere80", 42, 80, 1.2, 0.7},
                                           Expected{"sphere768", 386, 768, 2, 0.45},
                                           Expected{"banana", 3147, 6290, 2, 0.4},
                                           Expected{"octopus", 5800, 11596, 2, 0.4}),
                         [](const auto& test) { return test.param.name; });

TEST(BuiltinModels, ScriptMakesTheCommittedFiles) {
    KERF_BY_NIGHT();  // neither script nor files change by themselves
    if (std::system("/usr/bin/python3 -c 'import numpy' 2>/dev/null") != 0) {
        GTEST_SKIP() << "python3-numpy is not installed; the script needs it";
    }
    const test::TemporaryFolder made;
    const fs::path folder = fs::path(KERF_SOURCE_DIR) / "assets" / "models";
    const std::string command = "/usr/bin/python3 -B '" + (folder / "make_models.py").string() +
                                "' '" + made.path().string() + "' >/dev/null";
    EXPECT_EQ(std::system(command.c_str()), 0);
    for (const char* name : {"sphere20", "sphere80", "sphere768", "banana", "octopus"}) {
        const std::string file = std::string(name) + ".obj";
        EXPECT_TRUE(test::readBytes(folder / file) == test::readBytes(made / file)) << file;
    }
}

}  // namespace
}  // namespace kerf
