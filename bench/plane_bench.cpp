// Milliseconds (CPU, one thread) of a whole planar cut of spheres into two closed halves whose
// walls are meshed at the edge length of the skin: all steps of the blade together, beside CGAL in
// the same run. CGAL does not remove slivers, so the compared run leaves the clean-up off; the
// figure with it stands beside. Each row has another number of steps: a slow stroke, a quick one,
// one swipe. Numbers, SUBDIVISIONS, STEPS and perhaps GRADING, repeat that stroke alone, for a
// profiler. A folder instead gets the spheres as OBJ files, and walls are graded:
// bench/vtk_plane_cut.py runs VTK on these beside.

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "bench/cgal_plane_cut.h"
#include "bench/timing.h"
#include "sim/base/freed_memory.h"
#include "sim/cut/stroke/cutter.h"
#include "sim/mesh/invariants.h"
#include "sim/mesh/triangle.h"
#include "tests/support/shapes.h"

namespace kerf {
namespace {

constexpr double kRadius = 0.5;
constexpr double kReach = 1.3;  // how far the blade goes beyond the sphere, in radii
constexpr std::array<int, 3> kSteps{60, 15, 1};  // a stroke of a second, of a quarter, a swipe
constexpr double kSameVolume = 1e-9;             // relative
constexpr double kComparable = 1.5;              // largest ratio of the numbers of wall triangles
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
    double meanShape = 0;       ///< of the walls: height over longest edge, 1 if equilateral
    int flat = 0;               ///< walls of a shape below 0.1
    double construction = 0;    ///< of the cutter [ms]
    std::vector<double> calls;  ///< begin, each step, finish [ms]
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

/// How a cut of ours is made.
struct How {
    int steps;
    bool cleanUp = false;
    double grading = 1;  ///< CutSettings::wallCoarsening
};

Outcome ourCut(const SurfaceMesh& whole, double edge, const How& how) {
    SurfaceMesh mesh = whole;
    Outcome out;
    CutSettings settings;
    settings.wallEdgeLength = edge;
    settings.offset = kOffset;
    settings.tolerance = 1e-9;
    settings.cleanUp = how.cleanUp;
    settings.wallCoarsening = how.grading;
    const CpuTime time;
    Cutter cutter(mesh, settings);
    out.construction = time.milliseconds();
    const auto timed = [&out](const auto& call) {
        const CpuTime ofCall;
        call();
        out.calls.push_back(ofCall.milliseconds());
    };
    timed([&] { cutter.begin(bladeAt(-kReach * kRadius)); });
    for (int i = 1; i <= how.steps; ++i) {
        timed([&] {
            cutter.boundMotion(0);
            const double share = static_cast<double>(i) / how.steps;
            if (cutter.advance(bladeAt((2 * share - 1) * kReach * kRadius))
                    .statistics.refusedPieces > 0) {
                throw std::runtime_error("a step of the cut was refused");
            }
        });
    }
    timed([&] {
        cutter.boundMotion(0);
        cutter.finish();
    });
    out.milliseconds = time.milliseconds();
    for (const Piece& piece : findPieces(mesh).pieces) {
        out.volumes.push_back(piece.volume);
    }
    std::sort(out.volumes.begin(), out.volumes.end());
    for (const int t : livingTriangles(mesh)) {
        if (mesh.kind(t) == SurfaceKind::wall) {
            const Corners at = cornersOf(mesh, t);
            const double shape = areaNormal(at).norm() / longestEdgeSquare(at) * 2 / std::sqrt(3);
            out.meanShape += shape;
            out.flat += shape < 0.1;
            ++out.wallTriangles;
        }
    }
    out.meanShape /= std::max(out.wallTriangles, 1);
    return out;
}

Outcome theirCut(const SurfaceMesh& whole) {
    CgalPlaneCut cut(whole);
    const CpuTime time;
    cut.run(kPoint, kNormal);
    Outcome out;
    out.milliseconds = time.milliseconds();
    out.volumes = cut.partVolumes();
    out.wallTriangles = cut.wallTriangles();
    return out;
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

/// Of all repeats of a stroke.
struct Ours {
    std::vector<double> milliseconds, construction, medianCall, longestCall, cleaned;

    void add(const Outcome& cut) {
        milliseconds.push_back(cut.milliseconds);
        construction.push_back(cut.construction);
        medianCall.push_back(median(cut.calls));
        longestCall.push_back(std::ranges::max(cut.calls));
    }
};

void print(int triangles, int steps, const Ours& ours, const std::vector<double>& theirs) {
    const nlohmann::ordered_json line = {
        {"name", "cut/plane/" + std::to_string(triangles) + "/steps/" + std::to_string(steps)},
        {"ours", median(ours.milliseconds)},
        {"theirs", median(theirs)},
        {"peer", "CGAL split, triangulate_and_refine_hole"},
        {"ratio", median(theirs) / median(ours.milliseconds)},
        {"unit", "ms"},
        {"construction", median(ours.construction)},
        {"median_step", median(ours.medianCall)},
        {"longest_step", median(ours.longestCall)},
        {"ours_with_cleanup", median(ours.cleaned)}};
    std::puts(line.dump().c_str());
    std::fflush(stdout);
}

void bench(int subdivisions, int repeats) {
    const SurfaceMesh whole = test::icosphere(subdivisions, kRadius);
    const double edge = meanEdge(whole);
    std::vector<double> theirs;
    std::array<Ours, kSteps.size()> ours;
    for (int i = 0; i < repeats; ++i) {
        const Outcome their = theirCut(whole);
        theirs.push_back(their.milliseconds);
        for (std::size_t k = 0; k < kSteps.size(); ++k) {
            const Outcome our = ourCut(whole, edge, {kSteps[k]});
            if (i == 0) {
                std::fprintf(stderr, "%d triangles, %d steps\n", whole.triangleSlots(), kSteps[k]);
                requireSameVolumes(our, their);
                requireComparableWalls(our, their);
            }
            ours[k].add(our);
            ours[k].cleaned.push_back(ourCut(whole, edge, {kSteps[k], true}).milliseconds);
        }
    }
    for (std::size_t k = 0; k < kSteps.size(); ++k) {
        print(whole.triangleSlots(), kSteps[k], ours[k], theirs);
    }
}

void repeatAlone(int subdivisions, const How& how) {
    constexpr int kLeast = 3;
    constexpr double kMilliseconds = 3000;
    const SurfaceMesh whole = test::icosphere(subdivisions, kRadius);
    const double edge = meanEdge(whole);
    Ours ours;
    const CpuTime time;
    for (int i = 0; i < kLeast || time.milliseconds() < kMilliseconds; ++i) {
        ours.add(ourCut(whole, edge, how));
    }
    std::printf(
        "%d triangles, %d steps: %.2f ms, of that %.2f to construct; median step %.3f, "
        "longest %.2f\n",
        whole.triangleSlots(), how.steps, median(ours.milliseconds), median(ours.construction),
        median(ours.medianCall), median(ours.longestCall));
}

void writeObj(const SurfaceMesh& mesh, const std::string& path) {
    std::ofstream file(path);
    file.precision(17);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const Vec3& p = mesh.position(v);
        file << "v " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
    }
    for (int t = 0; t < mesh.triangleSlots(); ++t) {
        const auto [a, b, c] = mesh.triangle(t);
        file << "f " << a + 1 << ' ' << b + 1 << ' ' << c + 1 << '\n';
    }
    if (!file.flush()) {
        throw std::runtime_error("cannot write " + path);
    }
}

/// Fine and graded walls in turn, and the bodies for a peer to cut.
void benchGraded(int subdivisions, int repeats, const std::string& folder) {
    constexpr double kGrading = 3;
    const SurfaceMesh whole = test::icosphere(subdivisions, kRadius);
    const double edge = meanEdge(whole);
    const std::string path = folder + "/" + std::to_string(whole.triangleSlots()) + ".obj";
    writeObj(whole, path);
    for (const int steps : kSteps) {
        std::vector<double> fine, graded;
        Outcome coarse, dense;
        for (int i = 0; i < repeats; ++i) {
            dense = ourCut(whole, edge, {steps});
            coarse = ourCut(whole, edge, {steps, false, kGrading});
            fine.push_back(dense.milliseconds);
            graded.push_back(coarse.milliseconds);
        }
        const nlohmann::ordered_json line = {
            {"name", "cut/graded/" + std::to_string(whole.triangleSlots()) + "/steps/" +
                         std::to_string(steps)},
            {"ours", median(graded)},
            {"fine", median(fine)},
            {"unit", "ms"},
            {"construction", coarse.construction},
            {"wall_triangles", coarse.wallTriangles},
            {"fine_wall_triangles", dense.wallTriangles},
            {"shape", coarse.meanShape},
            {"fine_shape", dense.meanShape},
            {"flat", coarse.flat},
            {"fine_flat", dense.flat},
            {"volumes", coarse.volumes},
            {"body", path},
            {"point", {kPoint.x(), kPoint.y(), kPoint.z()}},
            {"normal", {kNormal.x(), kNormal.y(), kNormal.z()}}};
        std::puts(line.dump().c_str());
        std::fflush(stdout);
    }
}

}  // namespace
}  // namespace kerf

int main(int count, char** arguments) {
    kerf::keepFreedMemory();  // as the editor does, and for CGAL too
    try {
        if (count == 3 || count == 4) {
            const double grading = count == 4 ? std::atof(arguments[3]) : 1;
            kerf::repeatAlone(std::atoi(arguments[1]), {std::atoi(arguments[2]), false, grading});
            return 0;
        }
        if (count == 2) {
            kerf::benchGraded(5, 5, arguments[1]);
            kerf::benchGraded(7, 5, arguments[1]);
            return 0;
        }
        kerf::bench(5, 5);
        kerf::bench(7, 5);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
