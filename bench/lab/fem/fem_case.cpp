#include "bench/lab/fem/fem_case.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <stdexcept>

#include "sim/mesh/box_surface.h"

namespace kerf::app {

namespace {

constexpr double kModulus = 1e5;     // [Pa]
constexpr double kHair = 1e-5;       // around places, since Kerf has them as floats [m]
constexpr double kDrag = 6;          // so that it comes to rest soon [1/s]
constexpr double kBladeSpeed = 1;    // [m/s]
constexpr double kClearance = 0.03;  // of the blade above the body and beside it [m]

// The bar: along x, clamped at its lower end, notched from above.
const Vec3 kBar(0.4, 0.1, 0.1);
constexpr std::array kBarCells{16, 4, 4};
constexpr double kNotchAt = -0.1125;          // between planes of Kerf's squares
constexpr double kBarGravity = 0.4;           // [m/s^2]: the whole bar sags by 4 % of its length
constexpr std::array kDepths{0, 25, 50, 75};  // [%]

// The slab: drawn apart along x, with an incision across from above.
const Vec3 kSlab(0.3, 0.1, 0.2);
constexpr std::array kSlabCells{13, 4, 7};
constexpr double kIncisionHalf = 0.05;  // [m]
constexpr double kStretch = 0.2;        // of its length
constexpr int kStretchSteps = 100;

// The ball: hangs by the half of a cap around its top, x > 0.
constexpr double kRadius = 0.5;
constexpr int kRows = 8;
constexpr int kPinnedRows = 4;      // of triangles from the top on
constexpr double kBallGravity = 5;  // [m/s^2]

/// The events of a session, in their order.
class Course {
  public:
    int step() const { return step_; }
    void wait(int steps) { step_ += steps; }
    void add(SessionAction action) { events_.push_back({step_, std::move(action), -1}); }
    /// Leads the blade from one pose to another, and takes it away.
    void cut(const Blade& from, const Blade& to, double timeStep) {
        add(MoveBlade{from});
        wait(static_cast<int>(std::ceil((from.a - to.a).norm() / kBladeSpeed / timeStep)));
        add(MoveBlade{to});
        wait(1);
        add(LiftBlade{});
    }
    std::vector<SessionEvent> take() { return std::move(events_); }

