#include "app/files/export/export.h"

#include <bit>
#include <tuple>

#include "app/files/export/companion_names.h"
#include "app/files/export/export_gltf.h"
#include "app/files/export/export_vtp.h"
#include "app/files/io/file_io.h"
#include "sim/base/text.h"
#include "sim/mesh/triangle.h"

namespace kerf::app {

namespace {

static_assert(std::endian::native == std::endian::little, "PLY and STL are written as they lie");

template <class T>
void append(std::string& bytes, const T& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof(T));
}

template <class Number>
void append(std::string& bytes, const Eigen::Matrix<Number, 3, 1>& v) {
    bytes.append(reinterpret_cast<const char*>(v.data()), 3 * sizeof(Number));
}

bool hasSkinUvs(const ExportMesh& mesh) {
    return std::ranges::any_of(
        mesh.faces, [](const ExportFace& face) { return !face.cut && face.uvs[0] >= 0; });
}

/// As MeshLab has them: two numbers a corner; none on the faces of cuts, since readers that keep
/// one pair a vertex would take theirs.
void appendTexcoord(std::string& bytes, const ExportMesh& mesh, const ExportFace& face) {
    append(bytes, static_cast<std::uint8_t>(face.cut ? 0 : 6));
    for (int i = 0; i < 3 && !face.cut; ++i) {
        append(bytes, mesh.uvs[face.uvs[i]].x());
        append(bytes, mesh.uvs[face.uvs[i]].y());
    }
}

/// From linear light to a byte for displays.
std::uint8_t displayByte(double linear) {
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp(linear, 0.0, 1.0)));
}

void appendColor(std::string& bytes, const Eigen::Vector4f& color) {
    for (const double part : render::toDisplay(color.head<3>().cwiseMin(1).cwiseMax(0))) {
        append(bytes, displayByte(part));
    }
    append(bytes, displayByte(color.w()));
}

/// What a PLY file has besides the shape.
struct PlyLooks {
    std::vector<Eigen::Vector4f> colors{};  ///< of the vertices, linear; or none
    std::string image{};                    ///< the name of its file, or ""
};

std::string plyHeader(const ExportMesh& mesh, const PlyLooks& looks) {
    const std::string number = mesh.farPositions.empty() ? "float" : "double";
    return "ply\nformat binary_little_endian 1.0\ncomment Kerf, " + mesh.coordinates + "\n" +
           (looks.image.empty() ? "" : "comment TextureFile " + looks.image + "\n") +
           "element vertex " + std::to_string(mesh.positions.size()) + "\nproperty " + number +
           " x\nproperty " + number + " y\nproperty " + number +
           " z\n"
           "property float nx\nproperty float ny\nproperty float nz\n" +
           (mesh.tellsQuantities ? "property float vx\nproperty float vy\nproperty float vz\n"
                                 : "") +
           (looks.colors.empty() ? ""
                                 : "property uchar red\nproperty uchar green\n"
                                   "property uchar blue\nproperty uchar alpha\n") +
           "element face " + std::to_string(mesh.faces.size()) +
           "\nproperty list uchar int vertex_indices\nproperty int piece\nproperty uchar cut\n" +
           (mesh.tellsQuantities ? "property float strain\nproperty double piece_volume\n" : "") +
           (hasSkinUvs(mesh) ? "property list uchar float texcoord\n" : "") + "end_header\n";
}

std::string encodePly(const ExportMesh& mesh, const PlyLooks& looks = {}) {
    std::string bytes = plyHeader(mesh, looks);
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        if (mesh.farPositions.empty()) {
            append(bytes, mesh.positions[v]);
        } else {
            append(bytes, mesh.farPositions[v]);
        }
        append(bytes, mesh.normals[v]);
        if (mesh.tellsQuantities) {
            append(bytes, mesh.velocities[v]);
        }
        if (!looks.colors.empty()) {
            appendColor(bytes, looks.colors[v]);
        }
    }
    const bool textured = hasSkinUvs(mesh);
    for (const ExportFace& face : mesh.faces) {
        append(bytes, std::uint8_t{3});
        for (const int corner : face.corners) {
            append(bytes, std::int32_t{corner});
        }
        append(bytes, std::int32_t{face.piece});
        append(bytes, std::uint8_t{face.cut});
        if (mesh.tellsQuantities) {
            append(bytes, face.strain);
            append(bytes, mesh.pieceVolumes[face.piece]);
        }
        if (textured) {
            appendTexcoord(bytes, mesh, face);
        }
    }
    return bytes;
}

/// Each behind a blank.
template <class Vector>
std::string objNumbers(const Vector& v) {
    std::string text;
    for (const auto number : v) {
        text.append(" ").append(formatNumber(number));
    }
    return text;
}

