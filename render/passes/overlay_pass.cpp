#include "render/passes/overlay_pass.h"

#include <glad/gl.h>

#include "shaders/shared/body_records.h"
#include "shaders/shared/constraints.h"
#include "shaders/shared/render_bindings.h"

namespace kerf::render {
namespace {

constexpr float kLineWidth = 1.3F;  // [px]
constexpr float kPullWidth = 1.6F;
constexpr float kBoxWidth = 1.6F;
constexpr float kContactRadius = 3.5F;
constexpr float kPinRadius = 4;
constexpr float kMarkWidth = 2.2F;
constexpr float kMarkRadius = 4.5F;
constexpr float kHiddenMark = 0.35F;   // of marks behind the body
constexpr float kHiddenInside = 0.5F;  // of what lies inside by nature
constexpr float kHidden = 0.14F;       // of what lies behind

Eigen::Vector3f tone(const DisplayColor& c) {
    return Eigen::Vector3f(c[0], c[1], c[2]) / 255;
}

gpu::Program constraintProgram(const char* kind) {
    return gpu::Program::graphics("render/constraint.vert", "render/constraint.frag",
                                  {{"KIND", kind}});
}

gpu::Program dotProgram(const char* kind) {
    return gpu::Program::graphics("render/dot.vert", "render/dot.frag", {{"KIND", kind}});
}

/// Twice: fainter what is hidden, then what is seen. `set` takes the strength.
template <class Set>
void drawBothSides(GLsizei vertices, float hidden, Set&& set) {
    glDepthFunc(GL_GREATER);
    set(hidden);
    glDrawArrays(GL_TRIANGLES, 0, vertices);
    glDepthFunc(GL_LEQUAL);
    set(1.0F);
    glDrawArrays(GL_TRIANGLES, 0, vertices);
}

void setView(const gpu::Program& program, const Frame& frame) {
    program.set("viewProjection", frame.viewProjection);
    program.set("viewport", Eigen::Vector2f(float(frame.width), float(frame.height)));
}

void setTones(const gpu::Program& program, const DisplayColor& type, bool errors) {
    program.set("showError", errors ? 1.0F : 0.0F);
    program.set("fullError", kFullError);
    program.set("typeColor", tone(type));
    program.set("shortColor", tone(kShortColor));
    program.set("restColor", tone(kRestColor));
    program.set("longColor", tone(kLongColor));
}

std::vector<shared::vec4> edgesOf(const Bounds& box) {
    const auto packed = [&](int corner) {
        const Vec3 p = box.corner(corner);
        return shared::vec4{float(p.x()), float(p.y()), float(p.z()), 1};
    };
    std::vector<shared::vec4> ends;
    for (int corner = 0; corner < 8; ++corner) {
        for (const int bit : {1, 2, 4}) {
            if ((corner & bit) == 0) {
                ends.push_back(packed(corner));
                ends.push_back(packed(corner | bit));
            }
        }
    }
    return ends;
}

}  // namespace

OverlayPass::OverlayPass()
    : constraints_{constraintProgram("0"), constraintProgram("1"), constraintProgram("2"),
                   constraintProgram("3"), constraintProgram("4")},
      chosen_(dotProgram("0")),
      contacts_(dotProgram("1")),
      lines_(gpu::Program::graphics("render/line.vert", "render/line.frag")) {}

void OverlayPass::draw(const SceneView& scene, const Frame& frame) {
    glDepthMask(GL_FALSE);
    glEnable(GL_BLEND);
    scene.body.positions->bindStorage(shared::kBindPositions);
    scene.body.restPositions->bindStorage(shared::kBindRestPositions);
    if (scene.overlays.ispcs) {
        drawConstraints(ispcs, scene, frame);
    }
    if (scene.overlays.showsEdges()) {
        drawConstraints(edges, scene, frame);
    }
    if (scene.overlays.bends) {
        drawConstraints(bends, scene, frame);
    }
    drawConstraints(pulls, scene, frame);
    drawBoxes(scene, frame);
    drawContacts(scene, frame);
    drawPins(scene, frame);
    drawMarks(scene, frame);
    glDisable(GL_BLEND);
    glDepthMask(GL_TRUE);
}

void OverlayPass::drawConstraints(Kind kind, const SceneView& scene, const Frame& frame) {
    const ConstraintView& view = scene.constraints;
    struct Source {
        const gpu::Buffer* records;
        std::size_t recordBytes;
        std::uint32_t count;
        std::uint32_t lines;  // of a record
        DisplayColor color;
        float width;
        float hidden;
    };
    const std::array<Source, 4> sources{
        {{scene.body.triangles, sizeof(std::array<std::uint32_t, 4>), scene.body.triangleCount, 3,
          kEdgeColor, kLineWidth, 0},
         {view.bends, sizeof(shared::BendRecord), view.bendCount, 2, kBendColor, kLineWidth, 0},
         {view.ispcs, sizeof(shared::IspcConstraint), view.ispcCount, 1, kIspcColor, kLineWidth,
          kHiddenInside},
         {view.pulls, sizeof(shared::PullRecord), view.pullCount, 1, kPinColor, kPullWidth,
          kHiddenInside}}};
    const Source& source = sources[kind];
    if (source.records == nullptr || source.count == 0) {
        return;
    }
    const gpu::Program& program = constraints_[kind];
    program.use();
    setView(program, frame);
    program.set("width", source.width);
    setTones(program, source.color, scene.overlays.errors && kind != pulls);
    source.records->bindStorageParts(
        kind == edges ? shared::kBindTriangles : shared::kBindConstraints, source.recordBytes,
        [&](std::size_t first, std::size_t count) {
            const std::size_t end = std::min<std::size_t>(first + count, source.count);
            const std::size_t drawn = end - std::min(first, end);
            drawBothSides(GLsizei(6 * source.lines * drawn), source.hidden,
                          [&](float strength) { program.set("strength", strength); });
        });
}

void OverlayPass::drawContacts(const SceneView& scene, const Frame& frame) {
    const ConstraintView& view = scene.constraints;
    if (!scene.overlays.contacts || view.contacts == nullptr || view.mostContacts == 0) {
        return;
    }
    view.contacts->bindStorage(shared::kBindConstraints);
    view.contactState->bindStorage(shared::kBindContactState);
    contacts_.use();
    setView(contacts_, frame);
    contacts_.set("radius", kContactRadius);
    contacts_.set("tone", tone(kContactColor));
    drawBothSides(GLsizei(6 * view.mostContacts), kHiddenInside,
                  [&](float strength) { contacts_.set("strength", strength); });
}

void OverlayPass::drawPins(const SceneView& scene, const Frame& frame) {
    if (scene.pinned.empty()) {
        return;
    }
    pinned_.assign(scene.pinned);
    pinned_.bindStorage(shared::kBindConstraints);
    drawDots(scene.pinned.size(), kPinRadius, kHidden, kPinColor, frame);
}

void OverlayPass::drawDots(std::size_t count, float radius, float hidden, const DisplayColor& color,
                           const Frame& frame) {
    chosen_.use();
    setView(chosen_, frame);
    chosen_.set("radius", radius);
    chosen_.set("tone", tone(color));
    drawBothSides(GLsizei(6 * count), hidden,
                  [&](float strength) { chosen_.set("strength", strength); });
}

void OverlayPass::upload(const std::shared_ptr<const std::vector<Marks>>& marks) {
    if (marks == marks_) {
        return;
    }
    marks_ = marks;
    markBuffers_.clear();
    markBuffers_.reserve(marks->size());
    for (const Marks& each : *marks) {
        MarkBuffers& buffers = markBuffers_.emplace_back();
        buffers.lines.assign(each.lines);
        buffers.dots.assign(each.dots);
    }
}

void OverlayPass::drawMarks(const SceneView& scene, const Frame& frame) {
    if (!scene.marks) {
        return;
    }
    upload(scene.marks);
    for (std::size_t m = 0; m < markBuffers_.size(); ++m) {
        const Marks& marks = (*scene.marks)[m];
        const std::size_t lines = marks.lines.size() / 2;
        const gpu::Program& program = constraints_[pairs];
        program.use();
        setView(program, frame);
        program.set("width", kMarkWidth);
        setTones(program, marks.color, false);
        markBuffers_[m].lines.bindStorageParts(
            shared::kBindConstraints, 2 * sizeof(std::uint32_t),
            [&](std::size_t first, std::size_t count) {
                const std::size_t end = std::min(first + count, lines);
                drawBothSides(GLsizei(6 * (end - std::min(first, end))), kHiddenMark,
                              [&](float strength) { program.set("strength", strength); });
            });
        if (!marks.dots.empty()) {
            markBuffers_[m].dots.bindStorage(shared::kBindConstraints);
            drawDots(marks.dots.size(), kMarkRadius, kHiddenMark, marks.color, frame);
        }
    }
}

void OverlayPass::drawBoxes(const SceneView& scene, const Frame& frame) {
    std::vector<shared::vec4> ends;
    for (const Bounds& box : scene.pieceBoxes) {
        if (!box.empty()) {
            const auto lines = edgesOf(box);
            ends.insert(ends.end(), lines.begin(), lines.end());
        }
    }
    if (ends.empty()) {
        return;
    }
    boxes_.assign(ends);
    boxes_.bindStorage(shared::kBindSegments);
    lines_.use();
    setView(lines_, frame);
    lines_.set("width", kBoxWidth);
    const Eigen::Vector3f color = tone(kBoxColor);
    drawBothSides(GLsizei(3 * ends.size()), kHidden, [&](float strength) {
        lines_.set("tint", Eigen::Vector4f(color.x(), color.y(), color.z(), strength));
    });
}

}  // namespace kerf::render
