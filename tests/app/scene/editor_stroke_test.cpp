#include "app/scene/editor_stroke.h"

#include <gmock/gmock.h>

namespace kerf::app {
namespace {

constexpr double kAspect = 16.0 / 9;

Bounds unitBounds() {
    Bounds bounds;
    bounds.add(Vec3(-1, -1, -1));
    bounds.add(Vec3(1, 1, 1));
    return bounds;
}

StrokeSpace space() {
    return {render::Camera{}, kAspect, unitBounds()};
}

std::vector<Blade> drainPoses(BladeStroke& stroke) {
    std::vector<Blade> poses;
    while (const std::optional<Command> command = stroke.next()) {
        if (const auto* move = std::get_if<MoveBlade>(&*command)) {
            poses.push_back(move->blade);
        }
    }
    return poses;
}

TEST(BladeStroke, KnowsTheStrokesThatWait) {
    BladeStroke stroke;
    EXPECT_EQ(stroke.waiting(), 0);
    for (int i = 0; i < 3; ++i) {
        stroke.begin(space(), {-0.5, 0});
        stroke.moveTo({0.5, 0});
        stroke.end();
    }
    EXPECT_EQ(stroke.waiting(), 3);
    stroke.next();
    EXPECT_EQ(stroke.waiting(), 2) << "the first one is being cut";
    stroke.cancel();
    EXPECT_EQ(stroke.waiting(), 0);
}

/// Where time runs, the blade keeps to the speed of a hand.
TEST(BladeStroke, GoesNoFartherInAStepThanItsLimit) {
    BladeStroke stroke;
    const auto longest = [&] {
        stroke.begin(space(), {-0.5, 0});
        stroke.moveTo({0.5, 0});
        stroke.end();
        const std::vector<Blade> poses = drainPoses(stroke);
        double most = 0;
        for (std::size_t i = 1; i < poses.size(); ++i) {
            most = std::max(most, space().distance(poses[i - 1], poses[i]));
        }
        return most;
    };
    const double free = longest();
    stroke.limitStep(free / 7);
    const double limited = longest();
    EXPECT_LE(limited, free / 7 * (1 + 1e-9));
    EXPECT_GE(limited, free / 8);
}

TEST(StrokeSpace, TheBladeLiesOnTheRayThroughThePointer) {
    const render::Camera camera;
    const Vec2 ndc(0.3, -0.2);
    const Blade blade = space().bladeAt(ndc);
    const Vec3 ray = camera.ray(ndc, kAspect).direction;
    EXPECT_NEAR(((blade.a - camera.eye).cross(ray)).norm(), 0, 1e-12);
    EXPECT_NEAR(((blade.b - camera.eye).cross(ray)).norm(), 0, 1e-12);
    EXPECT_LT((blade.a - camera.eye).dot(ray), (blade.b - camera.eye).dot(ray));
}

TEST(StrokeSpace, TheBladeGoesThroughAllOfTheBody) {
    const render::Camera camera;
    const Vec3 forward = (camera.target - camera.eye).normalized();
    const Blade blade = space().bladeAt({0, 0});
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 p(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
        EXPECT_LT(blade.a.dot(forward), p.dot(forward));
        EXPECT_GT(blade.b.dot(forward), p.dot(forward));
    }
}

TEST(StrokeSpace, FromInsideTheBodyTheBladeStaysBeforeTheEye) {
    render::Camera camera;
    camera.eye = Vec3(0.1, 0, 0.2);
    const Vec3 forward = (camera.target - camera.eye).normalized();
    const Blade blade = StrokeSpace(camera, kAspect, unitBounds()).bladeAt({0.5, 0.5});
    EXPECT_GT((blade.a - camera.eye).dot(forward), 0);
    EXPECT_GT((blade.b - blade.a).dot(forward), 0);
}

TEST(StrokeSpace, AStraightStrokeSweepsAPlane) {
    const Blade first = space().bladeAt({0.1, 0.9});
    const Blade last = space().bladeAt({-0.2, -0.9});
    const Vec3 normal = (first.b - first.a).cross(last.a - first.a).normalized();
    const Blade middle = space().bladeAt({-0.05, 0});
    EXPECT_NEAR((middle.a - first.a).dot(normal), 0, 1e-12);
    EXPECT_NEAR((middle.b - first.a).dot(normal), 0, 1e-12);
}

TEST(BladeStroke, AClickDoesNothing) {
    BladeStroke stroke;
    stroke.begin(space(), {0, 0});
    stroke.end();
    EXPECT_EQ(stroke.pending(), 0U);
    EXPECT_EQ(stroke.next(), std::nullopt);
}

TEST(BladeStroke, LongMovesAreDividedAndNoneIsLost) {
    const StrokeSpace where = space();
    BladeStroke stroke;
    stroke.begin(where, {0, 0.9});
    stroke.moveTo({0, -0.9});
    stroke.end();
    const std::vector<Blade> poses = drainPoses(stroke);
    ASSERT_GT(poses.size(), 20U);
    for (std::size_t i = 1; i < poses.size(); ++i) {
        EXPECT_LE(where.distance(poses[i - 1], poses[i]), where.maxStep() * (1 + 1e-9));
    }
    EXPECT_NEAR(where.distance(poses.front(), where.bladeAt({0, 0.9})), 0, 1e-12);
    EXPECT_NEAR(where.distance(poses.back(), where.bladeAt({0, -0.9})), 0, 1e-12);
}

TEST(BladeStroke, SmallMovesAreGatheredAndTheLastPointIsReached) {
    const StrokeSpace where = space();
    BladeStroke stroke;
    stroke.begin(where, {0, 0.5});
    for (int i = 1; i <= 1000; ++i) {
        stroke.moveTo({0, 0.5 - i * 1e-3});
    }
    stroke.end();
    const std::vector<Blade> poses = drainPoses(stroke);
    EXPECT_LT(poses.size(), 500U);
    EXPECT_NEAR(where.distance(poses.back(), where.bladeAt({0, -0.5})), 0, 1e-9);
}

TEST(BladeStroke, ThePosesSayHowLongTheHandTook) {
    BladeStroke stroke;
    stroke.elapse(7);
    stroke.begin(space(), {0, 0.5});
    for (int i = 1; i <= 50; ++i) {
        stroke.elapse(0.04);
        stroke.moveTo({0, 0.5 - i * 0.02});
    }
    stroke.end();
    double sum = 0;
    while (const std::optional<Command> command = stroke.next()) {
        const auto* move = std::get_if<MoveBlade>(&*command);
        sum += move == nullptr ? 0 : move->seconds.value_or(0);
    }
    EXPECT_NEAR(sum, 2, 1e-9);
}

/// The commands of a pointer that goes down evenly in two seconds, after one in which it was away.
/// `frames`: how long each picture takes, in turn [s]; the pointer moves eight times in each.
std::vector<MoveBlade> timedStroke(const std::vector<double>& frames) {
    BladeStroke stroke;
    stroke.keepTime(0.01);
    stroke.elapse(1);
    stroke.begin(space(), {0, 0.5});
    double time = 0;
    for (std::size_t i = 0; time < 2; ++i) {
        const double frame = std::min(frames[i % frames.size()], 2 - time);
        stroke.elapse(frame);
        for (int k = 1; k <= 8; ++k) {
            stroke.moveTo({0, 0.5 - 0.5 * (time + k / 8.0 * frame)});
        }
        time += frame;
    }
    stroke.end();
    std::vector<MoveBlade> moves;
    while (const std::optional<Command> command = stroke.next()) {
        if (const auto* move = std::get_if<MoveBlade>(&*command)) {
            moves.push_back(*move);
        }
    }
    return moves;
}

TEST(BladeStroke, WhereTimeIsKeptAHandTakesAsManyStepsWhateverThePictures) {
    for (const std::vector<double>& frames :
         {std::vector{1 / 12.0}, {1 / 15.0}, {1 / 30.0}, {1 / 60.0}, {1 / 144.0}, {0.01, 0.05}}) {
        const std::vector<MoveBlade> moves = timedStroke(frames);
        SCOPED_TRACE(frames.front());
        EXPECT_NEAR(double(moves.size()), 200, 4);
        EXPECT_DOUBLE_EQ(moves.front().seconds.value_or(0), 1) << "it was away";
        double time = 0;
        const StrokeSpace where = space();
        for (std::size_t i = 1; i < moves.size(); ++i) {
            time += moves[i].seconds.value_or(0);
            const double there = where.distance(moves.front().blade, moves[i].blade);
            const double wanted =
                where.distance(moves.front().blade, where.bladeAt({0, 0.5 - 0.5 * time}));
            EXPECT_NEAR(there, wanted,
                        0.02 * where.distance(moves.front().blade, moves.back().blade))
                << "at " << time;
        }
        EXPECT_NEAR(time, 2, 1e-9);
    }
}

TEST(BladeStroke, AHandThatRestsIsSimulatedForAMomentAndItsTimeKept) {
    BladeStroke stroke;
    stroke.keepTime(0.01);
    stroke.begin(space(), {0, 0.5});
    stroke.elapse(0.1);
    stroke.moveTo({0, 0.4});
    for (int i = 0; i < 500; ++i) {
        stroke.elapse(0.01);
    }
    stroke.end();
    double time = 0;
    EXPECT_LT(stroke.pending(), 45U);
    while (const std::optional<Command> command = stroke.next()) {
        const auto* move = std::get_if<MoveBlade>(&*command);
        time += move == nullptr ? 0 : move->seconds.value_or(0);
    }
    EXPECT_NEAR(time, 5.1, 1e-9);
}

TEST(BladeStroke, TheLiftComesAfterTheLastPose) {
    BladeStroke stroke;
    stroke.begin(space(), {0, 0.5});
    stroke.moveTo({0, -0.5});
    stroke.end();
    std::optional<Command> last;
    while (std::optional<Command> command = stroke.next()) {
        last = command;
    }
    ASSERT_TRUE(last.has_value());
    EXPECT_TRUE(std::holds_alternative<LiftBlade>(*last));
    EXPECT_TRUE(stroke.wayAhead().empty());
}

TEST(BladeStroke, CancelForgetsWhatIsToComeAndLifts) {
    BladeStroke stroke;
    stroke.begin(space(), {0, 0.5});
    stroke.moveTo({0, -0.5});
    for (int i = 0; i < 3; ++i) {
        stroke.next();
    }
    EXPECT_EQ(stroke.wayAhead().size(), stroke.pending() + 2) << "the last pose and the pointer";
    stroke.cancel();
    EXPECT_FALSE(stroke.drawing());
    ASSERT_EQ(stroke.pending(), 1U);
    EXPECT_TRUE(std::holds_alternative<LiftBlade>(*stroke.next()));
}

TEST(StrokeSpace, ASetDepthEndsBehindTheNearestPoint) {
    render::Camera camera;
    camera.eye = Vec3(0, 0, 6);
    camera.target = Vec3::Zero();
    const Blade blade = StrokeSpace(camera, kAspect, unitBounds(), 0.5).bladeAt({0, 0});
    EXPECT_NEAR(blade.b.z(), 0.5, 1e-12) << "the body reaches to z = 1";
    EXPECT_GT(blade.a.z(), 1);
}

TEST(StrokeSpace, AnOrthographicBladeStandsAlongTheViewAndGoesThroughAll) {
    render::Camera camera;
    camera.eye = Vec3(0, 0, 6);
    camera.target = Vec3::Zero();
    camera.orthographic = true;
    for (const double distance : {6.0, 0.1}) {
        // Near by, the eye itself is inside the body.
        camera.eye.z() = distance;
        const Blade blade = StrokeSpace(camera, kAspect, unitBounds()).bladeAt({0.3, -0.2});
        EXPECT_NEAR((blade.b - blade.a).cross(Vec3::UnitZ()).norm(), 0, 1e-9);
        EXPECT_GT(blade.a.z(), 1);
        EXPECT_LT(blade.b.z(), -1);
    }
}

TEST(BladeStroke, CancelBeforeTheFirstStepLeavesNothing) {
    BladeStroke stroke;
    stroke.begin(space(), {0, 0.5});
    stroke.moveTo({0, -0.5});
    stroke.cancel();
    EXPECT_EQ(stroke.next(), std::nullopt);
}

}  // namespace
}  // namespace kerf::app
