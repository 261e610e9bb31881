// kerf-lab NAME|all --out DIR: the laboratory, which `kerf experiment` starts.
#include <CLI/CLI.hpp>
#include <iostream>

#include "app/cli/option_checks.h"
#include "app/cli/program.h"
#include "app/files/io/exit_codes.h"
#include "app/session/paper_experiments.h"
#include "bench/lab/bar_experiment.h"
#include "bench/lab/experiment_verb.h"

namespace {

using namespace kerf::app;

constexpr int kMostRepeats = 100;

/// "sphere20, ..., banana, bar, ..., all".
std::string experimentNames() {
    std::string names;
    for (const PaperExperiment& experiment : paperExperiments()) {
        names += std::string(experiment.name) + ", ";
    }
    for (const OwnExperiment& experiment : ownExperiments()) {
        names += std::string(experiment.name) + ", ";
    }
    return names + "all";
}

std::string refuseUnknownExperiment(const std::string& name) {
    const bool known =
        name == "all" || findOwnExperiment(name) != nullptr || findPaperExperiment(name) != nullptr;
    return known ? "" : "there is no experiment '" + name + "'; there are " + experimentNames();
}

void describe(CLI::App& app, ExperimentArguments& arguments) {
    app.name("kerf experiment");
    app.footer(kExitCodes);
    app.add_option("NAME", arguments.name, experimentNames())
        ->required()
        ->check(refuseUnknownExperiment);
    app.add_option("--out", arguments.out, "Folder for the results")
        ->required()
        ->check(refuseEmpty)
        ->type_name("DIR");
    app.add_flag("--published", arguments.published,
                 "Solve, answer contact and cut as the paper does");
    app.add_option("--runs", arguments.runs,
                   "Runs of each stroke, for the spread of frame rates (5)")
        ->check(CLI::Range(1, kMostRepeats))
        ->type_name("N");
    app.add_flag("--whole", arguments.whole,
                 "With bar: all combinations of settings, which takes hours");
    app.add_flag("--json", arguments.json, "Print one JSON object");
}

/// What the experiment does not take; empty where it takes all.
std::string refuseOptions(const CLI::App& app, const ExperimentArguments& arguments) {
    const bool likePaper = arguments.published || app.count("--runs") > 0;
    if (likePaper && findOwnExperiment(arguments.name) != nullptr) {
        return "'" + arguments.name +
               "' is none of the paper's experiments and takes neither --published nor --runs.";
    }
    if (arguments.whole && arguments.name != kBarExperiment) {
        return "--whole is for 'bar' alone; leave it out.";
    }
    return "";
}

}  // namespace

// NOLINTNEXTLINE(bugprone-exception-escape): without memory for its options there is no way on
int main(int argc, char** argv) {
    setUpProgram();
    CLI::App app{
        "Run the paper's experiments, the virtual test bench, or a comparison with finite "
        "elements, headless and write a report"};
    ExperimentArguments arguments;
    describe(app, arguments);
    if (const std::optional<int> ended = parseWords(app, argc, argv)) {
        return *ended;
    }
    if (const std::string refusal = refuseOptions(app, arguments); !refusal.empty()) {
        return complain(refusal, kExitUsage);
    }
    return runSafely([&] {
        refuseFileAsFolder(arguments.out);
        return experimentVerb(arguments, std::cout, std::cerr);
    });
}
