#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/cli/option_checks.h"
#include "app/cli/verb.h"
#include "app/files/io/errors.h"
#include "app/files/io/file_io.h"
#include "app/files/io/output_folder.h"
#include "app/files/jobs/child_runs.h"
#include "app/study/study_plots.h"
#include "app/study/study_run.h"
#include "app/study/study_table.h"
#include "gpu/context.h"
#include "sim/base/containers.h"
#include "sim/base/text.h"

namespace kerf::app {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Numbers = std::vector<std::size_t>;

constexpr std::size_t kMostNamed = 10;

/// The arguments of `kerf sweep STUDY --out DIR ...`, parsed.
struct SweepArguments {
    std::filesystem::path study;
    std::filesystem::path out;       ///< empty for none, which --list alone may do without
    int jobs = 1;                    ///< runs at a time
    std::optional<std::size_t> run;  ///< this run alone
    bool list = false;               ///< says what the runs are, and runs nothing
    bool gather = false;             ///< gathers what is there, and runs nothing
    bool json = false;
};

/// "runs 3, 5 and 7"; of many the first ones.
std::string nameRuns(const Numbers& numbers) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < std::min(numbers.size(), kMostNamed); ++i) {
        names.push_back(std::to_string(numbers[i]));
    }
    if (numbers.size() > kMostNamed) {
        names.push_back(std::to_string(numbers.size() - kMostNamed) + " more");
    }
    return (numbers.size() == 1 ? "run " : "runs ") + enumerated(names);
}

/// ", 2 failed (runs 3 and 5)"; "" where there are none.
std::string describeAll(const Numbers& numbers, const char* state) {
    return numbers.empty() ? ""
                           : fmt::format(", {} {} ({})", numbers.size(), state, nameRuns(numbers));
}

/// "3 a.kerf.json time_step=0.003".
std::string describeRun(const Study& study, std::size_t number) {
    const StudyRun& run = study.runs[number];
    const std::string settings = settingsText(run);
    return fmt::format("{} {}{}{}", number, study.sessionOf(run).name, settings.empty() ? "" : " ",
                       settings);
}

// --- --list ------------------------------------------------------------------------------------

/// "done", "failed" or "missing".
std::string stateName(const RunState& state) {
    if (!state.record) {
        return "missing";
    }
    return state.record->exitCode == 0 ? "done" : "failed";
}

Json describeAsJson(const Study& study, std::size_t number, const fs::path& out) {
    const StudyRun& run = study.runs[number];
    Json json{{"run", number}, {"session", study.sessionOf(run).name}, {"params", Json::object()}};
    for (const Setting& setting : run.settings) {
        json["params"][setting.name] = Json::parse(setting.value);
    }
    if (!out.empty()) {
        json["state"] = stateName(stateOfRun(study, number, out));
    }
    return json;
}

int listRuns(const Study& study, const SweepArguments& arguments, std::ostream& out) {
    Json list = Json::array();
    for (std::size_t number = 0; number < study.runs.size(); ++number) {
        if (arguments.json) {
            list.push_back(describeAsJson(study, number, arguments.out));
        } else {
            const std::string state =
                arguments.out.empty() ? ""
                                      : " " + stateName(stateOfRun(study, number, arguments.out));
            out << describeRun(study, number) << state << "\n";
        }
    }
    if (arguments.json) {
        out << Json{{"runs", std::move(list)}}.dump() << "\n";
    }
    return kExitDone;
}

// --- --run -------------------------------------------------------------------------------------

int runOne(const Study& study, const SweepArguments& arguments, std::ostream& out,
           std::ostream& errors) {
    const std::size_t number = *arguments.run;
    if (number >= study.runs.size()) {
        throw UsageError(
            fmt::format("--run {}: the study has runs 0 to {}", number, study.runs.size() - 1));
    }
    const RunEnd end = performRun(study, number, arguments.out);
    errors << end.log;
    if (end.noOpenGl) {
        return kExitNoOpenGl;
    }
    const RunRecord& record = end.record;
    out << (end.wasDone            ? "was done"
            : record.exitCode == 0 ? "done    "
                                   : "failed  ")
        << " " << describeRun(study, number) << "\n";
    return record.exitCode;
}

