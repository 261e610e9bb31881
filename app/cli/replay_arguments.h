#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/replay/film.h"
#include "app/cli/replay/film_strip.h"
#include "app/cli/replay/mesh_sequence.h"
#include "app/session/session.h"

namespace CLI {  // NOLINT(readability-identifier-naming): a name of its authors
class App;
}

namespace kerf::app {

/// The arguments of `kerf replay SESSION --out DIR ...`, parsed.
struct ReplayArguments {
    std::filesystem::path session;
    std::filesystem::path out;
    std::string material;          ///< a name or a file; empty for that of the session
    std::vector<std::string> set;  ///< NAME=VALUE each, behind the material
    bool hashes = false;
    bool pieces = false;
    bool forces = false;
    std::filesystem::path verify;     ///< empty for none
    std::filesystem::path reference;  ///< empty for none
    bool update = false;
    int until = kMaxSteps;
    bool keepGoing = false;
    bool hashChecks = true;
    bool fine = false;
    FilmOptions film;
    StripOptions strip;
    SequenceOptions sequence;
    std::optional<PictureSize> pictureSize;  ///< of the film, and of each picture of the strip
    bool json = false;
    bool jsonl = false;
};

/// Describes the options that fill them in.
void describeReplay(CLI::App& verb, ReplayArguments& arguments);

}  // namespace kerf::app
