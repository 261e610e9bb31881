#include "sim/solve/volume_targets.h"

namespace kerf {
namespace {

PieceModel piece(double restVolume, bool holdsVolume = true) {
    PieceModel out;
    out.restVolume = restVolume;
    out.holdsVolume = holdsVolume;
    return out;
}

BodyModel whole() {
    BodyModel model;
    model.pieces = {piece(2)};
    return model;
}

/// The whole in two, and a chip of new vertices only.
BodyModel halves() {
    BodyModel model;
    model.pieces = {piece(1.2), piece(0.8), piece(1e-9, false)};
    return model;
}

BodyModel halvesAndSplinter() {
    BodyModel model;
    model.pieces = {piece(1.2), piece(0.799), piece(1e-3)};
    return model;
}

// Which old piece each comes from.
constexpr std::array<int, 3> kSplit{0, 0, -1};
constexpr std::array<int, 3> kUnchanged{0, 1, 2};

void startAt(std::span<const double> volumes, VolumeTargets& targets) {
    for (std::size_t p = 0; p < volumes.size(); ++p) {
        targets.startAt(static_cast<int>(p), volumes[p]);
    }
}

TEST(VolumeTargets, StartAtTheRestVolume) {
    VolumeTargets targets;
    targets.reset(whole());
    ASSERT_EQ(targets.targets().size(), 1u);
    EXPECT_EQ(targets.targets()[0].volume, 2);
    EXPECT_TRUE(targets.targets()[0].constrained);
    EXPECT_FALSE(targets.fade(0.1));
}

TEST(VolumeTargets, OfPartsFadeFromTheCurrentToTheRestVolume) {
    VolumeTargets targets;
    targets.reset(whole());
    const double volumes[] = {1.19, 0.81, 5};
    targets.follow(kSplit, halves(), volumes);
    EXPECT_DOUBLE_EQ(targets.targets()[0].volume, 1.19);
    EXPECT_DOUBLE_EQ(targets.targets()[1].volume, 0.81);
    EXPECT_FALSE(targets.targets()[2].constrained);
    EXPECT_TRUE(targets.fade(0.1));
    EXPECT_NEAR(targets.targets()[0].volume, 1.2 - 0.01 * std::exp(-1), 1e-12);
    EXPECT_NEAR(targets.targets()[1].volume, 0.8 + 0.01 * std::exp(-1), 1e-12);
    while (targets.fade(0.1)) {
    }
    EXPECT_EQ(targets.targets()[0].volume, 1.2);
    EXPECT_EQ(targets.targets()[1].volume, 0.8);
}

TEST(VolumeTargets, GoOnThroughACutThatSeparatesNothing) {
    VolumeTargets targets;
    targets.reset(whole());
    const double volumes[] = {1.19, 0.81, 1e-9};
    targets.follow(kSplit, halves(), volumes);
    const double later[] = {1.1, 0.9, 1e-9};
    targets.follow(kUnchanged, halves(), later);
    EXPECT_DOUBLE_EQ(targets.targets()[0].volume, 1.19);
    EXPECT_DOUBLE_EQ(targets.targets()[1].volume, 0.81);
}

TEST(VolumeTargets, ComeBackFromAfarByTwoRestVolumesASecond) {
    VolumeTargets targets;
    targets.reset(whole());
    const double insideOut[] = {-2};
    startAt(insideOut, targets);
    EXPECT_DOUBLE_EQ(targets.targets()[0].volume, -2);
    EXPECT_TRUE(targets.fade(0.1));
    EXPECT_DOUBLE_EQ(targets.targets()[0].volume, -1.6);
    for (int i = 0; i < 100 && targets.fade(0.1); ++i) {
    }
    EXPECT_EQ(targets.targets()[0].volume, 2);
}

// Parts of a body that is crushed where one of them lies: the sum is the body's volume all the way.
TEST(VolumeTargets, OfPartsKeepTheirSumHoweverFarOneIsOff) {
    VolumeTargets targets;
    targets.reset(whole());
    const double volumes[] = {0.2, 1.8, 1e-9};
    targets.follow(kSplit, halves(), volumes);
    double last = 0.2;
    while (targets.fade(0.02)) {
        const double first = targets.targets()[0].volume;
        EXPECT_NEAR(first + targets.targets()[1].volume, 2, 1e-6);
        EXPECT_LE(first - last, 2 * 1.2 * 0.02 + 1e-12);
        last = first;
    }
    EXPECT_EQ(targets.targets()[0].volume, 1.2);
    EXPECT_EQ(targets.targets()[1].volume, 0.8);
}

TEST(VolumeTargets, DoNotWaitForASplinterThatHoldsLittle) {
    VolumeTargets targets;
    targets.reset(halvesAndSplinter());
    const double volumes[] = {1.1, 0.897, 0.003};
    startAt(volumes, targets);
    EXPECT_TRUE(targets.fade(0.1));
    EXPECT_NEAR(targets.targets()[0].volume, 1.2 - 0.1 * std::exp(-1), 0.002);
    EXPECT_NEAR(targets.targets()[1].volume, 0.799 + 0.098 * std::exp(-1), 0.002);
}

// Hands have stretched it to thirty times what it held.
TEST(VolumeTargets, OfPartsKeepTheirSumBesideSplinters) {
    VolumeTargets targets;
    targets.reset(halvesAndSplinter());
    const double volumes[] = {1.15, 0.82, 0.03};
    startAt(volumes, targets);
    int steps = 0;
    for (double last = 0.03; targets.fade(0.02); ++steps) {
        const double splinter = targets.targets()[2].volume;
        EXPECT_NEAR(targets.targets()[0].volume + targets.targets()[1].volume + splinter, 2, 1e-6);
        EXPECT_LE(last - splinter, 2 * 1e-3 * 0.02 + 1e-12);
        last = splinter;
    }
    EXPECT_GT(steps, 500);
    EXPECT_EQ(targets.targets()[0].volume, 1.2);
    EXPECT_EQ(targets.targets()[2].volume, 1e-3);
}

TEST(VolumeTargets, OfChipsStayAtRest) {
    VolumeTargets targets;
    targets.reset(halves());
    const double volumes[] = {1, 1, 5};
    startAt(volumes, targets);
    EXPECT_EQ(targets.targets()[2].volume, 1e-9);
}

}  // namespace
}  // namespace kerf
