// From top to bottom: places of nodes; materials; primitives; the scene.

#include <Eigen/Geometry>

#include "app/files/io/errors.h"
#include "app/files/io/file_io.h"
#include "app/import/appearance_reader.h"
#include "app/import/face_soup.h"
#include "app/import/gltf_file.h"
#include "sim/base/text.h"

namespace kerf::app {
namespace {

using Json = GltfFile::Json;
using Transform = Eigen::Affine3d;

/// Extensions that change the shape of what has them, and are not read.
constexpr std::array<std::string_view, 2> kUnreadable{"KHR_draco_mesh_compression",
                                                      "EXT_mesh_gpu_instancing"};
/// What is in the names of extensions that a file may need: they are read, or change no shape.
constexpr std::array<std::string_view, 6> kHarmless{
    "KHR_mesh_quantization", "_materials_", "_texture_", "_lights_", "_xmp", "_animation_"};

const Json* find(const Json& object, const char* key) {
    const auto found = object.is_object() ? object.find(key) : object.end();
    return found == object.end() ? nullptr : &*found;
}

const Json* extensionOf(const Json& object, std::string_view name) {
    const Json* all = find(object, "extensions");
    return all == nullptr ? nullptr : find(*all, std::string(name).c_str());
}

[[noreturn]] void refuse(std::string_view extension) {
    throw InputError("it needs the glTF extension " + printable(std::string(extension)) +
                     ", which Kerf does not know; export it without");
}

void refuseUnreadable(const Json& object) {
    for (const std::string_view name : kUnreadable) {
        if (extensionOf(object, name) != nullptr) {
            refuse(name);
        }
    }
}

std::vector<double> listOf(const Json& object, const char* key, std::vector<double> otherwise) {
    const std::size_t count = otherwise.size();
    std::vector<double> list = valueOf(object, key, std::move(otherwise));
    if (list.size() != count) {
        throw InputError("its \"" + std::string(key) + "\" is not what glTF has there");
    }
    return list;
}

std::vector<std::uint64_t> indicesOf(const Json& object, const char* key) {
    return valueOf(object, key, std::vector<std::uint64_t>{});
}

std::optional<std::uint64_t> indexOf(const Json& object, const char* key) {
    return find(object, key) == nullptr ? std::nullopt
                                        : std::optional(valueOf<std::uint64_t>(object, key, 0));
}

// --- Places of nodes ----------------------------------------------------------------------------

Transform transformOf(const Json& node) {
    Transform own = Transform::Identity();
    if (find(node, "matrix") != nullptr) {
        const std::vector<double> matrix = listOf(node, "matrix", std::vector<double>(16));
        own.matrix() = Eigen::Map<const Eigen::Matrix4d>(matrix.data());
        return own;
    }
    const std::vector<double> t = listOf(node, "translation", {0, 0, 0});
    const std::vector<double> r = listOf(node, "rotation", {0, 0, 0, 1});
    const std::vector<double> s = listOf(node, "scale", {1, 1, 1});
    return own.translate(Vec3(t[0], t[1], t[2]))
        .rotate(Eigen::Quaterniond(r[3], r[0], r[1], r[2]).normalized())
        .scale(Vec3(s[0], s[1], s[2]));
}

/// The nodes that a scene shows, and where they stand.
class GltfNodes {
  public:
    explicit GltfNodes(const GltfFile& file) : file_(file) {
        for (const std::uint64_t root : roots()) {
            place(root, Transform::Identity());
        }
    }

    const std::map<std::uint64_t, Transform>& places() const { return places_; }
    /// Of a joint, which must hang in the scene as its mesh does: else its place is not known.
    Transform placeOf(std::uint64_t node) const {
        const auto found = places_.find(node);
        if (found == places_.end()) {
            throw InputError("its joint " + std::to_string(node) + " is not in the scene");
        }
        return found->second;
    }

  private:
    std::vector<std::uint64_t> roots() const {
        const Json* scenes = find(file_.top(), "scenes");
        if (scenes != nullptr && !scenes->empty()) {
            const auto shown = valueOf<std::uint64_t>(file_.top(), "scene", 0);
            return indicesOf(file_.item("scenes", shown), "nodes");
        }
        const Json* nodes = find(file_.top(), "nodes");
        std::vector<bool> isChild(nodes == nullptr ? 0 : nodes->size(), false);
        for (std::size_t n = 0; n < isChild.size(); ++n) {
            for (const std::uint64_t child : indicesOf(file_.item("nodes", n), "children")) {
                if (child < isChild.size()) isChild[child] = true;
            }
        }
        std::vector<std::uint64_t> roots;
        for (std::size_t n = 0; n < isChild.size(); ++n) {
            if (!isChild[n]) roots.push_back(n);
        }
        return roots;
    }

