// Hands that keep to the time of the body.
#include "app/scene/held_hands.h"

#include <gtest/gtest.h>

#include "app/scene/document/document_loading.h"
#include "app/scene/editor_scene.h"
#include "sim/run/simulation.h"
#include "tests/app/editor/editor_fixture.h"

namespace kerf::app {
namespace {

class HeldHandsTest : public test::GlTest {
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

}  // namespace
}  // namespace kerf::app
