#include "sim/contact/paper_contact.h"

#include "shaders/shared/box_records.h"
#include "shaders/shared/contact_bindings.h"

namespace kerf {

namespace {

using shared::uint;

static_assert(sizeof(shared::PaperRequest) == 28);

constexpr double kFarthestWay = 0.5;   // h: that one pair may move a vertex in a time step
constexpr double kFarthestPush = 0.1;  // h: of it, by being pushed apart
constexpr double kStepsOfAWay = 0x1p20;

}  // namespace

shared::ContactUniforms paperContactUniforms(const ContactSettings& settings, double edgeLength) {
    const double timeStep = settings.substep * settings.substeps;
    const double lift = settings.liftSpeed * settings.sweeps * timeStep;
    shared::ContactUniforms u{};
    u.h = static_cast<float>(edgeLength);
    u.interval = static_cast<float>(timeStep);
    u.reach = static_cast<float>(kFarthestWay * edgeLength);
    u.margin = static_cast<float>(std::min(lift, kFarthestPush * edgeLength));
    u.unit = static_cast<float>(kFarthestWay * edgeLength / kStepsOfAWay);
    return u;
}

PaperContact::PaperContact() {
    state_.resize(sizeof(shared::ContactState));
}

void PaperContact::setBody(const ContactBody& body, double edgeLength) {
    body_ = body;
    edgeLength_ = edgeLength;
    bodyIsNew_ = true;
}

void PaperContact::respond(uint pieces) {
    state_.clear();
    if (pieces < 2) {
        return;
    }
    if (!kernels_) {
        kernels_.emplace(Kernels{gpu::Program::compute("sim/paper_contact/pieces.comp"),
                                 gpu::Program::compute("sim/paper_contact/meet.comp"),
                                 gpu::Program::compute("sim/paper_contact/answer.comp"),
                                 ContactTree()});
    }
    makeRoom(pieces);
    bind();
    kernels_->pieces.dispatch(body_.triangleCount);
    const ContactTree& tree = kernels_->tree;
    tree.fit(body_, *body_.positions, *body_.velocities);
    tree.bind();
    kernels_->meet.setNumbers({pieces, tree.roots(), tree.leaves()});
    kernels_->meet.dispatch(body_.triangleCount);
    kernels_->answer.dispatch(body_.vertexCount);
}

/// Pieces begin with empty boxes.
void PaperContact::makeRoom(uint pieces) {
    constexpr uint kMost = ~0u;
    if (std::exchange(bodyIsNew_, false)) {
        kernels_->tree.take(body_);
    }
    asked_.resize(std::max(body_.triangleCount, 1u) * sizeof(shared::PaperRequest));
    asked_.clear();
    pieceBounds_.assign(std::vector<shared::PieceBounds>(pieces, {kMost, kMost, kMost, 0, 0, 0}));
    shared::ContactUniforms uniforms = paperContactUniforms(settings_, edgeLength_);
    uniforms.vertex_count = body_.vertexCount;
    uniforms.triangle_count = body_.triangleCount;
    uniforms_.assign(std::span<const shared::ContactUniforms>(&uniforms, 1));
}

void PaperContact::bind() const {
    uniforms_.bindStorage(shared::kContactUniformsBinding);
    body_.positions->bindStorage(shared::kContactPositionsBinding);
    body_.velocities->bindStorage(shared::kContactVelocitiesBinding);
    body_.triangles->bindStorage(shared::kContactTrianglesBinding);
    body_.incidenceRanges->bindStorage(shared::kPaperRangesBinding);
    body_.incidence->bindStorage(shared::kPaperIncidenceBinding);
    asked_.bindStorage(shared::kPaperRequestsBinding);
    pieceBounds_.bindStorage(shared::kPaperPiecesBinding);
    state_.bindStorage(shared::kContactStateBinding);
}

}  // namespace kerf
