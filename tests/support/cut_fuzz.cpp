#include "tests/support/cut_fuzz.h"

#include <cstdlib>
#include <random>
#include <sstream>

#include "sim/base/math.h"
#include "sim/body/rest_geometry.h"
#include "sim/cut/stroke/cutter.h"
#include "tests/support/self_intersections.h"
#include "tests/support/shapes.h"

namespace kerf::test {

namespace {

// Of positions that are rounded, share of h.
constexpr double kNoise = 1e-6;

// A piece reaches to both sides of a stroke if it has vertices farther away from it, share of h: as
// far as a step that cuts anew from behind the front may lie aside.
constexpr double kOtherSide = 0.3;
constexpr double kChanceOfRounding = 0.4;
constexpr double kChanceOfFineOffset = 0.2;  // of strokes in doubles, drawn apart
constexpr int kManySlivers = 4;              // of one stroke that are worth a note
// The clean-up moves vertices of the skin, and the rim with them, this far, share of h.
constexpr double kCleanupReach = 0.03;

class Dice {
  public:
    explicit Dice(std::uint64_t seed) : engine_(seed) {}
    // std::uniform_real_distribution differs between libraries; seeds should not.
    double uniform(double low = 0, double high = 1) {
        return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
    }
    int below(int n) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(n)); }
    bool chance(double p) { return uniform() < p; }
    Vec3 direction() {
        while (true) {
            const double x = uniform(-1, 1);
            const double y = uniform(-1, 1);
            const double z = uniform(-1, 1);
            const Vec3 v(x, y, z);
            if (v.norm() > 0.1 && v.norm() < 1) {
                return v.normalized();
            }
        }
    }

  private:
    std::mt19937_64 engine_;
};

/// A small head with eight arms, star-shaped.
SurfaceMesh urchin() {
    TriangleSoup soup = icosphereSoup(3, 1.0);
    for (Vec3& p : soup.positions) {
        double radius = 0.3;
        for (int k = 0; k < 8; ++k) {
            const double angle = 2 * M_PI * k / 8 + 0.1;
            const Vec3 arm = Vec3(std::cos(angle), -0.4, std::sin(angle)).normalized();
            radius += 0.5 * std::pow(std::max(0.0, p.dot(arm)), 30);
        }
        p *= radius;
    }
    return meshOf(soup);
}

// Rare, since each takes as long as twenty others. Drawn apart from the rest, so that the other
// seeds keep their bodies.
constexpr double kChanceOfLargeBody = 0.004;
constexpr double kChanceOfGradedBody = 0.05;

/// The one asked for, or any of those that are drawn.
FuzzMode randomMode(Dice& dice, std::optional<FuzzMode> wanted) {
    const auto drawn = static_cast<FuzzMode>(dice.below(kModesDrawn));
    const char* name = std::getenv("KERF_FUZZ_MODE");
    for (int mode = 0; name != nullptr && mode < kFuzzModes; ++mode) {
        if (std::string(name) == nameOf(static_cast<FuzzMode>(mode))) {
            return static_cast<FuzzMode>(mode);
        }
    }
    return wanted.value_or(drawn);
}

SurfaceMesh randomBody(Dice& dice, std::uint64_t seed, std::string& name) {
    const int kind = dice.below(7);
    Dice apart(seed + 1000000007);
    if (apart.chance(kChanceOfLargeBody)) {
        const bool sphere = apart.chance(0.5);
        name = sphere ? "icosphere 20480" : "octopus";
        return sphere ? icosphere(5) : builtin("octopus");
    }
    if (apart.chance(kChanceOfGradedBody)) {
        const bool sphere = apart.chance(0.5);
        name = sphere ? "graded sphere" : "graded torus";
        return sphere ? gradedSphere() : gradedTorus();
    }
    switch (kind) {
        case 0:
            name = "icosphere 20";
            return icosphere(0);
        case 1:
            name = "icosphere 80";
            return icosphere(1);
        case 2:
            name = "icosphere 1280";
            return icosphere(3);
        case 3:
            name = "cube sphere 768";
            return cubeSphere(8);
        case 4:
            name = "torus 1024";
            return torus();
        case 5:
            name = "bent tube";
            return bentTube();
        default:
            name = "urchin";
            return urchin();
    }
}

