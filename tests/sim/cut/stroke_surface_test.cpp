#include "sim/cut/surface/stroke_surface.h"

#include <gtest/gtest.h>

#include "sim/cut/cut_change.h"
#include "sim/cut/stroke/cutter.h"
#include "tests/support/cut_strokes.h"
#include "tests/support/shapes.h"

namespace kerf {
namespace {

double edgeOf(const SurfaceMesh& mesh) {
    return (mesh.position(mesh.target(0)) - mesh.position(mesh.origin(0))).norm();
}

std::size_t samplesAtPole(int subdivisions) {
    const SurfaceMesh mesh = test::icosphere(subdivisions);
    return cut::StrokeSurface(mesh).samplesAround({Vec3::UnitY()}, edgeOf(mesh)).size();
}

TEST(StrokeSurface, NeedsFewMoreSamplesOfALargeBody) {
    const std::size_t small = samplesAtPole(3);
    EXPECT_GT(small, 40u);
    EXPECT_LT(samplesAtPole(6), 2 * small);
}

TEST(StrokeSurface, SamplesAllThatIsNearAndStandsForTheWhole) {
    const SurfaceMesh mesh = test::icosphere(5);
    const double edge = edgeOf(mesh);
    const std::vector<Vec3> places{Vec3::UnitX(), -Vec3::UnitZ()};
    const auto samples = cut::StrokeSurface(mesh).samplesAround(places, edge);
    double weights = 0;
    for (const cut::SurfaceSample& sample : samples) {
        weights += sample.weight;
    }
    EXPECT_NEAR(weights, mesh.aliveTriangles(), 1e-6);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const bool near = std::ranges::any_of(
            places, [&](const Vec3& p) { return (mesh.position(v) - p).norm() < edge; });
        const bool sampled = std::ranges::any_of(
            samples, [&](const cut::SurfaceSample& sample) { return sample.vertex == v; });
        EXPECT_TRUE(sampled || !near) << v;
    }
}

TEST(StrokeSurface, FollowsCutsLikeOneThatIsMadeAnew) {
    SurfaceMesh mesh = test::icosphere(3);
    cut::StrokeSurface followed(mesh);
    constexpr double kMostRestMotion = 0.1;
    Cutter cutter(mesh, test::exactSettings());
    const test::Stroke stroke =
        test::straightStroke({0.013, 0.021, 0.3}, Vec3::UnitX(), -Vec3::UnitY(), 3, 2, 9);
    cutter.begin(stroke.front());
    for (std::size_t i = 1; i <= stroke.size(); ++i) {
        const CutResult result = i < stroke.size() ? cutter.advance(stroke[i]) : cutter.finish();
        followed.follow(changedTriangles(result.delta), kMostRestMotion);
    }
    followed.beginStroke();
    const cut::StrokeSurface fresh(mesh);
    EXPECT_EQ(followed.vertexCount(), fresh.vertexCount());
    int found = 0;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const Vec3 rest = 0.9 * mesh.restPosition(v);
        const auto a = followed.insidePosition(rest, mesh.position(v), 0.2);
        const auto b = fresh.insidePosition(rest, mesh.position(v), 0.2);
        EXPECT_EQ(a, b) << v;
        found += a.has_value();
    }
    EXPECT_GT(found, 500);
}

}  // namespace
}  // namespace kerf
