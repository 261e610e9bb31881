#pragma once

#include "shaders/shared/body_records.h"
#include "sim/base/params.h"
#include "sim/body/body_model.h"
#include "sim/body/rest_geometry.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf {

/// Recovers pieces that have collapsed: one that has passed through itself rests in a wrong shape,
/// since lengths and angles are the same inside out, and no elastic force leads out of it. All
/// vertices of such a piece move to its fitted rest shape; floor, boxes and other pieces stop them.
/// Recovery ends when the shape is reached, or after a time limit, and does not restart before the
/// next user action.
class ShapeRecovery {
  public:
    /// A piece with a larger share inside out has collapsed. An arm that is dragged through its
    /// body stays below.
    static constexpr double kMostInsideOut = 0.1;

    /// Starts to recover the collapsed pieces. `insideOut`: see sharesInsideOut(). Returns their
    /// number.
    int begin(std::span<const double> insideOut);
    /// Allows recovery again: the load that crushed the pieces may be gone.
    void allowAgain();
    /// Stops all recoveries.
    void stop() { recoveries_.clear(); }
    /// Follows a cut. `source`: see LabelChange.
    void follow(std::span<const int> source);

    bool draws() const;
    bool draws(int piece) const;

    /// The input of a step.
    struct Body {
        const BodyModel& model;
        const SurfaceMesh& mesh;
        const Params& params;
        /// Pinned or held vertices, ascending: the shape is fitted to them.
        std::vector<std::uint32_t> held;
    };
    /// The motion of the vertices of these pieces in the coming step. Ends finished recoveries.
    std::vector<shared::PullRecord> advance(const Body& body);

    /// Writes or reads all of it (ByteArchive).
    template <class Archive>
    void archive(Archive& io) {
        io(recoveries_);
    }

  private:
    struct Recovery {
        bool draws = false;
        bool spent = false;                 ///< recovered since the last user action
        double time = 0;                    ///< since its start [s]
        std::optional<RigidMotion> motion;  ///< as a whole, in the last step
    };
    /// Appends the motion of the vertices of a piece, or ends its recovery.
    static void lead(std::vector<FittedVertex> vertices, const Body& body, Recovery& recovery,
                     std::vector<shared::PullRecord>& records);

    std::vector<Recovery> recoveries_;  ///< by piece; those behind the last have none
};

}  // namespace kerf
