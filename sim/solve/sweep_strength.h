#pragma once

#include <map>
#include <optional>
#include <vector>

#include "sim/base/params.h"
#include "sim/body/body_model.h"

namespace kerf {

/// The share of the constraints' stiffness that one Jacobi sweep a substep carries. The rest makes
/// the body softer than its modulus (docs/physics.md, Accuracy by iterations). Bends don't count: a
/// solid lacks them least.
class SweepStrength {
  public:
    /// Without a body: any number of iterations is enough.
    SweepStrength() = default;
    /// For `model`, whose constraints were made for `params`.
    SweepStrength(const BodyModel& model, const Params& params) { follow(model, params); }

    /// Recomputes, in O(constraints), if the constraints for `params` or for a body of this size
    /// differ. Not after cuts.
    void follow(const BodyModel& model, const Params& params);

    /// The share of the stiffness of edges, with a true modulus of ISPCs too, that a sweep carries,
    /// 0 to 1. Each constraint is weighted by its energy under a uniform stretch, so this is an
    /// upper bound of the stiffness (Voigt). A constraint carries, with r = (alpha / h^2) / sum(n w
    /// |grad C|^2) of mass-splitting XPBD, r / (1 + r); with a true modulus min(1, 4 r / 3 s) for
    /// the room s of its type (sweepRoom()).
    double carried(const Params& params) const;
    /// Whether that is too little for the modulus: less than 0.9 with a true one; else less than
    /// 0.7, since skin and ISPCs each carry the whole load. Never with plain PBD, whose stiffness
    /// is no modulus.
    bool isTooLittle(const Params& params) const;
    /// The least number of iterations for which it is not; none within the range of the parameter.
    std::optional<int> enoughIterations(const Params& params) const;

  private:
    /// Constraints of nearly the same strength.
    struct Alike {
        double volume = 0;    ///< that they represent [m^3]
        double strength = 0;  ///< mean by volume of r E h^2 / rho [m^2]
    };
    using Constraints = std::map<long, Alike>;  ///< by the logarithm of their strength

    template <class Constraint>
    static Constraints count(const std::vector<Constraint>& list, const Incidence& incidence,
                             const BodyModel& model, const std::vector<double>& masses);

    std::optional<Params> countedFor_;
    double diagonal_ = 0;  ///< BodyModel::diagonal of what was counted [m]
    Constraints edges_;
    Constraints ispcs_;
};

}  // namespace kerf
