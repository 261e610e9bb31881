// A walk through time at random, beside a model that keeps all states: what is done, undone,
// sought, saved, reopened, exchanged, lost and recovered has the state hashes that it had.

#include <spawn.h>

#include <csignal>

#include "app/journal/journal.h"
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

/// What is done, and how often beside other things.
struct Act {
    int share;
    const char* name;
    std::function<void()> run;
    int count = 0;
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
        options.journals = kept_;
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
        tell("doing");
        courses_.erase(courses_.upper_bound(step()), courses_.end());
        unsaved_ = true;
    }
    void arrive() {
        courses_[step()] = {hash(), changes_};
        tell("done");
    }
    /// Tells who kills this walk what it has come to: what is shown now, and at this step before
    /// what is done there.
    void tell(const std::string& what) {
        if (record_.is_open()) {
            const auto then = courses_.find(step());
            record_ << what << (unsaved_ ? " unsaved " : " saved ") << step() << " "
                    << (then != courses_.end() ? then->second.hash : "-") << " " << hash()
                    << std::endl;
        }
    }
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
        tell("done");
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
        tell("done");
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
        tell("done");
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
    void save() {
        goToEnd();
        saveByKeys();
        unsaved_ = false;
        tell("done");
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
        tell("exchanging");
        tap(Key::o, {.shift = true, .control = true}, 2);
        enter("box.obj");
        settle(2);
        undo();
        settle(2);
        tell("done");
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

    /// What needs no other window.
    std::vector<Act> actsOfAWindow() {
        return {{18, "cut", [this] { cut(); }},        {14, "set", [this] { set(); }},
                {14, "play", [this] { play(); }},      {20, "undo", [this] { takeBack(); }},
                {12, "redo", [this] { bringBack(); }}, {10, "seek", [this] { seekBack(); }},
                {3, "save", [this] { save(); }},       {3, "exchange", [this] { exchange(); }}};
    }
    Act& oneOf(std::vector<Act>& acts) {
        int sum = 0;
        for (const Act& act : acts) {
            sum += act.share;
        }
        auto act = acts.begin();
        for (int chance = below(sum); chance >= act->share; ++act) {
            chance -= act->share;
        }
        return *act;
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
    std::ofstream record_;  ///< of a walk that is killed
    test::TemporaryFolder journals, ends;
    fs::path kept_ = journals.path();
};

class EditorKilledWalkTest : public EditorWalkTest {
  protected:
    /// Of a walk: what it told last.
    struct Told {
        std::string what, kept, before, shown;
        int step = 0;
    };
    static Told lastOf(const fs::path& record) {
        std::ifstream lines(record);
        Told told;
        for (Told next;
             lines >> next.what >> next.kept >> next.step >> next.before >> next.shown;) {
            told = next;
        }
        return told;
    }
    /// Goes on until it is killed, in the folder of who kills it.
    void walk(const fs::path& shared) {
        random_.seed(static_cast<unsigned>(std::atoi(std::getenv("KERF_FUZZ_SEED"))));
        kept_ = shared / "journals";
        fs::copy(folder / "ball.obj", shared / "ball.obj");
        fs::copy(folder / "box.obj", shared / "box.obj");
        startWith(shared / "ball.obj");
        record_.open(shared / "record");
        begin();
        for (std::vector<Act> acts = actsOfAWindow(); !HasFailure();) {
            oneOf(acts).run();
        }
    }
    /// Starts this test in another process, kills it at some time, and returns what it told last.
    Told killWalk(const fs::path& shared, unsigned seed) {
        const test::Variable at("KERF_WALK_IN", shared.string());
        const test::Variable with("KERF_FUZZ_SEED", std::to_string(seed));
        std::string program = "/proc/self/exe";
        std::string filter = "--gtest_filter=EditorKilledWalkTest.*";
        const std::array<char*, 3> arguments{program.data(), filter.data(), nullptr};
        pid_t walk = 0;
        EXPECT_EQ(
            ::posix_spawn(&walk, program.c_str(), nullptr, nullptr, arguments.data(), environ), 0);
        const int lines = 2 + below(20);
        for (int n = 0; n < lines && ::waitpid(walk, nullptr, WNOHANG) == 0;) {
            std::this_thread::sleep_for(std::chrono::milliseconds(below(40)));
            n = static_cast<int>(std::ranges::count(readBytes(shared / "record"), '\n'));
        }
        ::kill(walk, SIGKILL);
        ::waitpid(walk, nullptr, 0);
        return lastOf(shared / "record");
    }
    /// What the next start offers has all but the action that was under way.
    void expectRecovered(const Told& told, const fs::path& shared) {
        kept_ = shared / "journals";
        startWith(folder / "ball.obj");
        frames(5);
        ASSERT_FALSE(told.kept == "unsaved" && panels().question.text.empty());
        if (panels().question.text.empty() || told.what == "exchanging") {
            return;
        }
        clickAndWait("question.0");
        settle(2);
        ASSERT_GE(step(), told.step);
        if (step() == told.step) {
            EXPECT_TRUE(told.what == "doing" || hash() == told.shown);
        } else if (told.before != "-") {
            scene().seek(told.step);
            settle(1);
            EXPECT_EQ(hash(), told.before);
        }
    }
};

TEST_F(EditorWalkTest, AllStatesComeBackAsTheyWere) {
    const char* const asked = std::getenv("KERF_WALK");  // actions, for a night
    const int actions = asked != nullptr ? std::atoi(asked) : 120;
    const auto seed = static_cast<unsigned>(actions);
    SCOPED_TRACE("seed " + std::to_string(seed));
    random_.seed(seed);
    begin();
    std::vector<Act> acts = actsOfAWindow();
    acts.push_back({4, "save and reopen", [this] { saveAndReopen(); }});
    acts.push_back({3, "crash", [this] { crash(); }});
    acts.push_back({2, "full disk", [this] { fillDisk(); }});
    for (int i = 0; i < actions && !HasFailure(); ++i) {
        Act& act = oneOf(acts);
        SCOPED_TRACE("action " + std::to_string(i) + ": " + act.name);
        act.run();
        ++act.count;
    }
    for (const Act& act : acts) {
        std::cout << act.name << ": " << act.count << "\n";
    }
}

TEST_F(EditorKilledWalkTest, OnlyTheActionUnderWayIsLost) {
    if (const char* const shared = std::getenv("KERF_WALK_IN")) {
        walk(shared);
        return;
    }
    const std::uint32_t seed = fuzzSeed(std::random_device()() % 30000);
    random_.seed(seed);
    for (int n = 0; n < runs("KERF_KILLS", 2, 200) && !HasFailure(); ++n) {
        const test::TemporaryFolder shared;
        SCOPED_TRACE("kill " + std::to_string(n) + " of seed " + std::to_string(seed));
        const Told told = killWalk(shared.path(), seed + static_cast<unsigned>(n));
        std::cout << "kill " << n << ": " << told.what << " at step " << told.step << ", "
                  << told.kept << std::endl;
        expectRecovered(told, shared.path());
    }
}

}  // namespace
}  // namespace kerf::app
