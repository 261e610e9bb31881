#pragma once

#include "gpu/read_back.h"
#include "sim/contact/contact_solver.h"
#include "sim/contact/edge_push.h"
#include "sim/contact/obstacle_contact.h"
#include "sim/contact/obstacles.h"
#include "sim/contact/paper_contact.h"
#include "sim/solve/solver_body.h"

namespace kerf {

/// The inputs of a measure from self-contact.
struct ContactReadings {
    const gpu::Buffer& state;     ///< a ContactState: its counts
    const gpu::Buffer& searched;  ///< X at the last search; of any size without one
    bool counts;                  ///< whether contact is on
};

/// The collisions of a body except with the floor: with itself, boxes and the blade's body, each
/// only if possible in a step.
class Collisions {
  public:
    /// The body must outlive it. Compiles kernels: throws gpu::ShaderError.
    explicit Collisions(SolverBody& body) : body_(body) {}

    /// A new body, or the one before with changed triangles or rest shape. Throws gpu::OutOfMemory.
    void setBody(const BodyModel& model, bool isNew);
    /// Settings of self-contact, off until then, or the paper's contact of pieces, and of contact
    /// with boxes.
    void setSettings(const ContactSettings& settings);
    /// Sets the boxes that the body collides with. Throws gpu::ShaderError.
    void setBoxes(std::vector<StaticBox> boxes) {
        boxes_.setObstacles(BoxObstacles::of(std::move(boxes)));
    }
    /// The motion of the blade's body in the coming step; none: it does not push. Throws
    /// gpu::ShaderError.
    void setBlade(std::optional<BladeMotion> motion) {
        blade_.setObstacles(BladeObstacle::of(std::move(motion)));
    }

    /// The pressing edge in the coming step; none: it does not press. Throws gpu::ShaderError.
    void setEdge(const std::optional<PressingEdge>& edge) { edge_.setEdge(edge); }
    const std::optional<PressingEdge>& edge() const { return edge_.edge(); }
    /// The load on the edge in the last measured time step.
    const EdgeLoad& edgeLoad() const { return edge_.load(); }

    /// Measures from now on the load on the blade's body; changes nothing else.
    void feelBlade(bool wanted) { blade_.measureLoad(wanted); }
    /// The load on the blade's body in the last measured time step.
    const BladeLoad& bladeLoad() const { return blade_.load(); }
    /// Requests the measured loads of edge and blade in the last time step.
    void askForLoads(gpu::ReadBack& back);
    /// Reads the requested loads; waits for the GPU.
    void takeLoads(const gpu::ReadBack& back);

    /// For a body that was moved by other means than a step.
    void forgetCandidates() { contacts_.forgetCandidates(); }
    /// The bounds of positions and velocities [m, m/s] at the start of the coming step, for
    /// possible contacts; an empty box of velocities: all at rest. They give the speed of `motion`.
    void expect(const Bounds& positions, const Bounds& velocities, RelativeMotion motion = {});
    /// No two vertices differed by more in velocity then [m/s].
    double relativeSpeed() const { return motion_.speed; }
    /// Whether the skin was folded then.
    bool expectsFolds() const { return motion_.folded; }

    /// Begins a time step, before its first substep. `folds`: see ContactSolver::setFolds().
    void beginStep(const gpu::Buffer* folds);
    bool searchesBefore(std::uint32_t substep) const {
        return contacts_.searchesBefore(static_cast<int>(substep));
    }
    /// Searches for contact candidates.
    void search() { contacts_.search(); }
    /// Begins a substep, before anything moves X.
    void beginSubstep() { boxes_.beginSubstep(); }
    /// Answers in a sweep of plain PBD.
    void respond();
    /// See ObstacleContact::keepSides().
    void keepSides(const gpu::Buffer& velocities, double h) { boxes_.keepSides(velocities, h); }
    /// Whether pieces respond to each other as in the paper: once a time step, after the last
    /// substep.
    bool followsThePaper() const { return paperContact_.enabled(); }
    void respondAsThePaper();

    const ContactSolver& contacts() const { return contacts_; }
    const ObstacleContact& boxes() const { return boxes_; }
    const ObstacleContact& bladeBody() const { return blade_; }
    const EdgePush& push() const { return edge_; }
    ContactReadings readings() const;
    /// The state of contact for a snapshot; restore it after body and settings.
    ContactMemory memory() const;
    void remember(const ContactMemory& memory);

  private:
    template <class F>
    void forEachKind(F&& f);

    SolverBody& body_;
    ContactOrder order_;
    ContactSolver contacts_;
    PaperContact paperContact_;
    ObstacleContact boxes_{BoxObstacles::kind()};
    ObstacleContact blade_{BladeObstacle::kind()};
    EdgePush edge_;
    RelativeMotion motion_;  ///< upper bounds
    BodyReach reach_;
};

}  // namespace kerf
