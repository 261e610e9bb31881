#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>

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

/// The body of a simulation as it runs: constant set-up, running state on the GPU, the mesh, which
/// is the truth about topology and fetches positions where they are read, and all that cutting and
/// solving remember of it. What a Snapshot keeps.
struct RunningBody {
    /// Runs an uncut body at rest, which `loadedSolver` has been given.
    RunningBody(PreparedBody prepared, std::unique_ptr<GpuSolver> loadedSolver);

    /// The uncut body at rest, nothing held or pinned. measureAtRest() once the parameters apply.
    void startAnew();
    /// startAnew() of the uncut body as it was at first.
    void startAsAtFirst();
    /// "", or one sentence where the scene has no model of this number.
    std::string checkModel(int model) const;
    /// startAnew() with `placed`, the uncut body with its models put elsewhere.
    void startAnew(std::shared_ptr<const UncutBody> placed);
    void measureAtRest();
    void apply(const Params& params);

    /// The body as it is now; never null.
    SnapshotPointer capture();
    /// Bit for bit. The parameters are to be applied again.
    void restore(const Snapshot& snapshot);

    /// Lets targets of volumes fade, and hands and what is drawn back move, before the solver's
    /// step.
    void prepareStep(const Params& params);
    void bringLostPiecesBack();
    /// Keeps triangles of a folded thin body from passing through each other, unless they did at
    /// `before` [m]. Measures the body anew where some did.
    void stopCrossings(const std::vector<Vec3>& before, const Params& params);
    /// Measures what the solver's step has moved; waits for the GPU.
    void measureStep();
    /// The solver's step is over, with lost pieces back. Returns how long it took to list what lies
    /// near the blade, which the GPU has found [ms].
    double endStep();

    /// The triangles near what is swept between these points [m], ascending.
    std::vector<int> trianglesNear(std::span<const Vec3> strip);
    /// Tells whether there are any.
    bool isNear(std::span<const Vec3> strip) { return !trianglesNear(strip).empty(); }
    /// The rung where the blade last cut, as it lies now.
    std::vector<RungNode> front() const;
    /// The mesh has changed.
    void forgetPieces() { pieces_.reset(); }

    /// See Simulation::readAllBack().
    void readAllBack(bool all);

    /// The box around what is pinned, once it is moved so [m].
    Bounds pinnedAfter(const MovePins& move) const;
    /// Moves it, at once.
    void movePinned(const MovePins& move);

    /// The running mesh: another one after models were put elsewhere, and what was before.
    SurfaceMesh& mesh() const { return *uncut->running; }
    const BodyModel& model() const { return updater->model(); }
    /// Whether a piece may have gone through itself, as far as the last measure shows: some edge is
    /// folded, or a piece holds little of its volume.
    bool looksCollapsed() const;
    /// Whether it has hardly moved for so long that it stays as it is until something is done to
    /// it.
    bool liesStill() const;
    /// A step of `timeStep` [s] has been measured, in which a piece was lost or not.
    void noteStillness(double timeStep, bool lost);
    /// Tells whether walls of a stroke of the open course are absent.
    bool isOpen() const;
    const PieceMap& pieces();
    /// The solver has the model again after it became another one.
    void becomeWhole();

    // What it was made with, and what it starts anew from. Never null.
    const std::shared_ptr<const UncutBody> first;
    std::shared_ptr<const UncutBody> uncut;
    double diagonal = 0;  ///< of the uncut body at rest [m]
    double wallEdge = 0;  ///< edge length of walls [m]
    bool thin = false;    ///< see isThin(), of the uncut body

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
    std::vector<shared::PullRecord> leadsBack(const Params& params);
    void castIspcs(IspcRays rays);
    std::vector<Vec3> placesAfter(const MovePins& move) const;
    void take(std::shared_ptr<const UncutBody> body);
    void lookUpTriangles();
    void beginAtRest();

    std::optional<PieceMap> pieces_;  ///< of the mesh as it is, where it is known
};

}  // namespace kerf
