#include "bench/lab/bar_experiment.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <ostream>

#include "app/files/io/exit_codes.h"
#include "app/files/jobs/progress_line.h"
#include "gpu/context.h"
#include "sim/base/text.h"

namespace kerf::app {

namespace {

constexpr std::array kKinds{SpecimenKind::hangingBar,   SpecimenKind::bentBar,
                            SpecimenKind::bentSlab,     SpecimenKind::compressedBlock,
                            SpecimenKind::shearedBlock, SpecimenKind::hangingCube,
                            SpecimenKind::pressedSphere};
constexpr std::array kModuli{1e4, 1e5, 1e6};
constexpr std::array kCells{2, 3, 4, 6};
constexpr std::array kIterations{5, 10, 20, 40, 60};
constexpr std::array kTimeSteps{0.0025, 0.005, 0.01};
constexpr std::array kOrderSteps{0.005, 0.0025};
constexpr std::array kOrderIterations{10, 20, 40};
// At a bar that comes down. Later ways in a substep are too short for floats.
constexpr int kOrderLooks = 8;
constexpr double kMostVolumeChange = 0.01;
constexpr const char* kBarReportFile = "report.md";
constexpr const char* kBarSummaryFile = "summary.json";

const char* nameOf(SpecimenKind kind) {
    switch (kind) {
        case SpecimenKind::hangingBar:
            return "hanging bar";
        case SpecimenKind::bentBar:
            return "bent bar";
        case SpecimenKind::bentSlab:
            return "bent slab";
        case SpecimenKind::compressedBlock:
            return "compressed block";
        case SpecimenKind::shearedBlock:
            return "sheared block";
        case SpecimenKind::hangingCube:
            return "hanging cube";
        case SpecimenKind::pressedSphere:
            return "pressed sphere";
    }
    return "";
}

const char* nameOf(bool trueModulus) {
    return trueModulus ? "true modulus" : "plain ISPCs";
}

/// "1.62": effective modulus over the parameter, with a star where the program says that iterations
/// are too few; a dash where that test was not run.
std::string ratioOf(const std::vector<BenchRun>& runs, const BenchSetting& setting) {
    const auto run =
        std::ranges::find_if(runs, [&](const BenchRun& r) { return r.setting == setting; });
    return run == runs.end()
               ? "-"
               : fmt::format("{:.2f}{}{}", run->result.effectiveModulus / setting.modulus,
                             run->result.tooFewIterations ? "*" : "",
                             run->result.settled ? "" : " (still moving)");
}

template <class Columns, class Setting>
std::string table(const std::vector<BenchRun>& runs, const char* unit, const Columns& columns,
                  Setting&& settingOf) {
    std::string text = "| specimen | E, Pa |";
    std::string rule = "|---|---|";
    for (const auto column : columns) {
        text += fmt::format(" {} {} |", column, unit);
        rule += "---|";
    }
    text += "\n" + rule + "\n";
    for (const SpecimenKind kind : kKinds) {
        for (const double modulus : kModuli) {
            text += fmt::format("| {} | {:.0e} |", nameOf(kind), modulus);
            for (const auto column : columns) {
                text += " " + ratioOf(runs, settingOf(kind, modulus, column)) + " |";
            }
            text += "\n";
        }
    }
    return text;
}

nlohmann::ordered_json toJson(const BenchRun& run) {
    return {{"specimen", nameOf(run.setting.kind)},
            {"cells", run.setting.cells},
            {"triangles", run.result.triangles},
            {"youngs_modulus", run.setting.modulus},
            {"iterations", run.setting.iterations},
            {"time_step", run.setting.timeStep},
            {"true_modulus", run.setting.trueModulus ? 1 : 0},
            {"strain", run.result.strain},
            {"effective_modulus", run.result.effectiveModulus},
            {"ratio", run.result.effectiveModulus / run.setting.modulus},
            {"too_few_iterations", run.result.tooFewIterations},
            {"volume_ratio", run.result.volumeRatio},
            {"settled", run.result.settled}};
}

std::string describe(const BenchSetting& setting) {
    return fmt::format("{}, E = {:.0e} Pa, {} cells, {} iterations of {} s, {}",
                       nameOf(setting.kind), setting.modulus, setting.cells, setting.iterations,
                       setting.timeStep, nameOf(setting.trueModulus));
}

/// Empty where every specimen kept its volume.
std::string firstFailure(const std::vector<BenchRun>& runs) {
    for (const BenchRun& run : runs) {
        if (!(std::abs(run.result.volumeRatio - 1) < kMostVolumeChange)) {
            return fmt::format("bar: {}: the volume is {:.2f} % of what it was.",
                               describe(run.setting), 100 * run.result.volumeRatio);
        }
    }
    return "";
}

std::vector<std::string> stillMoving(const std::vector<BenchRun>& runs) {
    std::vector<std::string> names;
    for (const BenchRun& run : runs) {
        if (!run.result.settled) {
            names.push_back(describe(run.setting));
        }
    }
    return names;
}

std::vector<BenchRun> runAll(bool whole) {
    std::vector<BenchRun> runs;
    const std::vector<BenchSetting> settings = barSettings(whole);
    ProgressLine line("bar: ");
    for (const BenchSetting& setting : settings) {
        line.show(static_cast<int>(runs.size()), static_cast<int>(settings.size()));
        runs.push_back({setting, measureModulus(setting)});
    }
    return runs;
}

/// Of one material.
std::string tables(const std::vector<BenchRun>& runs, bool trueModulus) {
    const auto setting = [&](SpecimenKind kind, double modulus) {
        return BenchSetting{.kind = kind, .modulus = modulus, .trueModulus = trueModulus};
    };
    std::string text = fmt::format("\n## With {}\n", nameOf(trueModulus));
    text += "\n### By resolution (squares across the specimen), 20 iterations of 5 ms\n\n";
    text += table(runs, "across", kCells, [&](SpecimenKind kind, double modulus, int cells) {
        BenchSetting s = setting(kind, modulus);
        s.cells = cells;
        return s;
    });
    text += "\n### By iterations of 5 ms, 4 squares across\n\n";
    text += table(runs, "iterations", kIterations, [&](SpecimenKind kind, double modulus, int n) {
        BenchSetting s = setting(kind, modulus);
        s.iterations = n;
        return s;
    });
    text += "\n### By time step, 20 iterations, 4 squares across\n\n";
    text += table(runs, "s", kTimeSteps, [&](SpecimenKind kind, double modulus, double step) {
        BenchSetting s = setting(kind, modulus);
        s.timeStep = step;
        return s;
    });
    return text;
}

std::string formatCounts(const std::vector<BenchRun>& runs) {
    std::string text =
        "\n## How many hold\n\n"
        "| material | iterations | runs | within 10 % | within 25 % |\n|---|---|---|---|---|\n";
    for (const bool trueModulus : {true, false}) {
        for (const bool tooFew : {false, true}) {
            const BarCount count = countBarRuns(runs, trueModulus, tooFew);
            text += fmt::format("| {} | {} | {} | {} | {} |\n", nameOf(trueModulus),
                                tooFew ? "too few, as the program says" : "enough", count.all,
                                count.within10, count.within25);
        }
    }
    return text;
}

BenchSetting fallingBar(int iterations, double timeStep) {
    return {.cells = 2, .iterations = iterations, .timeStep = timeStep};
}

AccuracyRun accuracyOf(int iterations, double timeStep, const std::vector<double>& exact) {
    const std::vector<double> motion = motionOfEnd(fallingBar(iterations, timeStep), kOrderLooks);
    AccuracyRun run{iterations, timeStep, 0};
    for (std::size_t i = 0; i < motion.size(); ++i) {
        run.error = std::max(run.error, std::abs(motion[i] - exact[i]) / exact.back());
    }
    return run;
}

double substepOf(const AccuracyRun& run) {
    return run.timeStep / run.iterations;
}

nlohmann::ordered_json toJson(const AccuracyRun& run) {
    return {{"iterations", run.iterations}, {"time_step", run.timeStep}, {"error", run.error}};
}

}  // namespace

std::vector<AccuracyRun> measureAccuracy(const std::vector<int>& iterations,
                                         const std::vector<double>& timeSteps) {
    constexpr int kFiner = 4;
    const std::vector<double> exact =
        motionOfEnd(fallingBar(kFiner * std::ranges::max(iterations), std::ranges::min(timeSteps)),
                    kOrderLooks);
    std::vector<AccuracyRun> runs;
    for (const int n : iterations) {
        for (const double step : timeSteps) {
            runs.push_back(accuracyOf(n, step, exact));
        }
    }
    return runs;
}

double orderOf(const std::vector<AccuracyRun>& runs) {
    double x = 0;
    double y = 0;
    double xx = 0;
    double xy = 0;
    for (const AccuracyRun& run : runs) {
        const double length = std::log(substepOf(run));
        const double size = std::log(run.error);
        x += length;
        y += size;
        xx += length * length;
        xy += length * size;
    }
    const auto n = static_cast<double>(runs.size());
    return (n * xy - x * y) / (n * xx - x * x);
}

std::string formatAccuracy(const std::vector<AccuracyRun>& runs) {
    std::string text =
        "\n## Accuracy by iterations\n\n"
        "The hanging bar of 1e5 Pa, two squares across, with a true modulus. The largest error of "
        "where its end is while it comes down, in per cent of that way.\n\n"
        "| iterations | time step, s | substep, ms | error, % |\n"
        "|---|---|---|---|\n";
    for (const AccuracyRun& run : runs) {
        text += fmt::format("| {} | {} | {:.3g} | {:.2g} |\n", run.iterations, run.timeStep,
                            1000 * substepOf(run), 100 * run.error);
    }
    return text +
           fmt::format("\nThe error falls as the substep to the power of {:.2f}.\n", orderOf(runs));
}

BarCount countBarRuns(const std::vector<BenchRun>& runs, bool trueModulus, bool tooFewIterations) {
    BarCount count;
    for (const BenchRun& run : runs) {
        if (run.setting.trueModulus == trueModulus &&
            run.result.tooFewIterations == tooFewIterations) {
            const double error = std::abs(run.result.effectiveModulus / run.setting.modulus - 1);
            ++count.all;
            count.within10 += error <= 0.10 ? 1 : 0;
            count.within25 += error <= 0.25 ? 1 : 0;
        }
    }
    return count;
}

std::vector<BenchSetting> barSettings(bool whole) {
    std::vector<BenchSetting> settings;
    const auto add = [&](const BenchSetting& setting) {
        const BenchSetting usual;
        const int changes = (setting.cells != usual.cells ? 1 : 0) +
                            (setting.iterations != usual.iterations ? 1 : 0) +
                            (setting.timeStep != usual.timeStep ? 1 : 0);
        if (whole || changes <= 1) {
            settings.push_back(setting);
        }
    };
    for (const bool trueModulus : {true, false}) {
        for (const SpecimenKind kind : kKinds) {
            for (const double modulus : kModuli) {
                for (const int cells : kCells) {
                    for (const int iterations : kIterations) {
                        for (const double step : kTimeSteps) {
                            add({kind, cells, modulus, iterations, step, trueModulus});
                        }
                    }
                }
            }
        }
    }
    return settings;
}

std::string formatBarReport(const std::vector<BenchRun>& runs) {
    return "# Effective Young's modulus\n\n"
           "A bar that hangs from its pinned top, the same bar and one five times as wide bent by "
           "a weight that acts sideways, a block that stands on a floor without friction, a flat "
           "one that a weight sideways shears, and a cube that hangs from its pinned top. Each is "
           "loaded by its own weight so that a solid of modulus E changes its length, or moves its "
           "end aside, by 1 %. A sphere is pressed on a floor so that Hertz's formula lets its "
           "middle down by 2 % of its diameter. The figures are E_eff / E: the modulus of the "
           "incompressible solid that would move as much as ours, over the parameter "
           "`youngs_modulus`. 1 is true to the parameter, more is too stiff. Beside a star the "
           "program says that iterations are too few.\n" +
           formatCounts(runs) + tables(runs, true) + tables(runs, false);
}

std::string stillMovingWarning(const std::vector<BenchRun>& runs) {
    const std::vector<std::string> names = stillMoving(runs);
    return names.empty()
               ? ""
               : fmt::format(
                     "bar: {} still moving when time was up, so what stands there "
                     "is not final: {}.",
                     counted(names.size(), "specimen was", "specimens were"), joined(names, "; "));
}

int reportBarRuns(const std::vector<BenchRun>& runs, const std::vector<AccuracyRun>& accuracy,
                  OutputFolder& folder, bool json, std::ostream& out, std::ostream& errors) {
    nlohmann::ordered_json summary;
    for (const BenchRun& run : runs) {
        summary["tests"].push_back(toJson(run));
    }
    summary["still_moving"] = stillMoving(runs);
    for (const AccuracyRun& run : accuracy) {
        summary["accuracy"].push_back(toJson(run));
    }
    const std::string report =
        formatBarReport(runs) + (accuracy.empty() ? "" : formatAccuracy(accuracy));
    folder.write(kBarReportFile, report);
    folder.write(kBarSummaryFile, summary.dump(2) + "\n");
    out << (json ? summary.dump() + "\n" : report);
    for (const std::string& sentence : {stillMovingWarning(runs), firstFailure(runs)}) {
        if (!sentence.empty()) {
            errors << sentence << "\n";
        }
    }
    return firstFailure(runs).empty() ? kExitDone : kExitCheckFailed;
}

int runBarExperiment(const std::filesystem::path& folder, bool whole, bool json, std::ostream& out,
                     std::ostream& errors) {
    const gpu::EglContext context;
    OutputFolder own(folder / kBarExperiment);
    own.remove(kBarSummaryFile);
    own.remove(kBarReportFile);
    const std::vector<AccuracyRun> accuracy =
        measureAccuracy({kOrderIterations.begin(), kOrderIterations.end()},
                        {kOrderSteps.begin(), kOrderSteps.end()});
    return reportBarRuns(runAll(whole), accuracy, own, json, out, errors);
}

}  // namespace kerf::app
