#include "app/files/export/export_gltf.h"

#include <bit>
#include <nlohmann/json.hpp>

#include "app/files/export/companion_names.h"
#include "app/files/io/encodings.h"
#include "sim/mesh/triangle.h"

namespace kerf::app {
namespace {

using Json = nlohmann::ordered_json;

// Numbers of the glTF 2.0 specification.
constexpr int kFloat = 5126;
constexpr int kUnsignedInt = 5125;
constexpr int kArrayBuffer = 34962;
constexpr int kElementArrayBuffer = 34963;
constexpr std::uint32_t kGlbMagic = 0x46546C67;
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;
constexpr std::uint32_t kBinaryChunk = 0x004E4942;

static_assert(std::endian::native == std::endian::little, "buffers are written as they lie");

/// Vertices of a primitive: a corner with another texture coordinate or colour is another one.
struct Primitive {
    std::vector<Vec3f> positions;
    std::vector<float> vertices;  ///< of the whole mesh: where two walls of a cut lie on each other
    std::vector<Vec3f> normals;
    std::vector<Eigen::Vector2f> uvs;     ///< empty where there are none
    std::vector<Eigen::Vector4f> colors;  ///< empty where there are none
    std::vector<Vec3f> velocities;        ///< empty where they are not told
    std::vector<float> strains;           ///< means of the faces at a vertex; empty as velocities
    std::vector<std::uint32_t> indices;
};

/// Of the faces of this part alone: sharp towards other parts.
std::vector<Vec3f> normalsWithin(const ExportMesh& part) {
    std::vector<Vec3f> sums(part.positions.size(), Vec3f::Zero());
    for (const ExportFace& face : part.faces) {
        const auto& [a, b, c] = face.corners;
        for (const int v : face.corners) {
            sums[v] += areaNormal(part.positions[a], part.positions[b], part.positions[c]);
        }
    }
    for (std::size_t v = 0; v < sums.size(); ++v) {
        const bool cancels = sums[v].norm() < 1e-20F;  // both walls at the front of a slit
        sums[v] = cancels ? part.normals[v] : Vec3f(sums[v].stableNormalized());
    }
    return sums;
}

/// By position: the mean of the faces of this part there.
std::vector<float> strainsWithin(const ExportMesh& part) {
    std::vector<float> sums(part.positions.size(), 0);
    std::vector<float> counts(part.positions.size(), 0);
    for (const ExportFace& face : part.faces) {
        for (const int v : face.corners) {
            sums[v] += face.strain;
            counts[v] += 1;
        }
    }
    for (std::size_t v = 0; v < sums.size(); ++v) {
        sums[v] /= std::max(counts[v], 1.0F);
    }
    return sums;
}

Primitive primitiveOf(const ExportMesh& part) {
    Primitive out;
    const std::vector<float> strains = strainsWithin(part);
    std::map<std::array<int, 3>, std::uint32_t> numbers;  // by position, coordinate and colour
    for (const ExportFace& face : part.faces) {
        for (int i = 0; i < 3; ++i) {
            const int v = face.corners[i];
            const auto next = static_cast<std::uint32_t>(out.positions.size());
            const auto [place, isNew] = numbers.try_emplace({v, face.uvs[i], face.colors[i]}, next);
            if (isNew) {
                out.positions.push_back(part.positions[v]);
                out.vertices.push_back(static_cast<float>(part.vertices[v]));
                out.normals.push_back(part.normals[v]);
                if (part.tellsQuantities) {
                    out.velocities.push_back(part.velocities[v]);
                    out.strains.push_back(strains[v]);
                }
                if (!part.uvs.empty()) {
                    // v runs downwards in glTF.
                    const Eigen::Vector2f& uv = part.uvs[face.uvs[i]];
                    out.uvs.emplace_back(uv.x(), 1 - uv.y());
                }
                if (!part.colors.empty()) {
                    out.colors.push_back(part.colors[face.colors[i]]);
                }
            }
            out.indices.push_back(place->second);
        }
    }
    return out;
}

/// The JSON and the buffer of a file, as they grow.
class GltfOutput {
  public:
    /// `images`: the names of their files; null where they go into the buffer.
    GltfOutput(const ExportMesh& mesh, const std::vector<std::string>* images) {
        json_["asset"] = {{"version", "2.0"}, {"generator", "Kerf"}};
        json_["scene"] = 0;
        json_["scenes"] = Json::array({{{"nodes", Json::array()}}});
        if (images != nullptr) {
            bytes_ = kCompanionMark;  // a file of its own
        }
        for (const render::SurfaceMaterial& material : mesh.materials) {
            Json json = toJson(material, mesh, images);  // adds to other lists itself
            json_["materials"].push_back(std::move(json));
        }
    }

