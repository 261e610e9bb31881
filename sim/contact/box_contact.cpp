#include "sim/contact/box_contact.h"

#include <utility>

namespace kerf {

namespace {

constexpr double kDepth = 0.5;  // h

std::vector<shared::BoxRecord> boxesNear(const std::vector<StaticBox>& boxes,
                                         const Bounds& bounds) {
    std::vector<shared::BoxRecord> records;
    for (const StaticBox& box : boxes) {
        if (box.bounds().overlaps(bounds)) {
            records.push_back(boxRecord(box.center, box.axes(), 0.5 * box.size));
        }
    }
    return records;
}

}  // namespace

void BoxContact::setBoxes(std::vector<StaticBox> boxes) {
    boxes_ = std::move(boxes);
    if (!boxes_.empty() && !kernels_) {
        kernels_.emplace(
            Kernels{BoxTouches(gpu::Defines{}), gpu::Program::compute("sim/boxes/vertices.comp")});
    }
}

void BoxContact::setBody(const ContactBody& body, double edgeLength) {
    body_ = body;
    edgeLength_ = edgeLength;
}

void BoxContact::beginStep(const BodyReach& reach) {
    const std::vector<shared::BoxRecord> near = boxesNear(boxes_, boundsInStep(reach, settings_));
    reached_ = !near.empty();
    if (!reached_) {
        return;
    }
    boxBuffer_.assign(near);
    kernels_->touches.resize(body_);
    shared::BoxUniforms uniforms = boxUniforms(settings_, body_, near.size());
    uniforms.thickness = static_cast<float>(settings_.thickness * edgeLength_);
    uniforms.depth = static_cast<float>(kDepth * edgeLength_) + uniforms.thickness;
    kernels_->touches.setUniforms(uniforms);
}

void BoxContact::respond() {
    if (reached_) {
        kernels_->touches.bind(body_, boxBuffer_);
        kernels_->touches.solve(body_);
        runOver(kernels_->vertices, body_.vertexCount);
    }
}

}  // namespace kerf