  private:
    std::vector<SessionEvent> events_;
    int step_ = 0;
};

Params restingParams(double drag) {
    Params params;
    params.youngsModulus = kModulus;
    params.gravity = Vec3::Zero();
    params.airDrag = drag;
    params.floor.reset();
    return params;
}

SetParam gravityOf(double strength) {
    return {"gravity", Vec3(0, -strength, 0)};
}

/// A blade along z at this place of x and y.
Blade bladeAt(double x, double y, double half) {
    return {Vec3(x, y, -half), Vec3(x, y, half)};
}

/// A plane x of a body at rest.
Bounds planeAt(double x, const Vec3& size) {
    Bounds plane{{x, -size.y() / 2, -size.z() / 2}, {x, size.y() / 2, size.z() / 2}};
    plane.widen(kHair);
    return plane;
}

SolidProblem problemOf(SolidMesh mesh, double gravity) {
    SolidProblem problem;
    problem.mesh = std::move(mesh);
    problem.material = NeoHookean::of(kModulus, kFemPoissonRatio);
    problem.density = Params().density;
    problem.gravity = Vec3(0, -gravity, 0);
    problem.held.resize(problem.mesh.nodes.size());
    return problem;
}

/// Holds the nodes on a plane across x, moved along x.
void holdPlane(SolidProblem& problem, double x, double by) {
    for (std::size_t n = 0; n < problem.mesh.nodes.size(); ++n) {
        const Vec3& p = problem.mesh.nodes[n];
        if (p.x() == x) {
            problem.held[n] = heldAt(p + by * Vec3::UnitX());
        }
    }
}

// --- The bar

SolidProblem barSolid(int depth, int fineness) {
    const Vec3 half = kBar / 2;
    const double bottom = half.y() - kBar.y() * depth / 100;
    const std::optional<Slit> slit =
        depth > 0 ? std::optional(Slit{kNotchAt, bottom, kBar.z()}) : std::nullopt;
    SolidProblem problem =
        problemOf(solidBox({gridLinesThrough(-half.x(), kNotchAt, half.x(), 2 * fineness),
                            evenGridLines(-half.y(), half.y(), 4 * fineness),
                            evenGridLines(-half.z(), half.z(), 2 * fineness)},
                           slit),
                  kBarGravity);
    holdPlane(problem, -half.x(), 0);
    return problem;
}

FemCase barCase(int depth) {
    FemCase bar;
    bar.name = fmt::format("bar-{}", depth);
    bar.body = "notched bar";
    bar.cut = depth == 0 ? "none" : fmt::format("{} % of its height", depth);
    bar.model = boxSurface(kBar, kBarCells);
    bar.params = restingParams(kDrag);
    const double top = kBar.y() / 2;
    Course course;
    course.add(Pin{planeAt(-kBar.x() / 2, kBar)});
    if (depth > 0) {
        const double half = kBar.z() / 2 + kClearance;
        course.cut(bladeAt(kNotchAt, top + kClearance, half),
                   bladeAt(kNotchAt, top - kBar.y() * depth / 100, half), bar.params.timeStep);
        bar.cutPlane = kNotchAt;
        bar.opens = true;
    }
    course.add(gravityOf(kBarGravity));
    bar.loaded = course.step();
    bar.events = course.take();
    bar.pinned = Vec3(-kBar.x() / 2, 0, 0);
    bar.probe = planeAt(kBar.x() / 2, kBar);
    bar.solid = barSolid(depth, 2);
    bar.coarseSolid = barSolid(depth, 1);
    return bar;
}

// --- The slab

SolidProblem slabSolid(bool cut, int fineness) {
    const Vec3 half = kSlab / 2;
    const std::optional<Slit> slit = cut ? std::optional(Slit{0, 0, kIncisionHalf}) : std::nullopt;
    SolidProblem problem =
        problemOf(solidBox({gridLinesThrough(-half.x(), 0, half.x(), 3 * fineness),
                            evenGridLines(-half.y(), half.y(), 2 * fineness),
                            evenGridLines(-half.z(), half.z(), 4 * fineness)},
                           slit),
                  0);
    holdPlane(problem, -half.x(), 0);
    holdPlane(problem, half.x(), kStretch * kSlab.x());
    problem.loadSteps = 3;
    return problem;
}

/// Draws one end away in small ways, while the other one stays: what is pinned moves as a whole, so
/// the other end is free of pins meanwhile, for no time.
void drawApart(Course& course) {
    const Bounds still = planeAt(-kSlab.x() / 2, kSlab);
    for (int i = 0; i < kStretchSteps; ++i) {
        course.add(Pin{still, false});
        course.add(MovePins{kStretch * kSlab.x() / kStretchSteps * Vec3::UnitX()});
        course.add(Pin{still});
        course.wait(1);
    }
}

FemCase slabCase(bool cut) {
    FemCase slab;
    slab.name = cut ? "slab-incised" : "slab-whole";
    slab.body = "slab drawn apart";
    slab.cut = cut ? "incision" : "none";
    slab.model = boxSurface(kSlab, kSlabCells);
    slab.params = restingParams(kDrag);
    Course course;
    if (cut) {
        course.cut(bladeAt(0, kSlab.y() / 2 + kClearance, kIncisionHalf),
                   bladeAt(0, 0, kIncisionHalf), slab.params.timeStep);
        slab.cutPlane = 0;
        slab.opens = true;
    }
    course.add(Pin{planeAt(kSlab.x() / 2, kSlab)});
    course.add(Pin{planeAt(-kSlab.x() / 2, kSlab)});
    drawApart(course);
    slab.loaded = course.step();
    slab.events = course.take();
    slab.pinned = Vec3(-kSlab.x() / 2, 0, 0);
    slab.solid = slabSolid(cut, 2);
    slab.coarseSolid = slabSolid(cut, 1);
    return slab;
}

// --- The ball

/// The large triangles of its skin alone, whose sides are cut in half for the elements.
TriangleSoup largeTriangles(const SolidMesh& solid) {
    TriangleSoup soup{solid.nodes, {}, {}};
    for (std::size_t i = 0; i < solid.skin.size(); i += 4) {
        soup.triangles.push_back({solid.skin[i][0], solid.skin[i + 1][1], solid.skin[i + 2][2]});
    }
    return weldExactly(soup);
}

/// Where pins hold the ball: a corner of its skin is one of the first rows from the top on one
/// side.
Bounds capOfBall() {
    const double below = kRows - kPinnedRows;  // of the lowest of them, on an axis
    const double height = kRadius * below / std::hypot(below, kPinnedRows);
    Bounds cap{{0, height, -kRadius}, {kRadius, kRadius, kRadius}};
    cap.widen(kHair);
    cap.low.x() = kHair;  // none on the plane of the cut
    return cap;
}

/// Holds what lies on triangles whose corners are all pinned.
void holdCap(SolidProblem& problem) {
    const Region cap = capOfBall();
    const SolidMesh& mesh = problem.mesh;
    const auto hold = [&](int n) { problem.held[n] = heldAt(mesh.nodes[n]); };
    for (std::size_t i = 0; i < mesh.skin.size(); i += 4) {
        const auto& [a, ab, ca] = mesh.skin[i];
        const int b = mesh.skin[i + 1][1];
        const auto& [first, bc, c] = mesh.skin[i + 2];
        const auto isPinned = [&](int n) { return contains(cap, mesh.nodes[n]); };
        for (const auto& [from, middle, to] :
             {std::array{a, ab, b}, std::array{b, bc, c}, std::array{c, ca, a}}) {
            if (isPinned(from) && isPinned(to)) {
                hold(from);
                hold(middle);
                hold(to);
            }
        }
    }
}

SolidProblem ballSolid(bool half, int layers) {
    SolidProblem problem = problemOf(solidBall(kRadius, kRows, layers, half), kBallGravity);
    holdCap(problem);
    return problem;
}

FemCase ballCase(bool half) {
    FemCase ball;
    ball.name = half ? "ball-half" : "ball-whole";
    ball.body = "hanging ball";
    ball.cut = half ? "in half" : "none";
    ball.model = largeTriangles(solidBall(kRadius, kRows, 1, false));
    ball.params = restingParams(kDrag);
    ball.params.floor = -4 * kRadius;
    Course course;
    course.add(Pin{capOfBall()});
    if (half) {
        const double reach = kRadius + kClearance;
        course.cut(bladeAt(0, reach, reach), bladeAt(0, -reach, reach), ball.params.timeStep);
        ball.cutPlane = 0;
    }
    course.add(gravityOf(kBallGravity));
    ball.loaded = course.step();
    ball.events = course.take();
    const Bounds cap = capOfBall();
    ball.pinned = Vec3(cap.center().x(), kRadius, 0);
    ball.hangs = true;
    ball.solid = ballSolid(half, 3);
    ball.coarseSolid = ballSolid(half, 2);
    return ball;
}

}  // namespace

std::vector<FemCase> femCases() {
    std::vector<FemCase> cases;
    cases.reserve(kDepths.size() + 4);
    for (const int depth : kDepths) {
        cases.push_back(barCase(depth));
    }
    for (const bool cut : {false, true}) {
        cases.push_back(slabCase(cut));
    }
    for (const bool half : {false, true}) {
        cases.push_back(ballCase(half));
    }
    return cases;
}

FemCase femCase(const std::string& name) {
    for (FemCase& each : femCases()) {
        if (each.name == name) {
            return std::move(each);
        }
    }
    throw std::invalid_argument("there is no case " + name);
}

}  // namespace kerf::app
