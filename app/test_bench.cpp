#include "app/test_bench.h"

#include <cmath>
#include <vector>

#include "sim/mesh/box_surface.h"
#include "sim/simulation.h"

namespace kerf::app {

namespace {

constexpr double kStrain = 0.01;
constexpr double kDrag = 20;       // [1/s]: about critical for the slowest mode, so it settles soon
constexpr int kWindow = 40;        // steps between two looks
constexpr double kSettled = 1e-4;  // relative change of length in a window
constexpr double kMostSeconds = 8;  // then it has not settled

/// The unloaded body, its axis along y.
struct Specimen {
    Vec3 size;
    SurfaceMesh mesh;
    std::vector<int> bottom;  ///< vertices of the lower end
    std::vector<int> top;
};

std::vector<int> verticesAt(const SurfaceMesh& mesh, double height) {
    std::vector<int> found;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        if (mesh.restPosition(v).y() == height) {
            found.push_back(v);
        }
    }
    return found;
}

Specimen makeSpecimen(const BenchSetting& setting) {
    const bool bar = setting.kind == SpecimenKind::hangingBar;
    const Vec3 size = bar ? Vec3(0.1, 0.4, 0.1) : Vec3(0.2, 0.2, 0.2);
    const int along = bar ? 4 * setting.cells : setting.cells;
    const TriangleSoup soup = boxSurface(size, {setting.cells, along, setting.cells});
    Specimen specimen{size, SurfaceMesh::fromTriangles(soup.positions, soup.triangles), {}, {}};
    specimen.bottom = verticesAt(specimen.mesh, -size.y() / 2);
    specimen.top = verticesAt(specimen.mesh, size.y() / 2);
    return specimen;
}

/// Mean distance of the weight from the support [m]. Weight lies on the skin, spread by area.
double meanWeightDistance(const Specimen& specimen, SpecimenKind kind) {
    const double support = (kind == SpecimenKind::hangingBar ? 0.5 : -0.5) * specimen.size.y();
    const SurfaceMesh& mesh = specimen.mesh;
    double area = 0;
    double moment = 0;
    for (int t = 0; t < mesh.triangleSlots(); ++t) {
        const auto [a, b, c] = mesh.triangle(t);
        const Vec3 middle = (mesh.position(a) + mesh.position(b) + mesh.position(c)) / 3;
        const double share =
            0.5 *
            (mesh.position(b) - mesh.position(a)).cross(mesh.position(c) - mesh.position(a)).norm();
        area += share;
        moment += share * std::abs(middle.y() - support);
    }
    return moment / area;
}

/// How much longer or shorter a specimen of modulus E gets, times E, per unit of gravity [Pa s^2].
double loadPerGravity(const Specimen& specimen, SpecimenKind kind, double density) {
    return density * specimen.size.y() * meanWeightDistance(specimen, kind);
}

Params benchParams(const BenchSetting& setting, const Specimen& specimen) {
    Params params;
    params.iterations = setting.iterations;
    params.youngsModulus = setting.modulus;
    params.ispcStiffness = setting.ispcStiffness;
    params.airDrag = kDrag;
    params.friction = 0;
    params.floor.reset();
    if (setting.kind == SpecimenKind::compressedBlock) {
        params.floor = -specimen.size.y() / 2;
    }
    const double load = loadPerGravity(specimen, setting.kind, params.density);
    params.gravity = Vec3(0, -kStrain * setting.modulus * specimen.size.y() / load, 0);
    return params;
}

void pinTop(Simulation& simulation, const Specimen& specimen) {
    Bounds region;
    for (const int v : specimen.top) {
        region.add(specimen.mesh.position(v));
    }
    region.widen(1e-3 * specimen.size.y());
    simulation.execute(Pin{region});
}

double meanHeight(const SurfaceMesh& mesh, const std::vector<int>& vertices) {
    double sum = 0;
    for (const int v : vertices) {
        sum += mesh.position(v).y();
    }
    return sum / static_cast<double>(vertices.size());
}

double length(Simulation& simulation, const Specimen& specimen) {
    const SurfaceMesh& mesh = simulation.mesh();
    return meanHeight(mesh, specimen.top) - meanHeight(mesh, specimen.bottom);
}

/// Steps until the length stands still. False where it does not in kMostSeconds.
bool settle(Simulation& simulation, const Specimen& specimen) {
    double before = length(simulation, specimen);
    while (simulation.report().time < kMostSeconds) {
        for (int i = 0; i < kWindow; ++i) {
            simulation.step();
        }
        const double now = length(simulation, specimen);
        if (std::abs(now - before) <= kSettled * std::abs(now - specimen.size.y())) {
            return true;
        }
        before = now;
    }
    return false;
}

}  // namespace

BenchResult measureModulus(const BenchSetting& setting) {
    const Specimen specimen = makeSpecimen(setting);
    const Params params = benchParams(setting, specimen);
    Simulation simulation(specimen.mesh, params);
    if (setting.kind == SpecimenKind::hangingBar) {
        pinTop(simulation, specimen);
    }
    BenchResult result;
    result.settled = settle(simulation, specimen);
    const double change = std::abs(length(simulation, specimen) - specimen.size.y());
    const double load = loadPerGravity(specimen, setting.kind, params.density);
    result.triangles = specimen.mesh.aliveTriangles();
    result.strain = change / specimen.size.y();
    result.effectiveModulus = load * -params.gravity.y() / change;
    result.volumeRatio = simulation.report().volumeRatio;
    return result;
}

}  // namespace kerf::app
