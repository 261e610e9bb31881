#include <gtest/gtest.h>

#include "sim/base/math.h"

namespace kerf {
namespace {

// In place and side by side, as the vectoriser of GCC 12 got it wrong.
TEST(FloatRounding, EachComponentBecomesAFloat) {
    std::vector<Vec3> places(3, Vec3(1 / 3., -1 / 7., 1e-9 / 11.));
    for (Vec3& place : places) {
        place = nearestFloats(place);
    }
    for (const Vec3& place : places) {
        for (int i = 0; i < 3; ++i) {
            const volatile float stored = static_cast<float>(place[i]);
            EXPECT_EQ(place[i], static_cast<double>(stored)) << i;
        }
        EXPECT_FLOAT_EQ(static_cast<float>(place.x()), 1 / 3.f);
    }
}

}  // namespace
}  // namespace kerf
