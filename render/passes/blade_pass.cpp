#include "render/passes/blade_pass.h"

#include <glad/gl.h>

#include <algorithm>
#include <array>

#include "shaders/shared/render_bindings.h"

namespace kerf::render {
namespace {

using shared::vec4;

struct BladeVertex {
    vec4 position;  // w: height above the cutting edge, 0 to 1
    vec4 normal;    // w: shine, 1 on the ground bevel, 0 on the flat, less on the back
};
static_assert(sizeof(BladeVertex) == 32);

constexpr double kHeight = 0.11;     // of the body's size, where the blade only cuts
constexpr double kThickness = 0.05;  // half, of the height
// The back is a pixel thin in most pictures: dark, it doesn't sparkle.
constexpr double kBackShine = -0.45;
const Eigen::Vector4f kSheetTint = {0.10f, 0.62f, 0.52f, 0.30f};
const Eigen::Vector4f kEdgeTint = {0.30f, 0.95f, 0.80f, 1.0f};
const Eigen::Vector4f kForceTint = {1.0f, 0.45f, 0.10f, 1.0f};
constexpr float kEdgeWidth = 1.6f;   // [px]
constexpr float kForceWidth = 3.0f;  // [px]
constexpr double kArrowHead = 0.2;   // of the arrow's length
constexpr float kHiddenStrength = 0.22f;

vec4 packed(const Vec3& v, double w) {
    return {float(v.x()), float(v.y()), float(v.z()), float(w)};
}

Vec3 middle(const Blade& blade) {
    return 0.5 * (blade.a + blade.b);
}

/// Across the blade, towards where it came from; up where it hasn't moved.
Vec3 spineDirection(const SceneView& scene) {
    const Vec3 along = (scene.blade->b - scene.blade->a).normalized();
    Vec3 spine = Vec3::UnitY();
    if (scene.strokePoses.size() >= 2) {
        const Vec3 came = middle(scene.strokePoses[scene.strokePoses.size() - 2]) -
                          middle(scene.strokePoses.back());
        spine = came.norm() > 1e-9 ? Vec3(came.normalized()) : spine;
    }
    for (const Vec3& candidate : {spine, Vec3(Vec3::UnitY()), Vec3(Vec3::UnitX())}) {
        const Vec3 across = candidate - along * along.dot(candidate);
        if (across.norm() > 0.1) {
            return across.normalized();
        }
    }
    return Vec3::UnitZ();
}

struct KnifeShape {
    Vec3 spine;  ///< from the edge to the back, unit
    double height;
    double halfThickness;
    double bevel;  ///< where the ground bevel ends, of the height
};

/// What pushes is drawn as it is.
KnifeShape shapeOf(const SceneView& scene, double bodySize) {
    const double height = bladeHeight(scene, bodySize);
    if (!scene.bladeBody) {
        return {spineDirection(scene), height, kThickness * height, kBladeBevel};
    }
    const BladeMotion& body = *scene.bladeBody;
    return {body.frames.back().axes.col(1), height, body.halfAt(height),
            std::min(body.bevel / height, 1.0)};
}

/// A prism along AB over this cross-section (seen from B, the cutting edge below):
///     3---2
///     |   |
///     4   1
///      \ /
///       0
class KnifeBuilder {
  public:
    KnifeBuilder(const Blade& blade, const KnifeShape& shape)
        : blade_(blade),
          shape_(shape),
          side_((blade.b - blade.a).normalized().cross(shape.spine)),
          section_{{{0, 0}, {1, shape.bevel}, {1, 1}, {-1, 1}, {-1, shape.bevel}}} {}

    std::vector<BladeVertex> build() {
        for (int i = 0; i < 5; ++i) {
            addFace(i, (i + 1) % 5);
        }
        addEnd(blade_.a);
        addEnd(blade_.b);
        return std::move(vertices_);
    }

  private:
    Vec3 at(const Vec3& end, int i) const {
        return end + shape_.halfThickness * section_[i][0] * side_ +
               shape_.height * section_[i][1] * shape_.spine;
    }

    void add(const Vec3& end, int i, const Vec3& normal, double shine) {
        vertices_.push_back({packed(at(end, i), section_[i][1]), packed(normal, shine)});
    }

    void addFace(int i, int j) {
        const Vec3 across = at(blade_.a, j) - at(blade_.a, i);
        const Vec3 normal = across.cross(blade_.b - blade_.a).normalized();
        const double shine = i == 0 || j == 0 ? 1 : (i == 2 ? kBackShine : 0);
        for (const auto& [end, corner] : {std::pair{blade_.a, i},
                                          {blade_.b, i},
                                          {blade_.a, j},
                                          {blade_.a, j},
                                          {blade_.b, i},
                                          {blade_.b, j}}) {
            add(end, corner, normal, shine);
        }
    }

    void addEnd(const Vec3& end) {
        const Vec3 normal = (end - middle(blade_)).normalized();
        for (int i = 1; i < 4; ++i) {
            add(end, 0, normal, 0);
            add(end, i, normal, 0);
            add(end, i + 1, normal, 0);
        }
    }