/// Of walls.
double longestEdgeOf(const SurfaceMesh& mesh) {
    double longest = 0;
    for (const int t : livingTriangles(mesh)) {
        for (int h = 3 * t; h < 3 * t + 3; ++h) {
            const Vec3 edge = mesh.restPosition(mesh.target(h)) - mesh.restPosition(mesh.origin(h));
            longest = std::max(longest, edge.norm());
        }
    }
    return std::min(longest, meshBounds(mesh).diagonal() / 12);
}

double meanEdge(const SurfaceMesh& mesh) {
    return std::min(meanRestEdgeLength(mesh), meshBounds(mesh).diagonal() / 12);
}

int randomTriangle(Dice& dice, const SurfaceMesh& mesh) {
    while (true) {
        const int t = dice.below(mesh.triangleSlots());
        if (mesh.alive(t)) {
            return t;
        }
    }
}

/// Where and how a stroke goes.
struct Course {
    Vec3 center;
    Vec3 along;  ///< of the blade, from A to B
    Vec3 travel;
    Vec3 normal;
    double diagonal;
    double h;
    int steps;
};

void orthogonalize(Course& course) {
    course.travel -= course.along * course.along.dot(course.travel);
    course.travel.normalize();
    course.normal = course.along.cross(course.travel);
}

Course randomCourse(Dice& dice, const SurfaceMesh& mesh, double h) {
    const Bounds bounds = meshBounds(mesh);
    const Triangle& t = mesh.triangle(randomTriangle(dice, mesh));
    Course course;
    course.center = (mesh.position(t[0]) + mesh.position(t[1]) + mesh.position(t[2])) / 3;
    if (dice.chance(0.5)) {
        course.center += dice.uniform() * (bounds.center() - course.center);
    }
    course.along = dice.direction();
    course.travel = dice.direction();
    course.diagonal = bounds.diagonal();
    course.h = h;
    orthogonalize(course);
    course.steps =
        std::max(6, static_cast<int>(2.3 * course.diagonal / (h * dice.uniform(0.3, 1.5))));
    return course;
}

// Axis directions, through a vertex, the origin, or along an edge.
void align(Dice& dice, const SurfaceMesh& mesh, Course& course) {
    const int axis = dice.below(3);
    course.along = Vec3::Unit(axis) * (dice.chance(0.5) ? 1 : -1);
    course.travel = Vec3::Unit((axis + 1 + dice.below(2)) % 3) * (dice.chance(0.5) ? 1 : -1);
    const Triangle& t = mesh.triangle(randomTriangle(dice, mesh));
    const Vec3& a = mesh.position(t[0]);
    const Vec3 edge = mesh.position(t[1]) - a;
    const int kind = dice.below(3);
    course.center = kind == 1 ? Vec3(Vec3::Zero()) : a;
    if (kind == 2 && edge.norm() > 1e-3 * course.h) {
        course.travel = edge.normalized();
        if (course.along.cross(course.travel).norm() < 0.2) {
            course.along = course.travel.unitOrthogonal();
        }
        course.along -= course.travel * course.travel.dot(course.along);
        course.along.normalize();
    }
    course.normal = course.along.cross(course.travel);
}

struct Bend {
    double curvature = 0;
    double twist = 0;
    double phase = 0;
};

Stroke throughStroke(const Course& c, const Bend& bend) {
    Stroke stroke;
    for (int i = 0; i <= c.steps; ++i) {
        const double u = i / static_cast<double>(c.steps) - 0.5;
        const double wobble = bend.curvature != 0 ? 0.03 * std::sin(6 * u + bend.phase) : 0;
        const Vec3 middle = c.center + c.travel * (2.3 * c.diagonal * u) +
                            c.normal * (c.diagonal * (bend.curvature * u * u + wobble));
        const Vec3 along = (c.along + c.normal * (2 * bend.twist * u)).normalized();
        stroke.push_back(
            {middle - along * (1.3 * c.diagonal), middle + along * (1.3 * c.diagonal)});
    }
    return stroke;
}

