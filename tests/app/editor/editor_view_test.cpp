// The camera, the axes in the corner, what is shown and how.

#include "app/editor/view/body_display.h"

namespace kerf::app {
namespace {

class EditorViewTest : public EditorTest {
  protected:
    Vec3 axis(int i) const { return panels().view.axes.axes[i]; }
};

/// The range of colours and the value under the pointer are those of pictures.
class EditorLegendTest : public EditorViewTest {
  protected:
    EditorOptions options() override {
        EditorOptions options = EditorViewTest::options();
        options.drawsAll = true;
        return options;
    }
};

/// The last row of the picture that shows the ball, between the panels.
int lowestOfBall(const render::Image& picture) {
    int lowest = 0;
    for (std::size_t i = 0; i < picture.pixels.size(); i += 4) {
        const int row = static_cast<int>(i / 4) / picture.width;
        const int column = static_cast<int>(i / 4) % picture.width;
        const bool red = picture.pixels[i] > 120 && picture.pixels[i] > picture.pixels[i + 2] + 80;
        const bool inView = column > kWidth / 3 && column < 2 * kWidth / 3 && row < kHeight - 80;
        lowest = red && inView ? row : lowest;
    }
    return lowest;
}

// One look at what is beside the eye sent the view so far away that nothing was seen.
TEST_F(EditorViewTest, AViewFromBesideABodyMovesAwayUntilItIsSeenAndNoFarther) {
    Session session;
    session.model.builtin = "sphere768";
    session.steps = 1;
    session.view = render::Camera{.eye = {-0.002, 0.1, 0.6}, .target = {0.998, 0.1, 0.6}};
    writeText(folder / "beside.kerf.json", formatSession(session, folder.path()));
    open(folder / "beside.kerf.json");
    moveTo(5, 5);
    settle();
    const render::Image picture = editor->readPicture();
    int red = 0;
    for (std::size_t i = 0; i < picture.pixels.size(); i += 4) {
        red += picture.pixels[i] > 120 && picture.pixels[i] > 2 * picture.pixels[i + 2] ? 1 : 0;
    }
    EXPECT_GT(red, kWidth * kHeight / 100);
}

TEST_F(EditorViewTest, FramingKeepsTheBallAboveTheHint) {
    dragAndSettle(kTop, kBottom, 30);
    tap(Key::f);
    settle(2);
    ASSERT_TRUE(editor->itemRects().contains("hint.A"));
    const float hint = editor->itemRects().at("hint.A").y;
    moveTo(kWidth / 2.0, 12);
    press(true);  // The hint goes.
    frames(2);
    EXPECT_LT(lowestOfBall(editor->readPicture()), hint - 10);
    EXPECT_GT(lowestOfBall(editor->readPicture()), hint - 140) << "it fills the rest";
}

TEST_F(EditorViewTest, TheKeysOfTheAxesLookAlongThem) {
    tap(Key::digit3);
    settle();
    EXPECT_NEAR(axis(0).z(), 1, 1e-3) << "x comes towards the eye";
    tap(Key::digit7);
    settle();
    EXPECT_NEAR(axis(1).z(), 1, 1e-3);
    EXPECT_NEAR(axis(0).x(), 1, 1e-3);
    tap(Key::digit1);
    settle();
    EXPECT_NEAR(axis(2).z(), 1, 1e-3);
}

TEST_F(EditorViewTest, AClickOnAnEndOfTheAxesLooksFromThere) {
    settle();
    click("axes.-X");
    settle();
    EXPECT_NEAR(axis(0).z(), -1, 1e-3);
    EXPECT_EQ(panels().transport.step, 0) << "and cuts nothing";
}

TEST_F(EditorLegendTest, TheStrainUnderThePointerIsThatOfTheSurfaceThere) {
    moveTo(kWidth / 2.0, kHeight / 2.0);
    tap(Key::j, 3);
    ASSERT_EQ(panels().looks.field.field, render::SurfaceField::strain);
    EXPECT_NEAR(panels().looks.field.range.high, 0.01, 1e-6) << "at rest: the least range";
    ASSERT_TRUE(panels().looks.field.underPointer);
    EXPECT_NEAR(*panels().looks.field.underPointer, 0, 1e-5);
    moveTo(kWidth / 2.0, 2, 2);
    EXPECT_FALSE(panels().looks.field.underPointer) << "beside the body";
}

// Each key stroke counted, so that an end could not pass the other one, and 1e999 was taken.
TEST_F(EditorLegendTest, BothEndsOfTheRangeAreTypedInAnyOrder) {
    editor->resize(kWidth, 4 * kHeight);
    tap(Key::j);
    click("section.display");
    click("display.automatic_range");
    const auto typed = [&](double share, const std::string& text) {
        const ui::Rect place = editor->itemRects().at("display.range");
        moveTo(place.x + share * place.width, place.y + place.height / 2);
        press(true);
        press(false, 2);
        type(text);
        tap(Key::enter, 2);
        return panels().looks.field.range;
    };
    typed(0.8, "10");
    EXPECT_FLOAT_EQ(typed(0.2, "10").low, 0.1F);
    EXPECT_EQ(typed(0.8, "20"), (render::FieldRange{0.1F, 0.2F}));
    EXPECT_EQ(typed(0.2, "1e999"), (render::FieldRange{0.1F, 0.2F})) << "refused";
    EXPECT_EQ(typed(0.2, "1e9"), (render::FieldRange{1e4F, 0.2F}));
    EXPECT_EQ(typed(0.2, "0,5"), (render::FieldRange{0.005F, 0.2F}));
}

TEST_F(EditorLegendTest, ABodyThatSqueezesItselfShowsStrainAndItsRangeFollows) {
    tap(Key::j);
    tap(Key::v);
    playFor(60);
    moveTo(kWidth / 2.0, kHeight / 2.0 + 60);
    settle(3);
    EXPECT_GT(panels().looks.field.range.high, 0.01);
    ASSERT_TRUE(panels().looks.field.underPointer);
    EXPECT_GT(*panels().looks.field.underPointer, 1e-4);
}

TEST_F(EditorLegendTest, TheThicknessIsWorkedOutWhileTimeStandsAndSaysWhenItIsOld) {
    for (int i = 0; i < 3; ++i) {
        tap(Key::j);
    }
    moveTo(kWidth / 2.0, kHeight / 2.0 + 10);
    ASSERT_EQ(panels().looks.field.field, render::SurfaceField::thickness);
    for (int i = 0; i < 400 && !(panels().looks.field.note.empty() && i > 2); ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        frames(1);
    }
    frames(3);
    EXPECT_EQ(panels().looks.field.note, "");
    ASSERT_TRUE(panels().looks.field.underPointer);
    EXPECT_NEAR(*panels().looks.field.underPointer, 1, 0.05) << "the diameter";
    tap(Key::v);
    tap(Key::space, 3);
    EXPECT_THAT(panels().looks.field.note, HasSubstr("From step 0."));
}

TEST_F(EditorViewTest, ASectionOpensThePictureAndItsHandleShiftsItAlongItsNormal) {
    settle();
    const auto whole = viewPixels(editor->readPicture());
    tap(Key::n, 2);
    ASSERT_TRUE(panels().display.section);
    EXPECT_EQ(panels().display.section->normal, Vec3::UnitZ()) << "towards the eye";
    EXPECT_NE(viewPixels(editor->readPicture()), whole);
    tap(Key::n, 2);
    EXPECT_EQ(viewPixels(editor->readPicture()), whole);
    tap(Key::n);
    moveTo(2, 2, 2);
    ASSERT_EQ(panels().view.overlay.handles.size(), 2U);
    tap(Key::digit3);  // from the right: the normal lies across the view
    settle();
    const ui::PlotPoint from = panels().view.overlay.handles[0].at;
    drag(Vec2(from.x, from.y), Vec2(from.x - 40, from.y + 25), 4);
    frames(2);
    EXPECT_NE(panels().display.section->point.z(), 0);
    EXPECT_NEAR(panels().view.overlay.handles[0].at.x, from.x - 40, 2);
    EXPECT_NEAR(panels().view.overlay.handles[0].at.y, from.y, 2) << "it stays on its normal";
    EXPECT_EQ(panels().changes.rows.size(), 0U) << "nothing was cut";
}

TEST_F(EditorViewTest, TheTipOfASectionTurnsIt) {
    tap(Key::n);
    tap(Key::digit3);
    moveTo(2, 2);
    settle();
    const ui::PlotPoint middle = panels().view.overlay.handles[0].at;
    drag(Vec2(panels().view.overlay.handles[1].at.x, panels().view.overlay.handles[1].at.y),
         Vec2(middle.x, middle.y - 80), 4);
    frames(2);
    EXPECT_NEAR(panels().display.section->normal.y(), 1, 0.05);
}

TEST_F(EditorLegendTest, UnderThePointerIsWhatASectionShows) {
    tap(Key::j);
    moveTo(kWidth / 2.0, kHeight / 2.0 + 8, 3);
    ASSERT_TRUE(panels().looks.field.underPointer);
    tap(Key::n, 3);
    EXPECT_FALSE(panels().looks.field.underPointer) << "the filled section has no strain";
}

TEST_F(EditorViewTest, TheLookComesBackAfterAllQuantities) {
    settle();
    const auto before = viewPixels(editor->readPicture());
    for (int i = 0; i < render::kSurfaceFields; ++i) {
        tap(Key::j, 2);
        const bool look = panels().display.field.field == render::SurfaceField::look;
        EXPECT_EQ(viewPixels(editor->readPicture()) == before, look) << i;
    }
}

TEST_F(EditorViewTest, AViewFromAboveIsSavedAndReadAgain) {
    tap(Key::digit7);
    tap(Key::digit5);
    saveByKeys();
    const Session session = readSession(onlyFile(folder.path()));
    EXPECT_TRUE(session.view->orthographic);
    EXPECT_NEAR(session.view->towardsEye(Vec3::Zero()).y(), 1, 1e-3);
}

TEST_F(EditorViewTest, AStrokeThatBeginsWhileTheViewFliesIsMadeInTheViewAtItsEnd) {
    tap(Key::digit3, 2);
    ASSERT_EQ(editor->idleSeconds(), 0) << "it still flies";
    moveTo(kTop);
    press(true, 2);
    EXPECT_NEAR(axis(0).z(), 1, 1e-3);
}

TEST_F(EditorViewTest, EachOverlayIsDrawnInItsColourWithALegend) {
    struct Marking {
        Key key;
        render::DisplayColor color;
        int least;
    };
    const std::vector<std::uint8_t> plain = [&] {
        moveTo(5, 5);
        settle();
        return viewPixels(editor->readPicture());
    }();
    for (const Marking& marking :
         {Marking{Key::e, render::kEdgeColor, 1500}, Marking{Key::b, render::kBendColor, 1500},
          Marking{Key::i, render::kIspcColor, 50}, Marking{Key::o, render::kBoxColor, 400}}) {
        tap(marking.key);
        settle();
        const auto shown = viewPixels(editor->readPicture());
        EXPECT_GT(pixelsOf(marking.color, shown), pixelsOf(marking.color, plain) + marking.least)
            << int(marking.color[0]);
        tap(marking.key);
    }
    settle();
    EXPECT_EQ(viewPixels(editor->readPicture()), plain);
}

TEST_F(EditorViewTest, ErrorsAreGreyAtRestAndColouredWhereTheBodyIsPulled) {
    tap(Key::x);
    settle();
    const int long0 = pixelsOf(render::kLongColor, viewPixels(editor->readPicture()));
    tap(Key::d);
    moveTo(kWidth / 2.0, kHeight / 2.0);
    press(true, 1);
    moveTo(kWidth / 2.0 + 150, kHeight / 2.0, 15);
    EXPECT_GT(pixelsOf(render::kLongColor, viewPixels(editor->readPicture())), long0 + 50);
}

TEST_F(EditorViewTest, PinnedVerticesAreMarked) {
    tap(Key::p);
    const Vec2 middle(kWidth / 2.0, kHeight / 2.0);
    drag(middle, middle, 1);
    moveTo(5, 5);
    settle();
    ASSERT_GT(panels().body.pinned, 0U);
    EXPECT_GT(pixelsOf(render::kPinColor, viewPixels(editor->readPicture())),
              8 * static_cast<int>(panels().body.pinned));
}

TEST_F(EditorViewTest, ContactsAreMarkedWhereHalvesTouch) {
    tap(Key::k);
    writeText(folder / "touch.kerf.json", R"({
        "format": "kerf-session", "version": 1, "model": {"builtin": "sphere80"},
        "params": {"gravity": [0, -9.81, 0], "floor": -0.7, "iterations": 4, "contact": 1},
        "steps": 60,
        "events": [{"step": 1, "type": "blade", "a": [-2, 0.1, -1.5], "b": [2, 0.1, -1.5]},
                   {"step": 40, "type": "blade", "a": [-2, 0.1, 1.5], "b": [2, 0.1, 1.5]},
                   {"step": 41, "type": "lift"}]})");
    open(folder / "touch.kerf.json");
    tap(Key::space);
    int most = 0;
    for (int i = 0; i < 70; ++i) {
        frames(1);
        most = std::max(most, pixelsOf(render::kContactColor, viewPixels(editor->readPicture())));
    }
    EXPECT_EQ(editor->title(), "Kerf - touch - 2 pieces");
    EXPECT_GT(most, 40);
}

TEST_F(EditorViewTest, TheFinePictureIsSmootherAndTheChoiceIsKept) {
    moveTo(5, 5);
    settle();
    const auto light = viewPixels(editor->readPicture());
    EXPECT_EQ(panels().display.quality, render::Quality::light);
    tap(Key::q);
    settle();
    EXPECT_EQ(panels().display.quality, render::Quality::full);
    EXPECT_NE(viewPixels(editor->readPicture()), light);
    tap(Key::q);
    settle();
    EXPECT_EQ(viewPixels(editor->readPicture()), light);
}

TEST_F(EditorViewTest, ColoursAndLooksAreKeptInTheSessionAndShownAgain) {
    render::ChosenColors blue;
    blue.skin = Vec3(0.1, 0.2, 0.9);
    render::ChosenColors stone;
    stone.look = render::LookName::marble;
    for (const auto& [colors, mostRed] : {std::pair(blue, 0.5), {stone, 1.3}}) {
        Session before;
        before.model.builtin = "sphere80";
        before.steps = 1;
        before.params.floor = -0.7;
        before.view = render::Camera{.eye = {0, 0.4, 3}};
        before.colors = colors;
        const fs::path file = folder / "dyed.kerf.json";
        writeText(file, formatSession(before, folder.path()));
        open(file);
        moveTo(5, 5);
        settle();
        EXPECT_EQ(panels().display.colors, colors);
        const render::Image picture = editor->readPicture();
        const std::size_t middle = 4 * (std::size_t(kHeight / 2) * kWidth + kWidth / 2);
        EXPECT_LT(picture.pixels[middle], mostRed * picture.pixels[middle + 2]);
        fs::remove(file);
        saveByKeys();
        EXPECT_EQ(readSession(onlyFile(folder.path())).colors, colors);
        fs::remove(onlyFile(folder.path()));
    }
}

TEST_F(EditorViewTest, WhatIsShownApartIsFramedApart) {
    dragAndSettle(kTop, kBottom, 10);
    BodyDisplay display;
    EXPECT_EQ(display.boundsOf({editor->scene(), false}).diagonal(),
              editor->scene()->simulation().bounds().diagonal());
    display.settings.apart = 1;
    EXPECT_GT(display.boundsOf({editor->scene(), false}).diagonal(),
              1.15 * editor->scene()->simulation().bounds().diagonal());
}

TEST_F(EditorViewTest, TheCameraLooksAtTheMiddleOfWhatThePanelsLeaveFree) {
    const auto middleOfBody = [&] {
        double sum = 0;
        double count = 0;
        const render::Image picture = editor->readPicture();
        const int row = picture.height / 2;
        for (int x = 0; x < picture.width; ++x) {
            const auto* pixel = &picture.pixels[4 * (row * picture.width + x)];
            const bool red = pixel[0] > 120 && pixel[0] > 2 * pixel[2];
            sum += red ? x : 0;
            count += red ? 1 : 0;
        }
        return sum / count;
    };
    settle();
    EXPECT_NEAR(middleOfBody(), kWidth / 2.0, 6);
    const ui::Rect edge = editor->itemRects().at("edge.readings");
    dragAndSettle(Vec2(edge.x + 3, 200), Vec2(kWidth - 2.0, 200), 5);
    ASSERT_FALSE(panels().settings.showReadings);
    EXPECT_GT(middleOfBody(), kWidth / 2.0 + 100);
}

TEST_F(EditorViewTest, ALightThemeHasALightScene) {
    const auto corner = [&] {
        settle();
        const std::vector<std::uint8_t> pixels = viewPixels(editor->readPicture());
        return int(pixels[0]);
    };
    EXPECT_LT(corner(), 80);
    for (const std::string section : {"simulation", "tools", "window"}) {
        click("section." + section);  // the first two folded, so that all of the last is seen
    }
    click("window.light");
    EXPECT_GT(corner(), 150);
}

TEST_F(EditorViewTest, ThePointerTellsWhatAClickWouldDo) {
    moveTo(kWidth / 2.0, kHeight / 2.0, 2);
    EXPECT_EQ(editor->cursor(), ui::Cursor::crosshair);
    tap(Key::d, 2);
    EXPECT_EQ(editor->cursor(), ui::Cursor::hand) << "over the body";
    moveTo(kWidth / 2.0 + 130, 30, 2);
    EXPECT_EQ(editor->cursor(), ui::Cursor::arrow) << "beside it";
    const ui::Rect edge = editor->itemRects().at("edge.controls");
    moveTo(edge.x + edge.width / 2, 200, 2);
    EXPECT_EQ(editor->cursor(), ui::Cursor::resizeX);
    const ui::Rect button = editor->itemRects().at("tool.Grab");
    moveTo(button.x + 5, button.y + 5, 2);
    EXPECT_EQ(editor->cursor(), ui::Cursor::arrow);
}

// Gravity alone was taken back, the pieces stayed on the floor, and nothing was said.
TEST_F(EditorViewTest, AnUndoThatMovesNothingSaysWhatComesNext) {
    dragAndSettle(kTop, kBottom, 10);
    tap(Key::space, {.shift = true}, 10);
    tap(Key::space);
    tap(Key::z, {.control = true}, 2);
    EXPECT_THAT(panels().toast.text, HasSubstr("Undone: Gravity"));
    EXPECT_THAT(panels().toast.text, HasSubstr("m/s\u00b2"));
    ASSERT_TRUE(panels().toast.choice.has_value());
    EXPECT_THAT(panels().toast.choice->label, HasSubstr("Cut 1"));
    click("toast.Ctrl+Z");
    EXPECT_EQ(editor->title(), "Kerf - ball - 1 piece");
    EXPECT_THAT(panels().toast.text, HasSubstr("Undone: Cut 1"));
    tap(Key::z, {.shift = true, .control = true}, 2);
    EXPECT_THAT(panels().toast.text, HasSubstr("Redone: Cut 1"));
}

}  // namespace
}  // namespace kerf::app
