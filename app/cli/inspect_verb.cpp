#include <spdlog/fmt/fmt.h>

#include <CLI/CLI.hpp>
#include <iomanip>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/cli/option_checks.h"
#include "app/cli/program.h"
#include "app/cli/verb.h"
#include "app/files/export/export.h"
#include "app/files/import/builtin_models.h"
#include "app/files/import/import_answer.h"
#include "app/files/import/model_faults.h"
#include "app/files/import/model_source.h"
#include "app/files/import/model_units.h"
#include "app/files/io/errors.h"
#include "app/files/io/file_io.h"
#include "app/scene/document/editor_document.h"
#include "app/scene/document/faulty_scene.h"
#include "app/scene/document/triangle_text.h"
#include "app/session/material.h"
#include "app/session/real_time_factor.h"
#include "gpu/context.h"
#include "render/renderer.h"
#include "render/scene/image.h"
#include "sim/base/size_params.h"
#include "sim/base/text.h"
#include "sim/contact/impact_zones.h"
#include "sim/mesh/invariants.h"
#include "sim/mesh/piece_figures.h"
#include "sim/mesh/triangle_quality.h"
#include "ui/state/legends.h"
#include "ui/state/piece_row.h"

namespace kerf::app {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kMargin = 12;  // around the legend of a picture [px]
constexpr int kIndent = 11;  // of what is told of a model, beside its name

/// The arguments of `kerf inspect`, parsed.
struct InspectArguments {
    std::filesystem::path model;  ///< a file, or the name of a builtin model
    bool json = false;
    bool pieces = false;            ///< a table of the pieces as CSV instead
    std::filesystem::path mended;   ///< where a mended model is written; empty for nowhere
    Mending mending;                ///< what is done for it beside a repair, for a file
    bool tryRepair = false;         ///< finds out what would help
    std::filesystem::path picture;  ///< where a picture with its faults goes; empty for nowhere
    PictureSize pictureSize;
};

std::string helpOf(const ModelHelp& help, bool tried) {
    if (!tried) {
        return ". A repair may help: kerf inspect MODEL --try-repair tells.";
    }
    std::string text =
        help.repairs.empty() ? "" : ". Or have it repaired: kerf inspect MODEL --repair OUT.ply";
    text +=
        help.thickness > 0 ? ". Or give it a thickness: kerf inspect MODEL --thicken OUT.ply" : "";
    return text + (text.empty() ? "" : ".");
}

/// A report, and the sentence why the model is refused (empty where it is not).
struct Inspection {
    MeshReport report;
    FileFacts facts;
    std::string refusal;
    ModelHelp help;  ///< what `--repair` and `--thicken` would do about it, if that was tried
    bool triedRepair = false;
    std::shared_ptr<const FoundFaults> found;  ///< what is wrong where, as far as that was asked
    std::string mended;                        ///< the file that is to be written, if any
    TriangleFigures triangles;                 ///< none of a model that is refused
    std::vector<double> volumes;               ///< of the largest pieces; none of such a model
    Json looks;                                ///< see looksJson()
    std::vector<std::string> remarks;          ///< what was left out, and what else is to be known
    ThinWalls thinWalls;                       ///< of a model that can be cut [m]
    std::optional<RealTimeForecast> speed;     ///< of such a model
    std::string noSpeed;                       ///< why there is none
    bool wantsRepair() const { return !report.cuttable || report.crossingTriangles > 0; }
    bool isCoarse() const { return kerf::isCoarse(triangles, report.bounds.diagonal()); }
    double proposedEdge() const { return kerf::proposedEdge(triangles, report.bounds.diagonal()); }
};

/// What a model has besides its shape, as `--json` tells it. Pictures that are not decoded have no
/// size.
Json looksJson(const render::Appearance* appearance, const SkinAttributes& skin) {
    Json looks = {{"materials", Json::array()},
                  {"images", Json::array()},
                  {"texture_coordinates", !skin.uvs.empty()},
                  {"vertex_colors", !skin.colors.empty()}};
    if (appearance != nullptr) {
        for (const render::SurfaceMaterial& material : appearance->materials) {
            looks["materials"].push_back({{"name", material.name}});
        }
        for (const auto& [name, bytes, pixels] : appearance->images) {
            looks["images"].push_back({{"name", name}});
            if (!pixels.pixels.empty()) {
                looks["images"].back().update({{"width", pixels.width}, {"height", pixels.height}});
            }
        }
    }
    return looks;
}

/// Of the largest pieces, falling.
std::vector<double> largestVolumes(const SurfaceMesh& mesh) {
    constexpr std::size_t kMost = 5;
    std::vector<double> volumes;
    std::ranges::transform(findPieces(mesh).pieces, std::back_inserter(volumes), &Piece::volume);
    std::ranges::sort(volumes, std::greater{});
    volumes.resize(std::min(volumes.size(), kMost));
    return volumes;
}

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

/// In the editor, with the settings of a new session.
MemoryNeed memoryNeedOf(const MeshReport& report) {
    MemorySettings settings = memorySettings(Params{}, false);
    settings.undoBudget = kUndoBudget;
    settings.checkpointBudget = kCheckpointBudget;
    return memoryNeedOf(
        BodySize{static_cast<double>(report.vertices), static_cast<double>(report.triangles)},
        settings);
}

/// Of a model as the editor opens it.
RealTimeForecast forecastOf(const SurfaceMesh& mesh) {
    Params params = ofNewScene({});
    applyMaterial(params, findMaterial(kMaterialOfNewModel, {}));
    params = suitedTo(meshBounds(mesh).diagonal(), params);
    const gpu::EglContext context;
    return realTimeForecast(mesh, params);
}

/// Nothing else of an inspection needs OpenGL, nor so much memory.
void forecast(const std::filesystem::path& file, SurfaceMesh mesh, Inspection& inspection) {
    try {
        requireMemory(shownPath(file), memoryNeedOf(inspection.report), memoryMeans());
        const UnitGuess guess = guessUnits(file, meshBounds(mesh), inspection.facts.units);
        place(mesh, standing(guess, mesh.restPositions()));
        inspection.thinWalls = thinWalls(buildBodyModel(mesh));
        inspection.speed = forecastOf(mesh);
    } catch (...) {
        inspection.noSpeed = complaintAboutThrown().sentence;
    }
}

/// Fills in what a model tells that can be cut.
void describe(const std::filesystem::path& file, const ModelMesh& model,
              const InspectArguments& arguments, Inspection& inspection) {
    inspection.found = arguments.picture.empty() ? nullptr : faultsOf(model.mesh);
    inspection.triangles = figuresOf(soupOf(model.mesh));
    inspection.volumes = largestVolumes(model.mesh);
    inspection.looks = looksJson(model.looks.appearance.get(), model.looks.skin);
    inspection.remarks = model.remarks;
    forecast(file, model.mesh, inspection);
}

std::filesystem::path modelFile(const std::filesystem::path& model) {
    const bool builtin = std::ranges::count(builtinModels(), model.string()) > 0;
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
    ReadOptions options{{arguments.mending}};
    options.repair = options.toFile = true;
    options.findCrossingsUpTo = std::numeric_limits<std::size_t>::max();
    Inspection inspection;
    options.report = &inspection.report;
    const ModelMesh mended = readModel(file, options);
    ExportLooks looks;
    looks.own = mended.looks;
    inspection.facts = mended.facts;
    inspection.mended = encodeMesh(mended.mesh, findPieces(mended.mesh), *format, looks);
    describe(file, mended, arguments, inspection);
    return inspection;
}

/// A file that can't be read at all has no report and throws.
Inspection inspect(const std::filesystem::path& file, const InspectArguments& arguments) {
    ImportOrder order;
    order.findCrossingsUpTo = std::numeric_limits<std::size_t>::max();
    order.tryRepair = arguments.tryRepair;
    order.findFaults = !arguments.picture.empty();
    ImportAnswer answer = importModel(file, order);
    Inspection inspection;
    inspection.report = answer.report;
    inspection.facts = answer.model.facts;
    inspection.help = answer.help;
    inspection.triedRepair = order.tryRepair;
    inspection.looks = looksJson(&answer.model.appearance, answer.model.soup.skin);
    inspection.remarks = answer.model.remarks;
    try {
        describe(file, cuttableModel(file, std::move(answer)), arguments, inspection);
    } catch (const ModelFault& fault) {
        inspection.refusal = fault.what();
        inspection.found = fault.found();
    }
    return inspection;
}

Json toJson(const Vec3& v) {
    return Json::array({v.x(), v.y(), v.z()});
}

/// Along each of the axes of its file [m].
Vec3 sizeOf(const Bounds& own, const UnitGuess& guess) {
    return (own.high - own.low) * infoOf(guess.unit).metres;
}

Json toJson(const UnitGuess& guess) {
    return {{"unit", std::string(nameOf(guess.unit))},
            {"up", std::string(nameOf(guess.up))},
            {"certain", guess.certain},
            {"sentence", guess.sentence}};
}

Json memoryJson(const MeshReport& report) {
    const MemoryNeed need = memoryNeedOf(report);
    return {{"needed", need.memory + need.program},
            {"graphics", need.graphics},
            {"largest_buffer", need.largestBuffer},
            {"free", freeMemory()}};
}

/// Without numbers where there are none.
Json toJson(const ThinWalls& walls) {
    const bool any = walls.share > 0;
    return {{"share", walls.share},
            {"thickness", any ? Json(walls.thickness) : Json()},
            {"edge", any ? Json(walls.edge) : Json()}};
}

/// Without numbers where there is no forecast.
Json speedJson(const Inspection& inspection) {
    const auto number = [&](auto RealTimeForecast::*member) {
        return inspection.speed ? Json((*inspection.speed).*member) : Json();
    };
    return {{"real_time_factor", number(&RealTimeForecast::factor)},
            {"time_step", number(&RealTimeForecast::timeStep)},
            {"iterations", number(&RealTimeForecast::iterations)},
            {"implicit_steps", number(&RealTimeForecast::implicitSteps)},
            {"problem", inspection.noSpeed}};
}

Json toJson(const Inspection& inspection, const std::filesystem::path& file) {
    const MeshReport& report = inspection.report;
    const UnitGuess guess = guessUnits(file, report.bounds, inspection.facts.units);
    const double thickness = inspection.help.thickness;
    const bool known = inspection.triedRepair || !inspection.wantsRepair();
    return {{"file", file.string()},
            {"format", lowerCase(file.extension().string()).substr(1)},
            {"vertices", report.vertices},
            {"triangles", report.triangles},
            {"bounds", {{"low", toJson(report.bounds.low)}, {"high", toJson(report.bounds.high)}}},
            {"objects", inspection.facts.objects},
            {"size", toJson(sizeOf(report.bounds, guess))},
            {"guess", toJson(guess)},
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
            {"thin_walls", toJson(inspection.thinWalls)},
            {"speed", speedJson(inspection)},
            {"repairs", report.repairs},
            {"left", report.left},
            {"cuttable", report.cuttable},
            {"problem", report.problem},
            {"largest_pieces", inspection.volumes},
            {"looks", inspection.looks},
            {"remarks", inspection.remarks},
            {"repairable", known ? Json(!inspection.help.repairs.empty()) : Json()},
            {"thickenable", known ? Json(thickness > 0) : Json()},
            {"proposed_thickness", thickness > 0 ? Json(thickness) : Json()},
            {"proposed_edge", inspection.isCoarse() ? Json(inspection.proposedEdge()) : Json()}};
}

std::string lengths(const Vec3& v) {
    return joined(v, " ", [](double x) { return formatNumber(static_cast<float>(x)); });
}

/// Each line in at most 100 columns; what is left of one stands below its text.
std::string wrapped(const std::string& lines) {
    constexpr std::size_t kWidth = 100;
    std::string text;
    std::istringstream stream(lines);
    for (std::string line; std::getline(stream, line); text.append(line).append("\n")) {
        const auto blank = [&line] { return line.substr(0, kWidth + 1).find_last_of(' ') + 1; };
        for (std::size_t end = 0; line.size() > kWidth && (end = blank()) > kIndent + 1;) {
            text.append(line, 0, end - 1).append("\n");
            line.replace(0, end, kIndent, ' ');
        }
    }
    return text;
}

/// "2: tile.png (16 x 16), wood.jpg (512 x 512)"; of many the first ones.
std::string listed(const Json& items) {
    constexpr std::size_t kMost = 6;
    std::string text = std::to_string(items.size());
    for (std::size_t i = 0; i < std::min(items.size(), kMost); ++i) {
        const int width = items[i].value("width", 0);
        text += (i == 0 ? ": " : ", ") + items[i]["name"].get<std::string>();
        text += width == 0 ? "" : fmt::format(" ({} x {})", width, items[i].value("height", 0));
    }
    return text + (items.size() > kMost ? ", ..." : "");
}

/// A line of what is told of a model, "skin       with texture coordinates", begins with a name.
std::ostream& labelled(std::ostream& text, const char* name) {
    return text << std::left << std::setw(kIndent) << name;
}

void printSurface(const Inspection& inspection, std::ostream& text) {
    const MeshReport& report = inspection.report;
    const auto is = [](bool yes) { return yes ? "" : "not "; };
    labelled(text, "vertices") << report.vertices << "\n";
    labelled(text, "triangles") << report.triangles << "\n";
    labelled(text, "surface") << is(report.closed) << "closed, " << is(report.manifold)
                              << "manifold, " << is(report.oriented) << "oriented\n";
    if (inspection.facts.objects.size() > 1) {
        labelled(text, "objects") << inspection.facts.objects.size() << "\n";
    }
    labelled(text, "pieces") << report.pieces << "\n";
    if (report.cavities > 0) {
        labelled(text, "cavities") << report.cavities << "\n";
    }
    if (report.crossingTriangles > 0) {
        labelled(text, "crossing")
            << counted(report.crossingTriangles, "triangle", "triangles") << "\n";
    }
}

/// What could be done about it.
void printHelp(const Inspection& inspection, std::ostream& text) {
    if (inspection.isCoarse()) {
        labelled(text, "remark") << fmt::format(
            "{}; --remesh OUT.ply --edge {:.2g} makes it bend and cut well.\n",
            coarseText(inspection.triangles,
                       fmt::format("{:.3g}", inspection.triangles.longestEdge)),
            inspection.proposedEdge());
    }
    if (!inspection.help.repairs.empty()) {
        labelled(text, "--repair")
            << "would help: " << joined(inspection.help.repairs, "; ") << "\n";
    }
    if (inspection.help.thickness > 0) {
        labelled(text, "--thicken")
            << "would help, with --thickness " << inspection.help.thickness << "\n";
    }
}

void printForPeople(const Inspection& inspection, const std::filesystem::path& file,
                    std::ostream& out) {
    const MeshReport& report = inspection.report;
    const Json& looks = inspection.looks;
    const UnitGuess guess = guessUnits(file, report.bounds, inspection.facts.units);
    std::ostringstream text;
    const auto lines = [&text](const char* name, const std::vector<std::string>& texts) {
        for (const std::string& each : texts) labelled(text, name) << each << "\n";
    };
    labelled(text, "size") << joined(sizeOf(report.bounds, guess), " x ", lengthText)
                           << (guess.certain ? "" : ", as guessed") << "\n";
    labelled(text, "unit") << guess.sentence << "\n";
    labelled(text, "bounds") << lengths(report.bounds.low) << " to " << lengths(report.bounds.high)
                             << "\n";
    printSurface(inspection, text);
    labelled(text, "volume") << formatNumber(static_cast<float>(report.volume)) << " "
                             << nameOf(guess.unit) << "\u00b3";
    if (inspection.volumes.size() > 1) {
        text << fmt::format("; the largest pieces: {:.3g}", fmt::join(inspection.volumes, ", "));
    }
    text << "\n";
    for (const char* name : {"materials", "images"}) {
        if (!looks[name].empty()) labelled(text, name) << listed(looks[name]) << "\n";
    }
    labelled(text, "skin") << (looks["texture_coordinates"] ? "with" : "no")
                           << " texture coordinates, " << (looks["vertex_colors"] ? "with" : "no")
                           << " colours of vertices\n";
    lines("repaired", report.repairs);
    lines("left", report.left);
    lines("remark", inspection.remarks);
    labelled(text, "memory") << describeMemory(memoryNeedOf(report), freeMemory()) << "\n";
    if (const ThinWalls& walls = inspection.thinWalls; walls.many()) {
        labelled(text, "walls") << fmt::format(
            "at {:.0f} % of the vertices thinner than the longest edge there (in the median {} and "
            "{}). Contact alone can't hold their sides apart, so regions about to intersect stop "
            "together, in slower steps. Smaller triangles (--remesh) or thicker walls move better."
            "\n",
            100 * walls.share, lengthText(walls.thickness), lengthText(walls.edge));
    }
    if (const auto& speed = inspection.speed) {
        labelled(text, "speed") << fmt::format(
            "about {} real time here (time step {:.3g} ms, {}{} iterations)\n",
            factorText(speed->factor), 1000 * speed->timeStep,
            speed->implicitSteps > 1 ? fmt::format("{} implicit steps, ", speed->implicitSteps)
                                     : "",
            speed->iterations);
    }
    labelled(text, "cuttable") << (inspection.refusal.empty() ? "yes" : "no") << "\n";
    printHelp(inspection, text);
    labelled(out, "file") << file.string() << "\n" << wrapped(text.str());
}

/// What is wrong with a model, under a legend headed by `title`. `file` tells what its numbers
/// mean.
render::Image faultPicture(const FoundFaults& found, const std::filesystem::path& file,
                           const std::string& title, const PictureSize& size) {
    const FaultyScene scene(found, file);
    render::Renderer renderer(render::Quality::full);
    renderer.draw(scene.view(), scene.camera(), size.width, size.height);
    render::Image picture = renderer.readPicture();
    render::paste(picture, ui::drawFaultLegend(title, ui::faultRows(scene.marks())), kMargin,
                  kMargin);
    return picture;
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
        rows.push_back({.triangles = piece.triangles,
                        .volume = piece.volume,
                        .share = 1,
                        .shareOfAll = all > 0 ? piece.volume / all : 0,
                        .bounds = piece.bounds,
                        .sums = ui::PieceSums{piece.skinArea, piece.cutArea, piece.centroid}});
    }
    return rows;
}

