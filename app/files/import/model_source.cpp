#include "app/files/import/model_source.h"

#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>

#include <csignal>

#include "app/files/import/import_process.h"
#include "app/files/import/import_protocol.h"
#include "app/files/import/shell_union.h"
#include "app/files/io/file_io.h"
#include "app/files/jobs/child_process.h"
#include "sim/base/text.h"
#include "sim/mesh/triangle_quality.h"
#include "sim/repair/crossings.h"
#include "sim/repair/hole_filling.h"
#include "sim/repair/remesher.h"
#include "sim/repair/soup_editing.h"
#include "sim/repair/soup_repair.h"
#include "sim/repair/thickening.h"
#include "sim/repair/vertex_parting.h"

namespace kerf::app {

namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kGigabyte = 1'000'000'000;
static_assert(kMaxModelBytes == kGigabyte, "the sentence below names the limit");

struct Format {
    const char* extension;
    const char* name;
};

/// Formats whose reader held up best against damaged files.
const std::vector<Format>& formats() {
    static const std::vector<Format> list = {
        {".obj", "OBJ"}, {".ply", "PLY"}, {".stl", "STL"}, {".gltf", "glTF"}, {".glb", "GLB"},
        {".off", "OFF"}, {".3ds", "3DS"}, {".dae", "DAE"}, {".fbx", "FBX"},   {".vtk", "VTK"},
        {".vtp", "VTP"}, {".vtu", "VTU"}, {".msh", "Gmsh"}};
    return list;
}

std::string joinedNames(const std::string& lastSeparator) {
    std::string text;
    for (std::size_t i = 0; i < formats().size(); ++i) {
        text += i == 0 ? "" : i + 1 == formats().size() ? lastSeparator : ", ";
        text += formats()[i].name;
    }
    return text;
}

const Format& formatOf(const fs::path& file) {
    const std::string extension = lowerCase(file.extension().string());
    const auto found =
        std::ranges::find_if(formats(), [&](const Format& f) { return extension == f.extension; });
    if (found == formats().end()) {
        throw InputError((extension.empty() ? "a file without extension" : extension + " files") +
                         (extension.empty() ? " is" : " are") +
                         " not read as a model; convert it to " + joinedNames(" or "));
    }
    return *found;
}

void checkFile(const fs::path& file) {
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    if (status.type() == fs::file_type::not_found) {
        throw InputError(file.native().find("://") == std::string::npos
                             ? "no such file; check the path"
                             : "this is an address, not a file; download it first");
    }
    if (status.type() == fs::file_type::directory) {
        throw InputError("this is a folder; name a model file in it");
    }
    if (status.type() != fs::file_type::regular) {
        throw InputError("this is not a regular file; name a model file");
    }
    const std::uintmax_t size = fs::file_size(file, error);
    if (error) {
        throw InputError("the file can't be read (" + error.message() + ")");
    }
    if (size == 0) {
        throw InputError("the file is empty; export the model again");
    }
    if (size > kMaxModelBytes) {
        throw InputError("the file has " + std::to_string(size / 1'000'000) +
                         " MB, but at most 1000 MB are read; decimate the model");
    }
}

/// Throws where the reader did not come to an end by itself.
void checkOutcome(const ImportOutcome& outcome, const std::string& format,
                  const ImportLimits& limits) {
    if (outcome.tooSlow) {
        const int limit = outcome.signal == SIGXCPU ? limits.cpuSeconds : limits.wallSeconds;
        throw InputError("reading it as " + format + " did not end within " +
                         std::to_string(limit) +
                         " s; the file may be cut off or damaged, export it again");
    }
    if (outcome.tooLong) {
        throw InputError("it has more than " + std::to_string(kMaxImportTriangles) +
                         " triangles; decimate the model");
    }
    if (outcome.exitCode != 0) {
        throw InputError("the " + format + " reader failed on it (" +
                         (outcome.signal != 0 ? std::string(sigabbrev_np(outcome.signal))
                                              : "exit " + std::to_string(outcome.exitCode)) +
                         "); the file may be damaged, export it again, for example as OBJ");
    }
}

/// Of a model of which no more is known than how many triangles it has, cut as sparingly as can be.
void requireMemoryFor(const fs::path& file, std::uint64_t triangles, const MemoryMeans& means) {
    const BodySize size = BodySize::ofTriangles(static_cast<double>(triangles));
    requireMemory(file.filename().string(), memoryNeedOf(size, {.contact = false}), means);
}

ImportedModel readThroughProcess(const fs::path& file, const ImportLimits& limits,
                                 const std::optional<MemoryMeans>& means, WorkProgress* progress) {
    enter(progress, "Reading the file");
    checkFile(file);
    const Format& format = formatOf(file);
    const auto onHead = [&](std::string_view head) {
        if (means) {
            requireMemoryFor(file, trianglesByHead(head), *means);
        }
    };
    const ImportOutcome outcome =
        runImportProcess(importProgram(), fs::absolute(file), limits, progress, onHead);
    if (!outcome.log.empty()) {
        spdlog::debug("{}: {}", file.string(), outcome.log);
    }
    checkOutcome(outcome, format.name, limits);
    enter(progress, "Joining equal vertices");
    return modelOfAnswer(outcome.answer);
}

void noteTurning(const MeshReport& found, std::vector<std::string>& repairs) {
    if (found.insideOutPieces > 0) {
        repairs.push_back("turned " +
                          counted(found.insideOutPieces, "inside-out piece", "inside-out pieces"));
    }
    if (found.outwardCavities > 0) {
        repairs.push_back("turned " + counted(found.outwardCavities, "shell", "shells") +
                          " inside another one inwards, around " +
                          (found.outwardCavities == 1 ? "a cavity" : "cavities"));
    }
}

/// Turns what is inside out.
MeshReport inspectAndTurn(TriangleSoup& soup, std::vector<std::string> repairs) {
    MeshReport found = inspectTriangles(soup);
    if (found.insideOutPieces > 0 || found.outwardCavities > 0) {
        noteTurning(found, repairs);
        turnOutward(soup);
        found = inspectTriangles(soup);
    }
    found.repairs = std::move(repairs);
    return found;
}

/// Makes one surface of pieces that cross.
MeshReport united(TriangleSoup& soup, MeshReport before, WorkProgress* progress) {
    ShellUnion became = uniteCrossingPieces(soup, progress);
    MeshReport found = inspectTriangles(soup);
    found.repairs = std::move(before.repairs);
    std::ranges::move(became.done, std::back_inserter(found.repairs));
    found.left = std::move(became.left);
    return found;
}

/// Gives sheets a thickness. Returns why not, or "".
std::string thickened(TriangleSoup& soup, double thickness, std::vector<std::string>& repairs) {
    repair::Thickening done = repair::thicken(soup, thickness);
    if (done.sheets > 0) {
        repairs.push_back(fmt::format("gave {} a thickness of {:g}",
                                      counted(done.sheets, "sheet", "sheets"), done.thickness));
    }
    return std::move(done.problem);
}

/// Does what is wanted but to remesh, and turns what is inside out.
MeshReport inspectAndRepair(TriangleSoup& soup, const ReadOptions& options) {
    std::vector<std::string> repairs;
    if (options.repair && !inspectTriangles(soup).cuttable) {
        repairs = repair::repairSoup(soup, !options.thicken);
    }
    if (options.thicken) {
        if (std::string problem = thickened(soup, *options.thicken, repairs); !problem.empty()) {
            MeshReport found = inspectTriangles(soup);
            found.repairs = std::move(repairs);
            found.problem = std::move(problem);
            return found;
        }
    }
    if (options.fillHoles && inspectTriangles(soup).openEdges > 0) {
        const HoleFilling filled = fillHoles(soup);
        repairs.push_back("filled " + counted(filled.holes, "hole", "holes") + " with " +
                          counted(filled.triangles, "triangle", "triangles"));
    }
    MeshReport found = inspectAndTurn(soup, std::move(repairs));
    if (options.repair && found.cuttable) {
        found = united(soup, std::move(found), options.progress);
        // What moves apart may cross then, and what is united may touch itself. What is sound
        // stays.
        const int rounds = found.repairs.empty() ? 0 : 4;
        for (int i = 0; i < rounds && repair::moveApart(soup) > 0; ++i) {
            found = united(soup, std::move(found), options.progress);
        }
    }
    return found;
}

/// See ModelHelp::holes.
int holesThatHelp(TriangleSoup soup, const MeshReport& report) {
    if (report.openEdges == 0) {
        return 0;
    }
    const int holes = fillHoles(soup).holes;
    return inspectAndTurn(soup, {}).cuttable ? holes : 0;
}

/// What a mending does, where it helps.
std::vector<std::string> repairsThatHelp(TriangleSoup soup, const Mending& mending,
                                         WorkProgress* progress) {
    ReadOptions options{mending};
    options.progress = progress;
    const MeshReport mended = inspectAndRepair(soup, options);
    roundToFloats(soup);
    const bool helps = mended.cuttable && inspectTriangles(soup).cuttable;
    return helps ? mended.repairs : std::vector<std::string>{};
}

/// Notes which thickness helps.
void tryThickening(TriangleSoup soup, WorkProgress* progress, ModelHelp& help) {
    const TriangleSoup before = soup;
    repair::repairSoup(soup, false);
    help.isSheet = repair::isSheet(soup);
    const double proposed = repair::thicken(soup, 0).thickness;
    const Mending mending{.repair = true, .thicken = proposed};
    const bool helps = proposed > 0 && !repairsThatHelp(before, mending, progress).empty();
    help.thickness = helps ? proposed : 0;
}

ModelFault faultOf(const fs::path& file, const TriangleSoup& soup, const MeshReport& found,
                   const ReadOptions& options) {
    ModelHelp help;
    help.holes = options.tryFilling ? holesThatHelp(soup, found) : 0;
    if (options.tryRepair && help.holes == 0) {
        help.repairs = repairsThatHelp(soup, {.repair = true}, options.progress);
    }
    if (options.tryRepair && soup.triangles.size() <= options.findCrossingsUpTo) {
        tryThickening(soup, options.progress, help);
    }
    return ModelFault(shownPath(file) + ": " + found.problem, std::move(help));
}

/// A picture that can't be shown is left out of the materials.
void decodeImages(ImportedModel& model) {
    std::size_t pixels = 0;
    for (std::size_t i = 0; i < model.appearance.images.size(); ++i) {
        render::ModelImage& image = model.appearance.images[i];
        try {
            const render::PixelRect size = render::sizeOfImage(image.bytes);
            pixels += std::size_t(size.width) * std::size_t(size.height);
            if (pixels > render::kMaxTexturePixels) {
                throw std::runtime_error("all images together have more pixels than are read");
            }
            image.pixels = render::decodeImage(image.bytes);
        } catch (const std::runtime_error& error) {
            model.remarks.push_back("The image \"" + image.name +
                                    "\" was left out: " + error.what() +
                                    "; save it anew as PNG and open the model again.");
            for (render::SurfaceMaterial& material : model.appearance.materials) {
                material.image = material.image == static_cast<int>(i) ? -1 : material.image;
            }
        }
    }
}

OwnLooks looksOf(ImportedModel& model) {
    decodeImages(model);
    OwnLooks looks{std::move(model.soup.skin)};
    if (!model.appearance.materials.empty()) {
        looks.appearance = std::make_shared<const render::Appearance>(std::move(model.appearance));
    }
    return looks;
}

}  // namespace

