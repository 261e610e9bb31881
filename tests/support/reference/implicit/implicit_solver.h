#pragma once

#include "sim/base/params.h"
#include "tests/support/reference/implicit/contact_row.h"
#include "tests/support/reference/implicit/preconditioner.h"
#include "tests/support/reference/reference_solver.h"

namespace kerf {

/// The parameters of the implicit solver.
struct ImplicitSettings {
    double step = 1.0 / 240;  ///< [s]
    double prepared = 0;      ///< step for which parts are inverted, if not that one [s]
    int iterations = 4;       ///< of conjugate gradients, per stage
    double tolerance = 0;     ///< of the residual, as a share: ends them earlier; 0: never
    int passes = 1;           ///< of Newton's method, per stage
    std::size_t aggregateSize = 60;
    TypeModuli moduli{};  ///< [Pa]
    double density = 1000;
    double damping = 0.001;  ///< beta [s]
    double drag = 1;         ///< [1/s]
    Vec3 gravity{0, -9.81, 0};
    bool holdsVolume = true;
};

/// Those that scene parameters stand for; step and iterations as above.
ImplicitSettings implicitSettings(const Params& params);

/// What a step did.
struct ImplicitReport {
    double residual = 0;  ///< left by the last stage, as a share of what it began with
    int pushing = 0;      ///< contacts that push
};

/// Two linearly implicit stages a step (SDIRK2, Alexander 1977; L-stable, second order), of a body
/// linearised where the step begins, each solved by a few conjugate gradients that start along the
/// velocity, with volumes kept by projection and contacts as one-sided springs. In double
/// precision: what the kernels of the implicit solver are tested against. See
/// docs/notes/implicit-steps.md.
class ImplicitReference {
  public:
    /// `model` must outlive it; `pinned` vertices keep their places.
    ImplicitReference(const BodyModel& model, const ImplicitSettings& settings,
                      std::span<const std::uint32_t> pinned = {});

    /// Without a finder nothing touches anything. It must outlive the solver.
    void setContacts(ContactFinder* finder) { finder_ = finder; }
    /// Does one step.
    ImplicitReport step(ReferenceState& state);

    std::span<const double> masses() const { return masses_; }  ///< 0 where pinned [kg]
    /// Kinetic, elastic and of gravity about the origin, without that of contacts [J].
    double energy(const ReferenceState& state) const;
    std::vector<double> volumes(std::span<const Vec3> positions) const;

  private:
    class Descent;
    /// From which a stage goes on.
    struct StageStart {
        Vectors positions, velocities;
    };

    void linearise(const Vectors& positions);
    Vectors residualAt(const Vectors& total, const Vectors& start, const StageStart& from) const;
    std::vector<double> missingVolumes() const;
    Vectors solveStage(const StageStart& from, const Vectors& start, ContactRows& rows,
                       ImplicitReport& report);
    void spinBack(const ReferenceState& before, const ContactRows& rows,
                  ReferenceState& state) const;
    ContactRows findRows(const ReferenceState& state);
    void keepSlips(const ContactRows& rows);

    const BodyModel& model_;
    ImplicitSettings settings_;
    std::vector<double> masses_;
    std::vector<ConstraintPull> pulls_;  ///< at rest, then where the body was linearised
    std::vector<double> firmness_;       ///< contactFirmness()
    VertexGroups groups_;
    RestInverse inverse_;
    Preconditioner preconditioner_;
    std::vector<double> steepness_;
    ContactFinder* finder_ = nullptr;
    struct Held {
        std::uint64_t memory;
        Vec3 slip;
        double push;
    };
    std::vector<Held> held_;

    // Of the body where it was linearised.
    BlockMatrix matrix_;
    Vectors force_, volumeGradient_;
    std::vector<double> volume_;
};

}  // namespace kerf
