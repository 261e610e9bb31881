#pragma once

#include "sim/body/body_model.h"

namespace kerf {

/// Nodes and springs of a body as a soft body of Bullet (its position-based solver, one thread,
/// Gauss-Seidel over links, single precision): a peer for the speed of projecting constraints.
class BulletSoftBody {
  public:
    /// A node per vertex and a link per edge of `model`; bending and inside are left out.
    explicit BulletSoftBody(const BodyModel& model, int iterations);
    ~BulletSoftBody();
    BulletSoftBody(const BulletSoftBody&) = delete;
    BulletSoftBody& operator=(const BulletSoftBody&) = delete;

    /// Advances the nodes by a step of `seconds` under gravity, without projecting anything.
    void predict(double seconds);
    /// All iterations of a step over all links, with Bullet's preparation.
    void project();
    int links() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace kerf
