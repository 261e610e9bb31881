#pragma once

#include "app/cli/replay/replay.h"
#include "app/link/link_server.h"
#include "app/session/session.h"

namespace CLI {  // NOLINT(readability-identifier-naming): a name of its authors
class App;
}

namespace kerf::app {

/// The arguments of `kerf replay SESSION --out DIR ...`, parsed.
struct ReplayArguments : ReplayOptions {
    std::filesystem::path session;
    std::filesystem::path out;
    std::string material;             ///< a name or a file; empty for that of the session
    std::vector<std::string> set;     ///< NAME=VALUE each, after the material
    std::filesystem::path reference;  ///< empty for none
    bool update = false;
    std::optional<PictureSize> pictureSize;  ///< of the film, and of each picture of the strip
    std::optional<sockaddr_in> serve;        ///< for OpenIGTLink
    bool json = false;
    bool jsonl = false;
};

/// Describes the options that set them.
void describeReplay(CLI::App& verb, ReplayArguments& arguments);

/// Throws UsageError if a replay would overwrite an input (session, models, material, hashes,
/// reference pictures), or write two results to one file.
void checkReplayTargets(const Session& session, const ReplayArguments& arguments);

}  // namespace kerf::app