/// Of a model that is refused the report is printed, and then the refusal thrown.
int runInspect(const InspectArguments& arguments, std::ostream& out) {
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
        out << toJson(inspection, file).dump(-1, ' ', false, Json::error_handler_t::replace)
            << "\n";
    } else {
        printForPeople(inspection, file, out);
    }
    if (!inspection.refusal.empty()) {
        throw InputError(inspection.refusal + helpOf(inspection.help, inspection.triedRepair));
    }
    return kExitDone;
}

std::string refuseNoPng(const std::string& text) {
    const bool isPng = lowerCase(std::filesystem::path(text).extension().string()) == ".png";
    return isPng ? "" : "'" + text + "' must end in .png";
}

/// The ways to write the model mended.
struct MendOptions {
    CLI::Option* remesh;
    CLI::Option* thicken;
};

MendOptions describeMends(CLI::App& verb, InspectArguments& arguments, CLI::Option* pieces) {
    Mending& mending = arguments.mending;
    const auto mends = [&](const char* name, const char* meaning, const auto& ask) {
        return verb.add_option(name, arguments.mended, meaning)
            ->type_name("OUT.ply")
            ->check(refuseEmpty)
            ->excludes(pieces)
            ->each([ask](const std::string&) { ask(); });
    };
    CLI::Option* const repair =
        mends("--repair", "Write the repaired model here, and report that one", [] {});
    CLI::Option* const remesh =
        mends("--remesh", "Write the model here, repaired and with even triangles", [&mending] {
            mending.remesh = true;
        })->excludes(repair);
    CLI::Option* const thicken =
        mends("--thicken", "Write the model here, repaired, its open sheets given a thickness",
              [&mending] { mending.thicken = mending.thicken.value_or(0); })
            ->excludes(repair)
            ->excludes(remesh);
    return {remesh, thicken};
}

