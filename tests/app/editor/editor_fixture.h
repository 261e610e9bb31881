// The whole editor without a window: events in, pictures out.
#pragma once

#include <gmock/gmock.h>

#include <chrono>
#include <thread>

#include "app/editor/editor.h"
#include "sim/mesh/invariants.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/shapes.h"
#include "tests/support/temporary_folder.h"
#include "ui/base/layout.h"

namespace kerf::app {
using ui::Button;
using ui::Key;

inline constexpr int kWidth = 960;
inline constexpr int kHeight = 580;
inline constexpr double kFrameSeconds = 1.0 / 60;

/// A sphere in the middle of the view, weightless and paused.
inline Document sphereDocument() {
    Document document{.name = "ball",
                      .session = {},
                      .mesh = test::cubeSphere(8, 0.5),
                      .restBounds = {},
                      .camera = {},
                      .looks = {},
                      .note = {}};
    document.session.model.builtin = "sphere768";
    document.session.params.gravity = Vec3::Zero();
    document.session.params.floor = -0.6;
    document.session.params.iterations = 4;
    document.restBounds = meshBounds(document.mesh);
    document.camera.eye = Vec3(0, 0.4, 3);
    document.camera.target = Vec3::Zero();
    return document;
}

/// Of an editor whose pictures and time don't depend on the machine.
inline EditorOptions plainOptions() {
    EditorOptions options;
    options.width = kWidth;
    options.height = kHeight;
    options.quality = render::Quality::light;
    options.byTheClock = false;
    options.drawsAll = false;
    options.slowStep = std::numeric_limits<double>::infinity();
    options.link = "0";  // a free port
    return options;
}

class EditorTest : public test::GlTest {
  protected:
    void SetUp() override {
        GlTest::SetUp();
        start(options(), document());
    }
    void TearDown() override {
        editor.reset();
        GlTest::TearDown();
    }

