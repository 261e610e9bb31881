#include "app/cli/inspect_verb.h"

#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <iomanip>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>
#include <utility>
#include <vector>

#include "app/cli/fault_picture.h"
#include "app/cli/usage_error.h"
#include "app/files/builtin_models.h"
#include "app/files/exit_codes.h"
#include "app/files/export.h"
#include "app/files/file_io.h"
#include "app/files/model_source.h"
#include "app/files/model_units.h"
#include "app/files/shell_union.h"
#include "app/scene/editor_document.h"
#include "app/scene/keyframes.h"
#include "app/scene/triangle_text.h"
#include "gpu/context.h"
#include "sim/base/text.h"
#include "sim/mesh/invariants.h"
#include "sim/mesh/piece_figures.h"
#include "sim/mesh/triangle_quality.h"
#include "ui/piece_row.h"

namespace kerf::app {

namespace {

using Json = nlohmann::ordered_json;

std::string helpOf(const ModelHelp& help) {
    std::string text =
        help.repairs.empty() ? "" : ". Or have it repaired: kerf inspect MODEL --repair OUT.ply";
    text +=
        help.thickness > 0 ? ". Or give it a thickness: kerf inspect MODEL --thicken OUT.ply" : "";
    return text + (text.empty() ? "" : ".");
}

/// A report, and the sentence why the model is refused (empty where it is not).
struct Inspection {
    MeshReport report;
    std::string refusal;
    ModelHelp help;  ///< what `--repair` and `--thicken` would do about it
    std::shared_ptr<const FoundFaults> found;  ///< what is wrong where, as far as that was asked
    std::string mended;                        ///< the file that is to be written, if any
    TriangleFigures triangles;                 ///< none of a model that is refused
    bool isCoarse() const { return kerf::isCoarse(triangles, report.bounds.diagonal()); }
    double proposedEdge() const { return kerf::proposedEdge(triangles, report.bounds.diagonal()); }
};

TriangleSoup soupOf(const SurfaceMesh& mesh) {
    TriangleSoup soup;
    soup.positions.assign(mesh.restPositions().begin(), mesh.restPositions().end());
    for (int t = 0; t < mesh.triangleSlots(); ++t) {
        soup.triangles.push_back(mesh.triangle(t));
    }
    return soup;
}

std::shared_ptr<const FoundFaults> faultsOf(const SurfaceMesh& mesh) {
    TriangleSoup soup = soupOf(mesh);
    repair::Faults faults = repair::findFaults(soup);
    return std::make_shared<const FoundFaults>(FoundFaults{std::move(soup), std::move(faults)});
}

std::filesystem::path modelFile(const std::filesystem::path& model) {
    const auto& names = builtinModels();
    const bool builtin = std::find(names.begin(), names.end(), model.string()) != names.end();
    return builtin && !std::filesystem::exists(model) ? builtinModelFile(model.string()) : model;
}

void requireNewFile(const std::filesystem::path& file, const std::filesystem::path& out) {
    std::error_code error;
    if (std::filesystem::equivalent(file, out, error)) {
        throw UsageError(shownPath(out) +
                         ": this is the model itself, which stays as it is; choose another name");
    }
}

/// The model as a repair leaves it. What can't be repaired throws.
Inspection mend(const std::filesystem::path& file, const InspectArguments& arguments) {
    const std::filesystem::path& out = arguments.mended;
    const std::optional<MeshFormat> format = meshFormatOf(out);
    if (!format) {
        throw UsageError(out.string() +
                         ": the name of a mesh file must end in .ply, .obj, .stl, "
                         ".glb, .gltf or .vtp");
    }
    requireNewFile(file, out);
    const MendedModel mended = mendModel(file, arguments.mending);
    for (const std::string& remark : mended.model.remarks) {
        spdlog::warn("{}: {}", file.string(), remark);
    }
    const SurfaceMesh& mesh = mended.model.mesh;
    ExportLooks looks;
    looks.own = mended.model.looks;
    return {mended.report,
            "",
            {},
            arguments.picture.empty() ? nullptr : faultsOf(mesh),
            encodeMesh(mesh, findPieces(mesh), *format, looks),
            figuresOf(soupOf(mesh))};
}

/// A file that can't be read at all has no report and throws.
Inspection inspect(const std::filesystem::path& file, const InspectArguments& arguments) {
    Inspection inspection;
    try {
        ReadOptions options;
        options.report = &inspection.report;
        options.findCrossingsUpTo = std::numeric_limits<std::size_t>::max();
        options.tryRepair = true;
        options.findFaults = !arguments.picture.empty();
        const ModelMesh model = readModel(file, options);
        for (const std::string& remark : model.remarks) {
            spdlog::warn("{}: {}", file.string(), remark);
        }
        inspection.triangles = figuresOf(soupOf(model.mesh));
        inspection.found = options.findFaults ? faultsOf(model.mesh) : nullptr;
        if (inspection.report.crossingTriangles > 0) {
            inspection.help.repairs = unionsToMake(soupOf(model.mesh));
        }
    } catch (const ModelFault& fault) {
        inspection.refusal = fault.what();
        inspection.help = fault.help();
        inspection.found = fault.found();
    } catch (const InputError& error) {
        if (inspection.report.triangles == 0) {
            throw;
        }
        inspection.refusal = error.what();
    }
    return inspection;
}

Json toJson(const Vec3& v) {
    return Json::array({v.x(), v.y(), v.z()});
}

Json toJson(const UnitGuess& guess) {
    return {{"unit", std::string(nameOf(guess.unit))},
            {"up", std::string(nameOf(guess.up))},
            {"certain", guess.certain},
            {"sentence", guess.sentence}};
}

/// In the editor, with the settings of a new session.
MemoryNeed memoryNeedOf(const MeshReport& report) {
    MemorySettings settings = memorySettings(Params{}, false);
    settings.undoBudget = kUndoBudget;
    settings.courseBudget = Keyframes::kBudget;
    return memoryNeedOf(
        BodySize{static_cast<double>(report.vertices), static_cast<double>(report.triangles)},
        settings);
}

Json memoryJson(const MeshReport& report) {
    const MemoryNeed need = memoryNeedOf(report);
    return {{"needed", need.memory + need.program},
            {"graphics", need.graphics},
            {"largest_buffer", need.largestBuffer},
            {"free", freeMemory()}};
}

Json toJson(const MeshReport& report, const std::filesystem::path& file) {
    return {{"file", file.string()},
            {"vertices", report.vertices},
            {"triangles", report.triangles},
            {"bounds", {{"low", toJson(report.bounds.low)}, {"high", toJson(report.bounds.high)}}},
            {"guess", toJson(guessUnits(file, report.bounds))},
            {"closed", report.closed},
            {"manifold", report.manifold},
            {"oriented", report.oriented},
            {"pieces", report.pieces},
            {"volume", report.volume},
            {"open_edges", report.openEdges},
            {"non_manifold_edges", report.nonManifoldEdges},
            {"misoriented_edges", report.misorientedEdges},
            {"non_manifold_vertices", report.nonManifoldVertices},
            {"degenerate_triangles", report.degenerateTriangles},
            {"non_finite_vertices", report.nonFiniteVertices},
            {"out_of_range_indices", report.outOfRangeIndices},
            {"cavities", report.cavities},
            {"crossing_triangles", report.crossingTriangles},
            {"memory_bytes", memoryJson(report)},
            {"repairs", report.repairs},
            {"left", report.left},
            {"cuttable", report.cuttable},
            {"problem", report.problem}};
}

std::string lengths(const Vec3& v) {
    return formatNumber(static_cast<float>(v.x())) + " " + formatNumber(static_cast<float>(v.y())) +
           " " + formatNumber(static_cast<float>(v.z()));
}

const char* yesNo(bool value) {
    return value ? "yes" : "no";
}

void printForPeople(const Inspection& inspection, const std::filesystem::path& file,
                    std::ostream& out) {
    const MeshReport& report = inspection.report;
    const auto line = [&out](const char* name) -> std::ostream& {
        return out << std::left << std::setw(11) << name;
    };
    line("file") << file.string() << "\n";
    line("vertices") << report.vertices << "\n";
    line("triangles") << report.triangles << "\n";
    line("bounds") << lengths(report.bounds.low) << " to " << lengths(report.bounds.high) << "\n";
    line("guess") << guessUnits(file, report.bounds).sentence << "\n";
    line("pieces") << report.pieces << "\n";
    if (report.cavities > 0) {
        line("cavities") << report.cavities << "\n";
    }
    if (report.crossingTriangles > 0) {
        line("crossing") << counted(report.crossingTriangles, "triangle", "triangles") << "\n";
    }
    line("volume") << formatNumber(static_cast<float>(report.volume)) << "\n";
    line("closed") << yesNo(report.closed) << "\n";
    line("manifold") << yesNo(report.manifold) << "\n";
    line("oriented") << yesNo(report.oriented) << "\n";
    for (const std::string& repair : report.repairs) {
        line("repaired") << repair << "\n";
    }
    for (const std::string& left : report.left) {
        line("left") << left << "\n";
    }
    line("memory") << describeMemory(memoryNeedOf(report), freeMemory()) << "\n";
    line("cuttable") << yesNo(inspection.refusal.empty()) << "\n";
    if (inspection.isCoarse()) {
        line("remark") << fmt::format(
            "{}; --remesh OUT.ply --edge {:.2g} makes it bend and cut well.\n",
            coarseText(inspection.triangles,
                       fmt::format("{:.3g}", inspection.triangles.longestEdge)),
            inspection.proposedEdge());
    }
    if (!inspection.help.repairs.empty()) {
        line("--repair") << "would help: " << joined(inspection.help.repairs, "; ") << "\n";
    }
    if (inspection.help.thickness > 0) {
        line("--thicken") << "would help, with --thickness " << inspection.help.thickness << "\n";
    }
}

void writeFaultPicture(const Inspection& inspection, const std::filesystem::path& file,
                       const InspectArguments& arguments) {
    if (inspection.found == nullptr) {
        throw InputError(inspection.refusal);
    }
    const bool cuttable = inspection.refusal.empty();
    const bool sound = cuttable && !inspection.found->faults.any();
    std::string title = file.filename().string();
    title += sound ? ": no faults" : cuttable ? ": can be cut" : ": can't be cut as it is";
    gpu::EglContext context;
    gpu::enableDebugOutput();
    writePicture(faultPicture(*inspection.found, file, title, arguments.pictureSize),
                 arguments.picture);
}

/// The lowest triangle of each piece, in the order of findPieces().
std::vector<int> firstTriangles(const SurfaceMesh& mesh, const PieceMap& pieces) {
    std::vector<int> first(pieces.pieces.size(), -1);
    for (const int t : livingTriangles(mesh)) {
        int& of = first[pieces.ofVertex[mesh.triangle(t)[0]]];
        of = of < 0 ? t : of;
    }
    return first;
}

/// The pieces of a model at rest.
std::vector<ui::PieceRow> pieceRows(const SurfaceMesh& mesh) {
    const double all = meshVolume(mesh);
    std::vector<ui::PieceRow> rows;
    const PieceShells shells(mesh);
    for (const int triangle : firstTriangles(mesh, findPieces(mesh))) {
        const PieceFigures piece = figuresOfPiece(mesh, shells, triangle);
        ui::PieceRow row;
        row.triangles = piece.triangles;
        row.volume = piece.volume;
        row.share = 1;
        row.shareOfAll = all > 0 ? piece.volume / all : 0;
        row.bounds = piece.bounds;
        row.sums = ui::PieceSums{piece.skinArea, piece.cutArea, piece.centroid};
        rows.push_back(row);
    }
    return rows;
}

}  // namespace

int inspectVerb(const InspectArguments& arguments, std::ostream& out) {
    const std::filesystem::path file = modelFile(arguments.model);
    if (arguments.pieces) {
        out << ui::piecesAsCsv(pieceRows(loadModel(file)));
        return kExitDone;
    }
    const bool mends = !arguments.mended.empty();
    const Inspection inspection = mends ? mend(file, arguments) : inspect(file, arguments);
    if (!arguments.picture.empty()) {
        writeFaultPicture(inspection, file, arguments);
    }
    if (mends) {
        writeOutputFile(arguments.mended, inspection.mended);
    }
    if (arguments.json) {
        Json json = toJson(inspection.report, file);
        const double thickness = inspection.help.thickness;
        json["repairable"] = !inspection.help.repairs.empty();
        json["thickenable"] = thickness > 0;
        json["proposed_thickness"] = thickness > 0 ? Json(thickness) : Json();
        json["proposed_edge"] = inspection.isCoarse() ? Json(inspection.proposedEdge()) : Json();
        out << json.dump(-1, ' ', false, Json::error_handler_t::replace) << "\n";
    } else {
        printForPeople(inspection, file, out);
    }
    if (!inspection.refusal.empty()) {
        throw InputError(inspection.refusal + helpOf(inspection.help));
    }
    return kExitDone;
}

}  // namespace kerf::app