// --- All of them -------------------------------------------------------------------------------

/// The runs that are to be done. Says which of them had results.
Numbers pendingRuns(const Study& study, const fs::path& out) {
    Numbers pending;
    for (std::size_t number = 0; number < study.runs.size(); ++number) {
        const RunState state = stateOfRun(study, number, out);
        if (!state.done()) {
            pending.push_back(number);
        }
        if (!state.reason.empty()) {
            spdlog::warn("Run {} is run again: {}.", number, state.reason);
        }
    }
    return pending;
}

std::vector<std::string> childArguments(const SweepArguments& arguments, std::size_t number) {
    return {"sweep", asArgument(arguments.study), "--out", asArgument(arguments.out),
            "--run", std::to_string(number)};
}

std::string lineAbout(const Study& study, std::size_t number, const fs::path& out,
                      const ChildOutcome& outcome) {
    const RunState state = stateOfRun(study, number, out);
    std::string line = fmt::format("{:<7} {} ({:.1f} s)\n", stateName(state),
                                   describeRun(study, number), outcome.seconds);
    if (outcome.exitCode == kExitDone) {
        return line;
    }
    return line + "        " + (state.record ? state.record->problem : sentenceAbout(outcome)) +
           "\n";
}

/// Each run is a program of its own, the same that a cluster would start.
void runPending(const Study& study, const Numbers& pending, const SweepArguments& arguments,
                std::ostream& out) {
    const auto children =
        mapped(pending, [&](std::size_t number) { return childArguments(arguments, number); });
    runChildren(children, arguments.jobs, [&](std::size_t i, const ChildOutcome& outcome) {
        if (outcome.exitCode == kExitNoOpenGl) {
            throw gpu::ContextError("Run " + std::to_string(pending[i]) + ": " +
                                    sentenceAbout(outcome));
        }
        if (!arguments.json) {
            out << lineAbout(study, pending[i], arguments.out, outcome) << std::flush;
        }
    });
}

// --- Gathering ---------------------------------------------------------------------------------

void warnAbout(const StudyTable& table) {
    for (const std::string& warning : table.warnings) {
        spdlog::warn("{}", warning);
    }
    if (table.renderers.size() > 1) {
        spdlog::warn("The runs were made on {} drivers, whose state hashes can't be compared: {}.",
                     table.renderers.size(), joined(table.renderers, "; "));
    }
}

/// The table is complete without pictures: the machine that gathers may have no OpenGL.
std::vector<std::string> drawPlots(const Study& study, const fs::path& out) {
    if (study.runs.size() > kMostDrawnRuns) {
        spdlog::warn("The plots show the first {} of {} runs.", kMostDrawnRuns, study.runs.size());
    }
    try {
        const gpu::EglContext context;
        drawStudy(study, out);
        return studyPictures(study);
    } catch (const gpu::ContextError& error) {
        spdlog::warn("The plots were not drawn. {}", error.what());
        return {};
    }
}

void print(const Study& study, const StudyTable& table, const std::vector<std::string>& files,
           const SweepArguments& arguments, std::ostream& out) {
    if (arguments.json) {
        out << Json{{"runs", study.runs.size()},
                    {"failed", table.failed},
                    {"missing", table.missing},
                    {"files", files}}
                   .dump()
            << "\n";
        return;
    }
    out << counted(study.runs.size(), "run", "runs") << describeAll(table.failed, "failed")
        << describeAll(table.missing, "missing")
        << (table.failed.empty() && table.missing.empty() ? ", none failed" : "")
        << (files.empty() ? "; there is nothing to gather" : "") << "\n";
    if (!files.empty()) {
        out << "written to " << arguments.out.string() << ": " << joined(files, " ") << "\n";
    }
}

