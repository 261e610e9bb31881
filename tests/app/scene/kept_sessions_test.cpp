// A session that is opened in the editor and saved again: nothing gets lost on the way.

#include "app/regression/expectation.h"
#include "app/regression/test_session.h"
#include "gpu/context.h"

namespace kerf::app {
namespace {

constexpr unsigned kFirstSeed = 20261122;
constexpr int kFewTriangles = 400;

// KERF_KEPT_SEED: the first seed of random sessions. KERF_KEPT_RUNS: how many.

/// The sessions in some folders of the source.
std::vector<fs::path> sessionsIn(const std::vector<std::string>& folders) {
    std::vector<fs::path> paths;
    paths.reserve(folders.size());
    for (const std::string& folder : folders) {
        paths.push_back(fs::path(KERF_SOURCE_DIR) / folder);
    }
    return findSessions(paths);
}

std::vector<fs::path> shippedSessions() {
    return sessionsIn({"assets/sessions", "tests/sessions"});
}

/// An editor without a window, with a session open.
class OpenedSession {
  public:
    explicit OpenedSession(const fs::path& file) : OpenedSession(openDocument(file)) {}
    explicit OpenedSession(Document document)
        : uploaded_(prepareDocument(std::move(document))),
          scene_(std::move(uploaded_.document), std::move(uploaded_.body)) {}

    EditorScene& operator*() { return scene_; }
    EditorScene* operator->() { return &scene_; }

    void run(int steps) {
        for (int i = 0; i < steps; ++i) {
            scene_.step();
        }
    }
    void goTo(int step) {
        scene_.seek(step);
        while (scene_.timeline().seekSteps() > 0) {
            scene_.step();
        }
    }
    SavedSession saved() {
        render::Camera elsewhere;
        elsewhere.eye = Vec3(7, 8, 9);
        return scene_.recorder().savedSession(elsewhere, scene_.document().session.colors);
    }
    std::string text() { return formatSession(saved().session, "/"); }
    /// As its file says.
    std::string openedText() { return formatSession(scene_.document().session, "/"); }
    std::string stateHash() { return scene_.simulation().stateHash(); }
    /// What a replay of the saved session says.
    RunSummary replay() {
        const test::TemporaryFolder folder;
        writeText(folder / "saved.kerf.json", formatSession(saved().session, folder.path()));
        const Session session = readSession(folder / "saved.kerf.json");
        ReplayOptions options;
        options.keepGoing = true;
        return replaySession(session, loadSessionModel(session), folder / "out", {}, options)
            .summary;
    }

  private:
    UploadedDocument uploaded_;
    EditorScene scene_;
};

/// A session of a small sphere that a die made: strokes, pulls, settings, boxes, pins, undo.
class RandomSession {
  public:
    explicit RandomSession(unsigned seed) : random_(seed) {
        session_.model.builtin = "sphere80";
        session_.params.gravity = oneIn(2) ? Vec3(0, -9.81, 0) : Vec3::Zero();
        session_.params.floor = -0.6;
        session_.params.iterations = 2;
        session_.steps = 60;
        session_.view = render::Camera{};
        session_.view->eye = Vec3(0, 1, 4);
        for (step_ = below(4); step_ < session_.steps; step_ += 1 + below(6)) {
            addSome();
        }
        std::ranges::stable_sort(session_.events, {}, &SessionEvent::step);
    }
    Session session() const { return session_; }

    int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }
    bool oneIn(int count) { return below(count) == 0; }
    double share() { return std::uniform_real_distribution<double>(0, 1)(random_); }

    /// Something that a person may change while it is played.
    Command change() {
        switch (below(4)) {
            case 0:
                return SetParam{"ispc_stiffness", share()};
            case 1:
                return SetParam{"gravity", Vec3(0, -10 * share(), 0)};
            case 2:
                return AddBox{{Vec3(2 * share() - 1, -0.4, 0), Vec3::Constant(0.2), Vec3::Zero()}};
            default:
                return Pin{Ball{Vec3(0, 0.5, 0), 0.3}};
        }
    }

