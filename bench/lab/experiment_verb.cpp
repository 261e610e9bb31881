#include "bench/lab/experiment_verb.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <ostream>

#include "app/files/io/exit_codes.h"
#include "app/files/io/file_io.h"
#include "bench/lab/bar_experiment.h"
#include "bench/lab/blade_experiment.h"
#include "bench/lab/experiment/experiment_report.h"
#include "bench/lab/experiment/experiment_runs.h"
#include "bench/lab/experiment/report_figures.h"
#include "bench/lab/fem/fem_experiment.h"
#include "bench/lab/materials_experiment.h"
#include "gpu/context.h"
#include "gpu/data_path.h"

namespace kerf::app {

namespace {

constexpr const char* kReportFile = "report.md";
constexpr const char* kAll = "all";

std::vector<const PaperExperiment*> chosenExperiments(const std::string& name) {
    std::vector<const PaperExperiment*> chosen;
    for (const PaperExperiment& experiment : paperExperiments()) {
        if (name == kAll || name == experiment.name) {
            chosen.push_back(&experiment);
        }
    }
    return chosen;
}

/// Results of an earlier run that are written after summary.json.
std::vector<std::filesystem::path> laterFiles(const std::vector<const PaperExperiment*>& chosen) {
    std::vector<std::filesystem::path> files{kReportFile, kFigure2File, kFigure9File, kFigure10File,
                                             kSearchFile};
    for (const PaperExperiment* experiment : chosen) {
        files.push_back(std::filesystem::path(experiment->name) / kPlotFile);
        files.emplace_back(cuttingFigure(*experiment).file());
        files.emplace_back(fallFigure(*experiment).file());
    }
    return files;
}

void removeEarlierReport(const std::filesystem::path& folder,
                         const std::vector<const PaperExperiment*>& experiments) {
    for (const std::filesystem::path& file : laterFiles(experiments)) {
        std::error_code error;
        std::filesystem::remove(folder / file, error);
        if (error) {
            throw OutputError((folder / file).string() +
                              ": an older result could not be removed (" + error.message() + ").");
        }
    }
}

ReportData runAll(const std::vector<const PaperExperiment*>& experiments,
                  const ExperimentArguments& arguments) {
    const ExperimentPlan plan{arguments.out, arguments.published, arguments.runs};
    ReportData data;
    data.published = arguments.published;
    data.results.reserve(experiments.size());
    for (const PaperExperiment* experiment : experiments) {
        data.results.push_back(runExperiment(*experiment, plan));
    }
    const auto isPictured = [](const PaperExperiment* e) {
        return e->name == std::string_view(kFigure2Model);
    };
    if (std::ranges::any_of(experiments, isPictured)) {
        data.figure2 = runFigure2(plan);
    }
    return data;
}

void printForPeople(const std::vector<ExperimentResult>& results,
                    const std::filesystem::path& folder, std::ostream& out) {
    for (const ExperimentResult& result : results) {
        const RunStatistics& run = result.summary.statistics;
        out << fmt::format(
            "{}: volume mean {:.2f} %, min {:.2f} %, final {:.2f} % (paper: mean {:.1f} %), {} "
            "pieces\n",
            result.paper->label, 100 * run.volumeRatio.mean(), 100 * run.volumeRatio.min(),
            100 * run.finalVolumeRatio, result.paper->meanVolume, result.summary.pieces.size());
    }
    out << "written to " << folder.string() << ": " << kReportFile << "\n";
}

void printJson(const std::vector<ExperimentResult>& results, std::ostream& out) {
    nlohmann::ordered_json json;
    for (const ExperimentResult& result : results) {
        json["experiments"][result.paper->name] = toJson(result.summary);
    }
    json["files"] = {kReportFile};
    out << json.dump() << "\n";
}

int complainAboutFailures(const std::vector<ExperimentResult>& results, std::ostream& errors) {
    for (const ExperimentResult& result : results) {
        if (!result.summary.failures.empty()) {
            errors << result.paper->name << ": " << result.summary.failures.front() << "\n";
            return kExitCheckFailed;
        }
    }
    return kExitDone;
}

}  // namespace

std::span<const OwnExperiment> ownExperiments() {
    using Arguments = const ExperimentArguments&;
    static constexpr std::array kOwn{
        OwnExperiment{kBarExperiment,
                      [](Arguments a, std::ostream& out, std::ostream& errors) {
                          return runBarExperiment(a.out, a.whole, a.json, out, errors);
                      }},
        OwnExperiment{kFemExperiment,
                      [](Arguments a, std::ostream& out, std::ostream& /*errors*/) {
                          return runFemExperiment(a.out, a.json, out);
                      }},
        OwnExperiment{kBladeExperiment,
                      [](Arguments a, std::ostream& out, std::ostream& errors) {
                          return runBladeExperiment(a.out, a.json, out, errors);
                      }},
        OwnExperiment{kMaterialsExperiment,
                      [](Arguments a, std::ostream& out, std::ostream& errors) {
                          return runMaterialsExperiment(a.out, a.json, out, errors);
                      }}};
    return kOwn;
}

const OwnExperiment* findOwnExperiment(std::string_view name) {
    const std::span<const OwnExperiment> all = ownExperiments();
    const auto found =
        std::ranges::find_if(all, [&](const OwnExperiment& own) { return own.name == name; });
    return found == all.end() ? nullptr : &*found;
}

int experimentVerb(const ExperimentArguments& arguments, std::ostream& out, std::ostream& errors) {
    if (const OwnExperiment* own = findOwnExperiment(arguments.name)) {
        return own->run(arguments, out, errors);
    }
    const std::vector<const PaperExperiment*> experiments = chosenExperiments(arguments.name);
    gpu::EglContext context;
    gpu::enableDebugOutput();
    removeEarlierReport(arguments.out, experiments);
    const ReportData data = runAll(experiments, arguments);
    drawFigures(data, arguments.out);
    writeOutputFile(arguments.out / kReportFile,
                    formatExperimentReport(data, readShaderInventory(gpu::shaderRoot())));
    if (arguments.json) {
        printJson(data.results, out);
    } else {
        printForPeople(data.results, arguments.out, out);
    }
    return complainAboutFailures(data.results, errors);
}

}  // namespace kerf::app