    /// A node has one parent: one that is met again would have itself for an ancestor.
    void place(std::uint64_t root, const Transform& parent) {
        std::vector<std::pair<std::uint64_t, Transform>> waiting{{root, parent}};
        while (!waiting.empty()) {
            const auto [index, above] = waiting.back();
            waiting.pop_back();
            const Json& node = file_.item("nodes", index);
            const Transform here = above * transformOf(node);
            if (!places_.try_emplace(index, here).second) {
                throw InputError("its node " + std::to_string(index) + " hangs at two others");
            }
            for (const std::uint64_t child : indicesOf(node, "children")) {
                waiting.emplace_back(child, here);
            }
        }
    }

    const GltfFile& file_;
    std::map<std::uint64_t, Transform> places_;
};

// --- Materials ----------------------------------------------------------------------------------

/// Which texture coordinates a material takes, and how.
struct TextureUse {
    std::uint64_t set = 0;
    Eigen::Affine2d transform = Eigen::Affine2d::Identity();
};

class GltfMaterials {
  public:
    GltfMaterials(const GltfFile& file, const std::filesystem::path& path, ImportedModel& model)
        : file_(file), model_(model), images_(path, model) {}

    /// Its number among those of the model; kNone for one that says nothing.
    int numberOf(std::uint64_t index) {
        const auto [place, isNew] = numbers_.try_emplace(index, FaceSoup::kNone);
        if (isNew) {
            place->second = orRemark("A material was left out: ",
                                     [&] { return add(file_.item("materials", index), index); });
        }
        return place->second;
    }
    TextureUse useOf(std::uint64_t index) const {
        const auto found = uses_.find(index);
        return found == uses_.end() ? TextureUse{} : found->second;
    }

  private:
    /// What `add` returns; -1 where it throws, which is a remark: the shape is right without it.
    int orRemark(const std::string& what, const std::function<int()>& add) {
        try {
            return add();
        } catch (const InputError& error) {
            model_.remarks.push_back(what + error.what() + ".");
            return FaceSoup::kNone;
        }
    }

    int add(const Json& from, std::uint64_t index) {
        static const Json kNothing = Json::object();
        const Json* const old = extensionOf(from, "KHR_materials_pbrSpecularGlossiness");
        const Json* const own = find(from, "pbrMetallicRoughness");
        const Json& look = own != nullptr ? *own : old != nullptr ? *old : kNothing;
        const bool isOld = own == nullptr && old != nullptr;
        render::SurfaceMaterial material;
        material.name = valueOf<std::string>(from, "name", "");
        const std::vector<double> color =
            listOf(look, isOld ? "diffuseFactor" : "baseColorFactor", {1, 1, 1, 1});
        material.baseColor = Eigen::Map<const Eigen::Vector4d>(color.data()).cast<float>();
        const double roughness = isOld ? 1 - valueOf<double>(look, "glossinessFactor", 1)
                                       : valueOf<double>(look, "roughnessFactor", 1);
        material.roughness = static_cast<float>(std::clamp(roughness, 0.0, 1.0));
        const double metallic = isOld ? 0 : valueOf<double>(look, "metallicFactor", 1);
        material.metallic = static_cast<float>(std::clamp(metallic, 0.0, 1.0));
        if (const Json* texture = find(look, isOld ? "diffuseTexture" : "baseColorTexture")) {
            material.image = orRemark(
                "The image of the material \"" + printable(material.name) + "\" was left out: ",
                [&] { return imageOf(*texture, material.name); });
            uses_[index] = useOf(*texture);
        }
        const bool plain = material.name.empty() && material.image < 0 &&
                           material.baseColor == Eigen::Vector4f::Ones();
        return plain ? FaceSoup::kNone : images_.add(std::move(material), "");
    }

