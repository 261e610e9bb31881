#pragma once

#include <optional>
#include <string>
#include <vector>

namespace kerf::ui {

/// The course on the time line: the session that is played, or what was done so far.
struct PlaybackState {
    int step = 0;
    int steps = 0;
    bool goesBack = false;  ///< whether earlier steps are kept
    bool played = false;    ///< not the present: events are to come by themselves
    bool loop = false;
    std::optional<int> divergedAt;  ///< the first step that came out differently
};

/// Something that happens at a step of the session: what a replay does there and changes nothing,
/// or a change of the body or of a parameter.
struct SessionMark {
    enum class Kind { picture, exported, check, camera, stroke, change };

    int id = 0;  ///< what RemoveMark asks for
    int step = 0;
    Kind kind = Kind::picture;
    std::string
        text;  ///< name of the file, or what is checked: "2 pieces, state"; none of a camera
};

/// What the time line and the list of marks show.
struct SessionPanelState {
    PlaybackState playback;
    /// Pictures, exports and checks of the session that would be saved now, by step.
    std::vector<SessionMark> marks;
    std::vector<SessionMark> course;  ///< strokes and changes of it, by step
};

}  // namespace kerf::ui
