#include "app/cli/bar_rig.h"

#include <cmath>
#include <vector>

#include "sim/mesh/box_surface.h"
#include "sim/mesh/triangle.h"
#include "sim/run/simulation.h"

namespace kerf::app {

namespace {

constexpr double kStrain = 0.01;
constexpr double kDrag = 20;             // [1/s]: about critical for the slowest stretching mode
constexpr double kFirstBending = 3.516;  // of a bar that is held at one end: (1.875)^2
constexpr int kWindow = 40;              // steps between two looks
constexpr double kSettled = 1e-4;        // relative change of the end's motion in a window
constexpr double kMostSeconds = 16;      // enough for what drag slows most; then it has not settled

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

bool isBent(SpecimenKind kind) {
    return kind == SpecimenKind::bentBar || kind == SpecimenKind::bentSlab;
}

Vec3 sizeOf(SpecimenKind kind) {
    switch (kind) {
        case SpecimenKind::hangingBar:
        case SpecimenKind::bentBar:
            return {0.1, 0.4, 0.1};
        case SpecimenKind::bentSlab:
            return {0.1, 0.4, 0.5};
        case SpecimenKind::compressedBlock:
            return {0.2, 0.2, 0.2};
    }
    return Vec3::Zero();
}

/// Squares across its x, as large along the other axes.
Specimen makeSpecimen(const BenchSetting& setting) {
    const Vec3 size = sizeOf(setting.kind);
    const auto cells = [&](double length) {
        return static_cast<int>(std::lround(setting.cells * length / size.x()));
    };
    const TriangleSoup soup = boxSurface(size, {setting.cells, cells(size.y()), cells(size.z())});
    Specimen specimen{size, SurfaceMesh::fromTriangles(soup.positions, soup.triangles), {}, {}};
    specimen.bottom = verticesAt(specimen.mesh, -size.y() / 2);
    specimen.top = verticesAt(specimen.mesh, size.y() / 2);
    return specimen;
}

/// How far a force at a distance from the support moves the end, times E, per newton [1/m].
double compliance(const Vec3& size, SpecimenKind kind, double distance) {
    const double length = size.y();
    if (isBent(kind)) {
        const double secondMoment = size.z() * std::pow(size.x(), 3) / 12;
        return distance * distance * (3 * length - distance) / (6 * secondMoment);
    }
    return distance / (size.x() * size.z());
}

/// How far the end of a specimen moves, times E, per unit of gravity [Pa s^2]. Weight lies on the
/// skin, spread by area.
double loadPerGravity(const Specimen& specimen, SpecimenKind kind, double density) {
    const Vec3& size = specimen.size;
    const double support = (kind == SpecimenKind::compressedBlock ? -0.5 : 0.5) * size.y();
    const SurfaceMesh& mesh = specimen.mesh;
    double area = 0;
    double motion = 0;
    for (int t = 0; t < mesh.triangleSlots(); ++t) {
        const Corners at = cornersOf(mesh, t);
        const Vec3 middle = (at[0] + at[1] + at[2]) / 3;
        const double share = triangleArea(at);
        area += share;
        motion += share * compliance(size, kind, std::abs(middle.y() - support));
    }
    return density * size.prod() * motion / area;
}

/// About critical for the slowest mode, so that it settles soon [1/s].
double dragFor(const BenchSetting& setting, const Specimen& specimen, double density) {
    if (!isBent(setting.kind)) {
        return kDrag;
    }
    const double gyration = specimen.size.x() / std::sqrt(12.0);
    const double length = specimen.size.y();
    return 2 * kFirstBending * gyration / (length * length) * std::sqrt(setting.modulus / density);
}

Params benchParams(const BenchSetting& setting, const Specimen& specimen) {
    Params params;
    params.iterations = setting.iterations;
    params.youngsModulus = setting.modulus;
    params.ispcStiffness = setting.ispcStiffness;
    params.airDrag = dragFor(setting, specimen, params.density);
    params.friction = 0;
    params.floor.reset();
    if (setting.kind == SpecimenKind::compressedBlock) {
        params.floor = -specimen.size.y() / 2;
    }
    const double load = loadPerGravity(specimen, setting.kind, params.density);
    const double gravity = kStrain * setting.modulus * specimen.size.y() / load;
    params.gravity = gravity * (isBent(setting.kind) ? Vec3(Vec3::UnitX()) : Vec3(-Vec3::UnitY()));
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

Vec3 meanPosition(const SurfaceMesh& mesh, const std::vector<int>& vertices) {
    Vec3 sum = Vec3::Zero();
    for (const int v : vertices) {
        sum += mesh.position(v);
    }
    return sum / static_cast<double>(vertices.size());
}

/// How far the ends have moved against each other since rest: along the bar, or aside [m].
double motionOfEnd(Simulation& simulation, const Specimen& specimen, SpecimenKind kind) {
    const SurfaceMesh& mesh = simulation.mesh();
    const Vec3 axis = meanPosition(mesh, specimen.bottom) - meanPosition(mesh, specimen.top);
    return std::abs(isBent(kind) ? axis.x() : axis.y() + specimen.size.y());
}

/// Steps until the end stands still. False where it does not in kMostSeconds.
bool settle(Simulation& simulation, const Specimen& specimen, SpecimenKind kind) {
    double before = motionOfEnd(simulation, specimen, kind);
    while (simulation.report().time < kMostSeconds) {
        for (int i = 0; i < kWindow; ++i) {
            simulation.step();
        }
        const double now = motionOfEnd(simulation, specimen, kind);
        if (std::abs(now - before) <= kSettled * now) {
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
    if (setting.kind != SpecimenKind::compressedBlock) {
        pinTop(simulation, specimen);
    }
    BenchResult result;
    result.settled = settle(simulation, specimen, setting.kind);
    const double change = motionOfEnd(simulation, specimen, setting.kind);
    const double load = loadPerGravity(specimen, setting.kind, params.density);
    result.triangles = specimen.mesh.aliveTriangles();
    result.strain = change / specimen.size.y();
    result.effectiveModulus = load * params.gravity.norm() / change;
    result.volumeRatio = simulation.report().volumeRatio;
    return result;
}

}  // namespace kerf::app
