#include "sim/solve/implicit/energy_guard.h"

#include <gtest/gtest.h>

namespace kerf {
namespace {

constexpr double kStep = 1.0 / 240;  // [s]

BodyMeasure moving(double kinetic, double strain = 0) {
    BodyMeasure measure;
    measure.kineticEnergy = kinetic;
    measure.strainEnergy = strain;
    return measure;
}

class EnergyGuardTest : public testing::Test {
  protected:
    EnergyGuardTest() { guard.note(moving(1), kStep, false); }

    EnergyGuard guard;
};

TEST_F(EnergyGuardTest, DividesWhatGrowsFurtherEachTimeUpToAnEighth) {
    double energy = 1;
    for (const int expected : {2, 4, 8, 8}) {
        energy *= 1.2;
        const int before = guard.divisions();
        EXPECT_EQ(guard.note(moving(energy), kStep, false), expected > before);
        EXPECT_EQ(guard.divisions(), expected);
    }
}

TEST_F(EnergyGuardTest, LetsEnergyChangeItsKind) {
    EXPECT_FALSE(guard.note(moving(0.2, 0.8), kStep, false));
    EXPECT_FALSE(guard.note(moving(0.1, 0.5), kStep, false));  // the rest is in contacts
    EXPECT_FALSE(guard.note(moving(0.9), kStep, false));
    EXPECT_EQ(guard.divisions(), 1);
}

TEST_F(EnergyGuardTest, LetsGrowWhatIsWorkedOnOrNew) {
    EXPECT_FALSE(guard.note(moving(5), kStep, true));
    guard.startAnew();
    EXPECT_FALSE(guard.note(moving(20), kStep, false));
    EXPECT_TRUE(guard.note(moving(25), kStep, false));
}

TEST_F(EnergyGuardTest, GoesBackAfterSecondsWithoutGrowth) {
    guard.note(moving(2), kStep, false);
    guard.note(moving(4), kStep, false);
    ASSERT_EQ(guard.divisions(), 4);
    for (int step = 0; step < 485; ++step) {
        guard.note(moving(1), kStep, false);
    }
    EXPECT_EQ(guard.divisions(), 1);
}

}  // namespace
}  // namespace kerf
