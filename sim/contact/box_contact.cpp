#include "sim/contact/box_contact.h"

#include <algorithm>
#include <span>
#include <utility>

#include "shaders/shared/body_records.h"

namespace kerf {

namespace {

using shared::uint;

static_assert(sizeof(shared::BoxUniforms) == 40);
static_assert(sizeof(shared::BoxRecord) == 64);
static_assert(sizeof(shared::BoxTouch) == 48);

constexpr double kDepth = 0.5;  // h
constexpr double kSpeedUp = 4;  // that a body may undergo in a time step

shared::vec4 packed(const Vec3& v, double w) {
    return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z()),
            static_cast<float>(w)};
}

shared::BoxRecord recordOf(const StaticBox& box) {
    const Eigen::Matrix3d axes = box.axes();
    const Vec3 half = 0.5 * box.size;
    return {packed(box.center, 0), packed(axes.col(0), half.x()), packed(axes.col(1), half.y()),
            packed(axes.col(2), half.z())};
}

std::vector<shared::BoxRecord> boxesNear(const std::vector<StaticBox>& boxes,
                                         const Bounds& bounds) {
    std::vector<shared::BoxRecord> records;
    for (const StaticBox& box : boxes) {
        if (box.bounds().overlaps(bounds)) {
            records.push_back(recordOf(box));
        }
    }
    return records;
}

}  // namespace

void BoxContact::setBoxes(std::vector<StaticBox> boxes) {
    boxes_ = std::move(boxes);
    if (!boxes_.empty() && !kernels_) {
        kernels_.emplace(Kernels{gpu::Program::compute("sim/boxes/triangles.comp"),
                                 gpu::Program::compute("sim/boxes/respond.comp"),
                                 gpu::Program::compute("sim/boxes/apply.comp"),
                                 gpu::Program::compute("sim/boxes/vertices.comp")});
    }
}

void BoxContact::setBody(const ContactBody& body, double edgeLength) {
    body_ = body;
    edgeLength_ = edgeLength;
}

void BoxContact::beginStep(const BodyReach& reach) {
    Bounds around = reach.bounds;
    const double duration = settings_.substep * settings_.substeps;
    around.widen(reach.margin + kSpeedUp * reach.speed * duration);
    const std::vector<shared::BoxRecord> near = boxesNear(boxes_, around);
    reached_ = !near.empty();
    if (!reached_) {
        return;
    }
    boxBuffer_.assign(near);
    records_.resize(std::max(body_.triangleCount, 1u) * sizeof(shared::BoxTouch));
    shares_.resize(body_.vertexCount * sizeof(uint));
    sums_.resize(body_.vertexCount * 6 * sizeof(int));
    uploadUniforms(near.size());
}

void BoxContact::uploadUniforms(std::size_t boxCount) {
    shared::BoxUniforms u{};
    u.thickness = static_cast<float>(settings_.thickness * edgeLength_);
    u.depth = static_cast<float>(kDepth * edgeLength_) + u.thickness;
    u.lift = static_cast<float>(settings_.liftSpeed * settings_.sweeps * settings_.substep);
    u.push = static_cast<float>(settings_.liftSpeed * settings_.substep);
    u.friction = static_cast<float>(settings_.friction);
    u.inverse_density = static_cast<float>(settings_.inverseDensity);
    u.unit = static_cast<float>(fixedUnit(settings_));
    u.vertex_count = body_.vertexCount;
    u.triangle_count = body_.triangleCount;
    u.box_count = static_cast<uint>(boxCount);
    uniformBuffer_.assign(std::span<const shared::BoxUniforms>(&u, 1));
}

void BoxContact::respond() {
    if (!reached_) {
        return;
    }
    uniformBuffer_.bindStorage(shared::kBoxUniformsBinding);
    body_.positions->bindStorage(shared::kBoxPositionsBinding);
    body_.displacement->bindStorage(shared::kBoxDisplacementBinding);
    body_.triangles->bindStorage(shared::kBoxTrianglesBinding);
    boxBuffer_.bindStorage(shared::kBoxBoxesBinding);
    records_.bindStorage(shared::kBoxRecordsBinding);
    shares_.bindStorage(shared::kBoxSharesBinding);
    sums_.bindStorage(shared::kBoxSumsBinding);
    run(kernels_->triangles, body_.triangleCount);
    run(kernels_->respond, body_.triangleCount);
    run(kernels_->apply, body_.vertexCount);
    run(kernels_->vertices, body_.vertexCount);
}

void BoxContact::run(const gpu::Program& kernel, uint threads) {
    kernel.dispatch(threads, shared::kGroupSize);
    gpu::storageBarrier();
}

}  // namespace kerf
