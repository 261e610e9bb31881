#pragma once

#include "render/scene/picture_comparison.h"

namespace kerf::app {

/// Files of an expectation folder, besides hashes.csv and the pictures under their own names.
inline constexpr const char* kExpectedFile = "expected.json";
inline constexpr const char* kTraceFile = "course.csv";
inline constexpr const char* kPieceBoxesFile = "pieces.csv";

/// The folder of a session's expectations: NAME.expected beside NAME.kerf.json.
std::filesystem::path expectationFolder(const std::filesystem::path& session);

/// The driver of a run. Runs on one Driver give the same bits.
struct Driver {
    std::string renderer;  ///< GL_RENDERER
    std::string version;   ///< GL_VERSION

    bool operator==(const Driver&) const = default;
};

/// The tolerances of a run on another driver.
struct Tolerances {
    double positions = 0.05;  ///< of boxes around pieces, as a share of the body's diagonal
    double volume = 0.01;     ///< of the whole, as a share of its volume at the start
    render::PictureLimits pictures = render::kTolerantLimits;  ///< instead of their own limits
};

/// An expected picture.
struct ExpectedPicture {
    std::string file;  ///< as named in the session
    render::ComparisonOptions options;
    std::optional<render::PictureLimits> limits;  ///< instead of the usual ones
};

/// The expectation for a session's runs, without the tables beside it.
struct Expectation {
    std::string kerf;  ///< version of the program that made it
    Driver driver;
    int steps = 0;
    std::string stateHash;
    Tolerances tolerances;
    std::vector<ExpectedPicture> pictures;
};

/// The PNG pictures in a folder of expectations that this expectation does not list. Throws
/// std::filesystem::filesystem_error.
std::vector<std::string> unlistedPictures(const std::filesystem::path& folder,
                                          const Expectation& expectation);

/// Reads an expected.json. Throws InputError naming file and key.
Expectation readExpectation(const std::filesystem::path& file);
/// The text of an expected.json.
std::string formatExpectation(const Expectation& expectation);

}  // namespace kerf::app