template <class Vector>
void appendObjVector(std::string& text, const char* keyword, const Vector& v) {
    text.append(keyword).append(objNumbers(v)).append("\n");
}

/// Positions, with the colours of displays behind them where there are some.
void appendObjPositions(std::string& text, const ExportMesh& mesh) {
    const std::vector<Eigen::Vector4f> colors =
        mesh.colors.empty() ? std::vector<Eigen::Vector4f>{} : vertexColors(mesh, false);
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        const std::string line = mesh.farPositions.empty() ? objNumbers(mesh.positions[v])
                                                           : objNumbers(mesh.farPositions[v]);
        const std::string color =
            colors.empty()
                ? ""
                : objNumbers(Vec3f(render::toDisplay(colors[v].head<3>()).cast<float>()));
        text.append("v").append(line).append(color).append("\n");
    }
}

void appendObjFace(std::string& text, const ExportFace& face) {
    text += 'f';
    for (int i = 0; i < 3; ++i) {
        const std::string index = std::to_string(face.corners[i] + 1);
        const std::string uv = face.uvs[i] < 0 ? "" : std::to_string(face.uvs[i] + 1);
        text.append(" ").append(index).append("/").append(uv).append("/").append(index);
    }
    text += '\n';
}

/// `materials`: the name of the file that has them; "" for none.
std::string encodeObj(ExportMesh mesh, const std::string& materials = "") {
    const auto keyOf = [](const ExportFace& face) {
        return std::tuple(face.piece, face.cut, face.material);
    };
    std::ranges::stable_sort(mesh.faces, {}, keyOf);
    std::string text = "# Kerf, " + mesh.coordinates + "\n";
    text += materials.empty() ? "" : "mtllib " + materials + "\n";
    appendObjPositions(text, mesh);
    for (const Eigen::Vector2f& uv : mesh.uvs) appendObjVector(text, "vt", uv);
    for (const Vec3f& n : mesh.normals) appendObjVector(text, "vn", n);
    const ExportFace* last = nullptr;
    for (const ExportFace& face : mesh.faces) {
        const bool otherPiece = last == nullptr || last->piece != face.piece;
        if (otherPiece) {
            text += "o piece_" + std::to_string(face.piece + 1) + "\n";
        }
        if (otherPiece || last->cut != face.cut) {
            text += face.cut ? "g cut\n" : "g skin\n";
        }
        if (!materials.empty() && (otherPiece || last->material != face.material)) {
            text += "usemtl " + mesh.materials[face.material].name + "\n";
        }
        appendObjFace(text, face);
        last = &face;
    }
    return text;
}

/// `images`: the names of their files.
std::string encodeMtl(const std::vector<render::SurfaceMaterial>& materials,
                      const std::vector<std::string>& images) {
    std::string text = "# " + std::string(kCompanionMark) + ", materials\n";
    for (const render::SurfaceMaterial& material : materials) {
        const float shine = 30 * (1 - material.roughness);
        text += "newmtl " + material.name + "\n";
        appendObjVector(text, "Kd", Vec3f(material.baseColor.head<3>()));
        text += "d " + formatNumber(material.baseColor.w()) + "\n";
        text += "Ns " + formatNumber(shine * shine) + "\n";
        text += "Pr " + formatNumber(material.roughness) + "\n";
        text += "Pm " + formatNumber(material.metallic) + "\nillum 2\n";
        if (material.image >= 0) {
            text += "map_Kd " + images[material.image] + "\n";
        }
    }
    return text;
}

std::string encodeStl(const ExportMesh& mesh) {
    std::string bytes = "Kerf, " + mesh.coordinates;
    bytes.resize(80, ' ');
    append(bytes, static_cast<std::uint32_t>(mesh.faces.size()));
    for (const ExportFace& face : mesh.faces) {
        const auto [a, b, c] = face.corners;
        append(bytes, unitNormal(mesh.positions[a], mesh.positions[b], mesh.positions[c]));
        for (const int v : face.corners) {
            append(bytes, mesh.farPositions.empty() ? mesh.positions[v]
                                                    : Vec3f(mesh.farPositions[v].cast<float>()));
        }
        append(bytes, static_cast<std::uint16_t>(face.piece));
    }
    return bytes;
}

std::string encode(const ExportMesh& mesh, MeshFormat format) {
    switch (format) {
        case MeshFormat::ply:
            return encodePly(mesh);
        case MeshFormat::obj:
            return encodeObj(mesh);
        case MeshFormat::stl:
            return encodeStl(mesh);
        case MeshFormat::glb:
            return encodeGlb(mesh);
        case MeshFormat::vtp:
            return encodeVtp(mesh);
        case MeshFormat::gltf:
            break;
    }
    return encodeGltf(mesh);
}

