#pragma once

#include "gpu/buffer.h"
#include "gpu/program.h"
#include "shaders/shared/solver_uniforms.h"
#include "sim/body/body_updater.h"
#include "sim/solve/body_measure.h"
#include "sim/solve/body_view.h"
#include "sim/solve/collisions.h"
#include "sim/solve/implicit_stepper.h"
#include "sim/solve/solver_body.h"
#include "sim/solve/time_stepper.h"
#include "sim/solve/vertex_masses.h"

namespace kerf {

/// The positions of a body at the end of a step, to reset pieces that are lost in the next.
class SavedPieces {
  public:
    /// The body must outlive it. Compiles the kernel: throws gpu::ShaderError.
    explicit SavedPieces(SolverBody& body);

    /// Saves the positions on the GPU.
    void save() { body_.state.saved.copyFrom(body_.state.positions); }
    /// Restores those of some pieces, with velocities at zero.
    void restoreAtRest(std::span<const int> pieces);

  private:
    SolverBody& body_;
    gpu::Program kernel_;
    gpu::Buffer marks_;  ///< per piece
};

/// The soft body on the GPU, with results that do not depend on the number of threads. Positions X,
/// the displacement d of a step of plain PBD and velocities v are kept apart: absolute positions in
/// floats lose momentum. Inside such a step a vertex is at X + d.
///
/// It loads a body and updates it after cuts; moving, holding, measuring and collisions are
/// separate parts.
class GpuSolver {
  public:
    /// Uploads a body. Counts in the uniforms and volume targets (rest volumes) follow from it.
    /// Throws gpu::OutOfMemory.
    void setModel(const BodyModel& model, const BodyState& state);
    /// The memory layout of the vertices of each piece; sums depend on it to the last bit.
    const VertexPages& pages() const { return body_.pieces.pages(); }
    /// setModel() for a body that was cut before, with its pages from then: continues bit for bit.
    void restoreModel(const BodyModel& model, const BodyState& state, VertexPages pages);
    /// restoreModel() in kModelPortions calls, portion 0 first, so that frames can be drawn in
    /// between. The pages are moved from.
    static constexpr int kModelPortions = 7 + 2 * kConstraintTypes;
    void setModelPortion(int portion, const BodyModel& model, const BodyState& state,
                         VertexPages& pages);
    /// Follows an update of the model, at the cost of what it changed. `written`: the vertices that
    /// get a new state, including new ones; ascending. `state`: theirs, shape [written]. All others
    /// keep theirs. Resets volume targets to the rest volumes. Throws gpu::OutOfMemory.
    void update(const BodyModel& model, const BodyChange& change,
                std::span<const std::uint32_t> written, const BodyState& state);
    /// Takes the present materials of the members. Resets volume targets to the rest volumes.
    /// Throws gpu::OutOfMemory.
    void takeMaterials(const BodyModel& model);
    /// Positions and velocities of the same body.
    void setState(const BodyState& state);
    /// All positions and velocities; waits for the GPU.
    BodyState readState() const { return body_.state.read(body_.uniforms.vertex_count); }
    /// d of the running step of plain PBD, shape [vertexCount] [m].
    std::vector<Vec3f> readDisplacements() const;

    /// Takes the parameters of `uniforms` (see solverUniforms); its counts are ignored.
    void setUniforms(const shared::SolverUniforms& uniforms) { body_.setParameters(uniforms); }
    /// Unfolds from now on (see Unfolding) firmly, or, the default, gently, for use beside a
    /// cutting blade.
    void unfoldFirmly(bool firmly) { body_.unfoldFirmly(firmly); }
    /// Sets the volume targets, one per piece.
    void setVolumeTargets(std::span<const VolumeTarget> targets) {
        body_.pieces.setVolumeTargets(targets);
    }
    /// The vertices that hands hold in the coming steps; each at most once.
    void setPulls(const std::vector<shared::PullRecord>& pulls) { body_.setPulls(pulls); }

    /// Compiles the kernels of implicit steps, once. Throws gpu::ShaderError.
    void compileImplicitSteps();
    /// Makes the coming time steps of implicit ones, prepared for this body, these parameters and
    /// pinned vertices if any of them has changed. Throws gpu::ShaderError, gpu::OutOfMemory.
    void stepImplicitly(const BodyModel& model, const Params& params, const ImplicitStep& step,
                        std::vector<std::uint32_t> pinned);
    /// Makes the coming time steps of sweeps again, the default.
    void stepBySweeps() { stepper_.stepImplicitly(nullptr); }
    /// The state of contact for a snapshot, and its restoring after body and settings.
    ContactMemory contactMemory() const;
    void remember(const ContactMemory& memory);
    /// One time step: uniforms.substeps implicit steps, or uniforms.sweeps sweeps.
    void step();
    /// The phases of a step of plain PBD, the first with fresh masses.
    void predictAndStretch();
    SweepPhases& phases() { return stepper_.phases(); }
    /// Measures the body between steps; waits for the GPU. The next step relies on its box and
    /// speeds.
    BodyMeasure measure();

    /// The vertices that are fixed or have a prescribed velocity; setModel() and restoreModel()
    /// unpin all.
    VertexMasses& masses() { return masses_; }
    Collisions& collisions() { return collisions_; }
    const Collisions& collisions() const { return collisions_; }
    TimeStepper& stepper() { return stepper_; }
    const TimeStepper& stepper() const { return stepper_; }
    BodyMeasurer& measurer() { return measurer_; }
    /// The state to which lost pieces are reset; update() writes into it too.
    SavedPieces& savedPieces() { return savedPieces_; }

    /// The buffers themselves; valid while the solver lives and until setModel() or update().
    BodyView view() const;
    ConstraintView constraintView() const;
    /// Kernels started since the solver was made.
    long dispatches() const { return body_.dispatches; }

  private:
    void makeRoom(const BodyModel& model);

    SolverBody body_;
    VertexMasses masses_{body_};
    Collisions collisions_{body_};
    TimeStepper stepper_{body_, collisions_};
    std::optional<ImplicitStepper> implicit_;
    /// For what the implicit steps were prepared; none: for nothing that is there now.
    struct Prepared {
        Params params;
        double step = 0;  ///< ImplicitStep::prepared
        std::vector<std::uint32_t> pinned;
        bool operator==(const Prepared&) const = default;
    };
    std::optional<Prepared> prepared_;
    std::optional<std::vector<shared::vec4>> restoredSlips_;  ///< for the coming implicit step
    BodyMeasurer measurer_{body_, collisions_};
    SavedPieces savedPieces_{body_};
};

}  // namespace kerf
