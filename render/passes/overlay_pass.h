#pragma once

#include <array>

#include "gpu/buffer.h"
#include "gpu/program.h"
#include "render/passes/frame.h"

namespace kerf::render {

/// What acts on the body, drawn over it: constraints as lines, contacts and pins as dots, boxes.
/// Inside the body they are fainter.
class OverlayPass {
  public:
    OverlayPass();
    void draw(const SceneView& scene, const Frame& frame);

  private:
    enum Kind { edges, bends, ispcs, pulls };

    void drawConstraints(Kind kind, const SceneView& scene, const Frame& frame);
    void drawContacts(const SceneView& scene, const Frame& frame);
    void drawPins(const SceneView& scene, const Frame& frame);
    void drawBoxes(const SceneView& scene, const Frame& frame);

    std::array<gpu::Program, 4> constraints_;
    gpu::Program chosen_;
    gpu::Program contacts_;
    gpu::Program lines_;
    gpu::Buffer pinned_;
    gpu::Buffer boxes_;
};

}  // namespace kerf::render
