#include "bench/lab/bar_rig.h"

#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "sim/mesh/box_surface.h"
#include "sim/mesh/invariants.h"
#include "sim/mesh/triangle.h"
#include "sim/run/simulation.h"
#include "sim/solve/sweep_strength.h"

namespace kerf::app {

namespace {

constexpr double kStrain = 0.01;
constexpr double kDrag = 20;             // [1/s]: about critical for the slowest stretching mode
constexpr double kFirstBending = 3.516;  // of a bar that is held at one end: (1.875)^2
constexpr double kPressed = 0.02;        // of a sphere's diameter
constexpr double kWindow = 0.2;          // between two looks [s]
constexpr double kSettled = 1e-4;        // relative change of the end's motion in a window
constexpr double kMostSeconds = 16;      // enough for what drag slows most; then it has not settled

/// What a solid does by formula.
enum class Theory { stretched, bent, sheared, pressed };

/// What holds a specimen.
enum class Support { top, bottom, floor };

/// How a specimen is loaded and what a solid does then.
struct Loading {
    Vec3 size;  ///< [m]
    Support support;
    Theory theory;
    /// How stiff an incompressible solid is against the formula: clamps, the width of a slab and
    /// free rims are not in it (docs/notes/effective-modulus.md).
    double solid;
};

Loading loadingOf(SpecimenKind kind) {
    switch (kind) {
        case SpecimenKind::hangingBar:
            return {{0.1, 0.4, 0.1}, Support::top, Theory::stretched, 1.04};
        case SpecimenKind::bentBar:
            return {{0.1, 0.4, 0.1}, Support::top, Theory::bent, 1.00};
        case SpecimenKind::bentSlab:
            return {{0.1, 0.4, 0.5}, Support::top, Theory::bent, 1.16};
        case SpecimenKind::compressedBlock:
            return {{0.2, 0.2, 0.2}, Support::floor, Theory::stretched, 0.96};
        case SpecimenKind::shearedBlock:
            return {{0.4, 0.1, 0.4}, Support::bottom, Theory::sheared, 0.83};
        case SpecimenKind::hangingCube:
            return {{0.2, 0.2, 0.2}, Support::top, Theory::stretched, 1.09};
        case SpecimenKind::pressedSphere:
            return {{0.2, 0.2, 0.2}, Support::floor, Theory::pressed, 1.00};
    }
    return {};
}

/// The unloaded body, its axis along y.
struct Specimen {
    Loading loading;
    SurfaceMesh mesh;
    std::vector<int> held;  ///< vertices of the end that is held
    std::vector<int> free;  ///< vertices whose mean way is measured
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

std::vector<int> allVertices(const SurfaceMesh& mesh) {
    std::vector<int> all(mesh.vertexCount());
    std::iota(all.begin(), all.end(), 0);
    return all;
}

bool actsAside(Theory theory) {
    return theory == Theory::bent || theory == Theory::sheared;
}

SurfaceMesh boxOfSquares(const Vec3& size, double square) {
    const auto cells = [&](double length) {
        return static_cast<int>(std::lround(length / square));
    };
    const TriangleSoup soup = boxSurface(size, {cells(size.x()), cells(size.y()), cells(size.z())});
    return SurfaceMesh::fromTriangles(soup.positions, soup.triangles);
}

/// Contact is small: four times as many squares as on a block, on each side of a cube that is blown
/// up to a sphere.
SurfaceMesh sphereOfSquares(double diameter, int cells) {
    constexpr int kFiner = 4;
    TriangleSoup soup = boxSurface(Vec3::Ones(), {kFiner * cells, kFiner * cells, kFiner * cells});
    for (Vec3& p : soup.positions) {
        // As the tangent of even angles, squares are of about one size.
        for (double& x : p) {
            x = std::tan(x * std::numbers::pi / 2);
        }
        p *= 0.5 * diameter / p.norm();
    }
    return SurfaceMesh::fromTriangles(soup.positions, soup.triangles);
}

/// Squares across its shortest side.
Specimen makeSpecimen(const BenchSetting& setting) {
    const Loading loading = loadingOf(setting.kind);
    const Vec3& size = loading.size;
    Specimen specimen{loading,
                      loading.theory == Theory::pressed
                          ? sphereOfSquares(size.y(), setting.cells)
                          : boxOfSquares(size, size.minCoeff() / setting.cells),
                      {},
                      {}};
    const double end = (loading.support == Support::top ? 0.5 : -0.5) * size.y();
    specimen.held = verticesAt(specimen.mesh, end);
    specimen.free = loading.theory == Theory::pressed ? allVertices(specimen.mesh)
                                                      : verticesAt(specimen.mesh, -end);
    return specimen;
}

/// How far a force at a distance from the support moves the end, times E, per newton [1/m].
double compliance(const Loading& loading, double distance) {
    const Vec3& size = loading.size;
    const double section = size.x() * size.z();
    if (loading.theory == Theory::bent) {
        const double secondMoment = size.z() * std::pow(size.x(), 3) / 12;
        return distance * distance * (3 * size.y() - distance) / (6 * secondMoment);
    }
    return (loading.theory == Theory::sheared ? 3 : 1) * distance / section;
}

/// How far the end of a specimen moves, times E, per unit of gravity [Pa s^2]. Weight lies on the
/// skin, spread by area.
double loadPerGravity(const Specimen& specimen, double density) {
    const Loading& loading = specimen.loading;
    const double support = (loading.support == Support::top ? 0.5 : -0.5) * loading.size.y();
    const SurfaceMesh& mesh = specimen.mesh;
    double area = 0;
    double motion = 0;
    for (int t = 0; t < mesh.triangleSlots(); ++t) {
        const Corners at = cornersOf(mesh, t);
        const Vec3 middle = (at[0] + at[1] + at[2]) / 3;
        const double share = triangleArea(at);
        area += share;
        motion += share * compliance(loading, std::abs(middle.y() - support));
    }
    return density * loading.size.prod() * motion / area / loading.solid;
}

/// The force per modulus that lets the middle of a sphere down by `way`: 4/3 E / (1 - nu^2)
/// sqrt(R) way^(3/2) with Poisson's ratio 1/2 [m^2].
double hertzForce(double radius, double way) {
    return 16.0 / 9 * std::sqrt(radius) * std::pow(way, 1.5);
}

/// The gravity that strains a specimen of this modulus [m/s^2].
double gravityFor(const Specimen& specimen, double modulus, double density) {
    const double length = specimen.loading.size.y();
    if (specimen.loading.theory == Theory::pressed) {
        const double mass = density * meshRestVolume(specimen.mesh);
        return modulus * hertzForce(0.5 * length, kPressed * length) / mass;
    }
    return kStrain * modulus * length / loadPerGravity(specimen, density);
}

/// The modulus of the solid whose end would go so far.
double modulusFor(const Specimen& specimen, double way, double gravity, double density) {
    if (specimen.loading.theory == Theory::pressed) {
        const double mass = density * meshRestVolume(specimen.mesh);
        return mass * gravity / hertzForce(0.5 * specimen.loading.size.y(), way);
    }
    return loadPerGravity(specimen, density) * gravity / way;
}

/// About critical for the slowest mode, so that it settles soon [1/s].
double dragFor(const BenchSetting& setting, const Specimen& specimen, double density) {
    if (specimen.loading.theory != Theory::bent) {
        return kDrag;
    }
    const double gyration = specimen.loading.size.x() / std::sqrt(12.0);
    const double length = specimen.loading.size.y();
    return 2 * kFirstBending * gyration / (length * length) * std::sqrt(setting.modulus / density);
}

Params benchParams(const BenchSetting& setting, const Specimen& specimen) {
    Params params;
    params.timeStep = setting.timeStep;
    params.iterations = setting.iterations;
    params.youngsModulus = setting.modulus;
    params.trueModulus = setting.trueModulus ? 1 : 0;
    params.airDrag = dragFor(setting, specimen, params.density);
    params.friction = 0;
    params.floor.reset();
    if (specimen.loading.support == Support::floor) {
        params.floor = -specimen.loading.size.y() / 2;
    }
    const double gravity = gravityFor(specimen, setting.modulus, params.density);
    params.gravity =
        gravity * (actsAside(specimen.loading.theory) ? Vec3(Vec3::UnitX()) : Vec3(-Vec3::UnitY()));
    return params;
}

void pinEnd(Simulation& simulation, const Specimen& specimen) {
    Bounds region;
    for (const int v : specimen.held) {
        region.add(specimen.mesh.position(v));
    }
    region.widen(1e-3 * specimen.loading.size.y());
    simulation.execute(Pin{region});
}

/// How far the free end has gone since rest: along the weight [m].
double motionOfEnd(Simulation& simulation, const Specimen& specimen) {
    const SurfaceMesh& mesh = simulation.mesh();
    Vec3 sum = Vec3::Zero();
    for (const int v : specimen.free) {
        sum += mesh.position(v) - mesh.restPosition(v);
    }
    const Vec3 way = sum / static_cast<double>(specimen.free.size());
    return std::abs(actsAside(specimen.loading.theory) ? way.x() : way.y());
}

/// Steps until the end stands still. False where it does not in kMostSeconds.
bool settle(Simulation& simulation, const Specimen& specimen) {
    double before = motionOfEnd(simulation, specimen);
    double look = kWindow;
    while (simulation.report().time < kMostSeconds) {
        while (simulation.report().time < look) {
            simulation.step();
        }
        look += kWindow;
        const double now = motionOfEnd(simulation, specimen);
        if (std::abs(now - before) <= kSettled * now) {
            return true;
        }
        before = now;
    }
    return false;
}

/// Held, and about to feel its weight.
Simulation mount(const Specimen& specimen, const Params& params) {
    Simulation simulation(specimen.mesh, params);
    if (specimen.loading.support != Support::floor) {
        pinEnd(simulation, specimen);
    }
    return simulation;
}

}  // namespace

std::vector<double> motionOfEnd(const BenchSetting& setting, int looks) {
    const Specimen specimen = makeSpecimen(setting);
    Simulation simulation = mount(specimen, benchParams(setting, specimen));
    const auto stepsBetween = std::lround(kLook / setting.timeStep);
    std::vector<double> motion;
    while (std::ssize(motion) < looks) {
        for (auto i = stepsBetween; i > 0; --i) {
            simulation.step();
        }
        motion.push_back(motionOfEnd(simulation, specimen));
    }
    return motion;
}

BenchResult measureModulus(const BenchSetting& setting) {
    const Specimen specimen = makeSpecimen(setting);
    const Params params = benchParams(setting, specimen);
    Simulation simulation = mount(specimen, params);
    BenchResult result;
    result.settled = settle(simulation, specimen);
    const double way = motionOfEnd(simulation, specimen);
    result.triangles = specimen.mesh.aliveTriangles();
    result.strain = way / specimen.loading.size.y();
    result.effectiveModulus = modulusFor(specimen, way, params.gravity.norm(), params.density);
    result.volumeRatio = simulation.report().volumeRatio;
    result.tooFewIterations = SweepStrength(simulation.bodyModel(), params).isTooLittle(params);
    return result;
}

}  // namespace kerf::app
