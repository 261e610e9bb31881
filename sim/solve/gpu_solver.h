#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "gpu/buffer.h"
#include "gpu/program.h"
#include "gpu/timer.h"
#include "shaders/shared/body_records.h"
#include "shaders/shared/solver_uniforms.h"
#include "sim/body/body_updater.h"
#include "sim/contact/blade_obstacle.h"
#include "sim/contact/box_obstacles.h"
#include "sim/contact/contact_solver.h"
#include "sim/contact/obstacle_contact.h"
#include "sim/solve/body_view.h"
#include "sim/solve/constraint_view.h"
#include "sim/solve/faster_way.h"
#include "sim/solve/gathered_records.h"
#include "sim/solve/nearby_vertices.h"
#include "sim/solve/scatter.h"
#include "sim/solve/small_body.h"
#include "sim/solve/unfolding.h"
#include "sim/solve/vertex_pages.h"

namespace kerf {

/// What volume a piece is held at; chips are left alone (PieceModel::holdsVolume).
struct VolumeTarget {
    double volume = 0;  ///< [m^3]
    bool constrained = true;
};

/// What the CPU learns from the GPU after a step, without reading the body back.
struct BodyMeasure {
    std::vector<double> pieceVolumes;  ///< [m^3]
    std::vector<Bounds> pieceBounds;   ///< [m]
    Bounds bounds;                     ///< of the living triangles [m]
    /// Pieces with a vertex that is not finite or faster than runawaySpeed(), or that have grown
    /// beyond kLargestPiece; ascending.
    std::vector<int> lostPieces;
    int contacts = 0;          ///< of the body with itself in the last substep
    double kineticEnergy = 0;  ///< of the vertices that are free to move [J]
    /// Of them, in the field of gravity above the floor, or above 0 [J].
    double potentialEnergy = 0;
    /// Of the strained material: the sum of C^2 / (2 alpha) over edges, bends and ISPCs that are on
    /// and not rigid; means nothing with plain PBD [J].
    double strainEnergy = 0;
};

/// A piece whose box is longer than this many diagonals of the uncut body has run away.
inline constexpr double kLargestPiece = 20;
/// What no vertex of a body of this size reaches but by a blow-up: 1000 diagonals a second, and
/// what free fall adds in 100 s. `diagonal` [m], `gravity` [m/s^2].
double runawaySpeed(double diagonal, double gravity);

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
    const VertexPages& pages() const { return pages_; }
    /// setModel() for a body that was cut before, with the pages that it had then: what follows is
    /// equal bit for bit.
    void restoreModel(const BodyModel& model, const BodyState& state, VertexPages pages);
    /// restoreModel() in so many calls, portion 0 first, so that pictures can be drawn in between.
    /// The pages are moved from.
    static constexpr int kModelPortions = 12;
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
    void setUniforms(const shared::SolverUniforms& uniforms);
    /// Contact of the body with itself, off until then, and with boxes.
    void setContact(const ContactSettings& settings);
    /// What the body collides with. Throws gpu::ShaderError.
    void setBoxes(std::vector<StaticBox> boxes) {
        boxes_.setObstacles(BoxObstacles::of(std::move(boxes)));
    }
    /// How the blade's body moves in the coming step; none: it does not push. Throws
    /// gpu::ShaderError.
    void setBlade(std::optional<BladeMotion> motion) {
        blade_.setObstacles(BladeObstacle::of(std::move(motion)));
    }
    /// One per piece.
    void setVolumeTargets(std::span<const VolumeTarget> targets);

    /// A vertex that goes on with `velocity`, whatever pulls at it, until released.
    void anchor(int vertex, const Vec3f& velocity);
    void release(int vertex);
    /// Vertices (ascending) that go on with these velocities in the coming step [m/s], for those
    /// that have no mass.
    void carry(std::span<const std::uint32_t> vertices, std::span<const Vec3f> velocities);

