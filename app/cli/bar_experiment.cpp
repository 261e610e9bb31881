#include "app/cli/bar_experiment.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <ostream>

#include "app/cli/exit_codes.h"
#include "app/files/progress_line.h"
#include "gpu/context.h"
#include "sim/base/text.h"

namespace kerf::app {

namespace {

constexpr std::array kKinds{SpecimenKind::hangingBar, SpecimenKind::bentBar, SpecimenKind::bentSlab,
                            SpecimenKind::compressedBlock};
constexpr std::array kModuli{1e4, 1e5, 1e6};
constexpr std::array kCells{2, 3, 4, 6};
constexpr std::array kIterations{5, 10, 20, 40, 60};
constexpr double kMostVolumeChange = 0.01;
constexpr const char* kReportFile = "report.md";
constexpr const char* kSummaryFile = "summary.json";

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
    }
    return "";
}

bool sameSetting(const BenchSetting& a, const BenchSetting& b) {
    return a.kind == b.kind && a.cells == b.cells && a.modulus == b.modulus &&
           a.iterations == b.iterations;
}

/// Each once, in the order in which they run.
std::vector<BenchSetting> allSettings() {
    std::vector<BenchSetting> settings;
    const auto add = [&](const BenchSetting& setting) {
        const auto isSame = [&](const BenchSetting& s) { return sameSetting(s, setting); };
        if (std::ranges::none_of(settings, isSame)) {
            settings.push_back(setting);
        }
    };
    for (const SpecimenKind kind : kKinds) {
        for (const double modulus : kModuli) {
            for (const int cells : kCells) {
                add({.kind = kind, .cells = cells, .modulus = modulus});
            }
            for (const int iterations : kIterations) {
                add({.kind = kind, .modulus = modulus, .iterations = iterations});
            }
        }
    }
    return settings;
}

/// "1.62": effective modulus over the parameter; a dash where that test was not run.
std::string ratioOf(const std::vector<BenchRun>& runs, const BenchSetting& setting) {
    const auto run = std::ranges::find_if(
        runs, [&](const BenchRun& r) { return sameSetting(r.setting, setting); });
    return run == runs.end()
               ? "-"
               : fmt::format("{:.2f}{}", run->result.effectiveModulus / setting.modulus,
                             run->result.settled ? "" : " (still moving)");
}

template <class Columns, class Setting>
std::string table(const std::vector<BenchRun>& runs, const char* unit, const Columns& columns,
                  Setting&& settingOf) {
    std::string text = "| specimen | E, Pa |";
    std::string rule = "|---|---|";
    for (const int column : columns) {
        text += fmt::format(" {} {} |", column, unit);
        rule += "---|";
    }
    text += "\n" + rule + "\n";
    for (const SpecimenKind kind : kKinds) {
        for (const double modulus : kModuli) {
            text += fmt::format("| {} | {:.0e} |", nameOf(kind), modulus);
            for (const int column : columns) {
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
            {"ispc_stiffness", run.setting.ispcStiffness},
            {"strain", run.result.strain},
            {"effective_modulus", run.result.effectiveModulus},
            {"ratio", run.result.effectiveModulus / run.setting.modulus},
            {"volume_ratio", run.result.volumeRatio},
            {"settled", run.result.settled}};
}

std::string describe(const BenchSetting& setting) {
    return fmt::format("{}, E = {:.0e} Pa, {} cells, {} iterations", nameOf(setting.kind),
                       setting.modulus, setting.cells, setting.iterations);
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

std::vector<BenchRun> runAll() {
    std::vector<BenchRun> runs;
    const std::vector<BenchSetting> settings = allSettings();
    ProgressLine line("bar: ");
    for (const BenchSetting& setting : settings) {
        line.show(static_cast<int>(runs.size()), static_cast<int>(settings.size()));
        runs.push_back({setting, measureModulus(setting)});
    }
    return runs;
}

}  // namespace

std::string formatBarReport(const std::vector<BenchRun>& runs) {
    return "# Effective Young's modulus\n\n"
           "A bar that hangs from its pinned top, the same bar and one five times as wide bent by "
           "a weight that acts sideways, and a block that stands on a floor without friction, "
           "loaded by their own weight so that a solid of modulus E changes its length, or moves "
           "its end aside, by 1 %. The figures are E_eff / E: the modulus of the solid that would "
           "change as much as ours, over the parameter `youngs_modulus`. 1 is true to the "
           "parameter, more is too stiff.\n\n"
           "## By resolution (squares across the specimen), 20 iterations\n\n" +
           table(runs, "across", kCells,
                 [](SpecimenKind kind, double modulus, int cells) {
                     return BenchSetting{.kind = kind, .cells = cells, .modulus = modulus};
                 }) +
           "\n## By iterations, 4 squares across\n\n" +
           table(runs, "iterations", kIterations,
                 [](SpecimenKind kind, double modulus, int iterations) {
                     return BenchSetting{
                         .kind = kind, .modulus = modulus, .iterations = iterations};
                 });
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

int reportBarRuns(const std::vector<BenchRun>& runs, OutputFolder& folder, bool json,
                  std::ostream& out, std::ostream& errors) {
    nlohmann::ordered_json summary;
    for (const BenchRun& run : runs) {
        summary["tests"].push_back(toJson(run));
    }
    summary["still_moving"] = stillMoving(runs);
    const std::string report = formatBarReport(runs);
    folder.write(kReportFile, report);
    folder.write(kSummaryFile, summary.dump(2) + "\n");
    out << (json ? summary.dump() + "\n" : report);
    for (const std::string& sentence : {stillMovingWarning(runs), firstFailure(runs)}) {
        if (!sentence.empty()) {
            errors << sentence << "\n";
        }
    }
    return firstFailure(runs).empty() ? kExitDone : kExitCheckFailed;
}

int runBarExperiment(const std::filesystem::path& folder, bool json, std::ostream& out,
                     std::ostream& errors) {
    const gpu::EglContext context;
    OutputFolder own(folder / kBarExperiment);
    own.remove(kSummaryFile);
    own.remove(kReportFile);
    return reportBarRuns(runAll(), own, json, out, errors);
}

}  // namespace kerf::app