    static TextureUse useOf(const Json& texture) {
        TextureUse use{valueOf<std::uint64_t>(texture, "texCoord", 0)};
        if (const Json* moved = extensionOf(texture, "KHR_texture_transform")) {
            const std::vector<double> offset = listOf(*moved, "offset", {0, 0});
            const std::vector<double> scale = listOf(*moved, "scale", {1, 1});
            use.set = valueOf<std::uint64_t>(*moved, "texCoord", use.set);
            use.transform.translate(Vec2(offset[0], offset[1]))
                .rotate(Eigen::Rotation2Dd(-valueOf<double>(*moved, "rotation", 0)))
                .scale(Vec2(scale[0], scale[1]));
        }
        return use;
    }

    int imageOf(const Json& use, const std::string& material) {
        const Json& texture = file_.item("textures", valueOf<std::uint64_t>(use, "index", 0));
        const std::optional<std::uint64_t> source = indexOf(texture, "source");
        if (!source) {
            throw InputError("it is neither PNG nor JPEG");
        }
        const Json& image = file_.item("images", *source);
        return images_.numberOf(std::to_string(*source), [&] { return read(image, material); });
    }

    /// A name that tells the kind, as of a file.
    render::ModelImage read(const Json& image, const std::string& material) const {
        const auto uri = valueOf<std::string>(image, "uri", "");
        const std::optional<std::uint64_t> view = indexOf(image, "bufferView");
        if (!view && !uri.starts_with("data:")) {
            return images_.read(unescaped(uri), material);
        }
        const auto name = valueOf<std::string>(image, "name", material);
        return {std::filesystem::path(name).filename().string(),
                view ? std::string(file_.view(*view)) : file_.bytesOf(uri),
                {}};
    }

    const GltfFile& file_;
    ImportedModel& model_;
    ModelImages images_;
    std::map<std::uint64_t, int> numbers_;
    std::map<std::uint64_t, TextureUse> uses_;
};

// --- Primitives ---------------------------------------------------------------------------------

std::vector<Vec3> vectorsOf(const std::vector<double>& numbers) {
    std::vector<Vec3> vectors;
    vectors.reserve(numbers.size() / 3);
    for (std::size_t i = 0; i + 2 < numbers.size(); i += 3) {
        vectors.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
    }
    return vectors;
}

/// Where a mesh is put.
struct GltfInstance {
    Transform node;
    std::optional<std::uint64_t> skin;
    std::vector<double> weights;  ///< of its morph targets
};

class GltfMeshes {
  public:
    GltfMeshes(const GltfFile& file, const GltfNodes& nodes, GltfMaterials& materials)
        : file_(file), nodes_(nodes), materials_(materials) {}

    void add(std::uint64_t index, GltfInstance place) {
        const Json& mesh = file_.item("meshes", index);
        if (place.weights.empty()) {
            place.weights = valueOf(mesh, "weights", std::vector<double>{});
        }
        const Json* const primitives = find(mesh, "primitives");
        for (std::size_t i = 0; primitives != nullptr && i < primitives->size(); ++i) {
            addPrimitive((*primitives)[i], place);
        }
    }
    FaceSoup& faces() { return faces_; }

  private:
    void addPrimitive(const Json& primitive, const GltfInstance& place) {
        refuseUnreadable(primitive);
        constexpr int kTriangles = 4;
        constexpr int kFan = 6;
        const int mode = valueOf<int>(primitive, "mode", kTriangles);
        if (mode < 0 || mode > kFan) {
            throw InputError("a primitive has the unknown mode " + std::to_string(mode));
        }
        const Json* const attributes = find(primitive, "attributes");
        const auto position =
            attributes == nullptr ? std::nullopt : indexOf(*attributes, "POSITION");
        if (!position || mode < kTriangles) {
            return;  // Points and lines, or nothing at all.
        }
        std::vector<Vec3> points = vectorsOf(file_.numbers(*position, 3));
        requireFineFloats(points);
        morph(primitive, place.weights, points);
        const bool mirrored = put(*attributes, place, points);
        const std::size_t first = faces_.positions.size();
        faces_.positions.insert(faces_.positions.end(), points.begin(), points.end());
        addAliases(*attributes, first);
        const std::optional<std::uint64_t> material = indexOf(primitive, "material");
        const int number = material ? materials_.numberOf(*material) : FaceSoup::kNone;
        addUvs(*attributes, material ? materials_.useOf(*material) : TextureUse{}, first);
        addColors(*attributes, first);
        addFaces(cornersOf(primitive, points.size()), mode - kTriangles, mirrored,
                 static_cast<int>(first), number);
    }

