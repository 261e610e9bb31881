#include "app/session/volume_watch.h"

#include <gtest/gtest.h>

namespace kerf::app {
namespace {

Piece pieceOf(double volume, double restVolume) {
    return {100, 52, volume, restVolume, 1};
}

TEST(VolumeWatch, NamesTheFirstStepInWhichTheBodyTurned) {
    VolumeWatch watch;
    EXPECT_FALSE(watch.add(0, {pieceOf(2, 2)}));
    EXPECT_FALSE(watch.add(1, {pieceOf(0.1, 2)}));
    EXPECT_EQ(watch.sentence(), "") << "thin is not lost";
    EXPECT_TRUE(watch.add(2, {pieceOf(-0.1, 2)}));
    EXPECT_EQ(watch.sentence().find("so in"), std::string::npos) << "one step says it all";
    EXPECT_FALSE(watch.add(3, {pieceOf(-0.4, 2)})) << "told already";
    const std::string sentence = watch.sentence();
    EXPECT_TRUE(
        sentence.starts_with("Step 2: the body turned inside out, with -5.0 % of its volume"))
        << sentence;
    EXPECT_TRUE(sentence.ends_with(" It was so in 2 steps.")) << sentence;
}

TEST(VolumeWatch, FlatIsToldAndInsideOutAfterIt) {
    VolumeWatch watch;
    EXPECT_TRUE(watch.add(1, {pieceOf(0.0002, 2)}));
    EXPECT_TRUE(
        watch.sentence().starts_with("Step 1: the body was pressed flat, with 0.0 % of its volume"))
        << watch.sentence();
    EXPECT_FALSE(watch.add(2, {pieceOf(0.0001, 2)}));
    EXPECT_TRUE(watch.add(3, {pieceOf(-0.1, 2)}));
    EXPECT_TRUE(watch.sentence().starts_with("Step 3: the body turned inside out"));
}

TEST(VolumeWatch, APieceCountsWhereTheSumHidesItAndDebrisDoesNot) {
    VolumeWatch watch;
    EXPECT_FALSE(watch.add(0, {pieceOf(1, 1), pieceOf(-1e-6, 1e-5)}));
    EXPECT_EQ(watch.sentence(), "");
    EXPECT_TRUE(watch.add(1, {pieceOf(1, 1), pieceOf(-0.25, 1)}));
    EXPECT_TRUE(watch.sentence().starts_with("Step 1: a piece turned inside out, with -25.0 %"));
}

}  // namespace
}  // namespace kerf::app
