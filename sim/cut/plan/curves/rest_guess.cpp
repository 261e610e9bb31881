#include "sim/cut/plan/curves/rest_guess.h"

#include <Eigen/Dense>
#include <vector>

namespace kerf::cut {

namespace {

constexpr double kShiftRidge = 1e-6;  // of the trace, towards a shift

struct KnownOffset {
    Vec3 position;
    Vec3 offset;  ///< rest - position
};

std::vector<KnownOffset> knownOffsets(const StepInput& in, const Strip& strip,
                                      const CutCurves& curves) {
    std::vector<KnownOffset> places;
    for (const CutNode& node : curves.nodes) {
        if (node.kind != NodeKind::wall) {
            places.push_back({node.position, node.rest - node.position});
        }
    }
    for (const StripNode& node : strip.nodes) {
        for (const int v : node.vertices) {
            const Vec3& position = in.mesh.position(v);
            places.push_back({position, in.mesh.restPosition(v) - position});
        }
    }
    return places;
}

}  // namespace

RestGuess::RestGuess(const StepInput& in, const Strip& strip, const CutCurves& curves) {
    if (in.atRest || in.edgeLengths.isEven()) {
        return;
    }
    const std::vector<KnownOffset> places = knownOffsets(in, strip, curves);
    if (places.empty()) {
        return;
    }
    for (const KnownOffset& place : places) {
        center_ += place.position / sizeOf(places);
        offset_ += place.offset / sizeOf(places);
    }
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    Eigen::Matrix3d offsets = Eigen::Matrix3d::Zero();
    for (const KnownOffset& place : places) {
        const Vec3 q = place.position - center_;
        spread += q * q.transpose();
        offsets += (place.offset - offset_) * q.transpose();
    }
    spread.diagonal().array() += kShiftRidge * spread.trace() + 1e-300;
    change_ = offsets * spread.inverse();
}

}  // namespace kerf::cut