namespace {

/// Those that hang together have become one, by the number and name of the first of them.
void numberObjects(ImportedModel& model) {
    std::vector<int> numbers(model.facts.objects.size(), -1);
    std::vector<std::string> names;
    for (int& object : model.soup.objects) {
        int& number = numbers[object];
        if (number < 0) {
            number = static_cast<int>(names.size());
            names.push_back(model.facts.objects[object]);
        }
        object = number;
    }
    model.facts.objects = std::move(names);
}

/// Keeps the items of a list that numbers name, in the order in which they first do.
template <class Item>
struct UsedItems {
    const std::vector<Item>& all;
    std::vector<Item> used{};
    std::map<int, int> numbers{};

    /// The number becomes that in the list of used ones.
    void take(int& number) {
        if (number >= 0) {
            const auto [place, isNew] = numbers.try_emplace(number, static_cast<int>(used.size()));
            if (isNew) {
                used.push_back(all[number]);
            }
            number = place->second;
        }
    }
};

/// A scene may hold a model for each object of a file: none is to bring the images of all.
void dropUnusedLooks(ImportedModel& model) {
    UsedItems<render::SurfaceMaterial> materials{model.appearance.materials};
    UsedItems<render::ModelImage> images{model.appearance.images};
    std::ranges::for_each(model.soup.skin.materials, [&](int& number) { materials.take(number); });
    for (render::SurfaceMaterial& material : materials.used) {
        images.take(material.image);
    }
    model.appearance = {std::move(materials.used), std::move(images.used)};
}

/// Leaves out the others.
void takeObject(const fs::path& file, ImportedModel& model, int object) {
    TriangleSoup& soup = model.soup;
    if (object > 0) {
        const int count = std::max<int>(1, static_cast<int>(model.facts.objects.size()));
        if (object > count) {
            throw InputError(shownPath(file) + ": object " + std::to_string(object) +
                             " is wanted, but it has " + counted(count, "object", "objects") +
                             "; name another one in \"object\", or none");
        }
        if (!soup.objects.empty()) {
            repair::keepTriangles(soup, [&](int t) { return soup.objects[t] + 1 == object; });
            repair::dropUnusedVertices(soup);
            dropUnusedLooks(model);
        }
    }
    soup.objects.clear();
}

}  // namespace

