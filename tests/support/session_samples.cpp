#include "tests/support/session_samples.h"

namespace kerf::test {

namespace {

/// A text inside so many objects, each under a key of the one around it.
std::string nested(std::string text, const std::string& key, int levels) {
    const std::string start = R"({")" + key + R"(": )";
    for (int level = 0; level < levels; ++level) {
        text.insert(0, start).append("}");
    }
    return text;
}

constexpr const char* kHead =
    R"("format": "kerf-session", "version": 1, "model": {"builtin": "sphere20"}, "steps": 100)";

}  // namespace

std::string sessionWith(const std::string& more) {
    return std::string("{") + kHead + (more.empty() ? "" : ", ") + more + "}";
}

std::string sessionWithEvent(const std::string& event) {
    return sessionWith(R"("events": [)" + event + "]");
}

std::string sessionWithEveryKey() {
    return R"({
      "format": "kerf-session", "version": 1,
      "model": {"path": "sub/../model.obj"},
      "placement": {"unit": "cm", "up": "z", "scale": 2, "rotate": [10, 20, 30], "translate": [1, 2, 3]},
      "material": "liver",
      "params": {"time_step": 0.004, "iterations": 7, "gravity": [0, -1, 0], "floor": null},
      "task": {"name": "Open it", "about": "Along the line.", "expert": "sub/expert.kerf.json",
        "lines": [{"points": [[0.1, 2, 0], [3, 2, 0.7]]},
                  {"points": [[0, 2, 0], [1, 2, 0], [1, 2, 1]], "closed": true}],
        "into": [0.1, -1, 0], "reach": 0.02, "depth": 0.005, "band": 0.001,
        "spare_regions": [{"center": [0, 1, 0], "radius": 0.3},
                          {"low": [0, 0, 0], "high": [1, 0.1, 1]}],
        "path": 0.3, "deviation": 0.002, "ends": 0.004, "in_band": 0.9, "margin": 0.003,
        "seconds": 20, "idle": 2, "economy": 0.8, "smoothness": -7, "wobble": 0.0003,
        "newtons": 0.7,
        "person": "Ada", "date": "2026-11-28T10:00:00Z"},
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
    })";
}

std::string sessionWithEveryEvent() {
    return sessionWith(R"("params": {"time_step": 0.0033333333333333335, "floor": null},
            "placement": {"rotate": [0.1, 0.2, 0.30000000000000004]},
            "boxes": [{"center": [0, -0.3, 0.1], "size": [1, 0.1, 1]},
                      {"center": [0, -9, 0], "size": [1, 0.7, 1], "rotate": [30, 0.1, -7]}],
            "events": [{"step": 1, "type": "blade", "a": [0.1, 1e-300, 3], "b": [1, 2, -0.7]},
                       {"step": 2, "type": "lift"},
                       {"step": 3, "type": "set", "name": "gravity", "value": [0, -9.81, 0]},
                       {"step": 3, "type": "set", "name": "floor", "value": null},
                       {"step": 3, "type": "set", "name": "solver", "value": "pbd"},
                       {"step": 3, "type": "set", "name": "density", "value": 900, "material": "Cork"},
                       {"step": 3, "type": "grab", "hand": 2, "at": [0.3, 0, 0], "radius": 0.1},
                       {"step": 3, "type": "grab", "hand": 3, "at": [0.3, 0, 0.1], "radius": 0.2,
                        "surface": true, "continues": true},
                       {"step": 3, "type": "drag", "hand": 2, "to": [0.1, 0.2, 0.7]},
                       {"step": 3, "type": "release", "hand": 2},
                       {"step": 3, "type": "pin", "low": [-1, -0.1, 0], "high": [1, 0, 0.3]},
                       {"step": 3, "type": "unpin", "center": [0, 0.1, 0], "radius": 0.7, "continues": true},
                       {"step": 3, "type": "move_pins", "by": [0, 0.3, 0], "rotate": [1, 0, 0.1],
                        "continues": true},
                       {"step": 3, "type": "add_box", "center": [0, 0.1, 0], "size": [1, 2, 3]},
                       {"step": 3, "type": "change_box", "box": 2, "center": [0, 0.2, 0],
                        "size": [1, 2, 3], "rotate": [0, 0.1, 0], "continues": true},
                       {"step": 3, "type": "remove_box", "box": 2},
                       {"step": 3, "type": "remove_piece", "piece": 1},
                       {"step": 3, "type": "undo"}, {"step": 3, "type": "redo"},
                       {"step": 4, "type": "restart"},
                       {"step": 4, "type": "place", "unit": "in", "up": "-x", "scale": 0.1,
                        "rotate": [0, 0.1, 90], "translate": [0.3, 0, -7], "continues": true},
                       {"step": 4, "type": "screenshot", "file": "ä \" b.png", "width": 3},
                       {"step": 5, "type": "export", "file": "a/b.obj", "coordinates": "model"},
                       {"step": 6, "type": "check", "hash": "00ff00ff00ff00ff"}],
            "view": {"eye": [1, 2, 3.3], "target": [0, 0, 0], "orthographic": true,
                     "skin": [0.2, 0.5, 1], "flesh": [1, 0.9, 0], "of_look": true})");
}

