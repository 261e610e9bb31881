#pragma once

#include <filesystem>
#include <iosfwd>

namespace kerf::app {

/// The arguments of `kerf replay SESSION --out DIR [--json]`, parsed.
struct ReplayArguments {
    std::filesystem::path session;
    std::filesystem::path out;
    bool json = false;
};

/// Replays a session headless and prints what came of it on `out`; the first failed check goes to
/// `errors`. Returns the exit code, 0 or 1. Throws what replaySession throws, and
/// gpu::ContextError.
int replayVerb(const ReplayArguments& arguments, std::ostream& out, std::ostream& errors);

}  // namespace kerf::app