/// Where a vertex was not moved, its place at rest has no rounding to float yet.
Vec3 exactPosition(const SurfaceMesh& mesh, int v) {
    const Vec3& now = mesh.position(v);
    const Vec3& rest = mesh.restPosition(v);
    return now.cast<float>() == rest.cast<float>() ? rest : now;
}

SurfaceMesh inModel(SurfaceMesh mesh, const Placement& placement) {
    const PlacementMap map(placement);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const Vec3 velocity = map.toModel(mesh.velocity(v)) - map.toModel(Vec3::Zero());
        mesh.setState(v, map.toModel(exactPosition(mesh, v)), velocity);
    }
    return mesh;
}

/// Floats hold no more than is there, but far from the origin doubles are written.
ExportMesh gatherInScene(const SurfaceMesh& mesh, const PieceMap& pieces, const ExportLooks& looks,
                         const Vec3& from) {
    if (from == Vec3::Zero()) {
        return gatherMesh(mesh, pieces, looks);
    }
    SurfaceMesh exact = mesh;
    for (int v = 0; v < exact.vertexCount(); ++v) {
        exact.setPosition(v, exactPosition(mesh, v));
    }
    return gatherMesh(exact, pieces, looks, from);
}

ExportMesh gatherInModel(const SurfaceMesh& mesh, const PieceMap& pieces, const ExportLooks& looks,
                         const Placement& placement) {
    const double unitsPerMetre = 1 / (placement.metresPerUnit() * placement.scale);
    ExportMesh gathered =
        gatherMesh(inModel(mesh, placement), pieces, looks, Vec3::Zero(), unitsPerMetre);
    gathered.coordinates = "coordinates of the model";
    if (placement.unit) {
        gathered.coordinates.append(", ").append(nameOf(*placement.unit));
    }
    return gathered;
}

/// Only materials that faces have, in their order: others would be told of in vain.
ExportMesh withoutUnused(ExportMesh mesh) {
    std::vector<int> numbers(mesh.materials.size(), -1);
    for (const ExportFace& face : mesh.faces) {
        numbers[face.material] = 0;
    }
    std::vector<render::SurfaceMaterial> used;
    for (std::size_t m = 0; m < numbers.size(); ++m) {
        if (numbers[m] == 0) {
            numbers[m] = static_cast<int>(used.size());
            used.push_back(mesh.materials[m]);
        }
    }
    for (ExportFace& face : mesh.faces) {
        face.material = numbers[face.material];
    }
    mesh.materials = std::move(used);
    return mesh;
}

/// With the ending of its kind.
std::string fileNameOf(const render::ModelImage& image) {
    const std::string kind(render::endingOf(render::kindOfImage(image.bytes)));
    std::string ending = lowerCase(std::filesystem::path(image.name).extension().string());
    ending = ending == ".jpeg" ? ".jpg" : ending;
    return ending == kind ? image.name : image.name + kind;
}

/// Writes the files of one export, and what they refer to.
class ExportWriter {
  public:
    ExportWriter(const ExportTarget& target, const ExportMesh& whole)
        : target_(target),
          whole_(whole),
          format_(*meshFormatOf(target.file)),
          names_(target.folder.empty() ? folderOf(target.file) : target.folder) {
        const bool hasImagesBeside =
            format_ != MeshFormat::stl && format_ != MeshFormat::glb && format_ != MeshFormat::vtp;
        if (hasImagesBeside) {
            addImages();
        }
        if (format_ == MeshFormat::obj) {
            materials_ = addCompanion(target.file.stem().string() + ".mtl",
                                      encodeMtl(whole.materials, images_));
        }
    }

    void add(const std::filesystem::path& file, const ExportMesh& mesh) {
        files_.push_back({file, encodeBeside(file, mesh)});
    }

    std::vector<ExportedFile> takeFiles() {
        std::ranges::move(companions_, std::back_inserter(files_));
        return std::move(files_);
    }

  private:
    static std::filesystem::path folderOf(const std::filesystem::path& file) {
        return file.has_parent_path() ? file.parent_path() : ".";
    }

    std::string encodeBeside(const std::filesystem::path& file, const ExportMesh& mesh) {
        if (format_ == MeshFormat::ply) {
            return encodePly(mesh, {vertexColors(mesh, true), onlyImage()});
        }
        if (format_ == MeshFormat::obj) {
            return encodeObj(mesh, materials_);
        }
        if (format_ == MeshFormat::gltf) {
            return encodeGltfBeside(mesh, images_, [&](std::string bytes) {
                return addCompanion(file.stem().string() + ".bin", std::move(bytes));
            });
        }
        return encode(mesh, format_);
    }