ImportedModel modelOfAnswer(std::string_view answer) {
    ImportedModel model = decodeImport(answer);
    model.soup = weldObjects(model.soup);
    numberObjects(model);
    checkImportedPositions(model.soup);
    return model;
}

namespace {

ImportedModel importFor(const fs::path& file, const ImportLimits& limits,
                        const std::optional<MemoryMeans>& means, WorkProgress* progress) {
    try {
        return readThroughProcess(file, limits, means, progress);
    } catch (const InputError& error) {
        throw InputError(shownPath(file) + ": " + error.what());
    }
}

}  // namespace

ImportedModel importWithLooks(const fs::path& file, const ImportLimits& limits,
                              WorkProgress* progress) {
    return importFor(file, limits, std::nullopt, progress);
}

ImportedModel importWithLooks(const fs::path& file, const ReadOptions& options) {
    return importFor(file, ImportLimits{}, options.means, options.progress);
}

TriangleSoup importModel(const fs::path& file, const ImportLimits& limits, WorkProgress* progress) {
    return importWithLooks(file, limits, progress).soup;
}

TriangleSoup importModel(const fs::path& file, WorkProgress* progress) {
    return importModel(file, ImportLimits{}, progress);
}

bool isModelFile(const fs::path& file) {
    const std::string extension = lowerCase(file.extension().string());
    return std::ranges::any_of(formats(),
                               [&](const Format& f) { return extension == f.extension; });
}

