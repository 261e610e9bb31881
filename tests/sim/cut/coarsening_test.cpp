#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "sim/cut/cleanup/copies.h"
#include "sim/cut/stroke/cutter.h"
#include "sim/mesh/invariants.h"
#include "tests/support/cut_strokes.h"
#include "tests/support/shapes.h"

namespace kerf {
namespace {

using test::Stroke;

constexpr double kCoarseWallEdge = 0.04;
constexpr double kFactor = 3;
const Vec3 kSphereCenter(0.013, 0.021, 0.034);

CutSettings settingsWith(double coarsening) {
    CutSettings settings = test::exactSettings();
    settings.wallEdgeLength = kCoarseWallEdge;
    settings.wallCoarsening = coarsening;
    return settings;
}

Stroke down() {
    return test::straightStroke(kSphereCenter, Vec3::UnitX(), -Vec3::UnitY(), 3.0, 2.4, 50);
}

Stroke inItsPlane() {
    return test::straightStroke(Vec3(0.003, 0.0012, 0.007), Vec3::UnitX(), Vec3::UnitZ(), 3.0, 2.4,
                                50);
}

/// Bends about half a radius aside on its way down.
Stroke curved() {
    Stroke stroke = down();
    for (Blade& blade : stroke) {
        const Vec3 aside = 0.2 * std::sin(2 * blade.a.y()) * Vec3::UnitZ();
        blade.a += aside;
        blade.b += aside;
    }
    return stroke;
}

/// From above, the tip about the middle of the body.
Stroke slit() {
    Stroke stroke;
    for (int i = 0; i <= 40; ++i) {
        const double x = -0.8 + 1.6 * i / 40;
        stroke.push_back({{x, 1.5, 0.011}, {x + 0.01, -0.1, 0.013}});
    }
    return stroke;
}

struct CoarseCase {
    const char* name;
    SurfaceMesh mesh;
    std::vector<Stroke> strokes;
};

std::vector<CoarseCase> coarseCases() {
    const Stroke across = test::straightStroke(kSphereCenter, Vec3(1, 0.2, 0.1).normalized(),
                                               Vec3::UnitZ(), 3.0, 2.4, 50);
    return {{"sphere", test::icosphere(3), {down()}},
            {"ring cut in its plane", test::torus(48, 24), {inItsPlane()}},
            {"sphere, curved", test::icosphere(3), {curved()}},
            {"sphere, slit", test::icosphere(3), {slit()}},
            {"sphere, across a cut", test::icosphere(3), {down(), across}}};
}

void run(SurfaceMesh& mesh, const CutSettings& settings, const Stroke& stroke) {
    Cutter cutter(mesh, settings);
    cutter.begin(stroke.front());
    for (const Blade& blade : stroke) {
        EXPECT_EQ(cutter.advance(blade).statistics.refusedPieces, 0);
    }
    cutter.finish();
}

/// Coarsens the walls of the last stroke.
SurfaceMesh cutBody(const CoarseCase& sample, double coarsening) {
    SurfaceMesh mesh = sample.mesh;
    for (const Stroke& stroke : sample.strokes) {
        run(mesh, settingsWith(&stroke == &sample.strokes.back() ? coarsening : 1), stroke);
    }
    return mesh;
}

using WallSegment = std::array<double, 6>;

/// Both ends of all half-edges that lie on rims, ends of slits and crossings, sorted.
std::vector<WallSegment> outlineOf(const SurfaceMesh& mesh) {
    std::vector<WallSegment> outline;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        if (mesh.outgoing(v) < 0) {
            continue;
        }
        const cut::SharedStar star = cut::starOf(mesh, v);
        mesh.forEachOutgoing(v, [&](int h) {
            if (star.edgeTo(mesh.firstCopy(mesh.target(h)))->isFeature()) {
                const Vec3& p = mesh.position(v);
                const Vec3& q = mesh.position(mesh.target(h));
                outline.push_back({p.x(), p.y(), p.z(), q.x(), q.y(), q.z()});
            }
        });
    }
    std::ranges::sort(outline);
    return outline;
}

std::vector<int> trianglesOf(const SurfaceMesh& mesh, SurfaceKind kind) {
    std::vector<int> triangles = livingTriangles(mesh);
    std::erase_if(triangles, [&](int t) { return mesh.kind(t) != kind; });
    return triangles;
}

std::vector<Triangle> cornersOf(const SurfaceMesh& mesh, const std::vector<int>& triangles) {
    std::vector<Triangle> corners;
    corners.reserve(triangles.size());
    for (const int t : triangles) {
        corners.push_back(mesh.triangle(t));
    }
    return corners;
}

double longestEdge(const SurfaceMesh& mesh, const std::vector<int>& triangles) {
    double longest = 0;
    for (const int t : triangles) {
        for (int h = 3 * t; h < 3 * t + 3; ++h) {
            longest = std::max(
                longest, (mesh.position(mesh.target(h)) - mesh.position(mesh.origin(h))).norm());
        }
    }
    return longest;
}

void expectSamePieces(const SurfaceMesh& fine, const SurfaceMesh& coarse) {
    const std::vector<Piece> before = findPieces(fine).pieces;
    const std::vector<Piece> after = findPieces(coarse).pieces;
    ASSERT_EQ(before.size(), after.size());
    for (std::size_t i = 0; i < before.size(); ++i) {
        EXPECT_NEAR(after[i].volume, before[i].volume, 1e-9 * before[i].volume);
        EXPECT_NEAR(after[i].restVolume, before[i].restVolume, 1e-9 * before[i].restVolume);
    }
}

TEST(WallCoarsening, ThinsTheInsideAndKeepsTheOutline) {
    for (const CoarseCase& sample : coarseCases()) {
        SCOPED_TRACE(sample.name);
        const SurfaceMesh fine = cutBody(sample, 1);
        const SurfaceMesh coarse = cutBody(sample, kFactor);
        EXPECT_EQ(outlineOf(coarse), outlineOf(fine));
        EXPECT_EQ(cornersOf(coarse, trianglesOf(coarse, SurfaceKind::skin)),
                  cornersOf(fine, trianglesOf(fine, SurfaceKind::skin)));
        expectSamePieces(fine, coarse);
        const std::vector<int> walls = trianglesOf(coarse, SurfaceKind::wall);
        const std::vector<int> fineWalls = trianglesOf(fine, SurfaceKind::wall);
        // Only the walls of the last stroke become coarser.
        const std::size_t tenths = sample.strokes.size() == 1 ? 5 : 8;
        EXPECT_LT(10 * walls.size(), tenths * fineWalls.size());
        EXPECT_LE(longestEdge(coarse, walls),
                  std::max(longestEdge(fine, fineWalls), kFactor * kCoarseWallEdge * 4 / 3));
        EXPECT_EQ(checkClosedManifold(coarse), "");
        EXPECT_EQ(test::checkMirroredWalls(coarse), "");
    }
}

TEST(WallCoarsening, OfOneChangesNothing) {
    const CoarseCase sample = coarseCases().front();
    SurfaceMesh mesh = sample.mesh;
    CutSettings settings = test::exactSettings();
    settings.wallEdgeLength = kCoarseWallEdge;
    run(mesh, settings, sample.strokes[0]);
    EXPECT_EQ(test::fingerprint(cutBody(sample, 1)), test::fingerprint(mesh));
}

}  // namespace
}  // namespace kerf
