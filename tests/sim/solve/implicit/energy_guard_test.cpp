#include <gtest/gtest.h>

#include "sim/solve/implicit/step_choice.h"

namespace kerf {
namespace {

BodyEnergies moving(double kinetic, double strain = 0) {
    return {kinetic + strain, 0};
}

class EnergyGuardTest : public testing::Test {
  protected:
    EnergyGuardTest() { note(moving(1)); }

    bool note(const BodyEnergies& body, bool worked = false) {
        return guard.note(body, 1.0 / 240, worked, 1e-3);
    }

    EnergyGuard guard;
};

TEST_F(EnergyGuardTest, DividesWhatGrowsFurtherEachTimeUpToAnEighth) {
    double energy = 1;
    for (const int expected : {2, 4, 8, 8}) {
        energy *= 1.6;
        const int before = guard.divisions();
        EXPECT_EQ(note(moving(energy)), expected > before);
        EXPECT_EQ(guard.divisions(), expected);
    }
}

TEST_F(EnergyGuardTest, LetsEnergyChangeItsKind) {
    EXPECT_FALSE(note(moving(0.2, 0.8)));
    EXPECT_FALSE(note(moving(0.1, 0.5)));  // the rest is in contacts
    EXPECT_FALSE(note(moving(0.9)));
    EXPECT_EQ(guard.divisions(), 1);
}

TEST_F(EnergyGuardTest, LetsGrowWhatIsWorkedOnOrNew) {
    EXPECT_FALSE(note(moving(5), true));
    guard.startAnew();
    EXPECT_FALSE(note(moving(20)));
    EXPECT_TRUE(note(moving(31)));
}

TEST_F(EnergyGuardTest, LetsLittleEnergyBe) {
    guard.startAnew();
    note(moving(1e-5));
    EXPECT_FALSE(note(moving(1e-4)));
}

TEST_F(EnergyGuardTest, GoesBackAfterSecondsWithoutGrowth) {
    note(moving(2));
    note(moving(4));
    ASSERT_EQ(guard.divisions(), 4);
    for (int step = 0; step < 485; ++step) {
        note(moving(1));
    }
    EXPECT_EQ(guard.divisions(), 1);
}

}  // namespace
}  // namespace kerf