    /// The vertices that stay where they are, ascending, instead of those before; setModel() and
    /// restoreModel() free all.
    void setPinned(std::vector<std::uint32_t> vertices);
    /// The vertices that hands hold in the coming steps; each at most once.
    void setPulls(const std::vector<shared::PullRecord>& pulls);

    /// One time step: uniforms.substeps substeps of uniforms.sweeps sweeps.
    void step();
    /// Whether small bodies may be solved by one work group, as at the start, or in a dispatch for
    /// each phase like larger ones; the bits are the same.
    void allowOneGroup(bool allowed) { oneGroupAllowed_ = allowed; }
    /// Whether the phases at the end of a substep may share a dispatch where nothing but the floor
    /// can be met, as at the start; the bits are the same.
    void allowSettling(bool allowed) { settlingAllowed_ = allowed; }
    /// Before setModel(): where that group keeps what it changes.
    void setSmallBodyMemory(SmallBodySolver::Memory memory) {
        smallBody_ = SmallBodySolver(memory);
    }
    /// Whether step() does so: in one dispatch, or in one for each substep where something may be
    /// touched; plain PBD only where nothing but the floor may be. Large bodies take one for each
    /// phase, in plain PBD on llvmpipe whichever is faster.
    bool solvesInOneGroup() const;

    // The phases of a substep, in their order; each ends with a storage barrier.
    void unfold();  ///< only where something is folded
    void predictAndStretch();
    void stretchAgain();  ///< instead of it in all sweeps but the first
    void solveBends();
    void solveIspcs();
    void solveVolume();
    void pull();
    void collideBody();
    void collideBlade(std::uint32_t substep);
    void collideBoxes(std::uint32_t substep);
    void collideFloor();
    void finishSubstep();

    /// Of the positions between steps; waits for the GPU. The next step counts on its box and
    /// speeds.
    BodyMeasure measure();
    /// What the coming measure() is to find out besides, for takeWatched(); see NearbyVertices.
    void watch(const std::optional<OrientedBox>& box, std::span<const int> vertices) {
        nearby_.ask(box, vertices);
    }
    /// As of the last measure(). Once for each watch().
    VertexStates takeWatched() { return nearby_.take(); }
    /// Positions and velocities of these vertices; waits for the GPU.
    VertexStates statesOf(std::span<const int> vertices);
    /// Looks for what may touch now, as the beginning of a step does.
    void searchContacts();
    const ContactSolver& contacts() const { return contacts_; }
    /// What a snapshot keeps of contact, and back after restoreModel() and setContact().
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
    long dispatches() const { return dispatches_; }

  private:
    struct IncidenceBuffers {
        gpu::Buffer ranges;
        gpu::Buffer entries;
        void assign(const Incidence& incidence);
    };
    struct ConstraintKernels {
        gpu::Program stretchAgain, bend, ispc;
    };
    struct Kernels {
        ConstraintKernels anySolver, plainPbd;
        gpu::Program stretch, gatherBends, gatherIspcs, gatherOntoFloor, volumeGradient,
            volumeCorrect, floor, finish, settle, measure, collect, masses, pull, restore;
    };

