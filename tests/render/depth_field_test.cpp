#include "render/scene/depth_field.h"

#include <gtest/gtest.h>

#include "tests/support/shapes.h"

namespace kerf::render {
namespace {

/// Largest difference between the field and `expected(point)` [m].
template <class F>
double worstError(const DepthField& field, F&& expected) {
    double worst = 0;
    for (int z = 0; z < field.size[2]; ++z) {
        for (int y = 0; y < field.size[1]; ++y) {
            for (int x = 0; x < field.size[0]; ++x) {
                const Vec3 point = field.origin + field.spacing * Vec3(x, y, z);
                const double depth = field.deepest * field.values[field.index(x, y, z)];
                worst = std::max(worst, std::abs(depth - expected(point)));
            }
        }
    }
    return worst;
}

double sampled(const DepthField& field, const Vec3& sample) {
    const Vec3 i = ((sample - field.origin) / field.spacing).array().round();
    return field.deepest * field.values[field.index(int(i.x()), int(i.y()), int(i.z()))];
}

TEST(DepthField, OfASphereIsTheDistanceToItsSurface) {
    const double radius = 0.5;
    const DepthField field = measureDepth(test::icosphere(4, radius), 32);
    const auto depth = [&](const Vec3& p) { return radius - p.norm(); };
    const auto nearDepth = [&](const Vec3& p) {
        return std::abs(depth(p)) < field.spacing ? depth(p) : sampled(field, p);
    };
    // Where triangles were measured themselves: the mesh lies up to 0.0006 m inside the sphere.
    EXPECT_LT(worstError(field, nearDepth), 0.001);
    // Elsewhere a neighbour's triangle may not be the very nearest.
    EXPECT_LT(worstError(field, depth), 0.02 * radius);
    EXPECT_NEAR(field.deepest, radius, field.spacing);
}

TEST(DepthField, OfABoxHasEdgesAndCorners) {
    const Vec3 half(0.5, 0.3, 0.2);
    const DepthField field = measureDepth(test::box(2 * half, 3), 32);
    const auto depth = [&](const Vec3& p) {
        const Vec3 q = p.cwiseAbs() - half;
        return q.maxCoeff() <= 0 ? -q.maxCoeff() : -Vec3(q.cwiseMax(0)).norm();
    };
    EXPECT_LT(worstError(field, depth), 1e-6);
}

TEST(DepthField, OfATorusIsNegativeInItsHole) {
    const DepthField field = measureDepth(test::torus(), 32);
    const Vec3 middle = (-field.origin / field.spacing).array().round();
    const int center = field.index(int(middle.x()), int(middle.y()), int(middle.z()));
    EXPECT_LT(field.values[center], 0);
}

TEST(DepthField, ValuesReachOne) {
    const DepthField field = measureDepth(test::bentTube(), 24);
    EXPECT_FLOAT_EQ(*std::max_element(field.values.begin(), field.values.end()), 1);
}

}  // namespace
}  // namespace kerf::render
