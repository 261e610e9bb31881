#include "tests/support/body_upload.h"

#include "shaders/shared/body_records.h"
#include "shaders/shared/shared_types.h"
#include "sim/body/surface_tag.h"

namespace kerf::test {
namespace {

std::vector<shared::vec4> packed(const std::vector<Vec3>& points) {
    std::vector<shared::vec4> out;
    out.reserve(points.size());
    for (const Vec3& p : points) {
        out.push_back({float(p.x()), float(p.y()), float(p.z()), 1});
    }
    return out;
}

std::vector<shared::uvec4> taggedTriangles(const SurfaceMesh& mesh) {
    std::vector<shared::uvec4> out;
    for (int t = 0; t < mesh.triangleSlots(); ++t) {
        if (mesh.alive(t)) {
            const Triangle& c = mesh.triangle(t);
            out.push_back({std::uint32_t(c[0]), std::uint32_t(c[1]), std::uint32_t(c[2]),
                           surfaceTag(mesh, t)});
        }
    }
    return out;
}

std::vector<std::vector<std::uint32_t>> cornersAround(const std::vector<shared::uvec4>& triangles,
                                                      std::size_t vertexCount) {
    std::vector<std::vector<std::uint32_t>> around(vertexCount);
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        around[triangles[t].x].push_back(4 * t);
        around[triangles[t].y].push_back(4 * t + 1);
        around[triangles[t].z].push_back(4 * t + 2);
    }
    return around;
}

/// Builds a hemisphere of rest radius 1 on the side of +z or -z of the plane z = 0.
class HalfBuilder {
  public:
    HalfBuilder(std::vector<Vec3>& points, std::vector<Triangle>& triangles,
                std::vector<bool>& wall, int rings, double side)
        : points_(points), triangles_(triangles), wall_(wall), rings_(rings), side_(side) {}

    void build() {
        const int rim = addDisk(1, false, -1);
        addDisk(1, true, rim);
    }

  private:
    int around() const { return 6 * rings_; }

    /// Rings from the rim to the middle; a dome where it is skin. Returns the first rim vertex.
    int addDisk(double radius, bool wall, int sharedRim) {
        int outer = sharedRim;
        for (int r = rings_; r >= 1; --r) {
            if (r == rings_ && sharedRim >= 0) {
                continue;
            }
            const int first = addRing(radius, double(r) / rings_, wall);
            if (r < rings_) {
                stitch(outer, first, wall);
            }
            sharedRim = sharedRim < 0 ? first : sharedRim;
            outer = first;
        }
        const int tip = add(Vec3(0, 0, wall ? 0 : side_ * radius));
        for (int i = 0; i < around(); ++i) {
            addTriangle({outer + i, outer + (i + 1) % around(), tip}, wall);
        }
        return sharedRim;
    }

    int addRing(double radius, double share, bool wall) {
        const int first = int(points_.size());
        const double tilt = 0.5 * std::numbers::pi * share;
        const double reach = wall ? radius * share : radius * std::sin(tilt);
        const double rise = wall || share == 1 ? 0 : side_ * radius * std::cos(tilt);
        for (int i = 0; i < around(); ++i) {
            const double angle = 2 * std::numbers::pi * i / around();
            add(Vec3(reach * std::cos(angle), reach * std::sin(angle), rise));
        }
        return first;
    }

    void stitch(int outer, int inner, bool wall) {
        for (int i = 0; i < around(); ++i) {
            const int j = (i + 1) % around();
            addTriangle({outer + i, outer + j, inner + i}, wall);
            addTriangle({outer + j, inner + j, inner + i}, wall);
        }
    }

    int add(const Vec3& p) {
        points_.push_back(p);
        return int(points_.size()) - 1;
    }

    void addTriangle(Triangle t, bool wall) {
        if ((side_ > 0) == wall) {
            std::swap(t[1], t[2]);
        }
        triangles_.push_back(t);
        wall_.push_back(wall);
    }

    std::vector<Vec3>& points_;
    std::vector<Triangle>& triangles_;
    std::vector<bool>& wall_;
    int rings_;
    double side_;
};

}  // namespace

UploadedBody::UploadedBody(const SurfaceMesh& mesh, std::vector<Vec3> normals) {
    normals.resize(mesh.vertexCount(), Vec3::Zero());
    cutSkinNormals.assign(packed(normals));
    const std::vector<shared::uvec4> living = taggedTriangles(mesh);
    positions.assign(packed(mesh.positions()));
    restPositions.assign(packed(mesh.restPositions()));
    triangles.assign(living);
    vertexCount = std::uint32_t(mesh.vertexCount());
    triangleCount = std::uint32_t(living.size());
    std::vector<shared::IncidenceRange> ranges;
    std::vector<std::uint32_t> entries;
    for (const auto& corners : cornersAround(living, vertexCount)) {
        const auto first = std::uint32_t(entries.size());
        entries.insert(entries.end(), corners.begin(), corners.end());
        ranges.push_back({first, std::uint32_t(entries.size())});
    }
    incidenceRanges.assign(ranges);
    incidence.assign(entries);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        bounds.add(mesh.position(v));
        restBounds.add(mesh.restPosition(v));
    }
}

BodyView UploadedBody::view() const {
    BodyView body;
    body.positions = &positions;
    body.restPositions = &restPositions;
    body.cutSkinNormals = &cutSkinNormals;
    body.triangles = &triangles;
    body.incidenceRanges = &incidenceRanges;
    body.incidence = &incidence;
    body.vertexCount = vertexCount;
    body.triangleCount = triangleCount;
    return body;
}

SurfaceMesh openedSphere(int rings, double gap, double angle) {
    std::vector<Vec3> rest;
    std::vector<Triangle> triangles;
    std::vector<bool> wall;
    HalfBuilder(rest, triangles, wall, rings, 1).build();
    const int firstHalf = int(rest.size());
    HalfBuilder(rest, triangles, wall, rings, -1).build();
    SurfaceMesh whole = SurfaceMesh::fromTriangles(rest, triangles);
    SurfaceMesh mesh = whole;
    for (int t = 0; t < whole.triangleSlots(); ++t) {
        mesh.removeTriangle(t);
        mesh.addTriangle(whole.triangle(t), wall[t] ? SurfaceKind::wall : SurfaceKind::skin,
                         wall[t] ? 0 : -1);
    }
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const double side = v < firstHalf ? 1 : -1;
        const Vec3 pivot(0, -1, 0);
        const Eigen::AngleAxisd turn(side * angle, Vec3::UnitX());
        mesh.setPosition(v, pivot + turn * (rest[v] - pivot) + Vec3(0, 0, side * gap));
    }
    return mesh;
}

}  // namespace kerf::test
