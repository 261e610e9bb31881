#include "app/files/io/system_file.h"

namespace kerf::app {
namespace {

/// A text in which the first of `what` is replaced.
std::string replaced(std::string text, const std::string& what, const std::string& with) {
    const std::size_t place = text.find(what);
    EXPECT_NE(place, std::string::npos) << what;
    return text.replace(place, what.size(), with);
}

class TestVerb : public testing::Test {
  protected:
    TestVerb() { writeText(session_, smallSession()); }

    ProgramRun run(const std::vector<std::string>& options = {},
                   const std::map<std::string, std::string>& environment = {}) {
        std::vector<std::string> words{"test", folder_.path()};
        words.insert(words.end(), options.begin(), options.end());
        return runKerf(words, environment);
    }
    void makeExpectation() { ASSERT_EQ(run({"--update"}).exitCode, 0); }
    fs::path expected(const std::string& name) { return folder_ / ("ball.expected/" + name); }
    /// What another driver would have had of a part after the first step.
    void changeHashes(const std::string& part) {
        const std::string table = readBytes(expected("hashes.csv"));
        const std::string header = table.substr(0, table.find(part));
        std::size_t place = table.find('\n') + 1;
        for (auto commas = std::ranges::count(header, ','); commas > 0; --commas) {
            place = table.find(',', place) + 1;
        }
        const std::string hash = table.substr(place, 16);
        writeText(expected("hashes.csv"),
                  replaced(table, hash, std::string(hash.rbegin(), hash.rend())));
    }
    /// Fails once, with these words.
    void expectFailure(const std::string& words) {
        const ProgramRun failed = run();
        EXPECT_EQ(failed.exitCode, 1) << failed.out << failed.errors;
        EXPECT_THAT(failed.out, HasSubstr(words));
        EXPECT_THAT(failed.out, HasSubstr("1 test, 1 failed"));
    }

