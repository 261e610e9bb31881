// Journals on the disk: what is read of them, whose they are, and how long they stay.

#include "app/journal/journal.h"

#include <sqlite3.h>

#include <csignal>

#include "app/journal/text_journal.h"
#include "tests/support/file_limit.h"

namespace kerf::app {
namespace {

Session sphere() {
    Session session;
    session.model.builtin = "sphere20";
    session.steps = 1;
    return session;
}

SessionEvent pose(int step, double y) {
    return {step, MoveBlade{{Vec3(-1, y, 0), Vec3(1, y, 0)}}};
}

SessionEvent lift(int step) {
    return {step, LiftBlade{}};
}

/// A stroke from before step 0, in the list from `from` on.
SessionChange stroke(std::size_t from, int step) {
    return {from, {pose(step, 0.5), pose(step + 1, -0.5), lift(step + 2)}, step + 3};
}

KeptWork ball(std::time_t when = std::time(nullptr)) {
    KeptWork work{"ball", formatSession(sphere()), {}, 3, true, when};
    for (const std::optional<SessionEvent>& event : stroke(0, 0).events) {
        work.events.push_back(formatEvent(*event));
    }
    return work;
}

/// Leaves a journal behind.
fs::path leave(const fs::path& folder, const KeptWork& work = ball()) {
    Journal journal(folder);
    journal.begin(work);
    EXPECT_EQ(journal.takeProblem(), std::nullopt);
    return journal.file();
}

std::size_t filesIn(const fs::path& folder) {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), {}));
}

class JournalTest : public testing::Test {
  protected:
    KeptWork workIn(const Journal& journal) { return journal.work().value_or(KeptWork{}); }
    Session sessionIn(const Journal& journal) { return parseSession(workIn(journal).text(), {}); }
    test::TemporaryFolder folder;
};

// --- The content -------------------------------------------------------------------------------

TEST_F(JournalTest, IsReadAsAnOrdinarySession) {
    Journal journal(folder.path());
    journal.begin("ball", sphere(), stroke(0, 0), true);
    journal.write(stroke(3, 3), false);
    const KeptWork kept = workIn(journal);
    EXPECT_EQ(kept.name, "ball");
    EXPECT_EQ(kept.cuts(), 2);
    EXPECT_FALSE(kept.unsaved);
    const Session session = sessionIn(journal);
    EXPECT_EQ(session.model.builtin, "sphere20");
    EXPECT_EQ(session.steps, 6);
    EXPECT_EQ(session.events.size(), 6U);
    EXPECT_TRUE(session.warnings.empty());
}

TEST_F(JournalTest, AChangeReplacesWhatStoodThere) {
    Journal journal(folder.path());
    journal.begin("ball", sphere(), stroke(0, 0), true);
    journal.write({1, {std::nullopt, lift(1)}, 9}, true);
    Session session = sessionIn(journal);
    ASSERT_EQ(session.events.size(), 2U) << "what is not saved has a place, and is left out";
    EXPECT_TRUE(std::holds_alternative<LiftBlade>(session.events[1].action));
    EXPECT_EQ(session.steps, 9);
    journal.write({3, {lift(4)}, 12}, true);
    EXPECT_EQ(sessionIn(journal).events.size(), 3U) << "the place without an event counts";
}

TEST_F(JournalTest, ANewViewTakesThePlaceOfTheOldOne) {
    Journal journal(folder.path());
    journal.begin("ball", sphere(), stroke(0, 0), true);
    EXPECT_EQ(journal.picture(), nullptr);
    Session seen = sphere();
    seen.view = render::Camera{};
    journal.show(seen, {2, 1, std::vector<std::uint8_t>(8, 7)});
    EXPECT_TRUE(sessionIn(journal).view.has_value());
    EXPECT_EQ(sessionIn(journal).events.size(), 3U);
    ASSERT_NE(journal.picture(), nullptr);
    EXPECT_EQ(journal.picture()->width, 2);
    EXPECT_EQ(journal.picture()->pixels, std::vector<std::uint8_t>(8, 7));
}

TEST_F(JournalTest, WithoutAnEventTimeGoesByAllTheSame) {
    Journal journal(folder.path());
    journal.begin("ball", sphere(), {0, {}, 40}, true);
    EXPECT_EQ(sessionIn(journal).events.size(), 1U);
}

// The editor calls files by the name of the scene.
TEST_F(JournalTest, ANameLeadsIntoNoFolder) {
    const std::map<std::string, std::string> names{
        {"../../ball", "ball"}, {"/etc/ball", "ball"}, {"..", "_.."}, {"a\nb", "a_b"}};
    for (const auto& [name, plain] : names) {
        Journal journal(folder.path());
        KeptWork work = ball();
        work.name = name;
        journal.begin(work);
        EXPECT_EQ(workIn(journal).name, plain) << name;
    }
}

