#include "render/passes/field_pass.h"

#include <glad/gl.h>

#include "render/passes/surface_pass.h"
#include "shaders/shared/render_bindings.h"

namespace kerf::render {
namespace {

void setColors(const gpu::Program& program, const ColorMap& map) {
    for (std::size_t i = 0; i < map.size(); ++i) {
        const DisplayColor& c = map[i];
        program.set("colorStops[" + std::to_string(i) + "]",
                    Eigen::Vector3f(Eigen::Vector3f(c[0], c[1], c[2]) / 255));
    }
}

bool isValue(float value) {
    return value > 0.5F * shared::kNoField;
}

}  // namespace

FieldPass::FieldPass()
    : strain_(gpu::Program::compute("render/field_strain.comp")),
      area_(gpu::Program::compute("render/field_strain.comp", {{"AREA", "1"}})),
      whole_(kindsFor({{"FIELD", "1"}})) {}

FieldPass::Kinds FieldPass::kindsFor(const gpu::Defines& defines) {
    gpu::Defines walls = defines;
    walls.emplace_back("WALLS", "1");
    return {gpu::Program::graphics("render/surface.vert", "render/field.frag", defines),
            gpu::Program::graphics("render/surface.vert", "render/field.frag", walls)};
}

void FieldPass::update(const SceneView& scene) {
    const FieldView& field = scene.field;
    const Source wanted{scene.bodyRevision, field.choice, field.values.get(),
                        scene.body.vertexCount};
    if (wanted.revision && shown_ == wanted) {
        return;
    }
    shown_ = wanted;
    values_.resize(std::size_t(4) * scene.body.vertexCount * sizeof(float));
    measure(scene);
    if (field.choice.field == SurfaceField::thickness) {
        take(field.values != nullptr ? *field.values : FieldValues{});
    }
    range_ = field.choice.range ? *field.choice.range
                                : automaticRange(samples(), infoOf(field.choice.field));
}

void FieldPass::measure(const SceneView& scene) {
    const BodyView& body = scene.body;
    body.positions->bindStorage(shared::kBindPositions);
    body.restPositions->bindStorage(shared::kBindRestPositions);
    body.triangles->bindStorage(shared::kBindTriangles);
    body.incidenceRanges->bindStorage(shared::kBindIncidenceRanges);
    body.incidence->bindStorage(shared::kBindIncidence);
    values_.bindStorage(shared::kBindField);
    const bool area = scene.field.choice.field == SurfaceField::area;
    const gpu::Program& program = area ? area_ : strain_;
    program.use();
    program.set("vertexCount", body.vertexCount);
    program.dispatch(body.vertexCount);
}

/// In place of the strains. There may be fewer than the body has vertices.
void FieldPass::take(const FieldValues& values) {
    FieldValues all(values_.size() / sizeof(float) / 2, shared::kNoField);
    for (std::size_t i = 0; i < std::min(all.size(), values.size()); ++i) {
        all[i] = values[i] >= 0 ? values[i] : shared::kNoField;
    }
    values_.write<float>(0, all);
}

/// Read back; of large bodies every so many.
std::vector<FieldSample> FieldPass::samples() const {
    constexpr std::size_t kMost = 1 << 16;
    const std::size_t count = values_.size() / sizeof(float) / 2;
    const std::vector<float> all = values_.read<float>(0, 2 * count);
    std::vector<FieldSample> samples;
    for (std::size_t i = 0; i < count; i += 1 + count / kMost) {
        if (isValue(all[i])) {
            samples.push_back({all[i], all[count + i]});
        }
    }
    return samples;
}

std::optional<float> FieldPass::valueAt(std::uint32_t vertex, bool onWall) const {
    const std::size_t place = std::size_t(2) * vertex + (onWall ? 1 : 0);
    if (2 * (place + 1) * sizeof(float) > values_.size()) {
        return std::nullopt;
    }
    const float value = values_.read<float>(place, 1).front();
    return isValue(value) ? std::optional(value) : std::nullopt;
}

const FieldPass::Kinds& FieldPass::openedOnes() {
    if (!opened_) {
        opened_ = kindsFor({{"FIELD", "1"}, {"SECTION", "1"}});
    }
    return *opened_;
}

void FieldPass::draw(const SceneView& scene, const Frame& frame, const NormalsPass& shape) {
    const Kinds& kinds = scene.section ? openedOnes() : whole_;
    bindBody(scene.body, shape);
    values_.bindStorage(shared::kBindField);
    drawKind(kinds[0], scene, frame);
    if (scene.hasWalls) {
        drawKind(kinds[1], scene, frame);
    }
}

void FieldPass::drawKind(const gpu::Program& program, const SceneView& scene,
                         const Frame& frame) const {
    program.use();
    bindLooks(program, frame);
    setColors(program, colorsOf(scene.field.choice).colors);
    program.set("fieldRange", Eigen::Vector2f(range_.low, range_.high));
    if (scene.section) {
        setSection(program, scene);
    }
    program.set("viewProjection", frame.viewProjection);
    program.set("eye", frame.eye);
    program.set("wireframe", scene.wireframe ? 1.0F : 0.0F);
    glDrawArrays(GL_TRIANGLES, 0, GLsizei(3 * scene.body.triangleCount));
}

}  // namespace kerf::render
