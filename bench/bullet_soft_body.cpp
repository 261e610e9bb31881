#include "bench/bullet_soft_body.h"

#include <BulletSoftBody/btSoftBody.h>
#include <BulletSoftBody/btSoftBodyHelpers.h>

namespace kerf {

struct BulletSoftBody::State {
    btSoftBodyWorldInfo world;
    std::unique_ptr<btSoftBody> body;
};

BulletSoftBody::BulletSoftBody(const BodyModel& model, int iterations)
    : state_(std::make_unique<State>()) {
    std::vector<btVector3> positions;
    for (const Vec3f& p : model.restPositions) {
        positions.emplace_back(p.x(), p.y(), p.z());
    }
    state_->world.m_gravity.setValue(0, btScalar(-9.81), 0);
    state_->body = std::make_unique<btSoftBody>(&state_->world, static_cast<int>(positions.size()),
                                                positions.data(), nullptr);
    for (const EdgeConstraint& edge : model.edges) {
        // Looking for doubles would take the square of their number.
        state_->body->appendLink(static_cast<int>(edge.a), static_cast<int>(edge.b), nullptr,
                                 false);
    }
    state_->body->m_cfg.piterations = iterations;
    state_->body->m_cfg.viterations = 0;
    state_->body->m_cfg.diterations = 0;
}

BulletSoftBody::~BulletSoftBody() = default;

void BulletSoftBody::predict(double seconds) {
    state_->body->predictMotion(static_cast<btScalar>(seconds));
}

void BulletSoftBody::project() {
    state_->body->solveConstraints();
}

int BulletSoftBody::links() const {
    return state_->body->m_links.size();
}

}  // namespace kerf
