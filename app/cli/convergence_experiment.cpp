#include "app/cli/convergence_experiment.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <ostream>

#include "app/files/exit_codes.h"
#include "app/files/output_folder.h"
#include "app/files/progress_line.h"
#include "gpu/context.h"

namespace kerf::app {

namespace {

constexpr double kLeastOrder = 0.9;
constexpr double kLongest = 4;  // substep that counts for the order, over the shortest
constexpr double kSwing = 0.2;  // [s]
constexpr const char* kConvergenceReportFile = "report.md";
constexpr const char* kConvergenceSummaryFile = "summary.json";

const char* specimenName(const BenchSetting& setting) {
    return setting.kind == SpecimenKind::bentBar ? "bent bar" : "hanging bar";
}

double sumOfSquares(const std::vector<Vec3>& ways) {
    double sum = 0;
    for (const Vec3& way : ways) {
        sum += way.squaredNorm();
    }
    return sum;
}

double errorAgainst(const std::vector<Vec3>& reference, std::vector<Vec3> ways) {
    for (std::size_t v = 0; v < ways.size(); ++v) {
        ways[v] -= reference[v];
    }
    return std::sqrt(sumOfSquares(ways) / sumOfSquares(reference));
}

/// As with no substep at all, from two that are twice as long as one another.
std::vector<Vec3> exactWays(const BenchSetting& setting, double seconds) {
    BenchSetting coarser = setting;
    coarser.timeStep *= 2;
    std::vector<Vec3> ways = courseInDoubles(setting, seconds).ways;
    const std::vector<Vec3> further = courseInDoubles(coarser, seconds).ways;
    for (std::size_t v = 0; v < ways.size(); ++v) {
        ways[v] = 2 * ways[v] - further[v];
    }
    return ways;
}

std::vector<Convergence> swingAll() {
    std::vector<Convergence> all;
    ProgressLine line("convergence: ");
    const std::vector kinds{SpecimenKind::hangingBar, SpecimenKind::bentBar};
    for (const SpecimenKind kind : kinds) {
        line.show(static_cast<int>(all.size()), static_cast<int>(kinds.size()));
        const BenchSetting reference{
            .kind = kind, .cells = 2, .modulus = 1e5, .iterations = 40, .timeStep = 0.00125};
        all.push_back(measureConvergence(reference, kSwing, {0.0025, 0.005, 0.01}, {5, 10, 20}));
    }
    return all;
}

nlohmann::ordered_json toJson(const Convergence& convergence) {
    nlohmann::ordered_json json{{"specimen", specimenName(convergence.reference)},
                                {"seconds", convergence.seconds},
                                {"order", convergence.order()}};
    for (const ConvergenceRun& run : convergence.runs) {
        json["runs"].push_back({{"time_step", run.setting.timeStep},
                                {"iterations", run.setting.iterations},
                                {"error", run.error},
                                {"too_few_iterations", run.tooFewIterations}});
    }
    return json;
}

/// Rows are time steps; runs lie by rows.
std::string convergenceTable(const Convergence& convergence) {
    const std::vector<ConvergenceRun>& runs = convergence.runs;
    std::string head = "| time step, ms |";
    std::string rule = "|---|";
    std::string rows;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const BenchSetting& setting = runs[i].setting;
        const bool begins = i == 0 || setting.timeStep != runs[i - 1].setting.timeStep;
        if (setting.timeStep == runs.front().setting.timeStep) {
            head += fmt::format(" {} iterations |", setting.iterations);
            rule += "---|";
        }
        rows += begins ? fmt::format("\n| {} |", 1000 * setting.timeStep) : "";
        rows +=
            fmt::format(" {:.2g}{} |", 100 * runs[i].error, runs[i].tooFewIterations ? "*" : "");
    }
    return head + "\n" + rule + rows + "\n";
}

}  // namespace

double Convergence::order() const {
    double shortest = std::numeric_limits<double>::infinity();
    for (const ConvergenceRun& run : runs) {
        shortest = std::min(shortest, run.substep());
    }
    double count = 0;
    double x = 0;
    double y = 0;
    double xx = 0;
    double xy = 0;
    for (const ConvergenceRun& run : runs) {
        if (!run.tooFewIterations && run.substep() < 1.01 * kLongest * shortest) {
            const double logStep = std::log(run.substep());
            const double logError = std::log(run.error);
            count += 1;
            x += logStep;
            y += logError;
            xx += logStep * logStep;
            xy += logStep * logError;
        }
    }
    const double spread = count * xx - x * x;
    return spread > 1e-9 ? (count * xy - x * y) / spread : 0;
}

Convergence measureConvergence(const BenchSetting& reference, double seconds,
                               const std::vector<double>& timeSteps,
                               const std::vector<int>& iterations) {
    const std::vector<Vec3> exact = exactWays(reference, seconds);
    Convergence convergence{reference, seconds, {}};
    for (const double step : timeSteps) {
        for (const int count : iterations) {
            BenchSetting setting = reference;
            setting.timeStep = step;
            setting.iterations = count;
            const BenchCourse course = courseOf(setting, seconds);
            convergence.runs.push_back(
                {setting, errorAgainst(exact, course.ways), course.tooFewIterations});
        }
    }
    return convergence;
}

std::string formatConvergenceReport(const std::vector<Convergence>& all) {
    std::string text =
        "# Convergence\n\n"
        "The weight of a bar begins to act, so it swings. Errors are how far its vertices are from "
        "where much smaller substeps have them, in per cent of their way since rest, as RMS. The "
        "order p is that of the error c h^p over the length h of a substep, up to four times the "
        "shortest. Beside a star the "
        "program says that iterations are too few.\n";
    for (const Convergence& convergence : all) {
        const BenchSetting& reference = convergence.reference;
        text +=
            fmt::format("\n## {}: order {:.2f}\n\n", specimenName(reference), convergence.order());
        text += convergenceTable(convergence);
        text += fmt::format(
            "\nAfter {} s, E = {:.0e} Pa, {} squares across, against {} iterations of {} ms.\n",
            convergence.seconds, reference.modulus, reference.cells, reference.iterations,
            1000 * reference.timeStep);
    }
    return text;
}

int runConvergenceExperiment(const std::filesystem::path& folder, bool json, std::ostream& out,
                             std::ostream& errors) {
    const gpu::EglContext context;
    OutputFolder own(folder / kConvergenceExperiment);
    own.remove(kConvergenceSummaryFile);
    own.remove(kConvergenceReportFile);
    const std::vector<Convergence> all = swingAll();
    nlohmann::ordered_json summary;
    for (const Convergence& convergence : all) {
        summary["specimens"].push_back(toJson(convergence));
    }
    const std::string report = formatConvergenceReport(all);
    own.write(kConvergenceReportFile, report);
    own.write(kConvergenceSummaryFile, summary.dump(2) + "\n");
    out << (json ? summary.dump() + "\n" : report);
    for (const Convergence& convergence : all) {
        if (!(convergence.order() >= kLeastOrder)) {
            errors << fmt::format("convergence: {}: the order is {:.2f}.\n",
                                  specimenName(convergence.reference), convergence.order());
            return kExitCheckFailed;
        }
    }
    return kExitDone;
}

}  // namespace kerf::app
