#include "bench/lab/fem/fem_experiment.h"

#include <array>
#include <nlohmann/json.hpp>
#include <ostream>

#include "app/files/io/exit_codes.h"
#include "app/files/io/file_io.h"
#include "app/files/jobs/progress_line.h"
#include "app/session/session.h"
#include "bench/lab/fem/fem_pictures.h"
#include "gpu/context.h"

namespace kerf::app {

namespace {

constexpr const char* kReportFile = "report.md";

const std::array<FemSetting, 2> kSettings{
    {{"true", "true modulus", [](Params& params) { params.trueModulus = 1; }},
     {"plain", "plain ISPCs", [](Params& params) { params.trueModulus = 0; }}}};

double restDiagonal(const TriangleSoup& model) {
    Bounds bounds;
    for (const Vec3& p : model.positions) {
        bounds.add(p);
    }
    return bounds.diagonal();
}

FemResult resultOf(const FemCase& each, const FemSetting& setting, const KerfRun& run,
                   const LoadedSurface& elements, const LoadedSurface& coarse) {
    FemResult result;
    result.name = each.name;
    result.body = each.body;
    result.cut = each.cut;
    result.setting = setting.label;
    result.kerf = figuresOf(each, run.surface);
    result.elements = figuresOf(each, elements);
    result.coarse = figuresOf(each, coarse);
    result.shape = shapeDeviation(run.surface, elements);
    result.diagonal = restDiagonal(each.model);
    result.settled = run.settled;
    result.steps = run.steps;
    result.stateHash = run.stateHash;
    result.tooFew = run.tooFew;
    result.picture = each.name + "-" + setting.name + ".png";
    result.session = sessionFile(each, setting);
    return result;
}

}  // namespace

std::span<const FemSetting> femSettings() {
    return kSettings;
}

std::vector<FemResult> runFemCases(const std::vector<FemCase>& cases,
                                   std::span<const FemSetting> settings, OutputFolder& folder) {
    std::vector<FemResult> results;
    ProgressLine line("fem: ");
    const int total = static_cast<int>(cases.size() * settings.size());
    for (const FemCase& each : cases) {
        line.show(static_cast<int>(results.size()), total);
        const LoadedSurface elements = relaxedSurface(each, each.solid);
        const LoadedSurface coarse = relaxedSurface(each, each.coarseSolid);
        for (const FemSetting& setting : settings) {
            line.show(static_cast<int>(results.size()), total);
            const KerfRun run = runKerf(each, setting, folder);
            results.push_back(resultOf(each, setting, run, elements, coarse));
            const FemResult& result = results.back();
            writePicture(
                drawBesideEachOther(each.body + ", cut: " + each.cut + ", " + setting.label,
                                    run.surface, elements),
                folder.pathOf(result.picture));
            folder.noteWritten(result.picture);
        }
    }
    return results;
}

int runFemExperiment(const std::filesystem::path& folder, bool json, std::ostream& out) {
    const gpu::EglContext context;
    OutputFolder own(folder / kFemExperiment);
    own.remove(kSummaryFile);
    own.remove(kReportFile);
    const std::vector<FemResult> results = runFemCases(femCases(), femSettings(), own);
    const std::string report = formatFemReport(results);
    const std::string summary = formatFemSummary(results);
    own.write(kReportFile, report);
    own.write(kSummaryFile, summary);
    out << (json ? nlohmann::ordered_json::parse(summary).dump() + "\n" : report);
    return kExitDone;
}

}  // namespace kerf::app
