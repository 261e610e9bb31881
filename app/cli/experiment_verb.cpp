#include "app/cli/experiment_verb.h"

#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>

#include <array>
#include <nlohmann/json.hpp>
#include <ostream>

#include "app/cli/bar_experiment.h"
#include "app/cli/exit_codes.h"
#include "app/cli/experiment_report.h"
#include "app/cli/replay.h"
#include "app/files/file_io.h"
#include "app/files/progress_line.h"
#include "app/session/hollow_session.h"
#include "gpu/context.h"
#include "gpu/data_path.h"
#include "ui/plot_picture.h"

namespace kerf::app {

namespace {

constexpr const char* kReportFile = "report.md";
constexpr const char* kPlotFile = "plots.png";
constexpr const char* kHollowFolder = "hollow";
constexpr int kPlotWidth = 900;
constexpr int kPlotHeight = 560;

/// What the plots show, against simulated time.
struct Curves {
    ui::Series volume;  ///< % of rest
    ui::Series frames;  ///< [1/s]
    std::vector<ui::PlotMark> marks;

    void add(const MetricsRow& row) {
        const StepReport& step = row.report;
        if (pieces_ != 0 && step.pieces != pieces_) {
            marks.push_back({step.time, fmt::format("{} pieces", step.pieces)});
        }
        pieces_ = step.pieces;
        volume.add(step.time, 100 * step.volumeRatio);
        frames.add(step.time, row.frameMs > 0 ? 1000 / row.frameMs : 0);
    }

  private:
    int pieces_ = 0;
};

render::Image drawCurves(const Curves& curves, const PaperExperiment& paper) {
    ui::PlotSpec volume;
    volume.id = "volume";
    volume.title = "Volume, % of rest";
    volume.curves = {{.label = "volume", .hue = ui::Hue::green, .series = &curves.volume}};
    volume.marks = curves.marks;
    volume.reference = {paper.meanVolume, fmt::format("paper's mean {:.1f}", paper.meanVolume)};
    volume.readoutDecimals = 2;
    ui::PlotSpec frames;
    frames.id = "frames";
    frames.title = "Frames per second";
    frames.curves = {{.label = "frames/s", .series = &curves.frames}};
    frames.marks = curves.marks;
    frames.reference = {paper.meanFps, fmt::format("paper's mean {:.1f}", paper.meanFps)};
    frames.minSpan = 10;
    return ui::PlotPainter().draw(std::array{volume, frames}, {}, kPlotWidth, kPlotHeight);
}

/// As the paper solves, answers contact and cuts.
void solveAsPublished(Params& params) {
    params.solver = SolverMode::pbd;
    params.paperContact = 1;
    params.openCut = 1;
}

Session sessionOf(const PaperExperiment& experiment, bool published) {
    Session session = readSession(
        gpu::dataPath("assets/sessions/" + std::string(experiment.name) + ".kerf.json"));
    for (const std::string& warning : session.warnings) {
        spdlog::warn(warning);
    }
    if (published) {
        solveAsPublished(session.params);
    }
    return session;
}

/// Runs the experiment once more up to the middle of its cut, with hands that draw the lips apart.
/// Returns its picture, relative to the report, if there is one.
std::vector<std::string> pictureHollow(const PaperExperiment& experiment, const Session& session,
                                       const std::filesystem::path& folder) {
    ModelMesh model = loadSessionModel(session);
    const std::optional<Session> hollow = hollowSession(session, model.mesh);
    if (!hollow) {
        return {};
    }
    const std::string place = std::string(experiment.name) + "/" + kHollowFolder;
    replaySession(*hollow, std::move(model), folder / place, {});
    return {place + "/" + kHollowFile};
}

ExperimentResult runExperiment(const PaperExperiment& experiment,
                               const ExperimentArguments& arguments) {
    const std::filesystem::path& folder = arguments.out;
    const Session session = sessionOf(experiment, arguments.published);
    Curves curves;
    ReplayResult replay;
    {
        ProgressLine line(std::string(experiment.name) + ": ");
        replay = replaySession(session, loadSessionModel(session), folder / experiment.name,
                               {[&line](int done, int total) { line.show(done, total); },
                                [&curves](const MetricsRow& row) { curves.add(row); }});
    }
    writePicture(drawCurves(curves, experiment), folder / experiment.name / kPlotFile);
    ExperimentResult result{&experiment, std::move(replay.summary), {}};
    replay.files.emplace_back(kPlotFile);
    for (const std::string& file : replay.files) {
        if (std::filesystem::path(file).extension() == ".png") {
            result.pictures.push_back(std::string(experiment.name) + "/" + file);
        }
    }
    if (arguments.published) {
        const auto afterCutting = result.pictures.begin() + 1;
        for (const std::string& picture : pictureHollow(experiment, session, folder)) {
            result.pictures.insert(afterCutting, picture);
        }
    }
    return result;
}

std::vector<const PaperExperiment*> chosenExperiments(const std::string& name) {
    std::vector<const PaperExperiment*> chosen;
    for (const PaperExperiment& experiment : paperExperiments()) {
        if (name == "all" || name == experiment.name) {
            chosen.push_back(&experiment);
        }
    }
    return chosen;
}

/// Results of an earlier run that are written after summary.json.
void removeEarlierReport(const std::filesystem::path& folder,
                         const std::vector<const PaperExperiment*>& experiments) {
    std::vector<std::filesystem::path> files{folder / kReportFile};
    for (const PaperExperiment* experiment : experiments) {
        files.push_back(folder / experiment->name / kPlotFile);
    }
    for (const std::filesystem::path& file : files) {
        std::error_code error;
        std::filesystem::remove(file, error);
        if (error) {
            throw OutputError(file.string() + ": an older result could not be removed (" +
                              error.message() + ").");
        }
    }
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

int experimentVerb(const ExperimentArguments& arguments, std::ostream& out, std::ostream& errors) {
    if (arguments.name == kBarExperiment) {
        return runBarExperiment(arguments.out, arguments.json, out, errors);
    }
    const std::vector<const PaperExperiment*> experiments = chosenExperiments(arguments.name);
    gpu::EglContext context;
    gpu::enableDebugOutput();
    removeEarlierReport(arguments.out, experiments);
    std::vector<ExperimentResult> results;
    results.reserve(experiments.size());
    for (const PaperExperiment* experiment : experiments) {
        results.push_back(runExperiment(*experiment, arguments));
    }
    writeOutputFile(arguments.out / kReportFile,
                    formatExperimentReport(results, arguments.published));
    if (arguments.json) {
        printJson(results, out);
    } else {
        printForPeople(results, arguments.out, out);
    }
    return complainAboutFailures(results, errors);
}

}  // namespace kerf::app
