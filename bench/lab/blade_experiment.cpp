#include "bench/lab/blade_experiment.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <ostream>
#include <utility>

#include "app/files/io/exit_codes.h"
#include "app/files/io/file_io.h"
#include "app/files/io/output_folder.h"
#include "app/files/jobs/progress_line.h"
#include "app/session/material.h"
#include "gpu/context.h"
#include "sim/mesh/box_surface.h"
#include "sim/run/simulation.h"
#include "ui/plots/plot_picture.h"

namespace kerf::app {

namespace {

constexpr double kSize = 0.06;     // of the block [m]
constexpr int kSlabCells = 12;     // across it
constexpr double kSpeed = 0.02;    // of the blade [m/s]
constexpr double kAbove = 0.002;   // where it starts [m]
constexpr double kDepth = 0.04;    // to which it is led [m]
constexpr double kAside = 0.0007;  // of the middle, where no edge of the mesh is [m]
constexpr double kSlabDrag = 2;    // [1/s]
constexpr double kMostMissing = 0.05;
constexpr const char* kBladeReportFile = "report.md";
constexpr const char* kTableFile = "forces.csv";
constexpr const char* kPlotFile = "forces.png";

/// Its bottom at 0.
SurfaceMesh block() {
    TriangleSoup soup = boxSurface(Vec3::Constant(kSize), {kSlabCells, kSlabCells, kSlabCells});
    for (Vec3& p : soup.positions) {
        p.y() += 0.5 * kSize;
    }
    return SurfaceMesh::fromTriangles(soup.positions, soup.triangles);
}

Params paramsOf(const Material& material, double bluntness) {
    Params params;
    params.gravity.setZero();
    params.floor.reset();
    params.airDrag = kSlabDrag;
    params.trueModulus = 1;
    params.iterations = 60;
    applyMaterial(params, material);
    params.damping = 0;  // what it takes is not measured
    params.bladeFeels = 1;
    params.bladeBluntness = bluntness;
    return params;
}

BladePoint pointAfter(const BladePoint& before, double depth, const StepReport& report,
                      const Params& params) {
    return {depth,
            report.bladeLoad ? report.bladeLoad->force.y() : 0,
            before.work + report.heldEdge.work,
            report.kineticEnergy + report.strainEnergy.value_or(0.0) + report.heldEdge.energy,
            before.fracture + report.fractureEnergy,
            before.drag + 2 * params.airDrag * report.kineticEnergy * params.timeStep};
}

std::vector<BladeRun> runAll() {
    struct Wanted {
        const char* material;
        double bluntness;
        const char* label;
    };
    constexpr std::array kWanted{Wanted{"gelatin", 0, "gelatin, sharp blade"},
                                 Wanted{"gelatin", 0.5, "gelatin, blunter blade"},
                                 Wanted{"cheese", 0.5, "cheese"}, Wanted{"tofu", 0.5, "tofu"}};
    std::vector<BladeRun> runs;
    ProgressLine line("blade: ");
    for (const auto& [material, bluntness, label] : kWanted) {
        line.show(static_cast<int>(runs.size()), static_cast<int>(kWanted.size()));
        runs.push_back(measureBlade(label, paramsOf(findMaterial(material, {}), bluntness)));
    }
    return runs;
}

nlohmann::ordered_json toJson(const BladeRun& run) {
    const BladePoint& end = run.points.back();
    return {{"material", run.label},
            {"youngs_modulus", run.params.youngsModulus},
            {"toughness", run.params.toughness},
            {"bluntness", run.params.bladeBluntness},
            {"rupture_force", run.rupture().force},
            {"rupture_depth", run.rupture().depth},
            {"plateau_force", run.plateau()},
            {"expected_force", run.expected()},
            {"work", end.work},
            {"gained", end.gained},
            {"fracture", end.fracture},
            {"drag", end.drag},
            {"found", run.found()}};
}

std::string tableOf(const std::vector<BladeRun>& runs) {
    std::string text = "material,depth,force,work,gained,fracture,drag\n";
    for (const BladeRun& run : runs) {
        for (const BladePoint& p : run.points) {
            text += fmt::format("\"{}\",{},{},{},{},{},{}\n", run.label, p.depth, p.force, p.work,
                                p.gained, p.fracture, p.drag);
        }
    }
    return text;
}

/// A panel for each run: force against depth.
render::Image plotOf(const std::vector<BladeRun>& runs) {
    std::vector<ui::Series> series(runs.size());
    std::vector<ui::PlotSpec> panels;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        for (const BladePoint& p : runs[i].points) {
            series[i].add(1000 * (p.depth + kAbove), p.force);
        }
        ui::PlotSpec spec;
        spec.id = "force";
        spec.title = runs[i].label;
        spec.notes = {fmt::format("toughness {:.3g} J/m\u00b2, bluntness {:.2g}",
                                  runs[i].params.toughness, runs[i].params.bladeBluntness)};
        spec.xUnit = "mm";
        spec.curves = {{.label = "force", .series = &series[i]}};
        spec.reference = {runs[i].expected(), "toughness times width"};
        spec.showsReference = true;
        spec.minSpan = 1e-3;
        spec.readoutDecimals = 3;
        panels.push_back(std::move(spec));
    }
    ui::PlotPainter painter(ui::Theme::light);
    return painter.draw({.title = "Force on the blade, N, against its way down",
                         .panels = panels,
                         .columns = 2,
                         .panelWidth = 440,
                         .panelHeight = 240});
}

std::string missingSentence(const std::vector<BladeRun>& runs) {
    for (const BladeRun& run : runs) {
        if (!(std::fabs(run.found() - 1) < kMostMissing)) {
            return fmt::format("blade: {}: {:.1f} % of the work are found again.", run.label,
                               100 * run.found());
        }
    }
    return "";
}

}  // namespace

