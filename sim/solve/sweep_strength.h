#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "sim/base/params.h"
#include "sim/body/body_model.h"

namespace kerf {

/// What one Jacobi sweep a substep is good for: the share of the constraints' stiffness that it
/// carries (the rest makes the body softer than its modulus), the error of a motion, and how many
/// iterations keep to one (docs/physics.md, Accuracy by iterations).
class SweepStrength {
  public:
    /// Without a body: any number of iterations is enough.
    SweepStrength() = default;
    /// For `model`, whose constraints were made for `params`.
    SweepStrength(const BodyModel& model, const Params& params) { follow(model, params); }

    /// Recomputes, from a sample of bounded size, if the constraints for `params` or for a body of
    /// this size differ; where iterations are auto, after a cut too.
    void follow(const BodyModel& model, const Params& params);

    /// The share of the stiffness of edges, with a true modulus of ISPCs too, that a sweep carries,
    /// 0 to 1. Each constraint is weighted by its energy under a uniform stretch, so this is an
    /// upper bound of the stiffness (Voigt). Bends don't count: a solid lacks them least. A
    /// constraint carries, with r = (alpha / h^2) / sum(n w
    /// |grad C|^2) of mass-splitting XPBD, r / (1 + r); with a true modulus min(1, 4 r / 3 s) for
    /// the room s of its type (sweepRoom()).
    double carried(const Params& params) const;
    /// Whether that is too little for the modulus: less than 0.9 with a true one; else less than
    /// 0.7, since skin and ISPCs each carry the whole load. Of auto iterations: whether even the
    /// most of them leave more than the error asked for. Never with plain PBD, whose stiffness is
    /// no modulus.
    bool isTooLittle(const Params& params) const;
    /// The least number of iterations for which it is not; none within the range of the parameter.
    std::optional<int> enoughIterations(const Params& params) const;

    /// An estimate of the error of a motion against one of many substeps, as a share of the motion:
    /// what stiffness lacks, bends by how thick the body is, and half a substep against the time in
    /// which a wave crosses the body. Bends are weighted by their energy under a uniform curvature.
    /// Fitted to `kerf experiment iterations`.
    double error(const Params& params) const;
    /// error() with the most iterations that there are.
    double leastError(const Params& params) const;
    /// The least number of iterations whose error() is at most params.iterationError, and which
    /// suit a body that meets something at this speed [m/s]: a substep moves it by a small share of
    /// an edge, and at the speed of sound, which deforms it deeply, they are those of the defaults.
    /// With a slit those of the defaults at least, since the hinges at its end decide how far it
    /// opens. The most that there are where more are needed. In steps where the speed decides, so
    /// that it seldom changes. With plain PBD that of the defaults.
    int iterationsFor(const Params& params, double speed) const;

    /// Writes or reads all of it (ByteArchive).
    template <class Archive>
    void archive(Archive& io) {
        io(countedFor_, diagonal_, constraints_, edges_, ispcs_, bends_, hasSlit_, wavesPerSpeed_,
           thickness_, edgeLength_);
    }

  private:
    /// Constraints of nearly the same strength.
    struct Alike {
        double energy = 0;    ///< of them under a uniform stretch or curvature, over E
        double strength = 0;  ///< mean by energy of r E h^2 / rho [m^2]
    };
    using Constraints = std::map<long, Alike>;  ///< by the logarithm of their strength

    template <class Constraint>
    static Constraints count(const std::vector<Constraint>& list, const Incidence& incidence,
                             const BodyModel& model);
    /// Sums of energy: of all, and of what a sweep carries of it.
    struct Sums {
        double all = 0;
        double carried = 0;
    };
    static Sums sumsOf(std::uint32_t type, const Constraints& constraints, const Params& params);
    void measure(const BodyModel& model);

    std::optional<Params> countedFor_;
    double diagonal_ = 0;          ///< BodyModel::diagonal of what was counted [m]
    std::size_t constraints_ = 0;  ///< of what was counted
    Constraints edges_;
    Constraints ispcs_;
    Constraints bends_;
    bool hasSlit_ = false;      ///< bends are folded at rest, where two walls meet
    double wavesPerSpeed_ = 0;  ///< across a member in a second, at a speed of sound of 1 m/s [1/m]
    double thickness_ = 0;      ///< of the thickest member, over the length of its box
    double edgeLength_ = 0;     ///< of walls [m]
};

}  // namespace kerf
