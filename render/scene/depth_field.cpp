#include "render/scene/depth_field.h"

#include <glad/gl.h>

#include "sim/base/math.h"
#include "sim/mesh/triangle.h"

namespace kerf::render {
namespace {

constexpr int kBandCells = 1;     // exact distances this far around each triangle
constexpr int kPaddingCells = 2;  // samples outside the bounds
constexpr double kFar = 1e30;
// Keeps rows of samples off the vertices and edges of regular models, where parity is ambiguous.
constexpr double kOffGrid[3] = {0.0137, 0.0271, 0.0419};

/// The work behind measureDepth: distances and the triangle that gave each.
class Measurement {
  public:
    Measurement(const SurfaceMesh& mesh, int resolution) : mesh_(mesh) {
        layGrid(resolution);
        nearest_.assign(field_.values.size(), -1);
        distance_.assign(field_.values.size(), kFar);
        crossings_.assign(field_.values.size(), 0);
    }

    DepthField run() {
        for (const int t : livingTriangles(mesh_)) {
            splat(t);
            countCrossings(t);
        }
        for (int pass = 0; pass < 8; ++pass) {
            sweep(pass & 1 ? -1 : 1, pass & 2 ? -1 : 1, pass & 4 ? -1 : 1);
        }
        writeValues();
        return std::move(field_);
    }

  private:
    void layGrid(int resolution) {
        const Bounds bounds =
            boxOf(livingTriangles(mesh_), [this](int t) { return boxOf(restCornersOf(mesh_, t)); });
        const Vec3 extent = bounds.high - bounds.low;
        field_.spacing = std::max(extent.maxCoeff(), 1e-9) / (resolution - 2 * kPaddingCells - 1);
        for (int i = 0; i < 3; ++i) {
            field_.size[i] = int(std::ceil(extent[i] / field_.spacing)) + 2 * kPaddingCells + 1;
            field_.origin[i] = bounds.low[i] - field_.spacing * (kPaddingCells - kOffGrid[i]);
        }
        field_.values.assign(std::size_t(field_.size[0]) * field_.size[1] * field_.size[2], 0);
    }

    const Vec3& corner(int t, int c) const { return mesh_.restPosition(mesh_.triangle(t)[c]); }

    Vec3 sample(int x, int y, int z) const {
        return field_.origin + field_.spacing * Vec3(x, y, z);
    }

    std::pair<int, int> cellRange(int t, int axis, int margin) const {
        const double a = corner(t, 0)[axis];
        const double b = corner(t, 1)[axis];
        const double c = corner(t, 2)[axis];
        const double low = (std::min({a, b, c}) - field_.origin[axis]) / field_.spacing;
        const double high = (std::max({a, b, c}) - field_.origin[axis]) / field_.spacing;
        return {std::max(int(std::floor(low)) - margin, 0),
                std::min(int(std::ceil(high)) + margin, field_.size[axis] - 1)};
    }

    void tryTriangle(int cell, const Vec3& p, int t) {
        const Vec3& a = corner(t, 0);
        const Vec3& b = corner(t, 1);
        const Vec3& c = corner(t, 2);
        const Vec3 weights = closestWeights(p, a, b, c);
        const double d = (weights.x() * a + weights.y() * b + weights.z() * c - p).squaredNorm();
        if (d < distance_[cell]) {
            distance_[cell] = d;
            nearest_[cell] = t;
        }
    }

    void splat(int t) {
        const auto [x0, x1] = cellRange(t, 0, kBandCells);
        const auto [y0, y1] = cellRange(t, 1, kBandCells);
        const auto [z0, z1] = cellRange(t, 2, kBandCells);
        for (int z = z0; z <= z1; ++z) {
            for (int y = y0; y <= y1; ++y) {
                for (int x = x0; x <= x1; ++x) {
                    tryTriangle(field_.index(x, y, z), sample(x, y, z), t);
                }
            }
        }
    }