/// The tip at `depth` behind the surface point, the handle far outside, moving by `way`.
Stroke incision(Dice& dice, Course c, FuzzMode mode) {
    const double depth = dice.uniform(0.05, 0.3) * c.diagonal;
    const double way = dice.uniform(0.5, 1.6) * c.diagonal;
    const double phase = dice.uniform(0, 6);
    c.steps = std::max(8, static_cast<int>(way / (c.h * dice.uniform(0.3, 1.0))));
    Stroke stroke;
    for (int i = 0; i <= c.steps; ++i) {
        const double u = i / static_cast<double>(c.steps);
        double x = u - 0.5;
        double sink = depth;
        double slide = 0;
        Vec3 along = c.along;
        if (mode == FuzzMode::wander) {
            sink = depth * (1 + 0.6 * std::sin(5 * u + phase));
            along = (c.along + 0.5 * c.normal * std::sin(3 * u + phase)).normalized();
        } else if (mode == FuzzMode::saw) {
            slide = 0.4 * depth * std::sin(1.3 * i + phase);
        } else if (mode == FuzzMode::reverse) {
            x = u + 0.18 * std::sin(6 * M_PI * u) - 0.5;
        } else if (mode == FuzzMode::pivot) {
            const double angle = 1.6 * (u - 0.5);
            along = c.along * std::cos(angle) + c.travel * std::sin(angle);
            x = 0;
        }
        const Vec3 tip = c.center + c.travel * (x * way) + c.along * sink + along * slide;
        stroke.push_back({tip - along * (1.6 * c.diagonal), tip});
    }
    return stroke;
}

/// The blade tilts to and fro in its plane while its middle goes on, so that either end in turn
/// goes back.
Stroke rockingStroke(Dice& dice, const Course& c) {
    const double tilt = dice.uniform(0.08, 0.2);
    const double turns = dice.uniform(3, 8);
    const double phase = dice.uniform(0, 6);
    Stroke stroke;
    for (int i = 0; i <= c.steps; ++i) {
        const double u = i / static_cast<double>(c.steps) - 0.5;
        const double angle = tilt * std::sin(2 * M_PI * turns * u + phase);
        const Vec3 along = c.along * std::cos(angle) + c.travel * std::sin(angle);
        const Vec3 middle = c.center + c.travel * (2.3 * c.diagonal * u);
        stroke.push_back(
            {middle - along * (1.3 * c.diagonal), middle + along * (1.3 * c.diagonal)});
    }
    return stroke;
}

/// Far along itself for each bit across, which is less than an edge and often less than the gate.
Stroke slicingStroke(Dice& dice, Course c) {
    const double reach = dice.uniform(0.5, 2) * c.diagonal;
    const double turns = dice.uniform(0.5, 8);
    const double phase = dice.uniform(0, 6);
    c.steps =
        std::clamp(static_cast<int>(2.3 * c.diagonal / (c.h * dice.uniform(0.05, 0.6))), 30, 600);
    Stroke stroke = throughStroke(c, {});
    for (int i = 0; i <= c.steps; ++i) {
        const double slide = reach * std::sin(2 * M_PI * turns * i / c.steps + phase);
        stroke[i].a += c.along * (slide - reach);
        stroke[i].b += c.along * (slide + reach);
    }
    return stroke;
}

/// Three strokes through the line along `normal` at the centre.
Stroke concurrentStroke(const Course& c, int index) {
    const double angle = 1.1 * index;
    const Vec3 along = c.normal;
    const Vec3 travel = c.along * std::cos(angle) + c.travel * std::sin(angle);
    return straightStroke(c.center, along, travel, 2.6 * c.diagonal, 2.3 * c.diagonal, c.steps);
}

int strokesOf(Dice& dice, FuzzMode mode) {
    switch (mode) {
        case FuzzMode::crossing:
        case FuzzMode::realigned:
            return 2 + dice.below(3);
        case FuzzMode::concurrent:
            return 3;
        case FuzzMode::incision:
        case FuzzMode::wander:
            return 1 + dice.below(2);
        default:
            return 1;
    }
}