namespace {

/// What is left of crossing pieces, and what can be done about it.
void noteCrossings(const MeshReport& found, bool repaired, std::vector<std::string>& remarks) {
    for (const std::string& left : found.left) {
        remarks.push_back("Left as it is: " + left + ".");
    }
    if (found.crossingTriangles > 0 && !repaired) {
        remarks.push_back(counted(found.crossingTriangles, "triangle passes", "triangles pass") +
                          " through others: where they do, the material counts twice and faces of "
                          "cuts cross; a repair unites pieces that cross (Unite pieces, under "
                          "Model; kerf inspect --repair).");
    }
}

ModelMesh meshOf(ImportedModel& model) {
    ModelMesh built(SurfaceMesh::fromTriangles(model.soup.positions, model.soup.triangles));
    built.looks = looksOf(model);
    built.remarks = std::move(model.remarks);
    built.facts = std::move(model.facts);
    return built;
}

void requireMended(const fs::path& file, const MeshReport& found, const Mending& mending) {
    if (!found.cuttable) {
        throw ModelFault(shownPath(file) + (mending.thicken ? ": " : ": after the repair still ") +
                         found.problem);
    }
}

/// What was sound in doubles may fall together where edges are short.
void requireSurvivesRounding(const fs::path& file, const MeshReport& found, bool remeshed) {
    if (!found.cuttable) {
        throw ModelFault(
            fmt::format("{}: once mended and rounded to the 32-bit numbers of a file, it has {}{}",
                        shownPath(file), found.problem,
                        remeshed ? ", or ask for longer edges with --edge" : ""));
    }
}

/// Edges too short for the memory that there is are refused before any of it is taken.
void requireMemoryForEdges(const fs::path& file, const TriangleSoup& soup, double edge) {
    constexpr double kBytesOfTriangle = 400;  // 330 were seen, with 300,000 of them
    const double triangles = trianglesOf(figuresOf(soup), edge);
    requireFree(fmt::format("{}: edges of {:g} make about {:.1e} triangles", file.string(), edge,
                            std::min(triangles, 1e18)),
                kBytesOfTriangle * triangles, "ask for longer ones with --edge");
}

/// Returns what was done.
std::string remeshed(const fs::path& file, TriangleSoup& soup, double edge,
                     WorkProgress* progress) {
    requireMemoryForEdges(file, soup, edge);
    const std::size_t before = soup.triangles.size();
    repair::remesh(soup, edge, [&](int round) {
        enter(progress, "Evening out the triangles, round " + std::to_string(round + 1));
    });
    return "remeshed " + std::to_string(before) + " triangles to " +
           std::to_string(soup.triangles.size());
}

MeshReport evened(const fs::path& file, TriangleSoup& soup, const MeshReport& before,
                  const ReadOptions& options) {
    std::vector<std::string> repairs = before.repairs;
    const double edge = options.edge.value_or(evenEdge(figuresOf(soup)));
    repairs.push_back(remeshed(file, soup, edge, options.progress));
    MeshReport found = inspectTriangles(soup);
    found.repairs = std::move(repairs);
    if (!found.cuttable) {
        throw ModelFault(file.string() + ": with even triangles it has " + found.problem);
    }
    return found;
}

/// Those that are asked for; crossing triangles are counted in the report.
repair::Faults findFaults(const TriangleSoup& soup, MeshReport& found, const ReadOptions& options) {
    const bool crossings =
        soup.triangles.size() <= options.findCrossingsUpTo && found.outOfRangeIndices == 0;
    if (!options.findFaults) {
        if (crossings) {
            countCrossings(soup, found);
        }
        return {};
    }
    repair::Faults faults = repair::findFaults(soup, crossings);
    found.crossingTriangles = faults.of(repair::FaultKind::crossingTriangle).count();
    return faults;
}

}  // namespace

