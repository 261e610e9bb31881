#include <assimp/DefaultIOSystem.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <assimp/Importer.hpp>
#include <cerrno>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "app/files/face_soup.h"
#include "app/files/gltf_reader.h"
#include "app/files/import_appearance.h"
#include "app/files/import_process.h"
#include "app/files/import_protocol.h"
#include "app/files/model_source.h"
#include "app/files/obj_reader.h"
#include "app/files/off_reader.h"
#include "app/files/ply_reader.h"
#include "app/files/process_limits.h"
#include "app/files/stl_reader.h"
#include "render/scene/body_look.h"
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
        return reads && isAllowed(name) ? DefaultIOSystem::Open(name, mode) : nullptr;
    }

  private:
    bool isAllowed(const std::filesystem::path& name) const { return isFileBelow(folder_, name); }

    std::filesystem::path folder_;
};

/// From what displays take to linear light, apart from the opacity.
Eigen::Vector4f linearOf(const aiColor4D& color) {
    const Vec3f linear = render::toLinear(Vec3(color.r, color.g, color.b));
    return {linear.x(), linear.y(), linear.z(), color.a};
}

/// The vertices of a mesh at the place of its node.
void addVertices(const aiMesh& mesh, const aiMatrix4x4& place, FaceSoup& faces) {
    const std::size_t first = faces.positions.size();
    for (const aiVector3D& own : std::span(mesh.mVertices, mesh.mNumVertices)) {
        const aiVector3D p = place * own;
        faces.positions.emplace_back(p.x, p.y, p.z);
    }
    if (mesh.HasTextureCoords(0)) {
        faces.vertexUvs.resize(first, Vec2::Zero());
        for (const aiVector3D& uv : std::span(mesh.mTextureCoords[0], mesh.mNumVertices)) {
            faces.vertexUvs.emplace_back(uv.x, uv.y);
        }
    }
    if (mesh.HasVertexColors(0)) {
        faces.vertexColors.resize(first, Eigen::Vector4f::Ones());
        std::ranges::transform(std::span(mesh.mColors[0], mesh.mNumVertices),
                               std::back_inserter(faces.vertexColors), linearOf);
    }
}

/// A node that mirrors turns them over.
void addFaces(const aiMesh& mesh, bool mirrored, int first, FaceSoup& faces) {
    for (const aiFace& face : std::span(mesh.mFaces, mesh.mNumFaces)) {
        for (unsigned i = 0; i < face.mNumIndices; ++i) {
            const unsigned corner = mirrored ? face.mNumIndices - 1 - i : i;
            faces.addCorner(first + static_cast<int>(face.mIndices[corner]));
        }
        faces.endFace(static_cast<int>(mesh.mMaterialIndex));
    }
}

/// All that the nodes of a scene show, an object for each node.
FaceSoup facesOf(const aiScene& scene, const aiMatrix4x4& root) {
    FaceSoup faces;
    std::vector<std::pair<const aiNode*, aiMatrix4x4>> waiting{{scene.mRootNode, root}};
    while (!waiting.empty()) {
        const auto [node, place] = waiting.back();
        waiting.pop_back();
        if (node->mNumMeshes > 0) {
            faces.beginObject(node->mName.C_Str());
        }
        for (const unsigned number : std::span(node->mMeshes, node->mNumMeshes)) {
            const aiMesh& mesh = *scene.mMeshes[number];
            const int first = static_cast<int>(faces.positions.size());
            addVertices(mesh, place, faces);
            addFaces(mesh, place.Determinant() < 0, first, faces);
        }
        for (unsigned i = node->mNumChildren; i > 0; --i) {
            const aiNode* child = node->mChildren[i - 1];
            waiting.emplace_back(child, place * child->mTransformation);
        }
    }
    return faces;
}

// --- What an FBX says of its numbers -------------------------------------------------------------

/// A setting of the whole file; nothing where it has none.
template <class T>
std::optional<T> settingOf(const aiScene& scene, const char* name) {
    T value{};
    const bool there = scene.mMetaData != nullptr && scene.mMetaData->Get(name, value);
    return there ? std::optional(value) : std::nullopt;
}

/// In the order of UpAxis: y, z and x, and the same downwards.
UpAxis upAxisOf(const aiScene& scene) {
    constexpr std::array kAxes{UpAxis::x, UpAxis::y, UpAxis::z};
    constexpr std::array kDownward{UpAxis::minusX, UpAxis::minusY, UpAxis::minusZ};
    const int axis = std::clamp(settingOf<int>(scene, "UpAxis").value_or(1), 0, 2);
    return settingOf<int>(scene, "UpAxisSign").value_or(1) < 0 ? kDownward[axis] : kAxes[axis];
}

/// Brings numbers in a unit that has no name to centimetres.
FileUnits fbxUnits(const aiScene& scene, double centimetres, std::vector<Vec3>& positions) {
    constexpr double kSame = 1e-6;
    constexpr int kUnits = std::size(kLengthUnitNames);
    for (int unit = 0; unit < kUnits; ++unit) {
        const double ratio = centimetres / (100 * infoOf(static_cast<LengthUnit>(unit)).metres);
        if (std::abs(ratio - 1) < kSame) {
            return {static_cast<LengthUnit>(unit), upAxisOf(scene)};
        }
    }
    for (Vec3& p : positions) {
        p *= centimetres;
    }
    return {LengthUnit::centimetre, upAxisOf(scene)};
}

/// Says in words of ours what assimp puts into its own.
std::string plainReason(const std::string& message) {
    const auto says = [&](std::string_view part) {
        return message.find(part) != std::string::npos;
    };
    if (says("mNumMeshes is 0") || says("No meshes remaining") || says("contains no faces")) {
        return "there is no surface in it";
    }
    if (says("bad_alloc")) {
        return "it needs more memory than a model may";
    }
    return message;
}

ImportedModel readByAssimp(const std::filesystem::path& file) {
    Assimp::Importer importer;
    importer.SetIOHandler(new FolderFiles(file));  // The importer deletes it.
    const aiScene* scene = importer.ReadFile(file.string(), aiProcess_ValidateDataStructure);
    if (scene == nullptr) {
        throw InputError(plainReason(importer.GetErrorString()));
    }
    // Some versions of assimp turn an FBX at its root, which is not in the file.
    const auto centimetres = settingOf<float>(*scene, "UnitScaleFactor");
    FaceSoup faces =
        facesOf(*scene, centimetres ? aiMatrix4x4() : scene->mRootNode->mTransformation);
    requireFineFloats(faces.positions);
    ImportedModel model;
    if (centimetres && *centimetres > 0) {
        model.facts.units = fbxUnits(*scene, *centimetres, faces.positions);
    }
    takeFaces(faces, model);
    addAppearance(*scene, file, model);
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