    test::TemporaryFolder folder_;
    fs::path session_ = folder_ / "ball.kerf.json";
};

TEST_F(TestVerb, WithoutExpectationsNothingIsRunAndItSaysHowToMakeThem) {
    expectFailure("make it with kerf test --update " + session_.string());
    EXPECT_FALSE(fs::exists(folder_ / "ball.expected"));
    const std::map<std::string, std::string> withoutGl{{"KERF_FORCE_NO_GL", "1"}};
    EXPECT_EQ(run({}, withoutGl).exitCode, 1);
    makeExpectation();
    EXPECT_EQ(run({}, withoutGl).exitCode, 4);
}

TEST_F(TestVerb, WhatWasMadeHoldsWhateverTheNumberOfThreads) {
    const ProgramRun made = run({"--update"});
    EXPECT_EQ(made.exitCode, 0) << made.out << made.errors;
    EXPECT_THAT(made.out, HasSubstr("made "));
    for (const char* file : {"expected.json", "hashes.csv", "course.csv", "pieces.csv", "end.png",
                             "pictures/half.png"}) {
        EXPECT_TRUE(fs::exists(expected(file))) << file;
    }
    for (const char* threads : {"0", "1", "2"}) {
        const ProgramRun again = run({}, {{"LP_NUM_THREADS", threads}});
        EXPECT_EQ(again.exitCode, 0) << again.out << again.errors;
        EXPECT_THAT(again.out, HasSubstr("passed "));
    }
    const std::string before = readBytes(expected("expected.json"));
    const ProgramRun same = run({"--update"});
    EXPECT_THAT(same.out, HasSubstr("passed ")) << "nothing to renew";
    EXPECT_EQ(readBytes(expected("expected.json")), before);
}

TEST_F(TestVerb, UpdateMendsWhatIsDamaged) {
    makeExpectation();
    const std::string hashes = readBytes(expected("hashes.csv"));
    const std::string course = readBytes(expected("course.csv"));
    writeText(expected("hashes.csv"), hashes.substr(0, hashes.find('\n', 200) + 1));
    EXPECT_EQ(run().exitCode, 3);
    EXPECT_THAT(run({"--update"}).out, HasSubstr("renewed "));
    EXPECT_EQ(readBytes(expected("hashes.csv")), hashes);
    fs::remove(expected("course.csv"));
    writeText(expected("end.png"), "no picture");
    EXPECT_EQ(run().exitCode, 3);
    EXPECT_THAT(run({"--update"}).out, HasSubstr("renewed "));
    EXPECT_EQ(readBytes(expected("course.csv")), course);
    EXPECT_EQ(run().exitCode, 0);
}

TEST_F(TestVerb, ResultsAndReportsTakeNobodysPlace) {
    makeExpectation();
    const ProgramRun inside = run({"--out", expected("runs").string()});
    expectEnd(inside, 2, "holds what a test expects");
    writeText(folder_ / "m.obj", "o");
    writeText(folder_ / "other.kerf.json",
              R"({"format": "kerf-session", "version": 1, "model": {"path": "m.obj"},
                  "steps": 2})");
    const ProgramRun over = run({"--junit", (folder_ / "m.obj").string()});
    expectEnd(over, 2, "m.obj: the tests read this file");
    EXPECT_EQ(readBytes(folder_ / "m.obj"), "o");
}

TEST_F(TestVerb, OneOutHasOneCallAtATime) {
    makeExpectation();
    fs::create_directories(folder_ / "runs");
    const FolderLock held(folder_ / "runs");
    const ProgramRun second = run({"--out", (folder_ / "runs").string()});
    expectEnd(second, 5, "another run writes its results there");
}

TEST_F(TestVerb, WithoutMemoryItIsNoFailureOfTheTest) {
    makeExpectation();
    const ProgramRun starved = run({}, {{"KERF_MEMORY_BYTES", "1000000"}});
    EXPECT_EQ(starved.exitCode, 5) << starved.out;
    EXPECT_THAT(starved.out, HasSubstr("unwritable "));
}

TEST_F(TestVerb, NamesTheStepThePartAndHowFar) {
    makeExpectation();
    const std::string session = smallSession();
    writeText(session_, replaced(session, "\"iterations\": 8", "\"iterations\": 9"));
    expectFailure("Step 0: parameters differ, from step ");
    writeText(session_, replaced(session, "[0, -9.81, 0]", "[0, -9.7, 0]"));
    expectFailure("Step 16: positions, velocities and parameters differ; at most ");
    writeText(session_, replaced(session, "0.62, 0.02", "0.62, 0.04"));
    expectFailure("Step 1: blade differs, from step ");
    writeText(session_, replaced(session, "\"steps\": 40", "\"steps\": 44"));
    expectFailure("44 steps instead of 40");
    expectFailure("To make it small: kerf reduce " + session_.string() + " --out reduced -- sh");
}

TEST_F(TestVerb, SeesAPictureAloneAndLeavesOutWhatIsMasked) {
    makeExpectation();
    render::Image picture = render::readPng(expected("end.png"));
    for (int y = 0; y < 20; ++y) {
        for (int x = 0; x < 80; ++x) {
            picture.pixels[std::size_t(4) * (std::size_t(y) * 96 + std::size_t(x))] ^= 0x80;
        }
    }
    writePng(picture, expected("end.png"));
    expectFailure("The picture end.png differs in ");
    const std::string text = readBytes(expected("expected.json"));
    writeText(expected("expected.json"),
              replaced(text, "\"end.png\": {}", "\"end.png\": {\"masks\": [[0, 0, 80, 20]]}"));
    EXPECT_EQ(run().exitCode, 0);
    writeText(session_, replaced(smallSession(), "\"iterations\": 8", "\"iterations\": 9"));
    const ProgramRun renewed = run({"--update"});
    EXPECT_EQ(renewed.exitCode, 0);
    EXPECT_THAT(renewed.out, HasSubstr("renewed "));
    EXPECT_THAT(renewed.out, HasSubstr("Step 0: ")) << "what has changed is listed";
    EXPECT_THAT(readBytes(expected("expected.json")), HasSubstr("masks"));
    EXPECT_EQ(run().exitCode, 0);
}

TEST_F(TestVerb, APictureTooManyOrTooFewIsNoticed) {
    makeExpectation();
    const std::string shot = R"({"step": 40, "type": "screenshot", "file": "end.png")";
    writeText(session_, replaced(smallSession(), shot, replaced(shot, "end.png", "last.png")));
    const ProgramRun other = run();
    EXPECT_EQ(other.exitCode, 1);
    EXPECT_THAT(other.out, HasSubstr("The run made no picture end.png any more."));
    EXPECT_THAT(other.out, HasSubstr("The picture last.png has no expectation"));
    EXPECT_EQ(run({"--update"}).exitCode, 0);
    EXPECT_FALSE(fs::exists(expected("end.png")));
    EXPECT_EQ(run().exitCode, 0);
}

TEST_F(TestVerb, AnOldPictureThatNothingListsIsNoticedAndRemoved) {
    makeExpectation();
    writeText(expected("pictures/old.png"), "old");
    expectFailure("The picture pictures/old.png is not listed in expected.json");
    EXPECT_EQ(run({"--update"}).exitCode, 0);
    EXPECT_FALSE(fs::exists(expected("pictures/old.png")));
    EXPECT_TRUE(fs::exists(expected("pictures/half.png")));
    EXPECT_EQ(run().exitCode, 0);
}

TEST_F(TestVerb, FindingsSayWhereTheyAreToProgramsToo) {
    makeExpectation();
    const std::string more = R"(, {"step": 30, "type": "check", "pieces": 5})";
    writeText(session_, replaced(smallSession(more), "\"end.png\", \"width\": 96",
                                 "\"end.png\", \"width\": 48"));
    const auto findings = Json::parse(run({"--json"}).out)["tests"][0]["findings"];
    ASSERT_EQ(findings.size(), 2u) << findings;
    EXPECT_EQ(findings[0]["part"], "check");
    EXPECT_EQ(findings[0]["step"], 30);
    EXPECT_EQ(findings[0]["file"], nullptr);
    EXPECT_EQ(findings[1]["step"], 40);
    EXPECT_EQ(findings[1]["file"], "end.png");
    EXPECT_EQ(findings[1]["sentence"], "The picture end.png has 48x64 pixels instead of 96x64.");
}

TEST_F(TestVerb, OnAnotherDriverItJudgesByToleranceAndSaysSo) {
    makeExpectation();
    const std::string text = readBytes(expected("expected.json"));
    writeText(expected("expected.json"), replaced(text, "\"driver\": \"", "\"driver\": \"Other "));
    changeHashes("positions");
    const ProgramRun near = run();
    EXPECT_EQ(near.exitCode, 0) << near.out;
    EXPECT_THAT(near.out, HasSubstr("[another driver: by tolerance]"));
    writeText(session_, replaced(smallSession(), "[0, -9.81, 0]", "[60, -9.81, 0]"));
    const ProgramRun far = run();
    EXPECT_EQ(far.exitCode, 1) << far.out;
    EXPECT_THAT(far.out, HasSubstr("are allowed on another driver"));
}

TEST_F(TestVerb, HowFarPicturesOfAnotherDriverMayBeOffCanBeSet) {
    makeExpectation();
    render::Image picture = render::readPng(expected("end.png"));
    for (std::size_t i = 0; i < picture.pixels.size() / 4; i += 4) {
        picture.pixels[i] ^= 0x80;
    }
    writePng(picture, expected("end.png"));
    const std::string text =
        replaced(readBytes(expected("expected.json")), "\"driver\": \"", "\"driver\": \"Other ");
    writeText(expected("expected.json"), text);
    expectFailure("The picture end.png differs in ");
    writeText(expected("expected.json"),
              replaced(replaced(text, "\"pixels\": 0.05", "\"pixels\": 0.6"), "\"worst\": 0.45",
                       "\"worst\": 1"));
    EXPECT_EQ(run().exitCode, 0);
}

TEST_F(TestVerb, WhatGoesIntoARunIsTheSameOnEachDriver) {
    makeExpectation();
    const std::string text = readBytes(expected("expected.json"));
    writeText(expected("expected.json"), replaced(text, "\"driver\": \"", "\"driver\": \"Other "));
    writeText(session_, replaced(smallSession(), "[0, -9.81, 0]", "[0, -9.8100001, 0]"));
    expectFailure("Step 16: parameters differ.");
    writeText(session_, replaced(smallSession(), "0.62, 0.02", "0.62, 0.021"));
    expectFailure("Step 1: blade differs.");
}

TEST_F(TestVerb, WhatIsNotOffIsNotTold) {
    makeExpectation();
    changeHashes("velocities");
    expectFailure("Step 0: velocities differ.");
}

TEST_F(TestVerb, MasksThatHideAWholePictureHoldNothing) {
    makeExpectation();
    const std::string text = readBytes(expected("expected.json"));
    writeText(expected("expected.json"),
              replaced(text, "\"end.png\": {}", "\"end.png\": {\"masks\": [[0, 0, 96, 64]]}"));
    expectFailure("The masks leave nothing of the picture end.png to compare.");
}

TEST_F(TestVerb, AReportTakesThePlaceOfNothingThatTheTestsRead) {
    makeExpectation();
    const fs::path read = expected("expected.json");
    const std::string before = readBytes(read);
    EXPECT_EQ(run({"--report", read}).exitCode, 2);
    EXPECT_EQ(run({"--junit", session_}).exitCode, 2);
    EXPECT_EQ(run({"--junit", folder_ / "a.xml", "--report", folder_ / "a.xml"}).exitCode, 2);
    EXPECT_EQ(readBytes(read), before);
    EXPECT_EQ(readBytes(session_), smallSession());
    EXPECT_EQ(runKerf({"replay", session_, "--out", read.parent_path()}).exitCode, 2);
    EXPECT_TRUE(fs::exists(expected("hashes.csv")));
}

TEST_F(TestVerb, AReportThatCannotBeWrittenIsToldBeforeAnythingRuns) {
    const ProgramRun refused = run({"--update", "--junit", folder_ / "ball.kerf.json/a.xml"});
    EXPECT_EQ(refused.exitCode, 5) << refused.out;
    EXPECT_EQ(refused.out, "");
    EXPECT_FALSE(fs::exists(folder_ / "ball.expected"));
}

TEST_F(TestVerb, AFailedCheckOfTheSessionIsNeverAnExpectation) {
    writeText(session_, smallSession(R"(, {"step": 20, "type": "check", "pieces": 5})"));
    const ProgramRun made = run({"--update"});
    EXPECT_EQ(made.exitCode, 1);
    EXPECT_THAT(made.out, HasSubstr("where the session expects 5"));
    EXPECT_THAT(made.out, HasSubstr("nothing was written"));
    EXPECT_THAT(made.out, HasSubstr(" --out reduced -- kerf replay {} --no-hash-checks"));
    EXPECT_FALSE(fs::exists(folder_ / "ball.expected"));
}

// The editor records state hashes as checks. They would hold a test to what it was for ever.
TEST_F(TestVerb, OldHashesInTheSessionsOwnChecksStandInNoWay) {
    const std::string hash(16, '0');
    writeText(session_, smallSession(R"(, {"step": 20, "type": "check", "hash": ")" + hash +
                                     R"("}, {"step": 20, "type": "check", "pieces": 2})"));
    const ProgramRun made = run({"--update"});
    EXPECT_EQ(made.exitCode, 0) << made.out;
    EXPECT_THAT(made.out,
                HasSubstr("kerf replay will fail: the session's own check before step 20"));
    EXPECT_EQ(run().exitCode, 0);
}

