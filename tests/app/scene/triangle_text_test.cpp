#include "app/scene/document/triangle_text.h"

#include <gmock/gmock.h>

#include "tests/support/shapes.h"

namespace kerf::app {
namespace {

using testing::StartsWith;

TEST(TriangleText, TellsNeedlesWhereThereAreSome) {
    TriangleFigures figures = figuresOf(test::boxSoup(Vec3(1, 20, 1)));
    EXPECT_THAT(trianglesText(figures), StartsWith("12 triangles, 8 slivers; edge length "));
    figures.needles = 1;
    EXPECT_THAT(trianglesText(figures), StartsWith("12 triangles, 1 sliver; edge length "));
    figures.needles = 0;
    EXPECT_THAT(trianglesText(figures), StartsWith("12 triangles; edge length "));
}

}  // namespace
}  // namespace kerf::app