/// Nobody shall take pictures of earlier results for those of the table.
std::vector<std::string> writeGathered(const Study& study, const StudyTable& table,
                                       const fs::path& out) {
    OutputFolder folder(out);
    folder.write(kTableFile, table.text);
    for (const std::string& picture : studyPictures(study)) {
        folder.remove(picture);
    }
    std::vector<std::string> files = drawPlots(study, out);
    files.insert(files.begin(), kTableFile);
    return files;
}

/// Where no run is done, what was gathered before stays.
int gather(const Study& study, const SweepArguments& arguments, std::ostream& out) {
    const StudyTable table = gatherTable(study, arguments.out);
    warnAbout(table);
    const bool anyDone = table.missing.size() < study.runs.size();
    print(study, table,
          anyDone ? writeGathered(study, table, arguments.out) : std::vector<std::string>(),
          arguments, out);
    return table.failed.empty() && table.missing.empty() ? kExitDone : kExitCheckFailed;
}

/// What would stop each run, or the table in the end, is told before anything runs.
void requireUsable(const fs::path& out) {
    OutputFolder folder(out);
    RunLock::requireFile(out);
    const AtomicFile table(folder.pathOf(kTableFile));
}

int sweep(const Study& study, const SweepArguments& arguments, std::ostream& out) {
    requireUsable(arguments.out);
    const Numbers pending = pendingRuns(study, arguments.out);
    runPending(study, pending, arguments, out);
    return gather(study, arguments, out);
}

Study read(const SweepArguments& arguments) {
    Study study = arguments.run ? readStudyForRun(arguments.study, *arguments.run)
                                : readStudy(arguments.study);
    for (const std::string& warning : study.warnings) {
        spdlog::warn(warning);
    }
    return study;
}

int runSweep(const SweepArguments& arguments, std::ostream& out, std::ostream& errors) {
    refuseFileAsFolder(arguments.out);
    if (arguments.out.empty() && !arguments.list) {
        throw UsageError("--out is missing; name the folder for the results");
    }
    const Study study = read(arguments);
    if (arguments.list) {
        return listRuns(study, arguments, out);
    }
    if (arguments.run) {
        return runOne(study, arguments, out, errors);
    }
    return arguments.gather ? gather(study, arguments, out) : sweep(study, arguments, out);
}

/// What is done instead of the whole sweep; one of these at most.
void describePartsOfSweep(CLI::App& verb, SweepArguments& arguments) {
    CLI::Option* run =
        verb.add_option("--run", arguments.run, "Do only this run, from 0; gather nothing")
            ->check(CLI::Range(std::size_t{0}, kMostRuns - 1))
            ->type_name("K");
    CLI::Option* list =
        verb.add_flag("--list", arguments.list, "Print a line for each run, and run nothing")
            ->excludes(run);
    verb.add_flag("--gather", arguments.gather,
                  "Write the table and the plots of the runs that are done, and run nothing")
        ->excludes(run)
        ->excludes(list);
    verb.add_flag("--json", arguments.json, "Print one JSON object")->excludes(run);
}

std::function<int()> describeSweep(CLI::App& verb) {
    const auto arguments = std::make_shared<SweepArguments>();
    verb.add_option("STUDY", arguments->study, "A study: see docs/sweeps.md")
        ->required()
        ->check(refuseEmpty);
    addOut(verb, arguments->out, "Folder for the results");
    addJobs(verb, arguments->jobs);
    describePartsOfSweep(verb, *arguments);
    return [arguments] { return runSweep(*arguments, std::cout, std::cerr); };
}

}  // namespace

const Verb kSweepVerb{"sweep", "Run sessions with many values of parameters; resumes if stopped",
                      describeSweep};

}  // namespace kerf::app
