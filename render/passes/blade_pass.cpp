#include "render/passes/blade_pass.h"

#include <glad/gl.h>

#include "shaders/shared/render_bindings.h"

namespace kerf::render {
namespace {

using shared::vec4;

struct BladeVertex {
    vec4 position;  // w: height above the cutting edge, 0 to 1
    vec4 normal;    // w: shine, 1 on the ground bevel, 0 on the flat, less on the back
};
static_assert(sizeof(BladeVertex) == 32);

// Of the body's size, where the blade only cuts.
constexpr double kHeight = 0.14;
constexpr double kLeastLength = 0.2;  // what is missing is a handle
// Of the height: half the thickness, seen from the side and along the edge.
constexpr double kThickness = 0.035;
constexpr double kThicknessEndOn = 0.11;
constexpr double kMostHeight = 0.5;  // of the length of the edge
constexpr double kRidge = 0.85;      // of the height, where its back begins
// Where the eye looks along the edge, the blade grows from a point over this share of its length:
// so its sides are seen, and not the cross-section alone.
constexpr double kGround = 0.25;
constexpr double kSettled = 0.02;  // of the body's size: a way so long tells where it came from
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
Vec3 spineDirection(const SceneView& scene, double bodySize) {
    const Blade& blade = *scene.blade;
    const Vec3 along = (blade.b - blade.a).normalized();
    Vec3 came = Vec3::Zero();
    for (auto pose = scene.strokePoses.rbegin();
         pose != scene.strokePoses.rend() && came.norm() < kSettled * bodySize; ++pose) {
        came = middle(*pose) - middle(blade);
    }
    for (const Vec3& candidate :
         {Vec3(came.stableNormalized()), Vec3(Vec3::UnitY()), Vec3(Vec3::UnitX())}) {
        const Vec3 across = candidate - along * along.dot(candidate);
        if (across.norm() > 0.1) {
            return across.normalized();
        }
    }
    return Vec3::UnitZ();
}

/// How far the eye looks along the edge: 0 from the side, 1 where it is seen as a point.
double endOn(const Blade& blade, const Vec3f& eye) {
    const Vec3 sight = (eye.cast<double>() - middle(blade)).normalized();
    const double along = std::abs(sight.dot((blade.b - blade.a).normalized()));
    return std::clamp((along - 0.9) / 0.09, 0.0, 1.0);
}

struct KnifeShape {
    Vec3 spine;  ///< from the edge to the back, unit
    double height;
    double halfThickness;
    double bevel;       ///< where the ground bevel ends, of the height
    double ridge = 1;   ///< where the back begins, of the height
    double ground = 0;  ///< share of the length over which it grows from a point
};

/// What pushes is drawn as it is.
KnifeShape shapeOf(const SceneView& scene, const Blade& blade, const Frame& frame) {
    const double height = bladeHeight(scene, frame.bodySize);
    if (!scene.bladeBody) {
        const double along = endOn(blade, frame.eye);
        const double half = height * (kThickness + along * (kThicknessEndOn - kThickness));
        return {spineDirection(scene, frame.bodySize),
                height,
                half,
                kBladeBevel,
                kRidge,
                along * kGround};
    }
    const BladeMotion& body = *scene.bladeBody;
    return {body.frames.back().axes.col(1), height, body.halfAt(height),
            std::min(body.bevel / height, 1.0)};
}

/// A prism along AB over this cross-section (seen from B, the cutting edge below), which may grow
/// from a point at A:
///       3
///     4   2
///     |   |
///     5   1
///      \ /
///       0
class KnifeBuilder {
  public:
    KnifeBuilder(const Blade& blade, const KnifeShape& shape)
        : blade_(blade),
          shape_(shape),
          side_((blade.b - blade.a).normalized().cross(shape.spine)),
          section_{{{0, 0},
                    {1, shape.bevel},
                    {1, shape.ridge},
                    {0, 1},
                    {-1, shape.ridge},
                    {-1, shape.bevel}}} {}

    std::vector<BladeVertex> build() {
        const Station tip{blade_.a, 0};
        const Station full{blade_.a + shape_.ground * (blade_.b - blade_.a), 1};
        const Station end{blade_.b, 1};
        for (int i = 0; i < kCorners; ++i) {
            addFace(tip, full, i);
            addFace(full, end, i);
        }
        addEnd(end);
        return std::move(vertices_);
    }

  private:
    static constexpr int kCorners = 6;
    /// A place along the edge, and the size of the cross-section there.
    struct Station {
        Vec3 at;
        double size;
    };

    Vec3 at(const Station& station, int i) const {
        return station.at + station.size * (shape_.halfThickness * section_[i][0] * side_ +
                                            shape_.height * section_[i][1] * shape_.spine);
    }

    void add(const Station& station, int i, const Vec3& normal, double shine) {
        vertices_.push_back(
            {packed(at(station, i), station.size * section_[i][1]), packed(normal, shine)});
    }

    void addFace(const Station& from, const Station& to, int i) {
        const int j = (i + 1) % kCorners;
        const Vec3 across = at(to, j) - at(to, i);
        const Vec3 normal = across.cross(at(to, i) - at(from, i)).stableNormalized();
        const bool back = i == 2 || i == 3;
        const double shine = i == 0 || j == 0 ? 1 : (back && from.size > 0 ? kBackShine : 0);
        for (const auto& [station, corner] :
             {std::pair{from, i}, {to, i}, {from, j}, {from, j}, {to, i}, {to, j}}) {
            add(station, corner, normal, shine);
        }
    }

    void addEnd(const Station& end) {
        const Vec3 normal = (end.at - middle(blade_)).normalized();
        for (int i = 1; i + 1 < kCorners; ++i) {
            add(end, 0, normal, 0);
            add(end, i, normal, 0);
            add(end, i + 1, normal, 0);
        }
    }

    Blade blade_;
    KnifeShape shape_;
    Vec3 side_;
    /// Half thicknesses aside, heights up.
    std::array<std::array<double, 2>, kCorners> section_;
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
    }
    const std::vector<Blade>& poses = scene.strokePoses;
    if (scene.blade && (poses.size() < 2 || poses.back().b != scene.blade->b)) {
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

std::optional<Blade> drawnBlade(const SceneView& scene, double bodySize) {
    std::optional<Blade> blade = scene.blade;
    const double length = blade ? (blade->b - blade->a).norm() : 0;
    if (!(length > 0)) {
        return std::nullopt;
    }
    if (!scene.bladeBody) {
        const double missing = std::max(kLeastLength * bodySize - length, 0.0);
        blade->a -= missing / length * (blade->b - blade->a);
    }
    return blade;
}

double bladeHeight(const SceneView& scene, double bodySize) {
    if (scene.bladeBody) {
        return scene.bladeBody->back;
    }
    const double length = scene.blade ? (scene.blade->b - scene.blade->a).norm() : 0;
    return std::min(kHeight * bodySize, kMostHeight * length);
}

BladePass::BladePass()
    : steel_(gpu::Program::graphics("render/blade.vert", "render/blade.frag")),
      sheet_(gpu::Program::graphics("render/sweep.vert", "render/flat.frag")),
      lines_(gpu::Program::graphics("render/line.vert", "render/line.frag")) {}

void BladePass::drawBlade(const SceneView& scene, const Frame& frame) {
    const std::optional<Blade> blade = drawnBlade(scene, frame.bodySize);
    if (!blade) {
        return;
    }
    const KnifeShape shape = shapeOf(scene, *blade, frame);
    const auto knife = KnifeBuilder(*blade, shape).build();
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
