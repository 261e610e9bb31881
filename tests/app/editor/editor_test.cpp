#include "app/editor/editor.h"

namespace kerf::app {
namespace {

/// A session of one stroke, over 40 of its 60 steps.
fs::path writeLongStroke(const fs::path& folder) {
    writeText(folder / "slice.kerf.json", sliceSession(""));
    return folder / "slice.kerf.json";
}

TEST_F(EditorTest, CancellingTellsHowManyCutsInTheQueueWereDropped) {
    for (int i = 0; i < 3; ++i) {
        drag(kTop + Vec2(20 * i, 0), kBottom + Vec2(20 * i, 0), 10);
    }
    frames(4);
    tap(Key::escape);
    EXPECT_EQ(panels().toast.text, "Cancelled. 2 more cuts in the queue were dropped.");
    settle();
    EXPECT_EQ(editor->scene()->stroke().pending(), 0U);
}

TEST_F(EditorTest, OpensPausedAndSaysWhatToDoFirst) {
    EXPECT_EQ(editor->title(), "Kerf - ball - 1 piece");
    EXPECT_FALSE(panels().transport.playing);
    EXPECT_EQ(panels().transport.step, 0);
    EXPECT_THAT(panels().help.hint.text, HasSubstr("Drag"));
}

TEST_F(EditorTest, AStrokeFromTopToBottomCutsTheSphereInTwo) {
    for (const auto& [orthographic, moves] : {std::pair(false, 30), {false, 1}, {true, 30}}) {
        SCOPED_TRACE(moves);
        start(options());
        if (orthographic) {
            tap(Key::digit5);
            settle();
        }
        EXPECT_EQ(panels().view.orthographic, orthographic);
        dragAndSettle(kTop, kBottom, moves);
        EXPECT_EQ(editor->title(), "Kerf - ball - 2 pieces");
        ASSERT_EQ(panels().pieces.rows.size(), 2U);
        EXPECT_NEAR(panels().pieces.rows[0].share, 1, 0.02);
        EXPECT_FALSE(panels().transport.playing) << "a paused stroke leaves time paused";
        EXPECT_GT(panels().transport.step, 0) << "but its poses ran steps";
        ASSERT_EQ(panels().plots.history->marks.size(), 1U);
    }
}

TEST_F(EditorTest, ASecondStrokeWaitsForTheFirst) {
    drag(kTop, kBottom, 3);
    drag(Vec2(kWidth / 3.0, kHeight / 2.0), Vec2(kWidth / 1.5, kHeight / 2.0), 3);
    frames(1);
    EXPECT_TRUE(panels().transport.stroking);
    settle();
    EXPECT_EQ(editor->title(), "Kerf - ball - 4 pieces");
}

TEST_F(EditorTest, EscapeStopsTheStroke) {
    moveTo(kTop);
    press(true);
    moveTo(kBottom, 2);
    tap(Key::escape);
    release();
    EXPECT_EQ(editor->title(), "Kerf - ball - 1 piece");
    EXPECT_FALSE(panels().transport.stroking);
}

TEST_F(EditorTest, ASliderDragChangesItsParameterAndAResetKeepsIt) {
    const double before = panels().parameters.now.timeStep;
    dragSlider("param.time_step");
    const double chosen = panels().parameters.now.timeStep;
    EXPECT_GT(chosen, before);
    EXPECT_EQ(panels().body.triangles, 768) << "the drag over the panel is no stroke";
    tap(Key::r, 1);
    EXPECT_EQ(panels().parameters.now.timeStep, chosen);
}

TEST_F(EditorTest, ASwitchLeavesTheIterationsToTheProgramAndTheSliderTakesThemBack) {
    click("auto.iterations");
    EXPECT_EQ(panels().parameters.now.iterations, kAutoIterations);
    tap(Key::period, 1);
    const int chosen = panels().parameters.iterations;
    EXPECT_LT(chosen, 20);
    click("auto.iterations");
    EXPECT_EQ(panels().parameters.now.iterations, chosen) << "goes on with what was chosen";
    click("auto.iterations");
    dragSlider("param.iterations");
    EXPECT_GT(panels().parameters.now.iterations, chosen);
}

TEST_F(EditorTest, SpacePlaysAndPausesAndTheDotSteps) {
    tap(Key::space, 5);
    EXPECT_TRUE(panels().transport.playing);
    EXPECT_GT(panels().transport.step, 3);
    tap(Key::space, 2);
    const int paused = panels().transport.step;
    frames(3);
    EXPECT_EQ(panels().transport.step, paused);
    tap(Key::period, 1);
    EXPECT_EQ(panels().transport.step, paused + 1);
    EXPECT_FALSE((*panels().plots.history)[ui::Reading::volumePercent].empty());
}

TEST_F(EditorTest, ResetJoinsThePiecesAgain) {
    dragAndSettle(kTop, kBottom, 10);
    tap(Key::r);
    settle();
    EXPECT_EQ(editor->title(), "Kerf - ball - 1 piece");
    EXPECT_EQ(panels().transport.time, 0);
    EXPECT_TRUE(panels().transport.restarted);
    EXPECT_EQ(panels().transport.step, panels().session.playback.step) << "as the time line says";
    EXPECT_EQ(panels().body.triangles, 768);
    EXPECT_TRUE((*panels().plots.history)[ui::Reading::volumePercent].empty());
}

TEST_F(EditorTest, ACutIsUndoneAndRedoneByKeys) {
    dragAndSettle(kTop, kBottom, 10);
    ASSERT_EQ(panels().changes.rows.size(), 1U);
    EXPECT_EQ(panels().changes.rows[0].name, "Cut 1");
    EXPECT_GT(panels().changes.bytes, 0U);
    const auto tapControl = [&](Key key, bool shift) {
        editor->post(ui::KeyChange{key, true, {.shift = shift, .control = true}});
        editor->post(ui::KeyChange{key, false, {.shift = shift, .control = true}});
        settle();
    };
    tapControl(Key::z, false);
    EXPECT_EQ(editor->title(), "Kerf - ball - 1 piece");
    EXPECT_EQ(panels().pieces.rows.size(), 1U);
    EXPECT_EQ(panels().changes.done, 0U);
    tapControl(Key::z, true);
    EXPECT_EQ(editor->title(), "Kerf - ball - 2 pieces");
    tapControl(Key::z, true);
    EXPECT_THAT(panels().toast.text, HasSubstr("nothing to redo"));
    tap(Key::r);
    settle();
    EXPECT_EQ(editor->title(), "Kerf - ball - 1 piece");
    tapControl(Key::z, false);
    EXPECT_EQ(editor->title(), "Kerf - ball - 2 pieces") << "a restart is taken back too";
}

TEST_F(EditorTest, UndoInTheMiddleOfAStrokeEndsIt) {
    moveTo(kTop);
    press(true);
    moveTo(kBottom.x(), kBottom.y() - 200);
    settle();
    EXPECT_GT(panels().body.triangles, 768);
    editor->post(ui::KeyChange{Key::z, true, {.control = true}});
    moveTo(kBottom);
    release();
    EXPECT_EQ(panels().body.triangles, 768);
    EXPECT_FALSE(panels().transport.stroking);
}

TEST_F(EditorTest, ABodyThatTurnsInsideOutSaysSoOnce) {
    EditorScene& scene = *editor->scene();
    for (const auto& [name, value] : {std::pair("ispc_stiffness", 0.0),
                                      {"youngs_modulus", 1e3},
                                      {"contact", 0.0},
                                      {"floor", -3.0}}) {
        ASSERT_EQ(scene.execute(SetParam{name, value}), "");
    }
    ASSERT_EQ(scene.execute(Grab{1, {0, 0.45, 0}, 0.4}), "");
    ASSERT_EQ(scene.execute(Grab{2, {0, -0.45, 0}, 0.4}), "");
    std::vector<std::string> told;
    for (int step = 0; step < 16; ++step) {
        const double top = 0.45 - 0.08 * step;
        scene.execute(Drag{1, {0, top, 0}});
        scene.execute(Drag{2, {0, -top, 0}});
        scene.step();
        std::ranges::move(scene.takeMessages(), std::back_inserter(told));
    }
    ASSERT_EQ(told.size(), 1U);
    EXPECT_THAT(told[0], HasSubstr("the body turned inside out"));
}

// A recording starts the body anew and had set again whatever a person had ever chosen.
TEST_F(EditorTest, AParameterThatWasTakenBackStaysSoInARecording) {
    const double before = panels().parameters.now.timeStep;
    const auto tapControl = [&](Key key, bool shift) {
        editor->post(ui::KeyChange{key, true, {.shift = shift, .control = true}});
        settle();
    };
    dragSlider("param.time_step");
    const double chosen = panels().parameters.now.timeStep;
    ASSERT_NE(chosen, before);
    tapControl(Key::z, false);
    EXPECT_THAT(panels().toast.text, HasSubstr("Undone: Time step"));
    toggleRecording();
    EXPECT_EQ(panels().parameters.now.timeStep, before);
    toggleRecording();
    dragSlider("param.time_step");
    tapControl(Key::z, false);
    tapControl(Key::z, true);
    EXPECT_THAT(panels().toast.text, HasSubstr("Redone: Time step"));
    const double again = panels().parameters.now.timeStep;
    ASSERT_NE(again, before);
    toggleRecording();
    EXPECT_EQ(panels().parameters.now.timeStep, again) << "what was brought back is chosen";
}

// What the blade has swept is cut where it is put away, and then there is nothing to redo.
TEST_F(EditorTest, ARedoThatEndsAStrokeClaimsNothing) {
    dragSlider("param.time_step");
    undo();
    moveTo(kWidth / 2.0, kHeight / 2.0);
    press(true);
    moveTo(kWidth / 2.0, kHeight / 2.0 + 7);
    settle();
    ASSERT_EQ(panels().changes.done, 0U);
    ASSERT_EQ(panels().changes.rows.size(), 1U) << "the stroke has cut nothing yet";
    editor->post(ui::KeyChange{Key::z, true, {.shift = true, .control = true}});
    settle();
    ASSERT_EQ(panels().changes.done, 1U);
    EXPECT_EQ(panels().changes.rows[0].name, "Cut 1");
    EXPECT_THAT(panels().toast.text, HasSubstr("nothing to redo"));
}

TEST_F(EditorTest, ABoxIsAddedMovedAndRemovedByThePanelAndIsInTheSession) {
    const auto click = [&](const std::string& item) {
        const ui::Rect place = editor->itemRects().at(item);
        moveTo(place.x + std::min(10.F, place.width / 2), place.y + place.height / 2, 1);
        press(true, 1);
        release();
    };
    for (const char* row : {"tab.Boxes", "boxes.add", "box.0"}) {
        click(row);
    }
    ASSERT_EQ(panels().body.boxes.size(), 1U);
    EXPECT_NEAR(panels().body.boxes[0].center.y() - panels().body.boxes[0].size.y() / 2, -0.6,
                1e-12);
    const StaticBox before = panels().body.boxes[0];
    const ui::Rect row = editor->itemRects().at("box.0.Centre");
    const double y = row.y + row.height / 2;
    dragAndSettle(Vec2(row.x + 10, y), Vec2(row.x + 60, y), 5);
    EXPECT_GT(panels().body.boxes[0].center.x(), before.center.x());
    EXPECT_EQ(panels().body.boxes[0].size, before.size);
    EXPECT_EQ(panels().changes.rows.size(), 2U) << "a drag is one change";
    undo();
    EXPECT_EQ(panels().body.boxes[0], before);
    toggleRecording();
    EXPECT_EQ(panels().body.boxes, std::vector<StaticBox>{before}) << "a recording keeps them";
    click("box.0.remove");
    EXPECT_TRUE(panels().body.boxes.empty());
}

TEST_F(EditorTest, SpeedDoublesAndHalves) {
    tap(Key::equal);
    tap(Key::space);
    const int before = panels().transport.step;
    frames(4);
    EXPECT_EQ(panels().transport.speed, 2);
    EXPECT_EQ(panels().transport.step - before, 8);
    for (int i = 0; i < 6; ++i) {
        tap(Key::minus);
    }
    EXPECT_EQ(panels().transport.speed, 0.25);
}

TEST_F(EditorTest, WhatWasDoneIsSavedAsASessionThatReplaysToTheSameBits) {
    const auto control = [&](Key key) {
        editor->post(ui::KeyChange{key, true, {.control = true}});
        frames(1);
    };
    control(Key::r);
    settle();
    EXPECT_TRUE(panels().transport.recording);
    tap(Key::v);
    dragAndSettle(kTop, kBottom, 6);
    dragSlider("param.ispc_stiffness");
    tap(Key::space, 8);
    drag(Vec2(kWidth / 3.0, kHeight / 2.0), Vec2(kWidth / 1.5, kHeight / 2.0), 3);
    frames(20);
    control(Key::z);
    frames(4);
    control(Key::y);
    tap(Key::space);
    settle();
    const int steps = panels().transport.step;
    control(Key::r);
    frames(2);
    confirm();
    settle();
    waitForWork();
    EXPECT_FALSE(panels().transport.recording);
    const Session session = readSession(onlyFile(folder.path()));
    EXPECT_EQ(session.steps, steps);
    expectReplayed(session, sphereDocument().mesh);
    EXPECT_GE(*lastCheck(session).pieces, 2);
    EXPECT_TRUE(undoesAnything(session));
}

TEST_F(EditorTest, APlayedSessionCanBeScrubbedAndTellsWhereItDiverged) {
    writeText(folder / "slice.kerf.json", sliceSession(kLift + R"(,
        {"step": 45, "type": "check", "pieces": 2},
        {"step": 50, "type": "check", "hash": "0123456789abcdef"})"));
    openAtStart(folder / "slice.kerf.json");
    settle();
    const auto scrubTo = [&](double share) {
        const ui::Rect bar = editor->itemRects().at("scrubber");
        dragAndSettle(Vec2(bar.x + 3, bar.y + bar.height / 2),
                      Vec2(bar.x + share * bar.width, bar.y + bar.height / 2), 1);
    };
    scrubTo(0.98);
    EXPECT_GT(panels().session.playback.step, 55);
    EXPECT_EQ(editor->title(), "Kerf - slice - 2 pieces");
    EXPECT_EQ(panels().session.playback.divergedAt, 50);
    scrubTo(0.2);
    EXPECT_LT(panels().session.playback.step, 20);
    EXPECT_EQ(editor->title(), "Kerf - slice - 1 piece");
    tap(Key::l);
    tap(Key::space, 62);
    EXPECT_TRUE(panels().transport.playing) << "it goes round";
    EXPECT_LT(panels().session.playback.step, 60);
}

TEST_F(EditorTest, TheScalpelMakesAnIncision) {
    for (const bool orthographic : {false, true}) {
        start(options());
        if (orthographic) {
            tap(Key::digit5);
        }
        tap(Key::s);
        const Vec2 middle(kWidth / 2.0, kHeight / 2.0);
        dragAndSettle(middle - Vec2(60, 0), middle + Vec2(60, 0), 12);
        EXPECT_EQ(editor->title(), "Kerf - ball - 1 piece");
        EXPECT_GT(panels().body.triangles, 768) << orthographic;
        ASSERT_EQ(panels().changes.rows.size(), 1U);
    }
}

TEST_F(EditorTest, TheGuillotineComesDownByAKeyAndByItsSlider) {
    tap(Key::g, 1);
    EXPECT_EQ(panels().view.overlay.handles.size(), 4U);
    EXPECT_TRUE(panels().view.overlay.touched.empty()) << "on request alone";
    tap(Key::w, {.shift = true}, 1);
    EXPECT_FALSE(panels().view.overlay.touched.empty()) << "what it will touch is shown before";
    EXPECT_FALSE(panels().view.overlay.wound.empty());
    tap(Key::enter);
    settle();
    EXPECT_EQ(editor->title(), "Kerf - ball - 2 pieces");
    tap(Key::r);
    tap(Key::g, 1);
    const ui::Rect slider = editor->itemRects().at("blade.lowered");
    const double y = slider.y + slider.height / 2;
    dragAndSettle(Vec2(slider.x + 4, y), Vec2(slider.x + slider.width - 1, y), 4);
    EXPECT_EQ(editor->title(), "Kerf - ball - 2 pieces");
}

TEST_F(EditorTest, AGuillotineHandleCanBeDragged) {
    for (const bool orthographic : {false, true}) {
        start(options());
        if (orthographic) {
            tap(Key::digit5);
        }
        tap(Key::g);
        moveTo(kWidth / 2.0, kHeight / 2.0, 2);
        ASSERT_EQ(panels().view.overlay.handles.size(), 4U);
        const ui::PlotPoint before = panels().view.overlay.handles[0].at;
        drag(Vec2(before.x, before.y), Vec2(before.x + 40, before.y + 30), 3);
        frames(2);
        ASSERT_EQ(panels().view.overlay.handles.size(), 4U);
        EXPECT_NEAR(panels().view.overlay.handles[0].at.x, before.x + 40, 0.5);
        EXPECT_NEAR(panels().view.overlay.handles[0].at.y, before.y + 30, 0.5);
        EXPECT_EQ(panels().transport.step, 0) << "posing cuts nothing";
    }
}

TEST_F(EditorTest, AShallowStrokeLeavesOnePiece) {
    const ui::Rect box = editor->itemRects().at("blade.through");
    dragAndSettle(Vec2(box.x + 8, box.y + box.height / 2), Vec2(box.x + 8, box.y + box.height / 2),
                  1);
    EXPECT_FALSE(panels().tools.stroke.throughAll);
    dragAndSettle(kTop, kBottom, 10);
    EXPECT_EQ(editor->title(), "Kerf - ball - 1 piece");
    EXPECT_GT(panels().body.triangles, 768);
}

TEST_F(EditorTest, TheRightButtonTurnsTheViewAndCutsNothing) {
    const render::Image before = editor->readPicture();
    dragAndSettle(kTop, kTop + Vec2(200, 50), 5, Button::right);
    EXPECT_GT(render::channelDifference(before, editor->readPicture()).pixels, 1000);
    EXPECT_EQ(panels().transport.step, 0);
    tap(Key::home);
    moveTo(0, 0);
    settle();
}

TEST_F(EditorTest, PausedAndUntouchedItRests) {
    settle();
    editor->resize(kWidth, kHeight);
    EXPECT_GT(editor->idleSeconds(), 1);
    editor->resize(kWidth + 10, kHeight);
    EXPECT_EQ(editor->idleSeconds(), 0);
    settle();
    EXPECT_EQ(editor->readPicture().width, kWidth + 10);
    EXPECT_GT(editor->idleSeconds(), 1);
    moveTo(kWidth / 2.0, kHeight / 2.0);
    EXPECT_EQ(editor->idleSeconds(), 0);
}

TEST_F(EditorTest, F12SavesThePictureAndSaysWhere) {
    moveTo(kWidth / 2.0, 5);
    settle();
    const render::Image shown = editor->readPicture();
    tap(Key::f12);
    waitForWork();
    const fs::path file = onlyFile(folder.path());
    const std::string name = file.filename().string();
    EXPECT_THAT(name, ::testing::MatchesRegex("kerf-[0-9]{8}-[0-9]{6}\\.png"));
    EXPECT_EQ(render::channelDifference(shown, render::readPng(file)).pixels, 0);
    frames(1);
    EXPECT_THAT(panels().toast.text, HasSubstr(name));
}

TEST_F(EditorTest, ControlF12SavesTheSceneAloneOnNoGround) {
    for (const bool fine : {false, true}) {
        if (fine) {
            tap(Key::q);
        }
        tap(Key::f12, {.control = true});
        waitForWork();
        const fs::path file = onlyFile(folder.path());
        EXPECT_THAT(file.filename().string(), StartsWith("kerf-scene-"));
        const render::Image picture = render::readPng(file);
        ASSERT_EQ(picture.width, kWidth);
        const auto alphaAt = [&](int x, int y) {
            return int{picture.pixels[4 * (y * kWidth + x) + 3]};
        };
        EXPECT_EQ(alphaAt(kWidth / 2, kHeight / 2), 255) << "the ball";
        EXPECT_EQ(alphaAt(2, 2), 0);
        EXPECT_EQ(alphaAt(kWidth / 2, kHeight - 3), 0) << "no floor";
        fs::remove(file);
    }
}

TEST_F(EditorTest, PicturesOfOneSecondAreFilesOfTheirOwn) {
    for (int i = 0; i < 3; ++i) {
        tap(Key::f12);
    }
    waitForWork();
    const fs::directory_iterator files(folder.path());
    EXPECT_EQ(std::distance(begin(files), end(files)), 3);
}

TEST_F(EditorTest, APictureThatCannotBeWrittenIsSaid) {
    fs::remove_all(folder.path());
    tap(Key::f12);
    waitForWork();
    EXPECT_TRUE(panels().toast.isError);
    EXPECT_THAT(panels().toast.text, HasSubstr("could not be written"));
}

TEST_F(EditorTest, UndoInMidStrokeEndsTheStroke) {
    tap(Key::g);
    const ui::Rect slider = editor->itemRects().at("blade.lowered");
    const double y = slider.y + slider.height / 2;
    dragAndSettle(Vec2(slider.x + 4, y), Vec2(slider.x + slider.width / 2, y), 4);
    EXPECT_GT(panels().tools.guillotine.lowered, 0.3);
    undo();
    EXPECT_EQ(panels().tools.guillotine.lowered, 0) << "the guillotine is above the body again";
    EXPECT_EQ(panels().changes.done, 0U);
}

// What the stroke had noted before was taken for the next one's.
TEST_F(EditorTest, ARecordingBegunInMidStrokeCanUndoItsFirstCut) {
    moveTo(kTop);
    press(true);
    for (int i = 1; i <= 6; ++i) {
        moveTo(kTop.x(), kTop.y() + i * (kBottom.y() - kTop.y()) / 12, 2);
    }
    frames(6);
    ASSERT_EQ(panels().changes.rows.size(), 1U) << "the blade is in the body";
    press(false);
    toggleRecording();
    dragAndSettle(kTop, kBottom, 8);
    EXPECT_EQ(editor->title(), "Kerf - ball - 2 pieces");
    undo();
    EXPECT_EQ(editor->title(), "Kerf - ball - 1 piece");
}

TEST_F(EditorTest, WhatCannotBeOpenedLeavesTheSceneAsItWas) {
    dragAndSettle(kTop, kBottom, 10);
    writeText(folder / "broken.kerf.json", "{\"format\": \"kerf-session\"");
    editor->post(ui::FileDrop{{folder / "broken.kerf.json"}});
    frames(3);
    clickAndWait("question.1");
    EXPECT_TRUE(panels().toast.isError);
    EXPECT_THAT(panels().toast.text, HasSubstr("broken.kerf.json"));
    EXPECT_EQ(editor->title(), "Kerf - ball - 2 pieces");
    editor->post(ui::FileDrop{{folder / "missing.obj"}});
    frames(3);
    clickAndWait("question.1");
    EXPECT_THAT(panels().toast.text, HasSubstr("missing.obj"));
}

TEST_F(EditorTest, ADroppedSessionOpensAtItsEndAndPlaysFromItsStart) {
    writeText(folder / "slice.kerf.json", sliceSession(kLift));
    editor->post(ui::FileDrop{{folder / "slice.kerf.json"}});
    waitForWork();
    settle();
    EXPECT_EQ(editor->title(), "Kerf - slice - 2 pieces");
    EXPECT_EQ(panels().session.playback.step, 60);
    tap(Key::r);
    EXPECT_EQ(editor->title(), "Kerf - slice - 1 piece");
    EXPECT_THAT(panels().help.hint.text, HasSubstr("play the session"));
    tap(Key::space, 3);
    EXPECT_EQ(panels().session.playback.steps, 60);
    frames(45);
    EXPECT_EQ(editor->title(), "Kerf - slice - 2 pieces");
}

TEST_F(EditorTest, UndoOfAParameterDuringAPlayedStrokeLeavesTheStroke) {
    openAtStart(writeLongStroke(folder.path()));
    playFor(10);
    Simulation& simulation = editor->scene()->simulation();
    ASSERT_TRUE(simulation.blade());
    const ParamValue before = getParam(simulation.params(), "iterations");
    ASSERT_EQ(editor->scene()->execute(SetParam{"iterations", 9.0}), "");
    tap(Key::z, {.control = true});
    EXPECT_EQ(getParam(simulation.params(), "iterations"), before);
    EXPECT_TRUE(simulation.blade());
    EXPECT_EQ(panels().session.playback.steps, 60);
    tap(Key::space, 60);
    EXPECT_EQ(editor->title(), "Kerf - slice - 2 pieces");
    EXPECT_EQ(panels().session.playback.step, 60);
}

}  // namespace
}  // namespace kerf::app
