#include "app/files/export/export_alembic.h"

#include <spdlog/fmt/fmt.h>

#include "app/files/export/ogawa_file.h"
#include "sim/base/containers.h"
#include "sim/base/math.h"
#include "sim/base/text.h"

namespace kerf::app {
namespace {

using namespace ogawa;  // NOLINT(google-build-using-namespace): names of types alone

constexpr OgawaFile::Schema kXform{"AbcGeom_Xform_v3", ".xform", false};
constexpr OgawaFile::Schema kPolyMesh{"AbcGeom_PolyMesh_v1", ".geom"};
constexpr OgawaFile::Schema kFaceSet{"AbcGeom_FaceSet_v1", ".faceset"};

/// A slash would part names.
std::string objectName(std::string name) {
    std::ranges::replace(name, '/', '_');
    return name.empty() ? "body" : name;
}

/// A number for each corner of each face, which stand clockwise here.
template <class NumberOf>
std::vector<std::uint32_t> ofCorners(const ExportMesh& mesh, NumberOf numberOf) {
    std::vector<std::uint32_t> numbers;
    numbers.reserve(3 * mesh.faces.size());
    for (const ExportFace& face : mesh.faces) {
        for (const int corner : {2, 1, 0}) {
            numbers.push_back(static_cast<std::uint32_t>(numberOf(face, corner)));
        }
    }
    return numbers;
}

std::vector<Vec3f> placesOf(const ExportMesh& mesh) {
    return mapped(mesh.positions, [&](const Vec3f& position) {
        return Vec3f((mesh.origin + position.cast<double>()).cast<float>());
    });
}

/// Of the skin at each vertex, then of the cut faces there: the edge between them is sharp.
std::vector<Vec3f> normalsOf(const ExportMesh& mesh) {
    const std::size_t vertices = mesh.positions.size();
    std::vector<Vec3f> normals(2 * vertices, Vec3f::Zero());
    for (const ExportFace& face : mesh.faces) {
        const auto [a, b, c] = face.corners;
        const Vec3f& at = mesh.positions[a];
        const Vec3f area = (mesh.positions[b] - at).cross(mesh.positions[c] - at);
        for (const int v : face.corners) {
            normals[v + (face.cut ? vertices : 0)] += area;
        }
    }
    for (Vec3f& normal : normals) {
        normal.stableNormalize();
    }
    return normals;
}

/// Each colour once, and which one each corner has.
struct CornerColors {
    explicit CornerColors(const ExportMesh& mesh) {
        std::map<std::pair<int, int>, std::size_t> numbers;  // by material and own colour
        indices = ofCorners(mesh, [&](const ExportFace& face, int corner) {
            const auto [place, isNew] =
                numbers.try_emplace(std::pair(face.material, face.colors[corner]), values.size());
            if (isNew) {
                Eigen::Vector4f color = cornerColor(mesh, face, corner, true);
                color.head<3>() = render::toDisplay(color.head<3>()).cast<float>();
                values.push_back(color);
            }
            return place->second;
        });
    }
    std::vector<Eigen::Vector4f> values;
    std::vector<std::uint32_t> indices;
};

std::vector<std::int32_t> facesOf(const ExportMesh& mesh, int material) {
    std::vector<std::int32_t> faces;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        if (mesh.faces[f].material == material) {
            faces.push_back(static_cast<std::int32_t>(f));
        }
    }
    return faces;
}

}  // namespace

/// The file, and the properties of the body.
struct AlembicCache::State {
    using Property = OgawaFile::Property;

    /// Values, and which of them each corner has.
    struct CornerValues {
        CornerValues(const std::string& name, unsigned numbers, const std::string& interpretation)
            : values{name, kArray | kFloat32 | extent(numbers),
                     fmt::format("arrayExtent=1;geoScope=fvr;interpretation={};isGeomParam=true;"
                                 "podExtent={};podName=float32_t",
                                 interpretation, numbers)} {}
        Property values;
        Property indices{".indices", kArray | kUint32 | extent(1)};
    };

    OgawaFile file;
    std::string name;
    Vec3 origin;
    std::vector<double> times{};
    Property bounds{".selfBnds", kScalar | kFloat64 | extent(6), "interpretation=box"};
    Property positions{"P", kArray | kFloat32 | extent(3), "geoScope=vtx;interpretation=point"};
    Property velocities{".velocities", kArray | kFloat32 | extent(3), "interpretation=vector"};
    Property corners{".faceIndices", kArray | kInt32 | extent(1)};
    Property counts{".faceCounts", kArray | kInt32 | extent(1)};
    CornerValues normals{"N", 3, "normal"};
    CornerValues uvs{"uv", 2, "vector"};
    CornerValues colors{"Cd", 4, "rgba"};
    std::vector<std::pair<std::string, Property>> faceSets{};  ///< by material

