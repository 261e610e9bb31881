#include "app/scene/timeline/event_log.h"

#include "app/scene/timeline/saved_session.h"
#include "app/scene/timeline/session_marks.h"

namespace kerf::app {
namespace {

MoveBlade pose(double y) {
    return {{Vec3(-1, y, 0), Vec3(1, y, 0)}};
}

std::vector<SessionEvent> eventsOf(const EventLog& journal) {
    return sessionAsSaved({}, journal).session.events;
}
Session sessionOf(const EventLog& journal, int steps) {
    Session session;
    session.steps = steps;
    session.events = eventsOf(journal);
    return session;
}
std::vector<int> stepsOf(const EventLog& journal) {
    std::vector<int> steps;
    for (const SessionEvent& event : eventsOf(journal)) {
        steps.push_back(event.step);
    }
    return steps;
}
/// Lets everything up to a step happen.
void playTo(EventLog& journal, int step) {
    for (int s = 0; s < step; ++s) {
        while (journal.takeDue(s) != nullptr) {
        }
    }
}
const CheckEvent& checkAt(const std::vector<SessionEvent>& events, std::size_t index) {
    return std::get<CheckEvent>(events.at(index).action);
}

TEST(EventLog, ATestLacksTheChecksThatARecordingMakesAlone) {
    EventLog journal;
    journal.note(3, pose(1));
    journal.note(5, CheckEvent{"0123456789abcdef", 1});
    journal.add(journal.here(6), CheckEvent{"fedcba9876543210", 2});
    EXPECT_EQ(eventsOf(journal).size(), 3U);
    const auto events = sessionAsSaved({}, journal, SavedAs::test).session.events;
    ASSERT_EQ(events.size(), 2U);
    EXPECT_EQ(checkAt(events, 1).pieces, 2) << "a person's own";
}

TEST(EventLog, ABladeThatStoodStillIsSaidToHave) {
    EventLog journal;
    journal.note(3, pose(1));
    journal.note(4, pose(0.9));
    journal.note(9, pose(0.8));
    journal.note(10, LiftBlade{});
    const Session session = sessionOf(journal, 12);
    const SessionSchedule schedule(session);
    for (const int step : {5, 6, 7}) {
        const auto actions = schedule.actionsAt(step);
        ASSERT_EQ(actions.size(), 1U);
        EXPECT_NEAR(std::get<MoveBlade>(actions[0].action).blade.a.y(), 0.9, 1e-15);
    }
    EXPECT_EQ(std::get<MoveBlade>(schedule.actionsAt(9).at(0).action).blade.a.y(), 0.8);
}

TEST(EventLog, NoHandTookTimeWhereABladeStoodStill) {
    EventLog journal;
    MoveBlade led = pose(1);
    led.seconds = 0.5;
    journal.note(3, led);
    journal.note(9, led);
    std::vector<double> times;
    for (const SessionEvent& event : eventsOf(journal)) {
        times.push_back(std::get<MoveBlade>(event.action).seconds.value_or(0));
    }
    EXPECT_THAT(times, ElementsAre(0.5, 0, 0.5));
}

TEST(EventLog, AHandThatStoodStillIsSaidToHave) {
    EventLog journal;
    journal.note(3, Grab{0, Vec3(1, 0, 0), 0.1});
    journal.note(7, Drag{0, Vec3(2, 0, 0)});
    journal.note(12, Drag{0, Vec3(3, 0, 0)});
    journal.note(13, Release{0});
    const Session session = sessionOf(journal, 15);
    const SessionSchedule schedule(session);
    const auto drags = [&](int step) {
        std::vector<double> places;
        for (const PlayedAction& played : schedule.actionsAt(step)) {
            if (const auto* drag = std::get_if<Drag>(&played.action)) {
                places.push_back(drag->to.x());
            }
        }
        return places;
    };
    for (const int step : {4, 5, 6}) {
        EXPECT_EQ(drags(step), std::vector<double>{1}) << step;
    }
    EXPECT_EQ(drags(7), std::vector<double>{2});
    for (const int step : {8, 9, 10, 11}) {
        EXPECT_EQ(drags(step), std::vector<double>{2}) << step;
    }
    EXPECT_EQ(drags(12), std::vector<double>{3});
}

TEST(EventLog, OfASliderDragAtOneStepOnlyTheLastValueIsKept) {
    EventLog journal;
    journal.note(2, SetParam{"friction", 0.1});
    journal.note(2, SetParam{"friction", 0.2, true});
    journal.note(3, SetParam{"friction", 0.3, true});
    const std::vector<SessionEvent> events = eventsOf(journal);
    ASSERT_EQ(events.size(), 2U);
    const auto& first = std::get<SetParam>(events[0].action);
    EXPECT_EQ(std::get<double>(first.value), 0.2);
    EXPECT_FALSE(first.continues);
    EXPECT_TRUE(std::get<SetParam>(events[1].action).continues);
}

TEST(EventLog, WhatAPersonAddsStandsAtThePresentOfThePlayedSession) {
    EventLog journal;
    journal.open({{2, pose(1)}, {5, SetParam{"friction", 0.5}}, {9, pose(0)}});
    playTo(journal, 5);
    journal.note(5, SetParam{"friction", 0.1});
    const auto values = [&] {
        std::vector<double> found;
        for (const SessionEvent& event : eventsOf(journal)) {
            if (const auto* set = std::get_if<SetParam>(&event.action)) {
                found.push_back(std::get<double>(set->value));
            }
        }
        return found;
    };
    EXPECT_THAT(stepsOf(journal), ElementsAre(2, 5, 5, 9));
    EXPECT_THAT(values(), ElementsAre(0.1, 0.5)) << "what the session does at this step comes then";
    journal.goTo(0, 0);
    journal.note(0, SetParam{"friction", 0.2});
    EXPECT_THAT(values(), ElementsAre(0.2, 0.5)) << "a slider stays where it was moved to last";
    journal.restart();
    EXPECT_THAT(values(), ElementsAre(0.5));
    EXPECT_FALSE(journal.firstChange());
}

TEST(EventLog, GoesToWhereSoManyCommandsWereDone) {
    EventLog journal;
    journal.open({{2, pose(1)}, {2, CheckEvent{{}, 1}}, {4, pose(0)}, {4, LiftBlade{}}});
    playTo(journal, 4);
    journal.note(4, SetParam{"friction", 0.1});
    EXPECT_EQ(journal.commandsDone(4), 1U);
    EXPECT_EQ(journal.takeDue(4)->event.step, 4);
    journal.add(journal.here(4), ScreenshotEvent{"a.png"});
    journal.goTo(4, 1);
    journal.note(4, SetParam{"density", 100.0});
    const std::vector<SessionEvent> events = eventsOf(journal);
    ASSERT_EQ(events.size(), 7U);
    EXPECT_EQ(std::get<SetParam>(events[2].action).name, "friction");
    EXPECT_EQ(std::get<SetParam>(events[3].action).name, "density");
    journal.goTo(3, 0);
    EXPECT_EQ(journal.takeDue(3), nullptr);
    EXPECT_EQ(std::get<SetParam>(journal.takeDue(4)->event.action).name, "friction");
}

TEST(EventLog, ChecksBehindAChangeAreRenewedOrLoseTheirHash) {
    const std::string hash(16, 'a');
    EventLog journal;
    journal.open({{1, CheckEvent{hash, 1}},
                  {3, CheckEvent{hash, {}}},
                  {5, CheckEvent{hash, 2}},
                  {7, CheckEvent{hash, {}}},
                  {9, CheckEvent{{}, 2}}});
    playTo(journal, 2);
    journal.note(2, SetParam{"friction", 0.1});
    journal.takeDue(3)->found = CheckEvent{std::string(16, 'b'), {}};
    const SavedSession saved = sessionAsSaved({}, journal);
    const std::vector<SessionEvent>& events = saved.session.events;
    ASSERT_EQ(events.size(), 5U) << "the one at step 7 has nothing left to check";
    EXPECT_EQ(checkAt(events, 0).hash, hash) << "it stands before the change";
    EXPECT_EQ(checkAt(events, 2).hash, std::string(16, 'b'));
    EXPECT_FALSE(checkAt(events, 3).hash);
    EXPECT_EQ(checkAt(events, 3).pieces, 2);
    EXPECT_EQ(checkAt(events, 4).pieces, 2);
    EXPECT_EQ(saved.remark,
              "Since you changed it at step 2, 1 check was updated, 1 check lost its state hash, 1 "
              "check was dropped.");
    journal.restart();
    EXPECT_EQ(checkAt(eventsOf(journal), 4).pieces, 2);
    EXPECT_EQ(checkAt(eventsOf(journal), 3).hash, hash) << "nothing is changed any more";
}

TEST(EventLog, WhatAHoldAddsBeforeAStepDoesNotCountForIt) {
    EventLog journal;
    journal.note(2, pose(1));
    journal.note(9, SetParam{"friction", 0.1});
    const std::size_t done = journal.commandsDone(9);
    journal.note(9, pose(0));  // the blade stood still until step 8
    EXPECT_THAT(stepsOf(journal), ElementsAre(2, 8, 9, 9));
    journal.goTo(9, done);
    EXPECT_TRUE(std::holds_alternative<MoveBlade>(journal.takeDue(9)->event.action));
}

TEST(EventLog, APersonsOwnRestIsLeftOutForGood) {
    EventLog journal;
    journal.open({{2, pose(1)}, {10, pose(0)}});
    playTo(journal, 6);
    EXPECT_EQ(journal.takeOver(6, {}), 0U);
    journal.note(6, LiftBlade{});
    journal.note(8, SetParam{"friction", 0.1});
    journal.goTo(7, 0);
    EXPECT_EQ(journal.takeOver(7, {}), 1U);
    EXPECT_EQ(journal.leftOut(), 1U) << "of the session";
    EXPECT_THAT(stepsOf(journal), ElementsAre(2, 6));
    journal.goTo(1, 0);
    EXPECT_EQ(journal.takeOver(1, {}), 1U);
    journal.restart();
    EXPECT_THAT(stepsOf(journal), ElementsAre(2, 10));
}

TEST(EventLog, AMoveThatATakeOverCutsShortEndsWhereTheBladeIs) {
    EventLog journal;
    journal.open({{2, pose(1)}, {10, pose(0)}, {11, ScreenshotEvent{"end.png"}}});
    playTo(journal, 6);
    journal.note(6, SetParam{"friction", 0.1});
    journal.takeOver(6, {{pose(0.6), -1}});
    journal.note(6, LiftBlade{});
    EXPECT_THAT(stepsOf(journal), ElementsAre(2, 5, 6, 6));
    EXPECT_EQ(sessionAsSaved({}, journal).remark,
              "Since you took over at step 6, 2 later events were dropped.");
    journal.restart();
    EXPECT_THAT(stepsOf(journal), ElementsAre(2, 10, 11));
}

TEST(EventLog, WhatFailedIsLeftOutOnlyOfAChangedSession) {
    EventLog journal;
    journal.open({{1, RemoveBox{0}}, {2, LiftBlade{}}});
    journal.takeDue(1)->failed = true;
    EXPECT_EQ(eventsOf(journal).size(), 2U);
    journal.note(2, SetParam{"friction", 0.1});
    EXPECT_THAT(stepsOf(journal), ElementsAre(2, 2));
    EXPECT_THAT(sessionAsSaved({}, journal).remark, HasSubstr("no longer possible"));
}

TEST(EventLog, PicturesStandWhereTheyWereAskedForAndCanBeRemoved) {
    EventLog journal;
    journal.note(3, pose(1));
    const LogPosition then = journal.here(3);
    journal.note(3, LiftBlade{});
    journal.note(8, pose(0));
    journal.add(then, ScreenshotEvent{freeOutputName(journal, "ball", 3, ".png")});
    journal.add(journal.here(8), ScreenshotEvent{freeOutputName(journal, "ball", 3, ".png")});
    EXPECT_THAT(stepsOf(journal), ElementsAre(3, 3, 3, 8, 8));
    EXPECT_TRUE(std::holds_alternative<ScreenshotEvent>(eventsOf(journal)[1].action));
    const std::vector<ui::SessionMark> marks = marksOf(journal);
    ASSERT_EQ(marks.size(), 2U);
    EXPECT_EQ(marks[0].text, "ball-3.png");
    EXPECT_EQ(marks[1].text, "ball-3-2.png");
    journal.remove(marks[0].id);
    journal.note(9, pose(-1));
    EXPECT_THAT(stepsOf(journal), ElementsAre(3, 3, 8, 8, 9));
    EXPECT_EQ(marksOf(journal).size(), 1U);
}

TEST(EventLog, ChecksThatARecordingMakesAreNoMarks) {
    EventLog journal;
    journal.note(50, CheckEvent{std::string(16, 'a'), 1});
    EXPECT_THAT(marksOf(journal), IsEmpty());
    EXPECT_EQ(eventsOf(journal).size(), 1U);
}

TEST(EventLog, PicturesSurviveARestartAndChecksBehindChangesAreInDoubtThen) {
    EventLog journal;
    journal.open({{2, pose(1)}});
    journal.note(0, SetParam{"friction", 0.1});
    playTo(journal, 4);
    journal.add(journal.here(4), CheckEvent{std::string(16, 'a'), 2});
    journal.add(journal.here(4), ScreenshotEvent{"a.png"});
    EXPECT_TRUE(checkAt(eventsOf(journal), 2).hash);
    journal.restart();
    EXPECT_THAT(stepsOf(journal), ElementsAre(2, 4, 4));
    EXPECT_FALSE(checkAt(eventsOf(journal), 1).hash);
}

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

TEST(SessionSchedule, PosesBetweenKeysAreLinearOnePerStepAndThereAreNoOthers) {
    const Session session = sessionOf({key(10, 1), key(14, 3), key(16, 1)});
    const SessionSchedule schedule(session);
    std::vector<std::vector<double>> heights;
    for (int step = 9; step <= 17; ++step) {
        heights.push_back(heightsAt(schedule, step));
    }
    EXPECT_EQ(heights,
              (std::vector<std::vector<double>>{{}, {1}, {1.5}, {2}, {2.5}, {3}, {2}, {1}, {}}));
    EXPECT_TRUE(schedule.actionsAt(0).empty());
    EXPECT_TRUE(schedule.actionsAt(17).empty());
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