    /// Those that materials show; the others have no name.
    void addImages() {
        images_.resize(whole_.appearance ? whole_.appearance->images.size() : 0);
        for (const render::SurfaceMaterial& material : whole_.materials) {
            if (material.image >= 0 && images_[material.image].empty()) {
                const render::ModelImage& image = whole_.appearance->images[material.image];
                images_[material.image] = addCompanion(fileNameOf(image), image.bytes);
            }
        }
    }

    /// A .ply names one image for the whole mesh.
    std::string onlyImage() const {
        const auto isShown = [](const std::string& name) { return !name.empty(); };
        const bool one = std::ranges::count_if(images_, isShown) == 1;
        return one ? *std::ranges::find_if(images_, isShown) : "";
    }

    std::string addCompanion(const std::string& wanted, std::string bytes) {
        std::string name = freeAmongOurs(wanted, bytes);
        const std::filesystem::path file = target_.file.parent_path() / name;
        const bool known =
            std::ranges::find(companions_, file, &ExportedFile::file) != companions_.end();
        if (!known && !names_.isThere(name, bytes)) {
            companions_.push_back({file, std::move(bytes)});
        }
        return name;
    }

    /// Two images of a model may have one name.
    std::string freeAmongOurs(const std::string& wanted, const std::string& bytes) const {
        std::string name = names_.nameFor(wanted, bytes);
        for (int number = 2; isOther(name, bytes); ++number) {
            name = names_.nameFor(std::to_string(number) + "-" + wanted, bytes);
        }
        return name;
    }
    bool isOther(const std::string& name, const std::string& bytes) const {
        const auto isTaken = [&](const ExportedFile& file) {
            return file.file.filename() == name && file.bytes != bytes;
        };
        return std::ranges::any_of(companions_, isTaken) || target_.file.filename() == name;
    }

    const ExportTarget& target_;
    const ExportMesh& whole_;
    MeshFormat format_;
    CompanionNames names_;
    std::vector<std::string> images_;  // the names of their files; "" for those not written
    std::string materials_;
    std::vector<ExportedFile> files_;
    std::vector<ExportedFile> companions_;
};

}  // namespace

std::string encodeMesh(const SurfaceMesh& mesh, const PieceMap& pieces, MeshFormat format,
                       const ExportLooks& looks, const Vec3& from) {
    return encode(gatherInScene(mesh, pieces, looks, from), format);
}

std::string encodeMeasured(const SurfaceMesh& mesh, const PieceMap& pieces, MeshFormat format,
                           const ExportLooks& looks, const Vec3& from) {
    ExportMesh gathered = gatherInScene(mesh, pieces, looks, from);
    gathered.tellsQuantities = true;
    return encode(gathered, format);
}

std::vector<ExportedFile> encodeExport(const ExportTarget& target, const SurfaceMesh& mesh,
                                       const PieceMap& pieces, const ExportLooks& looks,
                                       const ExportFrame& place) {
    const ExportMesh whole =
        withoutUnused(target.coordinates == Coordinates::scene
                          ? gatherInScene(mesh, pieces, looks, place.origin)
                          : gatherInModel(mesh, pieces, looks, place.placement));
    ExportWriter writer(target, whole);
    const auto piece = [&](int number) {
        return partOf(whole, [number](const ExportFace& face) { return face.piece == number; });
    };
    if (target.pieceAt) {
        writer.add(target.file, piece(pieces.ofVertex[mesh.triangle(*target.pieceAt)[0]]));
        return writer.takeFiles();
    }
    if (!target.filePerPiece) {
        writer.add(target.file, whole);
        return writer.takeFiles();
    }
    for (int number = 0; number < static_cast<int>(pieces.pieces.size()); ++number) {
        writer.add(pieceFile(target.file, number), piece(number));
    }
    return writer.takeFiles();
}

OwnLooks carried(const OwnLooks& looks, const SurfaceMesh& uncut, const SurfaceMesh& cut) {
    return {carrySkin(uncut, looks.skin, cut), looks.appearance};
}

std::filesystem::path pieceFile(const std::filesystem::path& file, int piece) {
    std::filesystem::path name = file.stem();
    name += "-" + std::to_string(piece + 1);
    name += file.extension();
    return file.parent_path() / name;
}

bool isPieceFile(const std::filesystem::path& path, const std::filesystem::path& file) {
    const std::string stem = path.stem().string();
    const std::string start = file.stem().string() + "-";
    return path.parent_path() == file.parent_path() && path.extension() == file.extension() &&
           stem.starts_with(start) && stem.size() > start.size() &&
           stem.find_first_not_of("0123456789", start.size()) == std::string::npos;
}

}  // namespace kerf::app
