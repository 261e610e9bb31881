#include "tests/support/cut_ball.h"

#include "sim/body/body_updater.h"
#include "sim/cut/stroke/cutter.h"
#include "tests/support/shapes.h"

namespace kerf::test {

SurfaceMesh cutBall(double height, int n) {
    constexpr double kRadius = 0.1;
    constexpr double kFrom = 0.12;
    constexpr int kSteps = 16;
    SurfaceMesh mesh = cubeSphere(n, kRadius);
    if (height > kRadius) {
        return mesh;
    }
    Cutter cutter(mesh, CutSettings{});
    for (int i = 0; i <= kSteps; ++i) {
        const double y = kFrom + (height - kFrom) * i / kSteps;
        const Blade blade{{-0.2, y, 0.003}, {0.2, y, 0.003}};
        if (i == 0) {
            cutter.begin(blade);
        } else {
            cutter.advance(blade);
        }
    }
    cutter.finish();
    return mesh;
}

BodyModel cutBallModel(double height) {
    const SurfaceMesh mesh = cutBall(height);
    BodyUpdater updater(mesh);
    updater.castIspcs(IspcRays::turned);
    return updater.model();
}

std::vector<std::uint32_t> verticesBelow(const BodyModel& model, double height) {
    std::vector<std::uint32_t> vertices;
    for (std::uint32_t v = 0; v < model.restPositions.size(); ++v) {
        if (model.restPositions[v].y() < height) {
            vertices.push_back(v);
        }
    }
    return vertices;
}

}  // namespace kerf::test
