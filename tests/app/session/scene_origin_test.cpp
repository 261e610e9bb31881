// Places that are counted from a point beside the models, and from 0 in files.
#include "app/session/scene_origin.h"

#include <gtest/gtest.h>

#include <random>

#include "app/session/session.h"
#include "tests/support/fuzz_seed.h"
#include "tests/support/session_samples.h"

namespace kerf::app {
namespace {

const Vec3 kMap(500096, 304, -5000192);

TEST(SceneOrigin, SessionsAreWrittenAsTheyWereRead) {
    for (const std::string& text : {test::sessionWithEveryKey(), test::sessionWithEveryEvent()}) {
        const Session read = parseSession(text, "/");
        const Session near = withOrigin(read, Vec3(64, -128, 512));
        EXPECT_EQ(near.origin, Vec3(64, -128, 512));
        const Session again = parseSession(formatSession(near, "/"), "/");
        const std::string asWritten = formatSession(withOrigin(again, Vec3(64, -128, 512)), "/");
        EXPECT_EQ(asWritten, formatSession(near, "/"));
        EXPECT_EQ(formatSession(withOrigin(near, Vec3::Zero()), "/"), formatSession(near, "/"));
    }
}

TEST(SceneOrigin, AnOriginAtZeroChangesNoBit) {
    for (const std::string& text : {test::sessionWithEveryKey(), test::sessionWithEveryEvent()}) {
        const Session read = parseSession(text, "/");
        EXPECT_EQ(formatSession(withOrigin(read, Vec3::Zero()), "/"), formatSession(read, "/"));
    }
    const Command minusZero = Drag{0, Vec3(-0.0, 1, 2)};
    const auto same = std::get<Drag>(asReplayed(minusZero, Vec3::Zero()));
    EXPECT_TRUE(std::signbit(same.to.x()));
}

TEST(SceneOrigin, WhatIsAPlaceMovesAndWhatIsNoneStays) {
    const Vec3 by(1, 10, 100);
    const auto moved = [&](const Command& command) { return countedFrom(command, by); };
    const Vec3 at(5, 6, 7);
    const Vec3 there(4, -4, -93);
    const auto blade = std::get<MoveBlade>(moved(MoveBlade{{at, Vec3(1, 10, 100)}})).blade;
    EXPECT_EQ(blade.a, there);
    EXPECT_EQ(blade.b, Vec3(0, 0, 0));
    EXPECT_EQ(std::get<Grab>(moved(Grab{1, at, 0.5})).at, there);
    EXPECT_EQ(std::get<Drag>(moved(Drag{1, at})).to, there);
    EXPECT_EQ(std::get<Ball>(std::get<Pin>(moved(Pin{Ball{at, 2}})).region).center, there);
    const auto box = std::get<Bounds>(std::get<Pin>(moved(Pin{Bounds{at, 2 * at}})).region);
    EXPECT_EQ(box.low, there);
    EXPECT_EQ(box.high, Vec3(9, 2, -86));
    EXPECT_EQ(std::get<AddBox>(moved(AddBox{{at, Vec3::Ones()}})).box.center, there);
    EXPECT_EQ(std::get<ChangeBox>(moved(ChangeBox{0, {at, Vec3::Ones()}})).box.center, there);
    EXPECT_EQ(std::get<MovePins>(moved(MovePins{at})).by, at);
    EXPECT_EQ(std::get<SetParam>(moved(SetParam{"gravity", at})).value, ParamValue(at));
    EXPECT_EQ(std::get<SetParam>(moved(SetParam{"floor", 3.0})).value, ParamValue(-7.0));
    EXPECT_EQ(std::get<SetParam>(moved(SetParam{"damping", 3.0})).value, ParamValue(3.0));
    Placement placement;
    placement.translate = at;
    EXPECT_EQ(std::get<Place>(moved(Place{placement})).placement.translate, there);
    render::Camera camera;
    camera.target = at;
    EXPECT_EQ(countedFrom(camera, by).target, there);
    EXPECT_EQ(countedFrom(camera, by).up, camera.up);
}

// Else a person's cut would not be that of its replay.
TEST(SceneOrigin, WhatIsDoneIsWhatAFileSays) {
    std::mt19937_64 engine(test::fuzzSeed(1));
    std::normal_distribution<double> normal;
    const double scales[] = {1e-3, 1, 10, 1e6, 1e7};
    for (int i = 0; i < 10000; ++i) {
        const double scale = scales[i % std::size(scales)];
        const Command wanted =
            Drag{0, scale * Vec3(normal(engine), normal(engine), normal(engine))};
        const Command done = asReplayed(wanted, kMap);
        const SessionEvent event{0, std::get<Drag>(countedFrom(done, -kMap))};
        Session session = parseSession(test::sessionWith(""), "/");
        session.events = {event};
        const Session read = parseSession(formatSession(session, "/"), "/");
        const auto replayed = std::get<Drag>(withOrigin(read, kMap).events.front().action);
        ASSERT_EQ(replayed.to, std::get<Drag>(done).to) << i;
        ASSERT_NEAR((replayed.to - std::get<Drag>(wanted).to).norm(), 0, 1e-8 * (1 + scale));
    }
}

}  // namespace
}  // namespace kerf::app
