#include "app/scene/editor_stroke.h"

#include "app/scene/incision.h"
#include "app/scene/timeline/hooks.h"

namespace kerf::app {
namespace {

constexpr double kAspect = 16.0 / 9;

Bounds unitBounds() {
    return {Vec3(-1, -1, -1), Vec3(1, 1, 1)};
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

TEST(BladeStroke, AClickOrACancelBeforeTheFirstStepDoesNothing) {
    BladeStroke stroke;
    stroke.begin(space(), {0, 0});
    stroke.end();
    EXPECT_EQ(stroke.pending(), 0U);
    EXPECT_EQ(stroke.next(), std::nullopt);
    stroke.begin(space(), {0, 0.5});
    stroke.moveTo({0, -0.5});
    stroke.cancel();
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

// Hands that keep to the time of the body.

class HeldHandsTest : public GlTest {
  protected:
    void SetUp() override {
        GlTest::SetUp();
        UploadedDocument uploaded(prepareDocument(sphereDocument()));
        scene.emplace(std::move(uploaded.document), std::move(uploaded.body));
        ASSERT_EQ(hands().grab(kAt, 0.2), "");
    }
    HeldHands& hands() { return scene->hands(); }
    /// Where the hand is.
    Vec3 place() { return scene->simulation().hands().at(0).to; }
    double stepLength() { return kSpeed * scene->simulation().params().timeStep; }

    static constexpr double kSpeed = 2;  // [m/s]
    const Vec3 kAt{0.5, 0, 0};
    const Vec3 kTo{0.6, 0.1, 0};
    std::optional<EditorScene> scene;
};

TEST_F(HeldHandsTest, AreWhereTheyAreDraggedToWithoutALimit) {
    hands().dragTo(kTo);
    scene->step();
    EXPECT_EQ(place(), kTo);
    EXPECT_EQ(hands().ahead(), 0);
}

TEST_F(HeldHandsTest, MoveNoFasterThanTheirLimitInSimulatedTime) {
    hands().limitSpeed(kSpeed);
    hands().dragTo(kTo);
    const double way = (kTo - kAt).norm();
    Vec3 before = kAt;
    int steps = 0;
    for (; place() != kTo && steps < 1000; ++steps) {
        EXPECT_TRUE(hands().pulling());
        EXPECT_NEAR(hands().ahead(), way - steps * stepLength(), 1e-9);
        scene->step();
        EXPECT_LE((place() - before).norm(), stepLength() * (1 + 1e-9));
        before = place();
    }
    EXPECT_EQ(steps, static_cast<int>(std::ceil(way / stepLength())));
    EXPECT_EQ(hands().ahead(), 0);
}

TEST_F(HeldHandsTest, LetGoOnceTheyHaveArrived) {
    hands().limitSpeed(kSpeed);
    hands().dragTo(kTo);
    scene->step();
    hands().letGoThere();
    int steps = 1;
    for (; hands().pulling() && steps < 1000; ++steps) {
        ASSERT_EQ(scene->simulation().hands().size(), 1U) << "still on its way";
        scene->step();
    }
    EXPECT_GE(steps * stepLength(), (kTo - kAt).norm());
    EXPECT_TRUE(scene->simulation().hands().empty());
}

TEST_F(HeldHandsTest, LetGoAtOnceWhereThatIsAskedFor) {
    hands().limitSpeed(kSpeed);
    hands().dragTo(kTo);
    scene->step();
    hands().letGo();
    EXPECT_TRUE(scene->simulation().hands().empty());
    EXPECT_FALSE(hands().pulling());
}

// Where the lips of a cut are, and how large a hand is there.

class IncisionTest : public SimulationFixture {
  protected:
    /// A slit across the top of a ball, in the plane z = 0.013.
    void slitTo(double bottom) {
        simulation.emplace(icosphere(3), weightless());
        for (double y = 0.7; y > bottom; y -= 0.03) {
            simulation->execute(MoveBlade{{{-1, y, 0.013}, {1, y, 0.013}}});
            simulation->step();
        }
        simulation->execute(LiftBlade{});
        simulation->step();
    }
    static Vec3 beside(double z) { return Vec3(0.02, 0.5, z).normalized() * 0.5; }
};

TEST_F(IncisionTest, LipsLieOnBothSidesThePressedOneFirst) {
    slitTo(0.1);
    for (const int side : {1, -1}) {
        const auto found = incisionNear(simulation->mesh(), beside(0.08 * side), 0.2);
        ASSERT_TRUE(found);
        EXPECT_GT(side * (found->lips[0].z() - 0.013), 0);
        EXPECT_LT(side * (found->lips[1].z() - 0.013), 0);
        EXPECT_LT((found->lips[0] - found->lips[1]).norm(), 0.15) << "they face each other";
        EXPECT_LT(side * found->across.z(), -0.97) << "from the pressed one to the other";
        EXPECT_NEAR(found->away, 0.079 - 0.013 * side, 0.01);
        EXPECT_NEAR(found->gap, 0, 0.01);
        EXPECT_NEAR(found->length, 1.06, 0.1) << "of the arc's box: 2 * 0.49 wide, 0.4 high";
    }
}

TEST_F(IncisionTest, NoneIsFoundWithoutACutOrBeyondTheReach) {
    slitTo(0.1);
    EXPECT_FALSE(incisionNear(simulation->mesh(), Vec3(0, -0.5, 0), 0.2));
    EXPECT_FALSE(incisionNear(icosphere(2), beside(0.08), 10));
}

TEST_F(IncisionTest, AHandIsSmallerWhereALipOrAPieceIs) {
    slitTo(0.35);
    const SurfaceMesh& mesh = simulation->mesh();
    const Bounds body = simulation->bounds();
    const double atLip = handRadius(mesh, beside(0.06), 0.3, body);
    EXPECT_LT(atLip, 0.2);
    EXPECT_GT(atLip, 0.08);
    EXPECT_EQ(handRadius(mesh, Vec3(0, -0.5, 0), 0.3, body), 0.3) << "no cut is near";
    Bounds crumb{Vec3(0, -0.5, 0), Vec3(0.1, -0.4, 0)};
    EXPECT_LT(handRadius(mesh, Vec3(0, -0.5, 0), 0.3, crumb), 0.05);
}

TEST(Hooks, AreTwoHandsOfARetractor) {
    EXPECT_EQ(partnerOf(kFirstHook), kFirstHook + 1);
    EXPECT_EQ(partnerOf(kFirstHook + 1), kFirstHook);
    std::vector<Hands::Hand> hands(3);
    hands[1].number = kFirstHook + 1;
    hands[2].number = kFirstHook + 2;
    EXPECT_EQ(hooksOf(hands).size(), 2U);
    EXPECT_EQ(freeRetractor(hands), kFirstHook + 4);
    hands.clear();
    for (int number = kFirstHook; number <= kLastHook; ++number) {
        hands.emplace_back().number = number;
    }
    EXPECT_EQ(freeRetractor(hands), std::nullopt);
}

}  // namespace
}  // namespace kerf::app
