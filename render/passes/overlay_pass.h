#pragma once

#include "gpu/buffer.h"
#include "gpu/program.h"
#include "render/passes/frame.h"

namespace kerf::render {

/// Overlays over the body: constraints as lines, contacts and pins as dots, boxes, and marks.
/// Inside the body they are fainter.
class OverlayPass {
  public:
    OverlayPass();
    void draw(const SceneView& scene, const Frame& frame);

  private:
    enum Kind { edges, bends, ispcs, pulls, pairs };

    void drawConstraints(Kind kind, const SceneView& scene, const Frame& frame);
    void drawContacts(const SceneView& scene, const Frame& frame);
    void drawPins(const SceneView& scene, const Frame& frame);
    void drawBoxes(const SceneView& scene, const Frame& frame);
    void drawMarks(const SceneView& scene, const Frame& frame);
    void upload(const std::shared_ptr<const std::vector<Marks>>& marks);
    void drawDots(std::size_t count, float radius, float hidden, const DisplayColor& color,
                  const Frame& frame);

    std::array<gpu::Program, 5> constraints_;
    gpu::Program chosen_;
    gpu::Program contacts_;
    gpu::Program lines_;
    gpu::Buffer pinned_;
    gpu::Buffer boxes_;
    /// The buffers of one set of marks.
    struct MarkBuffers {
        gpu::Buffer lines;
        gpu::Buffer dots;
    };
    std::shared_ptr<const std::vector<Marks>> marks_;  ///< that markBuffers_ hold
    std::vector<MarkBuffers> markBuffers_;
};

}  // namespace kerf::render
