// Journals on the disk: what is read of them, whose they are, and how long they stay.

#include <future>

#include "app/journal/journal_folder.h"
#include "app/journal/journal_writer.h"

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

/// A stroke from before step 0, in the list from `at` on.
SessionChange stroke(std::size_t at, int step) {
    return {at, 0, {pose(step, 0.5), pose(step + 1, -0.5), lift(step + 2)}, step + 3};
}

KeptWork readText(const std::string& text) {
    const test::TemporaryFolder folder;
    writeText(folder / "a.journal", text);
    return readJournal(folder / "a.journal");
}

Session sessionIn(const KeptWork& kept) {
    return parseSession(kept.session, {});
}

/// Until all is on the disk, or failed.
void settle(const JournalWriter& writer) {
    while (!writer.flushed()) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
}

/// Leaves a journal behind.
fs::path leave(const fs::path& folder, bool unsaved = true) {
    JournalWriter writer(folder);
    writer.add([] { return journalStart("ball", sphere()); });
    writer.add([unsaved] { return journalLine(stroke(0, 0), unsaved); });
    settle(writer);
    return writer.file();
}

std::size_t filesIn(const fs::path& folder) {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), {}));
}

// --- The text ----------------------------------------------------------------------------------

TEST(Journal, IsReadAsAnOrdinarySession) {
    const KeptWork kept =
        readText(journalStart("ball", sphere()) + journalLine(stroke(0, 0), true) +
                 journalLine(stroke(3, 3), true));
    EXPECT_EQ(kept.name, "ball");
    EXPECT_EQ(kept.cuts, 2);
    EXPECT_TRUE(kept.unsaved);
    const Session session = sessionIn(kept);
    EXPECT_EQ(session.model.builtin, "sphere20");
    EXPECT_EQ(session.steps, 6);
    EXPECT_EQ(session.events.size(), 6U);
    EXPECT_TRUE(session.warnings.empty());
}

TEST(Journal, LinesReplaceWhatStoodThere) {
    SessionChange other{1, 2, {std::nullopt, lift(1)}, 9};
    const Session session =
        sessionIn(readText(journalStart("ball", sphere()) + journalLine(stroke(0, 0), true) +
                           journalLine(other, true)));
    ASSERT_EQ(session.events.size(), 2U) << "what is not saved has a place, and is left out";
    EXPECT_TRUE(std::holds_alternative<LiftBlade>(session.events[1].action));
    EXPECT_EQ(session.steps, 9);
}

TEST(Journal, ANewViewTakesThePlaceOfTheOldOne) {
    Session seen = sphere();
    seen.view = render::Camera{};
    const Session session = sessionIn(readText(
        journalStart("ball", sphere()) + journalLine(stroke(0, 0), true) + journalView(seen)));
    EXPECT_TRUE(session.view.has_value());
    EXPECT_EQ(session.events.size(), 3U);
}

TEST(Journal, WithoutAnEventTimeGoesByAllTheSame) {
    const Session session =
        sessionIn(readText(journalStart("ball", sphere()) + journalLine({0, 0, {}, 40}, true)));
    EXPECT_EQ(session.steps, 40);
    EXPECT_EQ(session.events.size(), 1U);
}

// The editor calls files by the name of the scene.
TEST(Journal, ANameLeadsIntoNoFolder) {
    for (const char* name : {"../../ball", "/etc/ball", "a/../ball"}) {
        EXPECT_EQ(readText(journalStart(name, sphere())).name, "ball") << name;
    }
    EXPECT_EQ(readText(journalStart("..", sphere())).name, "_..");
    EXPECT_EQ(readText(journalStart("a\nb", sphere())).name, "a_b");
}

// A power cut may leave any part of what was written last.
TEST(Journal, TornAtAnyByteItIsReadUpToTheLastWholeLine) {
    const std::string start = journalStart("ball", sphere());
    const std::string first = journalLine(stroke(0, 0), true);
    const std::string second = journalLine(stroke(3, 3), true);
    const std::string all = start + first + second;
    for (std::size_t length = start.size(); length <= all.size(); ++length) {
        const std::size_t lines =
            (length >= start.size() + first.size() ? 1U : 0U) + (length == all.size() ? 1U : 0U);
        const KeptWork kept = readText(all.substr(0, length));
        EXPECT_EQ(kept.cuts, static_cast<int>(lines)) << length;
        EXPECT_EQ(kept.unsaved, lines > 0);
        EXPECT_NO_THROW(sessionIn(kept)) << length;
    }
    for (std::size_t length = 0; length < start.size(); ++length) {
        EXPECT_THROW(readText(all.substr(0, length)), InputError) << length;
    }
}

