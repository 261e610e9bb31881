#pragma once

#include "shaders/shared/body_records.h"
#include "sim/mesh/surface_mesh.h"
#include "sim/run/parts/command.h"

namespace kerf {

/// The hands with which a person holds a body: each pulls its vertices by springs, so that they
/// keep their offsets from it.
class Hands {
  public:
    struct Held {
        int vertex = -1;
        Vec3 offset = Vec3::Zero();  ///< from the hand, when grabbed [m]
    };
    struct Hand {
        int number = 0;
        Vec3 from = Vec3::Zero();  ///< at the start of the coming step [m]
        Vec3 to = Vec3::Zero();    ///< at its end
        std::vector<Held> held;

        template <class Archive>
        void archive(Archive& io) {
            io(number, from, to, held);
        }
    };

    /// Each returns "", or one sentence if nothing changed. A hand that holds something releases
    /// it; vertices that another hand holds stay with that.
    std::string grab(const Grab& grab, const SurfaceMesh& mesh);
    std::string drag(const Drag& drag);
    std::string release(const Release& release);

    /// The hands that hold something, by number.
    const std::vector<Hand>& hands() const { return hands_; }
    /// The vertices that hands hold, hand by hand.
    std::vector<std::uint32_t> heldVertices() const;
    bool empty() const { return hands_.empty(); }

    /// Lets go of vertices that are no more; a hand that holds no other vanishes.
    void forgetDead(const SurfaceMesh& mesh);

    /// The springs of the coming step of `timeStep` [s]; moves the hands to their targets.
    std::vector<shared::PullRecord> advance(double timeStep);

    /// Writes or reads all of it (ByteArchive).
    template <class Archive>
    void archive(Archive& io) {
        io(hands_);
    }

  private:
    Hand* find(int number);
    bool holds(int vertex) const;

    std::vector<Hand> hands_;
};

}  // namespace kerf
