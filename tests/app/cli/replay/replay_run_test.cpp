#include <gtest/gtest.h>
#include <sys/stat.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/support/run_kerf.h"
#include "tests/support/shapes.h"
#include "tests/support/small_sessions.h"
#include "tests/support/temporary_folder.h"

namespace kerf {
namespace {

using test::ProgramRun;
using test::readBytes;
using test::runKerf;
using test::sessionThatDoes;
using test::smallSession;
using test::TemporaryFolder;
using test::writeText;

ProgramRun replay(const TemporaryFolder& folder, const std::string& session, const std::string& out,
                  const std::map<std::string, std::string>& environment = {}) {
    writeText(folder / "test.kerf.json", session);
    return runKerf({"replay", folder / "test.kerf.json", "--out", folder / out, "--json"},
                   environment);
}

std::set<std::string> filesBelow(const std::filesystem::path& folder) {
    std::set<std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file()) {
            files.insert(entry.path().lexically_relative(folder).generic_string());
        }
    }
    return files;
}

/// metrics.csv without the columns of wall-clock time: milliseconds, and the real-time factor.
std::string withoutTimes(const std::string& metrics) {
    std::istringstream lines(metrics);
    std::vector<bool> kept;
    std::string text;
    for (std::string line; std::getline(lines, line); text += "\n") {
        std::istringstream cells(line);
        std::size_t column = 0;
        for (std::string cell; std::getline(cells, cell, ','); ++column) {
            if (column == kept.size()) {  // the header
                kept.push_back(!cell.ends_with("_ms") && cell != "real_time_factor");
            }
            text += kept[column] ? cell + "," : "";
        }
    }
    return text;
}

TEST(Replay, WritesWhatTheContractSaysAndNothingElse) {
    const TemporaryFolder folder;
    const ProgramRun run = replay(folder, smallSession(), "out");
    ASSERT_EQ(run.exitCode, 0) << run.errors;
    EXPECT_EQ(filesBelow(folder / "out"),
              (std::set<std::string>{"end.mtl", "end.obj", "end.png", "final.ply", "metrics.csv",
                                     "pictures/half.png", "summary.json"}));
    EXPECT_EQ(filesBelow(folder.path()).size(), 8u) << "the session, and nothing beside DIR";
    const auto printed = nlohmann::json::parse(run.out);
    const auto summary = nlohmann::json::parse(readBytes(folder / "out/summary.json"));
    EXPECT_EQ(printed["state_hash"], summary["state_hash"]);
    EXPECT_EQ(summary["steps"], 40);
    EXPECT_EQ(summary["before"]["triangles"], 80);
    EXPECT_EQ(summary["pieces"].size(), 2u);
    EXPECT_TRUE(summary["closed_every_step"]);
    const std::string metrics = readBytes(folder / "out/metrics.csv");
    EXPECT_EQ(std::count(metrics.begin(), metrics.end(), '\n'), 41);
}

TEST(Replay, SameBytesWhateverTheNumberOfThreads) {
    const TemporaryFolder folder;
    for (const char* threads : {"0", "1", "2"}) {
        const ProgramRun run =
            replay(folder, smallSession(), threads, {{"LP_NUM_THREADS", threads}});
        ASSERT_EQ(run.exitCode, 0) << run.errors;
    }
    const auto hash = [&](const std::string& out) {
        return nlohmann::json::parse(readBytes(folder / (out + "/summary.json")))["state_hash"];
    };
    for (const std::string other : {"1", "2"}) {
        EXPECT_EQ(hash(other), hash("0"));
        for (const char* file : {"/final.ply", "/end.obj", "/end.png", "/pictures/half.png"}) {
            const std::string bytes = readBytes(folder / (other + file));
            EXPECT_FALSE(bytes.empty()) << file;
            EXPECT_EQ(bytes == readBytes(folder / ("0" + std::string(file))), true)
                << file << " with " << other << " threads";
        }
        EXPECT_EQ(withoutTimes(readBytes(folder / (other + "/metrics.csv"))),
                  withoutTimes(readBytes(folder / "0/metrics.csv")));
    }
}