    void stepByPhases();
    void stepBySweeps();
    void stepTheFasterWay();
    bool sweepsInOneGroup() const;
    bool plainPbd() const;
    SmallBodyBuffers smallBodyBuffers() const;
    bool liftsInGather() const;
    void holdVolumeAndCollide(std::uint32_t substep);
    bool meetsOnlyTheFloor() const;
    void sumVolume();
    void settle();
    void stepAtOnce();
    void stepBySubsteps();
    void unfoldBefore();
    void runSmallBody(const SubstepRun& run);
    void searchContactsBefore(std::uint32_t substep);
    void takeModel(const BodyModel& model, VertexPages& pages);
    void uploadRestShape(const BodyModel& model);
    void uploadTriangleLists(const BodyModel& model);
    void uploadCounts(const BodyModel& model);
    void uploadState(const BodyModel& model, const BodyState& state);
    void uploadPieces(const BodyModel& model);
    void resizeScratch(const BodyModel& model);
    void updateVertices(const BodyModel& model, const BodyChange& change);
    void updateState(std::span<const std::uint32_t> written, const BodyState& state);
    void updateRecords(const BodyModel& model, const BodyChange& change);
    void updateSpokes(const BodyModel& model, const BodyChange& change);
    void updateBendLists(const BodyModel& model, const BodyChange& change);
    void updateIspcShares(const BodyModel& model, const BodyChange& change);
    void solveIspcs(const gpu::Program& gather);
    const ConstraintKernels& constraintKernels() const;
    void bindSpokes() const;
    void bindConstraints() const;
    void updateLists(IncidenceBuffers& buffers, const Incidence& incidence,
                     const std::vector<std::uint32_t>& vertices);
    void refreshMasses();
    void holdPins();
    void setMasses();
    void setContactBody();
    void setReach(const Bounds& positions, const Bounds& velocities);
    void uploadUniforms();
    void setInverseUnitMass(int vertex, float value);
    void compileConstraints();
    void bindBody() const;
    /// For kernels that fetch it: as texels and, where loadsImages_, as an image.
    void bindFetched(const gpu::Buffer& buffer, std::uint32_t binding,
                     gpu::TexelFormat format) const;
    void run(const gpu::Program& kernel, std::uint32_t threads);
    void runOverConstraints(const gpu::Program& kernel, std::uint32_t count);
    void runOverBlocks(const gpu::Program& kernel);
    void collectAsked(const NearbyVertices& query);
    bool isPinned(int vertex) const {
        return std::ranges::binary_search(pinned_, static_cast<std::uint32_t>(vertex));
    }
    bool active(shared::uint part) const { return (uniforms_.active_parts & part) != 0; }

    bool loadsImages_ = false;  ///< on llvmpipe
    Kernels kernels_;
    shared::SolverUniforms uniforms_{};
    std::vector<float> areas_;  ///< rest area of each vertex [m^2]
    std::vector<int> pieceOf_;  ///< of each vertex, -1 for none
    bool massesLag_ = false;
    std::vector<std::uint32_t> pinned_;
    double diagonal_ = 0;  ///< of the body at rest [m]
    VertexPages pages_;
    std::vector<shared::PieceRecord> pieces_;
    std::vector<shared::BlockRecord> blocks_;

    gpu::Buffer uniformBuffer_;
    gpu::Buffer positions_, velocities_, displacement_, previous_, restPositions_, cutSkinNormals_;
    gpu::Buffer savedPositions_;
    gpu::Buffer links_, areaBuffer_, triangles_, placeBuffer_, pageBuffer_;
    gpu::Buffer pulls_, marks_;
    gpu::Buffer edgeRanges_, spokes_, bends_, bendRanges_, bendEntries_;
    gpu::Buffer ispcs_, ispcRanges_, ispcShares_, corrections_;
    IncidenceBuffers triangleIncidence_, neighbours_;
    BendLists bendLists_;
    gpu::Buffer gradients_, pieceBuffer_, blockBuffer_, blockSums_, impulses_, blockMeasures_;

    NearbyVertices nearby_;     ///< of the coming measure()
    NearbyVertices collected_;  ///< of statesOf()
    Scatter scatter_;
    SmallBodySolver smallBody_;
    FasterWay sweepsFaster_;  ///< 0: in one group, 1: by phases
    bool oneGroupAllowed_ = true;
    bool settlingAllowed_ = true;
    ContactSolver contacts_;
    double contactEdgeLength_ = 0;
    RelativeMotion motion_;  ///< upper bounds
    BodyReach reach_;
    ObstacleContact boxes_{BoxObstacles::kind()};
    ObstacleContact blade_{BladeObstacle::kind()};
    Unfolding unfolding_;
    bool unfolds_ = false;  ///< in this step
    gpu::Timer deformTimer_;
    gpu::Timer collideTimer_;
    long dispatches_ = 0;
};

}  // namespace kerf
