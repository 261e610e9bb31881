#include <assimp/DefaultIOSystem.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <unistd.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cerrno>
#include <span>
#include <string>

#include "app/files/import_process.h"
#include "app/files/import_protocol.h"
#include "app/files/model_source.h"

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
        return reads && isAllowed(name) ? DefaultIOSystem::Open(name, mode) : nullptr;
    }

  private:
    bool isAllowed(const std::filesystem::path& name) const {
        std::error_code error;
        const std::filesystem::path file = std::filesystem::canonical(name, error);
        const auto [end, rest] =
            std::mismatch(folder_.begin(), folder_.end(), file.begin(), file.end());
        return !error && end == folder_.end() && std::filesystem::is_regular_file(file, error) &&
               std::filesystem::file_size(file, error) <= kMaxModelBytes && !error;
    }

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

void appendMesh(const aiMesh& mesh, bool textured, TriangleSoup& soup) {
    const int first = static_cast<int>(soup.positions.size());
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
        const aiVector3D& p = mesh.mVertices[i];
        soup.positions.emplace_back(p.x, p.y, p.z);
    }
    for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
        const aiFace& face = mesh.mFaces[i];
        if (face.mNumIndices == 3) {
            soup.triangles.push_back({first + static_cast<int>(face.mIndices[0]),
                                      first + static_cast<int>(face.mIndices[1]),
                                      first + static_cast<int>(face.mIndices[2])});
            if (textured) {
                soup.uvs.push_back(uvsOf(mesh, face));
            }
        }
    }
}

/// Says in words of ours what assimp puts into its own.
std::string plainReason(const std::string& message) {
    if (message.find("mNumMeshes is 0") != std::string::npos) {
        return "there is no surface in it";
    }
    if (message.find("bad_alloc") != std::string::npos) {
        return "it needs more memory than a model may";
    }
    return message;
}

/// Node transforms are applied, polygons triangulated, points and lines left out.
TriangleSoup readTriangles(const std::filesystem::path& file) {
    Assimp::Importer importer;
    importer.SetIOHandler(new FolderFiles(file));  // The importer deletes it.
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                                aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    const aiScene* scene = importer.ReadFile(
        file.string(), aiProcess_Triangulate | aiProcess_SortByPType |
                           aiProcess_PreTransformVertices | aiProcess_ValidateDataStructure);
    if (scene == nullptr) {
        throw InputError(plainReason(importer.GetErrorString()));
    }
    const std::span<aiMesh* const> meshes(scene->mMeshes, scene->mNumMeshes);
    const bool textured =
        std::ranges::any_of(meshes, [](const aiMesh* mesh) { return mesh->HasTextureCoords(0); });
    TriangleSoup soup;
    for (const aiMesh* mesh : meshes) {
        appendMesh(*mesh, textured, soup);
    }
    return soup;
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

std::string answerFor(const std::filesystem::path& file) {
    try {
        return encodeImport(readTriangles(file));
    } catch (const std::exception& error) {
        return encodeImportFailure(plainReason(error.what()));
    }
}

}  // namespace

int runImportWorker(const std::filesystem::path& file) {
    applyImportLimits();
    const int answer = takeStandardOutput();
    return writeAll(answer, answerFor(file)) ? 0 : 1;
}

}  // namespace kerf::app
