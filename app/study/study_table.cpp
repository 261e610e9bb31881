#include "app/study/study_table.h"

#include <nlohmann/json.hpp>

#include "app/files/io/csv.h"
#include "app/files/io/errors.h"
#include "app/files/io/file_io.h"
#include "app/session/session.h"
#include "app/session/session_json.h"
#include "sim/base/text.h"

namespace kerf::app {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::uintmax_t kMaxSummaryBytes = 256u << 20;
constexpr const char* kResultColumns =
    "exit,state_hash,pieces,volume_mean,volume_min,volume_final,cut_worst_angle,cut_mean_angle,"
    "cut_slivers,cut_wound_to_swept,cut_volume_error,cut_self_intersections,cut_steps_refused,"
    "tears,fracture_energy,fps_mean,real_time_factor";
/// What the columns that begin with cut_ have of `cut_report`, in their order.
constexpr std::array kCutFigures{"/smallest_angle/worst", "/smallest_angle/mean",
                                 "/slivers/below_0_02",   "/area/wound_to_swept",
                                 "/volume_error",         "/self_intersections/pairs",
                                 "/steps/refused"};
constexpr std::size_t kSummaryColumns = 9 + kCutFigures.size();  // all but exit

/// Without the quotes of JSON around a word.
std::string valueCell(const std::string& value) {
    return value.starts_with('"') ? value.substr(1, value.size() - 2) : csvCell(value);
}

/// The summary of a run; null where it wrote none.
json readSummary(const fs::path& folder) {
    const fs::path file = folder / kSummaryFile;
    return fs::exists(file) ? parseJson(readInputFile(file, kMaxSummaryBytes)) : json();
}

/// Null where there is no report, or no such figure in it.
json figureIn(const json& report, const char* path) {
    return report.is_null() ? json() : report.value(json::json_pointer(path), json());
}

/// The columns from state_hash on.
std::vector<std::string> summaryCells(const json& summary) {
    if (summary.is_null()) {
        return std::vector<std::string>(kSummaryColumns);
    }
    const json& volume = summary.at("volume_ratio");
    std::vector<std::string> cells{csvCell(summary.at("state_hash").get<std::string>()),
                                   std::to_string(summary.at("pieces").size())};
    const json cuts = summary.value("cut_report", json());
    std::vector<json> numbers{volume.at("mean"), volume.at("min"), volume.at("final")};
    for (const char* figure : kCutFigures) {
        numbers.push_back(figureIn(cuts, figure));
    }
    for (const char* figure :
         {"/tears", "/fracture_energy", "/fps/mean", "/real_time_factor/median"}) {
        numbers.push_back(figureIn(summary, figure));
    }
    for (const json& number : numbers) {
        cells.push_back(number.is_null() ? "" : formatNumber(number.get<double>()));
    }
    return cells;
}

std::vector<std::string> headCells(const Study& study, std::size_t number) {
    const StudyRun& run = study.runs[number];
    std::vector<std::string> cells{std::to_string(number), csvCell(study.sessionOf(run).name)};
    for (const std::string& parameter : study.parameters) {
        cells.push_back(valueCell(startValue(study, run, parameter)));
    }
    return cells;
}

void noteRenderer(StudyTable& table, const json& summary) {
    if (summary.is_null()) {
        return;
    }
    const std::string name = summary.at("renderer").get<std::string>() + ", OpenGL " +
                             summary.at("driver").get<std::string>();
    if (std::ranges::count(table.renderers, name) == 0) {
        table.renderers.push_back(name);
    }
}

/// The cells behind the parameters, as far as the run has results.
std::vector<std::string> resultCells(StudyTable& table, const RunState& state, std::size_t number,
                                     const fs::path& folder) {
    if (!state.record) {
        table.missing.push_back(number);
        if (!state.reason.empty()) {
            table.warnings.push_back("Run " + std::to_string(number) +
                                     " counts as missing: " + state.reason + ".");
        }
        return std::vector<std::string>(1 + kSummaryColumns);
    }
    if (state.record->exitCode != 0) {
        table.failed.push_back(number);
    }
    std::vector<std::string> cells{std::to_string(state.record->exitCode)};
    try {
        const json summary = readSummary(folder);
        noteRenderer(table, summary);
        std::ranges::move(summaryCells(summary), std::back_inserter(cells));
    } catch (const json::exception&) {
        throw InputError((folder / kSummaryFile).string() +
                         ": this is no summary of a replay; remove the folder and run it again.");
    }
    return cells;
}

}  // namespace

StudyTable gatherTable(const Study& study, const fs::path& out) {
    StudyTable table;
    const std::string parameters = joined(study.parameters, ",");
    table.text =
        "run,session," + parameters + (parameters.empty() ? "" : ",") + kResultColumns + "\n";
    for (std::size_t number = 0; number < study.runs.size(); ++number) {
        std::vector<std::string> cells = headCells(study, number);
        std::ranges::move(
            resultCells(table, stateOfRun(study, number, out), number, folderOfRun(out, number)),
            std::back_inserter(cells));
        for (std::size_t i = 0; i < cells.size(); ++i) {
            table.text += (i == 0 ? "" : ",") + cells[i];
        }
        table.text += "\n";
    }
    return table;
}

}  // namespace kerf::app
