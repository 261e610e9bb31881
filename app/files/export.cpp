#include "app/files/export.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <tuple>
#include <vector>

#include "app/files/export_gltf.h"
#include "app/files/export_mesh.h"
#include "app/files/file_io.h"
#include "sim/mesh/triangle.h"

namespace kerf::app {

namespace {

static_assert(std::endian::native == std::endian::little, "PLY and STL are written as they lie");

template <class T>
void append(std::string& bytes, const T& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof(T));
}

void append(std::string& bytes, const Vec3f& v) {
    bytes.append(reinterpret_cast<const char*>(v.data()), 3 * sizeof(float));
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

std::string encodePly(const ExportMesh& mesh) {
    std::string bytes =
        "ply\nformat binary_little_endian 1.0\ncomment Kerf, " + mesh.coordinates +
        "\nelement vertex " + std::to_string(mesh.positions.size()) +
        "\nproperty float x\nproperty float y\nproperty float z\n"
        "property float nx\nproperty float ny\nproperty float nz\n"
        "element face " +
        std::to_string(mesh.faces.size()) +
        "\nproperty list uchar int vertex_indices\nproperty int piece\nproperty uchar cut\n" +
        (mesh.uvs.empty() ? "" : "property list uchar float texcoord\n") + "end_header\n";
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        append(bytes, mesh.positions[v]);
        append(bytes, mesh.normals[v]);
    }
    for (const ExportFace& face : mesh.faces) {
        append(bytes, std::uint8_t{3});
        for (const int corner : face.corners) {
            append(bytes, std::int32_t{corner});
        }
        append(bytes, std::int32_t{face.piece});
        append(bytes, std::uint8_t{face.cut});
        if (!mesh.uvs.empty()) {
            appendTexcoord(bytes, mesh, face);
        }
    }
    return bytes;
}

template <class Vector>
void appendObjVector(std::string& text, const char* keyword, const Vector& v) {
    text += keyword;
    for (const float number : v) {
        text += ' ';
        text += formatNumber(number);
    }
    text += '\n';
}

std::string encodeObj(ExportMesh mesh) {
    const auto byGroup = [](const ExportFace& a, const ExportFace& b) {
        return std::tie(a.piece, a.cut) < std::tie(b.piece, b.cut);
    };
    std::stable_sort(mesh.faces.begin(), mesh.faces.end(), byGroup);
    std::string text = "# Kerf, " + mesh.coordinates + "\n";
    for (const Vec3f& p : mesh.positions) appendObjVector(text, "v", p);
    for (const Eigen::Vector2f& uv : mesh.uvs) appendObjVector(text, "vt", uv);
    for (const Vec3f& n : mesh.normals) appendObjVector(text, "vn", n);
    const ExportFace* last = nullptr;
    for (const ExportFace& face : mesh.faces) {
        if (last == nullptr || last->piece != face.piece) {
            text += "o piece_" + std::to_string(face.piece + 1) + "\n";
        }
        if (last == nullptr || last->piece != face.piece || last->cut != face.cut) {
            text += face.cut ? "g cut\n" : "g skin\n";
        }
        text += 'f';
        for (int i = 0; i < 3; ++i) {
            const std::string index = std::to_string(face.corners[i] + 1);
            const std::string uv = face.uvs[i] < 0 ? "" : std::to_string(face.uvs[i] + 1);
            text.append(" ").append(index).append("/").append(uv).append("/").append(index);
        }
        text += '\n';
        last = &face;
    }
    return text;
}

std::string encodeStl(const ExportMesh& mesh) {
    std::string bytes = "Kerf, " + mesh.coordinates;
    bytes.resize(80, ' ');
    append(bytes, static_cast<std::uint32_t>(mesh.faces.size()));
    for (const ExportFace& face : mesh.faces) {
        const auto [a, b, c] = face.corners;
        const Vec3f& origin = mesh.positions[a];
        append(bytes, unitNormal(origin, mesh.positions[b], mesh.positions[c]));
        append(bytes, origin);
        append(bytes, mesh.positions[b]);
        append(bytes, mesh.positions[c]);
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
        case MeshFormat::gltf:
            break;
    }
    return encodeGltf(mesh);
}

/// Where a vertex was not moved, its place at rest has no rounding to float yet.
SurfaceMesh inModel(SurfaceMesh mesh, const Placement& placement) {
    const PlacementMap map(placement);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const Vec3& now = mesh.position(v);
        const Vec3& rest = mesh.restPosition(v);
        const bool rests = now.cast<float>() == rest.cast<float>();
        mesh.setPosition(v, map.toModel(rests ? rest : now));
    }
    return mesh;
}

ExportMesh gatherInModel(const SurfaceMesh& mesh, const PieceMap& pieces,
                         const std::vector<CornerUvs>& uvs, const Placement& placement) {
    ExportMesh gathered = gatherMesh(inModel(mesh, placement), pieces, uvs);
    gathered.coordinates = "coordinates of the model";
    if (placement.unit) {
        gathered.coordinates.append(", ").append(nameOf(*placement.unit));
    }
    return gathered;
}

}  // namespace

std::string encodeMesh(const SurfaceMesh& mesh, const PieceMap& pieces, MeshFormat format,
                       const std::vector<CornerUvs>& uvs) {
    return encode(gatherMesh(mesh, pieces, uvs), format);
}

std::vector<ExportedFile> encodeExport(const ExportTarget& target, const SurfaceMesh& mesh,
                                       const PieceMap& pieces, const std::vector<CornerUvs>& uvs,
                                       const Placement& placement) {
    const MeshFormat format = *meshFormatOf(target.file);
    const ExportMesh whole = target.coordinates == Coordinates::scene
                                 ? gatherMesh(mesh, pieces, uvs)
                                 : gatherInModel(mesh, pieces, uvs, placement);
    std::vector<ExportedFile> files;
    if (!target.filePerPiece) {
        files.push_back({target.file, encode(whole, format)});
        return files;
    }
    for (int piece = 0; piece < static_cast<int>(pieces.pieces.size()); ++piece) {
        const auto belongs = [&](const ExportFace& face) { return face.piece == piece; };
        files.push_back({pieceFile(target.file, piece), encode(partOf(whole, belongs), format)});
    }
    return files;
}

std::filesystem::path pieceFile(const std::filesystem::path& file, int piece) {
    std::filesystem::path name = file.stem();
    name += "-" + std::to_string(piece + 1);
    name += file.extension();
    return file.parent_path() / name;
}

}  // namespace kerf::app
