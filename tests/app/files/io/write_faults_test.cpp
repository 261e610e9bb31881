// The system fails at each call by which a file is written, one after the other: what was there
// stays whole, what is not done leaves nothing, and a sentence says what to do.
#include <sys/resource.h>

#include "app/files/export/export_alembic.h"
#include "app/files/io/memory_means.h"

namespace kerf::app {
namespace {

/// Full disk, quota, read-only disk, no right, vanished folder, failing disk.
constexpr int kErrors[] = {ENOSPC, EDQUOT, EROFS, EACCES, ENOENT, EIO};
constexpr int kMostCalls = 500;

/// The files below a folder, with what is in them.
std::map<std::string, std::string> contents(const fs::path& folder) {
    std::map<std::string, std::string> files;
    std::error_code none;
    for (const auto& entry : fs::recursive_directory_iterator(folder, none)) {
        if (entry.is_regular_file()) {
            files[entry.path().lexically_relative(folder)] = readBytes(entry.path());
        }
    }
    return files;
}

/// Lets the system fail at each call of `write` in turn, until it comes to its end without.
/// `write` answers with a sentence, "" where nothing went wrong.
void failAtEachCall(const std::function<std::string()>& write,
                    const std::function<void()>& afterFailure) {
    int number = 1;
    for (bool struck = true; struck && number < kMostCalls; ++number) {
        SCOPED_TRACE("call " + std::to_string(number));
        const int error = kErrors[number % std::size(kErrors)];
        const FileFault fault(number, error);
        const std::string sentence = write();
        struck = fault.struck();
        EXPECT_EQ(sentence.empty(), !struck) << sentence;
        if (struck) {
            EXPECT_THAT(sentence, HasSubstr(std::strerror(error)));
            EXPECT_THAT(sentence, HasSubstr("; ")) << "and what to do";
            afterFailure();
        }
    }
    EXPECT_GT(number, 5) << "open, write, sync, close, rename";
    EXPECT_LT(number, kMostCalls);
}

/// What an error says; "" where there is none.
template <class Error>
std::string sentenceOf(const std::function<void()>& call) {
    try {
        call();
        return "";
    } catch (const Error& error) {
        return error.what();
    }
}

std::string writeSentence(const std::function<void()>& write) {
    return sentenceOf<OutputError>(write);
}

/// A file that is there stays the old one until it is the new one.
class OldOrNew : public testing::Test {
  protected:
    void write(const std::function<void()>& writeNew) const {
        writeText(file, "old");
        const auto before = contents(folder.path());
        failAtEachCall([&] { return writeSentence(writeNew); },
                       [&] { EXPECT_EQ(contents(folder.path()), before); });
    }