    void addPiece(const ExportMesh& mesh, int piece) {
        const ExportMesh whole =
            partOf(mesh, [&](const ExportFace& face) { return face.piece == piece; });
        Json primitives = Json::array();
        for (const bool cut : {false, true}) {
            ExportMesh part =
                partOf(whole, [&](const ExportFace& face) { return face.cut == cut; });
            part.normals = normalsWithin(part);
            addByMaterial(part, primitives);
        }
        const std::string name = "piece_" + std::to_string(piece + 1);
        const std::size_t index = json_["meshes"].size();
        json_["meshes"].push_back({{"name", name}, {"primitives", primitives}});
        json_["nodes"].push_back({{"name", name}, {"mesh", index}});
        if (mesh.origin != Vec3::Zero()) {
            json_["nodes"].back()["translation"] = {mesh.origin.x(), mesh.origin.y(),
                                                    mesh.origin.z()};
        }
        if (mesh.tellsQuantities) {
            json_["nodes"].back()["extras"] = {{"volume", mesh.pieceVolumes[piece]}};
        }
        json_["scenes"][0]["nodes"].push_back(index);
    }

    /// Where the buffer is; "" for the one beside the JSON.
    std::string text(const std::string& uri) {
        Json buffer = {{"byteLength", bytes_.size()}};
        if (!uri.empty()) {
            buffer["uri"] = uri;
        }
        json_["buffers"] = Json::array({buffer});
        return json_.dump(-1, ' ', false, Json::error_handler_t::replace);
    }
    const std::string& bytes() const { return bytes_; }

  private:
    void addByMaterial(const ExportMesh& part, Json& primitives) {
        std::set<int> materials;
        for (const ExportFace& face : part.faces) {
            materials.insert(face.material);
        }
        for (const int material : materials) {
            const auto has = [&](const ExportFace& face) { return face.material == material; };
            primitives.push_back(add(primitiveOf(partOf(part, has)), material));
        }
    }

    Json toJson(const render::SurfaceMaterial& material, const ExportMesh& mesh,
                const std::vector<std::string>* images) {
        const Eigen::Vector4f color = render::shownColor(material);
        Json pbr = {{"baseColorFactor", std::vector<float>(color.begin(), color.end())},
                    {"metallicFactor", material.metallic},
                    {"roughnessFactor", material.roughness}};
        if (material.image >= 0) {
            pbr["baseColorTexture"] = {{"index", textureOf(material.image, mesh, images)}};
        }
        return {{"name", material.name}, {"pbrMetallicRoughness", pbr}};
    }

    int textureOf(int image, const ExportMesh& mesh, const std::vector<std::string>* names) {
        const auto next = static_cast<int>(textures_.size());
        const auto [place, isNew] = textures_.try_emplace(image, next);
        if (isNew) {
            const render::ModelImage& from = mesh.appearance->images[image];
            Json json =
                names == nullptr ? inBuffer(from) : Json::object({{"uri", (*names)[image]}});
            json_["images"].push_back(std::move(json));
            json_["textures"].push_back({{"source", next}});
        }
        return place->second;
    }