double BladeRun::expected() const {
    return params.toughness * kSize;
}

const BladePoint& BladeRun::rupture() const {
    const auto broken =
        std::ranges::find_if(points, [](const BladePoint& p) { return p.fracture > 0; });
    return *std::max_element(
        points.begin(), broken == points.end() ? broken : broken + 1,
        [](const BladePoint& a, const BladePoint& b) { return a.force < b.force; });
}

double BladeRun::plateau() const {
    const double from = rupture().depth + 0.1 * kSize;
    double sum = 0;
    int count = 0;
    for (const BladePoint& p : points) {
        if (p.depth >= from) {
            sum += p.force;
            ++count;
        }
    }
    return count > 0 ? sum / count : 0;
}

double BladeRun::found() const {
    const BladePoint& end = points.back();
    return (end.gained + end.fracture + end.drag) / end.work;
}

BladeRun measureBlade(std::string label, const Params& params) {
    Simulation simulation(block(), params);
    const double low = 0.25 * kSize / kSlabCells;
    simulation.execute(Pin{Bounds{{-1, -low, -1}, {1, low, 1}}});
    BladeRun run{std::move(label), params, {}};
    const double perStep = kSpeed * params.timeStep;
    BladePoint point;
    for (double depth = -kAbove; depth < kDepth; depth += perStep) {
        const double y = kSize - depth;
        simulation.execute(MoveBlade{{{kAside, y, -kSize}, {kAside, y, kSize}}});
        point = pointAfter(point, depth, simulation.step(), params);
        run.points.push_back(point);
    }
    return run;
}

std::string formatBladeReport(const std::vector<BladeRun>& runs) {
    std::string text =
        "# The force on a blade\n\n"
        "A blade goes down into a block of 6 cm, at 2 cm/s. First the material yields and the "
        "force rises; then it breaks in, and goes on at a plateau. What new surface takes is "
        "toughness times width: the plateau lies there by theory. Found again is the share of the "
        "blade's work that became energy of the body, new surface and air drag.\n\n"
        "| material | E, Pa | toughness, J/m\u00b2 | bluntness | breaks in at, N | depth, mm | "
        "plateau, N | toughness times width, N | found again, % |\n"
        "|---|---|---|---|---|---|---|---|---|\n";
    for (const BladeRun& run : runs) {
        text += fmt::format(
            "| {} | {:.3g} | {:.3g} | {:.2g} | {:.3g} | {:.1f} | {:.3g} | {:.3g} "
            "| {:.1f} |\n",
            run.label, run.params.youngsModulus, run.params.toughness, run.params.bladeBluntness,
            run.rupture().force, 1000 * run.rupture().depth, run.plateau(), run.expected(),
            100 * run.found());
    }
    return text + "\n![Force against depth](forces.png)\n";
}

int runBladeExperiment(const std::filesystem::path& folder, bool json, std::ostream& out,
                       std::ostream& errors) {
    const gpu::EglContext context;
    OutputFolder own(folder / kBladeExperiment);
    for (const char* file : {kSummaryFile, kBladeReportFile, kTableFile, kPlotFile}) {
        own.remove(file);
    }
    const std::vector<BladeRun> runs = runAll();
    nlohmann::ordered_json summary;
    for (const BladeRun& run : runs) {
        summary["runs"].push_back(toJson(run));
    }
    own.write(kTableFile, tableOf(runs));
    writePicture(plotOf(runs), own.pathOf(kPlotFile));
    const std::string report = formatBladeReport(runs);
    own.write(kBladeReportFile, report);
    own.write(kSummaryFile, summary.dump(2) + "\n");
    out << (json ? summary.dump() + "\n" : report);
    if (const std::string missing = missingSentence(runs); !missing.empty()) {
        errors << missing << "\n";
        return kExitCheckFailed;
    }
    return kExitDone;
}

}  // namespace kerf::app
