#include "app/files/import/model_units.h"

#include <gtest/gtest.h>

namespace kerf::app {
namespace {

UnitGuess guessOf(const char* file, double length) {
    Bounds bounds;
    bounds.add(Vec3(5, 5, 5));
    bounds.add(Vec3(5 + 0.5 * length, 5 + length, 5 + 0.2 * length));
    return guessUnits(file, bounds, std::nullopt);
}

TEST(UnitGuess, FollowsTheFormat) {
    EXPECT_EQ(guessOf("a.GLB", 9.66).unit, LengthUnit::metre);
    EXPECT_TRUE(guessOf("a.gltf", 0.001).certain);
    EXPECT_EQ(guessOf("a.stl", 60).unit, LengthUnit::millimetre);
    EXPECT_EQ(guessOf("a.stl", 60).up, UpAxis::z);
    EXPECT_EQ(guessOf("a.obj", 1.2).unit, LengthUnit::metre);
    EXPECT_EQ(guessOf("a.obj", 1.2).up, UpAxis::y);
    EXPECT_FALSE(guessOf("a.obj", 1.2).certain);
}

TEST(UnitGuess, TakesAnotherUnitWhereTheUsualOneMakesItTinyOrHuge) {
    EXPECT_EQ(guessOf("a.obj", 9.66).unit, LengthUnit::centimetre);
    EXPECT_EQ(guessOf("a.ply", 1200).unit, LengthUnit::millimetre);
    EXPECT_EQ(guessOf("a.stl", 0.92).unit, LengthUnit::metre);
    EXPECT_EQ(guessOf("a.obj", 1e-3).unit, LengthUnit::metre);  // There is no better one.
}

TEST(UnitGuess, SaysWhatWasTakenAndWhy) {
    EXPECT_EQ(guessOf("a.glb", 2).sentence, "glTF is in metres with +y up: 2 m long.");
    EXPECT_EQ(guessOf("a.stl", 60).sentence,
              "STL has no unit: assumed millimetres with +z up, 6 cm long.");
    EXPECT_EQ(guessOf("a.obj", 9.66).sentence,
              "OBJ has no unit: assumed centimetres with +y up, 9.66 cm long, since 9.66 m would "
              "be huge.");
    Bounds bounds;
    bounds.add(Vec3(0, 0, 0));
    bounds.add(Vec3(1, 2, 1));
    EXPECT_EQ(guessUnits("a.fbx", bounds, FileUnits{LengthUnit::metre, UpAxis::minusZ}).sentence,
              "FBX is in metres with -z up: 2 m long.");
    EXPECT_NE(guessOf("a.stl", 0.92).sentence.find("since 920 \u00b5m would be tiny."),
              std::string::npos);
}

TEST(Standing, PutsAModelOverTheGroundWithoutScalingIt) {
    const std::vector<Vec3> own{Vec3(100, -50, 30), Vec3(160, 30, 30)};
    UnitGuess guess;
    const Placement placement = standing(guess, own);
    const Vec3 low = placement.apply(own[0]);
    const Vec3 high = placement.apply(own[1]);
    EXPECT_NEAR((high - low).norm(), 100, 1e-12);
    EXPECT_NEAR(low.y(), 2, 1e-12);
    EXPECT_NEAR((low + high).x(), 0, 1e-12);
    EXPECT_NEAR((low + high).z(), 0, 1e-12);

    Placement turned = placement;
    turned.rotate = {0, 0, 90};
    const Placement moved = standing(turned, own, Vec3(7, 1, 8));
    EXPECT_NEAR(std::min(moved.apply(own[0]).y(), moved.apply(own[1]).y()), 3, 1e-12);
    EXPECT_NEAR(0.5 * (moved.apply(own[0]) + moved.apply(own[1])).x(), 7, 1e-12);
}

}  // namespace
}  // namespace kerf::app
