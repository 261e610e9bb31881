#include "tests/support/bar_falls.h"

#include "sim/mesh/invariants.h"
#include "sim/run/simulation.h"
#include "tests/support/formatted.h"
#include "tests/support/shapes.h"

namespace kerf::test {

namespace {

constexpr double kBarLength = 4;  // [m]
constexpr double kBarTurn = 20;   // [degrees]

/// Twice the area of (0, p, q) in the y-z plane; its negative, to the last bit, for (0, q, p).
double turnOf(const Vec3& p, const Vec3& q) {
    return p.y() * q.z() - p.z() * q.y();
}

/// Where the x axis crosses a surface; `in`: 1 into the body, -1 out of it.
struct Crossing {
    double x = 0;
    int in = 0;
};

/// Crossings of the x axis with triangles, corners in `at`.
std::vector<Crossing> crossingsOf(const SurfaceMesh& mesh, const std::vector<Vec3>& at) {
    std::vector<Crossing> crossings;
    for (const int t : livingTriangles(mesh)) {
        const Triangle& c = mesh.triangle(t);
        const double a = turnOf(at[c[1]], at[c[2]]);
        const double b = turnOf(at[c[2]], at[c[0]]);
        const double d = turnOf(at[c[0]], at[c[1]]);
        const bool out = a >= 0 && b >= 0 && d >= 0;
        const bool in = a < 0 && b < 0 && d < 0;
        if ((out || in) && a + b + d != 0) {
            crossings.push_back(
                {(a * at[c[0]].x() + b * at[c[1]].x() + d * at[c[2]].x()) / (a + b + d),
                 in ? 1 : -1});
        }
    }
    std::ranges::sort(crossings, {}, &Crossing::x);
    return crossings;
}

double fastestOf(const SurfaceMesh& mesh) {
    double fastest = 0;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        fastest = std::max(fastest, mesh.velocity(v).norm());
    }
    return fastest;
}

/// Just above the bar, as fast as after the fall.
SurfaceMesh fallen(const BarFall& fall) {
    SurfaceMesh mesh = builtin(fall.model);
    const double up = 0.01 + std::sqrt(0.5) * fall.width - meshBounds(mesh).low.y();
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        mesh.setPosition(v, mesh.position(v) + Vec3(0.02, up, fall.aside));
        mesh.setRestPosition(v, mesh.position(v));
        mesh.setVelocity(v, Vec3(0, -std::sqrt(2 * 9.81 * fall.height), 0));
    }
    return mesh;
}

}  // namespace

double lengthInside(const SurfaceMesh& mesh, const StaticBox& bar) {
    std::vector<Vec3> at(mesh.vertexCount());
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        at[v] = bar.axes().transpose() * (mesh.position(v) - bar.center);
    }
    double inside = 0;
    double entered = 0;
    int winding = 0;
    for (const Crossing& crossing : crossingsOf(mesh, at)) {
        if (winding > 0) {
            inside += crossing.x - entered;
        }
        entered = crossing.x;
        winding += crossing.in;
    }
    return inside;
}

BarFigures fallOnBar(const BarFall& fall, Params params) {
    StaticBox bar;
    bar.size = {kBarLength, fall.width, fall.width};
    bar.rotate = {fall.roll, kBarTurn, 0};
    params.floor = fall.floor;
    params.youngsModulus = fall.modulus;
    const Vec3 gravity = std::exchange(params.gravity, Vec3::Zero());
    Simulation simulation(fallen(fall), params, {bar});
    simulation.execute(SetParam{"gravity", gravity});  // as a person does it in the editor
    BarFigures figures;
    figures.steps = static_cast<int>(std::lround(fall.seconds / params.timeStep));
    for (int i = 0; i < figures.steps; ++i) {
        const StepReport& report = simulation.step();
        figures.leastVolume = std::min(figures.leastVolume, report.volumeRatio);
        figures.lastVolume = report.volumeRatio;
        figures.longestLast = lengthInside(simulation.mesh(), bar);
        figures.longest = std::max(figures.longest, figures.longestLast);
        figures.pierced += figures.longestLast > 0;
        figures.fastest = std::max(figures.fastest, fastestOf(simulation.mesh()));
    }
    return figures;
}

std::string text(const BarFigures& f) {
    return formatted(
        "pierced after %3d of %d steps, at most %.3f m, at the end %.3f m; volume at "
        "least %.4f, at the end %.4f; fastest %.1f m/s",
        f.pierced, f.steps, f.longest, f.longestLast, f.leastVolume, f.lastVolume, f.fastest);
}

}  // namespace kerf::test