  private:
    void addSome() {
        switch (below(8)) {
            case 0:
                stroke();
                return;
            case 1:
                pull();
                return;
            case 2:
                add(SetParam{"friction", share()});
                changed_ = true;
                return;
            case 3:
                add(ScreenshotEvent{"p" + std::to_string(step_) + ".png", 64, 36});
                return;
            case 4:
                add(ExportEvent{"e" + std::to_string(step_) + ".obj", oneIn(2), std::nullopt});
                return;
            case 5:
                add(CheckEvent{std::nullopt, 1});
                return;
            case 6:
                takeBack();
                return;
            default:
                add(AddBox{{Vec3(share() - 0.5, -0.5, 0), Vec3::Constant(0.1), Vec3::Zero()}});
                changed_ = true;
        }
    }
    /// Down through the sphere, and the blade is lifted or not.
    void stroke() {
        const double x = share() - 0.5;
        const double turn = 0.2 * share();
        const auto pose = [&](double y) {
            return MoveBlade{{Vec3(x, y, -0.8), Vec3(x + turn, y + turn, 0.8)}};
        };
        add(pose(0.7));
        add(pose(0.7 - 1.5 * share()), 3 + below(12));
        if (!oneIn(4)) {
            add(LiftBlade{}, 1);
        }
    }
    void pull() {
        const Vec3 at(0, 0, 0.5);
        add(Grab{1, at, changed_ ? 10 : 0.4});  // an earlier hand may have flung it away
        changed_ = true;
        add(Drag{1, at + Vec3(share() - 0.5, share(), 0.3)}, 2 + below(8));
        if (oneIn(2)) {
            add(Release{1}, 1);
        }
    }
    void takeBack() {
        if (changed_) {
            add(Undo{});
            add(oneIn(2) ? SessionAction(Redo{}) : SessionAction(Restart{}), below(3));
        }
    }
    /// So many steps later, as far as the session has them.
    void add(SessionAction action, int later = 0) {
        if (step_ + later <= session_.steps) {
            step_ += later;
            session_.events.push_back({step_, std::move(action)});
        }
    }

