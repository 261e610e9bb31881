#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/session/metrics.h"
#include "bench/lab/experiment/paper_session.h"
#include "ui/plots/plot_math.h"
#include "ui/plots/series.h"

namespace kerf::app {

/// What the plots of a run show, against simulated time [s].
struct RunCurves {
    ui::Series volume;  ///< % of rest
    ui::Series frames;  ///< [ms]
    std::vector<ui::PlotMark> marks;

    void add(const MetricsRow& row);

  private:
    int pieces_ = 0;
};

/// What is measured while the blade cuts: from its first pose to the end of the stroke.
struct StrokeTimes {
    Range frameMs;
    Range cutMs;
    Range searchMs;     ///< for the triangles near the blade, part of the cut
    Range walkMs;       ///< of it, the walk from the first seed (CutSearch::adjacency)
    Range searchTests;  ///< triangles that were tested
    int mostSeeds = 0;  ///< groups of neighbours that needed a seed, of a step

    void add(const MetricsRow& row);
    /// Steps over the whole time [1/s]; 0 where nothing was measured.
    double fps() const { return frameMs.mean() > 0 ? 1000 / frameMs.mean() : 0; }
};

/// A stroke whose triangles were found in a way.
struct SearchRun {
    std::string way;  ///< a choice of the parameter `cut_search`
    StrokeTimes times;
};

/// One of the paper's experiments, run.
struct ExperimentResult {
    const PaperExperiment* paper = nullptr;
    Session session;  ///< as it ran
    RunSummary summary;
    RunCurves curves;
    Counts afterStroke;                ///< after the step in which the stroke ended
    std::vector<StrokeTimes> strokes;  ///< of all runs, the complete one first
    std::vector<SearchRun> searches;   ///< one for each way, in the order of the parameter
    std::vector<ReportPicture> cutting, falling;
};

/// Mean frame rates of the strokes of an experiment [1/s].
struct StrokeRates {
    double mean = 0;   ///< of all runs
    double least = 0;  ///< of one run
    double most = 0;   ///< of one run
};
/// The rates of an experiment with at least one run.
StrokeRates strokeRates(const ExperimentResult& result);

/// One of the two runs of figure 2.
struct HollowRun {
    std::string picture;       ///< relative to the report
    double pictureVolume = 1;  ///< over that at rest, before the step of the picture
    RunSummary summary;
};
/// Figure 2: halves of Sphere 768 on the floor.
struct Figure2 {
    HollowRun without;  ///< ISPC stiffness 0
    HollowRun with;     ///< that of the experiment
};

/// All that a report tells.
struct ReportData {
    bool published = false;  ///< solver, contact and course of the cut were the paper's too
    std::vector<ExperimentResult> results;  ///< at least one, in the paper's order
    std::optional<Figure2> figure2;
};

}  // namespace kerf::app
