#include "sim/contact/edge_push.h"

#include "shaders/shared/body_records.h"
#include "shaders/shared/edge_records.h"
#include "shaders/shared/implicit_records.h"
#include "sim/contact/obstacles.h"

namespace kerf {

namespace {

static_assert(sizeof(shared::EdgeUniforms) == 64);
static_assert(sizeof(shared::EdgeState) == 32);

shared::EdgeUniforms uniformsOf(const PressingEdge& edge, const ContactSettings& settings,
                                std::uint32_t vertexCount) {
    const double square = settings.substep * settings.substep;
    shared::EdgeUniforms u{};
    u.from = packed(edge.from, edge.reach);
    u.to = packed(edge.to, 1 / (edge.stiffness * square));
    u.ahead = packed(edge.ahead, edge.mostForce * square);
    u.lag = static_cast<float>(edge.lag);
    u.way = static_cast<float>(edge.way / settings.substeps);
    u.inverse_density = static_cast<float>(settings.inverseDensity);
    u.vertex_count = vertexCount;
    return u;
}

}  // namespace

void EdgePush::setEdge(const std::optional<PressingEdge>& edge) {
    edge_ = edge;
    if (edge_ && !weigh_) {
        weigh_ = gpu::Program::compute("sim/edge/weights.comp");
    }
}

void EdgePush::beginStep() {
    if (!edge_) {
        return;
    }
    const shared::EdgeUniforms uniforms = uniformsOf(*edge_, settings_, body_.vertexCount);
    uniforms_.assign(std::span<const shared::EdgeUniforms>(&uniforms, 1));
    weights_.resize(body_.vertexCount * sizeof(float));
    state_.resize(sizeof(shared::EdgeState));
    bind();
    weigh_->dispatchGroups(1);
}

void EdgePush::bindPressing() const {
    uniforms_.bindStorage(shared::kPressEdgeBinding);
    weights_.bindStorage(shared::kPressWeightsBinding);
    state_.bindStorage(shared::kPressStateBinding);
}

void EdgePush::askForLoad(gpu::ReadBack& back) {
    place_.reset();
    if (edge_ && state_.size() > 0) {
        place_ = back.ask(state_, sizeof(shared::EdgeState));
    }
}

/// An impulse changes d as a force does in a substep of length h.
void EdgePush::takeLoad(const gpu::ReadBack& back) {
    load_ = {};
    if (!place_) {
        return;
    }
    const shared::EdgeState& state = back.read<shared::EdgeState>(*place_, 1).front();
    const double square = settings_.substep * settings_.substep;
    const Vec3 middle(state.middle.x, state.middle.y, state.middle.z);
    load_ = {state.impulse / (square * settings_.substeps), edge_->from + middle,
             state.work / square};
}

void EdgePush::bind() const {
    uniforms_.bindStorage(shared::kEdgeUniformsBinding);
    body_.positions->bindStorage(shared::kEdgePositionsBinding);
    weights_.bindStorage(shared::kEdgeWeightsBinding);
    state_.bindStorage(shared::kEdgeStateBinding);
}

}  // namespace kerf
