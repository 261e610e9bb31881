#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/base/params.h"
#include "sim/contact/blade_body.h"
#include "sim/cut/stroke/cutter.h"
#include "sim/mesh/invariants.h"
#include "sim/mesh/surface_mesh.h"
#include "sim/run/moment.h"
#include "sim/run/parts/command.h"
#include "sim/run/parts/led_blade.h"
#include "sim/run/parts/step_report.h"
#include "sim/run/parts/stroke_record.h"
#include "sim/run/start/body_upload.h"
#include "sim/run/state_hash.h"
#include "sim/run/undo/undo_history.h"
#include "sim/solve/body_view.h"
#include "sim/solve/constraint_view.h"

namespace kerf {

/// A soft body, a blade and the parameters: one step at a time, on the GPU context that is current
/// when it is made. Equal commands at equal steps give equal bits.
class Simulation {
  public:
    /// Begins with `mesh` at rest, in world units, and `boxes` that checkBox() lets pass. Throws
    /// gpu::ShaderError, gpu::OutOfMemory.
    Simulation(SurfaceMesh mesh, const Params& params, std::vector<StaticBox> boxes = {});
    /// Begins with a body that was prepared elsewhere, and finishes its upload.
    Simulation(BodyUpload body, const Params& params, std::vector<StaticBox> boxes = {});
    ~Simulation();
    Simulation(Simulation&&) noexcept;
    Simulation& operator=(Simulation&&) noexcept;

    /// Lets all of the body come back from the GPU after each step, instead of what is read there;
    /// for tests, since it changes no result.
    void readAllBack(bool all);
    /// Number of times that all of the body came back.
    int wholeReads() const;

    /// Measures from now on what the body does to the blade's where that pushes
    /// (StepReport::bladeLoad); changes no result.
    void feelBlade(bool wanted);

    /// Applies a command before the coming step. Returns "" or one sentence; nothing changed then.
    std::string execute(const Command& command);
    /// One time step: solve -> cut -> publish; without the solve while time stands.
    const StepReport& step();
    /// Back to the uncut body at rest with the parameters and boxes it was made with; nothing can
    /// be undone then, and time starts anew.
    void reset();

    /// Sets the memory that the changes that can be undone may take [bytes]; 0, as at the start:
    /// none can be. Does not change any result.
    void setUndoBudget(std::size_t bytes);
    const UndoHistory& history() const;

    /// The present, to come back to with all that belongs to it: time, parameters, blade, history.
    Moment moment();
    void goTo(const Moment& moment);

    int stepCount() const;  ///< steps done
    /// Grows whenever the body may have moved or got another topology.
    int bodyRevision() const;
    /// Whether the body can be drawn: not at the pausePoint()s at which it becomes another one.
    bool isWhole() const;
    /// Whether time runs in steps, or stands: see SetTime.
    bool timeRuns() const;
    const Params& params() const;
    const StepReport& report() const;
    /// The pose of the blade, as it is led; none while lifted.
    std::optional<Blade> blade() const;
    /// What it was told to do in the coming step, from first to last. A moment lacks that.
    const std::vector<BladeAction>& bladeActions() const;
    /// Its pose after the coming step, by what it was told; none where it is lifted then.
    std::optional<Blade> comingBlade() const;
    /// Where its edge is: the pose, but where the material holds the edge back
    /// (StepReport::heldEdge).
    std::optional<Blade> bladeEdge() const;
    /// The blade's body where it pushes; none while it only cuts, or has not moved since it was
    /// placed.
    std::optional<BladeMotion> bladeBody() const;
    /// The rung where the blade last cut: see Cutter::rung().
    const std::vector<RungNode>& rung() const;
    /// Divided triangles since the body was whole, by pattern.
    const SubdivisionCounts& subdivisions() const;
    /// The strokes since the body was whole, in their order, as far as they are not undone. The
    /// last one may go on, and may not have met the body yet.
    const std::vector<StrokeRecord>& strokes() const;
    /// Outcome of the last step that the blade moved in.
    const CutResult& lastCut() const;
    /// What the messages said last of a step of the last stroke, or of the one that goes on, which
    /// was refused; empty where none was.
    const std::string& refusalOfStroke() const;
    /// Sentences about what went wrong in a step (refused cuts, non-finite values), since the last
    /// call.
    std::vector<std::string> takeMessages();

    /// The uncut body, as it was placed last; another one after each placement. Never null.
    const std::shared_ptr<const UncutBody>& uncut() const;
    /// The uncut body as it was at first, from which placements are made. Never null.
    const std::shared_ptr<const UncutBody>& firstUncut() const;
    /// Hands over what takes long of the next Place: makeUncutBody() of placedMesh() of
    /// firstUncut(), made on any thread. A Place that leads elsewhere does without it; no result
    /// changes.
    void expectPlacement(std::shared_ptr<const UncutBody> placed);
    /// How many models the scene consists of.
    int modelCount() const { return static_cast<int>(uncut()->models.size()); }
    /// How the numbers of the file of a model, by number, become metres of the scene.
    const Placement& placement(int model = 0) const { return uncut()->models[model].placement; }
    /// The boxes that the body collides with, besides the floor.
    const std::vector<StaticBox>& boxes() const;
    /// Vertices that stay where they are, ascending.
    const std::vector<std::uint32_t>& pinnedVertices() const;
    /// The hands that hold something, by their numbers.
    const std::vector<Hands::Hand>& hands() const;

    /// The buffers that the renderer draws from; valid until the next step or reset.
    BodyView bodyView() const;
    /// The model of what bodyView() shows, where isWhole(); valid as that.
    const BodyModel& bodyModel() const;
    /// Grows whenever bodyModel() becomes another one.
    int modelRevision() const;
    /// The buffers that overlays draw from; valid as bodyView().
    ConstraintView constraintView() const;
    /// Box around the body and what each piece holds, as of the last step, without reading anything
    /// back. Pieces stand in the order in which they came off.
    const Bounds& bounds() const;
    std::vector<Piece> measuredPieces() const;
    /// A triangle of the mesh of each of these pieces, in their order. O(triangles).
    std::vector<int> trianglesOfPieces() const;
    /// Boxes around these pieces [m], in their order.
    const std::vector<Bounds>& pieceBounds() const;
    /// The mesh with current positions and velocities (waits for the GPU where they are newer).
    const SurfaceMesh& mesh();
    /// The mesh with old numbers where nobody has looked since the last step; reading those waits
    /// for all of the body.
    const SurfaceMesh& meshAsRead() const;
    /// Looks into a box: its triangles, ascending, and perhaps others, are as they are now in
    /// meshAsRead(). Reads back what lies in the box alone; changes no result.
    std::vector<int> trianglesIn(const OrientedBox& box);
    /// Per piece: triangles, volume, rest volume (waits for the GPU as mesh()).
    const PieceMap& pieces();
    /// 64-bit FNV-1a over topology, positions, velocities and boxes, as 16 hexadecimal digits.
    std::string stateHash();
    /// The same, and a hash of each part of the state with parameters and blade (waits for the GPU
    /// as mesh()).
    StateHashes stateHashes();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace kerf
