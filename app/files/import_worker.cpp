#include <assimp/DefaultIOSystem.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <assimp/DefaultLogger.hpp>
#include <assimp/IOStream.hpp>
#include <assimp/Importer.hpp>
#include <assimp/LogStream.hpp>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "app/files/face_soup.h"
#include "app/files/gltf_reader.h"
#include "app/files/import_appearance.h"
#include "app/files/import_polygons.h"
#include "app/files/import_process.h"
#include "app/files/import_protocol.h"
#include "app/files/model_source.h"
#include "app/files/obj_reader.h"
#include "app/files/off_reader.h"
#include "app/files/ply_reader.h"
#include "app/files/process_limits.h"
#include "app/files/stl_reader.h"
#include "app/files/text_lines.h"
#include "sim/base/text.h"

namespace kerf::app {

namespace {

/// Opens, to read, regular files of limited size in one folder and below, and nothing else: models
/// name further files, and those names are as untrusted as the rest.
class FolderFiles : public Assimp::DefaultIOSystem {
  public:
    explicit FolderFiles(const std::filesystem::path& model)
        : folder_(std::filesystem::canonical(model).parent_path()) {}

    bool Exists(const char* name) const override { return isAllowed(name); }
    Assimp::IOStream* Open(const char* name, const char* mode) override {
        const bool reads = std::string_view(mode).starts_with('r') &&
                           std::string_view(mode).find('+') == std::string_view::npos;
        Assimp::IOStream* const stream =
            reads && isAllowed(name) ? DefaultIOSystem::Open(name, mode) : nullptr;
        std::array<char, kByteOrderMark.size()> first{};
        if (stream != nullptr && (stream->Read(first.data(), 1, first.size()) < first.size() ||
                                  std::string_view(first.data(), first.size()) != kByteOrderMark)) {
            stream->Seek(0, aiOrigin_SET);
        }
        return stream;
    }

  private:
    bool isAllowed(const std::filesystem::path& name) const { return isFileBelow(folder_, name); }

    std::filesystem::path folder_;
};

CornerUvs uvsOf(const aiMesh& mesh, const aiFace& face) {
    CornerUvs uvs;
    for (unsigned i = 0; i < 3; ++i) {
        const aiVector3D uv =
            mesh.HasTextureCoords(0) ? mesh.mTextureCoords[0][face.mIndices[i]] : aiVector3D();
        uvs[i] = {uv.x, uv.y};
    }
    return uvs;
}

CornerColors colorsOf(const aiMesh& mesh, const aiFace& face) {
    CornerColors colors;
    for (unsigned i = 0; i < 3; ++i) {
        const aiColor4D color =
            mesh.HasVertexColors(0) ? mesh.mColors[0][face.mIndices[i]] : aiColor4D(1, 1, 1, 1);
        colors[i] = linearOf({color.r, color.g, color.b, color.a});
    }
    return colors;
}

/// What the meshes of a scene have, at least one of them.
struct SceneHas {
    bool uvs;
    bool colors;
};

SceneHas contentOf(std::span<const aiMesh* const> meshes) {
    return {
        std::ranges::any_of(meshes, [](const aiMesh* mesh) { return mesh->HasTextureCoords(0); }),
        std::ranges::any_of(meshes, [](const aiMesh* mesh) { return mesh->HasVertexColors(0); })};
}

void appendMesh(const aiMesh& mesh, const SceneHas& has, TriangleSoup& soup) {
    const int first = static_cast<int>(soup.positions.size());
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
        const aiVector3D& p = mesh.mVertices[i];
        soup.positions.emplace_back(p.x, p.y, p.z);
    }
    for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
        const aiFace& face = mesh.mFaces[i];
        if (face.mNumIndices != 3) {
            continue;
        }
        soup.triangles.push_back({first + static_cast<int>(face.mIndices[0]),
                                  first + static_cast<int>(face.mIndices[1]),
                                  first + static_cast<int>(face.mIndices[2])});
        if (has.uvs) {
            soup.skin.uvs.push_back(uvsOf(mesh, face));
        }
        if (has.colors) {
            soup.skin.colors.push_back(colorsOf(mesh, face));
        }
    }
}

/// Says in words of ours what assimp puts into its own.
std::string plainReason(const std::string& message) {
    const auto says = [&](std::string_view part) {
        return message.find(part) != std::string::npos;
    };
    if (says("mNumMeshes is 0") || says("No meshes remaining") || says("contains no faces") ||
        says("No faces loaded")) {
        return "there is no surface in it";
    }
    if (says("bad_alloc")) {
        return "it needs more memory than a model may";
    }
    return message;
}

