#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "app/study/study.h"

namespace kerf::app {

/// The file in a run's folder that says which run it was and how it ended.
inline constexpr const char* kRecordFile = "run.json";

/// What tells one run from another: where any of it changed, the results are of another run.
struct RunIdentity {
    std::string program;  ///< version of Kerf
    std::string session;  ///< SHA-256 of the session's file
    std::string model;    ///< SHA-256 of the model's file
    std::vector<Setting> settings;
};

/// SHA-256 of the files of a run that a study gathers, by name; "" for one that is missing.
using ResultDigests = std::map<std::string, std::string>;

/// A run that came to its end.
struct RunRecord {
    RunIdentity identity;
    int exitCode = 0;         ///< 128 and the signal's number where one ended it
    std::string problem;      ///< a clause that says why, where exitCode is not 0
    ResultDigests results{};  ///< as the run left them
};

/// The identity of a run of a study.
RunIdentity identityOf(const Study& study, const StudyRun& run);
/// The folder of a run.
std::filesystem::path folderOfRun(const std::filesystem::path& out, std::size_t number);

/// The digests of what lies in a run's folder.
ResultDigests digestsOf(const std::filesystem::path& folder);

/// The text of run.json.
std::string formatRecord(const RunRecord& record);
/// Reads the run.json of a folder; nothing where there is none that can be read.
std::optional<RunRecord> readRecord(const std::filesystem::path& folder);

/// What a study finds in the folder of one of its runs.
struct RunState {
    std::optional<RunRecord> record;  ///< of this run; none where it must be run
    std::string reason;  ///< why it must be run again, in a clause; "" for the first time

    /// Whether it need not be run: it would end in the same way.
    bool done() const { return record.has_value() && reason.empty(); }
};
/// Compares the record in a run's folder with the run and with its results there: what was changed
/// or cut short since is none. What ended for want of memory, disk or time,
/// or by a signal, is no result of the run: it is to be run again.
RunState stateOfRun(const Study& study, std::size_t number, const std::filesystem::path& out);

}  // namespace kerf::app
