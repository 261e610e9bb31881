#include "bench/lab/hollow_session.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "sim/mesh/invariants.h"

namespace kerf::app {

namespace {

// Shares of the body's diagonal.
constexpr double kReach = 0.1;  // that a hand holds, and that it stays away from the cut
constexpr double kPull = 0.1;   // of each hand
// The view: along the blade, from where it came and from beside it, so that it hides little.
constexpr double kAlong = 0.75;
constexpr double kBehind = 0.6;
constexpr double kBeside = 0.2;
constexpr double kNearer = 0.62;  // distance, over that of the session's own view

/// A stroke in which a picture is taken.
struct PicturedStroke {
    SessionEvent first;    ///< pose of the blade
    SessionEvent last;     ///< pose of the blade
    SessionEvent picture;  ///< between both
};

Vec3 middleOf(const SessionEvent& pose) {
    const Blade& blade = std::get<MoveBlade>(pose.action).blade;
    return 0.5 * (blade.a + blade.b);
}

/// The plane of a stroke: unit vectors, of which `across` is its normal.
struct StrokeFrame {
    explicit StrokeFrame(const PicturedStroke& stroke) : middle(middleOf(stroke.first)) {
        const Blade& blade = std::get<MoveBlade>(stroke.first.action).blade;
        along = (blade.b - blade.a).normalized();
        ahead = (middleOf(stroke.last) - middle).normalized();
        across = along.cross(ahead).normalized();
    }

    Vec3 middle;  ///< of the blade at first [m]
    Vec3 along;   ///< the blade
    Vec3 ahead;   ///< where it goes
    Vec3 across;  ///< the plane
};

std::optional<PicturedStroke> findStroke(const Session& session) {
    std::vector<SessionEvent> poses;
    std::vector<SessionEvent> pictures;
    for (const SessionEvent& event : session.events) {
        if (std::holds_alternative<MoveBlade>(event.action)) {
            poses.push_back(event);
        } else if (std::holds_alternative<ScreenshotEvent>(event.action)) {
            pictures.push_back(event);
        }
    }
    if (poses.size() < 2) {
        return std::nullopt;
    }
    const auto found = std::ranges::find_if(pictures, [&](const SessionEvent& picture) {
        return picture.step > poses.front().step && picture.step < poses[1].step;
    });
    return found == pictures.end() ? std::nullopt
                                   : std::optional(PicturedStroke{poses.front(), poses[1], *found});
}

/// The point of the skin on one side of the stroke (1 or -1) where the blade comes first, at least
/// `gap` [m] beside it.
std::optional<Vec3> lipOf(const SurfaceMesh& mesh, const StrokeFrame& stroke, int side,
                          double gap) {
    std::optional<Vec3> lip;
    double least = std::numeric_limits<double>::max();
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const Vec3 way = mesh.position(v) - stroke.middle;
        const double beside = side * way.dot(stroke.across);
        const double late = way.dot(stroke.ahead) + beside + std::abs(way.dot(stroke.along));
        if (beside >= gap && late < least) {
            least = late;
            lip = mesh.position(v);
        }
    }
    return lip;
}

/// The vector, or against it, that points towards `way`.
Vec3 towards(const Vec3& way, const Vec3& vector) {
    return way.dot(vector) < 0 ? Vec3(-vector) : vector;
}

render::Camera viewInto(const StrokeFrame& stroke, const Vec3& target, render::Camera camera) {
    const Vec3 arm = camera.eye - camera.target;
    const Vec3 direction = kAlong * towards(arm, stroke.along) - kBehind * stroke.ahead +
                           kBeside * towards(arm, stroke.across);
    camera.target = target;
    camera.eye = target + kNearer * arm.norm() * direction.normalized();
    return camera;
}

/// The lips on both sides, which two hands hold.
struct Lips {
    std::array<Vec3, 2> points;
    std::array<Vec3, 2> ways;  ///< of the hands [m]
    double reach = 0;          ///< of the hands [m]
};

std::optional<Lips> findLips(const SurfaceMesh& mesh, const StrokeFrame& stroke, double diagonal) {
    Lips lips;
    lips.reach = kReach * diagonal;
    for (const int hand : {0, 1}) {
        const int side = 1 - 2 * hand;
        const std::optional<Vec3> lip = lipOf(mesh, stroke, side, lips.reach);
        if (!lip) {
            return std::nullopt;
        }
        lips.points[hand] = *lip;
        lips.ways[hand] = side * kPull * diagonal * stroke.across;
    }
    return lips;
}

std::vector<SessionEvent> eventsOf(const PicturedStroke& stroke, const Lips& lips) {
    const int begin = stroke.first.step;
    const int end = stroke.picture.step;
    const auto& picture = std::get<ScreenshotEvent>(stroke.picture.action);
    return {{begin, Grab{0, lips.points[0], lips.reach}},
            {begin, Grab{1, lips.points[1], lips.reach}},
            stroke.first,
            {end, Drag{0, lips.points[0] + lips.ways[0]}},
            {end, Drag{1, lips.points[1] + lips.ways[1]}},
            {end, ScreenshotEvent{kHollowFile, picture.width, picture.height}},
            stroke.last};
}

}  // namespace

std::optional<Session> hollowSession(const Session& session, const SurfaceMesh& mesh) {
    const std::optional<PicturedStroke> stroke = findStroke(session);
    if (!stroke) {
        return std::nullopt;
    }
    const Bounds bounds = meshBounds(mesh);
    const StrokeFrame frame(*stroke);
    const std::optional<Lips> lips = findLips(mesh, frame, bounds.diagonal());
    if (!lips) {
        return std::nullopt;
    }
    Session hollow = session;
    hollow.steps = stroke->picture.step;
    hollow.events = eventsOf(*stroke, *lips);
    const Vec3 between = 0.5 * (lips->points[0] + lips->points[1]);
    hollow.view =
        viewInto(frame, 0.5 * (between + bounds.center()), sessionCamera(session, bounds));
    return hollow;
}

}  // namespace kerf::app
