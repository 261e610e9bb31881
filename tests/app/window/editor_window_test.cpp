// The editor in a real window under a virtual display, driven by synthetic mouse and keys, beside
// the same editor without one.

namespace kerf::app {
namespace {

bool hasCommand(const std::string& name) {
    return std::system(("command -v " + name + " > /dev/null 2>&1").c_str()) == 0;
}

/// "name: value" lines.
std::map<std::string, std::string> valuesIn(const std::string& text) {
    std::map<std::string, std::string> values;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::size_t colon = text.find(": ", begin);
        if (colon < end) {
            values[text.substr(begin, colon - begin)] = text.substr(colon + 2, end - colon - 2);
        }
        begin = end + 1;
    }
    return values;
}

/// What a person does, for xdotool as for the input queue.
class Acts {
  public:
    void moveTo(const Vec2& at) {
        shell_ += "xdotool mousemove " + std::to_string(int(at.x())) + " " +
                  std::to_string(int(at.y())) + "\n";
        events_.emplace_back(ui::PointerMove{std::floor(at.x()), std::floor(at.y()), {}});
    }
    void press(bool down) {
        shell_ += std::string("xdotool ") + (down ? "mousedown" : "mouseup") + " 1\n";
        events_.emplace_back(ui::ButtonChange{ui::Button::left, down, {}});
    }
    void drag(const Vec2& from, const Vec2& to, int points) {
        moveTo(from);
        press(true);
        for (int i = 1; i <= points; ++i) {
            moveTo(from + (to - from) * i / points);
        }
        press(false);
    }
    void tap(const std::string& name, ui::Key key, const ui::Modifiers& modifiers = {}) {
        shell_ += "xdotool key " + name + "\n";
        events_.emplace_back(ui::KeyChange{key, true, modifiers});
        events_.emplace_back(ui::KeyChange{key, false, modifiers});
    }
    /// Until the window says so; the editor without one is done at once.
    void see(const std::string& name, const std::string& titleEnd) {
        shell_ += "see " + name + " '" + titleEnd + "'\n";
    }
    void seeFile(const std::string& name, const std::string& pattern) {
        shell_ += "seeFile " + name + " '" + pattern + "'\n";
    }
    /// Until all that moves has come to rest.
    void rest() { shell_ += "rest\n"; }
    /// Until a message is no longer shown.
    void waitForMessage() {
        shell_ += "sleep " + std::to_string(kMessageSeconds) + "\n";
        events_.emplace_back(std::nullopt);
    }

    const std::string& shell() const { return shell_; }
    /// Does it without a window.
    void feed(Editor& editor) const {
        for (const std::optional<ui::InputEvent>& event : events_) {
            if (event) {
                editor.post(*event);
                settle(editor);
            } else {
                elapse(editor, kMessageSeconds);
            }
        }
    }
    static void settle(Editor& editor) {
        for (int i = 0; i < 2000 && (editor.idleSeconds() == 0 || editor.working()); ++i) {
            editor.frame(1.0 / 60);
            if (editor.working()) {
                std::this_thread::sleep_for(std::chrono::milliseconds(5));
            }
        }
    }

  private:
    static constexpr int kMessageSeconds = 6;

    static void elapse(Editor& editor, int seconds) {
        for (int i = 0; i < 60 * seconds; ++i) {
            editor.frame(1.0 / 60);
        }
    }

    std::string shell_;
    std::vector<std::optional<ui::InputEvent>> events_;  ///< none: time passes
};

/// Cuts from top to bottom through the middle, changes a parameter, takes both back and brings them
/// back again.
void addStroke(Acts& acts, const ui::ItemRects& rects, int width, int height) {
    acts.drag(Vec2(width / 2.0, 40), Vec2(width / 2.0, height - 60.0), 16);
    acts.see("cut", "- 2 pieces");
    acts.rest();
    const ui::Rect slider = rects.at("param.iterations");
    const double y = slider.y + slider.height / 2;
    acts.drag(Vec2(slider.x + 0.4 * slider.width, y), Vec2(slider.x + 0.7 * slider.width, y), 5);
    acts.tap("ctrl+z", ui::Key::z, {.control = true});
    acts.tap("ctrl+z", ui::Key::z, {.control = true});
    acts.see("undone", "- 1 piece");
    acts.tap("ctrl+shift+z", ui::Key::z, {.shift = true, .control = true});
    acts.see("redone", "- 2 pieces");
    acts.tap("ctrl+y", ui::Key::y, {.control = true});
}

/// Cuts into the surface, left of the middle. In one move: what lies under the pointer on its way
/// depends on how far the blade has come by then.
void addScalpel(Acts& acts, int width, int height) {
    const Vec2 middle(width / 2.0, height / 2.0);
    acts.tap("s", ui::Key::s);
    acts.drag(middle + Vec2(-110, 0), middle + Vec2(-30, 30), 1);
    acts.rest();
}

/// Where the guillotine is got hold of.
struct GuillotinePlaces {
    std::vector<Vec2> handles;  ///< middle, ends, bottom [px]
    ui::Rect slider;

