#include "sim/body/ispc_builder.h"
#include "sim/body/ispc_set.h"

namespace kerf {
namespace {

std::vector<int> allTriangles(const SurfaceMesh& mesh) {
    std::vector<int> slots(mesh.triangleSlots());
    std::iota(slots.begin(), slots.end(), 0);
    return slots;
}

RayHit castAll(const SurfaceMesh& mesh, const std::vector<int>& slots, const Vec3& origin,
               const Vec3& direction) {
    return RayTree(mesh, slots).castToBackFace(origin, direction, 0, [](int) { return true; });
}

/// The answer without a tree: every triangle in a tree of its own.
RayHit castOneByOne(const SurfaceMesh& mesh, const Vec3& origin, const Vec3& direction) {
    RayHit best;
    best.distance = 1e300;
    for (const int slot : allTriangles(mesh)) {
        const RayHit hit = castAll(mesh, {slot}, origin, direction);
        if (hit.triangle >= 0 && hit.distance < best.distance) {
            best = hit;
        }
    }
    return best;
}

TEST(RayTree, FindsTheSameAsTryingEveryTriangle) {
    std::mt19937 random(11);
    std::normal_distribution<double> normal;
    const SurfaceMesh mesh = bentTube(20, 10);
    const RayTree tree(mesh, allTriangles(mesh));
    int hits = 0;
    for (int trial = 0; trial < 200; ++trial) {
        const Vec3 origin = 0.2 * Vec3(normal(random), normal(random), normal(random));
        const Vec3 direction = Vec3(normal(random), normal(random), normal(random)).normalized();
        const RayHit hit = tree.castToBackFace(origin, direction, 0, [](int) { return true; });
        const RayHit expected = castOneByOne(mesh, origin, direction);
        EXPECT_EQ(hit.triangle, expected.triangle) << "seed 11, trial " << trial;
        hits += hit.triangle >= 0;
    }
    EXPECT_GT(hits, 20);
}

TEST(RayTree, MissesNoRayThroughCornersAndEdges) {
    const SurfaceMesh mesh = box(Vec3::Ones(), 4);
    const RayTree tree(mesh, allTriangles(mesh));
    const auto any = [](int) { return true; };
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const Vec3 direction = mesh.restPosition(v).normalized();
        const RayHit hit = tree.castToBackFace(Vec3::Zero(), direction, 0, any);
        EXPECT_NEAR(hit.distance, mesh.restPosition(v).norm(), 1e-4) << v;
    }
}

TEST(RayTree, SeesBackFacesOnlyAndHonoursTheNearestDistance) {
    const SurfaceMesh mesh = box(Vec3::Ones(), 2);
    const RayTree tree(mesh, allTriangles(mesh));
    const auto any = [](int) { return true; };
    const Vec3 outside(0.1, 0.2, -3);
    EXPECT_NEAR(tree.castToBackFace(outside, Vec3::UnitZ(), 0, any).distance, 3.5, 1e-12);
    EXPECT_EQ(tree.castToBackFace(outside, Vec3::UnitZ(), 3.6, any).triangle, -1);
    EXPECT_EQ(tree.castToBackFace(outside, Vec3::UnitX(), 0, any).triangle, -1);
    EXPECT_EQ(tree.castToBackFace(outside, Vec3::UnitZ(), 0, [](int) { return false; }).triangle,
              -1);
}

TEST(RayTree, SegmentsCrossFromBothSidesButOnlyBetweenTheirEnds) {
    const SurfaceMesh mesh = box(Vec3::Ones(), 2);
    const RayTree tree(mesh, allTriangles(mesh));
    EXPECT_TRUE(tree.crosses({0.1, 0.2, 0}, {0.1, 0.2, 1}));
    EXPECT_TRUE(tree.crosses({0.1, 0.2, 1}, {0.1, 0.2, 0}));
    EXPECT_FALSE(tree.crosses({0.1, 0.2, 0}, {0.1, 0.2, 0.4}));
    EXPECT_FALSE(tree.crosses({0.1, 0.2, 2}, {0.1, 0.2, 0.6}));
    EXPECT_FALSE(RayTree(mesh, {}).crosses({0.1, 0.2, 0}, {0.1, 0.2, 1}));
}

TEST(RayTree, CopesWithTrianglesThatAllLieAtOnePlace) {
    TriangleSoup soup = boxSoup();
    for (int copies = 0; copies < 6; ++copies) {
        soup = joined(soup, soup, Vec3::Zero());
    }
    const SurfaceMesh mesh = meshOf(soup);
    const RayHit hit = castAll(mesh, allTriangles(mesh), {0.1, 0.2, 0}, Vec3::UnitX());
    EXPECT_NEAR(hit.distance, 0.4, 1e-12);
}

TEST(SegmentGrid, FindsEverySegmentThatPassesABox) {
    const unsigned seed = 9;
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    const auto point = [&] { return Vec3(uniform(random), uniform(random), uniform(random)); };
    Bounds box{Vec3(-1, -1, -1), Vec3(1, 1, 1)};
    const int count = 3000;
    SegmentGrid grid(box, count);
    std::vector<std::pair<Vec3, Vec3>> segments;
    for (int id = 0; id < count; ++id) {
        segments.emplace_back(point(), point());
        if (id % 7 == 0) {  // along an axis, through corners of cells
            segments.back() = {Vec3(-1, 0, 0.5), Vec3(1, 0, 0.5)};
        }
        grid.add(id, segments.back().first, segments.back().second);
    }
    int passed = 0;
    for (int id = 0; id < count; ++id) {
        const auto& [from, to] = segments[id];
        Bounds around;
        around.add(from + (to - from) * (0.5 + 0.5 * uniform(random)));
        around.widen(1e-9);
        const std::vector<int> found = grid.find({&around, 1});
        EXPECT_TRUE(std::ranges::binary_search(found, id)) << id;
        passed += static_cast<int>(found.size());
    }
    EXPECT_LT(passed, count * count / 5) << "a cell holds few of them";
    EXPECT_FALSE(grid.overfull());
}

TEST(SegmentGrid, TellsWhenItHoldsMuchThatIsOld) {
    Bounds box{Vec3(0, 0, 0), Vec3(1, 1, 1)};
    SegmentGrid grid(box, 500);
    int added = 0;
    while (!grid.overfull() && added < 100000) {
        grid.add(added++ % 500, Vec3(0, 0, 0), Vec3(1, 1, 1));
    }
    EXPECT_GT(added, 500);
    EXPECT_LT(added, 100000);
}

using Map = std::function<Vec3(const Vec3&)>;

std::vector<double> sharesWhere(SurfaceMesh mesh, const Map& place) {
    const BodyModel model = buildBodyModel(mesh);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        mesh.setPosition(v, place(mesh.restPosition(v)));
    }
    return sharesInsideOut(model, mesh);
}