/// What is not read of meshes, as remarks.
void tellLeftOut(const aiScene& scene, std::vector<std::string>& remarks) {
    const std::span meshes(scene.mMeshes, scene.mNumMeshes);
    if (std::ranges::any_of(meshes, [](const aiMesh* mesh) { return mesh->HasBones(); })) {
        remarks.emplace_back("The pose of its bones was left out: it has the shape without them.");
    }
    if (std::ranges::any_of(meshes, [](const aiMesh* mesh) { return mesh->mNumAnimMeshes > 0; })) {
        remarks.emplace_back("Its shape keys were left out: it has the shape without them.");
    }
}

/// Makes a remark of the first that assimp tells in its log alone where it leaves out a part of a
/// file, or changes it.
class DamageLog : public Assimp::LogStream {
  public:
    explicit DamageLog(std::vector<std::string>& remarks) : remarks_(remarks) {
        Assimp::DefaultLogger::create("", Assimp::Logger::NORMAL, 0);
        Assimp::DefaultLogger::get()->attachStream(this, Assimp::Logger::Warn);
    }
    ~DamageLog() override {
        Assimp::DefaultLogger::get()->detachStream(this, Assimp::Logger::Warn);
        Assimp::DefaultLogger::kill();
    }
    DamageLog(const DamageLog&) = delete;
    DamageLog& operator=(const DamageLog&) = delete;

    void write(const char* message) override {
        const std::string_view text(message, std::strcspn(message, "\n"));
        for (const std::string_view words :
             {"Unable to find geometry", "failed to read source object for incoming Model link",
              "duplicate object id", "Vertex index overflow"}) {
            if (remarks_.empty() && text.find(words) != std::string_view::npos) {
                remarks_.push_back("A part of it is damaged, and left out or changed: " +
                                   std::string(text.substr(text.find(": ") + 2)));
            }
        }
    }

  private:
    std::vector<std::string>& remarks_;
};

/// Node transforms are applied, polygons triangulated, points and lines left out.
ImportedModel readByAssimp(const std::filesystem::path& file) {
    ImportedModel model;
    const DamageLog log(model.remarks);
    Assimp::Importer importer;
    importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
    importer.SetIOHandler(new FolderFiles(file));  // The importer deletes it.
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                                aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    const aiScene* scene = importer.ReadFile(file.string(), 0);
    if (scene != nullptr) {
        tellLeftOut(*scene, model.remarks);
        dividePolygons(*scene);
        scene = importer.ApplyPostProcessing(aiProcess_Triangulate | aiProcess_SortByPType |
                                             aiProcess_PreTransformVertices |
                                             aiProcess_ValidateDataStructure);
    }
    if (scene == nullptr) {
        throw InputError(plainReason(importer.GetErrorString()));
    }
    const std::span<aiMesh* const> meshes(scene->mMeshes, scene->mNumMeshes);
    const SceneHas has = contentOf(meshes);
    std::vector<int> triangles;  // by mesh
    for (const aiMesh* mesh : meshes) {
        const std::size_t before = model.soup.triangles.size();
        appendMesh(*mesh, has, model.soup);
        triangles.push_back(static_cast<int>(model.soup.triangles.size() - before));
    }
    if (model.soup.triangles.empty()) {
        throw InputError(model.remarks.empty() ? "there is no surface in it"
                                               : model.remarks.front());
    }
    addAppearance(*scene, file, triangles, model);
    requireFineFloats(model.soup.positions);
    return model;
}

ImportedModel readScene(const std::filesystem::path& file) {
    using Reader = ImportedModel (*)(const std::filesystem::path&);
    static const std::map<std::string, Reader> kReaders{{".ply", readPly},   {".obj", readObj},
                                                        {".stl", readStl},   {".off", readOff},
                                                        {".gltf", readGltf}, {".glb", readGltf}};
    const auto own = kReaders.find(lowerCase(file.extension().string()));
    return own == kReaders.end() ? readByAssimp(file) : own->second(file);
}

/// The answer's stream, set aside so that nothing that a library prints gets into it.
int takeStandardOutput() {
    const int answer = ::dup(STDOUT_FILENO);
    ::dup2(STDERR_FILENO, STDOUT_FILENO);
    return answer;
}

bool writeAll(int descriptor, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
        if (count < 0 && errno != EINTR) {
            return false;
        }
        bytes.remove_prefix(std::max<ssize_t>(count, 0));
    }
    return true;
}

}  // namespace

std::string answerFor(const std::filesystem::path& file) {
    try {
        return encodeImport(readScene(file));
    } catch (const std::exception& error) {
        return encodeImportFailure(plainReason(error.what()));
    }
}

int runImportWorker(const std::filesystem::path& file) {
    applyImportLimits();
    const int answer = takeStandardOutput();
    return writeAll(answer, answerFor(file)) ? 0 : 1;
}

}  // namespace kerf::app
