#include "app/files/export/export_mesh.h"

#include <Eigen/Eigenvalues>

#include "sim/base/math.h"
#include "sim/base/placement.h"
#include "sim/mesh/skin_attributes.h"
#include "sim/mesh/triangle.h"
#include "sim/mesh/triangle_quality.h"

namespace kerf::app {
namespace {

std::vector<int> numberUsedVertices(const SurfaceMesh& mesh) {
    std::vector<int> numbers(mesh.vertexCount(), -1);
    int next = 0;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        if (mesh.outgoing(v) >= 0 && !hidden(mesh, v)) {
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

/// Numbers equal values alike.
template <class Vector>
class ValueNumbers {
  public:
    explicit ValueNumbers(std::vector<Vector>& values) : values_(values) {}

    int numberOf(const Vector& value) {
        std::array<float, Vector::SizeAtCompileTime> key;
        std::ranges::copy(value, key.begin());
        const auto [place, isNew] = numbers_.try_emplace(key, static_cast<int>(values_.size()));
        if (isNew) {
            values_.push_back(value);
        }
        return place->second;
    }

  private:
    std::vector<Vector>& values_;
    std::map<std::array<float, Vector::SizeAtCompileTime>, int> numbers_;
};

/// `wanted`, or that with a number where the list has it.
std::string freeName(const std::vector<render::SurfaceMaterial>& materials,
                     const std::string& wanted) {
    const auto taken = [&](const std::string& name) {
        return std::ranges::find(materials, name, &render::SurfaceMaterial::name) !=
               materials.end();
    };
    std::string name = wanted.empty() ? "material" : wanted;
    for (int number = 2; taken(name); ++number) {
        name = (wanted.empty() ? "material" : wanted) + "_" + std::to_string(number);
    }
    return name;
}

render::SurfaceMaterial plainMaterial(const Eigen::Vector3f& color) {
    render::SurfaceMaterial material;
    material.baseColor = {color.x(), color.y(), color.z(), 1};
    return material;
}

constexpr double kSteep = 0.9;  // of a normal: a plane that faces so far up has no other way up

int strokeOf(const SurfaceMesh& mesh, int t) {
    return mesh.wallLabel(t) / 2;
}

/// The direction that most of the area faces, either way: the two walls of a slit face away from
/// each other. Its largest part is positive.
Vec3 normalOf(const Eigen::Matrix3d& spread) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);
    const Vec3 normal = solver.eigenvectors().col(2);
    Eigen::Index largest = 0;
    normal.cwiseAbs().maxCoeff(&largest);
    return normal[largest] < 0 ? Vec3(-normal) : normal;
}

/// The planes onto which cut faces are projected, one for each stroke: the one that its walls face
/// most, at rest.
class CutPlanes {
  public:
    explicit CutPlanes(const SurfaceMesh& mesh);
    /// The rest position of vertex v in the plane of the wall triangle t [m]: across, then upwards.
    Eigen::Vector2f at(const SurfaceMesh& mesh, int t, int v) const;

  private:
    using Axes = Eigen::Matrix<double, 2, 3>;
    std::map<int, Axes> axes_;  // by stroke
};

CutPlanes::CutPlanes(const SurfaceMesh& mesh) {
    std::map<int, Eigen::Matrix3d> spreads;
    for (int t = 0; t < mesh.triangleSlots(); ++t) {
        if (mesh.present(t) && mesh.kind(t) == SurfaceKind::wall) {
            const Vec3 area = areaNormal(restCornersOf(mesh, t));
            const auto place = spreads.try_emplace(strokeOf(mesh, t), Eigen::Matrix3d::Zero());
            place.first->second += area * area.stableNormalized().transpose();
        }
    }
    for (const auto& [stroke, spread] : spreads) {
        const Vec3 normal = normalOf(spread);
        const Vec3 up = std::fabs(normal.y()) > kSteep ? Vec3(-Vec3::UnitZ()) : Vec3(Vec3::UnitY());
        const Vec3 across = up.cross(normal).normalized();
        Axes axes;
        axes << across.transpose(), normal.cross(across).transpose();
        axes_.emplace(stroke, axes);
    }
}

Eigen::Vector2f CutPlanes::at(const SurfaceMesh& mesh, int t, int v) const {
    return (axes_.at(strokeOf(mesh, t)) * mesh.restPosition(v)).cast<float>();
}

/// Gathers the faces of a mesh.
class Gathering {
  public:
    Gathering(const SurfaceMesh& mesh, const PieceMap& pieces, const ExportLooks& looks,
              double unitsPerMetre)
        : mesh_(mesh), pieces_(pieces), looks_(looks), scale_(unitsPerMetre), planes_(mesh) {
        out_.appearance = looks.own.appearance;
        addMaterials();
    }

    ExportMesh gather(const Vec3& from) {
        for (const Piece& piece : pieces_.pieces) {
            out_.pieceVolumes.push_back(piece.volume * scale_ * scale_ * scale_);
        }
        const std::vector<int> numbers = numberUsedVertices(mesh_);
        std::vector<Vec3> places;
        for (int v = 0; v < mesh_.vertexCount(); ++v) {
            if (numbers[v] >= 0) {
                places.emplace_back(mesh_.position(v) + from);
                out_.vertices.push_back(numbers[v]);
                out_.normals.push_back(vertexNormal(mesh_, v));
                out_.velocities.push_back(mesh_.velocity(v).cast<float>());
            }
        }
        put(std::move(places));
        for (int t = 0; t < mesh_.triangleSlots(); ++t) {
            if (mesh_.present(t)) {
                out_.faces.push_back(faceOf(t, numbers));
            }
        }
        return std::move(out_);
    }