TEST_F(TestVerb, ATableCutShortIsNoExpectation) {
    makeExpectation();
    for (const char* name : {"hashes.csv", "course.csv", "pieces.csv"}) {
        const std::string whole = readBytes(expected(name));
        writeText(expected(name), whole.substr(0, whole.find('\n', whole.size() / 2) + 1));
        const ProgramRun cut = run();
        EXPECT_EQ(cut.exitCode, 3) << name;
        EXPECT_THAT(cut.out, HasSubstr("steps where expected.json says 40"));
        writeText(expected(name), whole);
    }
    EXPECT_EQ(run().exitCode, 0);
}

TEST_F(TestVerb, AnUnknownKeyHoldsNothingSoItIsRefused) {
    makeExpectation();
    const std::string text = readBytes(expected("expected.json"));
    writeText(expected("expected.json"),
              replaced(text, "\"end.png\": {}", "\"end.png\": {\"mask\": [[0, 0, 80, 20]]}"));
    const ProgramRun typo = run({"--update"});
    EXPECT_EQ(typo.exitCode, 3);
    EXPECT_THAT(typo.out, HasSubstr("pictures, end.png, mask: there is no such key"));
}

TEST_F(TestVerb, ADeletedPictureIsNamedAndMadeAnew) {
    makeExpectation();
    fs::remove(expected("end.png"));
    expectFailure("The picture end.png has no expectation; kerf test --update makes it.");
    EXPECT_EQ(run({"--update"}).exitCode, 0);
    EXPECT_EQ(run().exitCode, 0);
}

