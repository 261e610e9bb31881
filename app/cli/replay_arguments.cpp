#include "app/cli/replay_arguments.h"

#include <CLI/CLI.hpp>

#include "app/cli/option_checks.h"
#include "app/cli/verb.h"
#include "app/files/export/export.h"
#include "app/files/export/export_alembic.h"
#include "app/files/film/film_encoder.h"
#include "app/files/io/file_io.h"
#include "sim/base/text.h"

namespace kerf::app {

namespace {

constexpr int kMostFilmRate = 240;
constexpr int kMostStripPictures = 1000;
constexpr double kLeastFilmSpeed = 0.001;
constexpr double kMostFilmSpeed = 1000;

std::string refuseNoSpeed(const std::string& text) {
    const std::optional<double> value = readNumber(text);
    const bool valid = value && *value >= kLeastFilmSpeed && *value <= kMostFilmSpeed;
    return valid ? "" : "'" + text + "' is no number from 0.001 to 1000";
}

/// Options that change what is run.
void describeReplayChanges(CLI::App& verb, ReplayArguments& arguments) {
    verb.add_option("--set", arguments.set,
                    "Replace a parameter at the start; VALUE is JSON. May be given several times")
        ->type_name("NAME=VALUE")
        ->allow_extra_args(false);
    verb.add_option("--material", arguments.material,
                    "Give the body another material at the start: a name, or a file (.json)")
        ->check(refuseEmpty)
        ->type_name("NAME|FILE");
    verb.add_flag_callback(
        "--fine", [&arguments] { arguments.quality = render::Quality::full; },
        "Take screenshots as with Fine picture: for looking at, not for comparing");
    verb.add_option("--until", arguments.until, "End after that many steps")
        ->check(CLI::Range(1, kMaxSteps))
        ->type_name("STEP");
}

/// Options that compare the run with another one, or write what later runs can be compared with.
void describeReplayChecks(CLI::App& verb, ReplayArguments& arguments) {
    verb.add_flag("--hashes", arguments.hashes, "Also write hashes.csv: the state after each step");
    verb.add_flag("--pieces", arguments.pieces,
                  "Also write pieces.csv: volume and box of each piece after each step");
    verb.add_flag("--forces", arguments.forces,
                  "Measure force and moment on a blade that pushes, in metrics.csv");
    verb.add_option("--verify", arguments.verifyName,
                    "Compare each step with a hashes.csv; end at the first one that differs")
        ->check(refuseEmpty)
        ->type_name("FILE");
    CLI::Option* reference =
        verb.add_option("--reference", arguments.reference,
                        "Compare each screenshot with the one of its name in this folder")
            ->check(refuseEmpty)
            ->type_name("REF");
    verb.add_flag("--update", arguments.update,
                  "Write screenshots that differ or are missing into REF instead")
        ->needs(reference);
    verb.add_flag("--keep-going", arguments.keepGoing, "Run all steps, also after a check failed");
    verb.add_flag("!--no-hash-checks", arguments.hashChecks,
                  "Ignore the state hashes in the session's own checks");
}

/// The film, and how it looks.
void describeFilm(CLI::App& verb, ReplayArguments& arguments) {
    FilmOptions& film = arguments.film;
    CLI::Option* const movie =
        verb.add_option("--movie", film.file,
                        "Also make a film of the run, by ffmpeg; FILE ends in " + filmEndings())
            ->check(refuseEmpty)
            ->type_name("FILE");
    verb.add_option("--fps", film.rate, "Frames per second of the film (30, of a .gif 25)")
        ->check(CLI::Range(1, kMostFilmRate))
        ->type_name("N")
        ->needs(movie);
    verb.add_option("--speed", film.speed,
                    "Simulated seconds per second of the film (1): 0.25 slows it down")
        ->check(refuseNoSpeed)
        ->type_name("S")
        ->needs(movie);
    verb.add_flag("--turntable", film.turntable, "Turn the camera once about the scene")
        ->needs(movie);
    verb.add_flag("--captions", film.captions, "Caption the film with the time and events")
        ->needs(movie);
}

int readCount(const std::string& text) {
    const std::optional<double> value = readNumber(text);
    if (!value || *value < 0 || *value > kMostStripPictures || *value != std::floor(*value)) {
        throw CLI::ValidationError("--strip", "'" + text + "' is no number of pictures");
    }
    return static_cast<int>(*value);
}

/// Pictures of the run in files that are named here.
void describeFilms(CLI::App& verb, ReplayArguments& arguments) {
    describeFilm(verb, arguments);
    verb.add_option_function<std::vector<std::string>>(
            "--strip",
            [&arguments](const std::vector<std::string>& words) {
                arguments.strip.file = words[0];
                arguments.strip.pictures = readCount(words[1]);
            },
            "Also make one picture (.png) of N pictures of the run side by side")
        ->type_size(2)
        ->expected(1)
        ->type_name("FILE N");
    addPictureSize(
        verb, [&arguments](const PictureSize& size) { arguments.pictureSize = size; },
        "Size of the film in pixels, or of each picture of the strip");
}

/// "obj, ply, ...": the formats as the command line names them.
std::string meshFormatNames() {
    return joined(meshFormats(), ", ",
                  [](const MeshFormatInfo& info) { return info.extension.substr(1); });
}

std::string refuseNoMeshFormat(const std::string& name) {
    return meshFormatOf("mesh." + name)
               ? ""
               : "'" + name + "' is no format; there are " + meshFormatNames();
}

/// Meshes on the way.
void describeSequence(CLI::App& verb, ReplayArguments& arguments) {
    CLI::Option* const sequence =
        verb.add_option("--sequence", arguments.sequence.every,
                        "Also write the mesh at this interval of steps, into the folder sequence")
            ->check(CLI::Range(1, kMaxSteps))
            ->type_name("EVERY");
    verb.add_option_function<std::string>(
            "--meshes",
            [&arguments](const std::string& name) {
                arguments.sequence.format = *meshFormatOf("mesh." + name);
            },
            "The format of these meshes (ply): " + meshFormatNames())
        ->check(refuseNoMeshFormat)
        ->type_name("FORMAT")
        ->needs(sequence);
    CLI::Option* const cache =
        verb.add_option("--cache", arguments.cache.file,
                        "Also write the body over time as an Alembic cache; FILE ends in .abc")
            ->check([](const std::string& file) {
                return isCacheFile(file) ? "" : "'" + file + "' does not end in .abc";
            })
            ->type_name("FILE");
    verb.add_option("--cache-every", arguments.cache.every,
                    "Steps from one sample of the cache to the next (1)")
        ->check(CLI::Range(1, kMaxSteps))
        ->type_name("STEPS")
        ->needs(cache);
}

/// Clients from outside.
void describeLink(CLI::App& verb, ReplayArguments& arguments) {
    const auto read = [&arguments](const std::string& text) {
        arguments.serve = readLinkAddress(text);
        if (!arguments.serve) {
            throw CLI::ValidationError(
                "--serve", "'" + text + "' is no [ADDRESS:]PORT, such as 127.0.0.1:18944");
        }
    };
    CLI::Option* const serve =
        verb.add_option_function<std::string>(
                "--serve", read, "Let clients of OpenIGTLink lead the blade, of this machine alone")
            ->type_name("[ADDRESS:]PORT")
            ->excludes("--strip");
    verb.add_option("--bodies", arguments.linkBodies,
                    "So many times a second they get the body (25); 0 for never")
        ->check(CLI::Range(0, kMostFilmRate))
        ->type_name("N")
        ->needs(serve);
    verb.add_option("--record", arguments.record, "Write what they did as a session")
        ->check(refuseEmpty)
        ->type_name("FILE")
        ->needs(serve);
}

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

void describeReplay(CLI::App& verb, ReplayArguments& arguments) {
    verb.add_option("SESSION", arguments.session, "A *.kerf.json file, or the .journal of a window")
        ->required()
        ->check(refuseEmpty);
    addOut(verb, arguments.out, "Folder for the results")->required();
    describeReplayChanges(verb, arguments);
    describeReplayChecks(verb, arguments);
    describeFilms(verb, arguments);
    describeSequence(verb, arguments);
    describeLink(verb, arguments);
    CLI::Option* json = verb.add_flag("--json", arguments.json, "Print one JSON object");
    verb.add_flag("--jsonl", arguments.jsonl, "Print a JSON object after each step")
        ->excludes(json);
}

void checkReplayTargets(const Session& session, const ReplayArguments& arguments) {
    const std::vector<fs::path> inputs = inputsOf(session, arguments);
    std::vector<fs::path> results = resultsOf(session, arguments);
    requireKept(inputs, results, session, arguments.out);
    requireOwnFile("--movie", arguments.film.file, inputs, results);
    requireOwnFile("--strip", arguments.strip.file, inputs, results);
    requireOwnFile("--cache", arguments.cache.file, inputs, results);
    requireOwnFile("--record", arguments.record, inputs, results);
    requireFreeSequence(session, arguments);
}

}  // namespace kerf::app
