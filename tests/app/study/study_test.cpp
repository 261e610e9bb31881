#include "app/study/study.h"

#include "app/study/run_record.h"
#include "app/study/study_plots.h"

namespace kerf::app {
namespace {

class StudyFile : public testing::Test {
  protected:
    StudyFile() {
        writeText(folder_ / "a.kerf.json", sessionThatDoes(""));
        writeText(folder_ / "b.kerf.json", sessionThatDoes(""));
    }

    std::filesystem::path file() const { return folder_ / "test.sweep.json"; }
    /// A study of these sessions with more keys.
    Study read(const std::string& keys, const std::string& sessions = R"(["a.kerf.json"])") {
        writeText(file(), R"({"format": "kerf-sweep", "version": 1, "sessions": )" + sessions +
                              ", " + keys + "}");
        return readStudy(file());
    }
    /// Says what is wrong, and where.
    void expectRefused(const std::string& text, const std::string& words) {
        writeText(file(), text);
        try {
            readStudy(file());
            ADD_FAILURE() << "accepted: " << text;
        } catch (const InputError& error) {
            EXPECT_THAT(error.what(), HasSubstr("test.sweep.json: " + words));
        }
    }

    test::TemporaryFolder folder_;
};

TEST_F(StudyFile, AGridIsEveryCombinationSessionBySession) {
    const Study study = read(R"("grid": {"time_step": [0.003, 0.0050], "iterations": [4, 8]})",
                             R"(["b.kerf.json", "a.kerf.json"])");
    EXPECT_EQ(study.name, "test");
    EXPECT_THAT(study.parameters, ElementsAre("time_step", "iterations")) << "the file's order";
    ASSERT_EQ(study.runs.size(), 8u);
    std::vector<std::string> runs;
    for (const StudyRun& run : study.runs) {
        runs.push_back(study.sessionOf(run).name + " " + settingsText(run));
    }
    EXPECT_EQ(runs[0], "b.kerf.json time_step=0.003 iterations=4");
    EXPECT_EQ(runs[1], "b.kerf.json time_step=0.003 iterations=8") << "the last one varies fastest";
    EXPECT_EQ(runs[2], "b.kerf.json time_step=0.005 iterations=4");
    EXPECT_EQ(runs[4], "a.kerf.json time_step=0.003 iterations=4");
}

TEST_F(StudyFile, ListedRunsKeepWhatTheyDoNotSet) {
    const Study study = read(
        R"("runs": [{}, {"floor": null, "gravity": [0, -1, 0]}, {"solver": "pbd", "iterations": 4}])");
    EXPECT_THAT(study.parameters, ElementsAre("floor", "gravity", "solver", "iterations"));
    ASSERT_EQ(study.runs.size(), 3u);
    EXPECT_EQ(settingsText(study.runs[0]), "");
    EXPECT_EQ(settingsText(study.runs[1]), "floor=null gravity=[0, -1, 0]");
    EXPECT_EQ(settingsText(study.runs[2]), "solver=\"pbd\" iterations=4");
    EXPECT_EQ(startValue(study, study.runs[0], "iterations"), "\"auto\"");
    EXPECT_EQ(startValue(study, study.runs[0], "gravity"), "[0, 0, 0]") << "as its session has it";
    EXPECT_EQ(startValue(study, study.runs[1], "gravity"), "[0, -1, 0]");
}

TEST_F(StudyFile, KnowsTheFilesOfItsSessionsByTheirDigests) {
    test::writeText(folder_ / "cube.obj", test::objText(test::boxSoup()));
    for (const char* name : {"c", "d"}) {
        writeText(folder_ / (std::string(name) + ".kerf.json"),
                  R"({"format": "kerf-session", "version": 1, "model": {"path": "cube.obj"},
                      "steps": 1, "events": []})");
    }
    const Study study =
        read(R"("grid": {"iterations": [4]})", R"(["a.kerf.json", "c.kerf.json", "d.kerf.json"])");
    EXPECT_EQ(study.sessions[0].sha256, sha256OfFile(folder_ / "a.kerf.json"));
    EXPECT_NE(study.sessions[0].modelSha256, study.sessions[1].modelSha256);
    EXPECT_EQ(study.sessions[1].modelSha256, sha256OfFile(folder_ / "cube.obj"));
    EXPECT_EQ(study.sessions[2].modelSha256, study.sessions[1].modelSha256) << "read once";
}

TEST_F(StudyFile, ForOneRunOnlyItsSessionIsRead) {
    read(R"("grid": {"iterations": [4, 8]})", R"(["a.kerf.json", "b.kerf.json"])");
    const Study whole = readStudy(file());
    writeText(folder_ / "a.kerf.json", "{");
    const Study study = readStudyForRun(file(), 2);
    ASSERT_EQ(study.runs.size(), 4u);
    EXPECT_EQ(formatRecord({identityOf(study, study.runs[2]), 0, ""}),
              formatRecord({identityOf(whole, whole.runs[2]), 0, ""}));
    EXPECT_THROW(readStudyForRun(file(), 1), InputError);
}

TEST_F(StudyFile, WhatIsWrongIsSaidWithItsPlace) {
    const std::string head = R"({"format": "kerf-sweep", "version": 1, )";
    const std::string top = head + R"("sessions": ["a.kerf.json"], )";
    const std::vector<std::pair<std::string, std::string>> mistakes{
        {"{", "line 1, column 1: this is not valid JSON"},
        {"[]", "top level: expected an object"},
        {R"({"version": 1})", "format: this key is missing"},
        {R"({"format": "kerf-session", "version": 1})", "format: expected \"kerf-sweep\""},
        {R"({"format": "kerf-sweep", "version": 2})", "version: expected 1"},
        {top + R"("a": 1})", "top level: expected either \"grid\" or \"runs\""},
        {top + R"("grid": {"iterations": [4]}, "runs": [{}]})", "top level: expected either"},
        {top + R"("grid": {}})", "grid: it is empty"},
        {top + R"("grid": [4]})", "grid: expected an object"},
        {top + R"("grid": {"iterations": []}})", "grid.iterations: the list is empty"},
        {top + R"("grid": {"iterations": 4}})", "grid.iterations: expected a list"},
        {top + R"("grid": {"iteration": [4]}})", "grid.iteration: there is no parameter"},
        {top + R"("grid": {"iterations": [4, 61]}})",
         "grid.iterations[1]: \"iterations\" must lie"},
        {top + R"("grid": {"iterations": [{"a": 1}]}})",
         R"(grid.iterations[0]: "iterations" takes one number from 1 to 60)"},
        {top + R"("grid": {"gravity": [0, -9.81, 0]}})",
         "grid.gravity[0]: \"gravity\" takes three"},
        {top + R"("grid": {"iterations": [4], "iterations": [5]}})", "grid: the key 'iterations'"},
        {top + R"("runs": []})", "runs: the list is empty"},
        {top + R"("runs": {"iterations": [4]}})", "runs: expected a list"},
        {top + R"("runs": [4]})", "runs[0]: expected an object"},
        {top + R"("runs": [{}, {"solver": "fem"}]})", "runs[1].solver: \"solver\" must be one of"},
        {head + R"("grid": {"iterations": [4]}})", "sessions: this key is missing"},
        {head + R"("sessions": [], "runs": [{}]})", "sessions: the list is empty"},
        {head + R"("sessions": "a.kerf.json", "runs": [{}]})", "sessions: expected a list"},
        {head + R"("sessions": [3], "runs": [{}]})", "sessions[0]: expected the name of a session"},
        {head + R"("sessions": ["a.kerf.json\u0000"], "runs": [{}]})",
         "sessions[0]: no file has a zero byte"},
        {head + R"("sessions": [")" + std::string(5000, 'a') + R"("], "runs": [{}]})",
         "sessions[0]: no file has a name of more than 4095 bytes"},
        {top + R"("grid": {")" + std::string(5000, 'a') + R"(": [1]}})",
         "grid." + std::string(60, 'a') + "...: there is no parameter"},
        {head + R"("sessions": ["a.kerf.json", "c.kerf.json"], "runs": [{}]})", "sessions[1]: "},
        {head + R"("sessions": ["test.sweep.json"], "runs": [{}]})",
         "sessions[0]: test.sweep.json: format: expected \"kerf-session\""},
    };
    for (const auto& [text, words] : mistakes) {
        expectRefused(text, words);
    }
    EXPECT_THROW(readStudy(folder_ / "missing.json"), InputError);
}

TEST_F(StudyFile, ErrorsAboutNamesArePrintableAndShort) {
    const std::string head = R"({"format": "kerf-sweep", "version": 1, "runs": [{}], )";
    for (const auto& [name, words] :
         {std::pair(std::string("a\\u001bb"), std::string("/a?b: there is no such file")),
          std::pair(std::string(2000, 'a') + "/b", "..." + std::string(198, 'a') + "/b: ")}) {
        test::writeText(folder_ / "test.sweep.json",
                        std::string(head).append(R"("sessions": [")").append(name).append("\"]}"));
        try {
            readStudy(folder_ / "test.sweep.json");
            FAIL() << "it was read";
        } catch (const InputError& error) {
            EXPECT_THAT(error.what(), HasSubstr(words));
            EXPECT_LT(std::string(error.what()).size(), 600u);
        }
    }
}