TEST_F(JournalTest, AnotherSceneTakesThePlaceOfTheOldOneAtOnce) {
    Journal journal(folder.path());
    journal.begin("ball", sphere(), stroke(0, 0), true);
    journal.show(sphere(), {1, 1, {1, 2, 3, 4}});
    journal.begin("box", sphere(), stroke(0, 7), true);
    EXPECT_EQ(workIn(journal).name, "box");
    EXPECT_EQ(sessionIn(journal).events.size(), 3U);
    EXPECT_EQ(journal.picture(), nullptr);
    EXPECT_EQ(journal.takeProblem(), std::nullopt);
}

/// Ends this process as a crash does, with `write` done.
void dieAfter(const std::function<void()>& write) {
    if (const pid_t child = ::fork(); child == 0) {
        write();
        ::kill(::getpid(), SIGKILL);
    } else {
        int status = 0;
        ::waitpid(child, &status, 0);
        ASSERT_TRUE(WIFSIGNALED(status));
    }
}

TEST_F(JournalTest, AKilledProgramLosesNothing) {
    dieAfter([&] {
        Journal& journal = *new Journal(folder.path());  // nobody closes it
        journal.begin("ball", sphere(), stroke(0, 0), true);
        for (int i = 1; i < 20; ++i) {
            journal.write(stroke(3U * i, 3 * i), true);
        }
    });
    const std::vector<LeftWork> left = lookForLeftWork(folder.path());
    ASSERT_EQ(left.size(), 1U);
    EXPECT_EQ(left[0].kept.cuts(), 20);
}

// A power cut may leave any part of what was written last.
TEST_F(JournalTest, TornAnywhereItHasTheLastWholeChange) {
    fs::path written;
    dieAfter([&] {
        Journal& journal = *new Journal(folder.path());  // nobody closes it
        journal.begin("ball", sphere(), stroke(0, 0), true);
        journal.write(stroke(3, 3), true);
        journal.write(stroke(6, 6), true);
    });
    for (const auto& entry : fs::directory_iterator(folder.path())) {
        written = isJournal(entry.path()) ? entry.path() : written;
    }
    const std::string main = readBytes(written);
    const std::string log = readBytes(fs::path(written) += "-wal");
    ASSERT_FALSE(log.empty());
    int most = -1;
    for (std::size_t length = 0; length <= log.size(); length += 1009) {
        const test::TemporaryFolder torn;
        writeText(torn / "a.journal", main);
        writeText(torn / "a.journal-wal", log.substr(0, length));
        const std::vector<LeftWork> left = lookForLeftWork(torn.path());
        const int cuts = left.empty() ? 0 : left[0].kept.cuts();
        EXPECT_GE(cuts, most) << length;
        if (!left.empty()) {
            EXPECT_NO_THROW(parseSession(left[0].kept.text(), {})) << length;
        }
        most = cuts;
    }
    EXPECT_GE(most, 2);
}

TEST_F(JournalTest, AnotherFileOfTheModelsNameIsNoticed) {
    writeText(folder / "a.obj", objText(icosphereSoup(1)));
    const Document document = openDocument(folder / "a.obj");
    const std::string hash = document.read.at(folder / "a.obj").sha256;
    EXPECT_EQ(hash.size(), 64U);
    Session session = document.session;
    session.model.sha256 = hash;
    EXPECT_NO_THROW(loadSessionModel(session));
    writeText(folder / "a.obj", objText(icosphereSoup(2)));
    EXPECT_THROW(loadSessionModel(session), InputError);
}

// --- Windows -----------------------------------------------------------------------------------

TEST_F(JournalTest, NobodyTakesTheJournalOfAWindow) {
    {
        Journal first(folder.path());
        Journal second(folder.path());
        first.begin(ball());
        second.begin(ball());
        EXPECT_NE(first.file(), second.file());
        EXPECT_TRUE(lookForLeftWork(folder.path()).empty());
        EXPECT_THROW(readJournal(first.file()), InputError);
    }
    const std::vector<LeftWork> left = lookForLeftWork(folder.path());
    EXPECT_EQ(left.size(), 2U);
    EXPECT_TRUE(lookForLeftWork(folder.path()).empty()) << "they are somebody's already";
}

