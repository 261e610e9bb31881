#include "app/scene/document/triangle_text.h"

#include <gmock/gmock.h>

#include "tests/support/shapes.h"

namespace kerf::app {
namespace {

using testing::StartsWith;

TEST(TriangleText, TellsNeedlesWhereThereAreSome) {
    TriangleFigures figures = figuresOf(test::boxSoup(Vec3(1, 20, 1)));
    EXPECT_THAT(trianglesText(figures), StartsWith("12 triangles, 8 of them needles; edges of "));
    figures.needles = 1;
    EXPECT_THAT(trianglesText(figures), StartsWith("12 triangles, 1 of them a needle; edges of "));
    figures.needles = 0;
    EXPECT_THAT(trianglesText(figures), StartsWith("12 triangles; edges of "));
}

}  // namespace
}  // namespace kerf::app
