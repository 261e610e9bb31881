#include <gtest/gtest.h>

#include "app/session/session.h"

namespace kerf::app {
namespace {

Blade bladeAt(double height) {
    return {{-1, height, 0}, {1, height, 0}};
}

SessionEvent key(int step, double height) {
    return {step, MoveBlade{bladeAt(height)}};
}
SessionEvent lift(int step) {
    return {step, LiftBlade{}};
}

Session sessionOf(std::vector<SessionEvent> events) {
    Session session;
    session.steps = 100;
    session.events = std::move(events);
    return session;
}

/// Heights of the blade poses of one step.
std::vector<double> heightsAt(const SessionSchedule& schedule, int step) {
    std::vector<double> heights;
    for (const PlayedAction& played : schedule.actionsAt(step)) {
        if (const auto* move = std::get_if<MoveBlade>(&played.action)) {
            heights.push_back(move->blade.a.y());
        }
    }
    return heights;
}

TEST(SessionSchedule, NothingMovesBeforeTheFirstKeyAndAfterTheLast) {
    const Session session = sessionOf({key(10, 1), key(12, 0)});
    const SessionSchedule schedule(session);
    EXPECT_TRUE(schedule.actionsAt(0).empty());
    EXPECT_TRUE(schedule.actionsAt(9).empty());
    EXPECT_TRUE(schedule.actionsAt(13).empty());
}

TEST(SessionSchedule, PosesBetweenKeysAreLinearOnePerStep) {
    const Session session = sessionOf({key(10, 1), key(14, 3)});
    const SessionSchedule schedule(session);
    EXPECT_EQ(heightsAt(schedule, 10), std::vector<double>{1});
    EXPECT_EQ(heightsAt(schedule, 11), std::vector<double>{1.5});
    EXPECT_EQ(heightsAt(schedule, 12), std::vector<double>{2});
    EXPECT_EQ(heightsAt(schedule, 13), std::vector<double>{2.5});
    EXPECT_EQ(heightsAt(schedule, 14), std::vector<double>{3});
}

TEST(SessionSchedule, KeysInARowShareTheirPose) {
    const Session session = sessionOf({key(0, 0), key(2, 2), key(4, 0)});
    const SessionSchedule schedule(session);
    EXPECT_EQ(heightsAt(schedule, 1), std::vector<double>{1});
    EXPECT_EQ(heightsAt(schedule, 2), std::vector<double>{2});
    EXPECT_EQ(heightsAt(schedule, 3), std::vector<double>{1});
}

TEST(SessionSchedule, ALiftEndsTheSweep) {
    const Session session = sessionOf({key(0, 0), key(2, 2), lift(3), key(8, 5), key(10, 6)});
    const SessionSchedule schedule(session);
    for (const int step : {4, 5, 6, 7}) {
        EXPECT_TRUE(schedule.actionsAt(step).empty()) << step;
    }
    EXPECT_EQ(heightsAt(schedule, 9), std::vector<double>{5.5});
}

TEST(SessionSchedule, UndoRedoAndRestartEndTheSweepAsALiftDoes) {
    for (const SessionAction& end : std::vector<SessionAction>{Undo{}, Redo{}, Restart{}}) {
        const Session session = sessionOf({key(0, 0), {2, end}, key(4, 4), key(6, 5)});
        const SessionSchedule schedule(session);
        for (const int step : {1, 2, 3}) {
            EXPECT_EQ(heightsAt(schedule, step), std::vector<double>{}) << step;
        }
        EXPECT_EQ(heightsAt(schedule, 4), std::vector<double>{4});
        EXPECT_EQ(heightsAt(schedule, 5), std::vector<double>{4.5});
    }
}

TEST(SessionSchedule, EventsOfOneStepComeInOrderThePoseLast) {
    const Session session =
        sessionOf({key(0, 0), {1, SetParam{"iterations", 5.0}}, {1, CheckEvent{{}, 1}}, key(2, 2)});
    const auto actions = SessionSchedule(session).actionsAt(1);
    ASSERT_EQ(actions.size(), 3u);
    EXPECT_TRUE(std::holds_alternative<SetParam>(actions[0].action));
    EXPECT_TRUE(std::holds_alternative<CheckEvent>(actions[1].action));
    EXPECT_TRUE(std::holds_alternative<MoveBlade>(actions[2].action));
}

TEST(SessionSchedule, WhatHappensKnowsItsEventInTheFile) {
    const Session session = parseSession(
        R"({"format": "kerf-session", "version": 1, "model": {"builtin": "sphere20"}, "steps": 9,
            "events": [{"step": 4, "type": "lift"},
                       {"step": 3, "type": "blade", "a": [0, 0, 0], "b": [1, 0, 0]},
                       {"step": 1, "type": "blade", "a": [0, 2, 0], "b": [1, 2, 0]},
                       {"step": 7, "type": "drag", "to": [1, 0, 0]},
                       {"step": 5, "type": "grab", "at": [0, 0, 0], "radius": 1}]})",
        "/");
    const SessionSchedule schedule(session);
    const std::vector<std::pair<int, int>> numberAt{{1, 2}, {2, 1}, {3, 1}, {4, 0},
                                                    {5, 4}, {6, 3}, {7, 3}};
    for (const auto& [step, number] : numberAt) {
        ASSERT_EQ(schedule.actionsAt(step).size(), 1u) << step;
        EXPECT_EQ(schedule.actionsAt(step)[0].number, number) << step;
    }
}

TEST(SessionSchedule, AfterTheLastStepComeTheEventsOfTheEnd) {
    const Session session = sessionOf({key(0, 0), {100, CheckEvent{{}, 1}}});
    EXPECT_EQ(SessionSchedule(session).actionsAt(100).size(), 1u);
}

TEST(SessionSchedule, HandsMoveLinearlyFromTheirGrabToTheirDrags) {
    const Session session = sessionOf({{2, Grab{1, {0, 0, 0}, 0.1}},
                                       {3, Grab{2, {9, 0, 0}, 0.1}},
                                       {6, Drag{1, {4, 0, 0}}},
                                       {8, Release{1}},
                                       {20, Drag{2, {9, 17, 0}}}});
    const SessionSchedule schedule(session);
    const auto dragsAt = [&](int step) {
        std::vector<std::pair<int, Vec3>> drags;
        for (const PlayedAction& played : schedule.actionsAt(step)) {
            if (const auto* drag = std::get_if<Drag>(&played.action)) {
                drags.emplace_back(drag->hand, drag->to);
            }
        }
        return drags;
    };
    using Drags = std::vector<std::pair<int, Vec3>>;
    EXPECT_EQ(dragsAt(2), Drags{});
    EXPECT_EQ(dragsAt(3), (Drags{{1, {1, 0, 0}}}));
    EXPECT_EQ(dragsAt(5), (Drags{{1, {3, 0, 0}}, {2, {9, 2, 0}}}));
    EXPECT_EQ(dragsAt(6), (Drags{{1, {4, 0, 0}}, {2, {9, 3, 0}}}));
    EXPECT_EQ(dragsAt(10), (Drags{{2, {9, 7, 0}}}));
    EXPECT_EQ(dragsAt(21), Drags{});
}

}  // namespace
}  // namespace kerf::app
