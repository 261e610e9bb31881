#include "render/renderer.h"

#include <glad/gl.h>

#include <algorithm>

#include "gpu/context.h"
#include "gpu/program.h"
#include "render/passes/blade_pass.h"
#include "render/passes/box_pass.h"
#include "render/passes/depth_passes.h"
#include "render/passes/floor_pass.h"
#include "render/passes/frame.h"
#include "render/passes/normals_pass.h"
#include "render/passes/smooth_pass.h"
#include "render/passes/surface_pass.h"
#include "shaders/shared/shared_types.h"

namespace kerf::render {
namespace {

constexpr int kSamples = 4;

gpu::Defines definesFor(Quality quality) {
    return quality == Quality::full ? gpu::Defines{{"SOFT_SHADOWS", "1"}} : gpu::Defines{};
}

int shadowSize(Quality quality) {
    return quality == Quality::full ? 2048 : 1024;
}

int floorShadeSize(Quality quality) {
    return quality == Quality::full ? 384 : 192;
}

/// The state that every picture starts from, whatever the interface left behind.
void resetState() {
    glDisable(GL_CULL_FACE);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_STENCIL_TEST);
    glDisable(GL_FRAMEBUFFER_SRGB);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    for (GLuint unit = 0; unit < 3; ++unit) {
        glBindSampler(unit, 0);
    }
}

}  // namespace

struct Renderer::State {
    explicit State(Quality quality)
        : samples(quality == Quality::full ? std::min(kSamples, gpu::queryDevice().maxSamples) : 1),
          shadow(shadowSize(quality)),
          floorShade(floorShadeSize(quality)),
          surface(definesFor(quality)),
          boxes(definesFor(quality)) {
        // Core profile draws nothing without a vertex array, even where no attribute is read.
        glCreateVertexArrays(1, &vertexArray);
    }
    ~State() { glDeleteVertexArrays(1, &vertexArray); }
    State(const State&) = delete;
    State& operator=(const State&) = delete;

    void makeTargets(int width, int height);
    void uploadLooks(const SceneView& scene, Frame& frame);
    void drawShadows(const SceneView& scene, const Frame& frame);
    void drawColors(const SceneView& scene, const Camera& camera, const Frame& frame);

    int samples;
    std::uint32_t vertexArray = 0;
    gpu::Buffer looks;
    gpu::Framebuffer drawn;
    gpu::Framebuffer resolved;
    NormalsPass normals;
    ShadowPass shadow;
    FloorShadePass floorShade;
    SurfacePass surface;
    BoxPass boxes;
    FloorPass floor;
    BladePass blade;
    SmoothPass smoothing;
};

void Renderer::State::makeTargets(int width, int height) {
    if (resolved.width() == width && resolved.height() == height) {
        return;
    }
    resolved = gpu::Framebuffer(GL_RGBA8, GL_DEPTH_COMPONENT32F, width, height);
    drawn = gpu::Framebuffer(GL_RGBA8, GL_DEPTH_COMPONENT32F, width, height, samples);
}

void Renderer::State::uploadLooks(const SceneView& scene, Frame& frame) {
    std::vector<shared::vec4> words(std::max<std::size_t>(1, scene.pieces.size()));
    for (std::size_t p = 0; p < scene.pieces.size(); ++p) {
        const PieceLook& look = scene.pieces[p];
        words[p] = {look.tint.x(), look.tint.y(), look.tint.z(),
                    look.hidden ? -1.0f : look.strength};
    }
    looks.assign(words);
    frame.looks = &looks;
    frame.lookCount = static_cast<std::uint32_t>(scene.pieces.size());
}

void Renderer::State::drawShadows(const SceneView& scene, const Frame& frame) {
    normals.run(scene.body);
    shadow.draw(scene, boxes.view(), frame);
    if (scene.floor) {
        floorShade.draw(scene, boxes.view(), frame);
    }
}

void Renderer::State::drawColors(const SceneView& scene, const Camera& camera, const Frame& frame) {
    drawn.bind();
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    glClear(GL_DEPTH_BUFFER_BIT);
    shadow.bind();
    floorShade.bind();
    if (frame.hasBody) {
        surface.draw(scene, frame, normals.normals());
    }
    boxes.draw(frame);
    blade.drawBlade(scene, frame);
    floor.drawBackdrop(scene.floor.has_value(), frame);
    if (scene.floor) {
        floor.drawFloor(*scene.floor, frame, camera);
    }
    blade.drawSweep(scene, frame);
    blade.drawEdges(scene, frame);
    if (samples > 1) {
        drawn.blitColorTo(resolved);
    } else {
        smoothing.draw(scene, frame, drawn, resolved);
    }
}

Renderer::Renderer(Quality quality) : state_(std::make_unique<State>(quality)) {}

Renderer::~Renderer() = default;

void Renderer::setRestShape(const SurfaceMesh& uncut) {
    setRestDepth(measureSkinDepth(uncut));
}

void Renderer::setRestDepth(const DepthField& depth) {
    state_->surface.setDepth(depth);
}

void Renderer::draw(const SceneView& scene, const Camera& camera, int width, int height) {
    width = std::max(width, 1);
    height = std::max(height, 1);
    state_->makeTargets(width, height);
    Frame frame = frameOf(scene, camera, width, height, state_->shadow.size());
    state_->uploadLooks(scene, frame);
    glBindVertexArray(state_->vertexArray);
    resetState();
    state_->boxes.update(scene);
    if (frame.hasBody) {
        gpu::storageBarrier();
        state_->drawShadows(scene, frame);
    }
    state_->drawColors(scene, camera, frame);
    glBindVertexArray(0);
    state_->resolved.bind();
}

const gpu::Framebuffer& Renderer::target() const {
    return state_->resolved;
}

Image Renderer::readPicture() const {
    const gpu::Framebuffer& picture = state_->resolved;
    return {picture.width(), picture.height(), picture.readColor()};
}

}  // namespace kerf::render
