// Milliseconds (CPU, one thread) of a whole planar cut of spheres into two closed halves whose
// walls are meshed at the edge length of the skin: all steps of the blade together, beside CGAL in
// the same run. CGAL does not remove slivers, so the compared run leaves the clean-up off; the
// figure with it stands beside.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <exception>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/cgal_plane_cut.h"
#include "bench/timing.h"
#include "sim/cut/cutter.h"
#include "sim/mesh/invariants.h"
#include "tests/support/shapes.h"

namespace kerf {
namespace {

constexpr double kRadius = 0.5;
constexpr double kReach = 1.3;        // how far the blade goes beyond the sphere, in radii
constexpr int kSteps = 60;            // a stroke of a second
constexpr double kSameVolume = 1e-9;  // relative
constexpr double kComparable = 1.5;   // largest ratio of the numbers of wall triangles
// Far less than kSameVolume of the sphere lies between the plane and the blade.
constexpr double kOffset = 1e-8;

const Vec3 kPoint(0.013, 0.021, 0.034);
const Vec3 kAlong = Vec3(0.9, 0.1, -0.3).normalized();
const Vec3 kTravel = kAlong.cross(Vec3(0.2, 1, 0.37)).normalized();
const Vec3 kNormal = kAlong.cross(kTravel);

/// Of this process since it was made; other programs on the machine do not count.
class CpuTime {
  public:
    double milliseconds() const {
        return 1e3 * static_cast<double>(std::clock() - start_) / CLOCKS_PER_SEC;
    }

  private:
    std::clock_t start_ = std::clock();
};

/// What a whole cut came to.
struct Outcome {
    double milliseconds = 0;
    std::vector<double> volumes;  ///< of the parts, ascending [m^3]
    int wallTriangles = 0;
};

double meanEdge(const SurfaceMesh& mesh) {
    double sum = 0;
    for (int h = 0; h < 3 * mesh.triangleSlots(); ++h) {
        sum += (mesh.position(mesh.target(h)) - mesh.position(mesh.origin(h))).norm();
    }
    return sum / (3 * mesh.triangleSlots());
}

Blade bladeAt(double distance) {
    const Vec3 middle = kPoint + distance * kTravel;
    return {middle - kReach * kRadius * kAlong, middle + kReach * kRadius * kAlong};
}

Outcome ourCut(const SurfaceMesh& whole, double edge, bool cleanUp) {
    SurfaceMesh mesh = whole;
    CutSettings settings;
    settings.wallEdgeLength = edge;
    settings.offset = kOffset;
    settings.tolerance = 1e-9;
    settings.cleanUp = cleanUp;
    const CpuTime time;
    Cutter cutter(mesh, settings);
    cutter.begin(bladeAt(-kReach * kRadius));
    for (int i = 1; i <= kSteps; ++i) {
        cutter.boundMotion(0);
        const double share = static_cast<double>(i) / kSteps;
        if (cutter.advance(bladeAt((2 * share - 1) * kReach * kRadius)).statistics.refusedPieces >
            0) {
            throw std::runtime_error("a step of the cut was refused");
        }
    }
    cutter.boundMotion(0);
    cutter.finish();
    Outcome out{time.milliseconds(), {}, 0};
    for (const Piece& piece : findPieces(mesh).pieces) {
        out.volumes.push_back(piece.volume);
    }
    std::sort(out.volumes.begin(), out.volumes.end());
    for (const int t : livingTriangles(mesh)) {
        out.wallTriangles += mesh.kind(t) == SurfaceKind::wall;
    }
    return out;
}

Outcome theirCut(const SurfaceMesh& whole) {
    CgalPlaneCut cut(whole);
    const CpuTime time;
    cut.run(kPoint, kNormal);
    return {time.milliseconds(), cut.partVolumes(), cut.wallTriangles()};
}

void requireSameVolumes(const Outcome& ours, const Outcome& theirs) {
    if (ours.volumes.size() != theirs.volumes.size()) {
        throw std::runtime_error("the cuts made different numbers of parts");
    }
    double largest = 0;
    for (std::size_t i = 0; i < ours.volumes.size(); ++i) {
        largest = std::max(largest, std::fabs(ours.volumes[i] / theirs.volumes[i] - 1));
    }
    std::fprintf(stderr, "  %zu parts, volumes apart by %.1e\n", ours.volumes.size(), largest);
    if (!(largest < kSameVolume)) {
        throw std::runtime_error("the parts have different volumes");
    }
}

void requireComparableWalls(const Outcome& ours, const Outcome& theirs) {
    const double ratio = static_cast<double>(ours.wallTriangles) / theirs.wallTriangles;
    std::fprintf(stderr, "  wall triangles: ours %d, CGAL's %d\n", ours.wallTriangles,
                 theirs.wallTriangles);
    if (!(ratio < kComparable && ratio > 1 / kComparable)) {
        throw std::runtime_error("the walls are not comparable");
    }
}

void bench(int subdivisions, int repeats) {
    const SurfaceMesh whole = test::icosphere(subdivisions, kRadius);
    const double edge = meanEdge(whole);
    std::vector<double> ours, cleaned, theirs;
    for (int i = 0; i < repeats; ++i) {
        const Outcome our = ourCut(whole, edge, false);
        const Outcome their = theirCut(whole);
        if (i == 0) {
            std::fprintf(stderr, "cut/plane/%d\n", whole.triangleSlots());
            requireSameVolumes(our, their);
            requireComparableWalls(our, their);
        }
        ours.push_back(our.milliseconds);
        theirs.push_back(their.milliseconds);
        cleaned.push_back(ourCut(whole, edge, true).milliseconds);
    }
    const nlohmann::ordered_json line = {
        {"name", "cut/plane/" + std::to_string(whole.triangleSlots())},
        {"ours", median(ours)},
        {"theirs", median(theirs)},
        {"peer", "CGAL split, triangulate_and_refine_hole"},
        {"ratio", median(theirs) / median(ours)},
        {"unit", "ms"},
        {"ours_with_cleanup", median(cleaned)}};
    std::puts(line.dump().c_str());
    std::fflush(stdout);
}

}  // namespace
}  // namespace kerf

int main() {
    try {
        kerf::bench(5, 5);
        kerf::bench(7, 5);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