    std::mt19937 random_;
    Session session_;
    int step_ = 0;
    bool changed_ = false;
};

Document documentOf(const Session& session) {
    const test::TemporaryFolder folder;
    writeText(folder / "random.kerf.json", formatSession(session, folder.path()));
    return openDocument(folder / "random.kerf.json");
}

class KeptSessions : public GlTest {
  protected:
    /// Each with a die that a seed begins.
    template <class Test>
    static void forRandomSessions(Test&& test) {
        const auto first = static_cast<unsigned>(environmentNumber("KERF_KEPT_SEED", kFirstSeed));
        std::cout << "first seed " << first << "\n";
        const auto runs = static_cast<unsigned>(test::runs("KERF_KEPT_RUNS", 4, 24));
        for (unsigned i = 0; i < runs; ++i) {
            SCOPED_TRACE("KERF_KEPT_RUNS=1 KERF_KEPT_SEED=" + std::to_string(first + i));
            RandomSession die(first + i);
            OpenedSession opened(documentOf(die.session()));
            test(die, opened);
            if (HasFailure()) {
                return;
            }
        }
    }
    static void playOn(RandomSession& die, OpenedSession& opened) {
        opened->timeline().playing = true;
        opened.run(die.below(40));
    }
};

TEST_F(KeptSessions, ShippedOnesAreSavedAsTheyWereWhereverTheyStand) {
    for (const fs::path& file : shippedSessions()) {
        SCOPED_TRACE(file.filename().string());
        OpenedSession opened(file);
        const std::string text = opened.openedText();
        EXPECT_EQ(opened.text(), text) << "at once";
        const bool large = opened->simulation().report().triangles > 2000;
        opened.run(large ? 2 : 25);
        EXPECT_EQ(opened.text(), text) << "after some steps";
        opened.goTo(large ? 1 : 7);
        EXPECT_EQ(opened.text(), text) << "after scrubbing back";
        EXPECT_EQ(opened.saved().remark, "");
        if (!opened->document().session.events.empty()) {
            opened->reset();  // else that is something done to the body
            EXPECT_EQ(opened.text(), text) << "at the start again";
        }
    }
}

TEST_F(KeptSessions, ThoseOfTheTestsEndAsTheirReplaysWereExpectedTo) {
    for (const fs::path& file : sessionsIn({"tests/regression"})) {
        SCOPED_TRACE(file.filename().string());
        OpenedSession opened(file);
        const int steps = opened->document().session.steps;
        EXPECT_EQ(opened.text(), opened.openedText()) << "at once";
        if (!nightly() && opened->simulation().report().triangles > kFewTriangles) {
            continue;  // RegressionSessions replay it
        }
        opened.goTo(steps / 2);
        opened.goTo(steps / 2 - 3);
        EXPECT_EQ(opened.text(), opened.openedText()) << "after scrubbing back";
        opened.goTo(steps);
        EXPECT_EQ(opened.text(), opened.openedText()) << "at the end";
        const Expectation expected = readExpectation(expectationFolder(file) / kExpectedFile);
        const gpu::DeviceInfo device = gpu::queryDevice();
        const bool sameBits = expected.driver == Driver{device.renderer, device.version};
        EXPECT_EQ(opened.stateHash(), sameBits ? expected.stateHash : opened.replay().stateHash);
    }
}

TEST_F(KeptSessions, APictureAddedToASessionWithoutEventsLeavesItsLength) {
    OpenedSession opened(fs::path(KERF_SOURCE_DIR) / "assets/sessions/drop-in.kerf.json");
    const int steps = opened->document().session.steps;
    opened.run(3);
    opened->recorder().addPicture(opened->recorder().end());
    const Session session = opened.saved().session;
    EXPECT_EQ(session.steps, steps);
    ASSERT_EQ(session.events.size(), 1U);
    EXPECT_EQ(session.events[0].step, steps);
}

TEST_F(KeptSessions, RandomOnesAreSavedAsTheyWereWhereverTheyStand) {
    forRandomSessions([](RandomSession& die, OpenedSession& opened) {
        const std::string text = opened.openedText();
        const int steps = opened->document().session.steps;
        EXPECT_EQ(opened.text(), text) << "at once";
        for (int i = 0; i < 4; ++i) {
            die.oneIn(2) ? opened.goTo(die.below(steps + 1)) : playOn(die, opened);
            EXPECT_EQ(opened.text(), text) << "at step " << opened->simulation().stepCount();
        }
        opened.goTo(0);
        opened.goTo(steps);
        EXPECT_EQ(opened.text(), text) << "at the end";
        const std::string hash = opened.stateHash();
        opened->timeline().toggleLoop();
        opened->timeline().playing = true;
        opened.run(3 * steps / 2);
        EXPECT_EQ(opened.text(), text) << "in the second round";
        EXPECT_EQ(opened.replay().stateHash, hash);
    });
}

TEST_F(KeptSessions, WhatAPersonChangesOnTheWayIsAddedAndReplaysAsItWasWatched) {
    forRandomSessions([](RandomSession& die, OpenedSession& opened) {
        const int steps = opened->document().session.steps;
        for (int i = 0; i < 3; ++i) {
            opened.goTo(die.below(steps));
            opened->execute(die.change());
        }
        opened->execute(SetParam{"air_drag", 2.0});
        opened.goTo(steps);
        const std::string hash = opened.stateHash();
        const RunSummary summary = opened.replay();
        EXPECT_EQ(summary.stateHash, hash);
        EXPECT_THAT(summary.failures, IsEmpty());
        EXPECT_EQ(opened.saved().session.steps, steps);
        const std::string text = opened.text();
        opened.goTo(die.below(steps));
        EXPECT_EQ(opened.text(), text) << "it may be saved from anywhere";
        opened.goTo(steps);
        EXPECT_EQ(opened.stateHash(), hash) << "and playing on does it again";
    });
}

/// Key poses of blade and hands up to a step.
std::size_t keyPoses(const std::vector<SessionEvent>& events, int step) {
    return std::ranges::count_if(events, [&](const SessionEvent& event) {
        return event.step < step && (std::holds_alternative<MoveBlade>(event.action) ||
                                     std::holds_alternative<Drag>(event.action));
    });
}

TEST_F(KeptSessions, WhereAPersonGoesOnAloneTheSessionIsThatSoFarAndReplaysAsItWasWatched) {
    forRandomSessions([](RandomSession& die, OpenedSession& opened) {
        const int steps = opened->document().session.steps;
        const int step = die.below(steps);
        opened.goTo(step);
        if (die.oneIn(2)) {
            opened->execute(die.change());
        }
        const std::vector<SessionEvent> file = opened->document().session.events;
        switch (die.below(3)) {
            case 0:
                EXPECT_EQ(opened->hands().grab(opened->simulation().bounds().center(), 10), "");
                opened->hands().dragTo(Vec3(0.3, 0.9, 0));
                opened.run(2);
                opened->hands().letGo();
                break;
            case 1:
                opened->execute(Restart{});
                break;
            default:
                opened->stroke().begin(Blade{Vec3(-0.1, 0.7, -1), Vec3(-0.1, 0.7, 1)},
                                       {0.5, maxStrokeStep(opened->simulation().bounds())});
                opened->stroke().moveTo(Blade{Vec3(-0.1, 0, -1), Vec3(-0.1, 0, 1)});
                opened->stroke().end();
        }
        opened.run(12);
        const std::vector<SessionEvent> events = opened.saved().session.events;
        EXPECT_LE(keyPoses(events, step), keyPoses(file, step) + 2) << "of the blade and of a hand";
        const RunSummary summary = opened.replay();
        EXPECT_EQ(summary.stateHash, opened.stateHash());
        EXPECT_EQ(opened.saved().session.steps, opened->simulation().stepCount());
    });
}

TEST_F(KeptSessions, PicturesChecksAndExportsSurviveScrubbingLoopingAndRestarts) {
    forRandomSessions([](RandomSession& die, OpenedSession& opened) {
        const std::size_t before = opened->document().session.events.size();
        const int steps = opened->document().session.steps;
        opened.goTo(die.below(steps + 1));
        opened->recorder().addPicture(opened->recorder().here());
        opened->recorder().addPicture(opened->recorder().here());
        opened->recorder().addCheck();
        opened.goTo(die.below(steps + 1));
        opened->recorder().addExport();
        opened->recorder().addCheck();
        const std::string text = opened.text();
        EXPECT_EQ(opened.saved().session.events.size(), before + 5);
        opened.goTo(0);
        opened.goTo(steps);
        opened->reset();
        EXPECT_EQ(opened.text(), text);
        opened->timeline().toggleLoop();
        opened->timeline().playing = true;
        opened.run(steps + 7);
        EXPECT_EQ(opened.text(), text);
        EXPECT_THAT(opened->takeMessages(), Not(Contains(HasSubstr("the state hash"))));
        const std::vector<std::string> failures = opened.replay().failures;
        EXPECT_THAT(failures, Each(HasSubstr("expects 1"))) << "not those";
    });
}

TEST_F(KeptSessions, TheViewIsItsOwnUntilAPersonChoosesAnother) {
    const fs::path sessions = fs::path(KERF_SOURCE_DIR) / "assets/sessions";
    OpenedSession opened(sessions / "sphere20.kerf.json");
    const Vec3 own = opened->document().session.view->eye;
    EXPECT_EQ(opened.saved().session.view->eye, own);
    opened.run(3);
    opened->execute(Restart{});
    EXPECT_EQ(opened.saved().session.view->eye, own) << "also of one that a person goes on with";
    render::Camera chosen;
    chosen.eye = Vec3(1, 2, 3);
    opened->recorder().useView(chosen);
    EXPECT_EQ(opened.saved().session.view->eye, chosen.eye);

    OpenedSession live(sessions / "drop-in.kerf.json");
    EXPECT_FALSE(live.saved().session.view) << "nothing was done";
    live->execute(SetParam{"friction", 0.1});
    EXPECT_EQ(live.saved().session.view->eye, Vec3(7, 8, 9));
}

TEST_F(KeptSessions, ARecordingOverASessionIsOfItself) {
    OpenedSession opened(fs::path(KERF_SOURCE_DIR) / "assets/sessions/sphere20.kerf.json");
    opened.run(20);
    opened->startRecording();
    opened.run(3);
    opened->recorder().stop();
    const Session session = opened.saved().session;
    EXPECT_EQ(session.steps, 3);
    EXPECT_EQ(session.view->eye, Vec3(7, 8, 9));
    for (const SessionEvent& event : session.events) {
        EXPECT_TRUE(std::holds_alternative<CheckEvent>(event.action));
    }
}

TEST_F(KeptSessions, AChangeAtTheEndLetsTheSessionGoOn) {
    Session session;
    session.model.builtin = "sphere20";
    session.params.gravity = Vec3::Zero();
    session.params.floor = -0.6;
    session.steps = 10;
    session.events = {{10, CheckEvent{std::nullopt, 1}}};
    OpenedSession opened(documentOf(session));
    opened.run(15);
    EXPECT_EQ(opened.text(), opened.openedText()) << "as long as nothing is changed";
    opened->execute(SetParam{"gravity", Vec3(0, -9.81, 0)});
    opened.run(20);
    EXPECT_EQ(opened.saved().session.steps, 35);
    EXPECT_EQ(opened.replay().stateHash, opened.stateHash());
    const std::string hash = opened.stateHash();
    opened.goTo(3);
    opened.goTo(35);
    EXPECT_EQ(opened.stateHash(), hash);
}

TEST_F(KeptSessions, TakingBackASettingLetsTheSessionPlayOn) {
    OpenedSession opened(fs::path(KERF_SOURCE_DIR) / "assets/sessions/sphere20.kerf.json");
    opened.run(4);
    opened->execute(SetParam{"friction", 0.1});
    EXPECT_EQ(opened->execute(Undo{}), "");
    EXPECT_TRUE(opened->timeline().playingBack());
    opened.run(20);
    opened->execute(SetParam{"friction", 0.2});
    opened->execute(Undo{});
    EXPECT_TRUE(opened->timeline().playingBack()) << "not even a stroke ends for it";
    EXPECT_TRUE(opened->simulation().blade());
}

// The next stroke began where the one before had been put away.
TEST_F(KeptSessions, AnUndoWithNothingToUndoEndsTheStrokeInTheSessionToo) {
    OpenedSession opened(fs::path(KERF_SOURCE_DIR) / "assets/sessions/drop-in.kerf.json");
    const auto stroke = [&](double x, double to) {
        opened->stroke().begin(Blade{Vec3(x, 0.1, -1), Vec3(x, 0.1, 1)}, {0.5, 0.05});
        opened->stroke().moveTo(Blade{Vec3(to, 0.1, -1), Vec3(to, 0.1, 1)});
        opened.run(4);
    };
    stroke(-1.2, -0.9);
    EXPECT_NE(opened->execute(Undo{}), "");
    stroke(0.9, 1.2);
    opened.run(4);
    EXPECT_EQ(opened->simulation().report().pieces, 1);
    EXPECT_EQ(opened.replay().stateHash, opened.stateHash());
}

}  // namespace
}  // namespace kerf::app
