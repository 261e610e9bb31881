#pragma once

#include "sim/base/params.h"

namespace kerf::app {

/// Most runs of a study; beyond them it is refused.
inline constexpr std::size_t kMostRuns = 100'000;

/// A session that a study runs.
struct StudySession {
    std::string name;            ///< as named in the study
    std::filesystem::path file;  ///< absolute
    std::string sha256;          ///< of the file
    std::string modelSha256;     ///< of its model's file
    Params params;               ///< at its start
    int models = 0;              ///< their number; 0 if not read
};

/// A parameter that a run sets.
struct Setting {
    std::string name;
    std::string value;  ///< as JSON
};

/// One run of a study.
struct StudyRun {
    std::size_t session = 0;  ///< in Study::sessions
    std::vector<Setting> settings;
};

/// A *.json file with sessions and the parameters to run them with: see docs/sweeps.md.
struct Study {
    std::string name;  ///< of the file, up to its first dot
    std::vector<StudySession> sessions;
    std::vector<std::string> parameters;  ///< those that any run sets, in the file's order
    std::vector<StudyRun> runs;           ///< by number: session by session
    std::vector<std::string> warnings;    ///< unknown extra keys

    const StudySession& sessionOf(const StudyRun& run) const { return sessions[run.session]; }
};

/// Reads and checks a study with all its sessions. Throws InputError naming the file and the place
/// in it ("study.json: grid.time_step[1]: ...").
Study readStudy(const std::filesystem::path& file);
/// readStudy() for one run: reads only that run's session, or none if there is no such run.
Study readStudyForRun(const std::filesystem::path& file, std::size_t number);

/// A value as a session writes it: 0.5, [0, -9.81, 0], null, "pbd".
std::string valueText(const ParamValue& value);
/// The value of a parameter at the start of a run, whether the run sets it or its session.
std::string startValue(const Study& study, const StudyRun& run, const std::string& parameter);
/// The settings of a run, for people: "time_step=0.003 floor=null"; "" for none.
std::string settingsText(const StudyRun& run);

}  // namespace kerf::app
