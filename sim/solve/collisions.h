#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "gpu/read_back.h"
#include "sim/contact/contact_solver.h"
#include "sim/contact/edge_push.h"
#include "sim/contact/obstacle_contact.h"
#include "sim/contact/obstacles.h"
#include "sim/contact/paper_contact.h"
#include "sim/solve/solver_body.h"

namespace kerf {

/// What a measure reads of contact between the parts of a body.
struct ContactReadings {
    const gpu::Buffer& state;     ///< a ContactState: its counts
    const gpu::Buffer& searched;  ///< X when candidates were looked for; of some size where never
    bool counts;                  ///< whether contact is on
};

/// What a body collides with but for the floor: itself, boxes and the blade's body, each where it
/// may be met in a step.
class Collisions {
  public:
    /// The body must outlive it. Compiles kernels: throws gpu::ShaderError.
    explicit Collisions(SolverBody& body) : body_(body) {}

    /// A new body, or one of which triangles or the rest shape changed. Throws gpu::OutOfMemory.
    void setBody(const BodyModel& model);
    /// Contact of the body with itself, off until then, or of its pieces as the paper has it, and
    /// with boxes.
    void setSettings(const ContactSettings& settings);
    /// Sets the boxes that the body collides with. Throws gpu::ShaderError.
    void setBoxes(std::vector<StaticBox> boxes) {
        boxes_.setObstacles(BoxObstacles::of(std::move(boxes)));
    }
    /// How the blade's body moves in the coming step; none: it does not push. Throws
    /// gpu::ShaderError.
    void setBlade(std::optional<BladeMotion> motion) {
        blade_.setObstacles(BladeObstacle::of(std::move(motion)));
    }

    /// How the blade's edge presses in the coming step; none: it does not. Throws gpu::ShaderError.
    void setEdge(const std::optional<PressingEdge>& edge) { edge_.setEdge(edge); }
    const std::optional<PressingEdge>& edge() const { return edge_.edge(); }
    /// What it did in the last time step that was measured.
    const EdgeLoad& edgeLoad() const { return edge_.load(); }

    /// Measures from now on what the body does to the blade's; changes nothing else.
    void feelBlade(bool wanted) { blade_.measureLoad(wanted); }
    /// What it did in the last time step that was measured.
    const BladeLoad& bladeLoad() const { return blade_.load(); }
    /// Asks for what edge and blade did in the last time step, as far as it is measured.
    void askForLoads(gpu::ReadBack& back);
    /// Takes up what was sent of that; waits for the GPU.
    void takeLoads(const gpu::ReadBack& back);

    /// The body has been put elsewhere.
    void forgetCandidates() { contacts_.forgetCandidates(); }
    /// Where the body is and how fast [m, m/s] when the coming step begins, which decides what it
    /// may meet; an empty box of velocities: all at rest. The speed of `motion` follows from them.
    void expect(const Bounds& positions, const Bounds& velocities, RelativeMotion motion = {});
    /// Whether the skin was folded then.
    bool expectsFolds() const { return motion_.folded; }

    /// Begins a time step, before its first substep. `folds`: see ContactSolver::setFolds().
    void beginStep(const gpu::Buffer* folds);
    /// Whether anything may be met in this step.
    bool mayTouch() const;
    bool searchesBefore(std::uint32_t substep) const {
        return contacts_.searchesBefore(static_cast<int>(substep));
    }
    /// Looks for what may touch.
    void search() { contacts_.search(); }
    /// Begins a substep, before anything moves X.
    void beginSubstep() { boxes_.beginSubstep(); }
    void respond(std::uint32_t substep);
    /// Whether pieces respond to each other as the paper has it: once a time step, after the last
    /// substep.
    bool followsThePaper() const { return paperContact_.enabled(); }
    void respondAsThePaper();

    const ContactSolver& contacts() const { return contacts_; }
    ContactReadings readings() const;
    /// The memory of contact for a snapshot, and back once body and settings are.
    ContactMemory memory() const;
    void remember(const ContactMemory& memory);

  private:
    template <class F>
    void forEachKind(F&& f);

    SolverBody& body_;
    ContactSolver contacts_;
    PaperContact paperContact_;
    ObstacleContact boxes_{BoxObstacles::kind()};
    ObstacleContact blade_{BladeObstacle::kind()};
    EdgePush edge_;
    RelativeMotion motion_;  ///< upper bounds
    BodyReach reach_;
};

}  // namespace kerf
