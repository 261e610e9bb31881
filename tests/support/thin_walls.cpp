#include "tests/support/thin_walls.h"

#include "sim/base/stopwatch.h"
#include "sim/mesh/invariants.h"
#include "sim/mesh/triangle.h"
#include "sim/repair/surface_contact.h"
#include "sim/run/simulation.h"
#include "tests/support/formatted.h"
#include "tests/support/self_intersections.h"
#include "tests/support/shapes.h"

namespace kerf::test {

namespace {

constexpr double kDiagonal = 0.1;    // [m]
constexpr double kRounding = 1e-6;   // of the diagonal
constexpr double kHair = 1e-3 / 12;  // of the diagonal
constexpr double kDeep = 0.05;       // of a wall
constexpr double kLongest = 0.09;    // of an edge along an axis [diagonals]

/// The coordinates of layers of a grid along an axis: walls of thickness `wall` beginning at
/// `walls`, the rest divided evenly.
std::vector<double> layers(double from, double to, const std::vector<double>& walls, double wall) {
    std::vector<double> ends = {from, to};
    for (const double at : walls) {
        ends.insert(ends.end(), {at, at + wall});
    }
    std::ranges::sort(ends);
    ends.erase(std::unique(ends.begin(), ends.end(),
                           [](double a, double b) { return std::fabs(a - b) < 1e-9; }),
               ends.end());
    std::vector<double> all = {ends.front()};
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        const int parts = static_cast<int>(std::ceil((ends[i + 1] - ends[i]) / kLongest));
        for (int k = 1; k <= parts; ++k) {
            all.push_back(ends[i] + (ends[i + 1] - ends[i]) * k / parts);
        }
    }
    return all;
}

using Layers = std::array<std::vector<double>, 3>;
using Filled = std::function<bool(const Vec3& middle)>;

/// The surface of the cells of a grid that are filled.
class CellSurface {
  public:
    CellSurface(const Layers& layers, const Filled& filled) : layers_(layers), filled_(filled) {
        std::array<int, 3> cell{};
        for (cell[0] = 0; cell[0] < cells(0); ++cell[0]) {
            for (cell[1] = 0; cell[1] < cells(1); ++cell[1]) {
                for (cell[2] = 0; cell[2] < cells(2); ++cell[2]) {
                    for (int axis = 0; axis < 3 && isFilled(cell); ++axis) {
                        addFace(cell, axis, -1);
                        addFace(cell, axis, 1);
                    }
                }
            }
        }
    }

    TriangleSoup soup;

  private:
    int cells(int axis) const { return static_cast<int>(layers_[axis].size()) - 1; }

    bool isFilled(const std::array<int, 3>& cell) const {
        Vec3 middle;
        for (int axis = 0; axis < 3; ++axis) {
            if (cell[axis] < 0 || cell[axis] >= cells(axis)) {
                return false;
            }
            middle[axis] = 0.5 * (layers_[axis][cell[axis]] + layers_[axis][cell[axis] + 1]);
        }
        return filled_(middle);
    }

    int vertex(const std::array<int, 3>& node) {
        const auto [at, isNew] = numbers_.try_emplace(node, static_cast<int>(numbers_.size()));
        if (isNew) {
            soup.positions.emplace_back(layers_[0][node[0]], layers_[1][node[1]],
                                        layers_[2][node[2]]);
        }
        return at->second;
    }

    void addFace(std::array<int, 3> cell, int axis, int side) {
        std::array<int, 3> beyond = cell;
        beyond[axis] += side;
        if (isFilled(beyond)) {
            return;
        }
        cell[axis] += side > 0 ? 1 : 0;
        const int u = (axis + 1) % 3;
        const int w = (axis + 2) % 3;
        std::array<int, 4> corners{};
        for (int k = 0; k < 4; ++k) {
            std::array<int, 3> node = cell;
            node[u] += k == 1 || k == 2 ? 1 : 0;
            node[w] += k >= 2 ? 1 : 0;
            corners[side > 0 ? k : 3 - k] = vertex(node);
        }
        soup.triangles.push_back({corners[0], corners[1], corners[2]});
        soup.triangles.push_back({corners[0], corners[2], corners[3]});
    }

