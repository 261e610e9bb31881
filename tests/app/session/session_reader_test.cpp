#include <gtest/gtest.h>

#include "app/files/sha256.h"
#include "app/session/session.h"
#include "tests/support/temporary_folder.h"

namespace kerf::app {
namespace {

using test::TemporaryFolder;
using test::writeText;

constexpr const char* kHead =
    R"("format": "kerf-session", "version": 1, "model": {"builtin": "sphere20"}, "steps": 100)";

/// A session with these keys behind the ones that every session needs.
std::string sessionWith(const std::string& more) {
    return std::string("{") + kHead + (more.empty() ? "" : ", ") + more + "}";
}

std::string sessionWithEvent(const std::string& event) {
    return sessionWith(R"("events": [)" + event + "]");
}

std::string errorOf(const std::string& text) {
    try {
        parseSession(text, "/folder");
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

TEST(SessionReader, MinimalSessionHasDefaults) {
    const Session session = parseSession(sessionWith(""), "/folder");
    EXPECT_EQ(session.model.builtin, "sphere20");
    EXPECT_EQ(session.steps, 100);
    EXPECT_TRUE(session.params == Params{});
    EXPECT_FALSE(session.view.has_value());
    EXPECT_TRUE(session.warnings.empty());
}

TEST(SessionReader, ReadsEveryKey) {
    const Session session = parseSession(R"({
      "format": "kerf-session", "version": 1,
      "model": {"path": "sub/../model.obj"},
      "placement": {"scale": 2, "rotate": [10, 20, 30], "translate": [1, 2, 3]},
      "params": {"time_step": 0.004, "iterations": 7, "gravity": [0, -1, 0], "floor": null},
      "steps": 50,
      "events": [
        {"step": 9, "type": "lift"},
        {"step": 3, "type": "blade", "a": [0, 1, 2], "b": [3, 4, 5]},
        {"step": 9, "type": "set", "name": "floor", "value": -2.5},
        {"step": 10, "type": "screenshot", "file": "shots/a.png", "width": 64, "height": 32},
        {"step": 10, "type": "export", "file": "a.stl"},
        {"step": 50, "type": "check", "hash": "0123456789abcdef", "pieces": 2}
      ],
      "view": {"eye": [1, 2, 3], "target": [0, 0, 1], "up": [0, 0, 1], "fov_y": 50}
    })",
                                         "/folder");
    EXPECT_EQ(session.model.path, "/folder/model.obj");
    EXPECT_EQ(session.placement.scale, 2);
    EXPECT_EQ(session.placement.rotate, Vec3(10, 20, 30));
    EXPECT_EQ(session.placement.translate, Vec3(1, 2, 3));
    EXPECT_EQ(session.params.timeStep, 0.004);
    EXPECT_EQ(session.params.iterations, 7);
    EXPECT_EQ(session.params.gravity, Vec3(0, -1, 0));
    EXPECT_FALSE(session.params.floor.has_value());
    ASSERT_EQ(session.events.size(), 6u);
    EXPECT_EQ(std::get<MoveBlade>(session.events[0].action).blade.b, Vec3(3, 4, 5));
    EXPECT_TRUE(std::holds_alternative<LiftBlade>(session.events[1].action));
    EXPECT_EQ(std::get<double>(std::get<SetParam>(session.events[2].action).value), -2.5);
    EXPECT_EQ(std::get<ScreenshotEvent>(session.events[3].action).file, "shots/a.png");
    EXPECT_EQ(std::get<ExportEvent>(session.events[4].action).file, "a.stl");
    EXPECT_EQ(std::get<CheckEvent>(session.events[5].action).pieces, 2);
    EXPECT_EQ(session.view->fovY, 50);
}

TEST(SessionReader, UnknownExtraKeysAreWarnings) {
    const Session session = parseSession(
        sessionWith(R"("author": "x", "events": [{"step": 1, "type": "lift", "why": 0}])"), "/");
    EXPECT_EQ(session.warnings, (std::vector<std::string>{"events[0].why: unknown key, ignored.",
                                                          "author: unknown key, ignored."}));
}

TEST(SessionReader, EventsOfOneStepKeepTheirOrder) {
    const Session session =
        parseSession(sessionWith(R"("events": [{"step": 5, "type": "export", "file": "b.ply"},
                                  {"step": 1, "type": "lift"},
                                  {"step": 5, "type": "export", "file": "a.ply"}])"),
                     "/");
    EXPECT_EQ(std::get<ExportEvent>(session.events[1].action).file, "b.ply");
    EXPECT_EQ(std::get<ExportEvent>(session.events[2].action).file, "a.ply");
}

struct BadSession {
    const char* name;
    std::string text;
    const char* error;  ///< how the sentence starts
};

class SessionErrors : public ::testing::TestWithParam<BadSession> {};

TEST_P(SessionErrors, NameThePlace) {
    EXPECT_EQ(errorOf(GetParam().text).substr(0, std::string(GetParam().error).size()),
              GetParam().error);
}

// clang-format off
INSTANTIATE_TEST_SUITE_P(All, SessionErrors, ::testing::Values(
    BadSession{"Empty", "", "line 1, column 1: this is not valid JSON near ''"},
    BadSession{"NoObject", "[1]", "top level: expected an object"},
    BadSession{"NaN", "{\n  \"steps\": NaN}", "line 2, column 12: this is not valid JSON near"},
    BadSession{"HugeNumber", "{\"steps\": 1e999}", "line 1, column 15: the number '1e999' is too large"},
    BadSession{"GrabWithoutRadius", R"({"format": "kerf-session", "version": 1, "steps": 9, "model": {"builtin": "sphere20"}, "events": [{"step": 1, "type": "grab", "at": [0, 0, 0]}]})", "events[0].radius: this key is missing"},
    BadSession{"NegativeRadius", R"({"format": "kerf-session", "version": 1, "steps": 9, "model": {"builtin": "sphere20"}, "events": [{"step": 1, "type": "pin", "center": [0, 0, 0], "radius": -1}]})", "events[0].radius: -1 is out of range"},
    BadSession{"PinOfBallAndBox", sessionWithEvent(R"({"step": 1, "type": "pin", "center": [0, 0, 0], "radius": 1, "low": [0, 0, 0], "high": [1, 1, 1]})"), "events[0]: expected either a ball (\"center\", \"radius\") or a box (\"low\", \"high\")."},
    BadSession{"PinOfHalfABallAndHalfABox", sessionWithEvent(R"({"step": 1, "type": "unpin", "radius": 1, "high": [1, 1, 1]})"), "events[0]: expected either a ball"},
    BadSession{"PinOfNothing", sessionWithEvent(R"({"step": 1, "type": "pin"})"), "events[0]: expected either a ball"},
    BadSession{"PinWithoutCenter", sessionWithEvent(R"({"step": 1, "type": "pin", "radius": 1})"), "events[0].center: this key is missing"},
    BadSession{"PinWithoutHigh", sessionWithEvent(R"({"step": 1, "type": "pin", "low": [0, 0, 0]})"), "events[0].high: this key is missing"},
    BadSession{"BoxUpsideDown", R"({"format": "kerf-session", "version": 1, "steps": 9, "model": {"builtin": "sphere20"}, "events": [{"step": 1, "type": "pin", "low": [0, 1, 0], "high": [1, 0, 1]}]})", "events[0].low: a box needs"},
    BadSession{"FlatBox", sessionWith(R"("boxes": [{"center": [0, 0, 0], "size": [1, 0, 1]}])"), "boxes[0].size: each side of a box must be at least 1e-06 m long."},
    BadSession{"BoxesNoList", sessionWith(R"("boxes": {})"), "boxes: expected a list"},
    BadSession{"BoxWithoutSize", sessionWithEvent(R"({"step": 1, "type": "add_box", "center": [0, 0, 0]})"), "events[0].size: this key is missing"},
    BadSession{"WhichBox", sessionWithEvent(R"({"step": 1, "type": "remove_box"})"), "events[0].box: this key is missing"},
    BadSession{"NoSuchSolver", R"({"format": "kerf-session", "version": 1, "steps": 9, "model": {"builtin": "sphere20"}, "params": {"solver": "fem"}})", "params.solver: \"solver\" must be one of small_steps, pbd."},
    BadSession{"TwoKeys", R"({"a": 1, "a": 2})", "top level: the key 'a' stands there twice"},
    BadSession{"TwoKeysInside", R"({"e": [{}, {"s": {"a": 1, "a": 2}}]})", "e[1].s: the key 'a' stands there twice"},
    BadSession{"TrailingText", "{} {}", "line 1, column 4: this is not valid JSON near"},
    BadSession{"NotUtf8", "{\"\xff\": 1}", "line 1, column 3: this is not valid JSON near"},
    BadSession{"OtherFormat", R"({"format": "gltf", "version": 1})", "format: expected \"kerf-session\""},
    BadSession{"NoFormat", "{}", "format: this key is missing"},
    BadSession{"NewVersion", R"({"format": "kerf-session", "version": 2})", "version: version 2 is not supported"},
    BadSession{"NoModel", R"({"format": "kerf-session", "version": 1, "steps": 1})", "model: this key is missing"},
    BadSession{"NoSuchModel", R"({"format": "kerf-session", "version": 1, "steps": 1, "model": {"builtin": "cow"}})", "model.builtin: there is no builtin model 'cow'"},
    BadSession{"TwoModels", R"({"format": "kerf-session", "version": 1, "steps": 1, "model": {"builtin": "sphere20", "path": "a"}})", "model: expected either"},
    BadSession{"ShortDigest", R"({"format": "kerf-session", "version": 1, "steps": 1, "model": {"builtin": "sphere20", "sha256": "ab"}})", "model.sha256: expected 64"},
    BadSession{"NoSteps", R"({"format": "kerf-session", "version": 1, "model": {"builtin": "sphere20"}})", "steps: this key is missing"},
    BadSession{"ZeroSteps", R"({"format": "kerf-session", "version": 1, "model": {"builtin": "sphere20"}, "steps": 0})", "steps: 0 is out of range"},
    BadSession{"TooManySteps", R"({"format": "kerf-session", "version": 1, "model": {"builtin": "sphere20"}, "steps": 10000000000})", "steps: 1e+10 is out of range"},
    BadSession{"HalfAStep", R"({"format": "kerf-session", "version": 1, "model": {"builtin": "sphere20"}, "steps": 1.5})", "steps: expected a whole number"},
    BadSession{"StepsAsText", R"({"format": "kerf-session", "version": 1, "model": {"builtin": "sphere20"}, "steps": "5"})", "steps: expected a number"},
    BadSession{"NegativeScale", sessionWith(R"("placement": {"scale": -1})"), "placement.scale: -1 is out of range"},
    BadSession{"WrongParam", sessionWith(R"("params": {"gravty": 1})"), "params.gravty: there is no parameter \"gravty\"; known are time_step"},
    BadSession{"ParamOutOfRange", sessionWith(R"("params": {"iterations": 1000})"), "params.iterations: \"iterations\" must lie between 1 and 60"},
    BadSession{"ParamOfWrongType", sessionWith(R"("params": {"time_step": [0, 0, 0]})"), "params.time_step: "},
    BadSession{"ParamAsText", sessionWith(R"("params": {"time_step": "NaN"})"), "params.time_step: \"time_step\" takes one number."},
    BadSession{"EventsNoList", sessionWith(R"("events": {})"), "events: expected a list"},
    BadSession{"EventNoObject", sessionWithEvent("1"), "events[0]: expected an object"},
    BadSession{"EventWithoutStep", sessionWithEvent(R"({"type": "lift"})"), "events[0].step: this key is missing"},
    BadSession{"EventAfterTheEnd", sessionWithEvent(R"({"step": 101, "type": "lift"})"), "events[0].step: 101 is out of range (0 to 100)"},
    BadSession{"UnknownType", sessionWithEvent(R"({"step": 1, "type": "slice"})"), "events[0].type: there is no event type 'slice'"},
    BadSession{"Continues", sessionWithEvent(R"({"step": 1, "type": "set", "name": "friction", "value": 1, "continues": 1})"), "events[0].continues: expected true or false"},
    BadSession{"TwoNumbers", sessionWithEvent(R"({"step": 1, "type": "blade", "a": [1, 2], "b": [1, 2, 3]})"), "events[0].a: expected three numbers"},
    BadSession{"TextInVector", sessionWithEvent(R"({"step": 1, "type": "blade", "a": [1, 2, "3"], "b": [1, 2, 3]})"), "events[0].a: expected three numbers"},
    BadSession{"FarAway", sessionWithEvent(R"({"step": 1, "type": "blade", "a": [1, 2, 1e9], "b": [1, 2, 3]})"), "events[0].a[2]: 1e+09 is out of range"},
    BadSession{"NoLength", sessionWithEvent(R"({"step": 1, "type": "blade", "a": [1, 2, 3], "b": [1, 2, 3]})"), "events[0].a: a and b are the same point"},
    BadSession{"SetUnknown", sessionWithEvent(R"({"step": 1, "type": "set", "name": "x", "value": 1})"), "events[0].name: there is no parameter \"x\""},
    BadSession{"SetOutOfRange", sessionWithEvent(R"({"step": 1, "type": "set", "name": "time_step", "value": 1})"), "events[0].value: \"time_step\" must lie between"},
    BadSession{"AbsoluteFile", sessionWithEvent(R"({"step": 1, "type": "screenshot", "file": "/a.png"})"), "events[0].file: '/a.png' is not a file inside"},
    BadSession{"FileAbove", sessionWithEvent(R"({"step": 1, "type": "screenshot", "file": "x/../../a.png"})"), "events[0].file: 'x/../../a.png' is not a file inside"},
    BadSession{"FileIsFolder", sessionWithEvent(R"({"step": 1, "type": "export", "file": "x/"})"), "events[0].file: 'x/' is not a file inside"},
    BadSession{"OwnFile", sessionWithEvent(R"({"step": 1, "type": "export", "file": "./final.ply"})"), "events[0].file: './final.ply' is written by the replay itself"},
    BadSession{"NoPng", sessionWithEvent(R"({"step": 1, "type": "screenshot", "file": "a.jpg"})"), "events[0].file: 'a.jpg' must end in .png"},
    BadSession{"NoMesh", sessionWithEvent(R"({"step": 1, "type": "export", "file": "a.fbx"})"), "events[0].file: 'a.fbx' must end in"},
    BadSession{"HugePicture", sessionWithEvent(R"({"step": 1, "type": "screenshot", "file": "a.png", "width": 100000})"), "events[0].width: 1e+05 is out of range"},
    BadSession{"EmptyCheck", sessionWithEvent(R"({"step": 1, "type": "check"})"), "events[0]: a check needs"},
    BadSession{"ShortHash", sessionWithEvent(R"({"step": 1, "type": "check", "hash": "12"})"), "events[0].hash: expected 16"},
    BadSession{"EyeAtTarget", sessionWith(R"("view": {"eye": [1, 1, 1], "target": [1, 1, 1]})"), "view: eye and target are the same"},
    BadSession{"UpAlongView", sessionWith(R"("view": {"eye": [0, 5, 0], "target": [0, 1, 0]})"), "view.up: up must not point"},
    BadSession{"DarkerThanBlack", sessionWith(R"("view": {"eye": [0, 5, 0], "target": [0, 1, 1], "skin": [0, -0.1, 0]})"), "view.skin: expected red, green and blue"},
    BadSession{"FlatView", sessionWith(R"("view": {"eye": [0, 5, 0], "target": [0, 1, 1], "fov_y": 180})"), "view.fov_y: 180 is out of range"}),
    [](const auto& each) { return std::string(each.param.name); });
// clang-format on

TEST(SessionReader, DeepNestingIsRefusedWhileParsing) {
    const std::string deep = "{\"x\": " + std::string(200'000, '[');
    EXPECT_EQ(errorOf(deep), "x: nested deeper than 32 levels.");
    EXPECT_EQ(errorOf(std::string(200'000, '[')), "nested deeper than 32 levels.");
}

TEST(SessionReader, NothingIsLeftUnreadAfterAZeroByte) {
    const std::string text = sessionWith(R"("steps": 3)");
    const std::string error = errorOf(text + std::string(1, '\0') + "more");
    EXPECT_NE(error.find("a zero byte is not valid JSON."), std::string::npos) << error;
}

TEST(SessionReader, ErrorsOfAFileNameIt) {
    const TemporaryFolder folder;
    writeText(folder / "bad.kerf.json",
              sessionWithEvent(R"({"step": 1, "type": "blade", "a": 1, "b": [0, 0, 0]})"));
    try {
        readSession(folder / "bad.kerf.json");
        FAIL() << "no error";
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(), "bad.kerf.json: events[0].a: expected three numbers.");
    }
}

TEST(SessionReader, MissingFileAndFolderAreRefused) {
    const TemporaryFolder folder;
    EXPECT_THROW(readSession(folder / "none.kerf.json"), InputError);
    EXPECT_THROW(readSession(folder.path()), InputError);
}

TEST(SessionReader, FilesAboveTheCapAreRefusedUnread) {
    const TemporaryFolder folder;
    writeText(folder / "big.kerf.json", "");
    std::filesystem::resize_file(folder / "big.kerf.json", kMaxSessionBytes + 1);
    EXPECT_THROW(readSession(folder / "big.kerf.json"), InputError);
}

/// The sentence with which the model of a session is refused; empty where it is not.
std::string refusalOfModel(const std::string& placement) {
    try {
        loadSessionModel(parseSession(sessionWith("\"placement\": " + placement), "."));
        return "";
    } catch (const InputError& error) {
        return error.what();
    }
}

TEST(SessionModel, MustBeWhereFloatsAreFineEnough) {
    EXPECT_EQ(refusalOfModel(R"({"translate": [10000, 0, 0]})"), "");
    EXPECT_EQ(refusalOfModel(R"({"scale": 100000, "translate": [500000, 0, 0]})"), "");
    for (const char* placement :
         {R"({"translate": [1e6, 0, 0]})", R"({"scale": 1e-4, "translate": [0, -10, 0]})",
          R"({"scale": 1e6, "translate": [1e6, 0, 0]})", R"({"scale": 1e-6})"}) {
        const std::string sentence = refusalOfModel(placement);
        EXPECT_EQ(sentence.find("placement: the model would be"), 0) << placement << sentence;
    }
}

TEST(SessionWriter, RoundTripKeepsEveryBit) {
    Session session =
        parseSession(sessionWith(R"("params": {"time_step": 0.0033333333333333335, "floor": null},
            "placement": {"rotate": [0.1, 0.2, 0.30000000000000004]},
            "boxes": [{"center": [0, -0.3, 0.1], "size": [1, 0.1, 1]},
                      {"center": [0, -9, 0], "size": [1, 0.7, 1], "rotate": [30, 0.1, -7]}],
            "events": [{"step": 1, "type": "blade", "a": [0.1, 1e-300, 3], "b": [1, 2, -0.7]},
                       {"step": 2, "type": "lift"},
                       {"step": 3, "type": "set", "name": "gravity", "value": [0, -9.81, 0]},
                       {"step": 3, "type": "set", "name": "floor", "value": null},
                       {"step": 3, "type": "set", "name": "solver", "value": "pbd"},
                       {"step": 3, "type": "grab", "hand": 2, "at": [0.3, 0, 0], "radius": 0.1},
                       {"step": 3, "type": "drag", "hand": 2, "to": [0.1, 0.2, 0.7]},
                       {"step": 3, "type": "release", "hand": 2},
                       {"step": 3, "type": "pin", "low": [-1, -0.1, 0], "high": [1, 0, 0.3]},
                       {"step": 3, "type": "unpin", "center": [0, 0.1, 0], "radius": 0.7, "continues": true},
                       {"step": 3, "type": "add_box", "center": [0, 0.1, 0], "size": [1, 2, 3]},
                       {"step": 3, "type": "change_box", "box": 2, "center": [0, 0.2, 0],
                        "size": [1, 2, 3], "rotate": [0, 0.1, 0], "continues": true},
                       {"step": 3, "type": "remove_box", "box": 2},
                       {"step": 4, "type": "screenshot", "file": "ä \" b.png", "width": 3},
                       {"step": 5, "type": "export", "file": "a/b.obj"},
                       {"step": 6, "type": "check", "hash": "00ff00ff00ff00ff"}],
            "view": {"eye": [1, 2, 3.3], "target": [0, 0, 0], "orthographic": true,
                     "skin": [0.2, 0.5, 1], "flesh": [1, 0.9, 0]})"),
                     "/folder");
    const std::string text = formatSession(session);
    const Session again = parseSession(text, "/folder");
    EXPECT_EQ(formatSession(again), text);
    EXPECT_TRUE(again.params == session.params);
    EXPECT_EQ(again.placement.rotate, session.placement.rotate);
    ASSERT_EQ(session.boxes.size(), 2u);
    EXPECT_EQ(again.boxes, session.boxes);
    EXPECT_EQ(session.boxes[1].rotate, Vec3(30, 0.1, -7));
    ASSERT_EQ(again.events.size(), session.events.size());
    EXPECT_EQ(std::get<MoveBlade>(again.events[0].action).blade.a, Vec3(0.1, 1e-300, 3));
    EXPECT_EQ(again.view->eye, session.view->eye);
    EXPECT_TRUE(again.view->orthographic);
    EXPECT_EQ(again.colors.skin, Vec3(0.2, 0.5, 1));
    EXPECT_EQ(again.colors.flesh, Vec3(1, 0.9, 0));
    EXPECT_TRUE(again.warnings.empty());
}

TEST(SessionWriter, ModelPathsAreRelativeToTheFolder) {
    Session session = parseSession(sessionWith(""), "/");
    session.model = {"", "/data/models/a.obj", ""};
    const std::string text = formatSession(session, "/data/sessions");
    EXPECT_NE(text.find(R"("path":"../models/a.obj")"), std::string::npos);
    EXPECT_EQ(parseSession(text, "/data/sessions").model.path, "/data/models/a.obj");
}

TEST(SessionWriter, RefusesWhatIsNotFinite) {
    Session session = parseSession(sessionWith(""), "/");
    session.events.push_back({1, MoveBlade{{Vec3(0, NAN, 0), Vec3(1, 0, 0)}}});
    EXPECT_THROW(formatSession(session), InputError);
}

TEST(Placement, ScalesThenTurnsAboutXThenYThenZThenMoves) {
    Placement placement;
    placement.scale = 2;
    placement.rotate = {90, 0, 90};
    placement.translate = {0, 0, 10};
    // (0, 1, 0) -> (0, 2, 0) -> about x (0, 0, 2) -> about z the same -> moved.
    EXPECT_TRUE(placement.apply({0, 1, 0}).isApprox(Vec3(0, 0, 12), 1e-12));
    // (1, 0, 0) -> (2, 0, 0) -> about x the same -> about z (0, 2, 0) -> moved.
    EXPECT_TRUE(placement.apply({1, 0, 0}).isApprox(Vec3(0, 2, 10), 1e-12));
}

TEST(Sha256, MatchesThePublishedVectors) {
    const test::TemporaryFolder folder;
    test::writeText(folder / "empty", "");
    test::writeText(folder / "abc", "abc");
    EXPECT_EQ(sha256OfFile(folder / "empty"),
              "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(sha256OfFile(folder / "abc"),
              "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

}  // namespace
}  // namespace kerf::app
