#include "sim/contact/contact_tree.h"

#include "shaders/shared/body_records.h"
#include "shaders/shared/contact_bindings.h"
#include "shaders/shared/contact_records.h"
#include "sim/base/containers.h"
#include "sim/body/body_model.h"
#include "sim/contact/contact_solver.h"

namespace kerf {

namespace {

using gpu::TexelFormat;
using shared::kTreeFan;
using shared::uint;

constexpr uint kMostUnordered = 4;  // one in as many

uint roundedUp(std::size_t count, uint step) {
    return static_cast<uint>((std::max<std::size_t>(count, 1) + step - 1) / step * step);
}

/// How many nodes each level has, the lowest first; at least two (shaders/sim/contact/fit.comp).
std::vector<uint> levelsOver(std::size_t places) {
    std::vector<uint> levels{static_cast<uint>(places / kTreeFan)};
    do {
        levels.push_back(roundedUp(levels.back() / kTreeFan, kTreeFan));
    } while (levels.back() > kTreeFan);
    return levels;
}

/// Every third bit of a number of ten.
uint spread(uint bits) {
    bits = (bits | bits << 16) & 0x030000FFu;
    bits = (bits | bits << 8) & 0x0300F00Fu;
    bits = (bits | bits << 4) & 0x030C30C3u;
    return (bits | bits << 2) & 0x09249249u;
}

/// Along a curve through the cube of this side about `low`: neighbours on it are near.
uint placeOnCurve(const Vec3f& p, const Vec3f& low, float side) {
    const auto cell = [&](float at, float from) {
        return spread(static_cast<uint>(std::clamp((at - from) / side, 0.0F, 1.0F) * 1023));
    };
    return cell(p.x(), low.x()) | cell(p.y(), low.y()) << 1 | cell(p.z(), low.z()) << 2;
}

/// Triangles piece by piece, within a piece so that neighbours come together.
std::vector<uint> orderOf(const std::vector<std::array<uint, 4>>& triangles,
                          const std::vector<Vec3f>& rest) {
    Vec3f low = Vec3f::Constant(1e30F);
    for (const Vec3f& p : rest) {
        low = low.cwiseMin(p);
    }
    float side = 1e-30F;
    for (const Vec3f& p : rest) {
        side = std::max(side, (p - low).maxCoeff());
    }
    std::vector<std::pair<std::uint64_t, uint>> keys;
    keys.reserve(triangles.size());
    for (const std::array<uint, 4>& t : triangles) {
        const std::uint64_t piece = t[3] >> 8;
        keys.emplace_back(piece << 32 | placeOnCurve(rest[t[0]], low, side),
                          static_cast<uint>(keys.size()));
    }
    std::ranges::sort(keys);
    return mapped(keys, [](const auto& key) { return key.second; });
}

/// As the triangles that touch them, then those that none touches.
std::vector<uint> verticesAlong(const std::vector<uint>& order,
                                const std::vector<std::array<uint, 4>>& triangles, uint count) {
    std::vector<uint> vertices;
    std::vector<bool> seen(count, false);
    const auto add = [&](uint v) {
        if (!seen[v]) {
            seen[v] = true;
            vertices.push_back(v);
        }
    };
    for (const uint t : order) {
        std::for_each_n(triangles[t].begin(), 3, add);
    }
    for (uint v = 0; v < count; ++v) {
        add(v);
    }
    return vertices;
}

/// Adds the numbers up to `end` that are not there yet, and fills up to a multiple of `step`.
void extend(std::vector<uint>& order, uint end, uint step) {
    while (!order.empty() && order.back() == shared::kNoVertex) {
        order.pop_back();
    }
    for (uint next = static_cast<uint>(order.size()); next < end; ++next) {
        order.push_back(next);
    }
    order.resize(roundedUp(order.size(), step), shared::kNoVertex);
}

/// Extends an order, and writes what is behind its first `kept` places to its buffer.
void extendOnGpu(std::vector<uint>& order, std::size_t kept, uint end, uint step,
                 gpu::Buffer& buffer) {
    extend(order, end, step);
    buffer.resize(order.size() * sizeof(uint));
    buffer.write(kept, std::span<const uint>(order).subspan(kept));
}

}  // namespace

void ContactOrder::follow(const BodyModel& model, bool isNew) {
    const std::size_t ordered = triangles_.size();
    if (!isNew && model.pieces.size() == pieces_ &&
        model.triangles.size() < ordered + ordered / kMostUnordered) {
        return;
    }
    triangles_ = orderOf(model.triangles, model.restPositions);
    vertices_ =
        verticesAlong(triangles_, model.triangles, static_cast<uint>(model.restPositions.size()));
    pieces_ = model.pieces.size();
    ++revision_;
}

ContactTree::ContactTree() : fit_(gpu::Program::compute("sim/contact/fit.comp")) {}

void ContactTree::take(const ContactBody& body) {
    const ContactOrder none;
    const ContactOrder& order = body.order != nullptr ? *body.order : none;
    const bool isKept = revision_ == order.revision();
    if (!isKept) {
        triangles_ = order.triangles();
        vertices_ = order.vertices();
        revision_ = order.revision();
    }
    // What comes later lies together too: where it was cut.
    extendOnGpu(triangles_, isKept ? order.triangles().size() : 0, body.triangleCount,
                kTreeFan * kTreeFan, triangleOrder_);
    extendOnGpu(vertices_, isKept ? order.vertices().size() : 0, body.vertexCount,
                shared::kSearchGroup, vertexOrder_);
    const std::vector<uint> levels = levelsOver(triangles_.size());
    boxes_.resize(triangles_.size() * 2 * sizeof(std::array<uint, 4>));
    nodes_.resize(std::reduce(levels.begin(), levels.end()) * 4 * sizeof(std::array<uint, 4>));
    groupLeaves_.resize(vertices_.size() / shared::kSearchGroup * shared::kMostGroupLeaves *
                        sizeof(std::array<uint, 2>));
}

void ContactTree::fit(const ContactBody& body, const gpu::Buffer& positions,
                      const gpu::Buffer& velocities, const ContactNormals& normals) const {
    positions.bindTexels(shared::kContactPositionsBinding, TexelFormat::float32x4);
    velocities.bindTexels(shared::kContactVelocitiesBinding, TexelFormat::float32x4);
    body.restPositions->bindTexels(shared::kContactRestBinding, TexelFormat::float32x4);
    body.triangles->bindTexels(shared::kContactTrianglesBinding, TexelFormat::uint32x4);
    body.incidenceRanges->bindTexels(shared::kContactRangesBinding, TexelFormat::uint32x2);
    body.incidence->bindTexels(shared::kContactIncidenceBinding, TexelFormat::uint32);
    body.columns->bindTexels(shared::kContactColumnsBinding, TexelFormat::uint32x4);
    body.columnRanges->bindTexels(shared::kContactColumnRangesBinding, TexelFormat::uint32x2);
    body.columnShares->bindTexels(shared::kContactColumnSharesBinding, TexelFormat::uint32x2);
    triangleOrder_.bindTexels(shared::kContactOrderBinding, TexelFormat::uint32);
    body.pieces->bindStorage(shared::kContactPiecesBinding);
    boxes_.bindStorage(shared::kContactBoxesBinding);
    nodes_.bindStorage(shared::kContactNodesBinding);
    const auto find = [&](const gpu::Buffer* found, uint binding) {
        if (found != nullptr) {
            found->bindStorage(binding);
        }
        return found != nullptr ? body.vertexCount : 0;
    };
    const uint vertices = find(normals.current, shared::kContactNormalsBinding);
    const uint restVertices = find(normals.rest, shared::kContactRestNormalsBinding);
    fit_.setNumbers({leaves(), vertices, restVertices});
    fit_.dispatch(std::max(leaves(), vertices));
}

void ContactTree::bind() const {
    boxes_.bindTexels(shared::kContactBoxesBinding, TexelFormat::uint32x4);
    nodes_.bindTexels(shared::kContactNodesBinding, TexelFormat::uint32x4);
    vertexOrder_.bindTexels(shared::kContactOrderBinding, TexelFormat::uint32);
    groupLeaves_.bindImage(shared::kContactGroupLeavesUnit, TexelFormat::uint32x2);
}

uint ContactTree::roots() const {
    const std::vector<uint> levels = levelsOver(triangles_.size());
    return std::reduce(levels.begin(), levels.end() - 1);
}

uint ContactTree::leaves() const {
    return levelsOver(triangles_.size()).front();
}

}  // namespace kerf
