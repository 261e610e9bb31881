#include "render/passes/surface_pass.h"

#include <glad/gl.h>

#include <bit>
#include <cstring>

#include "gpu/context.h"
#include "render/scene/environment.h"
#include "shaders/shared/render_bindings.h"

namespace kerf::render {

namespace {

// Of the extension that all desktop drivers have; glad generates the core alone.
constexpr GLenum kMaxAnisotropy = 0x84FE;
constexpr GLenum kLargestMaxAnisotropy = 0x84FF;
constexpr float kWantedAnisotropy = 8;

bool hasExtension(const char* name) {
    GLint count = 0;
    glGetIntegerv(GL_NUM_EXTENSIONS, &count);
    for (GLint i = 0; i < count; ++i) {
        const auto* extension =
            reinterpret_cast<const char*>(glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(i)));
        if (std::strcmp(extension, name) == 0) {
            return true;
        }
    }
    return false;
}

// Mesa's software driver (25.0) draws black at the corners of texels with it.
float anisotropy() {
    if (gpu::queryDevice().software || (!hasExtension("GL_EXT_texture_filter_anisotropic") &&
                                        !hasExtension("GL_ARB_texture_filter_anisotropic"))) {
        return 1;
    }
    float largest = 1;
    glGetFloatv(kLargestMaxAnisotropy, &largest);
    return std::min(largest, kWantedAnisotropy);
}

Image halved(const Image& image) {
    Image half{std::max(1, image.width / 2), std::max(1, image.height / 2), {}};
    for (int y = 0; y < half.height; ++y) {
        for (int x = 0; x < half.width; ++x) {
            const std::size_t from = 4 * (std::size_t(2 * y) * image.width + 2 * x);
            half.pixels.insert(half.pixels.end(), image.pixels.begin() + std::ptrdiff_t(from),
                               image.pixels.begin() + std::ptrdiff_t(from + 4));
        }
    }
    return half;
}

gpu::TextureName upload(const Image& image, float anisotropy) {
    GLint largest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    if (std::max(image.width, image.height) > largest) {
        return upload(halved(image), anisotropy);
    }
    const int levels = std::bit_width(unsigned(std::max(image.width, image.height)));
    gpu::TextureName texture = gpu::makeTexture(GL_TEXTURE_2D);
    const std::uint32_t id = texture.get();
    glTextureStorage2D(id, levels, GL_SRGB8_ALPHA8, image.width, image.height);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTextureSubImage2D(id, 0, 0, 0, image.width, image.height, GL_RGBA, GL_UNSIGNED_BYTE,
                        image.pixels.data());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glGenerateTextureMipmap(id);
    glTextureParameteri(id, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTextureParameteri(id, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTextureParameteri(id, GL_TEXTURE_WRAP_S, GL_REPEAT);
    glTextureParameteri(id, GL_TEXTURE_WRAP_T, GL_REPEAT);
    if (anisotropy > 1) {
        glTextureParameterf(id, kMaxAnisotropy, anisotropy);
    }
    return texture;
}

void drawTriangles(std::uint32_t first, std::uint32_t count) {
    glDrawArrays(GL_TRIANGLES, GLint(3 * first), GLsizei(3 * count));
}

/// All triangles, divided as they are shown.
void drawBody(const gpu::Program& program, const BodyView& body, const NormalsPass& shape) {
    const auto side = static_cast<std::uint32_t>(shape.sidePieces());
    program.set("sidePieces", shape.sidePieces());
    drawTriangles(0, side * side * body.triangleCount);
}

void setFinish(const gpu::Program& program, const Finish& finish) {
    program.set("roughness", finish.roughness);
    program.set("gloss", finish.gloss);
    program.set("glow", finish.glow);
    const MirrorLevel mirror = mirrorLevel(finish.roughness);
    program.set("mirrorLevel", float(mirror.level));
    program.set("mirrorReach", mirror.reach);
}

}  // namespace

SkinTextures::SkinTextures(std::shared_ptr<const Appearance> appearance)
    : appearance_(std::move(appearance)) {
    const float sharpness = anisotropy();
    for (std::size_t i = 0; appearance_ != nullptr && i < appearance_->images.size(); ++i) {
        const Image& image = appearance_->images[i].pixels;
        ids_.push_back(image.pixels.empty() ? gpu::TextureName() : upload(image, sharpness));
    }
}

void SkinTextures::bind(int image, std::uint32_t unit) const {
    glBindTextureUnit(unit, ids_[image].get());
}

void bindBody(const BodyView& body, const NormalsPass& shape) {
    body.positions->bindStorage(shared::kBindPositions);
    body.restPositions->bindStorage(shared::kBindRestPositions);
    body.triangles->bindStorage(shared::kBindTriangles);
    shape.normals().bindStorage(shared::kBindNormals);
    shape.skinCorners().bindStorage(shared::kBindSkinCorners);
}

void setSection(const gpu::Program& program, const SceneView& scene) {
    const SectionPlane& plane = *scene.section;
    const Vec3f n = plane.normal.cast<float>();
    const auto offset = float(-plane.normal.dot(plane.point));
    program.set("sectionPlane", Eigen::Vector4f(n.x(), n.y(), n.z(), offset));
}

void SurfacePass::setDepth(const DepthField& depth) {
    depth_ = depth.values.empty() ? DepthTexture() : DepthTexture(depth);
}

void SurfacePass::setLook(const gpu::Program& program, const SceneView& scene) const {
    const BodyLook& look = scene.look;
    const Bounds& bounds = scene.restBounds.empty() ? scene.focus : scene.restBounds;
    const Vec3 extent = 0.5 * (bounds.high - bounds.low);
    program.set("skinColor", look.skin);
    program.set("innerColor", look.inner);
    program.set("rindColor", look.rind);
    program.set("rindShare", look.rindShare);
    program.set("mottle", look.mottle);
    program.set("spots", look.spots);
    program.set("restCenter", Vec3f(bounds.center().cast<float>()));
    program.set("restExtent", Vec3f(extent.cwiseMax(1e-9).cast<float>()));
    program.set("hasDepthField", depth_.empty() ? 0.0f : 1.0f);
    program.set("fieldOrigin", depth_.origin());
    program.set("fieldScale", depth_.scale());
}

SurfacePass::Kind SurfacePass::kindOf(const SceneView& scene, const NormalsPass& shape, bool wall) {
    const BodyLook& look = scene.look;
    const bool painted = !wall && scene.paint != nullptr;
    const int skin = painted ? 0 : static_cast<int>(look.skinPattern);
    return {.wall = wall,
            .pattern = wall ? static_cast<int>(look.pattern) : skin,
            .shading = look.shading,
            .rounded = shape.sidePieces() > 1,
            .opened = scene.section.has_value(),
            .painted = painted};
}

gpu::Defines SurfacePass::definesOf(const Kind& kind) const {
    gpu::Defines defines = defines_;
    const auto add = [&](bool wanted, const char* name, const std::string& value) {
        if (wanted) {
            defines.emplace_back(name, value);
        }
    };
    add(kind.wall, "WALLS", "1");
    add(true, kind.wall ? "PATTERN" : "SKIN", std::to_string(kind.pattern));
    add(kind.rounded, "ROUNDED", "1");
    add(kind.shading != Shading::lit, "MATCAP", std::to_string(static_cast<int>(kind.shading)));
    add(kind.opened, "SECTION", "1");
    add(kind.painted, "OWN_COLOURS", "1");
    return defines;
}

const gpu::Program& SurfacePass::programOf(const Kind& kind) {
    auto found = programs_.find(kind);
    if (found == programs_.end()) {
        gpu::Program program =
            gpu::Program::graphics("render/surface.vert", "render/surface.frag", definesOf(kind));
        found = programs_.emplace(kind, std::move(program)).first;
    }
    return found->second;
}

void SurfacePass::linkEvery() {
    constexpr std::array kShadings{Shading::lit, Shading::matcapClay, Shading::matcapSteel,
                                   Shading::normals};
    for (int choice = 0; choice < 8; ++choice) {
        const bool wall = (choice & 1) != 0;
        const std::size_t patterns = wall ? kFleshPatterns : kSkinPatterns;
        for (const Shading shading : kShadings) {
            Kind kind{.wall = wall,
                      .shading = shading,
                      .rounded = (choice & 2) != 0,
                      .opened = (choice & 4) != 0};
            for (std::size_t pattern = 0; pattern < patterns; ++pattern) {
                kind.pattern = static_cast<int>(pattern);
                programOf(kind);
            }
            if (!wall) {
                kind.pattern = 0;
                kind.painted = true;
                programOf(kind);
            }
        }
    }
}

void SurfacePass::draw(const SceneView& scene, const Frame& frame, const NormalsPass& shape) {
    depth_.bind(shared::kUnitDepthField);
    bindBody(scene.body, shape);
    drawSkin(scene, frame, shape);
    const gpu::Program& walls = programOf(kindOf(scene, shape, true));  // before a cut waits for it
    if (scene.hasWalls) {
        prepare(walls, scene, frame);
        setFinish(walls, scene.look.cutFinish);
        drawBody(walls, scene.body, shape);
    }
}

void SurfacePass::upload(const std::shared_ptr<const SkinPaint>& paint) {
    if (paint == paint_) {
        return;
    }
    paintRecords_.assign(paint->records);
    if (!textures_.areOf(paint->appearance)) {
        textures_ = SkinTextures(paint->appearance);
    }
    paint_ = paint;
}

void SurfacePass::drawSkin(const SceneView& scene, const Frame& frame, const NormalsPass& shape) {
    const gpu::Program& skin = programOf(kindOf(scene, shape, false));
    prepare(skin, scene, frame);
    setFinish(skin, scene.look.skinFinish);
    if (scene.paint == nullptr) {
        drawBody(skin, scene.body, shape);
        return;
    }
    upload(scene.paint);
    drawPainted(skin);
}

void SurfacePass::drawPainted(const gpu::Program& skin) {
    paintRecords_.bindStorage(shared::kBindSkin);
    for (const SkinPaint::Range& range : paint_->ranges) {
        skin.set("hasSkinPicture", range.image >= 0 ? 1.0f : 0.0f);
        if (range.image >= 0) {
            textures_.bind(range.image, shared::kUnitSkin);
        }
        drawTriangles(range.first, range.count);
    }
}

void SurfacePass::prepare(const gpu::Program& program, const SceneView& scene,
                          const Frame& frame) const {
    program.use();
    setLight(program, frame);
    setLook(program, scene);
    if (scene.section) {
        setSection(program, scene);
    }
    bindLooks(program, frame);
    program.set("viewProjection", frame.viewProjection);
    program.set("eye", frame.eye);
    program.set("bodySize", frame.bodySize);
    program.set("hasFloor", scene.floor ? 1.0f : 0.0f);
    program.set("floorHeight", float(scene.floor.value_or(0)));
    program.set("wireframe", scene.wireframe ? 1.0f : 0.0f);
    for (std::size_t i = 0; i < frame.mattLight.size(); ++i) {
        program.set("mattLight[" + std::to_string(i) + "]", frame.mattLight[i]);
    }
}

}  // namespace kerf::render
