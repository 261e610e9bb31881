// A saved session opens where it was left off.

#include "sim/run/undo/undo_history.h"

namespace kerf::app {
namespace {

class EditorReopenTest : public EditorTest {
  protected:
    EditorOptions options() override { return optionsOf("a driver"); }
    EditorOptions optionsOf(const std::string& driver) {
        EditorOptions options = EditorTest::options();
        options.storedEnds = folder / "ends";
        options.driver = driver;
        return options;
    }
    EditorScene& scene() { return *editor->scene(); }
    std::string hash() { return scene().simulation().stateHash(); }
    bool canUndo() { return scene().simulation().history().canUndo(); }

    /// Cuts a model, lets it fall, and saves a session. Returns its file.
    fs::path saveHalves() {
        fs::create_directory(folder / "models");
        writeText(folder / "models/ball.kerf.json", R"({
            "format": "kerf-session", "version": 1, "model": {"builtin": "sphere80"},
            "placement": {"scale": 0.5},
            "params": {"gravity": [0, 0, 0], "floor": -0.6, "iterations": 4}, "steps": 10})");
        open(folder / "models/ball.kerf.json");
        dragAndSettle(kTop, kBottom, 10);
        tap(Key::space, {.shift = true}, 25);
        tap(Key::space);
        settle();
        saveByKeys();
        return folder / "models/ball.kerf.json";
    }
    fs::path writeLongSession() {
        writeText(folder / "long.kerf.json", R"({
            "format": "kerf-session", "version": 1, "model": {"builtin": "sphere20"},
            "params": {"gravity": [0, 0, 0], "floor": null, "iterations": 1}, "steps": 5000,
            "events": [{"step": 2000, "type": "set", "name": "iterations", "value": 2}]})");
        return folder / "long.kerf.json";
    }
    void reopen(const fs::path& file, const std::string& driver = "a driver") {
        start(optionsOf(driver));
        open(file);
        settle(1);
    }
    fs::path storedEnd() { return fs::directory_iterator(folder / "ends")->path(); }
    void expectAt(int step, const std::string& state) {
        EXPECT_EQ(panels().session.playback.step, step);
        EXPECT_EQ(hash(), state);
        EXPECT_FALSE(panels().transport.playing);
        EXPECT_THAT(editor->title(), HasSubstr("2 pieces"));
    }
};

TEST_F(EditorReopenTest, FromItsStoredEndWithoutAStep) {
    const auto file = saveHalves();
    const std::string then = hash();
    const int step = panels().session.playback.step;
    reopen(file);
    expectAt(step, then);
    EXPECT_FALSE(canUndo()) << "nothing was played";
    EXPECT_TRUE(panels().changes.recallable);
}

TEST_F(EditorReopenTest, HiddenAndColouredPiecesStaySo) {
    const fs::path file = saveHalves();
    click("eye.1");
    saveByKeys();
    std::string text = readBytes(file);  // as a person would colour it
    const std::string hidden = R"("hidden":true)";
    ASSERT_NE(text.find(hidden), std::string::npos);
    text.replace(text.find(hidden), hidden.size(), hidden + R"(,"color":[0,0.5,1])");
    writeText(file, text);
    reopen(file);
    frames(1);
    ASSERT_EQ(panels().pieces.rows.size(), 2U);
    EXPECT_FALSE(panels().pieces.rows[0].hidden);
    EXPECT_TRUE(panels().pieces.rows[1].hidden);
    EXPECT_EQ(panels().pieces.rows[1].color, Vec3(0, 0.5, 1));
    saveByKeys();
    EXPECT_EQ(readSession(file).editor->pieces[1].color, Vec3(0, 0.5, 1));
}

TEST_F(EditorReopenTest, ByPlayingWhereNoEndIsStored) {
    const auto file = saveHalves();
    const std::string then = hash();
    const int step = panels().session.playback.step;
    reopen(file, "another driver");
    expectAt(step, then);
    EXPECT_TRUE(canUndo());
    EXPECT_FALSE(panels().changes.recallable);
}

TEST_F(EditorReopenTest, ByPlayingWhereTheStoredEndIsCutOffOrAByteOfItHasChanged) {
    const auto file = saveHalves();
    const std::string then = hash();
    const int step = panels().session.playback.step;
    const std::string stored = readBytes(storedEnd());
    std::vector<std::string> damaged;
    for (const std::size_t kept : {std::size_t{10}, stored.size() / 2, stored.size() - 30}) {
        damaged.push_back(stored.substr(0, kept));
    }
    for (const std::size_t at : {stored.size() / 5, stored.size() / 2, stored.size() - 9}) {
        std::string& changed = damaged.emplace_back(stored);
        changed[at] = static_cast<char>(changed[at] ^ 0x40);
    }
    for (std::size_t i = 0; i < damaged.size(); ++i) {
        writeText(storedEnd(), damaged[i]);
        reopen(file);
        expectAt(step, then);
        EXPECT_TRUE(canUndo()) << i;
    }
}

