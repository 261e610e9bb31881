// Sessions short enough to be run several times in a test.
#pragma once

namespace kerf::test {

/// A small sphere, cut in two while it rests, then dropped.
inline std::string smallSession(const std::string& moreEvents = "") {
    return R"({"format": "kerf-session", "version": 1, "model": {"builtin": "sphere80"},
      "params": {"iterations": 8, "gravity": [0, 0, 0], "floor": -0.55}, "steps": 40,
      "events": [
        {"step": 1, "type": "blade", "a": [-0.8, 0.62, 0.02], "b": [0.8, 0.58, 0.05]},
        {"step": 13, "type": "blade", "a": [-0.8, -0.68, 0.02], "b": [0.8, -0.72, 0.05]},
        {"step": 14, "type": "lift"},
        {"step": 16, "type": "set", "name": "gravity", "value": [0, -9.81, 0]},
        {"step": 8, "type": "screenshot", "file": "pictures/half.png", "width": 96, "height": 64},
        {"step": 40, "type": "screenshot", "file": "end.png", "width": 96, "height": 64},
        {"step": 40, "type": "export", "file": "end.obj"},
        {"step": 40, "type": "check", "pieces": 2})" +
           moreEvents + "]}";
}

/// One stroke over 40 of 60 steps, through a sphere that rests, and what follows.
inline std::string sliceSession(const std::string& moreEvents) {
    return R"({"format": "kerf-session", "version": 1, "model": {"builtin": "sphere80"},
        "params": {"gravity": [0, 0, 0], "floor": null, "iterations": 4}, "steps": 60,
        "events": [{"step": 1, "type": "blade", "a": [-2, 1.5, 0.1], "b": [2, 1.5, 0.1]},
                   {"step": 40, "type": "blade", "a": [-2, -1.5, 0.1], "b": [2, -1.5, 0.1]})" +
           moreEvents + "]}";
}

inline const std::string kLift = R"(, {"step": 41, "type": "lift"})";

/// A whole sphere of 20 triangles to which these events happen.
inline std::string sessionThatDoes(const std::string& events, int steps = 5) {
    return R"({"format": "kerf-session", "version": 1, "model": {"builtin": "sphere20"},
              "params": {"gravity": [0, 0, 0], "floor": null}, "steps": )" +
           std::to_string(steps) + R"(, "events": [)" + events + "]}";
}

}  // namespace kerf::test
