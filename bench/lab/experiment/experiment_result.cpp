#include "bench/lab/experiment/experiment_result.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

namespace kerf::app {

void RunCurves::add(const MetricsRow& row) {
    const StepReport& step = row.report;
    if (pieces_ != 0 && step.pieces != pieces_) {
        marks.push_back({step.time, fmt::format("{} pieces", step.pieces)});
    }
    pieces_ = step.pieces;
    volume.add(step.time, 100 * step.volumeRatio);
    frames.add(step.time, row.frameMs);
}

void StrokeTimes::add(const MetricsRow& row) {
    const SearchWork& search = row.report.search;
    frameMs.add(row.frameMs);
    cutMs.add(row.report.cutMs);
    searchMs.add(search.milliseconds);
    walkMs.add(search.walkMilliseconds);
    searchTests.add(static_cast<double>(search.tests));
    mostSeeds = std::max(mostSeeds, search.seeds);
}

StrokeRates strokeRates(const ExperimentResult& result) {
    Range rates;
    for (const StrokeTimes& stroke : result.strokes) {
        rates.add(stroke.fps());
    }
    return {rates.mean(), rates.min(), rates.max()};
}

}  // namespace kerf::app
