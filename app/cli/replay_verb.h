#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/film.h"
#include "app/cli/film_strip.h"
#include "app/cli/mesh_sequence.h"
#include "app/session/session.h"

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

/// Replaces parameters of a session at its start. Each of `settings` is NAME=VALUE with a value as
/// JSON, or a bare word. Throws UsageError.
void setParameters(Params& params, const std::vector<std::string>& settings);

/// Replays a session headless and prints what came of it on `out`; the first failed check goes to
/// `errors`. Returns the exit code, 0 or 1. Throws what replaySession throws, UsageError and
/// gpu::ContextError.
int replayVerb(ReplayArguments arguments, std::ostream& out, std::ostream& errors);

}  // namespace kerf::app