    Json inBuffer(const render::ModelImage& image) {
        json_["bufferViews"].push_back(
            {{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", image.bytes.size()}});
        bytes_ += image.bytes;
        bytes_.resize((bytes_.size() + 3) / 4 * 4, '\0');
        return {{"name", image.name},
                {"mimeType", std::string(mediaTypeOf(render::kindOfImage(image.bytes)))},
                {"bufferView", json_["bufferViews"].size() - 1}};
    }

    Json add(const Primitive& primitive, int material) {
        Json attributes;
        attributes["POSITION"] = addVectors(primitive.positions, "VEC3", true);
        attributes["NORMAL"] = addVectors(primitive.normals, "VEC3", false);
        attributes["_VERTEX"] = addScalars(primitive.vertices);
        if (!primitive.uvs.empty()) {
            attributes["TEXCOORD_0"] = addVectors(primitive.uvs, "VEC2", false);
        }
        if (!primitive.colors.empty()) {
            attributes["COLOR_0"] = addVectors(primitive.colors, "VEC4", false);
        }
        if (!primitive.velocities.empty()) {
            attributes["_VELOCITY"] = addVectors(primitive.velocities, "VEC3", false);
            attributes["_STRAIN"] = addScalars(primitive.strains);
        }
        const int view = addView(primitive.indices, kElementArrayBuffer);
        const int indices = addAccessor({{"bufferView", view},
                                         {"componentType", kUnsignedInt},
                                         {"count", primitive.indices.size()},
                                         {"type", "SCALAR"}});
        return {{"attributes", attributes}, {"indices", indices}, {"material", material}};
    }

    template <class Vector>
    int addVectors(const std::vector<Vector>& vectors, const char* type, bool withBounds) {
        static_assert(sizeof(Vector) == Vector::SizeAtCompileTime * sizeof(float));
        Json accessor = {{"bufferView", addView(vectors, kArrayBuffer)},
                         {"componentType", kFloat},
                         {"count", vectors.size()},
                         {"type", type}};
        if (withBounds) {
            Vector low = vectors.front();
            Vector high = vectors.front();
            for (const Vector& v : vectors) {
                low = low.cwiseMin(v);
                high = high.cwiseMax(v);
            }
            accessor["min"] = std::vector<float>(low.begin(), low.end());
            accessor["max"] = std::vector<float>(high.begin(), high.end());
        }
        return addAccessor(std::move(accessor));
    }

    int addScalars(const std::vector<float>& values) {
        return addAccessor({{"bufferView", addView(values, kArrayBuffer)},
                            {"componentType", kFloat},
                            {"count", values.size()},
                            {"type", "SCALAR"}});
    }

    int addAccessor(Json accessor) {
        json_["accessors"].push_back(std::move(accessor));
        return static_cast<int>(json_["accessors"].size()) - 1;
    }

    /// All items are multiples of four bytes, as the format wants it.
    template <class Item>
    int addView(const std::vector<Item>& items, int target) {
        static_assert(sizeof(Item) % 4 == 0);
        const std::size_t length = items.size() * sizeof(Item);
        json_["bufferViews"].push_back({{"buffer", 0},
                                        {"byteOffset", bytes_.size()},
                                        {"byteLength", length},
                                        {"target", target}});
        bytes_.append(reinterpret_cast<const char*>(items.data()), length);
        return static_cast<int>(json_["bufferViews"].size()) - 1;
    }

    Json json_;
    std::string bytes_;
    std::map<int, int> textures_;  // by image
};

GltfOutput gather(const ExportMesh& mesh, const std::vector<std::string>* images = nullptr) {
    int pieces = 0;
    int first = mesh.faces.empty() ? 0 : mesh.faces.front().piece;
    for (const ExportFace& face : mesh.faces) {
        pieces = std::max(pieces, face.piece + 1);
        first = std::min(first, face.piece);
    }
    GltfOutput file(mesh, images);
    for (int piece = first; piece < pieces; ++piece) {
        file.addPiece(mesh, piece);
    }
    return file;
}

void append(std::string& bytes, std::uint32_t value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

void appendChunk(std::string& bytes, std::uint32_t type, std::string content, char padding) {
    content.resize((content.size() + 3) / 4 * 4, padding);
    append(bytes, static_cast<std::uint32_t>(content.size()));
    append(bytes, type);
    bytes += content;
}

}  // namespace

std::string encodeGlb(const ExportMesh& mesh) {
    GltfOutput file = gather(mesh);
    std::string chunks;
    appendChunk(chunks, kJsonChunk, file.text(""), ' ');
    appendChunk(chunks, kBinaryChunk, file.bytes(), '\0');
    std::string bytes;
    append(bytes, kGlbMagic);
    append(bytes, 2);
    append(bytes, static_cast<std::uint32_t>(12 + chunks.size()));
    return bytes + chunks;
}

std::string encodeGltf(const ExportMesh& mesh) {
    GltfOutput file = gather(mesh);
    return file.text("data:application/octet-stream;base64," + base64(file.bytes()));
}

std::string encodeGltfBeside(const ExportMesh& mesh, const std::vector<std::string>& images,
                             const std::function<std::string(std::string)>& nameOf) {
    GltfOutput file = gather(mesh, &images);
    return file.text(nameOf(file.bytes()));
}

}  // namespace kerf::app
