#pragma once

#include <optional>
#include <vector>

#include "gpu/buffer.h"
#include "gpu/program.h"
#include "sim/contact/box_touches.h"
#include "sim/contact/static_box.h"

namespace kerf {

/// Contact of a body with static boxes, on the GPU, with the same bits for any number of threads:
/// corners and edges of boxes against triangles first, then vertices against boxes, which have the
/// last word. Boxes that the body cannot reach in a time step cost nothing.
class BoxContact {
  public:
    /// All boxes there are. Compiles the kernels with the first one: throws gpu::ShaderError.
    void setBoxes(std::vector<StaticBox> boxes);
    /// A new body, or one that has more vertices or triangles. `edgeLength`: see
    /// contactEdgeLength().
    void setBody(const ContactBody& body, double edgeLength);
    void setSettings(const ContactSettings& settings) { settings_ = settings; }

    /// Before the first substep of a time step. Throws gpu::OutOfMemory.
    void beginStep(const BodyReach& reach);
    /// Whether a box is in reach in this step.
    bool mayTouch() const { return reached_; }
    /// Changes d where it leads into a box, and moves X out of where a box is inside the body.
    void respond();

  private:
    struct Kernels {
        BoxTouches touches;
        gpu::Program vertices;
    };

    std::vector<StaticBox> boxes_;
    std::optional<Kernels> kernels_;
    ContactBody body_;
    ContactSettings settings_;
    double edgeLength_ = 0;
    bool reached_ = false;  ///< a box in this step
    gpu::Buffer boxBuffer_;
};

}  // namespace kerf