Stroke randomStroke(Dice& dice, const SurfaceMesh& mesh, FuzzMode mode, double h) {
    Course course = randomCourse(dice, mesh, h);
    Bend bend;
    bend.phase = dice.uniform(-1, 1);
    const bool mixed = (mode == FuzzMode::crossing || mode == FuzzMode::fast) && dice.chance(0.5);
    switch (mode) {
        case FuzzMode::incision:
        case FuzzMode::wander:
        case FuzzMode::pivot:
        case FuzzMode::saw:
        case FuzzMode::reverse:
            return incision(dice, course, mode);
        case FuzzMode::aligned:
        case FuzzMode::realigned:
            align(dice, mesh, course);
            break;
        case FuzzMode::rocking:
            return rockingStroke(dice, course);
        case FuzzMode::slicing:
            return slicingStroke(dice, course);
        case FuzzMode::fast:
            course.steps = std::max(3, course.steps / 8);
            break;
        default:
            break;
    }
    if (mode == FuzzMode::curved || mixed) {
        bend.curvature = dice.uniform(-0.5, 0.5);
    }
    if (mode == FuzzMode::twisted || mixed) {
        bend.twist = dice.uniform(-0.5, 0.5);
    }
    if (dice.chance(0.05)) {
        course.steps = 1 + dice.below(3);
    }
    return throughStroke(course, bend);
}

/// Each vertex by up to `noise` to any side, then to the next float.
void roundToFloats(SurfaceMesh& mesh, double noise, Dice& dice) {
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const double way = noise * dice.uniform();
        const Vec3 moved = mesh.position(v) + way * dice.direction();
        mesh.setPosition(v, nearestFloats(moved));
    }
}

void deform(SurfaceMesh& mesh, double diagonal, double time) {
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const Vec3 p = mesh.position(v) / diagonal;
        mesh.setPosition(v, mesh.position(v) + 0.01 * diagonal *
                                                   Vec3(std::sin(6 * p.y() + time),
                                                        std::sin(5 * p.z() + 2 * time),
                                                        std::sin(4 * p.x() + time)));
    }
}

BetweenSteps disturbance(FuzzMode mode, bool rounded, double diagonal, double h, double phase,
                         std::uint64_t seed) {
    return [=, dice = Dice(seed)](SurfaceMesh& mesh, int step) mutable {
        if (mode == FuzzMode::deform) {
            deform(mesh, diagonal, phase + step);
        }
        if (rounded) {
            roundToFloats(mesh, kNoise * h, dice);
        }
    };
}

void addCleanup(const CleanupStatistics& from, CleanupStatistics& to) {
    to.collapses += from.collapses;
    to.flips += from.flips;
    to.slides += from.slides;
    to.volumeSpent = std::max(to.volumeSpent, from.volumeSpent);
}

/// Of living triangles.
Bounds restBounds(const SurfaceMesh& mesh, bool wallsAlone) {
    Bounds bounds;
    for (const int t : livingTriangles(mesh)) {
        for (const int v : mesh.triangle(t)) {
            if (!wallsAlone || mesh.kind(t) == SurfaceKind::wall) {
                bounds.add(mesh.restPosition(v));
            }
        }
    }
    return bounds;
}

bool reachesOut(const Bounds& inner, const Bounds& box) {
    return (inner.low.array() < box.low.array()).any() ||
           (inner.high.array() > box.high.array()).any();
}

/// Only where the body stays where it is: a deformation may push it through itself.
bool intersectsOpened(const SurfaceMesh& mesh, double h) {
    constexpr double kOpening = 1e-6;
    return !selfIntersections(opened(mesh, kOpening * h)).empty();
}

/// What is wrong with the mesh after a stroke.
struct Defects {
    bool unseparated = false;
    bool slitEnds = false;
    bool intersecting = false;
    bool outside = false;
    bool slivers = false;
    bool any() const { return unseparated || slitEnds || intersecting || outside || slivers; }
};

std::string noteOn(const CutCheck& check, const Defects& defects) {
    std::string note = check.problem + check.unmirrored + " " + std::to_string(check.refused) +
                       " refused, " + std::to_string(check.resumed) + " resumed of " +
                       std::to_string(check.cuts + check.refused) + " ";
    note += defects.unseparated ? ", not separated" : "";
    note += defects.slitEnds ? ", leaves the end of a slit" : "";
    note += defects.intersecting ? ", intersects when opened" : "";
    note += defects.outside ? ", a wall lies outside" : "";
    if (defects.slivers) {
        note += ", slivers " + std::to_string(check.quality.all().below0001);
    }
    return note + " " + check.reason;
}