    const test::TemporaryFolder folder;
    const fs::path file = folder / "a";
};

TEST_F(OldOrNew, IsAFile) {
    const std::string large(300'000, 'x');
    write([&] { writeOutputFile(file, large); });
    EXPECT_EQ(readBytes(file), large);
}

TEST_F(OldOrNew, IsAPicture) {
    const render::Image picture{64, 64, std::vector<std::uint8_t>(4 * 64 * 64, 99)};
    write([&] { writePicture(picture, file); });
    EXPECT_EQ(readPicture(file).pixels, picture.pixels);
}

TEST_F(OldOrNew, IsACache) {
    const SurfaceMesh box = test::box(Vec3::Ones(), 12);
    const ExportMesh mesh = gatherMesh(box, findPieces(box), {});
    write([&] {
        AlembicCache cache(file, "box", Vec3::Zero());
        for (int sample = 0; sample < 3; ++sample) {
            cache.add(sample, mesh, true);
        }
        cache.finish();
    });
    EXPECT_EQ(readBytes(file).substr(0, 6), "Ogawa\xFF");
}

TEST(WriteFaults, ADeviceAFolderAndALongNameAreRefused) {
    const test::TemporaryFolder folder;
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    EXPECT_THROW(writeOutputFile("/dev/full", "x"), OutputError);
    EXPECT_THROW(writeOutputFile(folder / "pipe", "x"), OutputError);
    EXPECT_THROW(writeOutputFile(folder.path(), "x"), OutputError);
    EXPECT_THAT(writeSentence([&] { writeOutputFile(folder / std::string(300, 'a'), "x"); }),
                HasSubstr("choose a shorter name"));
}

TEST(WriteFaults, SettingsStayAsTheyWere) {
    const test::TemporaryFolder folder;
    ui::Settings wide;
    wide.controlsWidth = 400;
    writeText(folder / "settings.json", formatSettings(wide));
    const auto before = contents(folder.path());
    failAtEachCall(
        [&] {
            SettingsFile settings(folder / "settings.json");
            settings.now.uiScale = 2;
            std::string sentence = settings.save();
            EXPECT_EQ(settings.now.uiScale, 2);
            return sentence;
        },
        [&] { EXPECT_EQ(contents(folder.path()), before); });
    EXPECT_EQ(SettingsFile(folder / "settings.json").now.uiScale, 2);
}

TEST(WriteFaults, TheListOfRecentFilesStaysWhole) {
    const test::TemporaryFolder folder;
    writeText(folder / "model.obj", "");
    RecentFiles(folder / "recent").add(folder / "model.obj");
    const auto before = contents(folder.path());
    for (int number = 1; number <= 5; ++number) {
        const FileFault fault(number, ENOSPC);
        RecentFiles(folder / "recent").add(folder / "other.obj");
        EXPECT_EQ(contents(folder.path()), before) << number;
    }
}

using WriteFaultsInReplays = GlTest;

// A run that is not done has no summary, and nothing of it is cut off.
TEST_F(WriteFaultsInReplays, EveryFileIsWholeOrNotThere) {
    const test::TemporaryFolder folder;
    writeText(folder / "a.kerf.json", sessionThatDoes(R"(
        {"step": 1, "type": "screenshot", "file": "a.png", "width": 32, "height": 32},
        {"step": 2, "type": "export", "file": "a.obj"},
        {"step": 3, "type": "export", "file": "pieces.ply", "per_piece": true})"));
    const Session session = readSession(folder / "a.kerf.json");
    const ModelMesh model = loadSessionModel(session);
    ReplayOptions options;
    options.hashes = options.pieces = true;
    const auto replay = [&](const std::string& out) {
        return writeSentence([&] { replaySession(session, model, folder / out, {}, options); });
    };
    ASSERT_EQ(replay("whole"), "");
    const auto whole = contents(folder / "whole");
    failAtEachCall([&] { return replay("out"); },
                   [&] {
                       for (const auto& [name, bytes] : contents(folder / "out")) {
                           EXPECT_TRUE(whole.contains(name)) << name;
                           EXPECT_NE(name, kSummaryFile);
                           if (name != kMetricsFile) {  // it has times
                               EXPECT_EQ(bytes, whole.at(name)) << name;
                           }
                       }
                   });
    EXPECT_EQ(contents(folder / "out").size(), whole.size());
}

class WriteFaultsInTheEditor : public EditorTest {
  protected:
    /// Saves by keys under a name that is there already, and answers with what is said of it.
    std::string writeByKeys(Key key, const std::string& name) {
        tap(key, {.control = true}, 2);
        type(name);
        tap(Key::enter, 2);
        if (panels().files.asksToOverwrite) {
            click("file.accept");
        }
        waitForWork();
        return panels().toast.isError ? panels().toast.text : "";
    }
    void expectFailuresToLeaveAllAsItWas(Key key, const std::string& name) {
        dragAndSettle(kTop, kBottom, 10);
        ASSERT_EQ(writeByKeys(key, name), "");
        auto before = contents(folder.path());
        ASSERT_FALSE(before.empty());
        const std::string hash = editor->scene()->simulation().stateHash();
        failAtEachCall([&] { return writeByKeys(key, name); },
                       [&] {
                           EXPECT_EQ(contents(folder.path()), before);
                           EXPECT_EQ(editor->scene()->simulation().stateHash(), hash);
                       });
    }
};

TEST_F(WriteFaultsInTheEditor, ASessionThatCannotBeSavedLeavesTheOldOneAndTheWork) {
    expectFailuresToLeaveAllAsItWas(Key::s, "work");
}

TEST_F(WriteFaultsInTheEditor, AnExportThatCannotBeWrittenLeavesTheOldOneAndTheWork) {
    expectFailuresToLeaveAllAsItWas(Key::e, "work.ply");
}

// What memory there is, and what is said where it does not do.

constexpr const char* kBytes = "KERF_MEMORY_BYTES";

std::string sentenceBy(const std::function<void()>& call) {
    return sentenceOf<MemoryShortage>(call);
}

TEST(MemoryMeans, AVariableStandsForTheMachine) {
    const std::uint64_t free = freeMemory();
    EXPECT_GT(free, 10'000'000U);
    const Variable variable(kBytes, "1000000");
    EXPECT_EQ(freeMemory(), 1'000'000U);
    for (const char* wrong : {"1GB", "x", "", "-1"}) {
        const Variable other(kBytes, wrong);
        EXPECT_GT(freeMemory(), 10'000'000U) << wrong;
    }
}

TEST(MemoryMeans, AnswersToTheLimitsOfTheProcess) {
    rlimit before{};
    ASSERT_EQ(::getrlimit(RLIMIT_DATA, &before), 0);
    rlimit limit = before;
    limit.rlim_cur = 64ULL << 30;
    const std::uint64_t free = freeMemory();
    if (::setrlimit(RLIMIT_DATA, &limit) != 0) {
        GTEST_SKIP() << "this process may not limit itself";
    }
    EXPECT_LE(freeMemory(), 64ULL << 30);
    limit.rlim_cur = 1ULL << 30;
    ASSERT_EQ(::setrlimit(RLIMIT_DATA, &limit), 0);
    EXPECT_LE(freeMemory(), 1ULL << 30);
    ASSERT_EQ(::setrlimit(RLIMIT_DATA, &before), 0);
    EXPECT_NEAR(static_cast<double>(freeMemory()) / static_cast<double>(free), 1, 0.5);
}

TEST(MemoryMeans, NothingIsSaidWhereItDoes) {
    const MemoryNeed need{.memory = 10, .program = 5, .graphics = 3, .largestBuffer = 2};
    EXPECT_EQ(sentenceBy([&] { requireMemory("a", need, {}); }), "");
    EXPECT_EQ(sentenceBy([&] { requireMemory("a", need, {.free = 15}); }), "");
    EXPECT_NE(sentenceBy([&] { requireMemory("a", need, {.free = 14}); }), "");
    EXPECT_EQ(sentenceBy([&] { requireMemory("a", need, {.free = 14, .programRuns = true}); }), "");
    EXPECT_NE(sentenceBy([&] { requireMemory("a", need, {.free = 15, .holdsGraphics = true}); }),
              "");
    EXPECT_NE(sentenceBy([&] { requireMemory("a", need, {.largestBuffer = 1}); }), "");
}

TEST(MemoryMeans, OneSentenceSaysHowMuchAndWhatToDo) {
    const MemoryNeed need{.memory = 3'400'000'000, .graphics = 1, .largestBuffer = 150'000'000};
    const std::string memory =
        sentenceBy([&] { requireMemory("bunny.ply", need, {.free = 210'000'000}); });
    EXPECT_THAT(memory, HasSubstr("bunny.ply: cutting it needs about 3.4 GB of memory"));
    EXPECT_THAT(memory, HasSubstr("210 MB are free"));
    EXPECT_THAT(memory, HasSubstr("--remesh"));
    const std::string buffer =
        sentenceBy([&] { requireMemory("bunny.ply", need, {.largestBuffer = 134'217'728}); });
    EXPECT_THAT(buffer, HasSubstr("a graphics buffer of 150 MB"));
    EXPECT_THAT(buffer, HasSubstr("134 MB"));
}

}  // namespace
}  // namespace kerf::app
