#include "bench/lab/experiment/experiment_runs.h"

#include <spdlog/fmt/fmt.h>

#include <utility>

#include "app/cli/replay/replay.h"
#include "app/files/import/model_source.h"
#include "app/files/jobs/progress_line.h"
#include "bench/lab/hollow_session.h"

namespace kerf::app {

namespace {

constexpr const char* kFigure2Folder = "figure-2";
constexpr const char* kHollowFolder = "hollow";
constexpr int kHollowPlace = 2;  ///< in the strip: behind the picture half way
constexpr const char* kSearchParameter = "cut_search";

using RowListener = std::function<void(const MetricsRow&)>;

RunSummary replay(const Session& session, const std::filesystem::path& folder,
                  const std::string& what, const RowListener& onRow) {
    ProgressLine line(what + ": ");
    return replaySession(session, loadSessionModel(session), folder,
                         {[&line](int done, int total) { line.show(done, total); }, onRow})
        .summary;
}

/// Adds the steps of a stroke to its times.
RowListener timing(StrokeTimes& times, const Moments& at) {
    return [&times, at](const MetricsRow& row) {
        if (row.report.step >= at.blade && row.report.step <= at.lift) {
            times.add(row);
        }
    };
}

/// The complete run: all that the report tells besides what is timed again.
ExperimentResult runWhole(const PaperExperiment& experiment, const ExperimentPlan& plan) {
    ExperimentResult result;
    result.paper = &experiment;
    const Session session = paperSession(experiment, plan.published);
    result.cutting = cuttingPictures(session);
    result.falling = fallPictures(session);
    result.session = withPictures(withPictures(session, result.cutting, kCuttingWidth),
                                  result.falling, kFallWidth);
    const Moments at = momentsOf(session);
    StrokeTimes stroke;
    const RowListener time = timing(stroke, at);
    result.summary = replay(
        result.session, plan.out / experiment.name, experiment.name, [&](const MetricsRow& row) {
            time(row);
            result.curves.add(row);
            if (row.report.step == at.lift) {
                result.afterStroke = {row.report.vertices, row.report.triangles, row.report.ispcs};
            }
        });
    result.strokes.push_back(stroke);
    return result;
}

StrokeTimes timeStroke(const Session& session, const Moments& at,
                       const std::filesystem::path& folder, const std::string& what) {
    StrokeTimes times;
    replay(session, folder, what, timing(times, at));
    return times;
}

/// The stroke with each way of finding triangles; it was run with the session's own way already.
std::vector<SearchRun> runSearches(const Session& stroke, const Moments& at,
                                   const StrokeTimes& ownWay, const std::filesystem::path& folder,
                                   const std::string& name) {
    const ParamInfo& parameter = *findParam(kSearchParameter);
    const ParamValue own = getParam(stroke.params, kSearchParameter);
    std::vector<SearchRun> runs;
    for (const std::string_view choice : parameter.choices) {
        const std::string way(choice);
        if (own == ParamValue(way)) {
            runs.push_back({way, ownWay});
            continue;
        }
        Session other = stroke;
        setParam(other.params, kSearchParameter, way);
        runs.push_back({way, timeStroke(other, at, folder / "search" / way,
                                        fmt::format("{}, search {}", name, way))});
    }
    return runs;
}

/// Pictures the hollow body in the middle of the cut, in a run of its own with hands that draw the
/// lips apart. Returns the picture, if there is one.
std::optional<ReportPicture> pictureHollow(const Session& session,
                                           const std::filesystem::path& folder) {
    ModelMesh model = loadSessionModel(session);
    std::optional<Session> hollow = hollowSession(session, model.mesh);
    if (!hollow) {
        return std::nullopt;
    }
    sizePictures(*hollow, kCuttingWidth);
    replaySession(*hollow, std::move(model), folder / kHollowFolder, {});
    return ReportPicture{hollow->steps, std::string(kHollowFolder) + "/" + kHollowFile,
                         "hollow: lips drawn apart"};
}

HollowRun runHollow(const ExperimentPlan& plan, double ispcStiffness, const std::string& name) {
    const std::string file = name + ".png";
    HollowRun run;
    run.picture = std::string(kFigure2Folder) + "/" + name + "/" + file;
    run.summary = replay(figure2Session(plan.published, ispcStiffness, file),
                         plan.out / kFigure2Folder / name, "figure 2, " + name,
                         [&run](const MetricsRow& row) {
                             if (row.report.step == kFigure2Step - 1) {
                                 run.pictureVolume = row.report.volumeRatio;
                             }
                         });
    return run;
}

}  // namespace

ExperimentResult runExperiment(const PaperExperiment& experiment, const ExperimentPlan& plan) {
    ExperimentResult result = runWhole(experiment, plan);
    const Moments at = momentsOf(result.session);
    const Session stroke = strokeAlone(result.session);
    for (int run = 2; run <= plan.runs; ++run) {
        const std::string name = fmt::format("{}", run);
        result.strokes.push_back(timeStroke(stroke, at, plan.out / experiment.name / "runs" / name,
                                            fmt::format("{}, stroke {}", experiment.name, name)));
    }
    result.searches =
        runSearches(stroke, at, result.strokes.back(), plan.out / experiment.name, experiment.name);
    if (plan.published) {
        const Session session = paperSession(experiment, plan.published);
        if (const auto hollow = pictureHollow(session, plan.out / experiment.name)) {
            result.cutting.insert(result.cutting.begin() + kHollowPlace, *hollow);
        }
    }
    return result;
}

Figure2 runFigure2(const ExperimentPlan& plan) {
    const PaperExperiment& sphere = *findPaperExperiment(kFigure2Model);
    const double stiffness = paperSession(sphere, plan.published).params.ispcStiffness;
    return {runHollow(plan, 0, "without"), runHollow(plan, stiffness, "with")};
}

}  // namespace kerf::app
