#pragma once

#include <optional>

#include "gpu/buffer.h"
#include "gpu/program.h"
#include "sim/contact/blade_body.h"
#include "sim/contact/box_touches.h"

namespace kerf {

/// Contact of a body with the body of the blade, on the GPU, with the same bits for any number of
/// threads: as with static boxes, but that the blade moves, tapers towards its edge, and stands in
/// the slit that the edge has cut, whose walls it holds apart. A blade that the body cannot reach
/// in a time step costs nothing.
class BladeContact {
  public:
    /// A new body, or one that has more vertices or triangles.
    void setBody(const ContactBody& body) { body_ = body; }
    void setSettings(const ContactSettings& settings) { settings_ = settings; }
    /// How the blade moves in the coming step, with a frame more than substeps; none: it does not
    /// push. Compiles the kernels with the first one: throws gpu::ShaderError.
    void setMotion(std::optional<BladeMotion> motion);

    /// Before the first substep of a time step. Throws gpu::OutOfMemory.
    void beginStep(const BodyReach& reach);
    /// Whether the blade is in reach in this step.
    bool mayTouch() const { return reached_; }
    /// Changes d where it leads into the blade, and moves X out of where it is inside.
    void respond(int substep);

  private:
    struct Kernels {
        BoxTouches touches;
        gpu::Program vertices;
    };

    std::optional<BladeMotion> motion_;
    std::optional<Kernels> kernels_;
    ContactBody body_;
    ContactSettings settings_;
    bool reached_ = false;  ///< the blade in this step
    gpu::Buffer blades_;    ///< BladeRecord per substep
};

}  // namespace kerf
