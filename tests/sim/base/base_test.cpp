#include <climits>

#include "sim/base/containers.h"
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
    return {Vec3::Constant(low), Vec3::Constant(high)};
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

TEST(Text, CountsWithTheRightNoun) {
    EXPECT_EQ(counted(0, "piece", "pieces"), "0 pieces");
    EXPECT_EQ(counted(1, "piece", "pieces"), "1 piece");
    EXPECT_EQ(counted(2u, "piece", "pieces"), "2 pieces");
}

TEST(Text, JoinsWithSeparatorsBetweenOnly) {
    EXPECT_EQ(joined(std::vector<std::string>{}, ", "), "");
    EXPECT_EQ(joined(std::vector<std::string>{"a"}, ", "), "a");
    EXPECT_EQ(joined(std::vector<std::string>{"a", "b", "c"}, "; "), "a; b; c");
}

TEST(Turn, AnglesOfARotationMakeItAgain) {
    for (const double x : {-170.0, -90.0, 0.0, 35.0, 180.0}) {
        for (const double y : {-90.0, -89.0, 0.0, 60.0, 90.0, 140.0}) {
            for (const double z : {-120.0, 0.0, 77.0, 180.0}) {
                const Eigen::Matrix3d turn = turnOf(Vec3(x, y, z));
                EXPECT_LT((turnOf(turnsOf(turn)) - turn).norm(), 1e-6) << x << " " << y << " " << z;
            }
        }
    }
}

TEST(Turn, SmallAnglesStayAsTheyAre) {
    EXPECT_LT((turnsOf(turnOf(Vec3(10, -20, 30))) - Vec3(10, -20, 30)).norm(), 1e-9);
}

// In place and side by side, as the vectoriser of GCC 12 got it wrong.
TEST(FloatRounding, EachComponentBecomesAFloat) {
    std::vector<Vec3> places(3, Vec3(1 / 3., -1 / 7., 1e-9 / 11.));
    for (Vec3& place : places) {
        place = nearestFloats(place);
    }
    for (const Vec3& place : places) {
        for (int i = 0; i < 3; ++i) {
            const volatile float stored = static_cast<float>(place[i]);
            EXPECT_EQ(place[i], static_cast<double>(stored)) << i;
        }
        EXPECT_FLOAT_EQ(static_cast<float>(place.x()), 1 / 3.f);
    }
}

// Dense numbers, and such as lie far apart.
TEST(SortUnique, LeavesEachNumberOnceInOrder) {
    constexpr unsigned kSeed = 11;
    SCOPED_TRACE("seed " + std::to_string(kSeed));
    std::mt19937 random{kSeed};
    for (const int count : {0, 1, 2, 63, 64, 65, 1000}) {
        for (const int gap : {1, 3, 100, 5000}) {
            std::vector<int> numbers(count);
            int next = static_cast<int>(random() % 1000) - 500;
            for (int& number : numbers) {
                number = next;
                next += 1 + static_cast<int>(random() % gap);
            }
            const std::vector<int> sorted = numbers;
            numbers.insert(numbers.end(), sorted.begin(), sorted.begin() + count / 2);
            std::ranges::shuffle(numbers, random);
            sortUnique(numbers);
            EXPECT_EQ(numbers, sorted) << count << " numbers up to " << gap << " apart";
        }
    }
    std::vector<int> far{INT_MAX, 0, INT_MIN, 0};
    sortUnique(far);
    EXPECT_EQ(far, (std::vector<int>{INT_MIN, 0, INT_MAX}));
}

Bounds cube(double center, double half) {
    Bounds bounds;
    bounds.add(Vec3::Constant(center));
    bounds.widen(half);
    return bounds;
}

TEST(Bounds, EmptyOnesOverlapNothing) {
    EXPECT_TRUE(Bounds{}.empty());
    EXPECT_FALSE(Bounds{}.overlaps(cube(0, 1)));
    EXPECT_EQ(Bounds{}.diagonal(), 0);
}

TEST(Bounds, OverlapWhereTheyTouch) {
    EXPECT_TRUE(cube(0, 1).overlaps(cube(2, 1)));
    EXPECT_FALSE(cube(0, 1).overlaps(cube(2.5, 1)));
}

TEST(Bounds, TakeInOthers) {
    Bounds both = cube(0, 1);
    both.add(cube(4, 1));
    EXPECT_EQ(both.low, Vec3::Constant(-1));
    EXPECT_EQ(both.high, Vec3::Constant(5));
}

TEST(Bounds, CornersSpanTheBox) {
    const Bounds box = cube(1, 2);
    EXPECT_EQ(box.corner(0), box.low);
    EXPECT_EQ(box.corner(7), box.high);
    EXPECT_EQ(box.corner(2), Vec3(-1, 3, -1));
}

// Where work may rest, and where not.

/// Asks while the stack is unwound.
struct Asking {
    std::string& answer;
    ~Asking() { answer = problemOfPause(); }
};

TEST(Pausing, IsDoneByWhoeverPausesThisThread) {
    int pauses = 0;
    pausePoint();
    {
        const Pauses pausing([&] { ++pauses; });
        pausePoint();
        EXPECT_EQ(problemOfPause(), "");
    }
    pausePoint();
    EXPECT_EQ(pauses, 1);
}

TEST(Pausing, IsRefusedWhileAnExceptionIsUnderWay) {
    const Pauses pausing([] {});
    std::string thrown;
    std::string handled;
    try {
        const Asking asking{thrown};
        throw std::runtime_error("no room");
    } catch (const std::runtime_error&) {
        handled = problemOfPause();
    }
    EXPECT_EQ(thrown, "an exception is under way");
    EXPECT_EQ(handled, "an exception is under way");
    EXPECT_EQ(problemOfPause(), "");
}

TEST(Pausing, IsRefusedWhereTheCheckSaysSo) {
    std::string left;
    const Pauses pausing([] {}, [&] { return left; });
    EXPECT_EQ(problemOfPause(), "");
    left = "a vertex array";
    EXPECT_EQ(problemOfPause(), "a vertex array");
}

TEST(Pausing, NobodyPausesNothingIsRefused) {
    std::string thrown = "?";
    try {
        const Asking asking{thrown};
        throw std::runtime_error("no room");
    } catch (const std::runtime_error&) {
        pausePoint();
    }
    EXPECT_EQ(thrown, "");
}

#ifndef NDEBUG
TEST(PausingDeathTest, APauseThatIsRefusedEndsTheProgramWhereAssertionsAreOn) {
    const Pauses pausing([] {}, [] { return "a vertex array"; });
    EXPECT_DEATH(pausePoint(), "no place to pause");
}
#endif

}  // namespace
}  // namespace kerf