void describePicture(CLI::App& verb, InspectArguments& arguments, CLI::Option* pieces) {
    CLI::Option* const picture =
        verb.add_option("--picture", arguments.picture,
                        "Write a picture (.png) of it here, with its faults as coloured lines")
            ->type_name("FILE.png")
            ->check(refuseNoPng)
            ->excludes(pieces);
    addPictureSize(
        verb, [&arguments](const PictureSize& size) { arguments.pictureSize = size; },
        "Size of that picture in pixels (1280x720)")
        ->needs(picture);
}

void describeLengths(CLI::App& verb, Mending& mending, const MendOptions& mends) {
    verb.add_option("--edge", mending.edge,
                    "Length of their edges in the model's unit; by default that of even triangles "
                    "with the same areas, at most a 25th of the diagonal of a coarse model")
        ->type_name("LENGTH")
        ->check(refuseNoLength)
        ->needs(mends.remesh);
    verb.add_option(
            "--thickness", mending.thicken,
            "That thickness in the model's unit; by default a 50th of its diagonal, or less "
            "where the sheet is bent or close to itself")
        ->type_name("LENGTH")
        ->check(refuseNoLength)
        ->needs(mends.thicken);
}

std::function<int()> describeInspect(CLI::App& verb) {
    const auto arguments = std::make_shared<InspectArguments>();
    verb.add_option("MODEL", arguments->model, "A model file, or the name of a builtin one")
        ->required()
        ->check(refuseEmpty);
    CLI::Option* const json = verb.add_flag("--json", arguments->json, "Print one JSON object");
    verb.add_flag("--try-repair", arguments->tryRepair,
                  "Find out what --repair and --thicken would do, which may take minutes");
    CLI::Option* const pieces =
        verb.add_flag("--pieces", arguments->pieces,
                      "Print a table of the pieces as CSV: volume, areas, centre, box")
            ->excludes(json);
    const MendOptions mends = describeMends(verb, *arguments, pieces);
    describePicture(verb, *arguments, pieces);
    describeLengths(verb, arguments->mending, mends);
    return [arguments] { return runInspect(*arguments, std::cout); };
}

}  // namespace

const Verb kInspectVerb{"inspect", "Describe a model and whether it can be cut", describeInspect};

}  // namespace kerf::app
