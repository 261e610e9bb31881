#include "app/files/model_source.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <csignal>

#include "app/files/import_process.h"
#include "app/files/import_protocol.h"
#include "sim/base/text.h"
#include "sim/mesh/hole_filling.h"

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
    static const std::vector<Format> list = {{".obj", "OBJ"},   {".ply", "PLY"}, {".stl", "STL"},
                                             {".gltf", "glTF"}, {".glb", "GLB"}, {".off", "OFF"},
                                             {".3ds", "3DS"},   {".dae", "DAE"}, {".fbx", "FBX"}};
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
        throw InputError("no such file; check the path");
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

ImportedModel readThroughProcess(const fs::path& file, const ImportLimits& limits,
                                 WorkProgress* progress) {
    enter(progress, "Reading the file");
    checkFile(file);
    const Format& format = formatOf(file);
    const ImportOutcome outcome =
        runImportProcess(importProgram(), fs::absolute(file), limits, progress);
    if (!outcome.log.empty()) {
        spdlog::debug("{}: {}", file.string(), outcome.log);
    }
    checkOutcome(outcome, format.name, limits);
    enter(progress, "Joining equal vertices");
    ImportedModel model = decodeImport(outcome.answer);
    model.soup = weldExactly(model.soup);
    checkImportedPositions(model.soup);
    return model;
}

/// Fills holes where that is wanted, and turns what is inside out.
MeshReport inspectAndRepair(TriangleSoup& soup, bool withFilling) {
    MeshReport found = inspectTriangles(soup);
    std::vector<std::string> repairs;
    if (withFilling && found.openEdges > 0) {
        const HoleFilling filled = fillHoles(soup);
        found = inspectTriangles(soup);
        repairs.push_back("filled " + counted(filled.holes, "hole", "holes") + " with " +
                          counted(filled.triangles, "triangle", "triangles"));
    }
    if (found.insideOutPieces > 0) {
        const int turned = turnOutward(soup);
        found = inspectTriangles(soup);
        repairs.push_back("turned " + counted(turned, "inside-out piece", "inside-out pieces"));
    }
    found.repairs = std::move(repairs);
    return found;
}

/// See ModelFault::fillableHoles.
int holesThatHelp(TriangleSoup soup, const MeshReport& report) {
    if (report.openEdges == 0) {
        return 0;
    }
    const int holes = fillHoles(soup).holes;
    return inspectAndRepair(soup, false).cuttable ? holes : 0;
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
            for (render::Material& material : model.appearance.materials) {
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

ImportedModel importWithLooks(const fs::path& file, const ImportLimits& limits,
                              WorkProgress* progress) {
    try {
        return readThroughProcess(file, limits, progress);
    } catch (const InputError& error) {
        throw InputError(file.string() + ": " + error.what());
    }
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

ModelMesh readModel(const fs::path& file, const ReadOptions& options) {
    ImportedModel model = importWithLooks(file, ImportLimits{}, options.progress);
    TriangleSoup& soup = model.soup;
    enter(options.progress, "Looking for faults");
    const MeshReport found = inspectAndRepair(soup, options.fillHoles);
    if (options.report != nullptr) {
        *options.report = found;
    }
    if (!found.cuttable) {
        const int holes = options.tryFilling ? holesThatHelp(soup, found) : 0;
        throw ModelFault(file.string() + ": " + found.problem, holes);
    }
    enter(options.progress, "Building the surface");
    ModelMesh built(SurfaceMesh::fromTriangles(soup.positions, soup.triangles));
    enter(options.progress, "Reading the images");
    built.looks = looksOf(model);
    built.remarks = std::move(model.remarks);
    return built;
}

SurfaceMesh loadModel(const fs::path& file, MeshReport* report) {
    ReadOptions options;
    options.report = report;
    return readModel(file, options).mesh;
}

}  // namespace kerf::app
