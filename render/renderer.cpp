#include "render/renderer.h"

#include <glad/gl.h>

#include "gpu/context.h"
#include "gpu/program.h"
#include "render/passes/blade_pass.h"
#include "render/passes/depth_passes.h"
#include "render/passes/field_pass.h"
#include "render/passes/frame.h"
#include "render/passes/normals_pass.h"
#include "render/passes/overlay_pass.h"
#include "render/passes/screen_passes.h"
#include "render/passes/section_pass.h"
#include "render/passes/surface_pass.h"
#include "render/passes/surroundings_pass.h"
#include "render/scene/environment.h"
#include "shaders/shared/render_bindings.h"
#include "shaders/shared/shared_types.h"

namespace kerf::render {
namespace {

constexpr int kSamples = 4;
constexpr std::array<float, 3> kCoveredColor{0.2F, 0.21F, 0.24F};  // about that of the floor

gpu::Defines definesFor(Quality quality) {
    return quality == Quality::full ? gpu::Defines{{"SOFT_SHADOWS", "1"}} : gpu::Defines{};
}

int shadowSize(Quality quality) {
    return quality == Quality::full ? 2048 : 1024;
}

int floorShadeSize(Quality quality) {
    return quality == Quality::full ? 384 : 192;
}

Roundness roundnessOf(Quality quality) {
    return quality == Quality::full ? Roundness{32768, 4} : Roundness{12000, 1};
}

/// The state that every picture starts from, whatever the interface left behind.
void resetState() {
    glDisable(GL_CULL_FACE);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_STENCIL_TEST);
    glDisable(GL_CLIP_DISTANCE0);
    glStencilMask(0xff);
    glClearStencil(0);
    glDisable(GL_FRAMEBUFFER_SRGB);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    for (GLuint unit = 0; unit < 4; ++unit) {
        glBindSampler(unit, 0);
    }
}

/// Brings the near plane there, so that all that is drawn later is hidden; panels let a little of
/// this ground shine through.
void closeOff(const std::vector<PixelRect>& covered, int pictureHeight) {
    const auto [red, green, blue] = kCoveredColor;
    glEnable(GL_SCISSOR_TEST);
    glClearColor(red, green, blue, 1);
    glClearDepth(0);
    for (const PixelRect& rect : covered) {
        glScissor(rect.x, pictureHeight - rect.y - rect.height, std::max(rect.width, 0),
                  std::max(rect.height, 0));
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    }
    glClearDepth(1);
    glDisable(GL_SCISSOR_TEST);
}

/// A section counts the surface itself; colours of its own and quantities are told by its corners.
bool isFlat(const SceneView& scene) {
    return scene.section || scene.paint || scene.field.choice.field != SurfaceField::look;
}

/// Crevices are darker where there is light, and where no section shows the inside.
bool hasDarkCrevices(const SceneView& scene) {
    return !scene.section && scene.look.shading == Shading::lit &&
           scene.field.choice.field == SurfaceField::look;
}

}  // namespace

/// All that shadows and normals depend on.
struct Renderer::ShadowSource {
    int bodyRevision = 0;
    std::uint32_t vertexCount = 0;
    std::uint32_t triangleCount = 0;
    std::vector<PieceLook> pieces;
    std::vector<StaticBox> boxes;
    std::optional<double> floor;
    double hardEdges = 0;
    bool flat = false;
    Eigen::Matrix4f light, shade;
    bool operator==(const ShadowSource&) const = default;

    static std::optional<ShadowSource> of(const SceneView& scene, const Frame& frame) {
        if (!scene.bodyRevision) {
            return std::nullopt;
        }
        return ShadowSource{*scene.bodyRevision,
                            scene.body.vertexCount,
                            scene.body.triangleCount,
                            scene.pieces,
                            scene.boxes,
                            scene.floor,
                            scene.hardEdges,
                            isFlat(scene),
                            frame.lightMatrix,
                            frame.shadeMatrix};
    }
};

struct Renderer::State {
    explicit State(Quality wanted)
        : quality(wanted),
          samples(quality == Quality::full ? std::min(kSamples, gpu::queryDevice().maxSamples) : 1),
          normals(roundnessOf(quality)),
          shadow(shadowSize(quality)),
          floorShade(floorShadeSize(quality)),
          surface(definesFor(quality)),
          boxes(definesFor(quality)) {
        // Core profile draws nothing without a vertex array, even where no attribute is read.
        glCreateVertexArrays(1, &vertexArray);
        if (quality == Quality::full) {
            occlusion.emplace();
        }
    }
    ~State() { glDeleteVertexArrays(1, &vertexArray); }
    State(const State&) = delete;
    State& operator=(const State&) = delete;

