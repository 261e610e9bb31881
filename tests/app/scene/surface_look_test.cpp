// What is under the pointer while the body moves: the same as of the whole mesh, without reading
// it.

#include "app/scene/readout/surface_look.h"

#include <gtest/gtest.h>

#include "tests/support/gl_fixture.h"
#include "tests/support/shapes.h"

namespace kerf::app {
namespace {

constexpr int kSteps = 12;

/// Falls, and is cut in the first steps.
class SurfaceLookTest : public test::GlTest {
  protected:
    static Simulation falling() { return Simulation(test::cubeSphere(12), Params{}); }
    static void step(Simulation& simulation, int i) {
        const Vec3 middle(0, 0.6 - 0.05 * i, 0.03);
        simulation.execute(MoveBlade{{middle - Vec3(0.8, 0, 0), middle + Vec3(0.8, 0, 0)}});
        simulation.step();
    }
    static render::Ray rayAt(double x, double y) { return {Vec3(x, y, 3), -Vec3::UnitZ()}; }
    static std::vector<Blade> wayAt(double y) {
        return {{Vec3(-0.7, y, 0.1), Vec3(0.7, y, 0.1)},
                {Vec3(-0.7, y - 0.3, 0.1), Vec3(0.7, y - 0.3, 0.1)}};
    }
};

TEST_F(SurfaceLookTest, FindsWhatTheWholeMeshHasWithoutReadingIt) {
    Simulation looked = falling();
    Simulation whole = falling();
    SurfaceLook look;
    int hits = 0;
    for (int i = 0; i < kSteps; ++i) {
        step(looked, i);
        step(whole, i);
        const int before = looked.wholeReads();
        for (const double x : {-0.3, 0.02, 0.24, 0.6}) {
            const auto found = look.pick(looked, rayAt(x, 0.1));
            const auto wanted =
                pickSurface(whole.mesh(), livingTriangles(whole.mesh()), rayAt(x, 0.1));
            ASSERT_EQ(found.has_value(), wanted.has_value()) << "step " << i << ", x " << x;
            if (wanted) {
                ++hits;
                EXPECT_EQ(found->triangle, wanted->triangle);
                EXPECT_EQ(found->position, wanted->position);
                EXPECT_EQ(found->normal, wanted->normal);
            }
        }
        const CutPreview& found = look.preview(looked, wayAt(0.3));
        const CutPreview wanted =
            previewCut(whole.mesh(), livingTriangles(whole.mesh()), wayAt(0.3));
        EXPECT_EQ(found.touched, wanted.touched) << "step " << i;
        EXPECT_EQ(found.wound, wanted.wound) << "step " << i;
        EXPECT_FALSE(wanted.touched.empty());
        EXPECT_EQ(looked.wholeReads(), before) << "step " << i;
    }
    EXPECT_GT(hits, 2 * kSteps);
    EXPECT_EQ(looked.stateHash(), whole.stateHash()) << "to look changes nothing";
}

TEST_F(SurfaceLookTest, NoWayTouchesNothing) {
    Simulation simulation = falling();
    SurfaceLook look;
    EXPECT_TRUE(look.preview(simulation, {}).touched.empty());
}

}  // namespace
}  // namespace kerf::app