TEST(Replay, DivergenceIsNamedWithItsStepAndTheResultsStay) {
    const TemporaryFolder folder;
    const ProgramRun run = replay(
        folder, smallSession(R"(, {"step": 5, "type": "check", "hash": "0123456789abcdef"})"),
        "out");
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_NE(run.errors.find("Step 5: the state hash is "), std::string::npos) << run.errors;
    const auto summary = nlohmann::json::parse(readBytes(folder / "out/summary.json"));
    EXPECT_EQ(summary["failures"].size(), 1u);
}

TEST(Replay, WrongNumberOfPiecesFailsTheCheck) {
    const TemporaryFolder folder;
    const ProgramRun run =
        replay(folder, smallSession(R"(, {"step": 0, "type": "check", "pieces": 3})"), "out");
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_NE(run.errors.find("Step 0: the model is in 1 piece where the session expects 3."),
              std::string::npos)
        << run.errors;
}

TEST(Replay, AnAbortedRunLeavesNoFinishedResults) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "out");
    writeText(folder / "out/summary.json", "of an earlier run");
    // By step 9 there is a piece's file where this export needs a folder.
    const ProgramRun run = replay(
        folder, smallSession(R"(, {"step": 8, "type": "export", "file": "e.ply", "per_piece": true},
                  {"step": 9, "type": "export", "file": "e-1.ply/x.ply"})"),
        "out");
    EXPECT_EQ(run.exitCode, 5) << run.errors;
    EXPECT_EQ(std::count(run.errors.begin(), run.errors.end(), '\n'), 1) << run.errors;
    EXPECT_EQ(filesBelow(folder / "out"), (std::set<std::string>{"e-1.ply", "pictures/half.png"}));
}

TEST(Replay, LinksDoNotLeadOutOfTheFolder) {
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder / "out");
    std::filesystem::create_directories(folder / "elsewhere");
    std::filesystem::create_directory_symlink(folder / "elsewhere", folder / "out/pictures");
    const ProgramRun run = replay(folder, smallSession(), "out");
    EXPECT_EQ(run.exitCode, 5) << run.errors;
    EXPECT_TRUE(std::filesystem::is_empty(folder / "elsewhere"));
}

TEST(Replay, LinksToFilesDoNotLeadOutOfTheFolder) {
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder / "out");
    for (const char* name : {"metrics.csv", "end.png", "end.mtl", "final.ply", "summary.json"}) {
        writeText(folder / ("of-somebody-" + std::string(name)), "mine");
        std::filesystem::create_symlink(folder / ("of-somebody-" + std::string(name)),
                                        folder / ("out/" + std::string(name)));
        const ProgramRun run = replay(folder, smallSession(), "out");
        EXPECT_EQ(readBytes(folder / ("of-somebody-" + std::string(name))), "mine") << run.errors;
        std::filesystem::remove_all(folder / "out");
        std::filesystem::create_directories(folder / "out");
    }
}

TEST(Replay, ModelsAreReadFromBesideAboveAndAbsolutePaths) {
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder / "sessions");
    std::filesystem::create_directories(folder / "models");
    const std::filesystem::path model = folder / "models/box.obj";
    writeText(model, test::objText(test::boxSoup()));
    for (const std::string& path : {std::string("../models/box.obj"), model.string()}) {
        writeText(folder / "sessions/a.kerf.json",
                  R"({"format": "kerf-session", "version": 1, "steps": 1, "model": {"path": ")" +
                      path + R"("}})");
        const ProgramRun run =
            runKerf({"replay", folder / "sessions/a.kerf.json", "--out", folder / "out"});
        EXPECT_EQ(run.exitCode, 0) << run.errors;
    }
}