ModelMesh readModel(const fs::path& file, const ReadOptions& options) {
    return surfaceOf(file, importWithLooks(file, options), options);
}

ModelMesh surfaceOf(const fs::path& file, ImportedModel model, const ReadOptions& options) {
    takeObject(file, model, options.object);
    TriangleSoup& soup = model.soup;
    if (options.facts != nullptr) {
        *options.facts = model.facts;
    }
    enter(options.progress, "Looking for faults");
    MeshReport found = inspectAndRepair(soup, options);
    if (found.cuttable && options.remesh) {
        found = evened(file, soup, found, options);
    }
    repair::Faults faults = findFaults(soup, found, options);
    if (options.report != nullptr) {
        *options.report = found;
    }
    if (!found.cuttable) {
        ModelFault fault = faultOf(file, soup, found, options);
        if (options.findFaults) {
            fault.setFound(std::make_shared<const FoundFaults>(
                FoundFaults{std::move(soup), std::move(faults), model.facts.units}));
        }
        throw fault;
    }
    enter(options.progress, "Building the surface");
    ModelMesh built = meshOf(model);
    built.faults = std::move(faults);
    noteCrossings(found, options.repair, built.remarks);
    return built;
}

MendedModel mendModel(const fs::path& file, const Mending& mending) {
    ImportedModel model = importWithLooks(file, ImportLimits{}, nullptr);
    ReadOptions options{mending};
    takeObject(file, model, options.object);
    options.repair = true;
    MeshReport found = inspectAndRepair(model.soup, options);
    requireMended(file, found, mending);
    std::vector<std::string> repairs = std::move(found.repairs);
    std::vector<std::string> left = std::move(found.left);
    if (options.remesh) {
        const double proposed = proposedEdge(figuresOf(model.soup), found.bounds.diagonal());
        repairs.push_back(remeshed(file, model.soup, options.edge.value_or(proposed), nullptr));
    }
    roundToFloats(model.soup);
    found = inspectTriangles(model.soup);
    requireSurvivesRounding(file, found, options.remesh);
    countCrossings(model.soup, found);
    found.repairs = std::move(repairs);
    found.left = std::move(left);
    return {meshOf(model), std::move(found)};
}

SurfaceMesh loadModel(const fs::path& file, MeshReport* report) {
    ReadOptions options;
    options.report = report;
    return readModel(file, options).mesh;
}

}  // namespace kerf::app