    void makeTargets(int width, int height, bool withStencil);
    void uploadLooks(const SceneView& scene, Frame& frame);
    void drawShadows(const SceneView& scene, const Frame& frame);
    void drawOverlays(const SceneView& scene, const Frame& frame);
    void drawBody(const SceneView& scene, const Camera& camera, const Frame& frame);
    void drawOpened(const SceneView& scene, const Camera& camera, const Frame& frame);
    void drawSurface(const SceneView& scene, const Frame& frame);
    void drawColors(const SceneView& scene, const Camera& camera, const Frame& frame);

    const Quality quality;
    int samples;
    std::uint32_t vertexArray = 0;
    gpu::Buffer looks;
    gpu::Framebuffer drawn;
    bool hasStencil = false;  ///< of `drawn`, for a section
    gpu::Framebuffer resolved;
    NormalsPass normals;
    ShadowPass shadow;
    FloorShadePass floorShade;
    Studios studios;
    SurfacePass surface;
    BoxPass boxes;
    FloorPass floor;
    RimPass rims;
    BladePass blade;
    SmoothPass smoothing;
    std::optional<ShadowSource> shadowsOf;   ///< what the shadows were drawn of
    std::optional<OverlayPass> overlays;     ///< from the first picture that shows some
    std::optional<OcclusionPass> occlusion;  ///< of the full tier
    std::optional<FieldPass> field;          ///< from the first picture that shows a quantity
    std::optional<SectionPass> section;      ///< from the first picture that has one
};

void Renderer::State::makeTargets(int width, int height, bool withStencil) {
    if (resolved.width() == width && resolved.height() == height && hasStencil == withStencil) {
        return;
    }
    hasStencil = withStencil;
    resolved = gpu::Framebuffer(GL_RGBA8, GL_DEPTH_COMPONENT32F, width, height);
    drawn = gpu::Framebuffer(GL_RGBA8, withStencil ? GL_DEPTH32F_STENCIL8 : GL_DEPTH_COMPONENT32F,
                             width, height, samples);
}

void Renderer::State::uploadLooks(const SceneView& scene, Frame& frame) {
    std::vector<shared::vec4> words(2 * std::max<std::size_t>(1, scene.pieces.size()));
    for (std::size_t p = 0; p < scene.pieces.size(); ++p) {
        const PieceLook& look = scene.pieces[p];
        words[2 * p] = {look.tint.x(), look.tint.y(), look.tint.z(),
                        look.hidden ? -1.0f : look.strength};
        words[2 * p + 1] = {float(look.shift.x()), float(look.shift.y()), float(look.shift.z()), 0};
    }
    looks.assign(words);
    frame.looks = &looks;
    frame.lookCount = static_cast<std::uint32_t>(scene.pieces.size());
}

/// A view that turns around a body at rest keeps them.
void Renderer::State::drawShadows(const SceneView& scene, const Frame& frame) {
    std::optional<ShadowSource> source = ShadowSource::of(scene, frame);
    if (source && source == shadowsOf) {
        return;
    }
    shadowsOf = std::move(source);
    normals.run(scene.body, scene.hardEdges, isFlat(scene));
    shadow.draw(scene, boxes.view(), frame);
    if (scene.floor) {
        floorShade.draw(scene, boxes.view(), frame);
    }
}

void Renderer::State::drawOverlays(const SceneView& scene, const Frame& frame) {
    const bool wanted = scene.overlays.any() || !scene.pinned.empty() ||
                        !scene.pieceBoxes.empty() || scene.constraints.pullCount > 0 || scene.marks;
    if (!frame.hasBody || !wanted) {
        return;
    }
    if (!overlays) {
        overlays.emplace();
    }
    overlays->draw(scene, frame);
}

/// The body, and the boxes that it may lie on.
void Renderer::State::drawBody(const SceneView& scene, const Camera& camera, const Frame& frame) {
    shadow.bind();
    studios.of(scene.bright).bind(shared::kUnitEnvironment);
    if (frame.hasBody) {
        drawOpened(scene, camera, frame);
    }
    boxes.draw(frame);
    if (occlusion && frame.hasBody && hasDarkCrevices(scene)) {
        occlusion->draw(frame, drawn, resolved);
    }
    floorShade.bind();
}

