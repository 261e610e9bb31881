#include "sim/mesh/triangle_soup.h"

#include <gtest/gtest.h>

#include <random>

namespace kerf {
namespace {

constexpr unsigned kSoupSeed = 20261126;

TEST(RoundToFloats, LeavesNoDoubleHoweverManyThereAre) {
    std::mt19937 random(kSoupSeed);
    std::uniform_real_distribution<double> any(1, 3);
    for (int count = 1; count < 40; ++count) {
        TriangleSoup soup;
        for (int i = 0; i < count; ++i) {
            soup.positions.emplace_back(any(random), any(random), any(random));
            soup.triangles.push_back({i, (i + 1) % count, (i + 2) % count});
        }
        roundToFloats(soup);
        for (const Vec3& p : soup.positions) {
            for (const double x : p) {
                const volatile float rounded = static_cast<float>(x);
                EXPECT_EQ(x, rounded) << "seed " << kSoupSeed << ", of " << count;
            }
        }
    }
}

TEST(RoundToFloats, JoinsWhatIsOnePlaceThen) {
    TriangleSoup soup{{{1, 0, 0}, {1 + 1e-12, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 3}, {1, 3, 2}}};
    roundToFloats(soup);
    EXPECT_EQ(soup.positions.size(), 3u);
}

}  // namespace
}  // namespace kerf