TEST_F(TestVerb, ASessionThatIsNamedTwiceIsRunOnce) {
    const std::string other = (folder_ / "../").string() +
                              fs::path(folder_.path()).filename().string() + "/ball.kerf.json";
    EXPECT_THAT(run({other, session_.string()}).out, HasSubstr("1 test, 1 failed"));
}

TEST_F(TestVerb, WhatCannotBeReadIsSaidAndTheOthersAreRun) {
    makeExpectation();
    fs::create_directory(folder_ / "deeper");
    writeText(folder_ / "deeper/broken.kerf.json", "{");
    const ProgramRun mixed = run();
    EXPECT_EQ(mixed.exitCode, 3) << mixed.out;
    EXPECT_THAT(mixed.out, HasSubstr("unreadable "));
    EXPECT_THAT(mixed.out, HasSubstr("passed "));
    fs::remove(folder_ / "deeper/broken.kerf.json");
    writeText(expected("expected.json"), "{}");
    EXPECT_EQ(run().exitCode, 3);
    EXPECT_EQ(runKerf({"test", folder_ / "missing"}).exitCode, 3);
    EXPECT_EQ(runKerf({"test", folder_ / "deeper"}).exitCode, 3) << "a folder without tests";
    EXPECT_EQ(runKerf({"test"}).exitCode, 2);
    EXPECT_EQ(runKerf({"test", folder_.path(), "--jobs", "0"}).exitCode, 2);
}

