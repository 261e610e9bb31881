#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "gpu/timer.h"
#include "shaders/shared/solver_uniforms.h"
#include "sim/body/body_updater.h"
#include "sim/contact/blade_obstacle.h"
#include "sim/contact/box_obstacles.h"
#include "sim/contact/contact_solver.h"
#include "sim/contact/obstacle_contact.h"
#include "sim/contact/paper_contact.h"
#include "sim/solve/body_measure.h"
#include "sim/solve/body_view.h"
#include "sim/solve/constraint_view.h"
#include "sim/solve/faster_way.h"
#include "sim/solve/small_body.h"
#include "sim/solve/solver_body.h"
#include "sim/solve/substep_phases.h"
#include "sim/solve/unfolding.h"
#include "sim/solve/vertex_masses.h"

namespace kerf {

/// The soft body on the GPU: the phases of ReferenceSolver in floats, in the same order, with
/// results that do not depend on the number of threads. Base positions X, the displacement d of a
/// substep and velocities v are kept apart: absolute positions in floats lose momentum. Inside a
/// substep a vertex is at X + d.
class GpuSolver {
  public:
    /// Compiles the kernels. Throws gpu::ShaderError.
    GpuSolver();

    /// Uploads a body. Counts in the uniforms and volume targets (rest volumes) follow from it.
    /// Throws gpu::OutOfMemory.
    void setModel(const BodyModel& model, const BodyState& state);
    /// How the vertices of each piece lie in memory; sums depend on it to the last bit.
    const VertexPages& pages() const { return body_.pieces.pages(); }
    /// setModel() for a body that was cut before, with the pages that it had then: what follows is
    /// equal bit for bit.
    void restoreModel(const BodyModel& model, const BodyState& state, VertexPages pages);
    /// restoreModel() in so many calls, portion 0 first, so that pictures can be drawn in between.
    /// The pages are moved from.
    static constexpr int kModelPortions = 7 + 2 * kConstraintTypes;
    void setModelPortion(int portion, const BodyModel& model, const BodyState& state,
                         VertexPages& pages);
    /// Follows an update of the model, at the cost of what it changed. `written`: the vertices
    /// that get a new state, those that are new among them; ascending. `state`: theirs, shape
    /// [written]. All others go on. Volume targets are the rest volumes again. Throws
    /// gpu::OutOfMemory.
    void update(const BodyModel& model, const BodyChange& change,
                std::span<const std::uint32_t> written, const BodyState& state);
    /// Positions and velocities of the same body.
    void setState(const BodyState& state);
    /// Takes the parameters of `uniforms` (see solverUniforms); its counts are ignored.
    void setUniforms(const shared::SolverUniforms& uniforms) { body_.setParameters(uniforms); }
    /// How folds are unfolded from now on (see Unfolding): firmly, or, as at first, gently, as
    /// beside a blade that cuts.
    void unfoldFirmly(bool firmly) { body_.unfoldFirmly(firmly); }
    /// Contact of the body with itself, off until then, or of its pieces as the paper has it, and
    /// with boxes.
    void setContact(const ContactSettings& settings);
    /// Sets the boxes that the body collides with. Throws gpu::ShaderError.
    void setBoxes(std::vector<StaticBox> boxes) {
        boxes_.setObstacles(BoxObstacles::of(std::move(boxes)));
    }
    /// How the blade's body moves in the coming step; none: it does not push. Throws
    /// gpu::ShaderError.
    void setBlade(std::optional<BladeMotion> motion) {
        blade_.setObstacles(BladeObstacle::of(std::move(motion)));
    }
    /// Sets the volume targets, one per piece.
    void setVolumeTargets(std::span<const VolumeTarget> targets) {
        body_.pieces.setVolumeTargets(targets);
    }

    /// A vertex that goes on with `velocity`, whatever pulls at it, until released.
    void anchor(int vertex, const Vec3f& velocity) { masses_.anchor(vertex, velocity); }
    void release(int vertex) { masses_.release(vertex); }
    /// Vertices (ascending) that go on with these velocities in the coming step [m/s], for those
    /// that have no mass.
    void carry(std::span<const std::uint32_t> vertices, std::span<const Vec3f> velocities) {
        masses_.carry(vertices, velocities);
    }

    /// The vertices that stay where they are, ascending, instead of those before; setModel() and
    /// restoreModel() free all.
    void setPinned(std::vector<std::uint32_t> vertices) { masses_.setPinned(std::move(vertices)); }
    /// The vertices that hands hold in the coming steps; each at most once.
    void setPulls(const std::vector<shared::PullRecord>& pulls) { body_.setPulls(pulls); }

    /// One time step: uniforms.substeps substeps of uniforms.sweeps sweeps.
    void step();
    /// Whether small bodies may be solved by one work group, as at the start, or in a dispatch for
    /// each phase like larger ones; the bits are the same.
    void allowOneGroup(bool allowed) { oneGroupAllowed_ = allowed; }
    /// Whether the phases at the end of a substep may share a dispatch where nothing but the floor
    /// can be met, as at the start; the bits are the same.
    void allowSettling(bool allowed) { settlingAllowed_ = allowed; }
    /// Sets where the group that solves a small body keeps what it changes; before setModel().
    void setSmallBodyMemory(SmallBodySolver::Memory memory) {
        smallBody_ = SmallBodySolver(memory);
    }
    /// Whether step() does so: in one dispatch, or in one for each substep where something may be
    /// touched; plain PBD only where nothing but the floor may be. Large bodies take one for each
    /// phase, in plain PBD on llvmpipe whichever is faster.
    bool solvesInOneGroup() const;
    const SmallBodySolver& smallBody() const { return smallBody_; }