TEST(Replay, ModelsThatAreNoFilesAreNamed) {
    const TemporaryFolder folder;
    ASSERT_EQ(::mkfifo((folder / "pipe.obj").c_str(), 0600), 0);
    std::filesystem::create_symlink("/dev/zero", folder / "zero.obj");
    std::filesystem::create_directory(folder / "folder.obj");
    std::filesystem::create_symlink("loop.obj", folder / "loop.obj");
    for (const std::string& name :
         {std::string("pipe.obj"), std::string("zero.obj"), std::string("folder.obj"),
          std::string("loop.obj"), std::string("~/a.obj"), std::string(300, 'a') + ".obj",
          std::string(5000, 'a') + ".obj"}) {
        const ProgramRun run =
            replay(folder,
                   R"({"format": "kerf-session", "version": 1, "steps": 1, "model": {"path": ")" +
                       name + R"("}})",
                   "out");
        EXPECT_EQ(run.exitCode, 3) << name << run.errors;
        EXPECT_EQ(std::count(run.errors.begin(), run.errors.end(), '\n'), 1) << run.errors;
        EXPECT_FALSE(std::filesystem::exists(folder / "out")) << name;
    }
}

TEST(Replay, AnUndoBetweenTwoKeysEndsTheStrokeAsALiftDoes) {
    const TemporaryFolder folder;
    // The key at step 13 places the blade anew below the body.
    const std::string first = R"({"step": 0, "type": "set", "name": "friction", "value": 1}, )";
    const std::string keys =
        R"({"step": 1, "type": "blade", "a": [-0.8, 0.62, 0.02], "b": [0.8, 0.58, 0.05]},
           {"step": 13, "type": "blade", "a": [-0.8, -0.68, 0.02], "b": [0.8, -0.72, 0.05]})";
    for (const char* end : {"undo", "lift"}) {
        const std::string events =
            first + keys + R"(, {"step": 2, "type": ")" + std::string(end) + R"("})";
        const ProgramRun run = replay(folder, sessionThatDoes(events, 20), end);
        ASSERT_EQ(run.exitCode, 0) << run.errors;
        const auto summary = nlohmann::json::parse(run.out);
        EXPECT_EQ(summary["after"]["triangles"], 20) << end;
    }
    const ProgramRun whole = replay(folder, sessionThatDoes(first + keys, 20), "whole");
    EXPECT_EQ(nlohmann::json::parse(whole.out)["pieces"].size(), 2u) << "without one it cuts";
}

TEST(Replay, WhatCannotHappenIsNamedAsItStandsInTheFileAndNothingIsWritten) {
    const TemporaryFolder folder;
    const std::string other = R"({"step": 3, "type": "lift"}, )";
    const std::vector<std::pair<std::string, std::string>> mistakes{
        {R"({"step": 1, "type": "undo"})", "events[1] at step 1: There is nothing to undo."},
        {R"({"step": 0, "type": "redo"})", "events[1] at step 0: There is nothing to redo."},
        {R"({"step": 2, "type": "remove_box", "box": 0})", "events[1] at step 2: There is no box"},
        {R"({"step": 1, "type": "grab", "at": [9, 9, 9], "radius": 0.1})",
         "events[1] at step 1: No free vertex"},
        {R"({"step": 1, "type": "pin", "center": [9, 9, 9], "radius": 0.1})",
         "events[1] at step 1: No free vertex"},
        // A blade that turns around goes through a point.
        {R"({"step": 4, "type": "blade", "a": [8, 0, 0], "b": [9, 0, 0]},
            {"step": 0, "type": "blade", "a": [9, 0, 0], "b": [8, 0, 0]})",
         ""},
    };
    for (const auto& [event, sentence] : mistakes) {
        const bool turns = sentence.empty();
        const ProgramRun run =
            replay(folder, sessionThatDoes((turns ? "" : other) + event), "new/out");
        EXPECT_EQ(run.exitCode, 3) << event;
        const std::string expected =
            "kerf: test.kerf.json: " +
            (turns ? "events[0] at step 2: The two ends of the blade" : sentence);
        EXPECT_EQ(run.errors.substr(0, expected.size()), expected);
        EXPECT_EQ(std::count(run.errors.begin(), run.errors.end(), '\n'), 1) << run.errors;
        EXPECT_FALSE(std::filesystem::exists(folder / "new")) << event;
    }
}