    static GuillotinePlaces in(Editor& editor) {
        tap(editor, ui::Key::g);
        GuillotinePlaces places{{}, editor.itemRects().at("blade.lowered")};
        for (const ui::Overlay::Handle& handle : editor.panels().view.overlay.handles) {
            places.handles.emplace_back(handle.at.x, handle.at.y);
        }
        tap(editor, ui::Key::c);
        return places;
    }

  private:
    static void tap(Editor& editor, ui::Key key) {
        editor.post(ui::KeyChange{key, true, {}});
        editor.post(ui::KeyChange{key, false, {}});
        Acts::settle(editor);
    }
};

/// Turns the guillotine by one of its ends and brings it down by its key; moves it aside by its
/// middle and brings it down by its slider, in one move: a slider sees where the pointer is at a
/// picture, not how it came there.
void addGuillotine(Acts& acts, const GuillotinePlaces& places) {
    acts.tap("g", ui::Key::g);
    acts.drag(places.handles[1], places.handles[1] + Vec2(20, 30), 3);
    acts.tap("Return", ui::Key::enter);
    acts.see("dropped", "- 4 pieces");
    acts.rest();
    acts.drag(places.handles[0], places.handles[0] + Vec2(60, 0), 3);
    const ui::Rect& slider = places.slider;
    const double y = slider.y + slider.height / 2;
    acts.drag(Vec2(slider.x + 0.05 * slider.width, y), Vec2(slider.x + 0.99 * slider.width, y), 1);
    acts.see("lowered", "- 5 pieces");
    acts.rest();
    acts.tap("c", ui::Key::c);
}

/// Takes a picture and saves a session.
void addSaving(Acts& acts, int width) {
    acts.moveTo(Vec2(width / 2.0, 60));
    acts.rest();
    acts.waitForMessage();
    acts.tap("F12", ui::Key::f12);
    acts.seeFile("picture", "kerf-*.png");
    acts.tap("ctrl+s", ui::Key::s, {.control = true});
    acts.rest();
    acts.tap("Return", ui::Key::enter);
    acts.seeFile("session", "*.kerf.json");
}

/// The one file with this ending.
fs::path fileEnding(const fs::path& folder, const std::string& ending) {
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (entry.path().string().ends_with(ending)) {
            return entry.path();
        }
    }
    ADD_FAILURE() << "no file *" << ending << " in " << folder;
    return {};
}

bool isLift(const SessionEvent& event) {
    return std::holds_alternative<LiftBlade>(event.action);
}

class EditorWindow : public GlTest {
  protected:
    void SetUp() override {
        GlTest::SetUp();
        if (!hasCommand("xvfb-run") || !hasCommand("xdotool")) {
            GTEST_SKIP() << "needs xvfb-run and xdotool (Debian packages xvfb and xdotool)";
        }
    }
    /// What a script says that drives the editor under a virtual display.
    std::string runInWindow(const std::string& script, const std::string& display = "",
                            const std::string& words = "") const {
        return outputOf("xvfb-run -a -s '-screen 0 1280x720x24" + display + "' bash " +
                        KERF_SOURCE_DIR "/tests/app/window/" + script +
                        " " KERF_BINARY_DIR "/kerf " + folder.path().string() + words + " 2>&1");
    }

    const test::TemporaryFolder folder;
};

class EditorWindowTest : public EditorWindow {
  protected:
    static constexpr int kPictureWidth = 1280;
    static constexpr int kPictureHeight = 720;

