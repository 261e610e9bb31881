#include "app/export.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <tuple>
#include <vector>

#include "app/file_io.h"

namespace kerf::app {

namespace {

static_assert(std::endian::native == std::endian::little, "PLY and STL are written as they lie");

struct ExportFace {
    Triangle corners;  ///< indices into ExportMesh::positions
    int piece = 0;
    bool cut = false;
};

/// A mesh without dead slots and unused vertices, in float as it is written.
struct ExportMesh {
    std::vector<Vec3f> positions;
    std::vector<Vec3f> normals;  ///< unit, area-weighted
    std::vector<ExportFace> faces;
};

std::vector<int> numberUsedVertices(const SurfaceMesh& mesh) {
    std::vector<int> numbers(mesh.vertexCount(), -1);
    int next = 0;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        if (mesh.outgoing(v) >= 0) {
            numbers[v] = next++;
        }
    }
    return numbers;
}

Vec3 areaVector(const SurfaceMesh& mesh, int t) {
    const auto [a, b, c] = mesh.triangle(t);
    return (mesh.position(b) - mesh.position(a)).cross(mesh.position(c) - mesh.position(a));
}

/// At the front of a slit the normals of its two walls cancel each other: there the first triangle
/// with an area stands for all.
Vec3f vertexNormal(const SurfaceMesh& mesh, int v) {
    Vec3 sum = Vec3::Zero();
    Vec3 first = Vec3::Zero();
    mesh.forEachOutgoing(v, [&](int h) {
        const Vec3 area = areaVector(mesh, h / 3);
        sum += area;
        first = first.isZero(0) ? area : first;
    });
    const Vec3& normal = sum.isZero(0) ? first : sum;
    return (normal.isZero(0) ? Vec3(Vec3::UnitY()) : normal.stableNormalized()).cast<float>();
}

ExportMesh compact(const SurfaceMesh& mesh, const PieceMap& pieces) {
    const std::vector<int> numbers = numberUsedVertices(mesh);
    ExportMesh out;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        if (numbers[v] >= 0) {
            out.positions.push_back(mesh.position(v).cast<float>());
            out.normals.push_back(vertexNormal(mesh, v));
        }
    }
    for (int t = 0; t < mesh.triangleSlots(); ++t) {
        if (mesh.alive(t)) {
            const auto [a, b, c] = mesh.triangle(t);
            out.faces.push_back({{numbers[a], numbers[b], numbers[c]},
                                 pieces.ofVertex[a],
                                 mesh.kind(t) == SurfaceKind::wall});
        }
    }
    return out;
}

template <class T>
void append(std::string& bytes, const T& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof(T));
}

void append(std::string& bytes, const Vec3f& v) {
    bytes.append(reinterpret_cast<const char*>(v.data()), 3 * sizeof(float));
}

std::string encodePly(const ExportMesh& mesh) {
    std::string bytes =
        "ply\nformat binary_little_endian 1.0\ncomment Kerf, metres, +y up\n"
        "element vertex " +
        std::to_string(mesh.positions.size()) +
        "\nproperty float x\nproperty float y\nproperty float z\n"
        "property float nx\nproperty float ny\nproperty float nz\n"
        "element face " +
        std::to_string(mesh.faces.size()) +
        "\nproperty list uchar int vertex_indices\nproperty int piece\nproperty uchar cut\n"
        "end_header\n";
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
    }
    return bytes;
}

void appendObjVector(std::string& text, const char* keyword, const Vec3f& v) {
    text += keyword;
    for (int i = 0; i < 3; ++i) {
        text += ' ';
        text += formatNumber(v[i]);
    }
    text += '\n';
}

std::string encodeObj(ExportMesh mesh) {
    const auto byGroup = [](const ExportFace& a, const ExportFace& b) {
        return std::tie(a.piece, a.cut) < std::tie(b.piece, b.cut);
    };
    std::stable_sort(mesh.faces.begin(), mesh.faces.end(), byGroup);
    std::string text = "# Kerf, metres, +y up\n";
    for (const Vec3f& p : mesh.positions) appendObjVector(text, "v", p);
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
        for (const int corner : face.corners) {
            const std::string index = std::to_string(corner + 1);
            text.append(" ").append(index).append("//").append(index);
        }
        text += '\n';
        last = &face;
    }
    return text;
}

std::string encodeStl(const ExportMesh& mesh) {
    std::string bytes = "Kerf, metres, +y up";
    bytes.resize(80, ' ');
    append(bytes, static_cast<std::uint32_t>(mesh.faces.size()));
    for (const ExportFace& face : mesh.faces) {
        const auto [a, b, c] = face.corners;
        const Vec3f& origin = mesh.positions[a];
        append(
            bytes,
            Vec3f(
                (mesh.positions[b] - origin).cross(mesh.positions[c] - origin).stableNormalized()));
        append(bytes, origin);
        append(bytes, mesh.positions[b]);
        append(bytes, mesh.positions[c]);
        append(bytes, static_cast<std::uint16_t>(face.piece));
    }
    return bytes;
}

}  // namespace

std::optional<MeshFormat> meshFormatOf(const std::filesystem::path& file) {
    const std::string extension = file.extension().string();
    if (extension == ".ply") return MeshFormat::ply;
    if (extension == ".obj") return MeshFormat::obj;
    if (extension == ".stl") return MeshFormat::stl;
    return std::nullopt;
}

std::string encodeMesh(const SurfaceMesh& mesh, const PieceMap& pieces, MeshFormat format) {
    ExportMesh out = compact(mesh, pieces);
    switch (format) {
        case MeshFormat::ply:
            return encodePly(out);
        case MeshFormat::obj:
            return encodeObj(std::move(out));
        case MeshFormat::stl:
            break;
    }
    return encodeStl(out);
}

}  // namespace kerf::app