TEST_F(JournalTest, WhatIsRemovedLeavesNothing) {
    Journal journal(folder.path());
    journal.begin("ball", sphere(), stroke(0, 0), true);
    EXPECT_GT(filesIn(folder.path()), 0U);
    journal.remove();
    journal.write(stroke(3, 3), true);
    EXPECT_EQ(filesIn(folder.path()), 0U);
    EXPECT_EQ(journal.takeProblem(), std::nullopt);
}

TEST_F(JournalTest, AFullDiskIsSaidOnceAndWhatWasKeptStays) {
    for (const rlim_t bytes : {0, 4096, 20'000, 40'000, 60'000, 100'000}) {
        const test::TemporaryFolder full;
        std::vector<std::string> problems;
        int written = 0;
        {
            const test::FileLimit limit(bytes);
            Journal journal(full.path());
            journal.begin("ball", sphere(), stroke(0, 0), true);
            for (int i = 1; i < 100; ++i) {
                journal.write(stroke(3U * i, 3 * i), true);
                if (auto problem = journal.takeProblem()) {
                    problems.push_back(*problem);
                }
                written += problems.empty() ? 1 : 0;
            }
        }
        ASSERT_EQ(problems.size(), 1U) << bytes;
        EXPECT_THAT(problems[0], testing::AnyOf(HasSubstr("disk full"), HasSubstr("disk I/O")));
        EXPECT_THAT(problems[0], HasSubstr("Save often."));
        const std::vector<LeftWork> left = lookForLeftWork(full.path());
        if (written > 0) {
            ASSERT_EQ(left.size(), 1U) << bytes;
            EXPECT_EQ(left[0].kept.cuts(), written + 1) << bytes;
        }
    }
}

TEST_F(JournalTest, AFolderThatCannotBeMadeIsSaid) {
    writeText(folder / "state", "a file");
    Journal journal(folder / "state/journal");
    journal.begin(ball());
    const std::optional<std::string> problem = journal.takeProblem();
    ASSERT_TRUE(problem.has_value());
    EXPECT_THAT(*problem, HasSubstr((folder / "state/journal").string()));
    EXPECT_EQ(journal.takeProblem(), std::nullopt);
}

// --- The folder --------------------------------------------------------------------------------

TEST_F(JournalTest, WhatIsSavedIsTakenAway) {
    KeptWork saved = ball();
    saved.unsaved = false;
    leave(folder.path(), saved);
    const fs::path unsaved = leave(folder.path());
    const std::vector<LeftWork> left = lookForLeftWork(folder.path());
    ASSERT_EQ(left.size(), 1U);
    EXPECT_EQ(left[0].journal->file(), unsaved);
    left[0].journal->remove();
    EXPECT_EQ(filesIn(folder.path()), 0U);
}

TEST_F(JournalTest, OldOnesAndThoseTooManyAreTakenAway) {
    for (std::size_t i = 0; i < kMostLeftJournals + 3; ++i) {
        leave(folder.path());
    }
    EXPECT_EQ(lookForLeftWork(folder.path()).size(), kMostLeftJournals);
    EXPECT_EQ(filesIn(folder.path()), kMostLeftJournals);
    const std::time_t old = std::time(nullptr) - 24 * 3600 * (kDaysOfJournals + 1);
    for (const auto& entry : fs::directory_iterator(folder.path())) {
        fs::remove(entry.path());
    }
    leave(folder.path(), ball(old));
    EXPECT_TRUE(lookForLeftWork(folder.path()).empty());
    EXPECT_EQ(filesIn(folder.path()), 0U);
}

TEST_F(JournalTest, OneJustBegunAndWhatIsNoneAreLeftAlone) {
    { const Journal begun(folder.path()); }
    writeText(folder / "garbage.journal", "garbage");
    writeText(folder / "mine.txt", "");
    fs::create_directory(folder / "folder.journal");
    EXPECT_TRUE(lookForLeftWork(folder.path()).empty());
    EXPECT_EQ(filesIn(folder.path()), 4U);
    EXPECT_TRUE(lookForLeftWork(folder / "missing").empty());
    for (const auto& entry : fs::directory_iterator(folder.path())) {
        fs::last_write_time(entry.path(), fs::file_time_type::clock::now() - std::chrono::hours(2));
    }
    EXPECT_TRUE(lookForLeftWork(folder.path()).empty());
    EXPECT_EQ(filesIn(folder.path()), 3U) << "nothing was ever done in the oldest";
}

