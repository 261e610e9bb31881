#pragma once

#include "app/study/study.h"

namespace kerf::app {

/// The file in a run's folder that says which run it was and how it ended.
inline constexpr const char* kRecordFile = "run.json";

/// The identity of a run: if any of it changed, the results are of another run.
struct RunIdentity {
    std::string program;  ///< version of Kerf
    std::string session;  ///< SHA-256 of the session's file
    std::string model;    ///< SHA-256 of the model's file
    std::vector<Setting> settings;
};

/// SHA-256 of the files of a run that a study gathers, by name; "" for one that is missing.
using ResultDigests = std::map<std::string, std::string>;

/// A finished run.
struct RunRecord {
    RunIdentity identity;
    int exitCode = 0;         ///< 128 plus the signal's number if one ended it
    std::string problem;      ///< a clause that says why, if exitCode is not 0
    ResultDigests results{};  ///< after the run
};

/// The identity of a run of a study.
RunIdentity identityOf(const Study& study, const StudyRun& run);
/// The folder of a run.
std::filesystem::path folderOfRun(const std::filesystem::path& out, std::size_t number);

/// The digests of the files in a run's folder.
ResultDigests digestsOf(const std::filesystem::path& folder);

/// The text of run.json.
std::string formatRecord(const RunRecord& record);
/// Reads the run.json of a folder; nothing if missing or unreadable.
std::optional<RunRecord> readRecord(const std::filesystem::path& folder);

/// The state of a run's folder.
struct RunState {
    std::optional<RunRecord> record;  ///< of this run; none where it must be run
    std::string reason;  ///< why it must be run again, in a clause; "" for the first time

    /// Whether it need not be run again.
    bool done() const { return record.has_value() && reason.empty(); }
};
/// Compares the record in a run's folder with the run and with its results there: changed or
/// truncated results are invalid. So are runs that ended for lack of memory, disk or time, or by a
/// signal: they must be run again.
RunState stateOfRun(const Study& study, std::size_t number, const std::filesystem::path& out);

}  // namespace kerf::app
