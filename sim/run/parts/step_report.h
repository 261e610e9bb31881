#pragma once

#include "sim/contact/blade_body.h"
#include "sim/cut/cut_types.h"

namespace kerf {

struct BodyMeasure;
struct BodyModel;
struct Params;

/// The wall-clock time of the stages of a step [ms].
struct StageTimes {
    double deform = 0;
    double collide = 0;
    double cut = 0;

    double sum() const { return deform + collide + cut; }
};

/// What tears a body, or holds it, in a step with `tearing`.
struct TearReport {
    /// Of the slit that is opened most: its opening, as a share of that at which its end advances;
    /// 0 without slits.
    double opening = 0;
    bool hasSlit = false;
    double stress = 0;      ///< the largest of the skin, as a share of the tensile strength
    bool advanced = false;  ///< new surface was torn in the step
    std::string failure{};  ///< why an advance was impossible; empty if none was
    bool failed() const { return !failure.empty(); }
};

/// The energies of a step.
struct StepEnergies {
    double fractureEnergy = 0;           ///< of the new surface of this step [J]
    double kineticEnergy = 0;            ///< see BodyMeasure [J]
    double potentialEnergy = 0;          ///< [J]
    std::optional<double> strainEnergy;  ///< of the material; none with plain PBD [J]
};

/// What a time step was made of.
struct StepParts {
    int implicitSteps = 1;  ///< 1 with other solvers
    int iterations = 0;     ///< as the parameters say, or as chosen where they are auto
    /// What the iterations left unsolved of the motion in the last implicit step: the root of the
    /// share of its energy. None with other solvers, and where nothing moved.
    std::optional<double> residual;
};

/// One row of metrics.csv, after a step.
struct StepReport : StepEnergies, StepParts {
    int step = 0;            ///< index of the step that just ran, from 0
    double time = 0;         ///< simulated time at its end [s]
    double volume = 0;       ///< sum over pieces [m^3]
    double volumeRatio = 1;  ///< against the uncut rest shape
    int pieces = 1;
    int vertices = 0;
    int triangles = 0;
    int ispcs = 0;
    int touchedTriangles = 0;
    SubdivisionCounts subdivisions{};    ///< of the touched triangles, in this step
    int seeds = 0;                       ///< groups of neighbours among the touched triangles
    Debris debris;                       ///< removed in this step
    SweptArea swept;                     ///< by the blade inside the material, in this step
    std::optional<BladeLoad> bladeLoad;  ///< none unless measured, or while paused
    HeldEdge heldEdge;                   ///< with `blade_feels`
    std::optional<TearReport> tear;      ///< with `tearing`
    int contacts = 0;                    ///< of the body with itself in the last substep
    bool closed = true;
    bool open = false;   ///< walls of a stroke of the open cut are absent
    int lostPieces = 0;  ///< diverged pieces, reset to the start of the step
    StageTimes times;
    /// For the triangles near the blade: part of the time of the cut, except the prefetch.
    SearchWork search;

    /// Adds the result of a movement of the blade, but for its debris.
    void add(const CutStatistics& cut);
    /// Describes the present body, with contacts from the measure.
    void describe(const BodyModel& model, const BodyMeasure& measure);
};

/// Whether a body can tear with these parameters, once `tearing` is on.
bool mayTear(const Params& params);
/// Says why what is pulled tears or does not, while `tearing` is on. "" says nothing.
std::string tearSentence(const StepReport& report, const Params& params, bool toreLately);
/// The message that a movement of the blade was refused.
std::string refusalSentence(const CutResult& result, int step);
/// Messages about the end of a stroke.
std::vector<std::string> sentencesAboutEnd(const CutResult& result, int step);

/// The results of the steps of a stroke.
struct StrokeRecord {
    int number = 0;         ///< as in SurfaceMesh::wallLabel, if it has cut
    int firstTriangle = 0;  ///< first slot of its triangles
    int cutSteps = 0;       ///< steps that cut
    int refusedSteps = 0;   ///< steps that were refused, in one group of pieces at least
    int retriedSteps = 0;   ///< steps that took more than one try
    int cutAnew = 0;        ///< restarts behind a dropped front
    SweptArea swept{};      ///< by the blade, inside the material
    Debris debris{};        ///< removed when it ended

    /// Adds a step.
    void add(const CutResult& step);
    /// Adds the steps of another stroke.
    void add(const StrokeRecord& other);
    /// Whether it met the body; one that did not is not recorded.
    bool metBody() const { return cutSteps + refusedSteps > 0; }
};

}  // namespace kerf