/// A grid of the same number of values for each of its parameters.
std::string hugeGrid() {
    std::string values = "[0.1";
    for (int i = 0; i < 400; ++i) {
        values += ", 0.1";
    }
    values += "]";
    return R"({"friction": )" + values + R"(, "ispc_stiffness": )" + values + R"(, "air_drag": )" +
           values + R"(, "stretch_stiffness": )" + values + "}";
}

TEST_F(StudyFile, HugeGridsAreRefusedBeforeTheyAreMade) {
    expectRefused(
        R"({"format": "kerf-sweep", "version": 1, "sessions": ["a.kerf.json"], "grid": )" +
            hugeGrid() + "}",
        "grid: these are more than 100000 runs");
}

TEST_F(StudyFile, UnknownKeysAreNamed) {
    EXPECT_THAT(read(R"("runs": [{}], "author": "me")").warnings,
                ElementsAre("test.sweep.json: author: unknown key, ignored."));
}

TEST_F(StudyFile, PanelsBelowOneAnotherShareTheParameterThatVariesFastest) {
    EXPECT_EQ(panelColumns(read(R"("runs": [{}])")), 1);
    EXPECT_EQ(panelColumns(read(R"("runs": [{}, {}, {}, {}, {}])")), 4);
    EXPECT_EQ(panelColumns(read(R"("grid": {"iterations": [1, 2], "contact": [0, 1]})")), 2);
    EXPECT_EQ(panelColumns(read(R"("grid": {"iterations": [1, 2, 3, 4, 5], "contact": [0, 1]})")),
              4);
    EXPECT_EQ(panelColumns(read(R"("grid": {"iterations": [1, 2], "air_drag": [0, 1, 2, 3, 4]})")),
              5);
    EXPECT_EQ(panelColumns(read(R"("grid": {"iterations": [1, 2, 3, 4, 5, 6, 7, 8]})")), 4);
}

}  // namespace
}  // namespace kerf::app
