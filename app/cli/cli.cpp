#include "app/cli/cli.h"

#include <CLI/CLI.hpp>
#include <cctype>

#include "app/cli/program.h"
#include "app/cli/verb.h"
#include "app/files/io/errors.h"
#include "app/files/jobs/child_process.h"
#include "app/window/window.h"

namespace kerf::app {

namespace {

/// All verbs, in the order of `kerf --help`.
const Verb* const kVerbs[] = {&kReplayVerb, &kExperimentVerb, &kInspectVerb,   &kCompareVerb,
                              &kTestVerb,   &kScoreVerb,      &kMaterialsVerb, &kSchemaVerb,
                              &kSweepVerb,  &kReduceVerb,     &kDoctorVerb};

/// A bare word that is no file was meant as a verb.
bool looksLikeVerb(const std::filesystem::path& file) {
    const std::string text = file.string();
    const auto isWord = [](unsigned char c) { return std::isalnum(c) != 0 || c == '-'; };
    std::error_code error;
    return std::all_of(text.begin(), text.end(), isWord) && !std::filesystem::exists(file, error);
}

/// What runs without a verb.
int openEditor(const std::filesystem::path& file) {
    if (file.empty()) {
        return runEditor(std::nullopt);
    }
    if (looksLikeVerb(file)) {
        return complain("'" + file.string() + "' is neither a verb nor a file; see kerf --help.",
                        kExitUsage);
    }
    return runEditor(file);
}

/// Describes all options. What is run once they are parsed becomes `run`.
void describe(CLI::App& parser, std::filesystem::path& file, std::function<int()>& run) {
    parser.name("kerf");
    parser.set_version_flag("--version", "kerf " KERF_VERSION);
    parser.require_subcommand(0, 1);
    parser.footer(kExitCodes);
    parser.add_option("FILE", file, "A model or a session to open in the editor");
    run = [&file] { return openEditor(file); };
    for (const Verb* verb : kVerbs) {
        CLI::App& own = *parser.add_subcommand(verb->name, verb->about);
        if (verb->describe != nullptr) {
            own.callback([&run, runVerb = verb->describe(own)] { run = runVerb; });
        }
    }
}

}  // namespace

int runCommandLine(int argc, char** argv) {
    setUpProgram();
    for (const Verb* verb : kVerbs) {
        if (verb->takeOver != nullptr && argc > 1 && argv[1] == std::string_view(verb->name)) {
            return verb->takeOver(argv + 1);
        }
    }
    runThisProgram();
    CLI::App parser{
        "Kerf cuts soft 3D models while they move. Without a verb it opens the editor."};
    std::filesystem::path file;
    std::function<int()> run;
    describe(parser, file, run);
    if (const std::optional<int> ended = parseWords(parser, argc, argv)) {
        return *ended;
    }
    if (!file.empty() && !parser.get_subcommands().empty()) {
        return complain("A verb comes first and takes its own files; see kerf --help.", kExitUsage);
    }
    return runSafely(run);
}

}  // namespace kerf::app
