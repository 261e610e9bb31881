// A walk through time at random, beside a model that keeps all states: what is done, undone,
// sought, saved, reopened, exchanged, lost and recovered has the state hashes that it had.

#include <random>

#include "app/journal/journal.h"
#include "app/scene/timeline/scene_timeline.h"
#include "sim/run/undo/undo_history.h"
#include "tests/support/file_limit.h"

namespace kerf::app {
namespace {

/// A change as the plain model keeps it: the state hashes that undo and redo lead to; empty where
/// they leave the body as it is.
struct Change {
    std::string before;
    std::string after;
};

/// The changes of a scene, and how many are done.
struct Changes {
    std::vector<Change> list;
    std::size_t done = 0;
};

class EditorWalkTest : public EditorTest {
  protected:
    void SetUp() override {
        EditorTest::SetUp();
        writeText(folder / "ball.obj", objText(icosphereSoup(1)));
        writeText(folder / "box.obj", objText(boxSoup(Vec3::Ones(), 2)));
        writeText(folder / "settings.json", "{}");
        startWith(folder / "ball.obj");
    }
    void startWith(const fs::path& file) {
        EditorOptions options = EditorTest::options();
        options.settingsFile = folder / "settings.json";
        options.journals = journals.path();
        options.storedEnds = ends.path();
        start(options, openDocument(file));
        settle(1);
    }

    EditorScene& scene() { return *editor->scene(); }
    int step() { return scene().simulation().stepCount(); }
    std::string hash() { return scene().simulation().stateHash(); }
    int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }
    double share() { return std::uniform_real_distribution<double>(0, 1)(random_); }

    // --- What is done, in the editor and in the model ------------------------------------------

    /// What was kept of a later course is played otherwise now.
    void forgetLater() {
        courses_.erase(courses_.upper_bound(step()), courses_.end());
        unsaved_ = true;
    }
    void arrive() { courses_[step()] = {hash(), changes_}; }
    void add(Change change) {
        changes_.list.resize(changes_.done);
        changes_.list.push_back(std::move(change));
        ++changes_.done;
    }
    void cut() {
        const std::string before = hash();
        const int begun = step();
        const std::size_t entries = scene().simulation().history().done();
        forgetLater();
        const Vec2 from((0.4 + 0.2 * share()) * kWidth, 150);  // below the remarks
        const Vec2 to((0.4 + 0.2 * share()) * kWidth, 445);
        dragAndSettle(from, to, 4);
        if (scene().simulation().history().done() > entries ||
            scene().simulation().history().canRedo() != (changes_.done < changes_.list.size())) {
            add({before, ""});
        }
        if (step() > begun) {
            arrive();
        }
    }
    void set() {
        forgetLater();
        const std::string before = hash();
        const int now = scene().simulation().params().iterations;
        scene().execute(SetParam{"iterations", static_cast<double>(now % 20 + 1)});
        add({});
        frames(1);
        EXPECT_EQ(hash(), before);
    }
    void play() {
        goToEnd();
        scene().timeline().playing = true;
        frames(1 + below(6));
        scene().timeline().playing = false;
        settle(1);
        arrive();
    }
    void takeBack() {
        if (changes_.done == 0) {
            return;
        }
        forgetLater();
        const std::string now = hash();
        undo();
        settle(1);
        Change& change = changes_.list[--changes_.done];
        change.after = change.before.empty() ? "" : now;
        EXPECT_EQ(hash(), change.before.empty() ? now : change.before);
    }
    void bringBack() {
        if (changes_.done == changes_.list.size() || !scene().simulation().history().canRedo()) {
            return;
        }
        forgetLater();
        const std::string now = hash();
        tap(Key::z, {.shift = true, .control = true});
        settle(1);
        const Change& change = changes_.list[changes_.done++];
        EXPECT_EQ(hash(), change.after.empty() ? now : change.after);
    }
    void seekBack() {
        if (courses_.empty()) {
            return;
        }
        const auto& [to, then] = *std::next(courses_.begin(), below(int(courses_.size())));
        if (to > step() || !scene().timeline().goesBack(to)) {
            return;
        }
        scene().seek(to);
        settle(1);
        EXPECT_EQ(step(), to);
        EXPECT_EQ(hash(), then.hash);
        changes_ = then.changes;
    }
    /// Where the past is shown, what followed comes back, as far as it still fits.
    void goToEnd() {
        const SessionPlayback* const past = scene().timeline().playback();
        if (past != nullptr && step() < past->steps()) {
            scene().seek(past->steps());
            settle(1);
            courses_.clear();
            changes_ = {};
        }
    }
    void saveAndReopen() {
        goToEnd();
        const std::string before = hash();
        saveByKeys();
        const fs::path file = folder / (scene().document().name + ".kerf.json");
        ASSERT_TRUE(fs::exists(file));
        startWith(folder / "ball.obj");
        open(file);
        settle(1);
        EXPECT_EQ(hash(), before);
        unsaved_ = false;
        begin();
    }
    void crash() {
        if (!unsaved_) {
            return;
        }
        goToEnd();
        const std::string before = hash();
        startWith(folder / "ball.obj");
        waitWhile([&] { return panels().question.text.empty(); });
        ASSERT_FALSE(panels().question.text.empty());
        frames(2);
        clickAndWait("question.0");
        settle(2);
        EXPECT_EQ(hash(), before);
        begin();
    }
    /// The scene on other models, and back.
    void exchange() {
        goToEnd();
        const std::string before = hash();
        tap(Key::o, {.shift = true, .control = true}, 2);
        enter("box.obj");
        settle(2);
        undo();
        settle(2);
        EXPECT_EQ(hash(), before);
        changes_.list.resize(changes_.done);  // to redo is now to exchange it again
    }
    void fillDisk() {
        {
            const test::FileLimit limit(0);
            set();
            frames(3);
        }
        saveByKeys();  // begins to keep again
        frames(2);
        unsaved_ = false;
    }
    /// A scene that was opened: what came before it is played again only where it is asked for.
    void begin() {
        courses_.clear();
        changes_ = {};
    }

