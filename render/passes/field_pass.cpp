#include "render/passes/field_pass.h"

#include <glad/gl.h>

#include <algorithm>
#include <cmath>
#include <string>

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

}  // namespace

FieldPass::FieldPass()
    : strain_(gpu::Program::compute("render/field_strain.comp")),
      area_(gpu::Program::compute("render/field_strain.comp", {{"AREA", "1"}})),
      range_(gpu::Program::compute("render/field_range.comp")),
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
    values_.resize(std::size_t(2) * scene.body.vertexCount * sizeof(float));
    ends_.assign(std::vector<std::uint32_t>(3, 0));
    if (field.choice.field == SurfaceField::thickness) {
        take(field.values != nullptr ? *field.values : FieldValues{});
    } else {
        measure(scene);
    }
    settleRange(field.choice);
}

void FieldPass::measure(const SceneView& scene) {
    const BodyView& body = scene.body;
    body.positions->bindStorage(shared::kBindPositions);
    body.restPositions->bindStorage(shared::kBindRestPositions);
    body.triangles->bindStorage(shared::kBindTriangles);
    body.incidenceRanges->bindStorage(shared::kBindIncidenceRanges);
    body.incidence->bindStorage(shared::kBindIncidence);
    values_.bindStorage(shared::kBindField);
    ends_.bindStorage(shared::kBindFieldRange);
    const bool area = scene.field.choice.field == SurfaceField::area;
    const gpu::Program& program = area ? area_ : strain_;
    program.use();
    program.set("vertexCount", body.vertexCount);
    program.dispatch(body.vertexCount);
}

/// There may be fewer than the body has vertices.
void FieldPass::take(const FieldValues& values) {
    FieldValues all(values_.size() / sizeof(float), shared::kNoField);
    float largest = 0;
    for (std::size_t i = 0; i < std::min(all.size(), values.size()); ++i) {
        if (values[i] >= 0) {
            all[i] = values[i];
            largest = std::max(largest, values[i]);
        }
    }
    values_.assign(all);
    ends_.assign(std::vector<float>{largest, 0, 0});
}

void FieldPass::settleRange(const FieldChoice& choice) {
    const FieldInfo& info = infoOf(choice.field);
    values_.bindStorage(shared::kBindField);
    ends_.bindStorage(shared::kBindFieldRange);
    range_.use();
    range_.set("fixedHigh", choice.high.value_or(0));
    range_.set("leastHigh", std::max(info.least, 1e-9F));
    range_.set("hasSign", info.hasSign ? 1.0F : 0.0F);
    range_.dispatch(1);
}

FieldRange FieldPass::range() const {
    const std::vector<float> ends = ends_.read<float>(1, 2);
    return {ends[0], ends[1]};
}

std::optional<float> FieldPass::valueAt(std::uint32_t vertex, bool onWall) const {
    const std::size_t place = std::size_t(2) * vertex + (onWall ? 1 : 0);
    if ((place + 1) * sizeof(float) > values_.size()) {
        return std::nullopt;
    }
    const float value = values_.read<float>(place, 1).front();
    return value > 0.5F * shared::kNoField ? std::optional(value) : std::nullopt;
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
    ends_.bindStorage(shared::kBindFieldRange);
    drawKind(kinds[0], scene, frame);
    if (scene.hasWalls) {
        drawKind(kinds[1], scene, frame);
    }
}

void FieldPass::drawKind(const gpu::Program& program, const SceneView& scene,
                         const Frame& frame) const {
    program.use();
    bindLooks(program, frame);
    setColors(program, *infoOf(scene.field.choice.field).map);
    if (scene.section) {
        setSection(program, scene);
    }
    program.set("viewProjection", frame.viewProjection);
    program.set("eye", frame.eye);
    program.set("wireframe", scene.wireframe ? 1.0F : 0.0F);
    glDrawArrays(GL_TRIANGLES, 0, GLsizei(3 * scene.body.triangleCount));
}

}  // namespace kerf::render
