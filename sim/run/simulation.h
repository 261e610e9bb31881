#pragma once

#include "sim/base/params.h"
#include "sim/run/checkpoint.h"
#include "sim/run/parts/command.h"
#include "sim/run/parts/hands.h"
#include "sim/run/parts/led_blade.h"
#include "sim/run/parts/pins.h"
#include "sim/run/parts/step_report.h"

namespace kerf {

class BodyUpload;
class SurfaceMesh;
class UndoHistory;
struct BodyModel;
struct BodyView;
struct ConstraintView;
struct OrientedBox;
struct Piece;
struct PieceMap;
struct RungNode;
struct StateHashes;
struct StrokeRecord;
struct UncutBody;

/// A soft body, a blade and the parameters: one step at a time, on the OpenGL context current at
/// construction. Equal commands at equal steps give equal bits.
class Simulation {
  public:
    /// Begins with `mesh` at rest, in world units, and `boxes` that pass checkBox(). Throws
    /// gpu::ShaderError, gpu::OutOfMemory.
    Simulation(SurfaceMesh mesh, const Params& params, std::vector<StaticBox> boxes = {});
    /// Begins with a body that was prepared elsewhere, and finishes its upload.
    Simulation(BodyUpload body, const Params& params, std::vector<StaticBox> boxes = {});
    ~Simulation();
    Simulation(Simulation&&) noexcept;
    Simulation& operator=(Simulation&&) noexcept;

    /// Reads the whole body back from the GPU after each step, instead of on demand; for tests,
    /// since it changes no result.
    void readAllBack(bool all);
    /// How often the whole body was read back.
    int wholeReads() const;

    /// Measures from now on the load on a pushing blade (StepReport::bladeLoad); changes no result.
    void feelBlade(bool wanted);

    /// Applies a command before the coming step. Returns "", or one sentence if nothing changed.
    std::string execute(const Command& command);
    /// One time step: solve -> cut -> publish; without the solve while paused.
    const StepReport& step();
    /// Restores the uncut body at rest with the initial parameters and boxes; clears the undo
    /// history, and restarts time.
    void reset();

    /// Sets the memory of the undo history [bytes]; 0, the default: nothing can be undone. Does not
    /// change any result.
    void setUndoBudget(std::size_t bytes);
    const UndoHistory& history() const;

    /// The present, to come back to: body, time, parameters, blade, undo history.
    Checkpoint checkpoint();
    void goTo(const Checkpoint& checkpoint);
    /// Continues from stored bytes (bytesOf()), with nothing to undo. False, and reset, where they
    /// are of other models, cut short, or don't have the state hash that they were written with.
    bool goTo(const std::vector<std::byte>& bytes);

    int stepCount() const;  ///< steps done
    /// Grows whenever the body may have moved or changed its topology.
    int bodyRevision() const;
    /// Whether the body can be drawn: not at pausePoint()s where it is inconsistent.
    bool isWhole() const;
    /// Whether time runs or is paused: see SetTime.
    bool timeRuns() const;
    const Params& params() const;
    const StepReport& report() const;
    /// The commanded pose of the blade; none while lifted.
    std::optional<Blade> blade() const;
    /// Its commands for the coming step, from first to last.
    const std::vector<BladeAction>& bladeActions() const;
    /// Its pose after the coming step; none if lifted then.
    std::optional<Blade> comingBlade() const;
    /// Its edge: the pose, unless the material resists the edge (StepReport::heldEdge).
    std::optional<Blade> bladeEdge() const;
    /// The body of a pushing blade; none while it only cuts, or has not moved since it was placed.
    std::optional<BladeMotion> bladeBody() const;
    /// The rung where the blade last cut: see Cutter::rung().
    const std::vector<RungNode>& rung() const;
    /// Divided triangles since the body was whole, by pattern.
    const SubdivisionCounts& subdivisions() const;
    /// The strokes since the body was whole, in order, without undone ones. The last one may be in
    /// progress, and may not have met the body yet.
    const std::vector<StrokeRecord>& strokes() const;
    /// Outcome of the last step with blade motion.
    const CutResult& lastCut() const;
    /// The last message about a refused step of the last or current stroke; empty for none.
    const std::string& refusalOfStroke() const;
    /// Sentences about what went wrong in a step (refused cuts, non-finite values), since the last
    /// call.
    std::vector<std::string> takeMessages();

    /// The uncut body in its last placement; replaced by each placement. Never null.
    const std::shared_ptr<const UncutBody>& uncut() const;
    /// The original uncut body, from which placements are made. Never null.
    const std::shared_ptr<const UncutBody>& firstUncut() const;
    /// Hands over the expensive part of the next Place: makeUncutBody() of placedMesh() of
    /// firstUncut(), made on any thread. Another Place ignores it; no result changes.
    void expectPlacement(std::shared_ptr<const UncutBody> placed);
    /// The number of models in the scene.
    int modelCount() const;
    /// The placement of a model, by number.
    const Placement& placement(int model = 0) const;
    /// The boxes that the body collides with, besides the floor.
    const std::vector<StaticBox>& boxes() const;
    /// Pinned vertices, ascending.
    const std::vector<std::uint32_t>& pinnedVertices() const;
    /// The motions of pinned vertices, ended ones too.
    const std::vector<Pins::Motion>& motions() const;
    /// The forces on regions.
    const std::vector<Pins::Force>& forces() const;
    /// The hands that hold something, by their numbers.
    const std::vector<Hands::Hand>& hands() const;

    /// The buffers that the renderer draws from; valid until the next step or reset.
    BodyView bodyView() const;
    /// The model of bodyView(), if isWhole(); valid as long as that.
    const BodyModel& bodyModel() const;
    /// Grows whenever bodyModel() changes.
    int modelRevision() const;
    /// The buffers that overlays draw from; valid as long as bodyView().
    ConstraintView constraintView() const;
    /// The bounds of the body, and the contents of each piece, after the last step, without reading
    /// anything back. Pieces are in the order of separation.
    const Bounds& bounds() const;
    std::vector<Piece> measuredPieces() const;
    /// A triangle of the mesh of each of these pieces, in their order. O(triangles).
    std::vector<int> trianglesOfPieces() const;
    /// Boxes around these pieces [m], in their order.
    const std::vector<Bounds>& pieceBounds() const;
    /// The mesh with current positions and velocities (waits for the GPU where they are newer).
    const SurfaceMesh& mesh();
    /// The mesh with stale state where nothing was read since the last step; reading that waits for
    /// the whole body.
    const SurfaceMesh& meshAsRead() const;
    /// Reads a box back: its triangles, ascending, and perhaps others, are then up to date in
    /// meshAsRead(). Changes no result.
    std::vector<int> trianglesIn(const OrientedBox& box);
    /// Per piece: triangles, volume, rest volume (waits for the GPU like mesh()).
    const PieceMap& pieces();
    /// 64-bit FNV-1a over topology, positions, velocities and boxes, as 16 hexadecimal digits.
    std::string stateHash();
    /// stateHash() and a hash of each part of the state, parameters and blade included (waits for
    /// the GPU like mesh()).
    StateHashes stateHashes();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace kerf