TEST(Journal, WhatComesBehindGarbageIsLeftOut) {
    const std::string whole = journalStart("ball", sphere()) + journalLine(stroke(0, 0), true);
    const std::string next = journalLine(stroke(3, 3), true);
    for (const std::string& bad :
         {std::string(200, '\0') + "\n", std::string("{}\n"), std::string("7\n"),
          std::string("{\"steps\":-1,\"at\":0,\"dropped\":0,\"events\":[]}\n"),
          std::string("{\"steps\":1,\"at\":99,\"dropped\":0,\"events\":[]}\n"),
          std::string("{\"steps\":1,\"at\":1,\"dropped\":9,\"events\":[]}\n"),
          std::string("{\"steps\":1e300,\"at\":1,\"dropped\":0,\"events\":[]}\n"),
          std::string("{\"steps\":1,\"at\":1,\"dropped\":0,\"events\":{}}\n")}) {
        EXPECT_EQ(readText(std::string(whole).append(bad).append(next)).cuts, 1) << bad;
    }
    EXPECT_THROW(readText(""), InputError);
    EXPECT_THROW(readText("{\"kerf_journal\":2,\"name\":\"a\",\"session\":{}}\n"), InputError);
    EXPECT_THROW(readText("{\"kerf_journal\":1,\"session\":{}}\n"), InputError);
}

TEST(Journal, AnotherFileOfTheModelsNameIsNoticed) {
    const test::TemporaryFolder folder;
    writeText(folder / "a.obj", "first");
    Session session;
    session.model.path = folder / "a.obj";
    ModelHashes known;
    addHashes(session, known);
    EXPECT_EQ(session.model.sha256.size(), 64U);
    writeText(folder / "a.obj", "second");
    Session again = session;
    again.model.sha256.clear();
    addHashes(again, known);
    EXPECT_EQ(again.model.sha256, session.model.sha256) << "it is the one that was opened";
    EXPECT_THROW(loadSessionModel(session), InputError);
}

// --- Windows -----------------------------------------------------------------------------------

TEST(JournalWriter, NobodyTakesTheJournalOfAWindow) {
    const test::TemporaryFolder folder;
    {
        JournalWriter first(folder.path());
        JournalWriter second(folder.path());
        for (JournalWriter* writer : {&first, &second}) {
            writer->add([] { return journalStart("ball", sphere()); });
            writer->add([] { return journalLine(stroke(0, 0), true); });
            settle(*writer);
        }
        EXPECT_NE(first.file(), second.file());
        EXPECT_TRUE(lookForLeftWork(folder.path()).empty());
        EXPECT_EQ(filesIn(folder.path()), 2U);
    }
    const std::vector<LeftWork> left = lookForLeftWork(folder.path());
    EXPECT_EQ(left.size(), 2U);
    EXPECT_TRUE(lookForLeftWork(folder.path()).empty()) << "they are somebody's already";
}

TEST(JournalWriter, WhatWaitsIsDoneInTurnThoughOneOfThemFails) {
    const test::TemporaryFolder folder;
    std::string done;  // by the thread alone, until it ends
    {
        JournalWriter writer(folder.path());
        std::promise<void> allWait;
        writer.run([until = allWait.get_future().share()](const fs::path&) { until.wait(); });
        writer.run([&](const fs::path&) { done += "a"; });
        writer.run([](const fs::path&) { throw std::runtime_error("no room"); });
        writer.run([&](const fs::path&) { done += "b"; });
        allWait.set_value();
        writer.add([] { return journalStart("ball", sphere()); });
    }
    EXPECT_EQ(done, "ab");
}

TEST(JournalWriter, WhatIsRemovedLeavesNothing) {
    const test::TemporaryFolder folder;
    {
        JournalWriter writer(folder.path());
        writer.add([] { return journalStart("ball", sphere()); });
        settle(writer);
        writer.run([](const fs::path& journal) { writeOutputFile(pictureOf(journal), "png"); });
        settle(writer);
        EXPECT_EQ(filesIn(folder.path()), 2U);
        writer.remove();
        writer.add([] { return journalLine(stroke(0, 0), true); });
    }
    EXPECT_EQ(filesIn(folder.path()), 0U);
}

