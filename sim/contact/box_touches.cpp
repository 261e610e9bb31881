#include "sim/contact/box_touches.h"

#include <algorithm>
#include <span>

#include "shaders/shared/body_records.h"

namespace kerf {

using shared::uint;

static_assert(sizeof(shared::BoxUniforms) == 40);
static_assert(sizeof(shared::BoxRecord) == 64);
static_assert(sizeof(shared::BoxTouch) == 48);

namespace {

constexpr double kSpeedUp = 4;  // that a body may undergo in a time step

}  // namespace

Bounds boundsInStep(const BodyReach& reach, const ContactSettings& settings) {
    Bounds around = reach.bounds;
    const double duration = settings.substep * settings.substeps;
    around.widen(reach.margin + kSpeedUp * reach.speed * duration);
    return around;
}

BoxTouches::BoxTouches(const gpu::Defines& defines)
    : triangles_(gpu::Program::compute("sim/boxes/triangles.comp", defines)),
      respond_(gpu::Program::compute("sim/boxes/respond.comp")),
      apply_(gpu::Program::compute("sim/boxes/apply.comp")) {}

void BoxTouches::resize(const ContactBody& body) {
    records_.resize(std::max(body.triangleCount, 1u) * sizeof(shared::BoxTouch));
    shares_.resize(body.vertexCount * sizeof(uint));
    sums_.resize(body.vertexCount * 6 * sizeof(int));
}

void BoxTouches::setUniforms(const shared::BoxUniforms& uniforms) {
    uniformBuffer_.assign(std::span<const shared::BoxUniforms>(&uniforms, 1));
}

void BoxTouches::bind(const ContactBody& body, const gpu::Buffer& boxes) const {
    uniformBuffer_.bindStorage(shared::kBoxUniformsBinding);
    body.positions->bindStorage(shared::kBoxPositionsBinding);
    body.displacement->bindStorage(shared::kBoxDisplacementBinding);
    body.triangles->bindStorage(shared::kBoxTrianglesBinding);
    boxes.bindStorage(shared::kBoxBoxesBinding);
    records_.bindStorage(shared::kBoxRecordsBinding);
    shares_.bindStorage(shared::kBoxSharesBinding);
    sums_.bindStorage(shared::kBoxSumsBinding);
}

void BoxTouches::solve(const ContactBody& body) const {
    runOver(triangles_, body.triangleCount);
    runOver(respond_, body.triangleCount);
    runOver(apply_, body.vertexCount);
}

shared::BoxUniforms boxUniforms(const ContactSettings& settings, const ContactBody& body,
                                std::size_t boxCount) {
    shared::BoxUniforms u{};
    u.lift = static_cast<float>(settings.liftSpeed * settings.sweeps * settings.substep);
    u.push = static_cast<float>(settings.liftSpeed * settings.substep);
    u.friction = static_cast<float>(settings.friction);
    u.inverse_density = static_cast<float>(settings.inverseDensity);
    u.unit = static_cast<float>(fixedUnit(settings));
    u.vertex_count = body.vertexCount;
    u.triangle_count = body.triangleCount;
    u.box_count = static_cast<uint>(boxCount);
    return u;
}

shared::vec4 packed(const Vec3& v, double w) {
    return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z()),
            static_cast<float>(w)};
}

shared::BoxRecord boxRecord(const Vec3& center, const Eigen::Matrix3d& axes, const Vec3& half) {
    return {packed(center, 0), packed(axes.col(0), half.x()), packed(axes.col(1), half.y()),
            packed(axes.col(2), half.z())};
}

void runOver(const gpu::Program& kernel, uint threads) {
    kernel.dispatch(threads, shared::kGroupSize);
    gpu::storageBarrier();
}

}  // namespace kerf