    /// Marks, in each row along x that pierces the triangle, the first sample behind it.
    void countCrossings(int t) {
        const Vec3& a = corner(t, 0);
        const Vec3 u = corner(t, 1) - a;
        const Vec3 v = corner(t, 2) - a;
        const double area = u.y() * v.z() - u.z() * v.y();
        if (area == 0) {
            return;
        }
        const auto [y0, y1] = cellRange(t, 1, 0);
        const auto [z0, z1] = cellRange(t, 2, 0);
        for (int z = z0; z <= z1; ++z) {
            for (int y = y0; y <= y1; ++y) {
                const Vec3 q = sample(0, y, z) - a;
                const double s = (q.y() * v.z() - q.z() * v.y()) / area;
                const double r = (u.y() * q.z() - u.z() * q.y()) / area;
                if (s >= 0 && r >= 0 && s + r <= 1) {
                    const double x = (a.x() + s * u.x() + r * v.x() - field_.origin.x());
                    const int first = std::max(int(std::ceil(x / field_.spacing)), 0);
                    if (first < field_.size[0]) {
                        ++crossings_[field_.index(first, y, z)];
                    }
                }
            }
        }
    }

    void sweep(int dx, int dy, int dz) {
        const auto start = [](int d, int n) { return d > 0 ? 0 : n - 1; };
        const auto inside = [](int i, int n) { return i >= 0 && i < n; };
        const auto [nx, ny, nz] = field_.size;
        for (int z = start(dz, nz); inside(z, nz); z += dz) {
            for (int y = start(dy, ny); inside(y, ny); y += dy) {
                for (int x = start(dx, nx); inside(x, nx); x += dx) {
                    const int cell = field_.index(x, y, z);
                    takeFrom(cell, x, y, z, inside(x - dx, nx) ? field_.index(x - dx, y, z) : cell);
                    takeFrom(cell, x, y, z, inside(y - dy, ny) ? field_.index(x, y - dy, z) : cell);
                    takeFrom(cell, x, y, z, inside(z - dz, nz) ? field_.index(x, y, z - dz) : cell);
                }
            }
        }
    }

    void takeFrom(int cell, int x, int y, int z, int neighbour) {
        const int t = nearest_[neighbour];
        if (t >= 0 && t != nearest_[cell]) {
            tryTriangle(cell, sample(x, y, z), t);
        }
    }

    void writeValues() {
        for (int z = 0; z < field_.size[2]; ++z) {
            for (int y = 0; y < field_.size[1]; ++y) {
                int crossed = 0;
                for (int x = 0; x < field_.size[0]; ++x) {
                    const int cell = field_.index(x, y, z);
                    crossed += crossings_[cell];
                    const double d = std::sqrt(distance_[cell]);
                    field_.values[cell] = float(crossed % 2 == 1 ? d : -d);
                    field_.deepest = std::max(field_.deepest, double(field_.values[cell]));
                }
            }
        }
        for (float& value : field_.values) {
            value = float(value / std::max(field_.deepest, 1e-12));
        }
    }

    const SurfaceMesh& mesh_;
    DepthField field_;
    std::vector<int> nearest_;
    std::vector<double> distance_;
    std::vector<int> crossings_;
};

}  // namespace

DepthField measureDepth(const SurfaceMesh& mesh, int resolution) {
    return Measurement(mesh, resolution).run();
}

DepthField measureSkinDepth(const SurfaceMesh& mesh) {
    constexpr int kResolution = 56;
    return mesh.aliveTriangles() > 0 ? measureDepth(mesh, kResolution) : DepthField{};
}

DepthTexture::DepthTexture(const DepthField& field) : id_(gpu::makeTexture(GL_TEXTURE_3D)) {
    const auto [nx, ny, nz] = field.size;
    const std::uint32_t id = id_.get();
    glTextureStorage3D(id, 1, GL_R16F, nx, ny, nz);
    glTextureSubImage3D(id, 0, 0, 0, 0, nx, ny, nz, GL_RED, GL_FLOAT, field.values.data());
    glTextureParameteri(id, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTextureParameteri(id, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R}) {
        glTextureParameteri(id, axis, GL_CLAMP_TO_EDGE);
    }
    const Vec3 sizes(nx, ny, nz);
    origin_ = (field.origin - Vec3::Constant(0.5 * field.spacing)).cast<float>();
    scale_ = (sizes * field.spacing).cwiseInverse().cast<float>();
}

void DepthTexture::bind(std::uint32_t unit) const {
    glBindTextureUnit(unit, id_.get());
}

}  // namespace kerf::render