void Renderer::State::drawOpened(const SceneView& scene, const Camera& camera, const Frame& frame) {
    if (!scene.section) {
        drawSurface(scene, frame);
        return;
    }
    if (!section) {
        section.emplace();
    }
    glEnable(GL_CLIP_DISTANCE0);
    drawSurface(scene, frame);
    glDisable(GL_CLIP_DISTANCE0);
    glClear(GL_STENCIL_BUFFER_BIT);
    section->draw(scene, frame, camera, surface);
}

void Renderer::State::drawSurface(const SceneView& scene, const Frame& frame) {
    if (scene.field.choice.field == SurfaceField::look) {
        surface.draw(scene, frame, normals);
        return;
    }
    if (!field) {
        field.emplace();
    }
    field->update(scene);
    field->draw(scene, frame, normals);
}

void Renderer::State::drawColors(const SceneView& scene, const Camera& camera, const Frame& frame) {
    drawn.bind();
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    glClearColor(0, 0, 0, 0);
    glClear(scene.transparent ? GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT : GL_DEPTH_BUFFER_BIT);
    closeOff(scene.covered, frame.height);
    drawBody(scene, camera, frame);
    blade.drawBlade(scene, frame);
    if (!scene.transparent) {
        floor.draw(scene.floor, frame, camera);
    }
    if (frame.hasBody && scene.cutLines && scene.hasWalls) {
        rims.draw(scene, frame, normals);
    }
    drawOverlays(scene, frame);
    blade.drawSweep(scene, frame);
    blade.drawEdges(scene, frame);
    if (samples > 1 || scene.transparent) {  // smoothing knows no alpha
        drawn.blitColorTo(resolved);
    } else {
        smoothing.draw(scene, frame, drawn, resolved);
    }
}

Renderer::Renderer(Quality quality) : state_(std::make_unique<State>(quality)) {}

Renderer::~Renderer() = default;

Quality Renderer::quality() const {
    return state_->quality;
}

void Renderer::setQuality(Quality quality) {
    if (quality != state_->quality) {
        auto next = std::make_unique<State>(quality);
        next->surface.takeRestShape(state_->surface);
        state_ = std::move(next);
    }
}

void Renderer::linkEveryProgram() {
    state_->surface.linkEvery();
    state_->rims.linkEvery();
    const OverlayPass overlays;
    FieldPass().linkEvery();
    SectionPass().linkEvery();
}

void Renderer::setRestShape(const SurfaceMesh& uncut) {
    setRestDepth(measureSkinDepth(uncut));
}

void Renderer::setRestDepth(const DepthField& depth) {
    state_->surface.setDepth(depth);
    state_->shadowsOf.reset();  // of another body
    if (state_->field) {
        state_->field->forget();
    }
}

void Renderer::draw(const SceneView& scene, const Camera& camera, int width, int height) {
    width = std::max(width, 1);
    height = std::max(height, 1);
    state_->makeTargets(width, height, scene.section.has_value());
    Frame frame = frameOf(scene, camera, width, height, state_->shadow.size());
    frame.mattLight = state_->studios.of(scene.bright).matt();
    state_->uploadLooks(scene, frame);
    glBindVertexArray(state_->vertexArray);
    resetState();
    state_->boxes.update(scene);
    if (frame.hasBody) {
        state_->drawShadows(scene, frame);
    }
    state_->drawColors(scene, camera, frame);
    glBindVertexArray(0);
    state_->resolved.bind();
}

FieldRange Renderer::fieldRange() const {
    return state_->field ? state_->field->range() : FieldRange{};
}

std::optional<float> Renderer::fieldAt(int bodyRevision, std::uint32_t vertex, bool onWall) const {
    if (!state_->field || state_->field->bodyRevision() != bodyRevision) {
        return std::nullopt;
    }
    return state_->field->valueAt(vertex, onWall);
}

const gpu::Framebuffer& Renderer::target() const {
    return state_->resolved;
}

Image Renderer::readPicture() const {
    const gpu::Framebuffer& picture = state_->resolved;
    return {picture.width(), picture.height(), picture.readColor()};
}

}  // namespace kerf::render