void count(const CutCheck& check, const Defects& defects, const std::string& name,
           FuzzFigures& figures) {
    ++figures.strokes;
    figures.cuts += check.cuts;
    figures.refused += check.refused;
    figures.retried += check.retried;
    figures.resumed += check.resumed;
    figures.unseparated += defects.unseparated;
    figures.slitEnds += defects.slitEnds;
    figures.intersecting += defects.intersecting;
    figures.outside += defects.outside;
    figures.unmirrored += !check.unmirrored.empty();
    figures.invalid += !check.problem.empty();
    figures.quality.add(check.quality);
    figures.mostVolumeChange = std::max(figures.mostVolumeChange, check.volumeChange);
    addCleanup(check.cleanup, figures.cleanup);
    if (!check.problem.empty() || !check.unmirrored.empty() || check.refused + check.resumed > 0 ||
        defects.any()) {
        figures.notes.push_back(name + ": " + noteOn(check, defects));
    }
}

void add(const FuzzFigures& from, FuzzFigures& to) {
    to.strokes += from.strokes;
    to.cuts += from.cuts;
    to.refused += from.refused;
    to.retried += from.retried;
    to.resumed += from.resumed;
    to.unseparated += from.unseparated;
    to.slitEnds += from.slitEnds;
    to.outside += from.outside;
    to.unmirrored += from.unmirrored;
    to.intersecting += from.intersecting;
    to.invalid += from.invalid;
    to.quality.add(from.quality);
    to.mostVolumeChange = std::max(to.mostVolumeChange, from.mostVolumeChange);
    addCleanup(from.cleanup, to.cleanup);
    to.notes.insert(to.notes.end(), from.notes.begin(), from.notes.end());
}

void writeSlivers(std::ostringstream& out, const char* of, const SliverCount& count) {
    out << ", " << of << " " << count.triangles << " (below 0.02: " << count.below002
        << ", below 0.001: " << count.below0001 << ")";
}

void writeRow(std::ostringstream& out, const std::string& name, const FuzzFigures& f) {
    if (f.strokes == 0) {
        return;
    }
    out.width(18);
    out << std::left << name << " strokes " << f.strokes << ", cutting steps " << f.cuts
        << ", refused " << f.refused << ", retried " << f.retried << ", resumed " << f.resumed
        << ", unseparated " << f.unseparated << ", slit ends " << f.slitEnds << ", outside "
        << f.outside << ", unmirrored " << f.unmirrored << ", intersecting " << f.intersecting
        << ", invalid " << f.invalid;
    writeSlivers(out, "skin", f.quality.skin);
    writeSlivers(out, "walls", f.quality.walls);
    out << ", collapses " << f.cleanup.collapses << " flips " << f.cleanup.flips << " slides "
        << f.cleanup.slides << ", volume changed " << f.mostVolumeChange << "\n";
}

const char* nameOf(FuzzSetting setting) {
    switch (setting) {
        case FuzzSetting::exact:
            return "positions in doubles";
        case FuzzSetting::fine:
            return "positions in doubles, offset 1e-7 h";
        case FuzzSetting::rounded:
            break;
    }
    return "positions rounded to floats";
}

FuzzSetting randomSetting(Dice& dice, std::uint64_t seed) {
    if (dice.chance(kChanceOfRounding)) {
        return FuzzSetting::rounded;
    }
    return Dice(seed + 2000000011).chance(kChanceOfFineOffset) ? FuzzSetting::fine
                                                               : FuzzSetting::exact;
}

CutSettings cutSettings(FuzzSetting setting, double meanEdge, std::uint64_t seed) {
    CutSettings settings = setting == FuzzSetting::fine ? exactSettings() : CutSettings{};
    if (setting == FuzzSetting::exact) {
        settings.tolerance = exactSettings().tolerance;
    }
    settings.seed = seed;
    settings.cleanUp = std::getenv("KERF_FUZZ_NO_CLEANUP") == nullptr;
    settings.wallEdgeLength = std::getenv("KERF_FUZZ_EVEN_WALLS") == nullptr ? 0 : meanEdge;
    if (const char* grading = std::getenv("KERF_FUZZ_GRADING")) {
        settings.wallCoarsening = std::atof(grading);
    }
    return settings;
}

}  // namespace

