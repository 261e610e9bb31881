#pragma once

#include "gpu/buffer.h"
#include "gpu/program.h"
#include "gpu/read_back.h"
#include "sim/base/math.h"
#include "sim/contact/contact_solver.h"

namespace kerf {

/// The edge of a blade that presses on the material in front of it during a time step, as a spring
/// between the edge and its commanded place. The force is distributed over the material around it,
/// by mass and distance.
struct PressingEdge {
    Vec3 from = Vec3::Zero();   ///< ends of the part that touches the material [m]
    Vec3 to = Vec3::Zero();     ///< [m]
    Vec3 ahead = Vec3::Zero();  ///< unit: the direction in which it presses
    double reach = 0;           ///< distance at which the share falls to an eighth [m]
    double lag = 0;             ///< mean lag at the start of the step [m]
    double way = 0;             ///< commanded advance in the time step [m]
    double stiffness = 0;       ///< of the spring, > 0 [N/m]
    double mostForce = 0;       ///< [N]
};

/// The load of the edge on the body in a time step.
struct EdgeLoad {
    double force = 0;            ///< along PressingEdge::ahead, a mean over the step [N]
    Vec3 middle = Vec3::Zero();  ///< point of application [m]
    double work = 0;             ///< of the command [J]
};

/// Presses the edge of a blade on a body, on the GPU, with the same bits for any number of threads:
/// one work group sums up in a fixed order.
class EdgePush {
  public:
    /// None: no edge presses in the coming step. The first one compiles the kernels: throws
    /// gpu::ShaderError.
    void setEdge(const std::optional<PressingEdge>& edge);
    const std::optional<PressingEdge>& edge() const { return edge_; }
    /// A new body, or one that has more vertices.
    void setBody(const ContactBody& body, double /*edgeLength*/) { body_ = body; }
    void setSettings(const ContactSettings& settings) { settings_ = settings; }

    /// Begins a time step, before its first substep. Throws gpu::OutOfMemory.
    void beginStep();
    /// Whether it presses in this step.
    bool mayTouch() const { return edge_.has_value(); }
    /// Binds what kernels of implicit steps have of the edge (implicit_records.h).
    void bindPressing() const;
    /// Requests the load of the last time step, if it pressed.
    void askForLoad(gpu::ReadBack& back);
    /// Reads the requested load; waits for the GPU.
    void takeLoad(const gpu::ReadBack& back);
    /// The load read last; zero if it did not press.
    const EdgeLoad& load() const { return load_; }

  private:
    void bind() const;

    std::optional<PressingEdge> edge_;
    std::optional<gpu::Program> weigh_;
    ContactBody body_;
    ContactSettings settings_;
    gpu::Buffer uniforms_, weights_, state_;
    std::optional<std::size_t> place_;  ///< of the requested state
    EdgeLoad load_;
};

}  // namespace kerf
