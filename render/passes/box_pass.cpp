#include "render/passes/box_pass.h"

#include <glad/gl.h>

#include <array>

#include "shaders/shared/render_bindings.h"

namespace kerf::render {
namespace {

using shared::uint;
using Corners = std::array<uint, 4>;  // of a triangle; the last word is unused

// Corner i of a box takes the high side along axis k where bit k of i is set. Two triangles a face,
// so that corner 0 of each is a right angle: box.vert relies on that.
constexpr std::array<Corners, 12> kTriangles{{{0, 4, 2, 0},
                                              {6, 2, 4, 0},
                                              {1, 3, 5, 0},
                                              {7, 5, 3, 0},
                                              {0, 1, 4, 0},
                                              {5, 4, 1, 0},
                                              {2, 6, 3, 0},
                                              {7, 3, 6, 0},
                                              {0, 2, 1, 0},
                                              {3, 1, 2, 0},
                                              {4, 5, 6, 0},
                                              {7, 6, 5, 0}}};

}  // namespace

BoxPass::BoxPass(const gpu::Defines& defines)
    : program_(gpu::Program::graphics("render/box.vert", "render/box.frag", defines)) {}

void BoxPass::update(const SceneView& scene) {
    std::vector<shared::vec4> positions;
    std::vector<Corners> triangles;
    for (const StaticBox& box : scene.boxes) {
        const auto first = static_cast<uint>(positions.size());
        for (const Corners& t : kTriangles) {
            triangles.push_back({first + t[0], first + t[1], first + t[2], 0});
        }
        for (int i = 0; i < 8; ++i) {
            const Vec3f p = box.corner(i).cast<float>();
            positions.push_back({p.x(), p.y(), p.z(), 1});
        }
    }
    triangleCount_ = static_cast<uint>(triangles.size());
    if (triangles.empty()) {
        return;
    }
    positions_.assign(positions);
    triangles_.assign(triangles);
}

void BoxPass::draw(const Frame& frame) const {
    if (triangleCount_ == 0) {
        return;
    }
    positions_.bindStorage(shared::kBindPositions);
    triangles_.bindStorage(shared::kBindTriangles);
    program_.use();
    setLight(program_, frame);
    program_.set("viewProjection", frame.viewProjection);
    program_.set("eye", frame.eye);
    program_.set("edgeWidth", 0.012f * frame.bodySize);
    program_.set("hasBody", frame.hasBody ? 1.0f : 0.0f);
    glDepthFunc(GL_LESS);
    glDrawArrays(GL_TRIANGLES, 0, GLsizei(3 * triangleCount_));
}

BodyView BoxPass::view() const {
    BodyView view;
    view.positions = &positions_;
    view.triangles = &triangles_;
    view.triangleCount = triangleCount_;
    return view;
}

}  // namespace kerf::render