    template <class Values>
    void put(Property& property, const Values& values) {
        file.put(property, rawBytesOf(values));
    }

    void putShape(const ExportMesh& mesh, bool moves) {
        const std::vector<Vec3f> places = placesOf(mesh);
        const Bounds box = boxOf(places, [](const Vec3f& p) { return Vec3(p.cast<double>()); });
        put(bounds, std::array{box.low, box.high});
        put(positions, places);
        put(velocities, moves ? mesh.velocities : std::vector(places.size(), Vec3f(0, 0, 0)));
        put(corners, ofCorners(mesh, [](const auto& face, int i) { return face.corners[i]; }));
        put(counts, std::vector<std::int32_t>(mesh.faces.size(), 3));
    }

    void putLooks(const ExportMesh& mesh) {
        put(normals.values, normalsOf(mesh));
        put(normals.indices, ofCorners(mesh, [&](const ExportFace& face, int i) {
                return face.corners[i] + (face.cut ? mesh.positions.size() : 0);
            }));
        std::vector<Eigen::Vector2f> places = mesh.uvs;
        places.emplace_back(0, 0);  // of corners that have none
        put(uvs.values, places);
        put(uvs.indices, ofCorners(mesh, [&](const ExportFace& face, int i) {
                return face.uvs[i] < 0 ? mesh.uvs.size() : face.uvs[i];
            }));
        const CornerColors painted(mesh);
        put(colors.values, painted.values);
        put(colors.indices, painted.indices);
    }

    void putFaceSets(const ExportMesh& mesh) {
        for (std::size_t m = 0; m < mesh.materials.size(); ++m) {
            if (times.empty()) {
                faceSets.emplace_back(objectName(mesh.materials[m].name),
                                      Property{".faces", kArray | kInt32 | extent(1)});
            }
            put(faceSets[m].second, facesOf(mesh, static_cast<int>(m)));
        }
    }

    OgawaMember close(const CornerValues& corner) {
        Property inside = corner.values;
        inside.name = ".vals";
        const std::array members{file.close(inside), file.close(corner.indices)};
        return file.compound(corner.values.name, corner.values.metadata, members);
    }

    OgawaMember closeMesh(const ContentDigest& digest) {
        std::vector<OgawaMember> sets;
        for (const auto& [material, faces] : faceSets) {
            // Its bounds are those of the mesh: readers ask for some.
            const std::array members{file.close(bounds), file.close(faces)};
            sets.push_back(file.object(material, kFaceSet, members, {}, digest));
        }
        const OgawaMember painted = close(colors);
        const std::array members{file.close(bounds),
                                 file.close(positions),
                                 file.close(velocities),
                                 file.close(corners),
                                 file.close(counts),
                                 close(normals),
                                 close(uvs),
                                 file.compound(".arbGeomParams", "", {&painted, 1})};
        return file.object(name + "Shape", kPolyMesh, members, sets, digest);
    }

    OgawaMember closeConstant(const std::string& called, unsigned type, std::string_view bytes) {
        Property property{called, type};
        file.put(property, bytes);
        return file.close(property);
    }

    /// The object around the mesh, which says where its positions are counted from.
    OgawaMember closePlace(const ContentDigest& digest) {
        const OgawaMember mesh = closeMesh(digest);
        const std::array members{
            closeConstant(".inherits", kScalar | kBool | extent(1), "\1"),
            closeConstant(".ops", kScalar | kUint8 | extent(1), "\x10"),  // a translation
            closeConstant(".vals", kScalar | kFloat64 | extent(3), rawBytesOf(origin)),
            closeConstant("isNotConstantIdentity", kScalar | kBool | extent(1), "\1")};
        return file.object(name, kXform, members, {&mesh, 1}, digest);
    }
};

bool isCacheFile(const std::filesystem::path& file) {
    return lowerCase(file.extension().string()) == ".abc";
}

AlembicCache::AlembicCache(const std::filesystem::path& file, const std::string& name,
                           const Vec3& origin)
    : state_(new State{OgawaFile(file), objectName(name), origin}) {}

AlembicCache::~AlembicCache() = default;

int AlembicCache::samples() const {
    return static_cast<int>(state_->times.size());
}

void AlembicCache::add(double time, const ExportMesh& mesh, bool moves) {
    state_->putShape(mesh, moves);
    state_->putLooks(mesh);
    state_->putFaceSets(mesh);
    state_->times.push_back(time);
}

void AlembicCache::finish() {
    // Of the places of all samples, and of what the last one looks like.
    const ContentDigest digest = digestOf(std::string(rawBytesOf(state_->positions.samples))
                                              .append(rawBytesOf(state_->positions.digest))
                                              .append(rawBytesOf(state_->colors.values.digest)));
    state_->file.finish(state_->closePlace(digest), state_->times, digest);
}

}  // namespace kerf::app