    EditorOptions options() const {
        EditorOptions options;
        options.width = kPictureWidth;
        options.height = kPictureHeight;
        options.quality = render::Quality::light;
        options.byTheClock = false;
        options.screenshotFolder = headless.path();
        return options;
    }
    /// What the window and its driver say.
    std::map<std::string, std::string> drive(const Acts& acts) {
        writeText(folder / "acts.sh", acts.shell());
        seen = runInWindow("editor_window.sh", "", " " + (folder / "acts.sh").string());
        return valuesIn(seen);
    }

    test::TemporaryFolder headless;
    std::string seen;
};

TEST_F(EditorWindowTest, APersonsWayThroughItEndsAsTheSameEventsDoWithoutAWindow) {
    Editor editor(options(), openDocument(gpu::dataPath("assets/sessions/drop-in.kerf.json")));
    Acts::settle(editor);
    Acts acts;
    addStroke(acts, editor.itemRects(), kPictureWidth, kPictureHeight);
    addScalpel(acts, kPictureWidth, kPictureHeight);
    addGuillotine(acts, GuillotinePlaces::in(editor));
    addSaving(acts, kPictureWidth);

    std::map<std::string, std::string> values = drive(acts);
    SCOPED_TRACE(seen + readBytes(folder / "errors.txt"));
    EXPECT_EQ(values["opened"], "Kerf - drop-in - 1 piece");
    EXPECT_EQ(values["cut"], "Kerf - drop-in - 2 pieces");
    EXPECT_EQ(values["undone"], "Kerf - drop-in - 1 piece");
    EXPECT_EQ(values["redone"], "Kerf - drop-in - 2 pieces");
    EXPECT_EQ(values["dropped"], "Kerf - drop-in - 4 pieces");
    EXPECT_EQ(values["lowered"], "Kerf - drop-in - 5 pieces");
    EXPECT_THAT(values["picture"], ::testing::MatchesRegex("kerf-[0-9]{8}-[0-9]{6}\\.png"));
    EXPECT_EQ(values["exit"], "0");

    acts.feed(editor);
    EXPECT_EQ(editor.title(), "Kerf - drop-in-cut - 5 pieces") << "as it was saved";
    const render::Image shown = render::readPng(fileEnding(folder.path(), ".png"));
    EXPECT_EQ(shown.width, kPictureWidth);
    EXPECT_EQ(shown.height, kPictureHeight);
    const render::Image drawn = render::readPng(fileEnding(headless.path(), ".png"));
    EXPECT_TRUE(viewPixels(shown) == viewPixels(drawn)) << "but for the panels, which show times";

    const Session session = readSession(fileEnding(folder.path(), ".kerf.json"));
    const Session same = readSession(fileEnding(headless.path(), ".kerf.json"));
    EXPECT_EQ(lastCheck(session).hash, lastCheck(same).hash);
    EXPECT_EQ(std::ranges::count_if(session.events, isLift), 4)
        << "of the stroke, the scalpel and both ways of the guillotine";
    expectReplayed(session, loadSessionModel(session));
}

TEST_F(EditorWindow, AModelIsOpenedByTheDialogExportedAndALoadingCancelled) {
    writeText(folder / "ball.obj", objText(icosphereSoup(2)));
    writeText(folder / "slow.obj", objText(icosphereSoup(1)));
    const std::string seen = runInWindow("editor_window_files.sh");
    SCOPED_TRACE(seen + readBytes(folder / "errors.txt"));
    std::map<std::string, std::string> values = valuesIn(seen);
    EXPECT_EQ(values["opened"], "Kerf - ball - 1 piece");
    EXPECT_EQ(values["exported"], "whole.obj");
    EXPECT_EQ(values["loading"], "Kerf - ball - 1 piece") << "what is open stays";
    EXPECT_EQ(values["cancelled"], "Kerf - ball - 1 piece");
    EXPECT_EQ(values["exit"], "0");
    MeshReport report;
    loadModel(folder / "whole.obj", &report);
    EXPECT_EQ(report.triangles, 320);
}

// It had ended with a sentence in the terminal, which nobody sees who clicked on a file.
TEST_F(EditorWindow, ABadModelOfTheCommandLineIsToldInTheWindow) {
    TriangleSoup soup = icosphereSoup(1);
    soup.triangles.pop_back();
    writeText(folder / "bad.obj", objText(soup));
    const std::string seen = runInWindow("editor_window_bad_model.sh");
    const std::string errors = readBytes(folder / "errors.txt");
    SCOPED_TRACE(seen + errors);
    std::map<std::string, std::string> values = valuesIn(seen);
    EXPECT_EQ(values["opened"], "Kerf");
    EXPECT_EQ(values["exit"], "0");
    EXPECT_THAT(errors, HasSubstr("bad.obj"));
}

