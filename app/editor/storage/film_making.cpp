#include "app/editor/storage/film_making.h"

#include <algorithm>
#include <string>
#include <vector>

#include "app/files/io/exit_codes.h"
#include "app/files/io/file_io.h"
#include "app/files/io/temporary_folder.h"
#include "app/files/jobs/child_runs.h"

namespace kerf::app {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> argumentsFor(const fs::path& session, const fs::path& film,
                                      const ui::FilmLook& look) {
    std::vector<std::string> words{
        "replay",  session.string(), "--out",   (session.parent_path() / "results").string(),
        "--movie", film.string(),    "--speed", formatNumber(look.speed),
        "--fine",  "--keep-going",   "--jsonl"};  // a line per step
    if (look.width > 0) {
        words.insert(words.end(),
                     {"--size", std::to_string(look.width) + "x" + std::to_string(look.height)});
    }
    if (look.rate > 0) {
        words.insert(words.end(), {"--fps", std::to_string(look.rate)});
    }
    if (look.captions) {
        words.emplace_back("--captions");
    }
    if (look.turntable) {
        words.emplace_back("--turntable");
    }
    return words;
}

}  // namespace

void filmSession(const Session& session, const fs::path& file, const ui::FilmLook& look,
                 WorkProgress& progress) {
    AtomicFile output(file);
    // All lies there until the end, so that nothing is left of a film that was given up.
    const TemporaryFolder folder("kerf-film");
    const fs::path copy = folder.path() / "session.kerf.json";
    const fs::path film = folder.path() / ("film" + file.extension().string());
    writeOutputFile(copy, formatSession(session, folder.path()));
    const auto tell = [&](int done) {
        progress.enter("Step " + std::to_string(std::min(done, session.steps)) + " of " +
                           std::to_string(session.steps),
                       done, session.steps);
    };
    tell(0);
    const ChildOutcome end = runChild(argumentsFor(copy, film, look), progress, tell);
    if (end.exitCode != kExitDone && end.exitCode != kExitCheckFailed) {
        throw OutputError("The video could not be exported: " + sentenceAbout(end, folder.path()));
    }
    progress.enter("Writing");
    output.writeAllOf(film);
    output.commit();
}

}  // namespace kerf::app
