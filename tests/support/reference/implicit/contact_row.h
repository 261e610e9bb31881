#pragma once

#include "shaders/shared/implicit_records.h"
#include "tests/support/reference/implicit/block_matrix.h"
#include "tests/support/reference/reference_solver.h"

namespace kerf {

/// Something that a point of the body presses on: an obstacle, or another point of the body. It
/// pushes with stiffness * depth, and holds with the same stiffness across, by friction * push at
/// most.
struct ContactRow {
    int count = 0;  ///< of its vertices
    std::array<std::uint32_t, 4> vertices{};
    std::array<double, 4> weights{};  ///< the point less the point that it presses on
    Vec3 normal = Vec3::UnitY();
    double gap = 0;                   ///< where the step begins; negative is inside [m]
    double stiffness = 0;             ///< [N/m]
    double friction = 0;              ///< Coulomb coefficient
    Vec3 slip = Vec3::Zero();         ///< across, what the step before has left held back [m]
    double push = 0;                  ///< of the stage before [N]
    double from = shared::kUndamped;  ///< the gap from where the second stage is damped [m]
    std::uint64_t memory = 0;         ///< by which the next step knows it again

    /// What it pushes at a gap, and how much less it does by metre of its opening.
    struct Push {
        double force = 0;
        double firmness = 0;
    };
    Push pushAt(double at) const {
        if (at > from) {
            const double pull = shared::kDampedContact * stiffness * (at - from);
            const double most = shared::kMostPull * push;
            return pull < most ? Push{-pull, shared::kDampedContact * stiffness} : Push{-most, 0};
        }
        return {stiffness * std::max(0.0, -at), at < 0 ? stiffness : 0};
    }
    /// Of the two points, by the motions of all vertices.
    Vec3 relative(std::span<const Vec3> motions) const {
        Vec3 sum = Vec3::Zero();
        for (int k = 0; k < count; ++k) {
            sum += weights[k] * motions[vertices[k]];
        }
        return sum;
    }
    Vec3 across(const Vec3& motion) const { return motion - normal * normal.dot(motion); }
    void addForce(const Vec3& force, std::span<Vec3> forces) const {
        for (int k = 0; k < count; ++k) {
            forces[vertices[k]] += weights[k] * force;
        }
    }
};
using ContactRows = std::vector<ContactRow>;

/// Finds what a body presses on.
class ContactFinder {
  public:
    virtual ~ContactFinder() = default;
    /// Of a step of `step` seconds from this state. Leaves stiffness, slip and push to the solver.
    virtual ContactRows find(const ReferenceState& state, double step) = 0;
};

}  // namespace kerf