double shareWhere(const Map& place) {
    return sharesWhere(cubeSphere(8), place).at(0);
}

TEST(InsideOut, IsNothingOfABodyThatIsBentTwistedOrStretched) {
    EXPECT_EQ(shareWhere([](const Vec3& p) { return p; }), 0);
    EXPECT_EQ(shareWhere([](const Vec3& p) { return Vec3(-p.y(), p.x() + 5, p.z()); }), 0);
    EXPECT_EQ(shareWhere([](const Vec3& p) { return Vec3(4 * p.x(), 0.3 * p.y(), p.z()); }), 0);
    EXPECT_EQ(
        shareWhere([](const Vec3& p) { return Vec3(Eigen::AngleAxisd(p.x(), Vec3::UnitX()) * p); }),
        0);
    EXPECT_EQ(shareWhere([](const Vec3& p) { return Vec3(p.x(), p.y() + p.x() * p.x(), p.z()); }),
              0);
}

TEST(InsideOut, IsAllOfAMirroredBody) {
    EXPECT_EQ(shareWhere([](const Vec3& p) { return Vec3(-p.x(), p.y(), p.z()); }), 1);
}

TEST(InsideOut, IsThePartThatWentThroughTheRest) {
    const double share = shareWhere([](const Vec3& p) {
        return Vec3(p.x(), p.y() > 0.3 ? 0.6 - 4 * p.y() : p.y(), p.z());  // the cap, far below
    });
    EXPECT_GT(share, 0.1);
    EXPECT_LT(share, 0.8);
}

TEST(InsideOut, IsToldOfEachPiece) {
    const SurfaceMesh two = meshOf(joined(icosphereSoup(1), icosphereSoup(1), {3, 0, 0}));
    const std::vector<double> shares = sharesWhere(
        two, [](const Vec3& p) { return p.x() > 1.5 ? Vec3(p.x(), -p.y(), p.z()) : p; });
    EXPECT_EQ(shares, (std::vector<double>{0, 1}));
}

}  // namespace
}  // namespace kerf
