#include "sim/contact/contact_solver.h"

#include "gpu/fetched_buffer.h"
#include "shaders/shared/bindings.h"
#include "shaders/shared/body_records.h"
#include "shaders/shared/contact_bindings.h"
#include "sim/body/solver_uniforms.h"
#include "sim/cut/wall_copies.h"

namespace kerf {

namespace {

using gpu::TexelFormat;
using shared::uint;

static_assert(sizeof(shared::ContactUniforms) == 48);
static_assert(sizeof(shared::ContactCandidate) == 8);
static_assert(sizeof(shared::ContactRecord) == 64);
static_assert(sizeof(shared::EdgePair) == 12);
static_assert(sizeof(shared::ContactState) == 40);

constexpr double kReach = 0.5;           // h
constexpr double kKept = 0.25;           // h: candidates are kept up to this motion
constexpr double kKeptInContact = 0.05;  // h: then the nearest one must be among them
constexpr double kFarthest = 2;          // h: no candidate beyond
constexpr double kTopSpeed = 400;        // that fixed-point displacements can hold [m/s]
constexpr uint kCandidatesPerPoint = shared::kCandidatesPerPoint;

/// A kernel of what a sweep spends its time in.
gpu::Program compileAnswer(const std::string& name, const gpu::Defines& defines = {}) {
    return gpu::fetchingKernel("sim/contact/" + name + ".comp", gpu::kernelWay(), defines);
}

/// How many times in a time step candidates are looked for, so that in between nothing moves much
/// farther than an edge.
int contactSearches(const ContactSettings& settings, double edgeLength, double relativeSpeed) {
    const double way = relativeSpeed * settings.substep * settings.substeps;
    const double wanted = std::ceil(way / ((kFarthest - kReach - kKept) * edgeLength));
    return static_cast<int>(std::clamp(wanted, 1.0, static_cast<double>(settings.substeps)));
}

}  // namespace

ContactSettings contactSettings(const Params& params) {
    ContactSettings settings;
    const shared::SolverUniforms solver = solverUniforms(params);
    settings.enabled = params.contact != 0 && params.paperContact == 0;
    settings.paper = params.paperContact != 0;
    settings.thickness = params.contactThickness;
    settings.sweeps = std::max(1, static_cast<int>(solver.sweeps));
    settings.liftSpeed = params.depenetrationSpeed / settings.sweeps;
    settings.friction = params.friction;
    settings.substeps = static_cast<int>(solver.substeps);
    settings.substep = params.timeStep / settings.substeps;
    settings.inverseDensity = 1 / params.density;
    return settings;
}

double fixedUnit(const ContactSettings& settings) {
    return kTopSpeed * settings.substep * 0x1p-31;
}

double contactEdgeLength(const BodyModel& model) {
    return wallEdgeFor(model.edgeLength, model.diagonal);
}

shared::ContactUniforms contactUniforms(const ContactSettings& settings, double edgeLength,
                                        double relativeSpeed) {
    const int searches = contactSearches(settings, edgeLength, relativeSpeed);
    const int between = (settings.substeps + searches - 1) / searches;
    const double interval = between * settings.substep;
    const double thickness = settings.thickness * edgeLength;
    const double reach = (kReach + kKept) * edgeLength + thickness;
    const double margin = std::min(reach + relativeSpeed * interval, kFarthest * edgeLength);
    shared::ContactUniforms u{};
    u.h = static_cast<float>(edgeLength);
    u.reach = static_cast<float>(reach);
    u.interval = static_cast<float>(interval);
    u.margin = static_cast<float>(std::max(margin, reach));
    u.thickness = static_cast<float>(thickness);
    u.substep = static_cast<float>(settings.substep);
    u.lift_speed = static_cast<float>(settings.liftSpeed);
    u.friction = static_cast<float>(settings.friction);
    u.inverse_density = static_cast<float>(settings.inverseDensity);
    u.unit = static_cast<float>(fixedUnit(settings));
    return u;
}

ContactSolver::ContactSolver() {
    kernels_.candidates = gpu::Program::compute("sim/contact/candidates.comp");
    kernels_.detect = compileAnswer("detect");
    kernels_.respond = compileAnswer("respond");
    kernels_.respondAgain = compileAnswer("respond", {{"SWEEP_AGAIN", "true"}});
    kernels_.apply = compileAnswer("apply", {{"APPLIES", "1"}});
    state_.resize(sizeof(shared::ContactState));
    searchedPositions_.resize(sizeof(shared::vec4));
}

void ContactSolver::setBody(const ContactBody& body, double edgeLength) {
    body_ = body;
    edgeLength_ = edgeLength;
    bodyIsNew_ = true;
    hasCandidates_ = false;
}

// Not before contact is on: the buffers are larger than the body's own.
void ContactSolver::takeBody() {
    const std::size_t n = body_.vertexCount;
    normals_.resize(2 * n * sizeof(shared::vec4));
    restNormals_.resize(2 * n * sizeof(shared::vec4));
    tree_.take(body_);
    candidates_.resize(n * kCandidatesPerPoint * sizeof(shared::ContactCandidate));
    points_.resize(n * sizeof(uint));
    edgePairs_.resize(n * shared::kEdgePairsPerPoint * sizeof(shared::EdgePair));
    records_.resize(2 * n * sizeof(shared::ContactRecord));
    state_.resize(sizeof(shared::ContactState) + n * sizeof(uint));
    sums_.resize(n * shared::kContactSumWords * sizeof(int));
}

void ContactSolver::uploadUniforms() {
    uniforms_.vertex_count = body_.vertexCount;
    uniforms_.triangle_count = body_.triangleCount;
    uniformBuffer_.assign(std::span<const shared::ContactUniforms>(&uniforms_, 1));
}

void ContactSolver::beginStep(const RelativeMotion& motion) {
    if (!enabled()) {
        return;
    }
    const double way = motion.speed * settings_.substep * settings_.substeps;
    const double kept = motion.touching ? kKeptInContact : kKept;
    keepsCandidates_ = hasCandidates_ && candidateSettings_ == settings_ &&
                       motion.drift + way <= kept * edgeLength_;
    foundNone_ = keepsCandidates_ && !motion.hasCandidates;
    if (keepsCandidates_) {
        return;
    }
    uniforms_ = contactUniforms(settings_, edgeLength_, motion.speed);
    uploadUniforms();
    if (bodyIsNew_) {
        takeBody();
    }
    const int searches = contactSearches(settings_, edgeLength_, motion.speed);
    substepsBetweenSearches_ = (settings_.substeps + searches - 1) / searches;
}

void ContactSolver::search() {
    searchedPositions_.copyFrom(*body_.positions);
    searchedVelocities_.copyFrom(*body_.velocities);
    candidateSettings_ = settings_;
    findFromSearched();
}

void ContactSolver::findFromSearched() {
    uniformBuffer_.bindStorage(shared::kContactUniformsBinding);
    state_.bindStorage(shared::kContactStateBinding);
    tree_.fit(body_, searchedPositions_, searchedVelocities_,
              {&normals_, std::exchange(bodyIsNew_, false) ? &restNormals_ : nullptr});
    findCandidates();
    ++searches_;
    hasCandidates_ = true;
}

ContactMemory ContactSolver::memory() const {
    if (!hasCandidates_) {
        return {};
    }
    return {searchedPositions_.read<shared::vec4>(0, body_.vertexCount),
            searchedVelocities_.read<shared::vec4>(0, body_.vertexCount),
            candidateSettings_,
            uniforms_,
            {},
            {}};
}

void ContactSolver::remember(const ContactMemory& memory) {
    if (memory.positions.empty()) {
        return;
    }
    candidateSettings_ = memory.settings;
    uniforms_ = memory.uniforms;
    uploadUniforms();
    takeBody();
    bodyIsNew_ = true;
    searchedPositions_.assign(memory.positions);
    searchedVelocities_.assign(memory.velocities);
    findFromSearched();
}

void ContactSolver::findCandidates() {
    tree_.bind();
    body_.restPositions->bindTexels(shared::kContactRestBinding, TexelFormat::float32x4);
    normals_.bindTexels(shared::kContactNormalsBinding, TexelFormat::float32x4);
    restNormals_.bindTexels(shared::kContactRestNormalsBinding, TexelFormat::float32x4);
    body_.links->bindStorage(shared::kContactLinksBinding);
    candidates_.bindStorage(shared::kContactCandidatesBinding);
    edgePairs_.bindStorage(shared::kContactEdgePairsBinding);
    points_.bindStorage(shared::kContactPointsBinding);
    kernels_.candidates.setNumbers({tree_.roots(), tree_.leaves(), settings_.edges ? 1U : 0U});
    kernels_.candidates.dispatch(tree_.vertexPlaces());
}

void ContactSolver::respond(gpu::KernelWay way) {
    if (!mayTouch()) {
        return;
    }
    bindAnswers({shared::kContactUniformsBinding, shared::kContactRecordsBinding,
                 shared::kContactSumsBinding, shared::kContactStateBinding},
                way);
    for (const auto& [buffer, binding] :
         {std::pair(body_.positions, shared::kContactPositionsBinding),
          std::pair(body_.displacement, shared::kContactDisplacementBinding)}) {
        buffer->bindStorage(binding);
        bindFetched(*buffer, binding, TexelFormat::float32x4, way);
    }
    runIndirect(kernels_.detect, offsetof(shared::ContactState, point_groups));
    // Two sweeps over the contacts, as in ReferenceContact.
    runIndirect(kernels_.respond, offsetof(shared::ContactState, point_groups));
    runIndirect(kernels_.respondAgain, offsetof(shared::ContactState, point_groups));
    runIndirect(kernels_.apply, offsetof(shared::ContactState, vertex_groups));
}

void ContactSolver::bindAnswers(const AnswerBindings& to, gpu::KernelWay way) const {
    uniformBuffer_.bindStorage(to.uniforms);
    records_.bindStorage(to.records);
    sums_.bindStorage(to.sums);
    state_.bindStorage(to.state);
    bindFetched(normals_, shared::kContactNormalsUnit, TexelFormat::float32x4, way);
    bindFetched(*body_.triangles, shared::kContactTrianglesUnit, TexelFormat::uint32x4, way);
    bindFetched(candidates_, shared::kContactCandidatesUnit, TexelFormat::uint32x2, way);
    bindFetched(points_, shared::kContactPointsUnit, TexelFormat::uint32, way);
    bindFetched(edgePairs_, shared::kContactEdgePairsUnit, TexelFormat::uint32, way);
}

void ContactSolver::runIndirect(const gpu::Program& kernel, std::size_t offset) {
    kernel.dispatchIndirect(state_, offset);
}

std::vector<std::vector<shared::ContactCandidate>> ContactSolver::readCandidates() const {
    const shared::ContactState state = readState();
    const auto points = points_.read<uint>(0, state.points);
    const auto all = candidates_.read<shared::ContactCandidate>(
        0, std::size_t{kCandidatesPerPoint} * body_.vertexCount);
    std::vector<std::vector<shared::ContactCandidate>> out(body_.vertexCount);
    for (const uint v : points) {
        for (uint k = 0; k < kCandidatesPerPoint; ++k) {
            const shared::ContactCandidate& candidate = all[kCandidatesPerPoint * v + k];
            if (candidate.triangle == shared::kNoVertex) {
                break;
            }
            out[v].push_back(candidate);
        }
    }
    return out;
}

shared::ContactState ContactSolver::readState() const {
    return state_.read<shared::ContactState>(0, 1).front();
}

}  // namespace kerf
