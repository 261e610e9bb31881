#pragma once

#include "sim/base/params.h"
#include "sim/body/body_updater.h"
#include "sim/cut/stroke/cutter.h"
#include "sim/mesh/invariants.h"
#include "sim/mesh/surface_mesh.h"
#include "sim/run/parts/mesh_sync.h"
#include "sim/run/parts/snapshot.h"
#include "sim/run/start/prepared_body.h"
#include "sim/solve/gpu_solver.h"

namespace kerf {

/// What a body may meet besides itself and the floor.
struct Surroundings {
    bool boxes = false;
    double bladeSpeed = 0;  ///< of a blade that pushes or presses, in the coming step [m/s]
};

/// The running body of a simulation: constant set-up, running state on the GPU, the mesh, which
/// owns the topology and fetches positions when read, and the state of cutting and solving.
/// Snapshot stores these.
struct RunningBody {
    /// Runs an uncut body at rest, already in `loadedSolver`.
    RunningBody(PreparedBody prepared, std::unique_ptr<GpuSolver> loadedSolver);

    /// Restores the uncut body at rest, nothing held or pinned. Call measureAtRest() after setting
    /// parameters.
    void startAnew();
    /// startAnew() with the original uncut body.
    void startAsAtFirst();
    /// "", or one sentence if the scene has no model of this number.
    std::string checkModel(int model) const;
    /// startAnew() with `placed`, the uncut body with new placements.
    void startAnew(std::shared_ptr<const UncutBody> placed);
    void measureAtRest();
    void apply(const Params& params);
    /// The iterations of the coming step: those of the parameters, or, where they are auto, as many
    /// as it needs (implicitIterations()). `steps`: implicitStepsFor() them.
    int iterationsFor(const Params& params, const Surroundings& around, int steps) const;
    /// Of how many implicit steps the coming time step is made, by how fast the body meets
    /// something.
    int implicitStepsFor(const Params& params, const Surroundings& around) const;
    /// After a step; `worked`: something that acts from outside, such as a blade. Returns whether
    /// the body gained energy of itself, so that coming steps are divided further.
    bool guardSteps(const Params& params, bool worked);
    /// After measureStep(): see StepParts.
    std::optional<double> residual(const Params& params) const;
    /// At which something near may be met in the coming step, or parts meet each other [m/s].
    double relativeSpeed(const Params& params, const Surroundings& around) const;
    /// Gives the solver parameters with a number of iterations; after apply().
    void applyToSolver(const Params& params);

    /// The present body; never null.
    SnapshotPointer capture();
    /// Bit for bit. Apply the parameters again afterwards.
    void restore(const Snapshot& snapshot);

    /// Decays volume targets, and moves hands and recovering pieces, before the solver's step.
    void prepareStep(const Params& params, bool autoIterations);
    void bringLostPiecesBack();
    /// Whether the coming step may lead it through itself, past what contact can see: it is thin,
    /// or some edge was drawn to almost four times its length. Not where it comes back from a
    /// collapse.
    bool keepsTrianglesApart(const Params& params) const;
    /// Keeps its triangles from passing through each other, unless they did at `before` [m].
    /// Measures the body again if some did.
    void stopCrossings(const std::vector<Vec3>& before, const Params& params);
    /// Measures what the solver's step has moved; waits for the GPU.
    void measureStep();
    /// Ends the solver's step, after lost pieces were reset. Returns the time for listing what the
    /// GPU found near the blade [ms].
    double endStep();

    /// The triangles near the area swept between these points [m], ascending.
    std::vector<int> trianglesNear(std::span<const Vec3> strip);
    /// Tells whether there are any.
    bool isNear(std::span<const Vec3> strip) { return !trianglesNear(strip).empty(); }
    /// The present position of the last rung.
    std::vector<RungNode> front() const;
    /// The mesh has changed.
    void forgetPieces() { pieces_.reset(); }

    /// See Simulation::readAllBack().
    void readAllBack(bool all);

    /// The box of the pinned vertices after such a move [m].
    Bounds pinnedAfter(const MovePins& move) const;
    /// Moves it, at once.
    void movePinned(const MovePins& move);
    /// Replaces what is pinned, moves and is pushed, by what was so before or will be.
    void setPins(Pins pins);
    /// Vertices that hands pull or that are pinned, ascending.
    std::vector<std::uint32_t> heldVertices() const;
    /// Tells the solver what is pinned, and overlays which forces act.
    void holdPins();

    /// The running mesh; replaced by placements.
    SurfaceMesh& mesh() const { return *uncut->running; }
    const BodyModel& model() const { return updater->model(); }
    /// Whether a piece may have passed through itself, by the last measure: some edge is folded, or
    /// a piece has lost much volume.
    bool looksCollapsed() const;
    /// Whether it sleeps: it has hardly moved for so long that it stays until disturbed.
    bool liesStill() const;
    /// After the measure of a step of `timeStep` [s]; `lost`: it lost a piece.
    void noteStillness(double timeStep, bool lost);
    /// Tells whether walls of a stroke of the open cut are absent.
    bool isOpen() const;
    const PieceMap& pieces();
    /// Gives the solver the volumes at which it holds the pieces.
    void holdVolumes();
    /// Prepares the solver for the kind of steps that the parameters ask for.
    void chooseSteps(const Params& params, bool autoIterations);
    /// The solver has the changed model.
    void becomeWhole();

    // What it was made with, and what it starts anew from. Never null.
    const std::shared_ptr<const UncutBody> first;
    std::shared_ptr<const UncutBody> uncut;
    double diagonal = 0;  ///< of the uncut body at rest [m]
    double wallEdge = 0;  ///< edge length of walls [m]
    bool thin = false;    ///< see ThinWalls::many(), of the uncut body

    std::unique_ptr<BodyUpdater> updater;
    const std::unique_ptr<GpuSolver> solverOwner;
    GpuSolver& solver = *solverOwner;
    MeshSync sync{solver};
    bool readsAllBack = false;
    bool feelsBlade = false;  ///< see Simulation::feelBlade()
    std::optional<Cutter> cutter;
    BodyMemory memory;
    bool whole = true;        ///< see Simulation::isWhole()
    int modelRevision = 0;    ///< see Simulation::modelRevision()
    bool volumesHeld = true;  ///< whether the parameters have a volume constraint

  private:
    double stillEnergy(const Params& params) const;
    std::vector<shared::PullRecord> leadsBack(const Params& params);
    std::vector<shared::PullRecord> forces(double density,
                                           const std::vector<std::uint32_t>& pulled) const;
    void castIspcs(IspcRays rays);
    std::vector<Vec3> placesAfter(const MovePins& move) const;
    void take(std::shared_ptr<const UncutBody> body);
    void lookUpTriangles();
    void beginAtRest();

    std::optional<PieceMap> pieces_;  ///< of the present mesh, if known
    bool isMoved_ = true;             ///< in this step, by hands, forces or pins
};

}  // namespace kerf