TEST_F(TestVerb, AFileThatCannotBeReachedIsToldOfItsTestAlone) {
    makeExpectation();
    for (const char* name : {"loop", "locked"}) {
        writeText(folder_ / (std::string(name) + ".kerf.json"), smallSession());
    }
    fs::create_symlink("loop.expected", folder_ / "loop.expected");
    fs::create_symlink("nowhere", folder_ / "dangling.kerf.json");
    const ProgramRun mixed = run();
    EXPECT_EQ(mixed.exitCode, 3);
    EXPECT_THAT(mixed.out, HasSubstr("passed "));
    EXPECT_THAT(mixed.out, HasSubstr("loop.expected/expected.json: it can't be read (Too many"));
    EXPECT_THAT(mixed.out, HasSubstr("dangling.kerf.json: there is no such file"));
    EXPECT_THAT(mixed.out, HasSubstr("locked.expected/expected.json; make it with"));
}

TEST_F(TestVerb, FoldersThatMayNotBeReadAreToldAndTheOthersAreRun) {
    if (::geteuid() == 0) {
        GTEST_SKIP() << "root may read all";
    }
    makeExpectation();
    writeText(folder_ / "locked.kerf.json", smallSession());
    for (const char* folder : {"locked.expected", "deeper"}) {
        fs::create_directory(folder_ / folder);
        fs::permissions(folder_ / folder, fs::perms::none);
    }
    const ProgramRun mixed = run();
    for (const char* folder : {"locked.expected", "deeper"}) {
        fs::permissions(folder_ / folder, fs::perms::owner_all);
    }
    EXPECT_EQ(mixed.exitCode, 3);
    EXPECT_THAT(mixed.out, HasSubstr("passed "));
    EXPECT_THAT(mixed.out, HasSubstr("deeper: this folder can't be searched"));
    EXPECT_THAT(mixed.out,
                HasSubstr("locked.expected/expected.json: it can't be read (Permission"));
}

TEST_F(TestVerb, AnExpectationThatCannotBeWrittenKeepsNoOtherFromIt) {
    writeText(folder_ / "a.kerf.json", sessionThatDoes(""));
    writeText(folder_ / "a.expected", "mine");
    const ProgramRun made = run({"--update", "--jobs", "1"});
    EXPECT_EQ(made.exitCode, 5);
    EXPECT_THAT(made.out, HasSubstr("unwritable " + (folder_ / "a").string()));
    EXPECT_THAT(made.out, HasSubstr("a.expected: a file stands where a folder should be."));
    EXPECT_THAT(made.out, HasSubstr("made "));
    EXPECT_THAT(made.out, HasSubstr("2 tests, 1 failed"));
    EXPECT_EQ(readBytes(folder_ / "a.expected"), "mine");
}

TEST_F(TestVerb, EachPathMustLeadToATestAndHiddenFoldersAreNotSearched) {
    makeExpectation();
    fs::create_directory(folder_ / ".git");
    fs::create_directory(folder_ / "empty");
    writeText(folder_ / ".git/old.kerf.json", "{");
    EXPECT_EQ(run().exitCode, 0);
    const ProgramRun both = run({folder_ / "empty"});
    expectEnd(both, 3, "empty: there is no session (*.kerf.json) in this folder.");
    EXPECT_EQ(both.out, "");
}

