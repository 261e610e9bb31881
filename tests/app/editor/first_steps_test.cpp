#include "app/editor/view/first_steps.h"

#include "sim/run/parts/step_report.h"
#include "ui/state/action_table.h"

namespace kerf::app {
namespace {

using ui::ActionId;

std::vector<ActionId> choicesOf(const ui::Hint& hint) {
    std::vector<ActionId> ids;
    for (const ui::HintChoice& choice : hint.choices) {
        ids.push_back(choice.id);
    }
    return ids;
}

TEST(CutWatch, TellsWhatCameOfAStroke) {
    CutWatch watch;
    const auto stroke = [&](int pieces, int triangles) {
        watch.follow(true, 1, 100);
        watch.follow(true, pieces, triangles);
        watch.follow(false, pieces, triangles);
        return watch.outcome();
    };
    watch.follow(false, 1, 100);
    EXPECT_EQ(watch.outcome(), StrokeOutcome::none);
    EXPECT_EQ(stroke(1, 100), StrokeOutcome::missed);
    EXPECT_EQ(stroke(1, 120), StrokeOutcome::incised);
    EXPECT_EQ(stroke(2, 180), StrokeOutcome::parted);
    watch.follow(false, 2, 180);
    EXPECT_EQ(watch.outcome(), StrokeOutcome::parted) << "until something else is done";
    watch.follow(false, 1, 100);
    EXPECT_EQ(watch.outcome(), StrokeOutcome::none) << "undone";
    watch.follow(true, 1, 100);
    watch.follow(true, 1, 120);
    watch.follow(false, 1, 100);
    EXPECT_EQ(watch.outcome(), StrokeOutcome::none)
        << "undone before it had ended: it met something";
}

TEST(FirstSteps, LeadThroughTheFirstCut) {
    FirstSteps steps;
    Situation now;
    EXPECT_EQ(steps.hint(now).text, "") << "the start page is there";
    now.open = now.weightless = true;
    EXPECT_THAT(steps.hint(now).text, HasSubstr("all the way across"));
    now.outcome = StrokeOutcome::missed;
    steps.follow(now);
    EXPECT_THAT(steps.hint(now).text, HasSubstr("missed the model"));
    now.outcome = StrokeOutcome::incised;
    steps.follow(now);
    EXPECT_THAT(steps.hint(now).text, HasSubstr("began or ended on the model"));
    now.outcome = StrokeOutcome::parted;
    now.pieces = 2;
    steps.follow(now);
    EXPECT_THAT(steps.hint(now).text, HasSubstr("2 pieces"));
    EXPECT_THAT(choicesOf(steps.hint(now)), ElementsAre(ActionId::letFall, ActionId::showApart,
                                                        ui::actionOf(ui::ToolKind::grab)));
    now.tool = ui::ToolKind::grab;
    steps.follow(now);
    EXPECT_THAT(steps.hint(now).text, HasSubstr("pull it")) << "a tool that is new";
    now.touching = true;
    steps.follow(now);
    now.touching = false;
    EXPECT_THAT(steps.hint(now).text, HasSubstr("What next")) << "known by now";
    now.tool = ui::ToolKind::stroke;
    now.playing = true;
    now.weightless = false;
    steps.follow(now);
    EXPECT_EQ(steps.hint(now).text, "") << "what falls is watched";
    now.playing = false;
    EXPECT_THAT(choicesOf(steps.hint(now)),
                ElementsAre(ActionId::undo, ActionId::reset, ActionId::help));
    now.tool = ui::ToolKind::grab;
    EXPECT_EQ(steps.hint(now).text, "") << "it would not cut";
    now.tool = ui::ToolKind::stroke;
    now.cutting = true;
    steps.follow(now);
    now.cutting = false;
    now.pieces = 3;
    steps.follow(now);
    EXPECT_EQ(steps.hint(now).text, "") << "who has seen it all is left alone";
    now.tool = ui::ToolKind::guillotine;
    EXPECT_THAT(steps.hint(now).text, HasSubstr("handles")) << "but for what is new";
}

TEST(TearSentence, SaysWhyItTearsOrNot) {
    Params params;
    StepReport report;
    report.tear = TearReport{.opening = 0.41, .stress = 0.2};
    EXPECT_EQ(tearSentence(report, params, true), "") << "off";
    params.tearing = 1;
    EXPECT_THAT(tearSentence(report, params, false), HasSubstr("41 % of what its end needs"));
    EXPECT_EQ(tearSentence(report, params, true), "Tearing at the end of a slit.");
    report.tear->opening = 0;
    EXPECT_THAT(tearSentence(report, params, false), HasSubstr("20 % of its strength"));
    EXPECT_THAT(tearSentence(report, params, true), HasSubstr("exceeds the tensile strength"));
    report.tear->hasSlit = true;
    EXPECT_THAT(tearSentence(report, params, false), HasSubstr("the slit is opened to 0 %"));
    report.tear->failure = "no room";
    EXPECT_EQ(tearSentence(report, params, true), "Can't tear here: no room. Pull another way.");
    params.solver = SolverMode::pbd;
    EXPECT_EQ(tearSentence(report, params, true),
              "Nothing tears with a toughness of 0, the solver pbd or the open cut.");
}

// A file may hold several shells.
TEST(FirstSteps, WhatWasOpenedInPiecesIsNotCutYet) {
    const FirstSteps steps;
    Situation now{.open = true, .weightless = true, .pieces = 2, .piecesAtFirst = 2};
    EXPECT_THAT(steps.hint(now).text, HasSubstr("all the way across"));
    now.pieces = 3;
    EXPECT_THAT(steps.hint(now).text, HasSubstr("Cut into 3 pieces"));
}

TEST(FirstSteps, AnIncisionOfTheScalpelLeadsToTheHand) {
    FirstSteps steps;
    Situation now{.open = true, .cutting = true, .tool = ui::ToolKind::scalpel};
    steps.follow(now);
    now.cutting = false;
    now.outcome = StrokeOutcome::incised;
    steps.follow(now);
    EXPECT_EQ(choicesOf(steps.hint(now)),
              (std::vector{ui::actionOf(ui::ToolKind::retract), ui::actionOf(ui::ToolKind::grab)}));
}

// Not that the blade began or ended inside, which the log does not say.
TEST(FirstSteps, SayOfARefusedStepWhatTheLogSays) {
    FirstSteps steps;
    Situation now{.open = true, .outcome = StrokeOutcome::incised};
    CutResult refused;
    refused.reason = "the blade meets a wall";
    now.refusal = refusalSentence(refused, 92);
    EXPECT_THAT(steps.hint(now).text, HasSubstr(now.refusal));
    now.pieces = 2;
    EXPECT_THAT(steps.hint(now).text, HasSubstr(now.refusal)) << "it parted nothing else either";
    now.outcome = StrokeOutcome::parted;
    EXPECT_THAT(steps.hint(now).text, HasSubstr("Cut into 2 pieces")) << "it did without that step";
}

TEST(FirstSteps, SayWhyNothingMoves) {
    FirstSteps steps;
    Situation now{.open = true, .playing = true, .weightless = true};
    steps.follow(now);
    EXPECT_EQ(choicesOf(steps.hint(now)), std::vector{ActionId::toggleGravity});
    now.weightless = false;
    steps.follow(now);
    now.weightless = true;
    EXPECT_EQ(steps.hint(now).text, "") << "known by now";
}

TEST_F(EditorTest, AStrokeThatEndsInsideIsAnIncisionAndTheHintSaysSo) {
    dragAndSettle(kTop, Vec2(kWidth / 2.0, kHeight / 2.0), 20);
    EXPECT_EQ(editor->title(), "Kerf - ball - 1 piece");
    EXPECT_THAT(panels().help.hint.text, HasSubstr("incision"));
    tap(Key::z, {.control = true});
    settle();
    EXPECT_THAT(panels().help.hint.text, Not(HasSubstr("incision")));
}

TEST_F(EditorTest, TheHintAfterACutLetsThePiecesFall) {
    dragAndSettle(kTop, kBottom, 10);
    frames(2);
    click("hint.Shift+Space");
    EXPECT_TRUE(panels().transport.playing);
    EXPECT_LT(panels().parameters.now.gravity.y(), 0);
}

TEST_F(EditorTest, PiecesAreShownApartUntilABladeComes) {
    dragAndSettle(kTop, kBottom, 10);
    moveTo(kWidth / 2.0, 5);
    settle();
    const std::vector<std::uint8_t> together = viewPixels(editor->readPicture());
    const int steps = panels().transport.step;
    tap(Key::a);
    settle();
    EXPECT_GT(panels().display.apart, 0);
    EXPECT_NE(viewPixels(editor->readPicture()), together);
    EXPECT_EQ(panels().transport.step, steps) << "nothing moved";
    moveTo(kTop.x() + 60, kTop.y());
    press(true);
    settle();
    EXPECT_EQ(panels().display.apart, 0);
    press(false);
    tap(Key::a);
    EXPECT_GT(panels().display.apart, 0);
    tap(Key::space, 2);
    EXPECT_EQ(panels().display.apart, 0);
}

TEST_F(EditorTest, ACoreIsShownApartFromThePieceAroundIt) {
    const auto onLoop = [](int i) {
        const double angle = 0.13 * i;
        return Vec2(kWidth / 2.0 + 60 * std::cos(angle), kHeight / 2.0 + 60 * std::sin(angle));
    };
    moveTo(onLoop(0).x(), onLoop(0).y());
    press(true);
    for (int i = 1; i <= 52; ++i) {
        moveTo(onLoop(i).x(), onLoop(i).y());
    }
    release();
    ASSERT_EQ(panels().pieces.rows.size(), 2U);
    moveTo(kWidth / 2.0, 5);
    settle();
    const std::vector<std::uint8_t> together = viewPixels(editor->readPicture());
    tap(Key::a);
    settle();
    const std::vector<std::uint8_t> apart = viewPixels(editor->readPicture());
    int changed = 0;
    for (std::size_t i = 0; i < apart.size(); i += 4) {
        changed += std::abs(int(apart[i]) - int(together[i])) > 30 ? 1 : 0;
    }
    EXPECT_GT(changed, 2000) << "of the core's 11,000";
}

}  // namespace
}  // namespace kerf::app
