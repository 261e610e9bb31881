#include <CLI/CLI.hpp>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/cli/option_checks.h"
#include "app/cli/verb.h"
#include "app/files/io/errors.h"
#include "app/files/io/file_io.h"
#include "app/practice/score_table.h"
#include "app/session/session.h"
#include "app/session/session_json.h"
#include "app/session/task_run.h"
#include "gpu/context.h"

namespace kerf::app {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::uintmax_t kMaxSummaryBytes = 256u << 20;

/// The arguments of `kerf score PATH... [--csv FILE] [--html FILE] [--json] [--passed]`, parsed.
struct ScoreArguments {
    std::vector<fs::path> paths;
    fs::path csv;   ///< empty for standard output, if there is no other result
    fs::path html;  ///< empty for none
    bool json = false;
    bool mustPass = false;
};

/// What a file with a score holds: itself, or as a replay wrote it. None if it holds none.
std::optional<Scored> scoreIn(const fs::path& file) {
    const Json read = parseOrderedJson(readInputFile(file, kMaxSummaryBytes));
    const Json& score = read.is_object() && read.contains("score") ? read["score"] : read;
    return isScore(score) ? std::optional(Scored{file.string(), score}) : std::nullopt;
}

bool isOf(const Task& task, const Json& score) {
    return score["task"] == task.name && score["person"] == task.person &&
           score["date"] == task.date;
}

/// The score that lies beside a session, if it is of that try, or else of a run; none if it has no
/// task, or no stroke.
std::optional<Scored> scoreSession(const fs::path& session) {
    const Session read = readSession(session);
    if (!read.task) {
        return std::nullopt;
    }
    const fs::path beside = scoreFileOf(session);
    if (const auto found = fs::exists(beside) ? scoreIn(beside) : std::nullopt;
        found && isOf(*read.task, found->score)) {
        return Scored{session.string(), found->score};
    }
    const gpu::EglContext context;
    const std::optional<Score> score = runForScore(read);
    return score ? std::optional(Scored{session.string(), app::toJson(*score, *read.task)})
                 : std::nullopt;
}

/// With the file in what it throws.
std::optional<Scored> scoreOfFile(const fs::path& file) {
    try {
        return file.string().ends_with(kSessionEnding) ? scoreSession(file) : scoreIn(file);
    } catch (const InputError& error) {
        const std::string problem = error.what();
        throw InputError(problem.find(file.string()) != std::string::npos
                             ? problem
                             : file.string() + ": " + problem);
    }
}

/// What a folder holds, of which the score of one try may be asked in two ways.
bool holdsTry(const fs::path& file) {
    return file.filename() == kSummaryFile || file.string().ends_with(kSessionEnding);
}

/// The files that are named, and each session and summary.json in folders and below.
std::vector<fs::path> filesAt(const std::vector<fs::path>& paths) {
    std::vector<fs::path> files;
    for (const fs::path& path : paths) {
        if (!fs::is_directory(path)) {
            files.push_back(path);
            continue;
        }
        const std::size_t before = files.size();
        for (const auto& entry : fs::recursive_directory_iterator(path)) {
            if (holdsTry(entry.path())) {
                files.push_back(entry.path());
            }
        }
        if (files.size() == before) {
            throw InputError(path.string() +
                             ": there is no session and no summary.json in this folder.");
        }
    }
    return files;
}

std::vector<Scored> scoreAll(const std::vector<fs::path>& files) {
    std::vector<Scored> tries;
    for (const fs::path& file : files) {
        auto scored = scoreOfFile(file);
        if (!scored) {
            throw InputError(file.string() + ": there is no score; give a session (*" +
                             std::string(kSessionEnding) +
                             ") with a task and a stroke, the summary.json of its replay, or a "
                             "*" +
                             std::string(kScoreEnding) + ".");
        }
        tries.push_back(std::move(*scored));
    }
    sortTries(tries);
    return tries;
}

Json toJson(const std::vector<Scored>& tries) {
    Json list = Json::array();
    for (const Scored& scored : tries) {
        list.push_back({{"file", scored.file}});
        list.back().update(scored.score);
    }
    return {{"tries", list}};
}

/// Nothing that is read, or that is written too, may be written over.
void requireFree(const fs::path& file, const std::vector<fs::path>& others) {
    std::error_code none;
    for (const fs::path& other : others) {
        if (!file.empty() && (file == other || fs::equivalent(file, other, none))) {
            throw InputError(file.string() + ": it is read or written already; give another file.");
        }
    }
}

int runScore(const ScoreArguments& arguments, std::ostream& out) {
    const std::vector<fs::path> files = filesAt(arguments.paths);
    requireFree(arguments.csv, files);
    requireFree(arguments.html, files);
    requireFree(arguments.html, {arguments.csv});
    const std::vector<Scored> tries = scoreAll(files);
    if (!arguments.csv.empty()) {
        writeOutputFile(arguments.csv, scoresAsCsv(tries));
    }
    if (!arguments.html.empty()) {
        writeOutputFile(arguments.html, scoresAsHtml(tries));
    }
    if (arguments.json) {
        out << toJson(tries).dump(-1, ' ', false, Json::error_handler_t::replace) << "\n";
    } else if (arguments.csv.empty() && arguments.html.empty()) {
        out << scoresAsCsv(tries);
    }
    const bool allPassed =
        std::ranges::all_of(tries, [](const Scored& scored) { return scored.score["passed"]; });
    return arguments.mustPass && !allPassed ? kExitCheckFailed : kExitDone;
}

std::function<int()> describeScore(CLI::App& verb) {
    const auto arguments = std::make_shared<ScoreArguments>();
    verb.add_option("PATH", arguments->paths,
                    "A session, its score, the summary.json of its replay, or a folder to search "
                    "for sessions and summaries")
        ->required()
        ->check(refuseEmpty);
    verb.add_option("--csv", arguments->csv, "Write the table as CSV here, not to standard output")
        ->type_name("FILE")
        ->check(refuseEmpty);
    verb.add_option("--html", arguments->html, "Write a page with the table and charts here")
        ->type_name("FILE")
        ->check(refuseEmpty);
    verb.add_flag("--json", arguments->json, "Print one JSON object");
    verb.add_flag("--passed", arguments->mustPass, "Exit code 1 unless all tries passed");
    return [arguments] { return runScore(*arguments, std::cout); };
}

}  // namespace

const Verb kScoreVerb{"score", "Table of practised cuts: figures, limits, and who passed",
                      describeScore};

}  // namespace kerf::app
