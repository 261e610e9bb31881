// Whatever a person does in the editor, in any order: what must hold holds after each act.
#include "tests/app/editor/editor_storm.h"

#include "sim/run/undo/undo_history.h"
#include "tests/support/session_validator.h"

namespace kerf::app {
namespace {

constexpr unsigned kFirstSeed = 20261120;
constexpr int kActs = 30;

// KERF_STORMS, KERF_STORM_ACTS: more of them. KERF_STORM_SEED: others (KERF_STORMS=1 repeats one).
// KERF_STORM_TRACE: tells each act. KERF_STORM_KEEP: where the last storm is kept as a session.

/// What is promised of the body, of undo and of the session after a storm.
class EditorStormTest : public EditorStorm {
  protected:
    /// All back, all forth: the same bits each time; all back again.
    void expectUndoIsExact() {
        const std::string before = simulation().stateHash();
        const auto all = [&](const Command& command, bool (UndoHistory::*possible)() const) {
            while ((simulation().history().*possible)()) {
                ASSERT_EQ(editor->scene()->execute(command), "");
            }
        };
        const std::size_t done = simulation().history().done();
        const bool fromTheStart = done > 0 && beginsWithTheFirstRestart();
        all(Undo{}, &UndoHistory::canUndo);
        const std::string first = simulation().stateHash();
        if (fromTheStart) {
            EXPECT_EQ(first, startHash_) << changes();
        }
        expectSound();
        while (simulation().history().done() < done) {
            ASSERT_EQ(editor->scene()->execute(Redo{}), "");
        }
        EXPECT_EQ(simulation().stateHash(), before);
        all(Undo{}, &UndoHistory::canUndo);
        EXPECT_EQ(simulation().stateHash(), first);
    }
    /// What is done or undone, in a line.
    std::string changes() {
        std::string names;
        for (const UndoEntry& entry : simulation().history().entries()) {
            names += entry.name + "; ";
        }
        return names;
    }
    /// The history begins with the first restart of the storm.
    bool beginsWithTheFirstRestart() {
        const UndoHistory& history = simulation().history();
        return !restarted_ && history.forgotten() == 0 && !history.entries().empty() &&
               history.entries().front().time == 0 && history.entries().front().name == "Restart";
    }

    /// A session that is played is saved whole, with what was changed.
    void playToTheEnd() {
        goToTheEnd();
        editor->scene()->timeline().playing = false;
    }

    void expectItReplays() {
        playToTheEnd();
        if (simulation().stepCount() == 0) {
            editor->scene()->step();  // a session has one at least
        }
        const Document& document = editor->scene()->document();
        const Session recorded = editor->scene()
                                     ->recorder()
                                     .savedSession(document.camera, document.session.colors)
                                     .session;
        writeText(folder / "storm.kerf.json", formatSession(recorded, folder.path()));
        if (const char* kept = std::getenv("KERF_STORM_KEEP")) {
            fs::copy_file(folder / "storm.kerf.json", kept, fs::copy_options::overwrite_existing);
        }
        if (hasSchemaValidator()) {
            const std::string text = readBytes(folder / "storm.kerf.json");
            EXPECT_EQ(placesWrongBySchema({text})[0], std::vector<std::string>{});
        }
        const Session session = readSession(folder / "storm.kerf.json");
        EXPECT_EQ(replayedHash(session, {document.mesh, document.looks}), simulation().stateHash());
    }

    void storm(unsigned seed, int acts) {
        SCOPED_TRACE("KERF_STORMS=1 KERF_STORM_SEED=" + std::to_string(seed));
        random_.seed(seed);
        startHash_ = simulation().stateHash();
        const EditorScene* const started = editor->scene();
        tap(Key::r);
        const bool traced = std::getenv("KERF_STORM_TRACE") != nullptr;
        for (int i = 0; i < acts; ++i) {
            const Act act = actFor(panels());
            SCOPED_TRACE("act " + std::to_string(i) + ": " + act.name);
            if (traced) {
                std::cerr << i << " " << act.name << ", step " << panels().transport.step << ", "
                          << editor->title() << ", " << panels().toast.text << "\n";
            }
            (this->*act.act)();
            frames(2);
            restarted_ |= panels().transport.recording || editor->scene() != started;
            expectSound();
            if (HasFatalFailure()) {
                return;
            }
        }
        calmDown();
        expectSound();
        expectUndoIsExact();
        expectItReplays();
    }

    std::string startHash_;
    bool restarted_ = false;  ///< from another start than the first one
};

TEST_F(EditorStormTest, WhateverIsDoneLeavesTheBodySoundUndoExactAndTheSessionTrue) {
    const auto first = static_cast<unsigned>(environmentNumber("KERF_STORM_SEED", kFirstSeed));
    const auto acts = static_cast<int>(environmentNumber("KERF_STORM_ACTS", kActs));
    std::cout << "first seed " << first << "\n";
    writeFiles();
    const auto storms = static_cast<unsigned>(runs("KERF_STORMS", 2, 12));
    for (unsigned i = 0; i < storms; ++i) {
        if (i > 0) {
            TearDown();
            SetUp();
            restarted_ = false;
            width_ = kWidth;
            height_ = kHeight;
        }
        storm(first + i, acts);
        if (HasFailure()) {
            return;
        }
    }
}

TEST_F(EditorStormTest, AnySizeOfTheWindowAndAnyScaleIsDrawn) {
    for (const auto& [width, height] : kSizes) {
        for (const float scale : {0.5F, 1.0F, 4.0F}) {
            SCOPED_TRACE(std::to_string(width) + " x " + std::to_string(height) + " at " +
                         std::to_string(scale));
            editor->resize(width, height);
            editor->setScale(scale);
            frames(1);
            for (const Key dialog : {Key::o, Key::e}) {
                tap(dialog, {.control = true});
                frames(1);
                tap(Key::escape);
            }
            tap(Key::f1);
            tap(Key::f1);
            expectSound();
        }
    }
}

}  // namespace
}  // namespace kerf::app
