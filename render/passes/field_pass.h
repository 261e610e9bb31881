#pragma once

#include "gpu/buffer.h"
#include "gpu/program.h"
#include "render/passes/frame.h"
#include "render/passes/normals_pass.h"

namespace kerf::render {

/// Draws the body in the colours of a quantity instead of its look.
class FieldPass {
  public:
    FieldPass();

    /// Computes the quantity of the frame, unless it is that of the last one.
    void update(const SceneView& scene);
    /// Drops the values, for another body with its own revisions.
    void forget() { shown_.reset(); }
    /// Draws into the bound target.
    void draw(const SceneView& scene, const Frame& frame, const NormalsPass& shape);

    /// The range of the colours of the last frame.
    const FieldRange& range() const { return range_; }
    /// The value of the last picture at a vertex, over its skin or over its walls; none if there is
    /// none (waits for the GPU).
    std::optional<float> valueAt(std::uint32_t vertex, bool onWall) const;
    /// Links every program that it may need. Throws gpu::ShaderError.
    void linkEvery() { openedOnes(); }
    /// SceneView::bodyRevision that the values are of.
    std::optional<int> bodyRevision() const { return shown_ ? shown_->revision : std::nullopt; }

  private:
    /// All that values and range depend on.
    struct Source {
        std::optional<int> revision;
        FieldChoice choice;
        const FieldValues* values = nullptr;
        std::uint32_t vertexCount = 0;
        bool operator==(const Source&) const = default;
    };
    void measure(const SceneView& scene);
    void take(const FieldValues& values);
    std::vector<FieldSample> samples() const;
    void drawKind(const gpu::Program& program, const SceneView& scene, const Frame& frame) const;

    gpu::Program strain_;
    gpu::Program area_;
    using Kinds = std::array<gpu::Program, 2>;  // skin, walls
    static Kinds kindsFor(const gpu::Defines& defines);
    const Kinds& openedOnes();

    Kinds whole_;
    std::optional<Kinds> opened_;  // from the first picture of a section
    gpu::Buffer values_;
    FieldRange range_;
    std::optional<Source> shown_;
};

}  // namespace kerf::render
