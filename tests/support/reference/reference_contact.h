#pragma once

#include "shaders/shared/contact_records.h"
#include "sim/body/body_model.h"
#include "tests/support/reference/reference_solver.h"

namespace kerf {

/// A triangle that a vertex may touch.
struct ReferenceCandidate {
    std::uint32_t triangle = 0;
    double thickness = 0;  ///< [m]
    double key = 0;        ///< distance as a share of how far the pair can move
};

/// Computes what the contact kernels compute, in double precision, without a grid, pair by pair:
/// the reference for their tests.
class ReferenceContact {
  public:
    /// `model` must outlive it. `inverseMass`: of each vertex [1/kg].
    ReferenceContact(const BodyModel& model, const shared::ContactUniforms& uniforms,
                     std::vector<double> inverseMass);

    /// The candidates of each vertex, nearest first, at most kCandidatesPerPoint.
    std::vector<std::vector<ReferenceCandidate>> findCandidates(const ReferenceState& state) const;
    /// The sweeps of a substep over the contacts: changes displacements and positions. Returns
    /// their number.
    int respond(const std::vector<std::vector<ReferenceCandidate>>& candidates,
                ReferenceState& state) const;

  private:
    struct Contact;

    bool isChip(int piece) const { return !model_.pieces[piece].holdsVolume; }
    bool consider(std::uint32_t vertex, std::uint32_t triangle, const ReferenceState& state,
                  ReferenceCandidate& candidate) const;
    bool mayTouch(std::uint32_t vertex, std::uint32_t triangle) const;
    bool detect(std::uint32_t vertex, const std::vector<ReferenceCandidate>& candidates,
                const ReferenceState& state, Contact& contact) const;

    /// Moves what a contact touches by a change of its relative vector; `taken`: by contacts, of
    /// each vertex.
    void apply(const Contact& contact, const std::vector<double>& taken, const Vec3& change,
               std::vector<Vec3>& vectors) const;
    void applyAll(const std::vector<Contact>& contacts, const std::vector<double>& taken,
                  const std::vector<Vec3>& changes, std::vector<Vec3>& vectors) const;
    /// The impulse after one more sweep.
    Vec3 goOn(const Contact& contact, const std::vector<Vec3>& displacements) const;

    const BodyModel& model_;
    shared::ContactUniforms uniforms_;
    std::vector<double> inverseMass_;
    std::vector<Vec3> rest_;
    std::vector<std::array<Vec3, 2>> restNormals_;  ///< of the skin and of walls
    std::vector<double> walls_;                     ///< the material behind each vertex at rest [m]
    std::vector<bool> touchesWall_;
};

}  // namespace kerf
