#pragma once

#include "sim/body/body_model.h"
#include "sim/contact/contact_solver.h"
#include "sim/contact/obstacles.h"
#include "sim/contact/static_box.h"
#include "tests/support/reference/reference_solver.h"

namespace kerf {

/// Computes the contact of boxes and triangles in a substep (sim/boxes/triangles.comp,
/// respond.comp, apply.comp), in double precision: the reference for tests of the kernels.
class ReferenceBoxes {
  public:
    /// `model` must outlive it. `inverseMass`: of each vertex [1/kg].
    ReferenceBoxes(const BodyModel& model, std::vector<StaticBox> boxes,
                   const ContactSettings& settings, const TouchDistances& distances,
                   std::vector<double> inverseMass);

    /// Triangles by kind of contact.
    struct Counts {
        int touched = 0;  ///< a corner or an edge of a box
        int passed = 0;   ///< a box passes through them
    };
    /// One sweep over all contacts: changes displacements and positions.
    Counts respond(ReferenceState& state) const;

  private:
    /// Where a triangle is touched, in the coordinates of the box.
    struct Touch {
        Vec3 normal;
        double before = 0;  ///< gap at X [m]
        Vec3 slip;          ///< of the touched point [m]
        Vec3 weights;
        bool passes = false;
        double gap() const { return before + normal.dot(slip); }
    };
    /// A triangle in the coordinates of a box.
    struct Corners {
        std::array<Vec3, 3> at;   ///< X [m]
        std::array<Vec3, 3> way;  ///< d [m]
    };
    using Ids = std::array<std::uint32_t, 3>;
    /// The response of a triangle, before masses are shared.
    struct Answer {
        Ids ids;
        Vec3 weights, impulse, push;  ///< the last two of d and X [m]
        bool passes = false;
    };

    bool isNear(const Corners& corners, const Vec3& half) const;
    std::optional<Touch> mostUrgent(const StaticBox& box, const Corners& corners,
                                    const Ids& ids) const;
    std::optional<Touch> atCorner(const Corners& corners, const Vec3& normal,
                                  const Vec3& corner) const;
    std::optional<Touch> atEdge(const Corners& corners, const Vec3& normal, int side, int axis,
                                const Vec3& start) const;
    std::optional<Touch> passingThrough(const Corners& corners, const Vec3& normal,
                                        const Vec3& half) const;
    Answer answerTo(const Touch& touch, const StaticBox& box, const Ids& ids) const;
    std::optional<Answer> answerOf(const Ids& ids, const ReferenceState& state) const;
    void apply(const Answer& answer, const std::vector<double>& taken, ReferenceState& state) const;

    const BodyModel& model_;
    std::vector<StaticBox> boxes_;
    ContactSettings settings_;
    TouchDistances distances_;
    std::vector<double> inverseMass_;
};

}  // namespace kerf
