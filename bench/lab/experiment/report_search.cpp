#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "bench/lab/experiment/report_figures.h"
#include "bench/lab/experiment/report_markdown.h"
#include "bench/lab/experiment/report_sections.h"

namespace kerf::app {

namespace {

constexpr const char* kPaperWay = "adjacency";
constexpr const char* kFormerWay = "all";
constexpr double kDecisiveShare = 0.1;  ///< of a step that a search takes

const StrokeTimes* timesOf(const ExperimentResult& result, std::string_view way) {
    const auto found = std::ranges::find(result.searches, way, &SearchRun::way);
    return found == result.searches.end() ? nullptr : &found->times;
}

std::string ways(const ReportData& data) {
    std::vector<Cells> rows;
    for (const ExperimentResult& result : data.results) {
        for (const SearchRun& run : result.searches) {
            const StrokeTimes& times = run.times;
            rows.push_back({result.paper->label, run.way,
                            fmt::format("{:.0f}", times.searchTests.mean()), spread(times.searchMs),
                            run.way == kPaperWay ? spread(times.walkMs) : kNotGiven,
                            run.way == kPaperWay ? fmt::format("{}", times.mostSeeds) : kNotGiven,
                            spread(times.cutMs), fmt::format("{:.1f}", times.fps())});
        }
    }
    return markdownTable(
        {"model", "`cut_search`", "triangles tested", "search, ms",
         "of it, walk from the first seed, ms", "most seeds", "cut, ms", "frames/s"},
        rows);
}

/// By how much frames come faster where they take `now` instead of `before` [%].
std::string gain(double before, double now) {
    return now > 0 ? fmt::format("{:.2f}", 100 * (before / now - 1)) : kNotGiven;
}

/// The last two columns leave all other times as they are with the former way.
Cells gainsOf(const ExperimentResult& result) {
    const StrokeTimes* walk = timesOf(result, kPaperWay);
    const StrokeTimes* all = timesOf(result, kFormerWay);
    if (walk == nullptr || all == nullptr) {
        return {result.paper->label, kNotGiven, kNotGiven, kNotGiven, kNotGiven};
    }
    const double saved = all->searchMs.mean() - walk->walkMs.mean();
    const double frame = all->frameMs.mean();
    const double cut = all->cutMs.mean();
    return {result.paper->label,
            result.paper->gain > 0 ? fmt::format("{:.2f}", result.paper->gain) : kNotGiven,
            gain(frame, walk->frameMs.mean()), gain(frame, frame - saved), gain(cut, cut - saved)};
}

std::string gains(const ReportData& data) {
    return experimentTable({"model", "paper: gain, %", "frames/s, as measured, %",
                            "frames/s, by the walk alone, %", "cuts/s, by the walk alone, %"},
                           data.results, gainsOf);
}

/// How much of a step the slowest search takes, where it was run.
std::string shareSentence(const ReportData& data) {
    double most = 0;
    for (const ExperimentResult& result : data.results) {
        const StrokeTimes* all = timesOf(result, kFormerWay);
        if (all != nullptr && all->frameMs.mean() > 0) {
            most = std::max(most, all->searchMs.mean() / all->frameMs.mean());
        }
    }
    return most == 0 || most > kDecisiveShare
               ? ""
               : fmt::format(
                     " Even the search among all takes at most {:.1f} % of a step of a "
                     "stroke here, so it cannot decide the frame rate.",
                     100 * most);
}

}  // namespace

std::string searchSection(const ReportData& data) {
    return "## The search for triangles (the paper's section 4)\n\n"
           "The paper attributes its gain to a search among adjacent triangles instead of all. "
           "`cut_search` has both, and the tree that Kerf uses; all three find the same triangles, "
           "so the cut is the same bit for bit. The paper's search ends with the walk from its "
           "first "
           "seed, which misses what hangs together with no seed, such as a second arm; ours goes "
           "on "
           "to the end of the list for more seeds. Each row is one run of the stroke alone.\n\n" +
           ways(data) + markdownPicture("Times of the three ways to search", kSearchFile) +
           "Gain of `adjacency` over `all`. As measured, it has all that disturbs the times of two "
           "runs. \"By the walk alone\" is what the paper's search would give, if all other times "
           "were as they are with `all`." +
           shareSentence(data) + "\n\n" + gains(data);
}

}  // namespace kerf::app