    /// plainOptions(), with pictures into a folder of the test.
    virtual EditorOptions options() {
        EditorOptions options = plainOptions();
        options.screenshotFolder = folder.path();
        return options;
    }
    virtual Document document() { return sphereDocument(); }
    void start(const EditorOptions& options, Document document = sphereDocument()) {
        editor.reset();
        editor = std::make_unique<Editor>(options, std::move(document));
        frames(2);
    }
    /// Has one picture made.
    virtual void frame() { editor->frame(kFrameSeconds); }
    void frames(int count) {
        for (int i = 0; i < count; ++i) {
            frame();
        }
    }
    /// Frames until nothing moves any more; here and below, `more` frames follow.
    void settle(int more = 0) {
        for (int i = 0; i < 400 && editor->idleSeconds() == 0; ++i) {
            frame();
        }
        frames(more);
    }
    void moveTo(double x, double y, int more = 0) {
        editor->post(ui::PointerMove{x, y, {}});
        frames(more);
    }
    void moveTo(const Vec2& to, int more = 0) { moveTo(to.x(), to.y(), more); }
    void press(bool down, Button button = Button::left) {
        editor->post(ui::ButtonChange{button, down, {}});
    }
    void press(bool down, int more) {
        press(down);
        frames(more);
    }
    void release() {
        press(false);
        settle();
    }
    /// Frames until no file is on its way in or out any more, a minute at most.
    void waitForWork(int more = 0) {
        frame();
        for (int i = 0; i < 12000 && editor->working(); ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
            frame();
        }
        ASSERT_FALSE(editor->working());
        frames(1 + more);
    }
    /// Frames as long as `waits` says so, every 5 ms, so many at most.
    template <class Condition>
    void waitWhile(const Condition& waits, int most = 2000) {
        for (int i = 0; i < most && waits(); ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
            frames(1);
        }
    }
    void open(const std::filesystem::path& file, int more = 0) {
        editor->open(file);
        waitForWork(more);
    }
    /// Opens a session and goes back to its start.
    void openAtStart(const std::filesystem::path& file) {
        open(file);
        settle();
        tap(Key::r);
    }
    void tap(Key key, const ui::Modifiers& modifiers = {}, int more = 0) {
        editor->post(ui::KeyChange{key, true, modifiers});
        editor->post(ui::KeyChange{key, false, {}});
        frames(1 + more);
    }
    void tap(Key key, int more) { tap(key, {}, more); }
    /// By Enter, and waits for what that begins.
    void confirm(int more = 0) {
        tap(Key::enter);
        waitForWork(more);
    }
    void undo() {
        editor->post(ui::KeyChange{Key::z, true, {.control = true}});
        settle();
    }
    /// So many frames of time that runs.
    void playFor(int count) {
        tap(Key::space, count);
        tap(Key::space);
    }
    /// Saves a session under the name that is proposed.
    void saveByKeys() {
        tap(Key::s, {.control = true}, 2);
        confirm();
    }
    /// Starts or stops a recording and saves nothing.
    void toggleRecording() {
        tap(Key::r, {.control = true});
        frames(1);
        if (!panels().question.text.empty()) {
            click("question.1");
        } else if (panels().files.purpose != ui::FilePurpose::none) {
            tap(Key::escape);
        }
        settle();
    }
    void type(const std::string& text, int more = 0) {
        for (const char letter : text) {
            editor->post(ui::Character{static_cast<std::uint32_t>(letter)});
        }
        frames(2 + more);
    }
    /// Presses and releases the left button over a named item.
    void click(const std::string& item, int more = 0) {
        ASSERT_TRUE(editor->itemRects().contains(item)) << item;
        const ui::Rect place = editor->itemRects().at(item);
        moveTo(place.x + place.width / 2, place.y + place.height / 2);
        press(true);
        press(false);
        frames(2 + more);
    }
    void enter(const std::string& text) {
        type(text);
        confirm();
    }
    void clickAndWait(const std::string& item) {
        click(item);
        waitForWork();
    }
    /// All events at once, as a hand faster than the frames would send them.
    void drag(const Vec2& from, const Vec2& to, int points, Button button = Button::left) {
        moveTo(from.x(), from.y());
        press(true, button);
        for (int i = 1; i <= points; ++i) {
            const Vec2 p = from + (to - from) * i / points;
            moveTo(p.x(), p.y());
        }
        press(false, button);
    }
    void dragAndSettle(const Vec2& from, const Vec2& to, int points, Button button = Button::left) {
        drag(from, to, points, button);
        settle();
    }
    /// Nearly all the way to the right.
    void dragSlider(const std::string& item) {
        const ui::Rect place = editor->itemRects().at(item);
        const double y = place.y + place.height / 2;
        dragAndSettle(Vec2(place.x + 0.3 * place.width, y), Vec2(place.x + 0.9 * place.width, y),
                      5);
    }
    const ui::PanelModel& panels() const { return editor->panels(); }

    test::TemporaryFolder folder;
    std::unique_ptr<Editor> editor;
};

/// What the panels leave free: they show measured times.
inline std::vector<std::uint8_t> viewPixels(const render::Image& image) {
    const ui::Rect view =
        ui::layoutPanels(float(image.width), float(image.height), 1, {}, true).view;
    std::vector<std::uint8_t> pixels;
    for (int y = 0; y < static_cast<int>(view.height); ++y) {
        const auto row = image.pixels.begin() + 4 * ((y + int(view.y)) * image.width + int(view.x));
        pixels.insert(pixels.end(), row, row + 4 * static_cast<int>(view.width));
    }
    return pixels;
}

inline const Vec2 kTop(kWidth / 2.0, 20);
inline const Vec2 kBottom(kWidth / 2.0, kHeight - 40.0);

/// The one file in it.
inline std::filesystem::path onlyFile(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        files.push_back(entry.path());
    }
    EXPECT_EQ(files.size(), 1U);
    return files.empty() ? "" : files[0];
}

}  // namespace kerf::app
