#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "shaders/shared/body_records.h"
#include "sim/base/params.h"
#include "sim/body/body_model.h"
#include "sim/body/rest_pose.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf {

/// Draws pieces that have collapsed back to their shape: what has gone through itself rests in a
/// wrong one, since lengths and angles are the same inside out, and no elastic force leads out of
/// it. All vertices of such a piece are led to its shape at rest, put where that fits best; floor,
/// boxes and other pieces stop them. Once it is back, or time is up, it is let go, and not drawn
/// again before somebody has acted.
class ShapeRecovery {
  public:
    /// A piece of which a larger share is inside out has collapsed. An arm that is dragged through
    /// its body stays below.
    static constexpr double kMostInsideOut = 0.1;

    /// Begins to draw the collapsed ones of the pieces back. `insideOut`: see sharesInsideOut().
    /// Returns how many these are.
    int begin(std::span<const double> insideOut);
    /// Lets pieces be drawn back again: the load that crushed them may have gone.
    void allowAgain();
    /// Lets go of all pieces.
    void stop() { courses_.clear(); }
    /// Follows a cut. `source`: see LabelChange.
    void follow(std::span<const int> source);

    bool draws() const;
    bool draws(int piece) const;

    /// What a step is about to move.
    struct Body {
        const BodyModel& model;
        const SurfaceMesh& mesh;
        const Params& params;
        /// Vertices that are pinned or in a hand, ascending: the shape is put to them.
        std::vector<std::uint32_t> held;
    };
    /// How the vertices of these pieces are led through the coming step. Lets go of those that are
    /// back.
    std::vector<shared::PullRecord> advance(const Body& body);

  private:
    struct Course {
        bool draws = false;
        bool spent = false;                 ///< drawn back since somebody last acted
        double time = 0;                    ///< that it has been drawn [s]
        std::optional<RigidMotion> motion;  ///< as a whole, in the last step
    };
    /// Appends how the vertices of a piece are led, or lets go of it.
    static void lead(std::vector<FittedVertex> vertices, const Body& body, Course& course,
                     std::vector<shared::PullRecord>& records);

    std::vector<Course> courses_;  ///< by piece; those behind the last have none
};

}  // namespace kerf
