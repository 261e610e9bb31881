#include "app/scene/session_journal.h"

#include <gtest/gtest.h>

namespace kerf::app {
namespace {

MoveBlade pose(double y) {
    return {{Vec3(-1, y, 0), Vec3(1, y, 0)}};
}

TEST(SessionJournal, ABladeThatStoodStillIsSaidToHave) {
    SessionJournal journal;
    journal.note(3, pose(1));
    journal.note(4, pose(0.9));
    journal.note(9, pose(0.8));
    journal.note(10, LiftBlade{});
    Session session;
    session.steps = 12;
    session.events = journal.events();
    const SessionPlayer player(session);
    for (const int step : {5, 6, 7}) {
        const auto actions = player.actionsAt(step);
        ASSERT_EQ(actions.size(), 1U);
        EXPECT_NEAR(std::get<MoveBlade>(actions[0].action).blade.a.y(), 0.9, 1e-15);
    }
    EXPECT_EQ(std::get<MoveBlade>(player.actionsAt(9).at(0).action).blade.a.y(), 0.8);
}

TEST(SessionJournal, AHandThatStoodStillIsSaidToHave) {
    SessionJournal journal;
    journal.note(3, Grab{0, Vec3(1, 0, 0), 0.1});
    journal.note(7, Drag{0, Vec3(2, 0, 0)});
    journal.note(12, Drag{0, Vec3(3, 0, 0)});
    journal.note(13, Release{0});
    Session session;
    session.steps = 15;
    session.events = journal.events();
    const SessionPlayer player(session);
    const auto drags = [&](int step) {
        std::vector<double> places;
        for (const PlayedAction& played : player.actionsAt(step)) {
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

TEST(SessionJournal, OfASliderDragAtOneStepOnlyTheLastValueIsKept) {
    SessionJournal journal;
    journal.note(2, SetParam{"friction", 0.1});
    journal.note(2, SetParam{"friction", 0.2, true});
    journal.note(3, SetParam{"friction", 0.3, true});
    ASSERT_EQ(journal.events().size(), 2U);
    const auto& first = std::get<SetParam>(journal.events()[0].action);
    EXPECT_EQ(std::get<double>(first.value), 0.2);
    EXPECT_FALSE(first.continues);
    EXPECT_TRUE(std::get<SetParam>(journal.events()[1].action).continues);
}

TEST(SessionJournal, GoesBackToAMark) {
    SessionJournal journal;
    journal.note(1, pose(1));
    const SessionJournal::Mark mark = journal.mark();
    journal.note(2, LiftBlade{});
    journal.goBackTo(mark);
    EXPECT_EQ(journal.events().size(), 1U);
    journal.note(8, pose(0.5));
    EXPECT_EQ(journal.events().size(), 3U) << "with the pose that was held";
}

}  // namespace
}  // namespace kerf::app