    /// What is shown at a step, before what is done there.
    struct Course {
        std::string hash;
        Changes changes;
    };
    std::map<int, Course> courses_;  ///< by step
    Changes changes_;
    bool unsaved_ = false;
    std::mt19937 random_;
    test::TemporaryFolder journals, ends;
};

TEST_F(EditorWalkTest, AllStatesComeBackAsTheyWere) {
    const char* const asked = std::getenv("KERF_WALK");  // actions, for a night
    const int actions = asked != nullptr ? std::atoi(asked) : 120;
    const auto seed = static_cast<unsigned>(actions);
    SCOPED_TRACE("seed " + std::to_string(seed));
    random_.seed(seed);
    begin();
    struct Act {
        int share;  ///< of a hundred
        const char* name;
        std::function<void()> run;
        int count = 0;
    };
    std::vector<Act> acts{{18, "cut", [this] { cut(); }},
                          {14, "set", [this] { set(); }},
                          {14, "play", [this] { play(); }},
                          {20, "undo", [this] { takeBack(); }},
                          {12, "redo", [this] { bringBack(); }},
                          {10, "seek", [this] { seekBack(); }},
                          {4, "save and reopen", [this] { saveAndReopen(); }},
                          {3, "crash", [this] { crash(); }},
                          {3, "exchange", [this] { exchange(); }},
                          {2, "full disk", [this] { fillDisk(); }}};
    for (int i = 0; i < actions && !HasFailure(); ++i) {
        auto act = acts.begin();
        for (int chance = below(100); chance >= act->share; ++act) {
            chance -= act->share;
        }
        SCOPED_TRACE("action " + std::to_string(i) + ": " + act->name);
        act->run();
        ++act->count;
    }
    for (const Act& act : acts) {
        std::cout << act.name << ": " << act.count << "\n";
    }
}

}  // namespace
}  // namespace kerf::app
