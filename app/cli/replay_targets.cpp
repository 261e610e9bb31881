#include "app/cli/replay_targets.h"

#include <algorithm>
#include <string>
#include <vector>

#include "app/cli/usage_error.h"
#include "app/files/export/export.h"
#include "app/files/io/file_io.h"

namespace kerf::app {

namespace {

namespace fs = std::filesystem;

/// One way to write a path: links are followed as far as there is something.
fs::path placeOf(const fs::path& file) {
    std::error_code error;
    fs::path whole = fs::weakly_canonical(fs::absolute(file, error), error);
    return error ? fs::absolute(file).lexically_normal() : whole;
}

bool contains(const std::vector<fs::path>& files, const fs::path& file) {
    return std::ranges::find(files, placeOf(file)) != files.end();
}

/// What the run writes or removes below its output folder.
std::vector<fs::path> resultsOf(const Session& session, const ReplayArguments& arguments) {
    const bool keepsHashes = !arguments.verifyName.empty() && !arguments.hashes;
    std::vector<fs::path> files;
    for (const char* name : kReplayFiles) {
        if (std::string_view(name) != kHashesFile || !keepsHashes) {
            files.push_back(placeOf(arguments.out / name));
        }
    }
    for (const SessionEvent& event : session.events) {
        if (const auto* picture = std::get_if<ScreenshotEvent>(&event.action)) {
            files.push_back(placeOf(arguments.out / picture->file));
            if (!arguments.reference.empty()) {
                files.push_back(placeOf(arguments.out / "diff" / picture->file));
            }
        } else if (const auto* mesh = std::get_if<ExportEvent>(&event.action)) {
            files.push_back(placeOf(arguments.out / mesh->file));
        }
    }
    return files;
}

/// What a person named to read, as they named it.
std::vector<fs::path> inputsOf(const Session& session, const ReplayArguments& arguments) {
    std::vector<fs::path> files = modelFiles(session);
    files.push_back(arguments.session);
    std::error_code error;
    if (fs::exists(arguments.material, error)) {
        files.emplace_back(arguments.material);
    }
    if (!arguments.verifyName.empty()) {
        files.emplace_back(arguments.verifyName);
    }
    if (!arguments.reference.empty()) {
        for (const std::string& picture : pictureFiles(session)) {
            files.push_back(arguments.reference / picture);
        }
    }
    return files;
}

/// How many pieces there will be is not known: all their files count.
bool isOfPieces(const fs::path& file, const Session& session, const fs::path& out) {
    return std::ranges::any_of(session.events, [&](const SessionEvent& event) {
        const auto* mesh = std::get_if<ExportEvent>(&event.action);
        return mesh != nullptr && mesh->filePerPiece &&
               isPieceFile(placeOf(file), placeOf(out / mesh->file));
    });
}

void requireKept(const std::vector<fs::path>& inputs, const std::vector<fs::path>& results,
                 const Session& session, const fs::path& out) {
    for (const fs::path& input : inputs) {
        if (contains(results, input) || isOfPieces(input, session, out)) {
            throw UsageError("--out: the replay reads " + shownPath(input) +
                             " and would write over it; choose another folder");
        }
    }
}

/// A film or a strip, which has a name of its own.
void requireOwnFile(const char* option, const fs::path& file, const std::vector<fs::path>& inputs,
                    std::vector<fs::path>& results) {
    if (file.empty()) {
        return;
    }
    std::vector<fs::path> read;
    std::ranges::transform(inputs, std::back_inserter(read), placeOf);
    const bool isInput = contains(read, file);
    if (isInput || contains(results, file)) {
        throw UsageError(
            std::string(option) + " " + shownPath(file) + ": " +
            (isInput ? "the replay reads this file" : "the replay writes another result there") +
            "; choose another name");
    }
    results.push_back(placeOf(file));
}

/// A sequence has the whole folder of its name.
void requireFreeSequence(const Session& session, const ReplayArguments& arguments) {
    if (arguments.sequence.every == 0) {
        return;
    }
    for (const SessionEvent& event : session.events) {
        const auto* mesh = std::get_if<ExportEvent>(&event.action);
        if (mesh != nullptr && *fs::path(mesh->file).begin() == kSequenceFolder) {
            throw UsageError("--sequence: the session exports " + mesh->file +
                             " into the folder of the sequence; give it another name there");
        }
    }
}

}  // namespace

void checkReplayTargets(const Session& session, const ReplayArguments& arguments) {
    const std::vector<fs::path> inputs = inputsOf(session, arguments);
    std::vector<fs::path> results = resultsOf(session, arguments);
    requireKept(inputs, results, session, arguments.out);
    requireOwnFile("--movie", arguments.film.file, inputs, results);
    requireOwnFile("--strip", arguments.strip.file, inputs, results);
    requireFreeSequence(session, arguments);
}

}  // namespace kerf::app