// Anybody may write there.
TEST_F(JournalTest, ADatabaseOfOtherContentHarmsNothing) {
    const char* const contents[] = {
        "CREATE TABLE scene (x)",
        "CREATE TABLE scene (id INTEGER PRIMARY KEY, name, session, steps, unsaved, at);"
        "INSERT INTO scene VALUES (1, NULL, 'no JSON', 1e300, 'x', -5)",
        "CREATE TABLE scene (id INTEGER PRIMARY KEY, name, session, steps, unsaved, at);"
        "INSERT INTO scene VALUES (1, 'a', '{}', -7, 1, 4e18);"
        "CREATE TABLE event (place INTEGER PRIMARY KEY, text);"
        "INSERT INTO event VALUES (1, '}{'), (2, x'00ff')",
        "CREATE VIEW event AS SELECT 1 AS place, '[' AS text",
    };
    for (const char* const sql : contents) {
        const fs::path file = folder / "a.journal";
        sqlite3* database = nullptr;
        ASSERT_EQ(sqlite3_open(file.c_str(), &database), SQLITE_OK);
        ASSERT_EQ(sqlite3_exec(database, sql, nullptr, nullptr, nullptr), SQLITE_OK) << sql;
        sqlite3_close(database);
        for (const LeftWork& left : lookForLeftWork(folder.path())) {
            EXPECT_THROW(parseSession(left.kept.text(), {}), InputError) << sql;
        }
        fs::remove(file);
    }
}

// --- Those of an older Kerf --------------------------------------------------------------------

const std::string kTextStart =
    R"({"kerf_journal":1,"name":"ball","session":{"format":"kerf-session","version":1,)"
    R"("model":{"builtin":"sphere20"},"steps":1}})"
    "\n";

std::string textStroke(int number) {
    const std::string step = std::to_string(3 * number);
    return R"({"steps":)" + std::to_string(3 * number + 3) + R"(,"unsaved":true,"at":)" + step +
           R"(,"dropped":0,"events":[{"step":)" + step +
           R"(,"type":"blade","a":[-1,0.5,0],"b":[1,0.5,0]},null,{"step":)" + step +
           R"(,"type":"lift"}]})"
           "\n";
}

TEST_F(JournalTest, TextOfAnOlderKerfIsOfferedToo) {
    writeText(folder / "20250101-000000-1-1.journal", kTextStart + textStroke(0) + textStroke(1));
    writeText(folder / "20250101-000000-1-1.png", "picture");
    {
        const std::vector<LeftWork> left = lookForLeftWork(folder.path());
        ASSERT_EQ(left.size(), 1U);
        EXPECT_EQ(left[0].kept.name, "ball");
        EXPECT_EQ(left[0].kept.cuts(), 2);
        EXPECT_EQ(parseSession(left[0].kept.text(), {}).steps, 6);
        EXPECT_FALSE(fs::exists(folder / "20250101-000000-1-1.journal"));
    }
    EXPECT_EQ(lookForLeftWork(folder.path()).size(), 1U) << "it stays, in the new form";
}

TEST_F(JournalTest, TextTornAtAnyByteIsReadUpToTheLastWholeLine) {
    const std::string first = kTextStart + textStroke(0);
    const std::string all = first + textStroke(1);
    for (std::size_t length = 0; length <= all.size(); ++length) {
        const std::optional<KeptWork> kept = workInText(all.substr(0, length));
        ASSERT_EQ(kept.has_value(), length >= kTextStart.size()) << length;
        if (kept) {
            EXPECT_EQ(kept->cuts(), (length >= first.size() ? 1 : 0) + (length == all.size()));
            EXPECT_NO_THROW(parseSession(kept->text(), {})) << length;
        }
    }
}

TEST_F(JournalTest, WhatComesBehindGarbageInTextIsLeftOut) {
    const std::string whole = kTextStart + textStroke(0);
    for (const std::string& bad :
         {std::string(200, '\0') + "\n", std::string("{}\n"), std::string("7\n"),
          std::string("{\"steps\":-1,\"at\":0,\"dropped\":0,\"events\":[]}\n"),
          std::string("{\"steps\":1,\"at\":99,\"dropped\":0,\"events\":[]}\n"),
          std::string("{\"steps\":1,\"at\":1,\"dropped\":9,\"events\":[]}\n"),
          std::string("{\"steps\":1e300,\"at\":1,\"dropped\":0,\"events\":[]}\n"),
          std::string("{\"steps\":1,\"at\":1,\"dropped\":0,\"events\":{}}\n")}) {
        EXPECT_EQ(workInText(std::string(whole).append(bad).append(textStroke(1)))->cuts(), 1)
            << bad;
    }
    for (const char* none : {"", "{\"kerf_journal\":2,\"name\":\"a\",\"session\":{}}\n",
                             "{\"kerf_journal\":1,\"session\":{}}\n"}) {
        EXPECT_FALSE(workInText(none).has_value()) << none;
    }
}

}  // namespace
}  // namespace kerf::app