    void morph(const Json& primitive, const std::vector<double>& weights,
               std::vector<Vec3>& points) const {
        const Json* const targets = find(primitive, "targets");
        const std::size_t count = targets == nullptr ? 0 : targets->size();
        for (std::size_t t = 0; t < std::min(count, weights.size()); ++t) {
            const auto moved = indexOf((*targets)[t], "POSITION");
            if (weights[t] == 0 || !moved) {
                continue;
            }
            const std::vector<Vec3> by = vectorsOf(file_.numbers(*moved, 3));
            for (std::size_t v = 0; v < std::min(by.size(), points.size()); ++v) {
                points[v] += weights[t] * by[v];
            }
        }
    }

    /// Brings points into the scene. True where that mirrors them.
    bool put(const Json& attributes, const GltfInstance& place, std::vector<Vec3>& points) const {
        if (place.skin && find(attributes, "JOINTS_0") != nullptr) {
            return putBySkin(attributes, *place.skin, points);
        }
        for (Vec3& point : points) {
            point = place.node * point;
        }
        return place.node.linear().determinant() < 0;
    }

    std::vector<Transform> jointsOf(std::uint64_t index) const {
        const Json& skin = file_.item("skins", index);
        const std::vector<std::uint64_t> joints = indicesOf(skin, "joints");
        const auto inverse = indexOf(skin, "inverseBindMatrices");
        const std::vector<double> numbers =
            inverse ? file_.numbers(*inverse, 16) : std::vector<double>{};
        std::vector<Transform> transforms;
        for (std::size_t j = 0; j < joints.size(); ++j) {
            Transform& joint = transforms.emplace_back(nodes_.placeOf(joints[j]));
            if (16 * (j + 1) <= numbers.size()) {
                Transform bind;
                bind.matrix() = Eigen::Map<const Eigen::Matrix4d>(numbers.data() + 16 * j);
                joint = joint * bind;
            }
        }
        return transforms;
    }

    /// By the joints alone: the node of a skinned mesh has no say.
    bool putBySkin(const Json& attributes, std::uint64_t skin, std::vector<Vec3>& points) const {
        const std::vector<Transform> joints = jointsOf(skin);
        std::vector<Eigen::Matrix4d> sums(points.size(), Eigen::Matrix4d::Zero());
        for (int set = 0;; ++set) {
            const std::string number = std::to_string(set);
            const auto which = indexOf(attributes, ("JOINTS_" + number).c_str());
            const auto much = indexOf(attributes, ("WEIGHTS_" + number).c_str());
            if (!which || !much) {
                break;
            }
            const std::vector<double> names = file_.numbers(*which, 4);
            const std::vector<double> weights = file_.numbers(*much, 4);
            const std::size_t count = std::min({names.size(), weights.size(), 4 * points.size()});
            for (std::size_t i = 0; i < count; ++i) {
                if (weights[i] != 0 && !(names[i] < static_cast<double>(joints.size()))) {
                    throw InputError("a vertex hangs at a joint that is not there");
                }
                if (weights[i] != 0) {
                    sums[i / 4] += weights[i] * joints[static_cast<std::size_t>(names[i])].matrix();
                }
            }
        }
        for (std::size_t v = 0; v < points.size(); ++v) {
            const double weight = sums[v](3, 3);
            points[v] = weight == 0 ? points[v]
                                    : Vec3((sums[v] * points[v].homogeneous()).head<3>() / weight);
        }
        return !sums.empty() && sums.front().topLeftCorner<3, 3>().determinant() < 0;
    }

    /// Exports of Kerf number the vertices of the body, of which walls of a cut may have two at one
    /// place.
    void addAliases(const Json& attributes, std::size_t first) {
        const auto accessor = indexOf(attributes, "_VERTEX");
        const bool ours = accessor && valueOf<std::string>(file_.item("accessors", *accessor),
                                                           "type", "") == "SCALAR";
        const std::vector<double> numbers =
            ours ? file_.numbers(*accessor, 1) : std::vector<double>{};
        for (std::size_t v = first; v < faces_.positions.size(); ++v) {
            const int own = static_cast<int>(v);
            int same = own;
            if (v - first < numbers.size()) {
                same = vertices_.try_emplace(numbers[v - first], own).first->second;
            }
            faces_.aliases.push_back(faces_.positions[same] == faces_.positions[v] ? same : own);
        }
    }

