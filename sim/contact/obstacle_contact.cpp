#include "sim/contact/obstacle_contact.h"

#include <bit>

#include "gpu/fetched_buffer.h"
#include "shaders/shared/bindings.h"
#include "shaders/shared/blade_records.h"
#include "shaders/shared/body_records.h"
#include "shaders/shared/implicit_records.h"

namespace kerf {

namespace {

using shared::uint;

static_assert(sizeof(shared::BoxUniforms) == 44);
static_assert(sizeof(shared::BoxTouch) == 48);
static_assert(sizeof(shared::PieceBounds) == 24);
static_assert(sizeof(shared::BoxPlanes) == sizeof(shared::BoxTouch));

constexpr double kSpeedUp = 4;  // that a body may undergo in a time step

/// Where a body may come in a time step.
Bounds boundsInStep(const BodyReach& reach, const ContactSettings& settings) {
    Bounds around = reach.bounds;
    const double duration = settings.substep * settings.substeps;
    around.widen(reach.margin + kSpeedUp * reach.speed * duration);
    return around;
}

shared::BoxUniforms uniformsOf(const ContactSettings& settings, const ContactBody& body,
                               const TouchDistances& distances, double floor, uint boxCount) {
    shared::BoxUniforms u{};
    u.thickness = distances.thickness;
    u.depth = distances.depth;
    u.lift = static_cast<float>(settings.liftSpeed * settings.sweeps * settings.substep);
    u.push = static_cast<float>(settings.liftSpeed * settings.substep);
    u.friction = static_cast<float>(settings.friction);
    u.inverse_density = static_cast<float>(settings.inverseDensity);
    u.unit = static_cast<float>(fixedUnit(settings));
    u.floor_height = static_cast<float>(floor);
    u.vertex_count = body.vertexCount;
    u.triangle_count = body.triangleCount;
    u.box_count = boxCount;
    return u;
}

}  // namespace

void ObstacleContact::setObstacles(std::unique_ptr<const Obstacles> obstacles) {
    obstacles_ = std::move(obstacles);
    if (obstacles_ && !kernels_) {
        kernels_.emplace(Kernels{gpu::Program::compute("sim/boxes/triangles.comp", kind_.triangles),
                                 gpu::Program::compute("sim/boxes/respond.comp"),
                                 gpu::Program::compute("sim/boxes/apply.comp"),
                                 gpu::Program::compute(kind_.vertices), std::nullopt, std::nullopt,
                                 std::nullopt, std::nullopt, std::nullopt, std::nullopt});
        if (kind_.movesPiecesOut) {
            kernels_->pieces = gpu::Program::compute("sim/boxes/pieces.comp");
        }
    }
}

void ObstacleContact::setBody(const ContactBody& body, double edgeLength) {
    body_ = body;
    edgeLength_ = edgeLength;
}

void ObstacleContact::beginStep(const BodyReach& reach) {
    const Bounds bounds = boundsInStep(reach, settings_);
    reached_ = obstacles_ ? static_cast<uint>(obstacles_->write(bounds, records_)) : 0;
    keepsSides_ = mayTouch() && kind_.keepsSides && obstacles_->mayPierce(bounds, edgeLength_);
    if (!mayTouch()) {
        return;
    }
    if (keepsSides_ && !kernels_->sides) {
        kernels_->planes = gpu::Program::compute("sim/boxes/planes.comp");
        kernels_->sides = gpu::Program::compute("sim/boxes/sides.comp");
    }
    makeRoom();
    if (measuresLoad_) {
        beginLoad();
    }
    const shared::BoxUniforms uniforms = uniformsOf(
        settings_, body_, obstacles_->distances(settings_, edgeLength_), reach.floor, reached_);
    uniforms_.assign(std::span<const shared::BoxUniforms>(&uniforms, 1));
    boundPieces();
}

void ObstacleContact::beginLoad() {
    if (!kernels_->load) {
        kernels_->load = gpu::Program::compute(kind_.load);
    }
    loads_.resize(body_.vertexCount * sizeof(shared::VertexLoad));
    loads_.clear();
}

/// After obstacles have changed d.
void ObstacleContact::addLoad() {
    before_.bindStorage(shared::kBladeBeforeBinding);
    loads_.bindStorage(shared::kBladeLoadsBinding);
    kernels_->load->setNumbers({0});
    kernels_->load->dispatch(body_.vertexCount);
}

void ObstacleContact::askForLoad(gpu::ReadBack& back) {
    place_.reset();
    if (mayTouch() && measuresLoad_ && loads_.size() > 0) {
        place_ = back.ask(loads_, loads_.size());
    }
}

/// Summed up by vertex, so that the order of threads does not matter. A change of d is one of
/// velocity by d / h, at each substep of length h.
void ObstacleContact::takeLoad(const gpu::ReadBack& back) {
    load_ = {};
    if (!place_) {
        return;
    }
    BladeLoad sum;
    const std::size_t count = loads_.size() / sizeof(shared::VertexLoad);
    for (const shared::VertexLoad& of : back.read<shared::VertexLoad>(*place_, count)) {
        sum.force -= Vec3(of.given.x, of.given.y, of.given.z);
        sum.moment -= Vec3(of.moment.x, of.moment.y, of.moment.z);
    }
    const double h = settings_.substep;
    const double scale = 1 / (h * h * settings_.substeps);
    load_ = {scale * sum.force, scale * sum.moment};
}

/// Pieces begin with empty boxes.
void ObstacleContact::boundPieces() {
    if (kernels_->pieces) {
        constexpr uint kMost = ~0u;
        const std::size_t count = body_.pieces->size() / sizeof(shared::PieceRecord);
        pieceBounds_.assign(
            std::vector<shared::PieceBounds>(count, {kMost, kMost, kMost, 0, 0, 0}));
        bind();
        kernels_->pieces->dispatch(body_.vertexCount);
    }
}

void ObstacleContact::makeRoom() {
    touches_.resize(std::max(body_.triangleCount, 1u) * sizeof(shared::BoxTouch));
    shares_.resize(body_.vertexCount * sizeof(uint));
    sums_.resize(body_.vertexCount * 6 * sizeof(int));
    start_.resize(kind_.keepsSides ? body_.vertexCount * sizeof(shared::vec4) : 0);
}

void ObstacleContact::beginSubstep() {
    if (keepsSides_) {
        start_.copyFrom(*body_.positions);
    }
}

void ObstacleContact::respond() {
    if (!mayTouch()) {
        return;
    }
    bind();
    // For those that move; the kernels of others do without.
    if (measuresLoad_) {
        before_.copyFrom(*body_.displacement);
    }
    kernels_->triangles.setNumbers({0});
    kernels_->vertices.setNumbers({0});
    kernels_->triangles.dispatch(body_.triangleCount);
    kernels_->respond.dispatch(body_.triangleCount);
    kernels_->apply.dispatch(body_.vertexCount);
    if (kind_.seesAround) {
        around_.copyFrom(*body_.positions);
        around_.bindStorage(shared::kBladeAroundBinding);
    }
    kernels_->vertices.dispatch(body_.vertexCount);
    if (measuresLoad_) {
        addLoad();
    }
    if (keepsSides_) {
        kernels_->planes->dispatch(body_.triangleCount);
        kernels_->sides->dispatch(body_.vertexCount);
    }
}

void ObstacleContact::keepSides(const gpu::Buffer& velocities, double h) {
    if (!keepsSides_) {
        return;
    }
    if (!kernels_->sidesOfStep) {
        const gpu::Defines ofStep{{"OF_STEP", "1"}};
        kernels_->planesOfStep = gpu::Program::compute("sim/boxes/planes.comp", ofStep);
        kernels_->sidesOfStep = gpu::Program::compute("sim/boxes/sides.comp", ofStep);
    }
    bind();
    velocities.bindStorage(shared::kVelocitiesBinding);
    kernels_->planesOfStep->dispatch(body_.triangleCount);
    kernels_->sidesOfStep->setNumbers({std::bit_cast<uint>(static_cast<float>(h)), 0, 0, 0});
    kernels_->sidesOfStep->dispatch(body_.vertexCount);
}

void ObstacleContact::bindMeetings(gpu::KernelWay way) const {
    uniforms_.bindStorage(shared::kMeetObstacleBinding);
    bindFetched(records_, shared::kMeetBoxesUnit, gpu::TexelFormat::float32x4, way);
    bindFetched(*body_.triangles, shared::kMeetTrianglesUnit, gpu::TexelFormat::uint32x4, way);
    bindFetched(*body_.incidenceRanges, shared::kMeetRangesUnit, gpu::TexelFormat::uint32x2, way);
    bindFetched(*body_.incidence, shared::kMeetIncidenceUnit, gpu::TexelFormat::uint32, way);
    if (kernels_->pieces) {
        bindFetched(pieceBounds_, shared::kMeetPieceBoundsUnit, gpu::TexelFormat::uint32, way);
    }
}

bool ObstacleContact::bindLoads() const {
    if (!mayTouch() || !measuresLoad_) {
        return false;
    }
    loads_.bindStorage(shared::kMadeLoadsBinding);
    records_.bindStorage(shared::kLoadBladesBinding);
    return true;
}

void ObstacleContact::bind() const {
    uniforms_.bindStorage(shared::kBoxUniformsBinding);
    body_.positions->bindStorage(shared::kBoxPositionsBinding);
    body_.displacement->bindStorage(shared::kBoxDisplacementBinding);
    body_.triangles->bindStorage(shared::kBoxTrianglesBinding);
    records_.bindStorage(shared::kBoxBoxesBinding);
    touches_.bindStorage(shared::kBoxRecordsBinding);
    shares_.bindStorage(shared::kBoxSharesBinding);
    sums_.bindStorage(shared::kBoxSumsBinding);
    body_.incidenceRanges->bindStorage(shared::kBladeRangesBinding);
    body_.incidence->bindStorage(shared::kBladeIncidenceBinding);
    body_.links->bindStorage(shared::kBoxLinksBinding);
    if (kernels_->pieces) {
        pieceBounds_.bindStorage(shared::kBoxPiecesBinding);
    }
    if (kind_.keepsSides) {
        start_.bindStorage(shared::kBoxStartBinding);
    }
}

}  // namespace kerf
