#include "app/editor/view/rest_depths.h"

#include <gtest/gtest.h>

#include "tests/support/shapes.h"

namespace kerf {
namespace {

std::shared_ptr<const UncutBody> ballOf(double radius) {
    return makeUncutBody(test::meshOf(test::icosphereSoup(2, radius)), {{}});
}

TEST(RestDepths, AreThoseThatWereNotedOrElseMeasured) {
    app::RestDepths depths;
    const auto noted = ballOf(0.5);
    const auto unknown = ballOf(0.25);
    render::DepthField field;
    field.deepest = 42;
    depths.note(noted, field);
    EXPECT_EQ(depths.of(noted).deepest, 42);
    EXPECT_EQ(depths.of(unknown).values, render::measureSkinDepth(unknown->mesh).values);
    EXPECT_NEAR(depths.of(unknown).deepest, 0.25, 0.02);
    EXPECT_EQ(depths.of(noted).deepest, 42) << "others are kept";
}

TEST(RestDepths, OfABodyThatIsGoneSayNothingOfTheNext) {
    app::RestDepths depths;
    for (const double radius : {0.5, 0.25, 0.125}) {
        EXPECT_NEAR(depths.of(ballOf(radius)).deepest, radius, 0.1 * radius);
    }
}

}  // namespace
}  // namespace kerf
