#include "sim/base/predicates.h"

#include <gtest/gtest.h>

#include <random>

namespace kerf::cut {
namespace {

__extension__ typedef __int128 Wide;

constexpr std::uint64_t kSeed = 20240601;
constexpr double kScale = 0x1p-31;

/// Integer coordinates: their determinants are exact in 128 bits, and so are the doubles.
struct Lattice {
    long long x, y, z;
    Vec3 scaled() const {
        return Vec3(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)) *
               kScale;
    }
    Vec2 flat() const { return Vec2(static_cast<double>(x), static_cast<double>(y)) * kScale; }
};

class LatticePoints {
  public:
    Lattice next(long long range) { return {number(range), number(range), number(range)}; }
    long long number(long long range) {
        return static_cast<long long>(engine_() % static_cast<std::uint64_t>(2 * range)) - range;
    }

  private:
    std::mt19937_64 engine_{kSeed};
};

int signOf(Wide value) {
    return value > 0 ? 1 : value < 0 ? -1 : 0;
}

int exactSign3d(const Lattice& a, const Lattice& b, const Lattice& c, const Lattice& p) {
    const Wide ux = b.x - a.x, uy = b.y - a.y, uz = b.z - a.z;
    const Wide vx = c.x - a.x, vy = c.y - a.y, vz = c.z - a.z;
    const Wide wx = p.x - a.x, wy = p.y - a.y, wz = p.z - a.z;
    return signOf((uy * vz - uz * vy) * wx + (uz * vx - ux * vz) * wy + (ux * vy - uy * vx) * wz);
}

int exactSign2d(const Lattice& a, const Lattice& b, const Lattice& c) {
    return signOf(Wide(b.x - a.x) * (c.y - a.y) - Wide(b.y - a.y) * (c.x - a.x));
}

TEST(Predicates, RandomTetrahedraHaveExactSigns) {
    LatticePoints points;
    for (int i = 0; i < 20000; ++i) {
        const Lattice a = points.next(1 << 30), b = points.next(1 << 30);
        const Lattice c = points.next(1 << 30), p = points.next(1 << 30);
        EXPECT_EQ(orient3d(a.scaled(), b.scaled(), c.scaled(), p.scaled()).sign,
                  exactSign3d(a, b, c, p));
        EXPECT_EQ(orientSign3d(a.scaled(), b.scaled(), c.scaled(), p.scaled()),
                  exactSign3d(a, b, c, p));
        EXPECT_EQ(orient2d(a.flat(), b.flat(), c.flat()), exactSign2d(a, b, c));
    }
}

TEST(Predicates, NearlyCoplanarPointsHaveExactSigns) {
    LatticePoints points;
    int zeros = 0;
    for (int i = 0; i < 20000; ++i) {
        const Lattice a = points.next(1 << 26), b = points.next(1 << 26), c = points.next(1 << 26);
        const long long j = points.number(8), k = points.number(8);
        // A lattice point of the plane abc, moved by at most one step of the lattice.
        const Lattice p{a.x + j * (b.x - a.x) + k * (c.x - a.x) + points.number(2),
                        a.y + j * (b.y - a.y) + k * (c.y - a.y),
                        a.z + j * (b.z - a.z) + k * (c.z - a.z)};
        const Orientation found = orient3d(a.scaled(), b.scaled(), c.scaled(), p.scaled());
        EXPECT_EQ(found.sign, exactSign3d(a, b, c, p));
        EXPECT_EQ(orientSign3d(a.scaled(), b.scaled(), c.scaled(), p.scaled()), found.sign);
        EXPECT_EQ(found.sign > 0, found.value > 0);
        EXPECT_EQ(found.sign < 0, found.value < 0);
        zeros += found.sign == 0;
    }
    EXPECT_GT(zeros, 1000);
}

TEST(Predicates, NearlyCollinearPointsHaveExactSigns) {
    LatticePoints points;
    int zeros = 0;
    for (int i = 0; i < 20000; ++i) {
        const Lattice a = points.next(1 << 26), b = points.next(1 << 26);
        const long long k = points.number(8);
        const Lattice c{a.x + k * (b.x - a.x) + points.number(2), a.y + k * (b.y - a.y), 0};
        EXPECT_EQ(orient2d(a.flat(), b.flat(), c.flat()), exactSign2d(a, b, c));
        zeros += exactSign2d(a, b, c) == 0;
    }
    EXPECT_GT(zeros, 1000);
}

TEST(Predicates, SignFlipsWithOrientation) {
    LatticePoints points;
    for (int i = 0; i < 2000; ++i) {
        const Vec3 a = points.next(4).scaled(), b = points.next(4).scaled();
        const Vec3 c = points.next(4).scaled(), p = points.next(4).scaled();
        EXPECT_EQ(orient3d(a, b, c, p).sign, -orient3d(b, a, c, p).sign);
        EXPECT_EQ(orient3d(a, b, c, p).sign, orient3d(b, c, a, p).sign);
    }
}

TEST(Predicates, LexicographicOrderFallsBackToIds) {
    EXPECT_TRUE(comesBefore({0, 1, 2}, 5, {0, 1, 3}, 1));
    EXPECT_FALSE(comesBefore({0, 2, 2}, 1, {0, 1, 3}, 5));
    EXPECT_TRUE(comesBefore({0, 1, 2}, 1, {0, 1, 2}, 5));
    EXPECT_FALSE(comesBefore({0, 1, 2}, 5, {0, 1, 2}, 5));
}

}  // namespace
}  // namespace kerf::cut
