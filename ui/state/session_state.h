#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ui/state/practice_state.h"

namespace kerf::ui {

/// The timeline: the played session, or what was done so far.
struct PlaybackState {
    int step = 0;
    int steps = 0;
    bool goesBack = false;  ///< whether earlier steps are kept
    bool played = false;    ///< events are still to come
    bool loop = false;
    std::optional<int> divergedAt;  ///< the first step that differed
};

/// A mark at a step of the session: an output or check of a replay, or a change of the body or of a
/// parameter.
struct SessionMark {
    enum class Kind { picture, exported, check, camera, stroke, change };

    int id = 0;  ///< for RemoveMark
    int step = 0;
    Kind kind = Kind::picture;
    std::string
        text;  ///< name of the file, or what is checked: "2 pieces, state"; none of a camera
};

/// The state of the timeline and the list of marks.
struct SessionPanelState {
    bool unsaved = false;  ///< something was done that no file has
    PlaybackState playback;
    /// Pictures, exports and checks of the session that would be saved now, by step.
    std::vector<SessionMark> marks;
    std::vector<SessionMark> past;  ///< strokes and changes of it, by step
    PracticeState practice;
};

}  // namespace kerf::ui