    const Layers& layers_;
    const Filled& filled_;
    std::map<std::array<int, 3>, int> numbers_;
};

/// Lengths in diagonals.
TriangleSoup cellsOf(const std::string& shape, double wall) {
    const double half = 0.5 / std::sqrt(3.0);  // of the edge of a cube
    const auto box = [&](const std::vector<double>& walls) {
        return layers(-half, half, walls, wall);
    };
    const std::vector<double> both = {-half, half - wall};
    const auto isRim = [&](double x) { return std::fabs(x) > half - wall; };
    if (shape == "plate") {
        const double wide = 0.5 / std::sqrt(2.0);
        return CellSurface({layers(-wide, wide, {}, wall), layers(-wall / 2, wall / 2, {}, wall),
                            layers(-wide, wide, {}, wall)},
                           [](const Vec3&) { return true; })
            .soup;
    }
    if (shape == "tube") {
        return CellSurface({box(both), box({}), box(both)},
                           [&](const Vec3& p) { return isRim(p.x()) || isRim(p.z()); })
            .soup;
    }
    if (shape == "cup") {
        return CellSurface({box(both), box({-half}), box(both)},
                           [&](const Vec3& p) {
                               return isRim(p.x()) || isRim(p.z()) || p.y() < -half + wall;
                           })
            .soup;
    }
    if (shape == "fins") {
        const std::vector<double> middle = {-wall / 2};
        return CellSurface({box(middle), box({}), box(middle)},
                           [&](const Vec3& p) {
                               return std::fabs(p.x()) < wall / 2 || std::fabs(p.z()) < wall / 2;
                           })
            .soup;
    }
    return CellSurface({box(both), box(both), box(both)},
                       [&](const Vec3& p) { return isRim(p.x()) || isRim(p.y()) || isRim(p.z()); })
        .soup;
}

/// A stroke in a plane through `point`, from above down.
void cutAlong(Simulation& simulation, const Vec3& point, const Vec3& normal) {
    constexpr int kSteps = 12;
    const Vec3 down = (-Vec3::UnitY() + normal * normal.y()).normalized();
    const Vec3 along = normal.cross(down);
    for (int step = 0; step <= kSteps; ++step) {
        const Vec3 middle = point + kDiagonal * (1.4 * step / kSteps - 0.7) * down;
        const Vec3 reach = kDiagonal * along;
        simulation.execute(MoveBlade{{middle - reach, middle + reach}});
        simulation.step();
    }
    simulation.execute(LiftBlade{});
    simulation.step();
}

/// A plane along the face of a wall, which leaves the body open on that side.
Vec3 pointOnFace(const WallScene& scene) {
    const double half = 0.5 / std::sqrt(3.0);
    const double x = scene.shape == "plate"  ? 0.1
                     : scene.shape == "fins" ? scene.wall / 2
                                             : half - scene.wall;
    return {kDiagonal * x, 0, 0};
}

/// Pairs of triangles that pass through each other.
struct Crossings {
    int all = 0;   ///< deeper than floats round, where a cut made one than a thousandth of an edge
    int deep = 0;  ///< deeper than a twentieth of the wall
};
Crossings crossingsOf(const SurfaceMesh& mesh, double wall) {
    Crossings count;
    const auto isWall = [&](int t) { return mesh.kind(t) == SurfaceKind::wall; };
    for (const auto& [a, b] : selfIntersections(mesh)) {
        const double depth =
            repair::crossingDepth(cornersOf(mesh, a), cornersOf(mesh, b)) / kDiagonal;
        count.all += depth > (isWall(a) || isWall(b) ? kHair : kRounding) ? 1 : 0;
        count.deep += depth > std::max(kHair, kDeep * wall) ? 1 : 0;
    }
    return count;
}

void cut(Simulation& simulation, const WallScene& scene) {
    const Vec3 slanted = Vec3(1, 0.37, 0.21).normalized();
    if (scene.cut == "flush") {
        cutAlong(simulation, pointOnFace(scene), Vec3::UnitX());
        return;
    }
    cutAlong(simulation, kDiagonal * Vec3(0.013, 0.007, 0.011), slanted);
    if (scene.cut == "twice") {
        cutAlong(simulation, kDiagonal * Vec3(-0.017, 0.003, 0.012),
                 Vec3(0.27, 0.19, -1).normalized());
    }
}

/// Hands at both ends in x.
struct Drawing {
    double speed = 0.05;       ///< of each [m/s]
    std::array<Vec3, 2> at{};  ///< [m]

