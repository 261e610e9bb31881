#pragma once

#include "shaders/shared/body_records.h"
#include "sim/base/placement.h"
#include "sim/body/body_model.h"
#include "sim/cut/cut_types.h"
#include "sim/mesh/surface_mesh.h"
#include "sim/run/parts/command.h"

namespace kerf {

/// Vertices that follow the material through cuts.
class HeldVertices {
  public:
    /// Adds the vertices in the region, or removes them. Returns how many changed.
    int change(const Region& region, bool holds, const SurfaceMesh& mesh);
    /// After a step of the cut: removes dead vertices, and adds copies. Returns whether anything
    /// changed.
    bool follow(const SurfaceMesh& mesh, const CutDelta& delta);

    /// Ascending.
    const std::vector<std::uint32_t>& vertices() const { return vertices_; }
    bool empty() const { return vertices_.empty(); }

    /// Writes or reads all of it (ByteArchive).
    template <class Archive>
    void archive(Archive& io) {
        io(vertices_, positions_);
    }

  private:
    void collectPlaces(const SurfaceMesh& mesh);
    bool holds(int vertex) const;

    std::vector<std::uint32_t> vertices_;
    std::set<std::array<double, 3>>
        positions_;  ///< rest positions of the vertices: copies share them, bit for bit
};

/// What is prescribed for vertices: which are fixed or move, and which forces act.
class Pins {
  public:
    /// Pinned vertices that move.
    struct Motion {
        int number = 0;  ///< which of all motions so far
        Vec3 velocity = Vec3::Zero();
        double left = 0;            ///< how long they move on [s]
        Vec3 moved = Vec3::Zero();  ///< so far [m]
        HeldVertices held;
        /// Where they were before that, by their rest positions [m].
        std::map<std::array<double, 3>, Vec3> starts;

        /// From where they are now.
        void start(const SurfaceMesh& mesh);
        void follow(const SurfaceMesh& mesh, const CutDelta& delta);
        template <class Archive>
        void archive(Archive& io) {
            io(number, velocity, left, moved, held, starts);
        }
    };
    /// A force on vertices.
    struct Force {
        Vec3 newtons = Vec3::Zero();  ///< on all of them together
        HeldVertices held;

        template <class Archive>
        void archive(Archive& io) {
            io(newtons, held);
        }
    };
    /// What moving vertices do in a step.
    struct Course {
        std::vector<std::uint32_t> vertices;  ///< ascending
        std::vector<Vec3f> from;              ///< where each begins [m]
        std::vector<Vec3f> velocities;        ///< [m/s]
    };

    /// Pins the free vertices in the region, or unpins the pinned ones. Returns how many changed.
    int change(const Pin& pin, const SurfaceMesh& mesh);
    /// Adds a force, or takes away what acts in the region. Returns on how many vertices that is.
    int change(const ApplyForce& apply, const SurfaceMesh& mesh);
    /// After a step of the cut. Returns whether the pinned vertices changed.
    bool follow(const SurfaceMesh& mesh, const CutDelta& delta);
    /// Motions go on from where `now` has them, and from the present positions.
    void goOnFrom(const Pins& now, const SurfaceMesh& mesh);
    /// The coming step of `timeStep` [s]; moves on.
    Course advance(double timeStep, const SurfaceMesh& mesh);
    /// The forces as accelerations, one per vertex, but none of `others` (ascending): of a model of
    /// a density [kg/m^3]. Those that are drawn have a length [m].
    std::vector<shared::PullRecord> accelerations(const BodyModel& model, double density,
                                                  const std::vector<std::uint32_t>& others,
                                                  double drawnLength) const;

    /// The pinned vertices, ascending.
    const std::vector<std::uint32_t>& vertices() const { return fixed_.vertices(); }
    const std::vector<Force>& forces() const { return forces_; }
    /// Those that have ended hold on.
    const std::vector<Motion>& motions() const { return motions_; }
    /// Whether some of them are on the move.
    bool moves() const;
    /// How many vertices are held, each as often as it is.
    std::size_t count() const;

    /// Writes or reads all of it (ByteArchive).
    template <class Archive>
    void archive(Archive& io) {
        io(fixed_, motions_, forces_, lastNumber_);
    }

  private:
    HeldVertices fixed_;           ///< those that move among them
    std::vector<Motion> motions_;  ///< ended ones too
    std::vector<Force> forces_;
    int lastNumber_ = 0;  ///< of a motion
};

}  // namespace kerf
