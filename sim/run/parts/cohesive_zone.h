#pragma once

#include "shaders/shared/body_records.h"
#include "sim/base/params.h"
#include "sim/cut/cut_types.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf {

/// Edges of walls in a cohesive zone, at least.
inline constexpr double kEdgesInZone = 3.5;

/// What new surface takes, as a cohesive law: the traction falls linearly from `strength` to zero
/// while the walls open (Hillerborg, Modeer, Petersson 1976).
struct TearLaw {
    double toughness = 0;      ///< energy per area [J/m^2]
    double strength = 0;       ///< largest traction, as low as the mesh resolves [Pa]
    double skinToughness = 0;  ///< of the skin layer, times its thickness: energy per length [J/m]
    double skinStrength = 0;   ///< the same of its strength: force per length [N/m]
    double zone = 0;           ///< length of the cohesive zone in the flesh, in edges of walls

    /// The opening at which the flesh has parted [m].
    double reach() const { return 2 * toughness / strength; }
};

/// The law for a mesh with walls of edge length `edge` [m]. A strength at which the cohesive zone
/// would be shorter than a few edges is lowered, so that it is resolved and its energy stays
/// (Turon, Davila, Camanho, Costa 2007).
TearLaw tearLaw(const Params& params, double edge);

/// Holds the walls of tears together: a bond between both copies of each of their points, which
/// weakens as it opens, never heals, and has taken the energy of the new surface once it breaks.
class CohesiveZone {
  public:
    /// A bond: vertices of W+ and W-, and its state.
    struct Bond {
        int plus = -1;
        int minus = -1;
        int label = 0;      ///< of W+, as SurfaceMesh::wallLabel
        double force = 0;   ///< the largest [N]
        double energy = 0;  ///< that it takes until it breaks [J]
        double widest = 0;  ///< largest opening so far [m]

        /// The opening at which it breaks [m].
        double reach() const { return force > 0 ? 2 * energy / force : 0; }
        bool isBroken() const { return widest >= reach(); }
        /// The energy taken so far [J].
        double taken() const { return isBroken() ? energy : energy * widest / reach(); }
    };

    /// The law of coming bonds, and of present ones when the mesh changes.
    void setLaw(const TearLaw& law) { law_ = law; }
    const TearLaw& law() const { return law_; }
    /// Bonds the walls that stroke `stroke` has just made, as a tear: points with a copy from
    /// `firstVertex` on. No vertex has more than one bond.
    void bond(const SurfaceMesh& mesh, const CutDelta& delta, int stroke, int firstVertex);
    /// After any step of the cutter: the present share of the walls of each bond.
    void follow(const SurfaceMesh& mesh);
    /// Takes the present openings.
    void noteOpenings(const SurfaceMesh& mesh);
    /// The springs of the coming step, but of none that names one of `others` (ascending).
    std::vector<shared::PullRecord> pulls(const std::vector<std::uint32_t>& others) const;
    /// The vertices that noteOpenings() reads.
    void addVertices(std::vector<int>& vertices) const;

    /// The bond of a vertex of W+; null if there is none.
    const Bond* find(int plus) const;
    bool empty() const { return bonds_.empty(); }
    /// The energy that all bonds have taken, ever [J].
    double taken() const;

    /// Writes or reads all of it (ByteArchive).
    template <class Archive>
    void archive(Archive& io) {
        io(law_, bonds_, spent_);
    }

  private:
    /// The energy and force of a point of W+, by the walls about it.
    void weigh(const SurfaceMesh& mesh, Bond& bond) const;

    TearLaw law_;
    std::vector<Bond> bonds_;  ///< by `plus`
    double spent_ = 0;         ///< of bonds that are gone [J]
};

/// The copy of `v`, a vertex of the wall of a stroke, on its other wall, on the same side of older
/// slits if there is one; -1 if there is none, as along the front.
int facingVertex(const SurfaceMesh& mesh, int v, int otherLabel);

}  // namespace kerf
