#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/regression/expectation.h"
#include "app/regression/picture_check.h"
#include "app/regression/run_course.h"
#include "app/session/hash_course.h"
#include "app/session/session.h"

namespace kerf::app {

/// A screenshot of a session.
struct TakenPicture {
    std::string file;
    int step = 0;  ///< before which it is taken; of several with one name, that of the last
};

/// What a replay left in its folder, as far as it is compared.
struct RunResults {
    std::filesystem::path folder;
    Driver driver;
    std::string stateHash;
    std::vector<std::string> failures;  ///< of checks and invariants during the run
    std::vector<std::string> messages;  ///< what it said of steps in which something went wrong
    std::vector<TakenPicture> pictures;
    HashCourse hashes;
    Course course;
    PieceCourse pieces;
};
/// Reads the results of `kerf replay --hashes --pieces` of a session. Throws InputError.
RunResults readResults(const std::filesystem::path& folder, const Session& session);

/// Something in which a run is not as expected.
struct Finding {
    /// "topology", "positions and velocities", "volume", "picture", "check", ...
    std::string part;
    int step = -1;         ///< the first at which it shows; -1 where it has none
    std::string sentence;  ///< one, with step, part and how far off
    std::string file{};    ///< the picture that it is about; "" for none
};
/// The finding about a failure of a run, a sentence that begins with its step.
Finding findingOfCheck(const std::string& failure);

/// The deviation of a run at a step.
struct Deviation {
    int step = 0;
    double value = 0;
};

/// What came of comparing a run with its expectation.
struct Judgement {
    bool otherDriver = false;  ///< judged by tolerance then
    Driver expectedDriver;     ///< that of the expectation
    std::vector<Finding> findings;
    std::vector<PictureCheck> pictures;
    Course expectedCourse;
    Course course;
    /// How far boxes around pieces are from where they should be, at some steps [m].
    std::vector<Deviation> positions;

    bool holds() const { return findings.empty(); }
};

/// Compares a run with the expectation in a folder, which must have one, and writes pictures of
/// what differs into `differences`. Throws InputError where the expectation can't be read,
/// OutputError.
Judgement judge(const std::filesystem::path& expectationFolder, const RunResults& results,
                const std::filesystem::path& differences);

}  // namespace kerf::app
