#include "app/import/scene_reader.h"

#include <assimp/DefaultIOSystem.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/DefaultLogger.hpp>
#include <assimp/IOStream.hpp>
#include <assimp/Importer.hpp>
#include <assimp/LogStream.hpp>
#include <charconv>
#include <cstring>

#include "app/files/import/import_answer.h"
#include "app/files/io/errors.h"
#include "app/files/io/file_io.h"
#include "app/files/io/text_lines.h"
#include "app/import/appearance_reader.h"
#include "app/import/dae_file.h"
#include "app/import/face_soup.h"
#include "app/import/vtk_mesh.h"
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
                               std::back_inserter(faces.vertexColors), [](const aiColor4D& c) {
                                   return linearOf({c.r, c.g, c.b, c.a});
                               });
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

/// Each corner of a face is a vertex of its own there: assimp leaves out a last face that does not
/// end, and no more.
void requireEndsOfFaces(const aiScene& scene) {
    for (const aiMesh* mesh : std::span(scene.mMeshes, scene.mNumMeshes)) {
        std::size_t corners = 0;
        for (const aiFace& face : std::span(mesh->mFaces, mesh->mNumFaces)) {
            corners += face.mNumIndices;
        }
        if (mesh->mNumVertices > corners) {
            throw InputError("the last face of a mesh has no end, so a part may be missing");
        }
    }
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
std::string plainWords(const std::string& message) {
    const auto says = [&](std::string_view part) {
        return message.find(part) != std::string::npos;
    };
    if (says("mNumMeshes is 0") || says("No meshes remaining") || says("contains no faces") ||
        says("No faces loaded")) {
        return "there is no surface in it";
    }
    if (says("bad_alloc")) {
        return "it needs more memory than a model may; export it with fewer triangles";
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

/// `text`: what stands for the bytes of the file, if anything.
ImportedModel readByAssimp(const std::filesystem::path& file, const std::string& text) {
    ImportedModel model;
    const DamageLog log(model.remarks);
    Assimp::Importer importer;
    importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
    importer.SetIOHandler(new FolderFiles(file));  // The importer deletes it.
    constexpr unsigned kSteps = aiProcess_ValidateDataStructure;
    const aiScene* scene = text.empty()
                               ? importer.ReadFile(file.string(), kSteps)
                               : importer.ReadFileFromMemory(text.data(), text.size(), kSteps,
                                                             file.extension().c_str());
    if (scene == nullptr) {
        throw InputError(plainWords(importer.GetErrorString()));
    }
    tellLeftOut(*scene, model.remarks);
    // Some versions of assimp turn an FBX at its root, which is not in the file.
    const auto centimetres = settingOf<float>(*scene, "UnitScaleFactor");
    FaceSoup faces =
        facesOf(*scene, centimetres ? aiMatrix4x4() : scene->mRootNode->mTransformation);
    if (faces.faceCount() == 0 && !model.remarks.empty()) {
        throw InputError(model.remarks.front());
    }
    requireFineFloats(faces.positions);
    if (centimetres) {
        requireEndsOfFaces(*scene);
    }
    if (centimetres && *centimetres > 0) {
        model.facts.units = fbxUnits(*scene, *centimetres, faces.positions);
    }
    takeFaces(faces, model);
    addAppearance(*scene, file, model);
    return model;
}

constexpr std::string_view kFbxSpace = " \t\r\n";

/// Takes it off a text, behind blanks and ends of lines. False where it is not there.
bool take(std::string_view what, std::string_view& text) {
    const std::size_t at = text.find_first_not_of(kFbxSpace);
    const bool there = at != std::string_view::npos && text.substr(at).starts_with(what);
    text.remove_prefix(there ? at + what.size() : 0);
    return there;
}

/// An FBX as text says before each list how many numbers it has, "*3 { a: 0,1,2 }", which assimp
/// does not look at. One with commas in its numbers has more.
void requireListLengths(std::string_view text) {
    for (std::size_t at = text.find('*'); at != std::string_view::npos;
         at = text.find('*', at + 1)) {
        std::string_view rest = text.substr(at + 1);
        std::size_t said = 0;
        const char* const end = std::from_chars(rest.data(), rest.data() + rest.size(), said).ptr;
        rest.remove_prefix(std::size_t(end - rest.data()));
        if (!take("{", rest) || !take("a:", rest)) {
            continue;
        }
        const std::string_view list = rest.substr(0, rest.find('}'));
        if (list.size() == rest.size()) {
            return;  // Cut off, which assimp tells.
        }
        const std::size_t commas = std::ranges::count(list, ',');
        const bool any = commas > 0 || list.find_first_not_of(kFbxSpace) != std::string_view::npos;
        const std::size_t there = any ? commas + 1 : 0;
        if (there != said) {
            throw InputError(
                "line " + std::to_string(1 + std::ranges::count(text.substr(0, at), '\n')) +
                ": a list has " + counted(there, "number", "numbers") + ", and should have " +
                std::to_string(said) + "; numbers need points, no commas");
        }
    }
}

ImportedModel readFbx(const std::filesystem::path& file) {
    const std::string bytes = readInputFile(file, kMaxModelBytes);
    if (!bytes.starts_with("Kaydara FBX Binary")) {
        requireListLengths(bytes);
    }
    return readByAssimp(file, "");
}

ImportedModel readDae(const std::filesystem::path& file) {
    return readByAssimp(file, plainDae(readInputFile(file, kMaxModelBytes)));
}

}  // namespace

ImportedModel readModelFile(const std::filesystem::path& file) {
    using Reader = ImportedModel (*)(const std::filesystem::path&);
    static const std::map<std::string, Reader> kReaders{
        {".ply", readPly},   {".obj", readObj},    {".stl", readStl},    {".off", readOff},
        {".gltf", readGltf}, {".glb", readGltf},   {".fbx", readFbx},    {".dae", readDae},
        {".vtk", readVtk},   {".vtp", readVtkXml}, {".vtu", readVtkXml}, {".msh", readGmsh}};
    const auto own = kReaders.find(lowerCase(file.extension().string()));
    return own == kReaders.end() ? readByAssimp(file, "") : own->second(file);
}

std::string plainReason(const std::exception& error) {
    return plainWords(error.what());
}

}  // namespace kerf::app
