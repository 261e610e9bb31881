#include "app/practice/hand_path.h"

namespace kerf::app {
namespace {

constexpr double kWay = 0.07;  // of the hand [m]
// Of a minimum-jerk motion: -ln(720 / 1.875^2).
const double kSmoothest = -std::log(204.8);

/// Flash and Hogan's motion from 0 to 1 in the time 0 to 1.
double minimumJerk(double t) {
    return t * t * t * (10 - 15 * t + 6 * t * t);
}

/// An upright blade at `x`, and as far aside as `z`.
Blade bladeAt(double x, double z = 0) {
    return {{x, 0.1, z}, {x, -0.1, z}};
}

using Motion = std::function<Blade(double share)>;

/// Adds a stroke of so many poses a second, which begins at `begin` [s].
void addStroke(std::vector<HandPose>& hand, double begin, double seconds, double rate,
               const Motion& motion) {
    const int count = static_cast<int>(std::lround(seconds * rate));
    for (int i = 0; i <= count; ++i) {
        const double share = static_cast<double>(i) / count;
        hand.push_back({begin + share * seconds, motion(share), i == 0});
    }
}

Blade smoothly(double share) {
    return bladeAt(kWay * minimumJerk(share));
}

MotionScore measureStroke(double seconds, double rate, const Motion& motion) {
    std::vector<HandPose> hand;
    addStroke(hand, 5, seconds, rate, motion);
    return measureMotion(hand, Vec3::Zero(), std::nullopt);
}

TEST(HandPath, SmoothnessDependsNeitherOnDurationNorOnTheRateOfPoses) {
    for (const double seconds : {3.0, 6.0, 20.0}) {
        for (const double rate : {10, 30, 100, 333, 1000}) {
            const auto smoothness = measureStroke(seconds, rate, smoothly).smoothness;
            EXPECT_NEAR(smoothness.value(), kSmoothest, seconds * rate < 50 ? 0.8 : 0.25)
                << seconds << " s, " << rate << " a second";
        }
    }
}

TEST(HandPath, StartsAndStopsAreLessSmooth) {
    const auto jerky = [](double share) {
        const double part = std::min(std::floor(5 * share), 4.0);
        return bladeAt(kWay * (part + minimumJerk(5 * share - part)) / 5);
    };
    const MotionScore score = measureStroke(6, 100, jerky);
    EXPECT_LT(*score.smoothness, kSmoothest - 2);
    EXPECT_NEAR(*score.path, kWay, 0.01 * kWay);
}

TEST(HandPath, StrokesWeighAsLongAsTheyLast) {
    std::vector<HandPose> hand;
    addStroke(hand, 0, 6, 100, smoothly);
    const double smooth = *measureMotion(hand, Vec3::Zero(), {}).smoothness;
    const auto twice = [](double share) {
        return bladeAt(kWay * minimumJerk(share < 0.5 ? 2 * share : 2 - 2 * share));
    };
    const double jerky = *measureStroke(2, 100, twice).smoothness;
    addStroke(hand, 7, 2, 100, twice);
    EXPECT_NEAR(*measureMotion(hand, Vec3::Zero(), {}).smoothness, (6 * smooth + 2 * jerky) / 8,
                1e-9);
    EXPECT_LT(jerky, smooth - 1);
    addStroke(hand, 10, 0.4, 100, twice);
    EXPECT_NEAR(*measureMotion(hand, Vec3::Zero(), {}).smoothness, (6 * smooth + 2 * jerky) / 8,
                1e-9)
        << "a short one does not count";
}

TEST(HandPath, PosesTooFarApartHaveNoSmoothnessOrTremor) {
    EXPECT_TRUE(measureStroke(6, 100, smoothly).tremor);
    EXPECT_TRUE(measureStroke(6, 50, smoothly).tremor);
    EXPECT_FALSE(measureStroke(6, 30, smoothly).tremor);
    EXPECT_TRUE(measureStroke(6, 10, smoothly).smoothness);
    EXPECT_FALSE(measureStroke(6, 5, smoothly).smoothness);
    const auto slow = [](double share) { return bladeAt(0.006 * share); };
    EXPECT_TRUE(measureStroke(6, 5, slow).smoothness) << "1 mm/s is no motion";
    EXPECT_TRUE(measureStroke(6, 5, slow).tremor);
    const auto hardly = [](double share) { return bladeAt(0.004 * share); };
    EXPECT_FALSE(measureStroke(1, 100, hardly).smoothness) << "4 mm are no way";
}

TEST(HandPath, TremorIsWhatTheFilterTakesAway) {
    const double amplitude = 3e-4;
    const double omega = 2 * std::numbers::pi * 8;
    const auto trembling = [&](double share) {
        return bladeAt(kWay * minimumJerk(share), amplitude * std::sin(omega * 6 * share));
    };
    const double left = 1 - std::exp(-0.5 * std::pow(omega * 0.06, 2));
    EXPECT_NEAR(*measureStroke(6, 100, trembling).tremor, left * amplitude / std::sqrt(2), 5e-6);
    EXPECT_LT(*measureStroke(6, 100, smoothly).tremor, 5e-5);
    const auto evenly = [](double share) { return bladeAt(kWay * share); };
    EXPECT_LT(*measureStroke(2, 100, evenly).tremor, 1e-9) << "starting at once is no tremor";
}

TEST(HandPath, WobbleIsTheWayToAndFroBesideALine) {
    const auto wobbleOf = [](double size, double hertz, double rate) {
        std::vector<HandPose> hand;
        addStroke(hand, 5, 6, rate, [&](double share) {
            return bladeAt(kWay * minimumJerk(share),
                           size * std::sin(12 * std::numbers::pi * hertz * share));
        });
        return measureMotion(hand, Vec3::Zero(), {},
                             [](const Vec3& point) {
                                 return point.x() < 0.06 ? std::optional(point.z()) : std::nullopt;
                             })
            .wobble;
    };
    for (const double hertz : {1.0, 2.0, 4.0}) {
        const double left = 1 - std::exp(-0.5 * std::pow(2 * std::numbers::pi * hertz * 0.25, 2));
        for (const double rate : {25, 50, 100, 333}) {
            const double expected = left * 6e-4 / std::numbers::sqrt2;
            EXPECT_NEAR(wobbleOf(6e-4, hertz, rate).value(), expected, 0.1 * expected)
                << hertz << " Hz, " << rate << " poses a second";
        }
    }
    EXPECT_LT(*wobbleOf(2e-3, 1.0 / 12, 100), 5e-5) << "a bow is the course of the hand";
    EXPECT_EQ(*wobbleOf(0, 1, 100), 0) << "whatever it does along the line";
    EXPECT_FALSE(wobbleOf(6e-4, 1, 5)) << "poses too far apart";
    EXPECT_FALSE(measureStroke(6, 100, smoothly).wobble) << "no line";
}

TEST(HandPath, TimeAndPathGoThroughTheAirToo) {
    std::vector<HandPose> hand;
    addStroke(hand, 1, 3, 100, smoothly);
    addStroke(hand, 6, 3, 100, smoothly);
    const MotionScore score = measureMotion(hand, Vec3::Zero(), 0.105);
    EXPECT_NEAR(*score.time, 8, 1e-12);
    EXPECT_NEAR(*score.path, 3 * kWay, 1e-4) << "back through the air";
    EXPECT_NEAR(*score.economy, 0.5, 1e-3);
    EXPECT_NEAR(*score.idleTime, 2, 1e-9);
    EXPECT_EQ(*measureMotion(hand, Vec3::Zero(), 1.0).economy, 1) << "at most";
    EXPECT_FALSE(measureMotion(hand, Vec3::Zero(), std::nullopt).economy);
}

TEST(HandPath, ARestIsIdleAtTheEndsToo) {
    const auto pausing = [](double seconds) {
        return [seconds](double share) {  // 3 s, the rest, 3 s; and 1 s at both ends
            const double t = share * (8 + seconds) - 1;
            const double first = minimumJerk(std::clamp(t / 3, 0.0, 1.0));
            return bladeAt(kWay * (first + minimumJerk(std::clamp((t - 3 - seconds) / 3, 0., 1.))));
        };
    };
    const double without = *measureStroke(8, 100, pausing(0)).idleTime;
    const double with = *measureStroke(10, 100, pausing(2)).idleTime;
    EXPECT_NEAR(with - without, 2, 0.7) << "slow ends of both motions count once there is a rest";
    EXPECT_NEAR(without, 2, 0.7) << "a second at both ends";
    EXPECT_EQ(*measureStroke(3, 100, smoothly).idleTime, 0) << "ramps are not idle";
    EXPECT_NEAR(*measureStroke(3, 100, [](double) { return bladeAt(0); }).idleTime, 3, 0.02);
}

TEST(HandPath, SlowerThanTwoMillimetresASecondIsARest) {
    const auto slowing = [](double speed) {  // for 2 s, between 2 s at 10 mm/s each
        return [speed](double share) {
            const double t = 6 * share;
            return bladeAt(0.01 * std::min(t, 2.0) + speed * std::clamp(t - 2, 0.0, 2.0) +
                           0.01 * std::max(t - 4, 0.0));
        };
    };
    EXPECT_NEAR(*measureStroke(6, 100, slowing(0.0015)).idleTime, 2, 0.3);
    EXPECT_EQ(*measureStroke(6, 100, slowing(0.0025)).idleTime, 0);
}

TEST(HandPath, TheHandIsAPointOfTheBladeThatIsNearTheTask) {
    const Vec3 pivot(0.02, 0.01, 0);
    const auto turning = [&](double share) {
        const Vec3 way(0.1 * std::cos(3 * share), 0.1 * std::sin(3 * share), 0);
        return Blade{pivot - way, pivot + way};
    };
    std::vector<HandPose> hand;
    addStroke(hand, 0, 2, 100, turning);
    EXPECT_NEAR(*measureMotion(hand, pivot, {}).path, 0, 1e-12);
    EXPECT_NEAR(handShare(hand, pivot), 0.5, 1e-12);
    EXPECT_NEAR(handShare(std::span(hand).first(1), pivot + Vec3(0.05, 0, 0)), 0.75, 1e-12);
    const auto down = [&](double share) {  // from above the pivot to below it, as a rigid blade
        return Blade{Vec3(0, 0.01 - 0.02 * share, 0), Vec3(0, 0.11 - 0.02 * share, 0)};
    };
    hand.clear();
    addStroke(hand, 0, 2, 100, down);
    EXPECT_NEAR(*measureMotion(hand, Vec3::Zero(), {}).path, 0.02, 1e-4);
    const auto point = [](double) { return Blade{Vec3::Ones(), Vec3::Ones()}; };
    EXPECT_EQ(*measureStroke(1, 100, point).path, 0);
}

TEST(HandPath, NothingIsMeasuredWhereThereIsNothing) {
    const MotionScore none = measureMotion({}, Vec3::Zero(), 1.0);
    EXPECT_FALSE(none.time || none.path || none.economy || none.smoothness || none.tremor ||
                 none.idleTime);
    const std::vector<HandPose> still{{3, bladeAt(0), true}};
    const MotionScore one = measureMotion(still, Vec3::Zero(), 1.0);
    EXPECT_EQ(*one.time, 0);
    EXPECT_EQ(*one.path, 0);
    EXPECT_FALSE(one.economy || one.smoothness || one.tremor);
    const std::vector<HandPose> atOnce{{3, bladeAt(0), true}, {3, bladeAt(1), false}};
    EXPECT_NEAR(*measureMotion(atOnce, Vec3::Zero(), {}).path, 1, 1e-9);
}

TEST(HandPath, AnHourIsMeasuredInAMoment) {
    std::vector<HandPose> hand{{0, bladeAt(0), true}, {3600, bladeAt(kWay), false}};
    const MotionScore score = measureMotion(hand, Vec3::Zero(), {});
    EXPECT_NEAR(*score.path, kWay, 1e-3 * kWay);
    EXPECT_EQ(*score.time, 3600);
}

}  // namespace
}  // namespace kerf::app
