#include "sim/base/placement.h"

#include <gtest/gtest.h>

#include "sim/base/size_params.h"
#include "sim/base/text.h"

namespace kerf {
namespace {

TEST(Placement, TakesTheUnitThenTheAxisThenScaleTurnAndPlace) {
    Placement placement;
    placement.unit = LengthUnit::millimetre;
    placement.up = UpAxis::z;
    placement.scale = 2;
    placement.rotate = {0, 90, 0};
    placement.translate = {10, 20, 30};
    // Up in the model, 5 mm: a centimetre up in the scene.
    EXPECT_TRUE(placement.apply({0, 0, 5}).isApprox(Vec3(10, 20.01, 30), 1e-12));
    // The turn about y takes x to -z.
    EXPECT_TRUE(placement.apply({500, 0, 0}).isApprox(Vec3(10, 20, 29), 1e-12));
}

TEST(Placement, EachAxisIsBroughtUpWithoutMirroring) {
    const Vec3 axes[] = {Vec3::UnitY(),  Vec3::UnitZ(),  Vec3::UnitX(),
                         -Vec3::UnitY(), -Vec3::UnitZ(), -Vec3::UnitX()};
    for (std::size_t i = 0; i < std::size(kUpAxisNames); ++i) {
        Placement placement;
        placement.up = static_cast<UpAxis>(i);
        EXPECT_EQ(placement.apply(axes[i]), Vec3::UnitY()) << kUpAxisNames[i];
        Eigen::Matrix3d map;
        map << placement.apply(Vec3::UnitX()), placement.apply(Vec3::UnitY()),
            placement.apply(Vec3::UnitZ());
        EXPECT_EQ(map.determinant(), 1) << kUpAxisNames[i];
    }
}

TEST(Placement, LeadsBackToTheModel) {
    const Vec3 point(12.5, -3, 70001);
    for (std::size_t unit = 0; unit < std::size(kLengthUnitNames); ++unit) {
        for (std::size_t up = 0; up < std::size(kUpAxisNames); ++up) {
            const Placement placement{static_cast<LengthUnit>(unit), static_cast<UpAxis>(up), 0.3,
                                      Vec3(10, 200, -30), Vec3(1, -2, 3)};
            const PlacementMap map(placement);
            EXPECT_TRUE(map.toModel(map.toScene(point)).isApprox(point, 1e-12))
                << kLengthUnitNames[unit] << kUpAxisNames[up];
        }
    }
}

/// A body from low to high along each axis.
Bounds cubeBetween(double low, double high) {
    Bounds bounds;
    bounds.add(Vec3::Constant(low));
    bounds.add(Vec3::Constant(high));
    return bounds;
}

TEST(Placement, ABodyMayReachTheLimitsOfTheRoomAndNotBeyond) {
    EXPECT_EQ(checkRoom(cubeBetween(0, 1e-6)), "");
    EXPECT_NE(checkRoom(cubeBetween(0, 0.99e-6)), "") << "too small";
    EXPECT_EQ(checkRoom(cubeBetween(-1e7, 1e7)), "");
    EXPECT_NE(checkRoom(cubeBetween(-1e7, 1.01e7)), "") << "too far above";
    EXPECT_NE(checkRoom(cubeBetween(-1.01e7, 1e7)), "") << "too far below";
    EXPECT_EQ(checkRoom(cubeBetween(19999, 20000)), "");
    EXPECT_NE(checkRoom(cubeBetween(20000, 20001)), "") << "too far for its length";
    const Vec3 beside = Vec3::Constant(20000);
    EXPECT_EQ(checkRoom(cubeBetween(20000, 20001), beside), "");
    EXPECT_NE(checkRoom(cubeBetween(40000, 40001), beside), "") << "too far from the origin";
}

TEST(Placement, TheOriginLiesAtZeroOrBesideTheModels) {
    EXPECT_EQ(originOf(cubeBetween(-0.5, 0.5)), Vec3::Zero());
    EXPECT_EQ(originOf(cubeBetween(100, 100)), Vec3::Zero()) << "a point";
    EXPECT_EQ(originOf(cubeBetween(7, 8)), Vec3::Zero()) << "near enough";
    EXPECT_EQ(originOf(cubeBetween(99.8, 100.3)), Vec3::Constant(100));
    EXPECT_EQ(originOf(cubeBetween(-5000123.3, -5000120.3)), Vec3::Constant(-5000120));
    Bounds slab = cubeBetween(0, 1);
    slab.low.x() += 1000;
    slab.high.x() += 1000;
    EXPECT_EQ(originOf(slab).y(), 0) << "each axis for itself";
    for (const double place : {0.1, 12.34, 4321.09, 5000456.7, 9.9e6}) {
        const Bounds bounds = cubeBetween(place, place + 0.37);
        const Vec3 origin = originOf(bounds);
        EXPECT_EQ((bounds.low - origin) + origin, bounds.low) << "not rounded";
        EXPECT_LE((bounds.center() - origin).cwiseAbs().maxCoeff(), 8.5 * 0.37);
    }
}

TEST(SizeParams, FollowSizeAndFirmness) {
    Params params;
    for (const double diagonal : {0.5, 1.5, 9.0}) {
        EXPECT_EQ(suitedTo(diagonal, params).timeStep, 0.016)
            << "a sixtieth of a second, or nearly";
        EXPECT_EQ(suitedTo(diagonal, params).depenetrationSpeed, params.depenetrationSpeed);
    }
    params.youngsModulus = 1e7;
    EXPECT_EQ(suitedTo(1, params).timeStep, 0.005);
    EXPECT_EQ(suitedTo(0.05, Params{}).timeStep, 0.005);
    EXPECT_EQ(suitedTo(1e-5, Params{}).timeStep, 0.0005);
    EXPECT_LT(suitedTo(0.005, Params{}).depenetrationSpeed, 1);
    EXPECT_EQ(suitedTo(300, Params{}).depenetrationSpeed, 10);
}

TEST(SizeParams, OfPlainPbdAreShorter) {
    Params paper;
    paper.solver = SolverMode::pbd;
    EXPECT_EQ(suitedTo(1, paper).timeStep, 0.005);
    EXPECT_EQ(suitedTo(0.05, paper).timeStep, 0.001);
}

TEST(SizeParams, FollowASizeUnlessSomebodyChoseThem) {
    Params chosen;
    chosen.timeStep = 0.003;
    const Params small = followSize(1, 0.005, chosen);
    EXPECT_EQ(small.timeStep, 0.003);
    EXPECT_EQ(small.depenetrationSpeed, suitedTo(0.005, chosen).depenetrationSpeed);
    EXPECT_EQ(followSize(0.005, 1, small), chosen);
}

TEST(QuantityText, TakesTheUnitThatSuits) {
    EXPECT_EQ(lengthText(9.66), "9.66 m");
    EXPECT_EQ(lengthText(0.0966), "9.66 cm");
    EXPECT_EQ(lengthText(0.005), "5 mm");
    EXPECT_EQ(lengthText(300), "300 m");
    EXPECT_EQ(lengthText(2e-7), "0.2 \u00b5m");
    EXPECT_EQ(massText(900), "900 kg");
    EXPECT_EQ(massText(1.4e7), "14000 t");
    EXPECT_EQ(massText(0.04), "40 g");
}

}  // namespace
}  // namespace kerf
