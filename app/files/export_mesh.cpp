#include "app/files/export_mesh.h"

#include <map>
#include <utility>

#include "sim/mesh/triangle.h"

namespace kerf::app {
namespace {

std::vector<int> numberUsedVertices(const SurfaceMesh& mesh) {
    std::vector<int> numbers(mesh.vertexCount(), -1);
    int next = 0;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        if (mesh.outgoing(v) >= 0 && !mesh.hidden(v)) {
            numbers[v] = next++;
        }
    }
    return numbers;
}

/// At the front of a slit the normals of its two walls cancel each other: there the first triangle
/// with an area stands for all.
Vec3f vertexNormal(const SurfaceMesh& mesh, int v) {
    Vec3 sum = Vec3::Zero();
    Vec3 first = Vec3::Zero();
    mesh.forEachOutgoing(v, [&](int h) {
        if (mesh.absent(h / 3)) {
            return;
        }
        const Vec3 area = areaNormal(cornersOf(mesh, h / 3));
        sum += area;
        first = first.isZero(0) ? area : first;
    });
    const Vec3& normal = sum.isZero(0) ? first : sum;
    return (normal.isZero(0) ? Vec3(Vec3::UnitY()) : normal.stableNormalized()).cast<float>();
}

/// Numbers equal texture coordinates alike.
class UvNumbers {
  public:
    explicit UvNumbers(std::vector<Eigen::Vector2f>& uvs) : uvs_(uvs) {}

    int numberOf(const Eigen::Vector2f& uv) {
        const auto [place, isNew] =
            numbers_.try_emplace({uv.x(), uv.y()}, static_cast<int>(uvs_.size()));
        if (isNew) {
            uvs_.push_back(uv);
        }
        return place->second;
    }

  private:
    std::vector<Eigen::Vector2f>& uvs_;
    std::map<std::pair<float, float>, int> numbers_;
};

}  // namespace

ExportMesh gatherMesh(const SurfaceMesh& mesh, const PieceMap& pieces,
                      const std::vector<CornerUvs>& uvs) {
    const std::vector<int> numbers = numberUsedVertices(mesh);
    ExportMesh out;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        if (numbers[v] >= 0) {
            out.positions.push_back(mesh.position(v).cast<float>());
            out.normals.push_back(vertexNormal(mesh, v));
        }
    }
    UvNumbers uvNumbers(out.uvs);
    for (int t = 0; t < mesh.triangleSlots(); ++t) {
        if (!mesh.present(t)) {
            continue;
        }
        const auto [a, b, c] = mesh.triangle(t);
        ExportFace face{{numbers[a], numbers[b], numbers[c]},
                        pieces.ofVertex[a],
                        mesh.kind(t) == SurfaceKind::wall};
        for (int i = 0; i < 3 && !uvs.empty() && !face.cut; ++i) {
            face.uvs[i] = uvNumbers.numberOf(uvs[t][i]);
        }
        out.faces.push_back(face);
    }
    return out;
}

}  // namespace kerf::app