TEST_F(EditorReopenTest, ASessionThatWasEditedIsPlayed) {
    const auto file = saveHalves();
    const int step = panels().session.playback.step;
    std::ofstream(file, std::ios::app) << "\n";
    reopen(file);
    EXPECT_EQ(panels().session.playback.step, step);
    EXPECT_TRUE(canUndo());
}

TEST_F(EditorReopenTest, UndoPlaysItFirst) {
    const auto file = saveHalves();
    const auto undoAll = [&] {
        std::vector<std::string> states;
        for (int i = 0; i < 3; ++i) {
            tap(Key::z, {.control = true});
            settle(2);
            states.push_back(hash());
        }
        return states;
    };
    const std::vector<std::string> before = undoAll();
    reopen(file);
    EXPECT_EQ(undoAll(), before);
    EXPECT_FALSE(panels().changes.recallable);
    EXPECT_EQ(editor->title().find("2 pieces"), std::string::npos);
}

TEST_F(EditorReopenTest, TheTimeLineGoesToItsStartAndBack) {
    const auto file = saveHalves();
    const std::string then = hash();
    const int step = panels().session.playback.step;
    reopen(file);
    const ui::Rect bar = editor->itemRects().at("scrubber");
    moveTo(bar.x + bar.width / 2, bar.y + bar.height / 2, 1);
    const auto goBy = [&](Key key, const ui::Modifiers& modifiers = {}) {
        tap(key, modifiers);
        settle(1);
        return panels().session.playback.step;
    };
    EXPECT_EQ(goBy(Key::home), 0);
    EXPECT_THAT(editor->title(), HasSubstr("1 piece"));
    EXPECT_EQ(goBy(Key::right), 1);
    EXPECT_EQ(goBy(Key::right, {.shift = true}), 11);
    EXPECT_EQ(goBy(Key::left), 10);
    EXPECT_EQ(goBy(Key::end), step);
    EXPECT_EQ(hash(), then);
    moveTo(kWidth / 2.0, kHeight / 2.0);
    EXPECT_EQ(goBy(Key::home), step) << "elsewhere it turns the view";
}

TEST_F(EditorReopenTest, WhatIsDoneThenReplays) {
    const auto file = saveHalves();
    const auto expectItReplays = [&] {
        const Document& document = scene().document();
        const Session session =
            scene().recorder().savedSession(document.camera, document.session.colors).session;
        writeText(folder / "models/on.kerf.json", formatSession(session, folder.path()));
        EXPECT_EQ(replayedHash(readSession(folder / "models/on.kerf.json"),
                               {document.mesh, document.looks}),
                  hash());
    };
    reopen(file);
    const int end = panels().session.playback.steps;
    playFor(10);
    settle();
    EXPECT_GE(panels().session.playback.steps, end + 10) << "it goes on in time";
    expectItReplays();
    dragAndSettle(kTop + Vec2(40, 0), kBottom + Vec2(-40, 0), 8);
    EXPECT_THAT(editor->title(), Not(HasSubstr("2 pieces")));
    expectItReplays();
}

TEST_F(EditorReopenTest, ALongSessionTellsHowFarItIsAndCanBeCancelled) {
    editor->open(writeLongSession());
    for (int i = 0; i < 4000 && panels().session.playback.step < 1000; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        frame();
    }
    EXPECT_TRUE(panels().transport.seeking);
    EXPECT_THAT(panels().work.title, HasSubstr("going to step 5000"));
    tap(Key::z, {.control = true});
    EXPECT_LT(panels().session.playback.step, 5000);
    click("work.cancel");
    settle();
    EXPECT_FALSE(panels().transport.seeking);
    EXPECT_LT(panels().session.playback.step, 5000);
    EXPECT_EQ(panels().session.playback.steps, 5000) << "nothing was lost";
    scene().seek(5000);
    frame();
    ASSERT_TRUE(panels().transport.seeking);
    tap(Key::escape);
    settle();
    EXPECT_LT(panels().session.playback.step, 5000) << "Esc stops it, too";
}

// The view stayed black, or showed what was open before, until the end was reached.
TEST_F(EditorReopenTest, TheBodyIsSeenWhileItsSessionIsPlayedToTheEnd) {
    EditorOptions byTheClock = options();
    byTheClock.byTheClock = true;
    editor.reset();
    editor = std::make_unique<Editor>(byTheClock, std::nullopt);
    editor->open(writeLongSession());
    for (int i = 0; i < 4000 && !(panels().transport.seeking && panels().name == "long"); ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        frame();
    }
    ASSERT_TRUE(panels().transport.seeking);
    frames(3);
    ASSERT_TRUE(panels().transport.seeking);
    const render::Image picture = editor->readPicture();
    const std::size_t middle = 4 * (std::size_t(kHeight / 2) * kWidth + kWidth / 2);
    EXPECT_GT(picture.pixels[middle], 2 * picture.pixels[middle + 2]) << "red";
    click("work.cancel");
    settle();
}

}  // namespace
}  // namespace kerf::app