    /// Whether the last measure saw a folded edge that the coming step unfolds (see Unfolding).
    bool unfolds() const;

    // The phases of a substep, in their order; each ends with a storage barrier.
    void unfold();  ///< only where something is folded
    void predictAndStretch();
    /// Solves the edges without a prediction: in all sweeps but the first.
    void stretchAgain() { phases_.stretchAgain(); }
    /// Solves the constraints of a type but edges.
    void solve(std::uint32_t type) { phases_.solve(type); }
    void solveVolume() { phases_.solveVolume(); }
    void pull() { phases_.pull(); }
    void collideBody() { contacts_.respond(); }
    void collideBlade(std::uint32_t substep) { blade_.respond(static_cast<int>(substep)); }
    void collideBoxes(std::uint32_t substep) { boxes_.respond(static_cast<int>(substep)); }
    void collideFloor() { phases_.collideFloor(); }
    void finishSubstep() { phases_.finish(); }
    /// Lets pieces respond to each other as the paper has it, where they are to: once a time step,
    /// after the last substep.
    void collideAsThePaper();

    /// Measures the body between steps; waits for the GPU. The next step counts on its box and
    /// speeds.
    BodyMeasure measure() {
        startMeasure();
        return takeMeasure();
    }
    /// measure() in two parts, between which the CPU may do something else that changes nothing
    /// here.
    void startMeasure() { measurer_.start(contactReadings()); }
    BodyMeasure takeMeasure();
    /// Has the coming measure() find out besides what takeWatched() gives; see NearbyVertices.
    void watch(const std::optional<OrientedBox>& box, std::span<const int> vertices) {
        measurer_.watch(box, vertices);
    }
    /// The watched vertices as of the last measure(). Once for each watch().
    VertexStates takeWatched() { return measurer_.takeWatched(); }
    /// Positions and velocities of these vertices; waits for the GPU.
    VertexStates statesOf(std::span<const int> vertices) { return measurer_.statesOf(vertices); }
    /// The states of all vertices of triangles that meet `box`; waits for the GPU. Between steps.
    VertexStates statesNear(const OrientedBox& box) {
        return measurer_.statesNear(box, contactReadings());
    }
    /// Looks for what may touch now, as the beginning of a step does.
    void searchContacts();
    const ContactSolver& contacts() const { return contacts_; }
    /// The memory of contact for a snapshot, and back after restoreModel() and setContact().
    ContactMemory contactMemory() const;
    void rememberContacts(const ContactMemory& memory);
    /// All positions and velocities; waits for the GPU.
    BodyState readState() const;
    /// d of the running substep, shape [vertexCount] [m].
    std::vector<Vec3f> readDisplacements() const;

    /// Remembers the positions on the GPU, and brings those of some pieces back with velocities at
    /// zero. update() writes into what is remembered too.
    void saveState();
    void restorePiecesAtRest(std::span<const int> pieces);

    /// The buffers themselves; valid while the solver lives and until setModel() or update().
    BodyView view() const;
    ConstraintView constraintView() const;
    /// GPU time of the steps since the last call [ms].
    double takeDeformMilliseconds() { return deformTimer_.takeMilliseconds(); }
    double takeCollideMilliseconds() { return collideTimer_.takeMilliseconds(); }
    /// Kernels started since the solver was made.
    long dispatches() const { return body_.dispatches; }

  private:
    void uploadCounts(const BodyModel& model);
    void makeRoom(const BodyModel& model);
    void setContactBody();
    void setReach(const Bounds& positions, const Bounds& velocities);

    ContactReadings contactReadings() const;

    // The ways through a step.
    void solveStep();
    void stepByPhases();
    void stepBySweeps();
    void stepTheFasterWay();
    void stepAtOnce();
    void stepBySubsteps();
    bool sweepsInOneGroup() const;
    bool meetsOnlyTheFloor() const;
    void holdVolumeAndCollide(std::uint32_t substep);
    void unfoldBefore();
    void searchContactsBefore(std::uint32_t substep);
    template <class Run>
    void runSmallBody(const Run& run);

    SolverBody body_;
    VertexMasses masses_{body_};
    SubstepPhases phases_{body_};
    BodyMeasurer measurer_{body_};
    SmallBodySolver smallBody_;
    FasterWay sweepsFaster_;  ///< 0: in one group, 1: by phases
    bool oneGroupAllowed_ = true;
    bool settlingAllowed_ = true;

    ContactSolver contacts_;
    PaperContact paperContact_;
    ObstacleContact boxes_{BoxObstacles::kind()};
    ObstacleContact blade_{BladeObstacle::kind()};
    double contactEdgeLength_ = 0;  ///< [m]
    RelativeMotion motion_;         ///< upper bounds
    BodyReach reach_;
    Unfolding unfolding_;
    bool unfolds_ = false;  ///< in this step

    gpu::Program restore_;
    gpu::Buffer marks_;  ///< per piece, for restorePiecesAtRest()
    gpu::Timer deformTimer_;
    gpu::Timer collideTimer_;
};

}  // namespace kerf