TEST(Replay, ARefusedEventLeavesFoldersThatWereThereAndPicturesOfBefore) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "out");
    const std::string undo = R"({"step": 2, "type": "undo"})";
    EXPECT_EQ(replay(folder, sessionThatDoes(undo), "out").exitCode, 3);
    EXPECT_TRUE(std::filesystem::is_empty(folder / "out"));
    const std::string picture =
        R"({"step": 1, "type": "screenshot", "file": "a/b.png", "width": 8, "height": 8}, )";
    EXPECT_EQ(replay(folder, sessionThatDoes(picture + undo), "out").exitCode, 3);
    EXPECT_EQ(filesBelow(folder / "out"), (std::set<std::string>{"a/b.png"}));
}

TEST(Replay, ASessionOfBeforeSaysOnceThatItsSolverIsReplaced) {
    const TemporaryFolder folder;
    const std::string former =
        R"({"step": 0, "type": "set", "name": "solver", "value": "small_steps"})";
    const ProgramRun run = replay(folder, sessionThatDoes(former), "out");
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_EQ(run.errors,
              "warning: test.kerf.json: events[0].value: \"small_steps\" is no longer there, "
              "\"implicit\" takes its place.\n");
    const ProgramRun present = replay(folder, sessionThatDoes(""), "present");
    EXPECT_EQ(present.errors, "");
    EXPECT_EQ(nlohmann::json::parse(run.out)["state_hash"],
              nlohmann::json::parse(present.out)["state_hash"]);
}

TEST(Replay, ABodyThatTurnsInsideOutIsARemarkAndNoFailure) {
    const TemporaryFolder folder;
    // Two hands draw the top and the bottom through each other.
    const std::string session = R"({"format": "kerf-session", "version": 1, "steps": 16,
        "model": {"builtin": "sphere20"},
        "params": {"gravity": [0, 0, 0], "floor": null, "ispc_stiffness": 0, "iterations": 2,
                   "youngs_modulus": 1000, "contact": 0},
        "events": [{"step": 0, "type": "grab", "hand": 0, "at": [0, 0.45, 0], "radius": 0.4},
                   {"step": 0, "type": "grab", "hand": 1, "at": [0, -0.45, 0], "radius": 0.4},
                   {"step": 15, "type": "drag", "hand": 0, "to": [0, -0.7, 0]},
                   {"step": 15, "type": "drag", "hand": 1, "to": [0, 0.7, 0]}]})";
    const ProgramRun run = replay(folder, session, "out");
    EXPECT_EQ(run.exitCode, 0);
    const auto summary = nlohmann::json::parse(readBytes(folder / "out/summary.json"));
    EXPECT_LT(summary["volume_ratio"]["min"], 0);
    ASSERT_EQ(summary["remarks"].size(), 2u);
    const std::string remark = summary["remarks"][0];
    EXPECT_NE(remark.find(": the body turned inside out, with -"), std::string::npos) << remark;
    const std::string crossings = summary["remarks"][1];
    EXPECT_NE(crossings.find("of the skin pass through each other"), std::string::npos)
        << crossings;
    EXPECT_NE(run.errors.find("test.kerf.json: " + remark), std::string::npos) << run.errors;
}

TEST(Replay, WithoutOpenGlNothingIsWritten) {
    const TemporaryFolder folder;
    const ProgramRun run = replay(folder, smallSession(), "out", {{"KERF_FORCE_NO_GL", "1"}});
    EXPECT_EQ(run.exitCode, 4) << run.errors;
    EXPECT_EQ(std::count(run.errors.begin(), run.errors.end(), '\n'), 1) << run.errors;
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

}  // namespace
}  // namespace kerf