TEST_F(EditorWindow, ResetsOfTheDriverThatFollowEachOtherFastEndIt) {
    writeText(folder / "ball.obj", objText(icosphereSoup(1)));
    const std::string seen = runInWindow("editor_window_resets.sh");
    SCOPED_TRACE(seen + readBytes(folder / "errors.txt"));
    std::map<std::string, std::string> values = valuesIn(seen);
    EXPECT_EQ(values["exit"], "4") << "and no window after the other for ever";
    EXPECT_EQ(values["recent"], (folder / "ball.obj").string()) << "for Open recent";
}

/// What a virtual display keeps in a file: X11's XWDFile.h, 32 bits a pixel, blue first.
render::Image readDisplay(const fs::path& file) {
    const std::string bytes = readBytes(file);
    const auto number = [&](std::size_t index) {  // of the header; the largest byte first
        std::uint32_t sum = 0;
        for (std::size_t i = 4 * index; i < 4 * index + 4; ++i) {
            sum = sum << 8 | static_cast<std::uint8_t>(bytes.at(i));
        }
        return sum;
    };
    constexpr std::size_t kHeaderSize = 0, kWidth = 4, kHeight = 5, kBitsPerPixel = 11, kRow = 12;
    constexpr std::size_t kColors = 19, kBytesPerColor = 12;
    EXPECT_EQ(number(kBitsPerPixel), 32u);
    render::Image image{static_cast<int>(number(kWidth)), static_cast<int>(number(kHeight)), {}};
    const std::size_t first = number(kHeaderSize) + number(kColors) * kBytesPerColor;
    for (std::size_t y = 0; y < number(kHeight); ++y) {
        for (std::size_t x = 0; x < number(kWidth); ++x) {
            const std::string_view pixel(&bytes.at(first + y * number(kRow) + 4 * x), 4);
            for (const char channel : {pixel[2], pixel[1], pixel[0], '\xff'}) {
                image.pixels.push_back(static_cast<std::uint8_t>(channel));
            }
        }
    }
    return image;
}

/// The upper left part.
render::Image partOf(const render::Image& image, int width, int height) {
    render::Image part{width, height, {}};
    for (int y = 0; y < std::min(height, image.height); ++y) {
        const auto row = image.pixels.begin() + std::ptrdiff_t(4) * y * image.width;
        part.pixels.insert(part.pixels.end(), row, row + std::ptrdiff_t(4) * width);
    }
    return part;
}

// A software driver went on with the size that the window had had at first.
TEST_F(EditorWindow, OfAnotherSizeTheDisplayShowsWhatWasDrawn) {
    const std::string seen =
        runInWindow("editor_window_sizes.sh", " -fbdir " + folder.path().string());
    SCOPED_TRACE(seen + readBytes(folder / "errors.txt"));
    EXPECT_EQ(valuesIn(seen)["exit"], "0");
    for (const char* name : {"smaller", "larger"}) {
        const render::Image drawn = render::readPng(folder / (std::string(name) + ".png"));
        const render::Image shown =
            partOf(readDisplay(folder / (std::string(name) + ".xwd")), drawn.width, drawn.height);
        // A message fades between the two, and a clock goes on.
        EXPECT_LT(render::channelDifference(drawn, shown).pixels, 0.02 * drawn.width * drawn.height)
            << name;
    }
}

TEST(EditorWithoutAWindow, WithoutADisplayItSaysSoAndExits4) {
    const ProgramRun run = runKerf({}, {{"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}});
    expectEnd(run, 4, "No window can be opened");
    EXPECT_EQ(run.out, "");
}

TEST(EditorWithoutAWindow, WithoutOpenGlItExits4) {
    EXPECT_EQ(runKerf({}, {{"KERF_FORCE_NO_GL", "1"}}).exitCode, 4);
}

TEST(EditorWithoutAWindow, AFileThatIsMissingIsExitCode3) {
    const ProgramRun run = runKerf({"no-such-model.obj"});
    expectEnd(run, 3, "no-such-model.obj");
}

}  // namespace
}  // namespace kerf::app