    /// v runs downwards in glTF.
    void addUvs(const Json& attributes, const TextureUse& use, std::size_t first) {
        const auto accessor = indexOf(attributes, ("TEXCOORD_" + std::to_string(use.set)).c_str());
        if (!accessor) {
            return;
        }
        const std::vector<double> numbers = file_.numbers(*accessor, 2);
        faces_.vertexUvs.resize(first, Vec2::Zero());
        for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) {
            const Vec2 uv = use.transform * Vec2(numbers[i], numbers[i + 1]);
            faces_.vertexUvs.emplace_back(uv.x(), 1 - uv.y());
        }
    }

    /// Of three numbers or four, in linear light.
    void addColors(const Json& attributes, std::size_t first) {
        const auto accessor = indexOf(attributes, "COLOR_0");
        if (!accessor) {
            return;
        }
        const std::string type =
            valueOf<std::string>(file_.item("accessors", *accessor), "type", "");
        const std::size_t width = type == "VEC3" ? 3 : 4;
        const std::vector<double> numbers = file_.numbers(*accessor, width);
        faces_.vertexColors.resize(first, Eigen::Vector4f::Ones());
        for (std::size_t i = 0; i + width <= numbers.size(); i += width) {
            const double opacity = width == 4 ? numbers[i + 3] : 1;
            faces_.vertexColors.push_back(
                Eigen::Vector4d(numbers[i], numbers[i + 1], numbers[i + 2], opacity).cast<float>());
        }
    }

    std::vector<int> cornersOf(const Json& primitive, std::size_t points) const {
        std::vector<int> corners;
        if (const auto accessor = indexOf(primitive, "indices")) {
            for (const double number : file_.numbers(*accessor, 1)) {
                corners.push_back(cornerOf(number));
                if (corners.back() < 0 || corners.back() >= static_cast<int>(points)) {
                    throw InputError("a triangle names vertex " + formatNumber(number) +
                                     ", counted from 0, and there are " + std::to_string(points));
                }
            }
        } else {
            for (std::size_t i = 0; i < points; ++i) {
                corners.push_back(static_cast<int>(i));
            }
        }
        return corners;
    }

    /// `kind`: 0 for triangles, 1 for a strip of them, 2 for a fan.
    void addFaces(const std::vector<int>& corners, int kind, bool mirrored, int first,
                  int material) {
        const std::size_t step = kind == 0 ? 3 : 1;
        for (std::size_t i = 0; i + 2 < corners.size(); i += step) {
            const bool turned = mirrored != (kind == 1 && i % 2 == 1);
            const int a = corners[kind == 2 ? 0 : i];
            const int b = corners[i + (turned ? 2 : 1)];
            const int c = corners[i + (turned ? 1 : 2)];
            for (const int v : {a, b, c}) {
                faces_.addCorner(first + v);
            }
            faces_.endFace(material);
        }
    }

    const GltfFile& file_;
    const GltfNodes& nodes_;
    GltfMaterials& materials_;
    FaceSoup faces_;
    std::map<double, int> vertices_;  ///< the first of each number
};

void refuseNeeded(const GltfFile& file) {
    for (const std::string& name :
         valueOf(file.top(), "extensionsRequired", std::vector<std::string>{})) {
        if (std::ranges::none_of(kHarmless, [&](std::string_view part) {
                return name.find(part) != std::string::npos;
            })) {
            refuse(name);
        }
    }
}

}  // namespace

ImportedModel readGltf(const std::filesystem::path& path) {
    GltfFile file(path);
    refuseNeeded(file);
    file.openBuffers();
    ImportedModel model;
    const GltfNodes nodes(file);
    GltfMaterials materials(file, path, model);
    GltfMeshes meshes(file, nodes, materials);
    for (const auto& [index, place] : nodes.places()) {
        const Json& node = file.item("nodes", index);
        refuseUnreadable(node);
        if (const auto mesh = indexOf(node, "mesh")) {
            meshes.faces().beginObject(valueOf<std::string>(node, "name", ""));
            meshes.add(*mesh, {place, indexOf(node, "skin"),
                               valueOf(node, "weights", std::vector<double>{})});
        }
    }
    takeFaces(meshes.faces(), model);
    if (model.appearance.materials.empty()) {
        model.soup.skin.materials.clear();
    }
    return model;
}

}  // namespace kerf::app
