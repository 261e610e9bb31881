#pragma once

#include "sim/base/params.h"
#include "sim/body/body_model.h"

namespace kerf {

/// Of so many steps a time step is made at most, however fast a splinter is.
inline constexpr int kMostImplicitSteps = 32;

/// The box of each member at rest; empty where none of it is left [m].
std::vector<Bounds> memberBoxes(const BodyModel& model);
/// longestImplicitStep() for all members of the body; infinite where nothing is left [s].
double longestStep(const BodyModel& model, const Params& params);
/// Of how many steps no longer than `longest` a time step is made [s]; kMostImplicitSteps at most.
int stepsWithin(double timeStep, double longest);
/// Of the smallest member at rest [m]; infinite where nothing is left.
double leastDiagonal(const BodyModel& model);
/// The longest step of a body that meets something at this speed [m/s]: beyond it rebounds err by
/// more than a tenth, and some gain energy. `diagonal`: leastDiagonal() [m]. [s]
double longestStepAt(double speed, double diagonal);
/// Iterations of a stage, where they are auto, of a body that meets something on `way` in a step,
/// in leastDiagonal(): what strikes, or lies on other pieces and moves, needs more, and a large
/// body by the root of its vertices. `error`: see Params::iterationError.
int implicitIterations(const BodyModel& model, double way, double error);
/// Of the energy of a motion, how much an error by that share leaves: see ImplicitStep::close.
double energyLeft(double error);

/// What a step of the implicit solver is done by.
struct ImplicitStep {
    double step = 1.0 / 240;         ///< [s]
    int iterations = 4;              ///< of conjugate gradients, per stage, at most
    std::size_t aggregateSize = 60;  ///< see groupVertices()
    double prepared = step;          ///< for which parts are inverted; good for shorter steps [s]
    bool unfolds = true;             ///< what is folded is drawn out of it: see Unfolding
    /// Of the energy of the motion: where less is left iterations end, but for half of them.
    double close = 0;

    /// As the parameters say, of a body whose longestStep() this is.
    static ImplicitStep of(const Params& params, std::size_t vertexCount, double longest);
};

/// What a body has after a step [J].
struct BodyEnergies {
    double moving = 0;     ///< kinetic and strain energy
    double potential = 0;  ///< in the field of gravity
};

/// Finds out that a body gains energy of itself, as none does whose steps are short enough, and
/// into how many parts its coming steps are to be divided therefore. The state of a body: it is
/// stored with it.
class EnergyGuard {
  public:
    /// What was changed before the coming step, or is new, may have another energy.
    void startAnew() { isNew_ = true; }
    /// After a step of `h` seconds; `worked`: something else may have given energy; `least`: less
    /// is nothing [J]. Returns whether the steps are divided further now.
    bool note(const BodyEnergies& body, double h, bool worked, double least);
    /// Of a step that would do for what does not grow.
    int divisions() const { return divisions_; }

    /// Writes or reads all of it (ByteArchive).
    template <class Archive>
    void archive(Archive& io) {
        io(isNew_, highest_, divisions_, calm_);
    }

  private:
    bool isNew_ = true;
    double highest_ = 0;  ///< energy of late [J]
    int divisions_ = 1;
    double calm_ = 0;  ///< time since it grew [s]
};

}  // namespace kerf