TEST(JournalWriter, WhatCannotBeWrittenIsSaidOnceWhereverItFails) {
    for (const bool lasting : {true, false}) {
        for (int n = 1; n <= 5; ++n) {
            const test::TemporaryFolder folder;
            const FileFault fault(n, ENOSPC, lasting);
            JournalWriter writer(folder.path());
            writer.add([] { return journalStart("ball", sphere()); });
            for (int i = 0; i < 3; ++i) {
                while (!writer.settled() && !fault.struck()) {
                    std::this_thread::sleep_for(std::chrono::milliseconds(1));
                }
                writer.add([i] { return journalLine(stroke(3U * i, 3 * i), true); });
            }
            std::optional<std::string> problem;
            while (!(problem = writer.takeProblem())) {
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            }
            EXPECT_THAT(*problem, HasSubstr("free some space"));
            writer.add([] { return journalLine(stroke(0, 0), true); });
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
            EXPECT_EQ(writer.takeProblem(), std::nullopt);
        }
    }
}

TEST(JournalWriter, BeyondItsLimitItGivesUpAndSaysSo) {
    const test::TemporaryFolder folder;
    JournalWriter writer(folder.path());
    writer.add([] { return std::string(kMaxJournalBytes + 1, ' '); });
    std::optional<std::string> problem;
    while (!(problem = writer.takeProblem())) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    EXPECT_THAT(*problem, HasSubstr("larger than 64 MB"));
}

TEST(JournalWriter, AFolderThatCannotBeMadeIsSaid) {
    const test::TemporaryFolder folder;
    writeText(folder / "state", "a file");
    JournalWriter writer(folder / "state/journal");
    writer.add([] { return journalStart("ball", sphere()); });
    std::optional<std::string> problem;
    while (!(problem = writer.takeProblem())) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    EXPECT_THAT(*problem, HasSubstr("not kept"));
}

// --- The folder --------------------------------------------------------------------------------

TEST(JournalFolder, WhatIsSavedIsTakenAway) {
    const test::TemporaryFolder folder;
    leave(folder.path(), false);
    const fs::path unsaved = leave(folder.path());
    const std::vector<LeftWork> left = lookForLeftWork(folder.path());
    ASSERT_EQ(left.size(), 1U);
    EXPECT_EQ(left[0].journal->file(), unsaved);
    EXPECT_EQ(left[0].picture, nullptr);
    EXPECT_EQ(filesIn(folder.path()), 1U);
    left[0].journal->remove();
    EXPECT_EQ(filesIn(folder.path()), 0U);
}

TEST(JournalFolder, OldOnesAndThoseTooManyAreTakenAway) {
    const test::TemporaryFolder folder;
    for (std::size_t i = 0; i < kMostLeftJournals + 3; ++i) {
        leave(folder.path());
    }
    EXPECT_EQ(lookForLeftWork(folder.path()).size(), kMostLeftJournals);
    EXPECT_EQ(filesIn(folder.path()), kMostLeftJournals);
    const auto old =
        fs::file_time_type::clock::now() - std::chrono::hours(24 * kDaysOfJournals + 1);
    for (const auto& entry : fs::directory_iterator(folder.path())) {
        fs::last_write_time(entry.path(), old);
    }
    EXPECT_TRUE(lookForLeftWork(folder.path()).empty());
    EXPECT_EQ(filesIn(folder.path()), 0U);
}

TEST(JournalFolder, HalvesAndLonelyPicturesAreTakenAwayAndGarbageIsLeftAlone) {
    const test::TemporaryFolder folder;
    writeText(folder / ".new.journal.part", "{");
    writeText(folder / ".old.journal.part", "{");
    fs::last_write_time(folder / ".old.journal.part",
                        fs::file_time_type::clock::now() - std::chrono::hours(2));
    writeText(folder / "lonely.png", "");
    writeText(folder / "garbage.journal", "garbage");
    writeText(folder / "mine.txt", "");
    fs::create_directory(folder / "folder.journal");
    EXPECT_TRUE(lookForLeftWork(folder.path()).empty());
    EXPECT_FALSE(fs::exists(folder / ".old.journal.part"));
    EXPECT_FALSE(fs::exists(folder / "lonely.png"));
    EXPECT_TRUE(fs::exists(folder / ".new.journal.part"));
    EXPECT_TRUE(fs::exists(folder / "garbage.journal"));
    EXPECT_TRUE(fs::exists(folder / "mine.txt"));
    EXPECT_TRUE(lookForLeftWork(folder / "missing").empty());
}

}  // namespace
}  // namespace kerf::app