    void begin(Simulation& simulation) {
        const Bounds box = meshBounds(simulation.mesh());
        at.fill(box.center());
        at[0].x() = box.low.x();
        at[1].x() = box.high.x();
        for (const int hand : {0, 1}) {
            simulation.execute(Grab{.hand = hand, .at = at[hand], .radius = 0.3 * kDiagonal});
        }
    }

    void goOn(Simulation& simulation, double timeStep) {
        for (const int hand : {0, 1}) {
            at[hand].x() += (hand == 0 ? -speed : speed) * timeStep;
            simulation.execute(Drag{hand, at[hand]});
        }
    }
};

}  // namespace

TriangleSoup thinSoup(const std::string& shape, double wall) {
    TriangleSoup soup = cellsOf(shape, wall);
    for (Vec3& p : soup.positions) {
        p *= kDiagonal;
    }
    return soup;
}

std::vector<WallScene> wallScenes(int nth) {
    std::vector<WallScene> all;
    int index = 0;
    for (const char* shape : {"plate", "tube", "cup", "fins", "shell"}) {
        for (const double wall : {1 / 5.5, 1 / 12.0, 1 / 38.0, 1 / 80.0, 1 / 200.0, 1 / 500.0}) {
            for (const char* cut : {"slanted", "flush", "twice"}) {
                for (const char* motion : {"rests", "falls", "drawn"}) {
                    for (const double timeStep : {0.001, 0.005}) {
                        if (index++ % nth == 0) {
                            all.push_back({shape, wall, cut, motion, timeStep});
                        }
                    }
                }
            }
        }
    }
    return all;
}

WallFigures playWalls(const WallScene& scene, Params params) {
    params.timeStep = scene.timeStep;
    params.floor.reset();
    params.gravity.setZero();
    const Stopwatch watch;
    Simulation simulation(meshOf(thinSoup(scene.shape, scene.wall)), params);
    simulation.execute(SetTime{false});
    cut(simulation, scene);
    const Bounds box = meshBounds(simulation.mesh());
    simulation.execute(SetTime{true});
    Drawing drawing;
    if (scene.motion == "falls") {
        simulation.execute(SetParam{"gravity", Vec3(0, -9.81, 0)});
        simulation.execute(SetParam{"floor", box.low.y() - 0.5 * kDiagonal});
    } else if (scene.motion == "drawn") {
        drawing.begin(simulation);
    }
    WallFigures figures;
    const Crossings atStart = crossingsOf(simulation.mesh(), scene.wall);
    const int steps = static_cast<int>(std::lround(scene.seconds / scene.timeStep));
    const int look = static_cast<int>(std::lround(0.02 / scene.timeStep));
    for (int step = 1; step <= steps; ++step) {
        if (scene.motion == "drawn") {
            drawing.goOn(simulation, scene.timeStep);
        }
        simulation.step();
        const StepReport& report = simulation.report();
        figures.leastVolume = std::min(figures.leastVolume, report.volumeRatio);
        figures.mostVolume = std::max(figures.mostVolume, report.volumeRatio);
        figures.closed = figures.closed && report.closed;
        figures.pieces = report.pieces;
        figures.triangles = report.triangles;
        if (step % look == 0) {
            const Crossings now = crossingsOf(simulation.mesh(), scene.wall);
            figures.crossings = std::max(figures.crossings, now.all - atStart.all);
            figures.deepCrossings = std::max(figures.deepCrossings, now.deep - atStart.deep);
        }
    }
    figures.messages = static_cast<int>(simulation.takeMessages().size());
    figures.wallTime = watch.milliseconds() / 1000;
    return figures;
}

bool WallFigures::isRight() const {
    return closed && leastVolume > 0.98 && mostVolume < 1.02 && deepCrossings <= 0;
}

std::string text(const WallScene& scene) {
    return formatted("%-5s 1/%-4.3g %-7s %-5s %g ms", scene.shape.c_str(), 1 / scene.wall,
                     scene.cut.c_str(), scene.motion.c_str(), 1000 * scene.timeStep);
}

std::string text(const WallFigures& f) {
    return formatted(
        "%s pieces %d triangles %d volume %.4f to %.4f crossings %d, deep %d%s messages %d, "
        "%.1f s",
        f.isRight() ? "right" : "WRONG", f.pieces, f.triangles, f.leastVolume, f.mostVolume,
        f.crossings, f.deepCrossings, f.closed ? "" : " OPEN", f.messages, f.wallTime);
}

}  // namespace kerf::test
