#pragma once

#include "app/regression/expectation.h"
#include "app/regression/picture_check.h"
#include "app/regression/run_trace.h"
#include "app/session/hash_trace.h"
#include "app/session/session.h"

namespace kerf::app {

/// A screenshot of a session.
struct TakenPicture {
    std::string file;
    int step = 0;  ///< before which it is taken; the last one of a name
};

/// The compared results of a replay.
struct RunResults {
    std::filesystem::path folder;
    Driver driver;
    std::string stateHash;
    std::vector<std::string> failures;  ///< of checks and invariants during the run
    std::vector<std::string> messages;  ///< about problems in steps
    std::vector<TakenPicture> pictures;
    HashTrace hashes;
    RunTrace trace;
    PieceTrace pieces;
};
/// Reads the results of `kerf replay --hashes --pieces` of a session. Throws InputError.
RunResults readResults(const std::filesystem::path& folder, const Session& session);

/// A difference of a run from its expectation.
struct Finding {
    /// "topology", "positions and velocities", "volume", "picture", "check", ...
    std::string part;
    int step = -1;         ///< the first that differs; -1 for none
    std::string sentence;  ///< one, with step, part and deviation
    std::string file{};    ///< the picture that it is about; "" for none
};
/// The finding about a failure of a run, a sentence that begins with its step.
Finding findingOfCheck(const std::string& failure);

/// The deviation of a run at a step.
struct Deviation {
    int step = 0;
    double value = 0;
};

/// How far pieces are from the expected ones, at the steps that both have [m].
std::vector<Deviation> comparePositions(const PieceTrace& expected, const PieceTrace& found);

/// The result of comparing a run with its expectation.
struct Judgement {
    bool otherDriver = false;  ///< judged by tolerance then
    Driver expectedDriver;     ///< that of the expectation
    std::vector<Finding> findings;
    std::vector<PictureCheck> pictures;
    RunTrace expectedTrace;
    RunTrace trace;
    /// The deviation of boxes around pieces at some steps [m].
    std::vector<Deviation> positions;

    bool holds() const { return findings.empty(); }
};

/// Compares a run with the expectation in a folder, which must have one, and writes pictures of
/// what differs into `differences`. Throws InputError if the expectation can't be read,
/// OutputError.
Judgement judge(const std::filesystem::path& expectationFolder, const RunResults& results,
                const std::filesystem::path& differences);

}  // namespace kerf::app
