#include "sim/repair/surface_contact.h"

namespace kerf::repair {
namespace {

const Line kLine{Vec3(0, 0, 0), Vec3(0, 0, 1)};

/// A face in a direction about the line [degrees], with its point somewhere along it.
Vec3 face(double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    return {std::cos(angle), std::sin(angle), 0.3};
}

TEST(Wedge, ThoseThatOverlapInPartCross) {
    EXPECT_TRUE(wedgesCross(kLine, {face(10), face(100)}, {face(50), face(160)}));
    EXPECT_TRUE(wedgesCross(kLine, {face(300), face(20)}, {face(10), face(100)}));
}

TEST(Wedge, ThoseThatAreApartOrWithinOneAnotherOnlyTouch) {
    EXPECT_FALSE(wedgesCross(kLine, {face(10), face(100)}, {face(150), face(300)}));
    EXPECT_FALSE(wedgesCross(kLine, {face(10), face(100)}, {face(40), face(60)}));
    // A hollow whose edge touches the skin from within: the material is all around it.
    EXPECT_FALSE(wedgesCross(kLine, {face(60), face(40)}, {face(10), face(100)}));
}

TEST(Wedge, AFaceInCommonCrossesWhereTheMaterialIsOnItsSameSide) {
    EXPECT_TRUE(wedgesCross(kLine, {face(10), face(100)}, {face(10), face(50)}));
    EXPECT_TRUE(wedgesCross(kLine, {face(10), face(100)}, {face(50), face(100)}));
    EXPECT_FALSE(wedgesCross(kLine, {face(10), face(100)}, {face(100), face(200)}));
    EXPECT_FALSE(wedgesCross(kLine, {face(10), face(100)}, {face(100), face(10)}));
    EXPECT_TRUE(wedgesCross(kLine, {face(10), face(100)}, {face(100), face(50)}))
        << "goes on into the other one";
}

TEST(Wedge, WithoutAnAngleNothingIsSaid) {
    EXPECT_FALSE(wedgesCross(kLine, {face(10), face(10)}, {face(0), face(50)}));
    EXPECT_FALSE(wedgesCross(kLine, {Vec3(0, 0, 2), face(10)}, {face(0), face(50)}));
}

/// How far a direction is turned from another one [steps of a whole turn of 12].
int turned(int from, int to) {
    return (to - from + 12) % 12;
}

bool within(int x, int from, int to) {
    return turned(from, x) > 0 && turned(from, x) < turned(from, to);
}

/// Whether some twelfth of the turn is in both, and neither is whole within the other.
bool overlapInPart(int a, int toA, int b, int toB) {
    const auto holds = [](int from, int to, int i) { return turned(from, i) < turned(from, to); };
    bool both = false;
    for (int i = 0; i < 12; ++i) {
        both = both || (holds(a, toA, i) && holds(b, toB, i));
    }
    const bool nested =
        (within(b, a, toA) && within(toB, a, toA)) || (within(a, b, toB) && within(toA, b, toB));
    return both && !nested;
}

TEST(Wedge, AllOfTwelfthsOfATurnAreAsCountingSays) {
    // Whole numbers, so that opposite directions are exact.
    constexpr std::array<std::array<int, 2>, 12> kDirections{{{2, 0},
                                                              {2, 1},
                                                              {1, 2},
                                                              {0, 2},
                                                              {-1, 2},
                                                              {-2, 1},
                                                              {-2, 0},
                                                              {-2, -1},
                                                              {-1, -2},
                                                              {0, -2},
                                                              {1, -2},
                                                              {2, -1}}};
    std::mt19937 random(20261126);
    const Line line{Vec3(1, 2, 3), Vec3(3, 3, 7)};
    const Vec3 axis = line.v - line.u;
    const Vec3 x(1, -2, 0);
    const Vec3 y = axis.cross(x);
    const auto place = [&](int i) {
        const double far = 1 + static_cast<double>(random() % 3);
        return Vec3(line.u + static_cast<double>(random() % 5) * axis +
                    far * (kDirections[i][0] * x + kDirections[i][1] * y));
    };
    for (int i = 0; i < 12 * 12 * 12 * 12; ++i) {
        const int a = i % 12;
        const int toA = i / 12 % 12;
        const int b = i / 144 % 12;
        const int toB = i / 1728;
        if (a != toA && b != toB) {
            ASSERT_EQ(wedgesCross(line, {place(a), place(toA)}, {place(b), place(toB)}),
                      overlapInPart(a, toA, b, toB))
                << a << " to " << toA << ", " << b << " to " << toB;
        }
    }
}

}  // namespace
}  // namespace kerf::repair
