#include "app/files/import/model_source.h"

#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>

#include <csignal>

#include "app/files/import/import_process.h"
#include "app/files/io/file_io.h"
#include "app/files/jobs/process_limits.h"
#include "sim/base/text.h"

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
void checkEnd(const ImportEnd& end, const std::string& format, const ImportLimits& limits) {
    if (end.tooSlow && !end.stage.empty()) {
        throw InputError(fmt::format(
            "\"{}\" did not end within {} s; mend it in a modelling tool, or decimate it",
            end.stage, kMendingWallSeconds));
    }
    if (end.tooSlow) {
        const int limit = end.signal == SIGXCPU ? limits.cpuSeconds : limits.wallSeconds;
        throw InputError("reading it as " + format + " did not end within " +
                         std::to_string(limit) +
                         " s; the file may be cut off or damaged, export it again");
    }
    if (end.tooLong) {
        throw InputError("it has more than " + std::to_string(kMaxImportTriangles) +
                         " triangles; decimate the model");
    }
    if (end.signal == SIGKILL || end.signal == SIGTERM) {
        throw InputError(
            "the program that reads it was ended from outside, as systems do that run out of "
            "memory; close other programs and open it again");
    }
    if (end.exitCode != 0) {
        throw InputError("the " + format + " reader failed on it (" +
                         (end.signal != 0 ? std::string(sigabbrev_np(end.signal))
                                          : "exit " + std::to_string(end.exitCode)) +
                         "); the file may be damaged, export it again, for example as OBJ");
    }
}

std::vector<ImportAnswer> answersOfReader(const fs::path& file,
                                          const std::vector<ImportOrder>& orders,
                                          const ImportLimits& limits, WorkProgress* progress) {
    enter(progress, "Reading the file");
    checkFile(file);
    const Format& format = formatOf(file);
    std::vector<std::string> command{importProgram().string(), fs::absolute(file).string()};
    std::ranges::transform(orders, std::back_inserter(command), encodeOrder);
    const ImportEnd end = runImportProcess(command, limits, progress);
    if (!end.log.empty()) {
        spdlog::debug("{}: {}", file.string(), end.log);
    }
    checkEnd(end, format.name, limits);
    std::vector<ImportAnswer> answers = decodeAnswers(end.answer, orders.size());
    for (const ImportAnswer& answer : answers) {
        if (answer.outcome == ImportOutcome::refused) {
            throw InputError(answer.reason);
        }
        if (answer.outcome == ImportOutcome::outOfMemory) {
            throw MemoryShortage(answer.reason);
        }
    }
    return answers;
}

OwnLooks looksOf(ImportedModel& model) {
    OwnLooks looks{std::move(model.soup.skin)};
    if (!model.appearance.materials.empty()) {
        looks.appearance = std::make_shared<const render::Appearance>(std::move(model.appearance));
    }
    return looks;
}

ModelMesh meshOf(ImportAnswer& answer) {
    ImportedModel& model = answer.model;
    ModelMesh built(SurfaceMesh::fromTriangles(model.soup.positions, model.soup.triangles));
    built.looks = looksOf(model);
    built.remarks = std::move(model.remarks);
    built.facts = std::move(model.facts);
    built.faults = std::move(answer.faults);
    return built;
}

ModelFault faultOf(const fs::path& file, ImportAnswer& answer) {
    ModelFault fault(shownPath(file) + ": " + answer.reason, std::move(answer.help));
    fault.setFound(std::make_shared<const FoundFaults>(FoundFaults{
        std::move(answer.model.soup), std::move(answer.faults), answer.model.facts.units}));
    return fault;
}

}  // namespace

bool isModelFile(const fs::path& file) {
    const std::string extension = lowerCase(file.extension().string());
    return std::ranges::any_of(formats(),
                               [&](const Format& f) { return extension == f.extension; });
}

fs::path importProgram() {
    const char* const chosen = std::getenv("KERF_IMPORT");
    return chosen != nullptr ? fs::path(chosen) : programBeside("kerf-import");
}

std::vector<ImportAnswer> importModels(const fs::path& file, const std::vector<ImportOrder>& orders,
                                       WorkProgress* progress, const ImportLimits& limits) {
    try {
        return answersOfReader(file, orders, limits, progress);
    } catch (const InputError& error) {
        throw InputError(shownPath(file) + ": " + error.what());
    }
}

ImportAnswer importModel(const fs::path& file, const ImportOrder& order, WorkProgress* progress,
                         const ImportLimits& limits) {
    return std::move(importModels(file, {order}, progress, limits).front());
}

ModelMesh cuttableModel(const fs::path& file, ImportAnswer answer) {
    if (answer.outcome != ImportOutcome::cuttable) {
        throw faultOf(file, answer);
    }
    return meshOf(answer);
}

ModelMesh readModel(const fs::path& file, const ReadOptions& options) {
    ImportAnswer answer = importModel(file, options, options.progress);
    if (options.report != nullptr) {
        *options.report = answer.report;
    }
    enter(options.progress, "Building the surface");
    return cuttableModel(file, std::move(answer));
}

SurfaceMesh loadModel(const fs::path& file, MeshReport* report) {
    ReadOptions options;
    options.report = report;
    return readModel(file, options).mesh;
}

}  // namespace kerf::app
