#pragma once

#include <optional>
#include <vector>

#include "gpu/buffer.h"
#include "gpu/program.h"
#include "shaders/shared/box_records.h"
#include "sim/contact/contact_solver.h"
#include "sim/contact/static_box.h"
#include "sim/math.h"

namespace kerf {

/// Where a body is and how fast it moves at most: what decides which boxes it can reach.
struct BodyReach {
    Bounds bounds;      ///< [m]
    double speed = 0;   ///< no vertex is faster [m/s]
    double margin = 0;  ///< what it may move besides in a time step [m]
};

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
    /// Changes d where it leads into a box, and moves X out of where a box is inside the body.
    void respond();

  private:
    struct Kernels {
        gpu::Program triangles, respond, apply, vertices;
    };
    void uploadUniforms(std::size_t boxCount);
    void run(const gpu::Program& kernel, std::uint32_t threads);

    std::vector<StaticBox> boxes_;
    std::optional<Kernels> kernels_;
    ContactBody body_;
    ContactSettings settings_;
    double edgeLength_ = 0;
    bool reached_ = false;  ///< a box in this step
    gpu::Buffer uniformBuffer_, boxBuffer_, records_, shares_, sums_;
};

}  // namespace kerf
