#include "tests/support/drop_scene.h"

#include "sim/mesh/invariants.h"
#include "sim/run/simulation.h"
#include "tests/support/folds.h"
#include "tests/support/formatted.h"
#include "tests/support/shape_error.h"
#include "tests/support/shapes.h"

namespace kerf::test {

namespace {

constexpr int kCutSteps = 60;
constexpr int kErrorEvery = 4;  // steps between two looks at the shape
constexpr double kChip = 1e-4;  // of the body's volume

/// Largest RMS shape errors of the pieces that are no chips.
struct ShapeErrors {
    double largest = 0;         ///< [m]
    double largestOfPiece = 0;  ///< share of the diagonal of the piece at rest
};

ShapeErrors shapeErrors(Simulation& simulation, double bodyVolume) {
    const SurfaceMesh& mesh = simulation.mesh();
    const PieceMap& pieces = simulation.pieces();
    std::vector<std::vector<int>> vertices(pieces.pieces.size());
    std::vector<Bounds> bounds(pieces.pieces.size());
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        if (const int piece = pieces.ofVertex[v]; piece >= 0) {
            vertices[piece].push_back(v);
            bounds[piece].add(mesh.restPosition(v));
        }
    }
    ShapeErrors errors;
    for (std::size_t p = 0; p < vertices.size(); ++p) {
        if (pieces.pieces[p].restVolume >= kChip * bodyVolume) {
            const double error =
                test::rmsShapeError(mesh.restPositions(), mesh.positions(), vertices[p]);
            errors.largest = std::max(errors.largest, error);
            errors.largestOfPiece = std::max(errors.largestOfPiece, error / bounds[p].diagonal());
        }
    }
    return errors;
}

/// Through the middle of the box, along z turned by `azimuth`, a little askew.
void cutInHalf(Simulation& simulation, const Bounds& bounds, double azimuth) {
    const Vec3 size = bounds.high - bounds.low;
    const Eigen::AngleAxisd turn(azimuth, Vec3::UnitY());
    const Vec3 middle = bounds.center() + turn * Vec3(0.02 * size.x(), 0, 0);
    const Vec3 reach =
        turn * Vec3(0.02 * size.x(), 0.03 * size.y(), 0.7 * std::max(size.x(), size.z()));
    for (int step = 0; step <= kCutSteps; ++step) {
        const double height = 0.65 - 1.3 * step / kCutSteps;
        const Vec3 at = middle + Vec3(0, height * size.y(), 0);
        simulation.execute(MoveBlade{{at - reach, at + reach}});
        simulation.step();
    }
    simulation.execute(LiftBlade{});
    simulation.step();
}

}  // namespace

DropFigures playDrop(SurfaceMesh mesh, const DropScene& scene) {
    const Bounds bounds = meshBounds(mesh);
    const double bodyVolume = meshRestVolume(mesh);
    Params params = scene.params;
    params.gravity = Vec3::Zero();
    params.floor = bounds.low.y() - scene.height;
    Simulation simulation(std::move(mesh), params);
    if (scene.cut) {
        cutInHalf(simulation, bounds, scene.azimuth);
    }
    simulation.execute(SetParam{"gravity", scene.params.gravity});
    DropFigures figures;
    const int steps = static_cast<int>(std::lround(scene.seconds / params.timeStep));
    for (int step = 1; step <= steps; ++step) {
        const StepReport& report = simulation.step();
        figures.meanVolume += report.volumeRatio / steps;
        figures.leastVolume = std::min(figures.leastVolume, report.volumeRatio);
        if (step % kErrorEvery == 0 || step == steps) {
            const ShapeErrors errors = shapeErrors(simulation, bodyVolume);
            figures.finalError = errors.largest / bounds.diagonal();
            figures.finalErrorOfPiece = errors.largestOfPiece;
            figures.peakErrorOfPiece = std::max(figures.peakErrorOfPiece, errors.largestOfPiece);
            figures.peakError = std::max(figures.peakError, figures.finalError);
        }
    }
    figures.pieces = simulation.report().pieces;
    figures.triangles = simulation.report().triangles;
    figures.finalVolume = simulation.report().volumeRatio;
    figures.folds = foldedEdges(simulation.mesh());
    figures.finalSpeed = topSpeed(simulation.mesh());
    figures.messages = static_cast<int>(simulation.takeMessages().size());
    return figures;
}

std::string dropTableHead() {
    return "drop                       pieces triangles  volume % mean     min   final  "
           "RMS % peak  final  of piece peak  final  folds  m/s at end  messages\n";
}

std::string dropTableRow(const std::string& name, const DropFigures& f) {
    return formatted("%-26s %6d %9d  %13.3f %7.3f %7.3f %11.2f %6.2f %14.2f %6.2f %6d %11.3f %9d\n",
                     name.c_str(), f.pieces, f.triangles, 100 * f.meanVolume, 100 * f.leastVolume,
                     100 * f.finalVolume, 100 * f.peakError, 100 * f.finalError,
                     100 * f.peakErrorOfPiece, 100 * f.finalErrorOfPiece, f.folds, f.finalSpeed,
                     f.messages);
}

}  // namespace kerf::test
