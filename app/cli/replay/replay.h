#pragma once

#include "app/cli/replay/film.h"
#include "app/cli/replay/film_strip.h"
#include "app/cli/replay/mesh_sequence.h"
#include "app/session/hash_trace.h"
#include "app/session/metrics.h"
#include "app/session/session.h"
#include "render/scene/scene.h"

namespace kerf::app {

class LinkServer;

/// Callbacks of a replay; either may be null.
struct ReplayListener {
    /// Called before each step with the steps done and the steps to do.
    std::function<void(int done, int total)> progress;
    /// Called after each step with its row of metrics.csv.
    std::function<void(const MetricsRow& row)> row;
};

/// The Alembic cache of a run.
struct CacheOptions {
    std::filesystem::path file;  ///< see isCacheFile(); empty for none
    int every = 1;               ///< steps from one sample to the next
};

/// Options of a replay besides the session.
struct ReplayOptions {
    bool hashes = false;                ///< writes hashes.csv
    bool pieces = false;                ///< writes pieces.csv
    bool forces = false;                ///< measures the load on the blade
    const HashTrace* verify = nullptr;  ///< hashes that the steps must have; not owned
    std::string verifyName;             ///< of the file with these hashes, for messages
    int until = kMaxSteps;              ///< ends after that many steps at most
    bool keepGoing = false;             ///< runs on after a check failed
    bool hashChecks = true;             ///< false: ignores state hashes in check events
    FilmOptions film;                   ///< if its file is set
    StripOptions strip;                 ///< if its file is set
    SequenceOptions sequence;           ///< where it names steps
    CacheOptions cache;                 ///< if its file is set
    /// Its clients lead the blade instead of the session, a step in its time, from the first one's
    /// arrival until the last one has left, or `until`. Not owned; null for none.
    LinkServer* link = nullptr;
    int linkBodies = 25;           ///< so many times a second they get the body
    std::filesystem::path record;  ///< what they did, as a session; empty for no file
    /// The tier of the pictures; only the light one looks the same on every driver.
    render::Quality quality = render::Quality::light;
};

/// The result of a replay.
struct ReplayResult {
    RunSummary summary;
    /// The files that were written, relative to the output folder, in the order of writing.
    std::vector<std::string> files;
    std::optional<FilmReport> film;  ///< where one was made
    int cacheSamples = 0;            ///< where a cache was written
};

/// Runs a session as fast as it can on the OpenGL context that is current and writes metrics.csv,
/// summary.json, final.ply, the session's screenshots and its exports into `folder` (made where it
/// is missing) and nowhere else, but for the film, the strip and the cache of `options`, whose
/// files a person named. Every file appears complete or not at all; results of an earlier run under
/// these names are removed first, and summary.json comes last. A check that fails stands in
/// summary.failures and, unless options.keepGoing, ends the run before the coming step. `model` is
/// loadSessionModel(session).
///
/// Throws InputError naming the event that cannot happen (nothing to undo, no such box),
/// OutputError, gpu::ShaderError, gpu::OutOfMemory; and MemoryShortage before anything is done.
ReplayResult replaySession(const Session& session, ModelMesh model,
                           const std::filesystem::path& folder, const ReplayListener& listener,
                           const ReplayOptions& options = {});

}  // namespace kerf::app
