#include "sim/body/skin_normals.h"
#include "tests/sim/body/hand_cut.h"

namespace kerf {
namespace {

/// [degrees]
double angleBetween(const Vec3& a, const Vec3& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / std::numbers::pi;
}

/// A mesh cut along the loop of its edges in the plane y = 0, and the normals carried through.
class LoopCut {
  public:
    explicit LoopCut(SurfaceMesh whole) : mesh(std::move(whole)), normals(mesh) {
        const int vertices = mesh.vertexCount();
        std::vector<Triangle> old;
        old.reserve(mesh.triangleSlots());
        for (int t = 0; t < mesh.triangleSlots(); ++t) {
            old.push_back(mesh.triangle(t));
        }
        const HandCut cut(mesh);
        normals.follow(mesh, vertices, old);
    }
    bool atWound(int v) const {
        const Vec3& p = mesh.restPosition(v);
        return std::fabs(p.y()) < 1e-12 && p.norm() > 1e-12;
    }

    SurfaceMesh mesh;
    SkinNormals normals;
};

/// However large its triangles are.
class RoundSkin : public testing::TestWithParam<double> {};

TEST_P(RoundSkin, KeepsItsNormalAtAWound) {
    const LoopCut body(cubeSphere(8, GetParam()));
    int found = 0;
    for (int v = 0; v < body.mesh.vertexCount(); ++v) {
        const Vec3 normal = body.normals.ofCut(body.mesh, v);
        if (!body.atWound(v)) {
            EXPECT_EQ(normal, Vec3::Zero()) << "its triangles give it";
            continue;
        }
        ++found;
        EXPECT_LT(angleBetween(normal, body.mesh.restPosition(v)), 2) << v;
    }
    EXPECT_GT(found, 20);
}

INSTANTIATE_TEST_SUITE_P(Radius, RoundSkin, testing::Values(0.005, 0.5, 50.0));

TEST(SkinNormals, AHardEdgeHasNoNormalOfItsOwn) {
    const LoopCut body(box(Vec3::Ones(), 4));
    int flat = 0;
    int hard = 0;
    for (int v = 0; v < body.mesh.vertexCount(); ++v) {
        const Vec3& p = body.mesh.restPosition(v);
        if (!body.atWound(v)) {
            continue;
        }
        const bool atEdge = std::fabs(std::fabs(p.x()) - std::fabs(p.z())) < 1e-9;
        const Vec3 normal = body.normals.ofCut(body.mesh, v);
        if (atEdge) {
            EXPECT_EQ(normal, Vec3::Zero()) << v;
            ++hard;
            continue;
        }
        const bool alongX = std::fabs(p.x()) > std::fabs(p.z());
        const Vec3 outwards(alongX ? p.x() : 0, 0, alongX ? 0 : p.z());
        EXPECT_LT(angleBetween(normal, outwards), 0.1) << v;
        ++flat;
    }
    EXPECT_EQ(hard, 2 * 4);
    EXPECT_EQ(flat, 2 * 4 * 3);
}

// A skin of its own thickness and modulus over the flesh (skin_thickness, skin_modulus).

/// What the skin adds to the energy of all edges, over the modulus of the flesh, where a body grows
/// by `strain` [m^3].
double addedByGrowing(const SurfaceMesh& mesh, double skin, double strain) {
    constexpr double kThickness = 0.1;
    double sum = 0;
    forEachEdge(mesh, [&](int h) {
        const EdgeConstraint with = edgeConstraint(mesh, h, kThickness, skin);
        const EdgeConstraint without = edgeConstraint(mesh, h, kThickness);
        const double square = std::pow(strain * with.rest_length, 2);
        sum += 0.5 * square * (1.0 / with.geometry - 1.0 / without.geometry);
    });
    return sum;
}

double areaOf(const SurfaceMesh& mesh) {
    double area = 0;
    for (const int t : livingTriangles(mesh)) {
        area += restArea(mesh, t);
    }
    return area;
}

// A sheet of modulus E, thickness t and Poisson's ratio 1/3 holds E t e^2 / (1 - 1/3) a square
// metre where it is stretched by e both ways.
TEST(SkinLayer, StretchesLikeASheetWhateverTheTriangles) {
    constexpr double kSkin = 0.02;
    constexpr double kStrain = 0.01;
    for (const SurfaceMesh& mesh : {icosphere(2), bentTube(), gradedSphere()}) {
        const double expected = 1.5 * kSkin * kStrain * kStrain * areaOf(mesh);
        EXPECT_NEAR(addedByGrowing(mesh, kSkin, kStrain), expected, 1e-3 * expected);
    }
}

/// Two equal triangles over one edge, of these kinds.
float geometryBetween(SurfaceKind left, SurfaceKind right, double skin) {
    SurfaceMesh mesh;
    for (const Vec3& p : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0.5, 1, 0), Vec3(0.5, -1, 0)}) {
        mesh.addVertex(p, p, Vec3::Zero());
    }
    mesh.addTriangle({0, 1, 2}, left, 0);
    mesh.addTriangle({1, 0, 3}, right, 0);
    mesh.link(0, 3);
    return edgeConstraint(mesh, 0, 0.1, skin).geometry;
}