  private:
    void put(std::vector<Vec3> places) {
        out_.origin = places.empty() ? Vec3(Vec3::Zero()) : originOf(boxOf(places));
        for (const Vec3& place : places) {
            out_.positions.emplace_back((place - out_.origin).cast<float>());
        }
        if (out_.origin != Vec3::Zero()) {
            out_.farPositions = std::move(places);
        }
    }

    void addMaterials() {
        for (int i = 0; out_.appearance && i < int(out_.appearance->materials.size()); ++i) {
            render::SurfaceMaterial material = out_.appearance->materials[i];
            material.name = freeName(out_.materials, material.name);
            out_.materials.push_back(material);
        }
        // Colours of corners stand for themselves.
        const bool colored = !looks_.own.skin.colors.empty();
        const Eigen::Vector3f white = Eigen::Vector3f::Ones();
        skin_ = add(plainMaterial(colored ? white : looks_.look.skin), "skin");
        cut_ = add(plainMaterial(looks_.look.inner), "cut");
    }

    int add(render::SurfaceMaterial material, const std::string& name) {
        material.name = freeName(out_.materials, name);
        out_.materials.push_back(std::move(material));
        return static_cast<int>(out_.materials.size()) - 1;
    }

    ExportFace faceOf(int t, const std::vector<int>& numbers) {
        const auto [a, b, c] = mesh_.triangle(t);
        ExportFace face{{numbers[a], numbers[b], numbers[c]}, pieces_.ofVertex[a]};
        face.cut = mesh_.kind(t) == SurfaceKind::wall;
        face.strain = static_cast<float>(strainOf(t));
        if (face.cut) {
            lay(t, face);
        } else {
            paint(t, face);
        }
        return face;
    }

    /// Places at rest are in metres of the scene, whatever those of now are in.
    double strainOf(int t) const {
        Corners now = cornersOf(mesh_, t);
        for (Vec3& corner : now) {
            corner /= scale_;
        }
        return largestStrain(restCornersOf(mesh_, t), now);
    }

    /// A face of a cut, into its plane.
    void lay(int t, ExportFace& face) {
        face.material = cut_;
        for (int i = 0; i < 3; ++i) {
            const Eigen::Vector2f place = planes_.at(mesh_, t, mesh_.triangle(t)[i]);
            face.uvs[i] = uvs_.numberOf(place * static_cast<float>(scale_));
        }
    }

    void paint(int t, ExportFace& face) {
        const SkinAttributes& skin = looks_.own.skin;
        const TriangleAttributes own = attributesOf(skin, t);
        face.material = out_.appearance && own.material >= 0 ? own.material : skin_;
        for (int i = 0; i < 3; ++i) {
            face.uvs[i] = skin.uvs.empty() ? -1 : uvs_.numberOf(own.uvs[i]);
            face.colors[i] = skin.colors.empty() ? -1 : colors_.numberOf(own.colors[i]);
        }
    }

    const SurfaceMesh& mesh_;
    const PieceMap& pieces_;
    const ExportLooks& looks_;
    double scale_;
    CutPlanes planes_;
    ExportMesh out_;
    ValueNumbers<Eigen::Vector2f> uvs_{out_.uvs};
    ValueNumbers<Eigen::Vector4f> colors_{out_.colors};
    int skin_ = 0;
    int cut_ = 0;
};

}  // namespace

Eigen::Vector4f cornerColor(const ExportMesh& mesh, const ExportFace& face, int corner,
                            bool withMaterials) {
    Eigen::Vector4f color = Eigen::Vector4f::Ones();
    if (withMaterials) {
        color = render::shownColor(mesh.materials[face.material]);
    }
    const int own = face.colors[corner];
    return own < 0 ? color : Eigen::Vector4f(color.cwiseProduct(mesh.colors[own]));
}

ExportMesh gatherMesh(const SurfaceMesh& mesh, const PieceMap& pieces, const ExportLooks& looks,
                      const Vec3& from, double unitsPerMetre) {
    return Gathering(mesh, pieces, looks, unitsPerMetre).gather(from);
}

std::vector<Eigen::Vector4f> vertexColors(const ExportMesh& mesh, bool withMaterials) {
    std::vector<Eigen::Vector4d> sums(mesh.positions.size(), Eigen::Vector4d::Zero());
    std::vector<int> counts(mesh.positions.size(), 0);
    for (const bool cut : {false, true}) {
        const std::vector<int> before = counts;
        for (const ExportFace& face : mesh.faces) {
            for (int i = 0; i < 3; ++i) {
                const int v = face.corners[i];
                if (face.cut == cut && (!cut || before[v] == 0)) {
                    sums[v] += cornerColor(mesh, face, i, withMaterials).cast<double>();
                    ++counts[v];
                }
            }
        }
    }
    std::vector<Eigen::Vector4f> colors;
    for (std::size_t v = 0; v < sums.size(); ++v) {
        colors.emplace_back((sums[v] / std::max(counts[v], 1)).cast<float>());
    }
    return colors;
}

}  // namespace kerf::app