TEST_F(TestVerb, AnExpectationReachesNoFileElsewhere) {
    makeExpectation();
    writeText(folder_ / "precious.png", "mine");
    const std::string text = readBytes(expected("expected.json"));
    writeText(expected("expected.json"), replaced(text, "\"end.png\"", "\"../precious.png\""));
    EXPECT_EQ(run({"--update"}).exitCode, 3);
    EXPECT_EQ(readBytes(folder_ / "precious.png"), "mine");
}

TEST_F(TestVerb, ReportsForProgramsAndPeople) {
    makeExpectation();
    writeText(folder_ / "a<b>&.kerf.json", sessionThatDoes(""));
    const ProgramRun both = run({"--json", "--junit", folder_ / "new/junit.xml", "--report",
                                 folder_ / "report.html", "--jobs", "2"});
    EXPECT_EQ(both.exitCode, 1);
    const auto json = Json::parse(both.out);
    EXPECT_EQ(json["passed"], 1);
    EXPECT_EQ(json["failed"], 1);
    ASSERT_EQ(json["tests"].size(), 2u);
    EXPECT_EQ(json["tests"][0]["status"], "failed") << "in the order of their names";
    EXPECT_EQ(json["tests"][0]["findings"][0]["part"], "expectation");
    const std::string junit = readBytes(folder_ / "new/junit.xml");
    EXPECT_THAT(junit, HasSubstr(R"(tests="2" failures="1" errors="0")"));
    EXPECT_THAT(junit, HasSubstr("a&lt;b&gt;&amp;"));
    const std::string page = readBytes(folder_ / "report.html");
    EXPECT_THAT(page, HasSubstr("data:image/png;base64,iVBOR"));
    EXPECT_THAT(page, Not(HasSubstr("a<b>"))) << "nothing ends the script";
    EXPECT_THAT(page, HasSubstr("a\\u003cb>&"));
}

TEST_F(TestVerb, NamesThatAreNoTextLeaveTheReportsWhole) {
    writeText(folder_ / "a\xff\x1b[31m\xEF\xBF\xBE.kerf.json", sessionThatDoes(""));
    const ProgramRun ran = run({"--junit", folder_ / "junit.xml"});
    EXPECT_THAT(ran.out, Not(HasSubstr("\x1b")));
    const std::string junit = readBytes(folder_ / "junit.xml");
    EXPECT_THAT(junit, HasSubstr("a\xEF\xBF\xBD [31m\xEF\xBF\xBD"));
    EXPECT_THAT(junit, Not(HasSubstr("\xff")));
}

// As a CI server does that has had enough of it.
TEST_F(TestVerb, AStoppedRunIsNoSuccessToAnybody) {
    makeExpectation();
    for (const char* other : {"c", "d", "e"}) {
        fs::copy(session_, folder_ / (std::string(other) + ".kerf.json"));
        fs::copy(folder_ / "ball.expected", folder_ / (std::string(other) + ".expected"),
                 fs::copy_options::recursive);
    }
    const std::string at = folder_.path().string();
    const std::string script = "cd '" + at +
                               "'; '" KERF_BINARY_DIR
                               "/kerf' test . --jobs 1 --json --junit st.xml --out runs "
                               "> st.json 2> st.log & tests=$!\n"
                               "while [ ! -e runs/0-ball ] && kill -0 $tests; do sleep 0.01; done\n"
                               "kill -TERM $tests; wait $tests";
    EXPECT_EQ(WEXITSTATUS(std::system(script.c_str())), 1);
    const auto json = Json::parse(readBytes(folder_ / "st.json"));
    EXPECT_EQ(json["stopped"], true);
    EXPECT_EQ(json["passed"], 1);
    EXPECT_EQ(json["not_run"], 3);
    EXPECT_EQ(json["tests"][3]["status"], "not run");
    const std::string junit = readBytes(folder_ / "st.xml");
    EXPECT_THAT(junit, HasSubstr(R"(tests="4" failures="0" errors="0" skipped="3")"));
    EXPECT_THAT(junit, HasSubstr("<skipped message=\"It was not run"));
    EXPECT_THAT(readBytes(folder_ / "st.log"), HasSubstr("Stopped: 3 of 4 tests were not run."));
}

}  // namespace
}  // namespace kerf::app