const char* nameOf(FuzzMode mode) {
    static const std::array<const char*, kFuzzModes> names{
        "straight", "curved", "twisted", "fast", "aligned", "crossing", "realigned", "concurrent",
        "incision", "wander", "pivot",   "saw",  "reverse", "deform",   "rocking",   "slicing"};
    return names[static_cast<int>(mode)];
}

bool goesThrough(FuzzMode mode) {
    return mode < FuzzMode::incision || mode == FuzzMode::rocking || mode == FuzzMode::slicing;
}

bool leavesSlabs(FuzzMode mode) {
    return mode == FuzzMode::realigned || mode == FuzzMode::concurrent || mode == FuzzMode::reverse;
}

FuzzFigures FuzzReport::ordinary(FuzzSetting setting) const {
    FuzzFigures sum;
    for (int mode = 0; mode < kFuzzModes; ++mode) {
        if (!leavesSlabs(static_cast<FuzzMode>(mode))) {
            add(of(setting, static_cast<FuzzMode>(mode)), sum);
        }
    }
    return sum;
}

FuzzFigures FuzzReport::total(FuzzSetting setting) const {
    FuzzFigures sum;
    for (const FuzzFigures& ofMode : figures[static_cast<int>(setting)]) {
        add(ofMode, sum);
    }
    return sum;
}

std::string FuzzReport::table() const {
    std::ostringstream out;
    for (const FuzzSetting setting : kFuzzSettings) {
        out << nameOf(setting) << "\n";
        for (int mode = 0; mode < kFuzzModes; ++mode) {
            writeRow(out, nameOf(static_cast<FuzzMode>(mode)),
                     of(setting, static_cast<FuzzMode>(mode)));
        }
        const FuzzFigures sum = total(setting);
        writeRow(out, "modes without slabs", ordinary(setting));
        writeRow(out, "all", sum);
        for (const std::string& note : sum.notes) {
            out << "  " << note << "\n";
        }
    }
    return out.str();
}

void fuzzOnce(std::uint64_t seed, FuzzReport& report, std::optional<FuzzMode> wanted,
              const Vec3& velocity) {
    Dice dice(seed);
    std::string body;
    SurfaceMesh mesh = randomBody(dice, seed, body);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        mesh.setVelocity(v, velocity);
    }
    const FuzzMode mode = randomMode(dice, wanted);
    const FuzzSetting setting = randomSetting(dice, seed);
    const bool rounded = setting == FuzzSetting::rounded;
    const double h = meanEdge(mesh);
    Cutter cutter(mesh, cutSettings(setting, h, seed));
    const int strokes = strokesOf(dice, mode);
    const Course shared = randomCourse(dice, mesh, h);
    const bool canOpen = mode != FuzzMode::deform && !rounded;
    Bounds restBox = restBounds(mesh, false);
    restBox.widen(kCleanupReach * longestEdgeOf(mesh));
    bool intersected = false;
    for (int i = 0; i < strokes; ++i) {
        const Stroke stroke = mode == FuzzMode::concurrent ? concurrentStroke(shared, i)
                                                           : randomStroke(dice, mesh, mode, h);
        const double phase = dice.uniform(0, 6);
        const CutCheck check =
            runStroke(cutter, mesh, stroke,
                      disturbance(mode, rounded, meshBounds(mesh).diagonal(), h, phase, seed + i));
        Defects defects;
        const bool done = check.problem.empty();  // otherwise it ended early
        defects.slitEnds = done && goesThrough(mode) && slitEdges(mesh, i) > 0;
        defects.unseparated =
            defects.slitEnds && piecesOnBothSides(mesh, stroke, kOtherSide * h) > 0;
        defects.outside = reachesOut(restBounds(mesh, true), restBox);
        defects.slivers = !leavesSlabs(mode) && check.quality.all().below0001 > kManySlivers;
        const bool intersects = canOpen && intersectsOpened(mesh, h);
        defects.intersecting = intersects && !std::exchange(intersected, intersects);
        const std::string name = "seed " + std::to_string(seed) + " " + body + " " + nameOf(mode) +
                                 " stroke " + std::to_string(i);
        count(check, defects, name, report.of(setting, mode));
        if (!check.problem.empty()) {
            return;
        }
    }
}

}  // namespace kerf::test