    Blade blade_;
    KnifeShape shape_;
    Vec3 side_;
    std::array<std::array<double, 2>, 5> section_;  ///< half thicknesses aside, heights up
    std::vector<BladeVertex> vertices_;
};

std::vector<vec4> poseEnds(const std::vector<Blade>& poses) {
    std::vector<vec4> ends;
    for (const Blade& pose : poses) {
        ends.push_back(packed(pose.a, 1));
        ends.push_back(packed(pose.b, 1));
    }
    return ends;
}

/// Trails of A and B, the first pose and the blade itself.
std::vector<vec4> outline(const SceneView& scene) {
    std::vector<vec4> segments;
    const auto add = [&](const Vec3& p, const Vec3& q) {
        segments.push_back(packed(p, 1));
        segments.push_back(packed(q, 1));
    };
    for (std::size_t i = 0; i + 1 < scene.strokePoses.size(); ++i) {
        add(scene.strokePoses[i].a, scene.strokePoses[i + 1].a);
        add(scene.strokePoses[i].b, scene.strokePoses[i + 1].b);
    }
    if (scene.strokePoses.size() >= 2) {
        add(scene.strokePoses.front().a, scene.strokePoses.front().b);
        add(scene.strokePoses.back().a, scene.strokePoses.back().b);
    } else if (scene.blade) {
        add(scene.blade->a, scene.blade->b);
    }
    return segments;
}

/// A shaft, and a head of four lines.
std::vector<vec4> arrow(const Vec3& from, const Vec3& way) {
    const Vec3 tip = from + way;
    const Vec3 aside = way.unitOrthogonal() * way.norm();
    const Vec3 other = way.normalized().cross(aside);
    std::vector<vec4> segments{packed(from, 1), packed(tip, 1)};
    for (const Vec3& side : {aside, Vec3(-aside), other, Vec3(-other)}) {
        segments.push_back(packed(tip, 1));
        segments.push_back(packed(tip + kArrowHead * (0.5 * side - way), 1));
    }
    return segments;
}

}  // namespace

double bladeHeight(const SceneView& scene, double bodySize) {
    return scene.bladeBody ? scene.bladeBody->back : kHeight * bodySize;
}

BladePass::BladePass()
    : steel_(gpu::Program::graphics("render/blade.vert", "render/blade.frag")),
      sheet_(gpu::Program::graphics("render/sweep.vert", "render/flat.frag")),
      lines_(gpu::Program::graphics("render/line.vert", "render/line.frag")) {}

void BladePass::drawBlade(const SceneView& scene, const Frame& frame) {
    if (!scene.blade || (scene.blade->b - scene.blade->a).norm() < 1e-9) {
        return;
    }
    const KnifeShape shape = shapeOf(scene, frame.bodySize);
    const auto knife = KnifeBuilder(*scene.blade, shape).build();
    vertices_.assign(knife);
    vertices_.bindStorage(shared::kBindSegments);
    steel_.use();
    steel_.set("keyDirection", frame.keyDirection);
    steel_.set("viewProjection", frame.viewProjection);
    steel_.set("eye", frame.eye);
    steel_.set("spine", Vec3f(shape.spine.cast<float>()));
    glDepthFunc(GL_LESS);
    glDrawArrays(GL_TRIANGLES, 0, GLsizei(knife.size()));
}

void BladePass::drawSweep(const SceneView& scene, const Frame& frame) {
    if (scene.strokePoses.size() < 2) {
        return;
    }
    poses_.assign(poseEnds(scene.strokePoses));
    poses_.bindStorage(shared::kBindSegments);
    sheet_.use();
    sheet_.set("viewProjection", frame.viewProjection);
    sheet_.set("tint", kSheetTint);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_FALSE);
    glEnable(GL_BLEND);
    glDrawArrays(GL_TRIANGLES, 0, GLsizei(6 * (scene.strokePoses.size() - 1)));
    glDisable(GL_BLEND);
    glDepthMask(GL_TRUE);
}

void BladePass::drawEdges(const SceneView& scene, const Frame& frame) {
    drawThrough(outline(scene), kEdgeWidth, kEdgeTint, frame);
    if (scene.blade && scene.bladeForce) {
        drawThrough(arrow(middle(*scene.blade), *scene.bladeForce), kForceWidth, kForceTint, frame);
    }
}

void BladePass::drawThrough(const std::vector<vec4>& segments, float width,
                            const Eigen::Vector4f& tint, const Frame& frame) {
    if (segments.empty()) {
        return;
    }
    segments_.assign(segments);
    segments_.bindStorage(shared::kBindSegments);
    glDepthMask(GL_FALSE);
    glEnable(GL_BLEND);
    glDepthFunc(GL_GREATER);
    Eigen::Vector4f hidden = tint;
    hidden.w() = kHiddenStrength;
    drawLines(segments.size() / 2, width, hidden, frame);
    glDepthFunc(GL_LEQUAL);
    drawLines(segments.size() / 2, width, tint, frame);
    glDisable(GL_BLEND);
    glDepthMask(GL_TRUE);
}

void BladePass::drawLines(std::size_t segments, float width, const Eigen::Vector4f& tint,
                          const Frame& frame) const {
    lines_.use();
    lines_.set("viewProjection", frame.viewProjection);
    lines_.set("viewport", Eigen::Vector2f(float(frame.width), float(frame.height)));
    lines_.set("width", width);
    lines_.set("tint", tint);
    glDrawArrays(GL_TRIANGLES, 0, GLsizei(6 * segments));
}

}  // namespace kerf::render