TEST(SkinLayer, IsNotOnWalls) {
    constexpr SurfaceKind kSkin = SurfaceKind::skin;
    constexpr SurfaceKind kWall = SurfaceKind::wall;
    EXPECT_FLOAT_EQ(geometryBetween(kSkin, kSkin, 0.1), 0.5F * geometryBetween(kSkin, kSkin, 0));
    EXPECT_FLOAT_EQ(geometryBetween(kSkin, kWall, 0.1), geometryBetween(kSkin, kSkin, 0) / 1.5F);
    EXPECT_EQ(geometryBetween(kWall, kWall, 0.1), geometryBetween(kSkin, kSkin, 0));
}

class SkinLayerTest : public GlTest {};

constexpr double kWidth = 0.1;   // of a bar [m]
constexpr double kLength = 0.4;  // [m]
constexpr double kLoad = 2;      // [m/s^2]

Params soft() {
    Params params;
    params.youngsModulus = 1e4;
    params.gravity = {0, -kLoad, 0};
    params.floor.reset();
    params.airDrag = 20;
    return params;
}

/// How much longer a bar becomes that hangs by its top [m].
double lengthening(const Params& params) {
    Simulation simulation(meshOf(boxSoup({kWidth, kLength, kWidth}, 6)), params);
    simulation.execute(Pin{Bounds{{-1, 0.499 * kLength, -1}, {1, 1, 1}}});
    step(simulation, 500);
    return -0.5 * kLength - simulation.bounds().low.y();
}

// E A of a hanging bar of length L is rho g A L^2 / 2 over what it lengthens by.
TEST_F(SkinLayerTest, StiffensABarByModulusThicknessAndCircumference) {
    Params params = soft();
    const double load = 0.5 * params.density * kLoad * kWidth * kWidth * kLength * kLength;
    const double without = load / lengthening(params);
    params.skinThickness = 0.002;
    params.skinModulus = 1e5;
    const double added = load / lengthening(params) - without;
    const double expected = params.skinModulus * params.skinThickness * 4 * kWidth;
    // A grid of squares with diagonals is 1.2 times as stiff as a sheet along its edges, more where
    // the flesh holds its width.
    EXPECT_GT(added, 0.85 * expected);
    EXPECT_LT(added, 1.6 * expected) << added / expected;
}

std::string hashAfterAFall(const Params& params) {
    Simulation simulation(cubeSphere(3), params);
    step(simulation, 30);
    return simulation.stateHash();
}

TEST_F(SkinLayerTest, ChangesNoBitWhereItHasNoThickness) {
    Params params;
    const std::string none = hashAfterAFall(params);
    params.skinModulus = 1e8;
    EXPECT_EQ(hashAfterAFall(params), none);
    params.skinThickness = 0.01;
    EXPECT_NE(hashAfterAFall(params), none);
}

TEST_F(SkinLayerTest, FollowsACutAndUndo) {
    Params params = soft();
    params.skinThickness = 0.002;
    Simulation simulation(cubeSphere(4), params);
    simulation.setUndoBudget(std::size_t{1} << 30);
    makeStroke(simulation, {{-1, 0.7, 0.02}, {1, 0.7, 0.03}}, {{-1, -0.7, 0.02}, {1, -0.7, 0.03}},
               20);
    ASSERT_EQ(simulation.report().pieces, 2);
    const BodyModel& cut = simulation.bodyModel();
    EXPECT_GT(cut.members.front().skin, 0);
    simulation.execute(SetParam{"skin_thickness", 0.0});
    simulation.step();
    EXPECT_EQ(simulation.bodyModel().members.front().skin, 0);
    EXPECT_EQ(simulation.execute(Undo{}), "");
    simulation.step();
    EXPECT_GT(simulation.bodyModel().members.front().skin, 0);
}

}  // namespace
}  // namespace kerf
