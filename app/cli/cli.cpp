#include "app/cli/cli.h"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <iostream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/cli/compare_verb.h"
#include "app/cli/doctor_verb.h"
#include "app/cli/inspect_verb.h"
#include "app/cli/materials_verb.h"
#include "app/cli/program.h"
#include "app/cli/replay_verb.h"
#include "app/cli/sweep_verb.h"
#include "app/cli/test_verb.h"
#include "app/editor/editor.h"
#include "app/files/film/film_formats.h"
#include "app/files/import/import_process.h"
#include "app/files/io/exit_codes.h"
#include "app/files/io/file_io.h"
#include "app/files/jobs/own_programs.h"
#include "app/session/material.h"
#include "app/session/session_schema.h"
#include "app/study/study.h"
#include "sim/base/text.h"

namespace kerf::app {

namespace {

constexpr int kMostJobs = 256;
constexpr int kMostFilmRate = 240;
constexpr int kMostStripPictures = 1000;
constexpr double kLeastFilmSpeed = 0.001;
constexpr double kMostFilmSpeed = 1000;

// Kinds of files that have a schema.
constexpr const char* kSessionKind = "session";
constexpr const char* kMaterialKind = "material";

constexpr const char* kExperiment = "experiment";  // a verb

/// What the command line asks for.
struct Arguments {
    std::filesystem::path file;  ///< for the editor; empty for none
    ReplayArguments replay;
    InspectArguments inspect;
    CompareArguments compare;
    TestArguments test;
    SweepArguments sweep;
    DoctorArguments doctor;
    MaterialsArguments materials;
    std::string schema = kSessionKind;  ///< the kind of files
    std::filesystem::path workerFile;
};

/// The parser and its verbs.
struct Parser {
    CLI::App app{"Kerf cuts soft 3D models in real time. Without a verb it opens the editor."};
    CLI::App* replay = nullptr;
    CLI::App* inspect = nullptr;
    CLI::App* compare = nullptr;
    CLI::App* test = nullptr;
    CLI::App* materials = nullptr;
    CLI::App* schema = nullptr;
    CLI::App* sweep = nullptr;
    CLI::App* doctor = nullptr;
    CLI::App* worker = nullptr;
};

/// A number and nothing else.
std::optional<double> readNumber(const std::string& text) {
    double value = 0;
    const char* end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, value);
    return read.ec == std::errc() && read.ptr == end ? std::optional(value) : std::nullopt;
}

/// CLI::Range lets NaN pass.
std::string refuseOutsideOfOne(const std::string& text) {
    const std::optional<double> value = readNumber(text);
    const bool valid = value && *value >= 0 && *value <= 1;
    return valid ? "" : "'" + text + "' is no number from 0 to 1";
}

std::string refuseNoSpeed(const std::string& text) {
    const std::optional<double> value = readNumber(text);
    const bool valid = value && *value >= kLeastFilmSpeed && *value <= kMostFilmSpeed;
    return valid ? "" : "'" + text + "' is no number from 0.001 to 1000";
}

/// "1280x720"; none where it is no size of a picture.
std::optional<PictureSize> readPictureSize(const std::string& text) {
    PictureSize size;
    const char* const end = text.data() + text.size();
    const auto width = std::from_chars(text.data(), end, size.width);
    if (width.ec != std::errc() || width.ptr == end || *width.ptr != 'x') {
        return std::nullopt;
    }
    const auto height = std::from_chars(width.ptr + 1, end, size.height);
    const auto fits = [](int side) { return side >= 1 && side <= kMaxPictureSize; };
    const bool valid = height.ec == std::errc() && height.ptr == end;
    return valid && fits(size.width) && fits(size.height) ? std::optional(size) : std::nullopt;
}

std::string refuseNoSize(const std::string& text) {
    return readPictureSize(text) ? ""
                                 : "'" + text + "' is no size as 1280x720, each side 1 to " +
                                       std::to_string(kMaxPictureSize);
}

std::string refuseNoLength(const std::string& text) {
    const std::optional<double> length = readNumber(text);
    return length && std::isfinite(*length) && *length > 0
               ? ""
               : "'" + text + "' is no length above zero, such as 0.02";
}

/// Options that change what is run.
void describeReplayChanges(CLI::App& replay, ReplayArguments& arguments) {
    replay
        .add_option("--set", arguments.set,
                    "Replace a parameter at the start; VALUE is JSON. May be given several times")
        ->type_name("NAME=VALUE")
        ->allow_extra_args(false);
    replay
        .add_option("--material", arguments.material,
                    "Give the body another material at the start: a name, or a file (.json)")
        ->check(refuseEmpty)
        ->type_name("NAME|FILE");
    replay.add_flag("--fine", arguments.fine,
                    "Take screenshots as with Fine picture: for looking at, not for comparing");
    replay.add_option("--until", arguments.until, "End after that many steps")
        ->check(CLI::Range(1, kMaxSteps))
        ->type_name("STEP");
}

/// Options that compare the run with another one, or write what later runs can be compared with.
void describeReplayChecks(CLI::App& replay, ReplayArguments& arguments) {
    replay.add_flag("--hashes", arguments.hashes,
                    "Also write hashes.csv: what state each step ended in");
    replay.add_flag("--pieces", arguments.pieces,
                    "Also write pieces.csv: volume and box of each piece after each step");
    replay.add_flag("--forces", arguments.forces,
                    "Measure force and moment on a blade that pushes, in metrics.csv");
    replay
        .add_option("--verify", arguments.verify,
                    "Compare each step with a hashes.csv; end at the first one that differs")
        ->check(refuseEmpty)
        ->type_name("FILE");
    CLI::Option* reference =
        replay
            .add_option("--reference", arguments.reference,
                        "Compare each screenshot with the one of its name in this folder")
            ->check(refuseEmpty)
            ->type_name("REF");
    replay
        .add_flag("--update", arguments.update,
                  "Write screenshots that differ or are missing into REF instead")
        ->needs(reference);
    replay.add_flag("--keep-going", arguments.keepGoing,
                    "Run all steps, also after a check failed");
    replay.add_flag("!--no-hash-checks", arguments.hashChecks,
                    "Pass over the state hashes in the session's own checks");
}

/// The film, and how it looks.
void describeFilm(CLI::App& replay, ReplayArguments& arguments) {
    FilmOptions& film = arguments.film;
    CLI::Option* const movie =
        replay
            .add_option("--movie", film.file,
                        "Also make a film of the run, by ffmpeg; FILE ends in " + filmEndings())
            ->check(refuseEmpty)
            ->type_name("FILE");
    replay.add_option("--fps", film.rate, "Pictures in a second of the film (30, of a .gif 25)")
        ->check(CLI::Range(1, kMostFilmRate))
        ->type_name("N")
        ->needs(movie);
    replay
        .add_option("--speed", film.speed,
                    "Simulated seconds in a second of the film (1): 0.25 slows it down")
        ->check(refuseNoSpeed)
        ->type_name("S")
        ->needs(movie);
    replay.add_flag("--turntable", film.turntable, "The camera turns once about the scene")
        ->needs(movie);
    replay.add_flag("--captions", film.captions, "The film tells the time, and what happens")
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
void describeFilms(CLI::App& replay, ReplayArguments& arguments) {
    describeFilm(replay, arguments);
    replay
        .add_option_function<std::vector<std::string>>(
            "--strip",
            [&arguments](const std::vector<std::string>& words) {
                arguments.strip.file = words[0];
                arguments.strip.pictures = readCount(words[1]);
            },
            "Also make a picture (.png) of so many pictures of the run side by side")
        ->type_size(2)
        ->expected(1)
        ->type_name("FILE N");
    replay
        .add_option_function<std::string>(
            "--size",
            [&arguments](const std::string& text) {
                arguments.pictureSize = readPictureSize(text);
            },
            "Size of the film in pixels, or of each picture of the strip")
        ->type_name("WxH")
        ->check(refuseNoSize);
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
void describeSequence(CLI::App& replay, ReplayArguments& arguments) {
    CLI::Option* const sequence =
        replay
            .add_option("--sequence", arguments.sequence.every,
                        "Also write the mesh every so many steps, into the folder sequence")
            ->check(CLI::Range(1, kMaxSteps))
            ->type_name("EVERY");
    replay
        .add_option_function<std::string>(
            "--meshes",
            [&arguments](const std::string& name) {
                arguments.sequence.format = *meshFormatOf("mesh." + name);
            },
            "The format of these meshes (ply): " + meshFormatNames())
        ->check(refuseNoMeshFormat)
        ->type_name("FORMAT")
        ->needs(sequence);
}

void describeReplay(Parser& parser, Arguments& arguments) {
    parser.replay = parser.app.add_subcommand(
        "replay", "Run a session headless, as fast as it can, and write its results");
    parser.replay
        ->add_option("SESSION", arguments.replay.session,
                     "A *.kerf.json file, or a .journal that a window left behind")
        ->required()
        ->check(refuseEmpty);
    parser.replay->add_option("--out", arguments.replay.out, "Folder for the results")
        ->required()
        ->check(refuseEmpty)
        ->type_name("DIR");
    describeReplayChanges(*parser.replay, arguments.replay);
    describeReplayChecks(*parser.replay, arguments.replay);
    describeFilms(*parser.replay, arguments.replay);
    describeSequence(*parser.replay, arguments.replay);
    CLI::Option* json =
        parser.replay->add_flag("--json", arguments.replay.json, "Print one JSON object");
    parser.replay
        ->add_flag("--jsonl", arguments.replay.jsonl,
                   "Print a JSON object for each step, as it is done")
        ->excludes(json);
}

std::string refuseNoPng(const std::string& text) {
    const bool isPng = lowerCase(std::filesystem::path(text).extension().string()) == ".png";
    return isPng ? "" : "'" + text + "' must end in .png";
}

void describeInspect(Parser& parser, Arguments& arguments) {
    parser.inspect =
        parser.app.add_subcommand("inspect", "Say what a model is and whether it can be cut");
    parser.inspect
        ->add_option("MODEL", arguments.inspect.model, "A model file, or the name of a builtin one")
        ->required()
        ->check(refuseEmpty);
    CLI::Option* const json =
        parser.inspect->add_flag("--json", arguments.inspect.json, "Print one JSON object");
    CLI::Option* const pieces =
        parser.inspect
            ->add_flag("--pieces", arguments.inspect.pieces,
                       "Print a table of the pieces as CSV: volume, areas, centre, box")
            ->excludes(json);
    Mending& mending = arguments.inspect.mending;
    const auto mends = [&](const char* name, const char* meaning, const auto& ask) {
        return parser.inspect->add_option(name, arguments.inspect.mended, meaning)
            ->type_name("OUT.ply")
            ->check(refuseEmpty)
            ->excludes(pieces)
            ->each([ask](const std::string&) { ask(); });
    };
    CLI::Option* const repair =
        mends("--repair", "Write the model here as a repair leaves it, and report that one", [] {});
    CLI::Option* const remesh =
        mends("--remesh", "Write the model here, repaired and with even triangles", [&mending] {
            mending.remesh = true;
        })->excludes(repair);
    CLI::Option* const thicken =
        mends("--thicken", "Write the model here, repaired, its open sheets given a thickness",
              [&mending] { mending.thicken = mending.thicken.value_or(0); })
            ->excludes(repair)
            ->excludes(remesh);
    CLI::Option* const picture =
        parser.inspect
            ->add_option("--picture", arguments.inspect.picture,
                         "Write a picture (.png) of it here, with its faults as coloured lines")
            ->type_name("FILE.png")
            ->check(refuseNoPng)
            ->excludes(pieces);
    parser.inspect
        ->add_option_function<std::string>(
            "--size",
            [&arguments](const std::string& text) {
                arguments.inspect.pictureSize = *readPictureSize(text);
            },
            "Size of that picture in pixels (1280x720)")
        ->type_name("WxH")
        ->check(refuseNoSize)
        ->needs(picture);
    parser.inspect
        ->add_option("--edge", mending.edge,
                     "Length of their edges in the model's unit; as those of even triangles with "
                     "the same areas, of a coarse model a 25th of its diagonal at most")
        ->type_name("LENGTH")
        ->check(refuseNoLength)
        ->needs(remesh);
    parser.inspect
        ->add_option("--thickness", mending.thicken,
                     "That thickness in the model's unit; a 50th of the model's diagonal, or less "
                     "where the sheet is bent or close to itself")
        ->type_name("LENGTH")
        ->check(refuseNoLength)
        ->needs(thicken);
}

std::string refuseNoMask(const std::string& text) {
    return readMask(text) ? "" : "'" + text + "' is no rectangle X,Y,W,H in whole pixels";
}

/// What decides where no threshold is named.
std::string explainLimits() {
    return "Without --threshold " + describeLimits(render::kStrictLimits) + ";\nwith --tolerant " +
           describeLimits(render::kTolerantLimits) + ".\nVisibly means by more than " +
           formatNumber(render::kVisibleError) + " of LDR-FLIP; a place is " +
           std::to_string(render::kPlaceSide) + " pixels wide.";
}

void describeHowToCompare(CLI::App& verb, CompareArguments& arguments) {
    CLI::Option* threshold =
        verb.add_option("--threshold", arguments.threshold,
                        "Largest mean channel difference that passes, instead of the limits below")
            ->check(refuseOutsideOfOne)
            ->type_name("T");
    verb.add_flag("--tolerant", arguments.tolerant, "Wide limits, for pictures of another driver")
        ->excludes(threshold);
    verb.add_option_function<std::vector<std::string>>(
            "--mask",
            [&arguments](const std::vector<std::string>& masks) {
                for (const std::string& mask : masks) {
                    arguments.masks.push_back(*readMask(mask));
                }
            },
            "A rectangle of pixels to leave out; may be given several times")
        ->check(refuseNoMask)
        ->allow_extra_args(false)
        ->type_name("X,Y,W,H");
}

void describeCompare(Parser& parser, Arguments& arguments) {
    parser.compare = parser.app.add_subcommand("compare", "Compare two PNG pictures");
    parser.compare->add_option("A", arguments.compare.a, "A PNG file")->required();
    parser.compare->add_option("B", arguments.compare.b, "Another one")->required();
    describeHowToCompare(*parser.compare, arguments.compare);
    parser.compare
        ->add_option("--diff", arguments.compare.diff,
                     "Picture of the difference, written only where they differ")
        ->type_name("D.png");
    parser.compare->add_flag("--json", arguments.compare.json, "Print one JSON object");
    parser.compare->footer(explainLimits());
}

void describeTest(Parser& parser, Arguments& arguments) {
    parser.test = parser.app.add_subcommand(
        "test", "Run sessions as regression tests: states, counts, volumes and pictures");
    parser.test
        ->add_option("PATH", arguments.test.paths,
                     "A session, or a folder that is searched for *.kerf.json")
        ->required()
        ->check(refuseEmpty);
    parser.test->add_flag("--update", arguments.test.update,
                          "Make or renew the expectations (NAME.expected beside NAME.kerf.json)");
    parser.test->add_option("--jobs", arguments.test.jobs, "Runs at a time; one per core otherwise")
        ->check(CLI::Range(1, kMostJobs))
        ->type_name("N");
    parser.test->add_option("--junit", arguments.test.junit, "Write the results as JUnit XML")
        ->check(refuseEmpty)
        ->type_name("FILE");
    parser.test
        ->add_option("--report", arguments.test.report,
                     "Write a page with expected, actual and different pictures, and plots")
        ->check(refuseEmpty)
        ->type_name("FILE.html");
    parser.test
        ->add_option("--out", arguments.test.out, "Keep what the runs write, a folder for each")
        ->check(refuseEmpty)
        ->type_name("DIR");
    parser.test->add_flag("--json", arguments.test.json, "Print one JSON object");
}

void describeMaterials(Parser& parser, Arguments& arguments) {
    parser.materials = parser.app.add_subcommand(
        "materials", "List the materials that come with Kerf, or show one with its sources");
    parser.materials
        ->add_option("MATERIAL", arguments.materials.material,
                     "A name of the list, or a material file (.json)")
        ->check(refuseEmpty);
    parser.materials->add_flag("--json", arguments.materials.json, "Print one JSON object");
}

void describeSchema(Parser& parser, Arguments& arguments) {
    parser.schema = parser.app.add_subcommand(
        "schema",
        "Print the JSON Schema of sessions or materials, by which text editors complete and check");
    parser.schema->add_option("KIND", arguments.schema, "session (where left out) or material")
        ->check(CLI::IsMember({kSessionKind, kMaterialKind}));
}

/// What is done instead of the whole sweep; one of these at most.
void describePartsOfSweep(CLI::App& sweep, SweepArguments& arguments) {
    CLI::Option* run =
        sweep.add_option("--run", arguments.run, "Do this run alone, from 0; gather nothing")
            ->check(CLI::Range(std::size_t{0}, kMostRuns - 1))
            ->type_name("K");
    CLI::Option* list =
        sweep.add_flag("--list", arguments.list, "Print a line for each run, and run nothing")
            ->excludes(run);
    sweep
        .add_flag("--gather", arguments.gather,
                  "Write the table and the plots of the runs that are done, and run nothing")
        ->excludes(run)
        ->excludes(list);
    sweep.add_flag("--json", arguments.json, "Print one JSON object")->excludes(run);
}

void describeDoctor(Parser& parser, Arguments& arguments) {
    parser.doctor = parser.app.add_subcommand(
        "doctor", "Check whether Kerf works as it should on this machine's graphics driver");
    parser.doctor->add_flag("--quick", arguments.doctor.quick, "Leave the speed of the models out");
    parser.doctor
        ->add_option("--out", arguments.doctor.out,
                     "Folder for a report with a picture, to look at or to attach to a bug")
        ->check(refuseEmpty)
        ->type_name("DIR");
    parser.doctor->add_flag("--json", arguments.doctor.json, "Print one JSON object");
}

void describeSweep(Parser& parser, Arguments& arguments) {
    parser.sweep = parser.app.add_subcommand(
        "sweep", "Run sessions with many values of parameters; begun anew, it goes on");
    parser.sweep->add_option("STUDY", arguments.sweep.study, "A study: see docs/sweeps.md")
        ->required()
        ->check(refuseEmpty);
    parser.sweep->add_option("--out", arguments.sweep.out, "Folder for the results")
        ->check(refuseEmpty)
        ->type_name("DIR");
    parser.sweep
        ->add_option("--jobs", arguments.sweep.jobs, "Runs at a time; one per core otherwise")
        ->check(CLI::Range(1, kMostJobs))
        ->type_name("N");
    describePartsOfSweep(*parser.sweep, arguments.sweep);
}

/// Not for people: model_source runs it to keep the file readers in a process of their own.
void describeWorker(Parser& parser, Arguments& arguments) {
    parser.worker = parser.app.add_subcommand("import-worker")->group("");
    parser.worker->add_option("FILE", arguments.workerFile)->required();
}

void describe(Parser& parser, Arguments& arguments) {
    parser.app.name("kerf");
    parser.app.set_version_flag("--version", "kerf " KERF_VERSION);
    parser.app.require_subcommand(0, 1);
    parser.app.footer(kExitCodes);
    parser.app.add_option("FILE", arguments.file, "A model or a session to open in the editor");
    describeReplay(parser, arguments);
    // Listed here; what follows it is for becomeLaboratory.
    parser.app.add_subcommand(kExperiment,
                              "Run the paper's experiments, the virtual test bench, or a "
                              "comparison with finite elements, headless and write a report; by "
                              "kerf-lab, which is made from the source tree and not installed");
    describeInspect(parser, arguments);
    describeCompare(parser, arguments);
    describeTest(parser, arguments);
    describeMaterials(parser, arguments);
    describeSchema(parser, arguments);
    describeSweep(parser, arguments);
    describeDoctor(parser, arguments);
    describeWorker(parser, arguments);
}

/// A bare word that is no file was meant as a verb.
bool looksLikeVerb(const std::filesystem::path& file) {
    const std::string text = file.string();
    const auto isWord = [](unsigned char c) { return std::isalnum(c) != 0 || c == '-'; };
    std::error_code error;
    return std::all_of(text.begin(), text.end(), isWord) && !std::filesystem::exists(file, error);
}

int runEditorVerb(const std::filesystem::path& file) {
    if (file.empty()) {
        return runEditor(std::nullopt);
    }
    if (looksLikeVerb(file)) {
        return complain("'" + file.string() + "' is neither a verb nor a file; see kerf --help.",
                        kExitUsage);
    }
    return runEditor(file);
}

int schemaVerb(const std::string& kind, std::ostream& out) {
    out << (kind == kMaterialKind ? materialSchema() : sessionSchema());
    return kExitDone;
}

int runVerb(const Parser& parser, const Arguments& arguments) {
    if (parser.replay->parsed()) return replayVerb(arguments.replay, std::cout, std::cerr);
    if (parser.inspect->parsed()) return inspectVerb(arguments.inspect, std::cout);
    if (parser.compare->parsed()) return compareVerb(arguments.compare, std::cout);
    if (parser.test->parsed()) return testVerb(arguments.test, std::cout);
    if (parser.materials->parsed()) return materialsVerb(arguments.materials, std::cout);
    if (parser.schema->parsed()) return schemaVerb(arguments.schema, std::cout);
    if (parser.sweep->parsed()) return sweepVerb(arguments.sweep, std::cout, std::cerr);
    if (parser.doctor->parsed()) return doctorVerb(arguments.doctor, std::cout, std::cerr);
    if (parser.worker->parsed()) return runImportWorker(arguments.workerFile);
    return runEditorVerb(arguments.file);
}

/// The laboratory takes the place of this program, with the words behind the verb.
int becomeLaboratory(char** words) {
    std::string program = programBeside("kerf-lab");
    words[0] = program.data();
    ::execv(program.c_str(), words);
    return complain(program + ", which runs experiments, can't be started (" +
                        std::strerror(errno) +
                        "); it is no part of an installed Kerf: scripts/build of the source tree "
                        "makes it.",
                    kExitInput);
}

}  // namespace

int runCommandLine(int argc, char** argv) {
    setUpProgram();
    if (argc > 1 && argv[1] == std::string_view(kExperiment)) {
        return becomeLaboratory(argv + 1);
    }
    readModelsWithThisProgram();
    Arguments arguments;
    Parser parser;
    describe(parser, arguments);
    if (const std::optional<int> ended = parseWords(parser.app, argc, argv)) {
        return *ended;
    }
    if (!arguments.file.empty() && !parser.app.get_subcommands().empty()) {
        return complain("A verb comes first and takes its own files; see kerf --help.", kExitUsage);
    }
    return runSafely([&] {
        for (const std::filesystem::path& out : {arguments.replay.out, arguments.test.out,
                                                 arguments.sweep.out, arguments.doctor.out}) {
            refuseFileAsFolder(out);
        }
        return runVerb(parser, arguments);
    });
}

}  // namespace kerf::app