const std::vector<BrokenSession>& brokenSessions() {
    // clang-format off
    static const std::vector<BrokenSession> sessions{
        {"Empty", "", "line 1, column 1: the text ends too early"},
        {"NoObject", "[1]", "top level: expected an object"},
        {"NaN", "{\n  \"steps\": NaN}", "line 2, column 12: this is not valid JSON near"},
        {"HugeNumber", "{\"steps\": 1e999}", "line 1, column 15: the number '1e999' is too large"},
        {"GrabWithoutRadius", sessionWithEvent(R"({"step": 1, "type": "grab", "at": [0, 0, 0]})"), "events[0].radius: this key is missing"},
        {"NegativeRadius", sessionWithEvent(R"({"step": 1, "type": "pin", "center": [0, 0, 0], "radius": -1})"), "events[0].radius: -1 is out of range"},
        {"PinOfBallAndBox", sessionWithEvent(R"({"step": 1, "type": "pin", "center": [0, 0, 0], "radius": 1, "low": [0, 0, 0], "high": [1, 1, 1]})"), "events[0]: expected either a ball (\"center\", \"radius\") or a box (\"low\", \"high\")."},
        {"PinOfHalfABallAndHalfABox", sessionWithEvent(R"({"step": 1, "type": "unpin", "radius": 1, "high": [1, 1, 1]})"), "events[0]: expected either a ball"},
        {"PinOfNothing", sessionWithEvent(R"({"step": 1, "type": "pin"})"), "events[0]: expected either a ball"},
        {"PinWithoutCenter", sessionWithEvent(R"({"step": 1, "type": "pin", "radius": 1})"), "events[0].center: this key is missing"},
        {"PinWithoutHigh", sessionWithEvent(R"({"step": 1, "type": "pin", "low": [0, 0, 0]})"), "events[0].high: this key is missing"},
        {"BoxUpsideDown", sessionWithEvent(R"({"step": 1, "type": "pin", "low": [0, 1, 0], "high": [1, 0, 1]})"), "events[0].low: a box needs"},
        {"IdleTask", sessionWith(R"("task": {"name": "t"})"), "task: there is nothing to do; give lines, or a model to take."},
        {"ShortTaskLine", sessionWith(R"("task": {"name": "t", "lines": [{"points": [[0, 0, 0]]}]})"), "task.lines[0].points: a line has two points at least."},
        {"TaskLineThatStands", sessionWith(R"("task": {"name": "t", "lines": [{"points": [[0, 0, 0], [1, 0, 0], [1, 0, 0]]}]})"), "task.lines[0].points: two points in a row are the same."},
        {"TaskAlongItsLine", sessionWith(R"("task": {"name": "t", "lines": [{"points": [[0, 0, 0], [1, 0, 0]]}], "into": [1, 0.01, 0]})"), "task.into: it points along a line; give a direction into the body."},
        {"TaskWithoutExpertsPath", sessionWith(R"("task": {"name": "t", "take": 1, "economy": 0.5})"), "task.economy: it needs the `path` of an expert."},
        {"TaskWithoutBand", sessionWith(R"("task": {"name": "t", "take": 1, "depth": 0.1, "in_band": 0.5})"), "task.in_band: it needs a `depth` and a `band` about it."},
        {"TaskWithoutDirection", sessionWith(R"("task": {"name": "t", "lines": [{"points": [[0, 0, 0], [1, 0, 0]]}], "into": [0, 0, 0]})"), "task.into: it has no direction."},
        {"TaskSparesNoModel", sessionWith(R"("task": {"name": "t", "lines": [{"points": [[0, 0, 0], [1, 0, 0]]}], "spare": [3]})"), "task.spare[0]: there is no model 3; the session has 1 model, numbered from 0."},
        {"TaskTakesWhatItCuts", sessionWith(R"("task": {"name": "t", "take": 0})"), "task.model: it is to be cut, so it can't be spared or taken out."},
        {"NegativeMargin", sessionWith(R"("task": {"name": "t", "lines": [{"points": [[0, 0, 0], [1, 0, 0]]}], "margin": -1})"), "task.margin: -1 is out of range (0 to 1e+08)."},
        {"HalfARegion", sessionWith(R"("task": {"name": "t", "lines": [{"points": [[0, 0, 0], [1, 0, 0]]}], "spare_regions": [{"radius": 1}]})"), "task.spare_regions[0].center: this key is missing; add it."},
        {"FlatBox", sessionWith(R"("boxes": [{"center": [0, 0, 0], "size": [1, 0, 1]}])"), "boxes[0].size[1]: 0 is out of range (1e-06 to 1e+06)."},
        {"BoxesNoList", sessionWith(R"("boxes": {})"), "boxes: expected a list"},
        {"BoxWithoutSize", sessionWithEvent(R"({"step": 1, "type": "add_box", "center": [0, 0, 0]})"), "events[0].size: this key is missing"},
        {"WhichBox", sessionWithEvent(R"({"step": 1, "type": "remove_box"})"), "events[0].box: this key is missing"},
        {"NoSuchSolver", sessionWith(R"("params": {"solver": "fem"})"), "params.solver: \"solver\" must be one of implicit, pbd."},
        {"TwoKeys", R"({"a": 1, "a": 2})", "top level: the key 'a' stands there twice"},
        {"TwoKeysInside", R"({"e": [{}, {"s": {"a": 1, "a": 2}}]})", "e[1].s: the key 'a' stands there twice"},
        {"TwoKeysDeepInside", nested(R"({"a": 1, "a": 2})", std::string(20, 'k'), 30), "...kkk"},
        {"TrailingText", "{} {}", "line 1, column 4: this is not valid JSON near"},
        {"NotUtf8", "{\"\xff\": 1}", "line 1, column 3: this is not valid JSON near"},
        {"OtherFormat", R"({"format": "gltf", "version": 1})", "format: expected \"kerf-session\""},
        {"NoFormat", "{}", "format: this key is missing"},
        {"NewVersion", R"({"format": "kerf-session", "version": 2})", "version: version 2 is not supported"},
        {"NoModel", R"({"format": "kerf-session", "version": 1, "steps": 1})", "model: this key is missing"},
        {"NoSuchModel", R"({"format": "kerf-session", "version": 1, "steps": 1, "model": {"builtin": "cow"}})", "model.builtin: there is no builtin model 'cow'"},
        {"TwoModels", R"({"format": "kerf-session", "version": 1, "steps": 1, "model": {"builtin": "sphere20", "path": "a"}})", "model: expected either"},
        {"ShortDigest", R"({"format": "kerf-session", "version": 1, "steps": 1, "model": {"builtin": "sphere20", "sha256": "ab"}})", "model.sha256: expected 64"},
        {"NoSteps", R"({"format": "kerf-session", "version": 1, "model": {"builtin": "sphere20"}})", "steps: this key is missing"},
        {"ZeroSteps", R"({"format": "kerf-session", "version": 1, "model": {"builtin": "sphere20"}, "steps": 0})", "steps: 0 is out of range"},
        {"TooManySteps", R"({"format": "kerf-session", "version": 1, "model": {"builtin": "sphere20"}, "steps": 10000000000})", "steps: 1e+10 is out of range"},
        {"ZeroByteInFile", sessionWithEvent(R"({"step": 1, "type": "screenshot", "file": "../a\u0000b.png"})"), "events[0].file: '../a?b.png' is not a file inside the output folder"},
        {"ZeroByteInPath", R"({"format": "kerf-session", "version": 1, "steps": 1, "model": {"path": "a\u0000.obj"}})", "model.path: no file has a zero byte in its name."},
        {"HalfAStep", R"({"format": "kerf-session", "version": 1, "model": {"builtin": "sphere20"}, "steps": 1.5})", "steps: expected a whole number"},
        {"StepsAsText", R"({"format": "kerf-session", "version": 1, "model": {"builtin": "sphere20"}, "steps": "5"})", "steps: expected a number"},
        {"NoSuchUnit", sessionWith(R"("placement": {"unit": "yard"})"), "placement.unit: 'yard' is none of m, cm, mm, um, km, in, ft."},
        {"UnitAsNumber", sessionWith(R"("placement": {"unit": 0.001})"), "placement.unit: expected a text in quotes."},
        {"NoSuchAxis", sessionWithEvent(R"({"step": 1, "type": "place", "up": "w"})"), "events[0].up: 'w' is none of y, z, x, -y, -z, -x."},
        {"NoSuchCoordinates", sessionWithEvent(R"({"step": 1, "type": "export", "file": "a.ply", "coordinates": "world"})"), "events[0].coordinates: 'world' is none of model, scene."},
        {"NegativeScale", sessionWith(R"("placement": {"scale": -1})"), "placement.scale: -1 is out of range"},
        {"WrongParam", sessionWith(R"("params": {"gravty": 1})"), "params.gravty: there is no parameter \"gravty\"; known are time_step"},
        {"ParamOutOfRange", sessionWith(R"("params": {"iterations": 1000})"), "params.iterations: \"iterations\" must lie between 1 and 60"},
        {"ParamOfWrongType", sessionWith(R"("params": {"time_step": [0, 0, 0]})"), "params.time_step: "},
        {"ParamAsText", sessionWith(R"("params": {"time_step": "NaN"})"), "params.time_step: \"time_step\" takes one number from 0.0005 to 0.02 s."},
        {"ParamAsTruth", sessionWith(R"("params": {"iterations": true})"), "params.iterations: \"iterations\" takes one number from 1 to 60, or \"auto\"."},
        {"EventsNoList", sessionWith(R"("events": {})"), "events: expected a list"},
        {"EventNoObject", sessionWithEvent("1"), "events[0]: expected an object"},
        {"EventWithoutStep", sessionWithEvent(R"({"type": "lift"})"), "events[0].step: this key is missing"},
        {"EventAfterTheEnd", sessionWithEvent(R"({"step": 101, "type": "lift"})"), "events[0].step: 101 is out of range (0 to 100)"},
        {"EventWithoutType", sessionWithEvent(R"({"step": 1})"), "events[0].type: this key is missing"},
        {"UnknownType", sessionWithEvent(R"({"step": 1, "type": "slice"})"), "events[0].type: there is no event type 'slice'"},
        {"Continues", sessionWithEvent(R"({"step": 1, "type": "set", "name": "friction", "value": 1, "continues": 1})"), "events[0].continues: expected true or false"},
        {"TwoNumbers", sessionWithEvent(R"({"step": 1, "type": "blade", "a": [1, 2], "b": [1, 2, 3]})"), "events[0].a: expected three numbers"},
        {"TextInVector", sessionWithEvent(R"({"step": 1, "type": "blade", "a": [1, 2, "3"], "b": [1, 2, 3]})"), "events[0].a: expected three numbers"},
        {"FarAway", sessionWithEvent(R"({"step": 1, "type": "blade", "a": [1, 2, 1e9], "b": [1, 2, 3]})"), "events[0].a[2]: 1e+09 is out of range"},
        {"NoLength", sessionWithEvent(R"({"step": 1, "type": "blade", "a": [1, 2, 3], "b": [1, 2, 3]})"), "events[0].a: a and b are the same point"},
        {"SetUnknown", sessionWithEvent(R"({"step": 1, "type": "set", "name": "x", "value": 1})"), "events[0].name: there is no parameter \"x\""},
        {"SetWithoutValue", sessionWithEvent(R"({"step": 1, "type": "set", "name": "floor"})"), "events[0].value: this key is missing"},
        {"SetOutOfRange", sessionWithEvent(R"({"step": 1, "type": "set", "name": "time_step", "value": 1})"), "events[0].value: \"time_step\" must lie between"},
        {"AbsoluteFile", sessionWithEvent(R"({"step": 1, "type": "screenshot", "file": "/a.png"})"), "events[0].file: '/a.png' is not a file inside"},
        {"FileAbove", sessionWithEvent(R"({"step": 1, "type": "screenshot", "file": "x/../../a.png"})"), "events[0].file: 'x/../../a.png' is not a file inside"},
        {"FileIsFolder", sessionWithEvent(R"({"step": 1, "type": "export", "file": "x/"})"), "events[0].file: 'x/' is not a file inside"},
        {"OwnFile", sessionWithEvent(R"({"step": 1, "type": "export", "file": "./final.ply"})"), "events[0].file: './final.ply' is written by the replay itself"},
        {"FileInOwnFile", sessionWithEvent(R"({"step": 1, "type": "screenshot", "file": "summary.json/x.png"})"), "events[0].file: 'summary.json/x.png' is written by the replay itself"},
        {"FileInFile", sessionWithEvent(R"({"step": 1, "type": "screenshot", "file": "a.png"}, {"step": 1, "type": "screenshot", "file": "a.png/b.png"})"), "events: 'a.png/b.png' can't lie in 'a.png'"},
        {"NoPng", sessionWithEvent(R"({"step": 1, "type": "screenshot", "file": "a.jpg"})"), "events[0].file: 'a.jpg' must end in .png"},
        {"NoMesh", sessionWithEvent(R"({"step": 1, "type": "export", "file": "a.fbx"})"), "events[0].file: 'a.fbx' must end in"},
        {"HugePicture", sessionWithEvent(R"({"step": 1, "type": "screenshot", "file": "a.png", "width": 100000})"), "events[0].width: 1e+05 is out of range"},
        {"EmptyCheck", sessionWithEvent(R"({"step": 1, "type": "check"})"), "events[0]: a check needs"},
        {"ShortHash", sessionWithEvent(R"({"step": 1, "type": "check", "hash": "12"})"), "events[0].hash: expected 16"},
        {"EyeAtTarget", sessionWith(R"("view": {"eye": [1, 1, 1], "target": [1, 1, 1]})"), "view: eye and target are the same"},
        {"UpAlongView", sessionWith(R"("view": {"eye": [0, 5, 0], "target": [0, 1, 0]})"), "view.up: up must not point"},
        {"DarkerThanBlack", sessionWith(R"("view": {"eye": [0, 5, 0], "target": [0, 1, 1], "skin": [0, -0.1, 0]})"), "view.skin[1]: -0.1 is out of range (0 to 1)."},
        {"FlatView", sessionWith(R"("view": {"eye": [0, 5, 0], "target": [0, 1, 1], "fov_y": 180})"), "view.fov_y: 180 is out of range"}};
    // clang-format on
    return sessions;
}

}  // namespace kerf::test
