#include "app/tools/gizmo.h"

#include <spdlog/fmt/fmt.h>

#include <Eigen/Geometry>

#include "sim/base/text.h"

namespace kerf::app {
namespace {

// In pixels of the picture.
constexpr double kArm = 90;     // length of an arrow
constexpr double kRing = 62;    // radius of a ring
constexpr double kCorner = 78;  // from the middle to the handle that scales, to either side
constexpr double kTipReach = 13;
constexpr double kLineReach = 6;
constexpr double kSnap = 12;  // a step is at least so long

constexpr double kTurnStep = 15;  // [degrees]
constexpr double kFactorStep = 0.1;
constexpr double kEdgeOn = 0.15;     // sine of the angle at which a ring is seen as a line
constexpr double kShortestArm = 24;  // of a pixel at the handle that scales, from the middle [px]
constexpr int kGizmoRingPoints = 48;
constexpr std::array<const char*, 3> kNames{"x", "y", "z"};

std::optional<Vec2> pixelOf(const ViewFrame& view, const Vec3& point) {
    const auto at = view.toPixel(point);
    return at ? std::optional(Vec2(at->x, at->y)) : std::nullopt;
}

/// The length of a pixel at a point [m].
double pixelAt(const ViewFrame& view, const Vec3& point) {
    const Vec2 middle(view.width / 2.0, view.height / 2.0);
    return (view.onPlaneThrough(point, middle + Vec2(1, 0)) - view.onPlaneThrough(point, middle))
        .norm();
}

/// Beyond the side that it would be hidden by.
Vec3 tipAt(const ViewFrame& view, const GizmoFrame& frame, int axis) {
    const double arm = kArm * pixelAt(view, frame.at);
    return frame.at + std::max(arm, frame.half[axis] + 0.5 * arm) * frame.axes.col(axis);
}

ui::PlotPoint plot(const Vec2& pixel) {
    return {pixel.x(), pixel.y()};
}

bool hasSize(const GizmoFrame& frame) {
    return frame.half.maxCoeff() > 0;
}

}  // namespace

// --- Where the parts are -----------------------------------------------------------------------

std::optional<Vec2> Gizmo::tipOf(const ViewFrame& view, const GizmoFrame& frame, int axis) {
    return pixelOf(view, tipAt(view, frame, axis));
}

std::vector<Vec2> Gizmo::ringOf(const ViewFrame& view, const GizmoFrame& frame, int axis) {
    const double radius = kRing * pixelAt(view, frame.at);
    const Vec3 u = radius * frame.axes.col((axis + 1) % 3);
    const Vec3 v = radius * frame.axes.col((axis + 2) % 3);
    std::vector<Vec2> pixels;
    for (int i = 0; i <= kGizmoRingPoints; ++i) {
        const double angle = 2 * std::numbers::pi * i / kGizmoRingPoints;
        if (const auto at = pixelOf(view, frame.at + std::cos(angle) * u + std::sin(angle) * v)) {
            pixels.push_back(*at);
        }
    }
    return pixels;
}

std::optional<Vec2> Gizmo::faceOf(const ViewFrame& view, const GizmoFrame& frame, int axis,
                                  int side) {
    return pixelOf(view, frame.at + side * frame.half[axis] * frame.axes.col(axis));
}

std::optional<Vec2> Gizmo::cornerOf(const ViewFrame& view, const GizmoFrame& frame) {
    const std::optional<Vec2> middle = pixelOf(view, frame.at);
    return middle ? std::optional(Vec2(*middle + Vec2(kCorner, -kCorner))) : std::nullopt;
}

/// Handles first, then arrows, then rings.
Gizmo::Part Gizmo::partAt(const ViewFrame& view, const Vec2& pixel, const GizmoFrame& frame) {
    Part found;
    double least = 1;
    const auto look = [&](const Part& part, double away, double reach) {
        if (away / reach < least) {
            least = away / reach;
            found = part;
        }
    };
    const auto lookAt = [&](const Part& part, const std::optional<Vec2>& at) {
        if (at) {
            look(part, (*at - pixel).norm(), kTipReach);
        }
    };
    for (int axis = 0; axis < 3; ++axis) {
        lookAt({Kind::arrow, axis}, tipOf(view, frame, axis));
        for (const int side : {1, -1}) {
            if (hasSize(frame)) {
                lookAt({Kind::face, axis, side}, faceOf(view, frame, axis, side));
            }
        }
    }
    if (frame.scales) {
        lookAt({Kind::corner}, cornerOf(view, frame));
    }
    if (found.kind != Kind::none) {
        return found;
    }
    const std::optional<Vec2> middle = pixelOf(view, frame.at);
    for (int axis = 0; axis < 3; ++axis) {
        const std::optional<Vec2> tip = tipOf(view, frame, axis);
        if (middle && tip) {
            look({Kind::arrow, axis}, distanceToLine(pixel, *middle, *tip), kLineReach);
        }
        const std::vector<Vec2> ring = ringOf(view, frame, axis);
        for (std::size_t i = 1; i < ring.size(); ++i) {
            look({Kind::ring, axis}, distanceToLine(pixel, ring[i - 1], ring[i]), kLineReach);
        }
    }
    return found;
}

bool Gizmo::isAt(const ViewFrame& view, const Vec2& pixel, const GizmoFrame& frame) {
    return partAt(view, pixel, frame).kind != Kind::none;
}

// --- A drag ------------------------------------------------------------------------------------

bool Gizmo::press(const ViewFrame& view, const Vec2& pixel, const GizmoFrame& frame) {
    const Part part = partAt(view, pixel, frame);
    if (part.kind != Kind::none) {
        held_ = Held{part, frame, pixel, pixel, 0, ""};
    }
    return part.kind != Kind::none;
}

GizmoChange Gizmo::moved(const ViewFrame& view, const Vec2& pixel, bool snaps) {
    switch (held_->part.kind) {
        case Kind::arrow:
            return shifted(view, pixel, snaps);
        case Kind::ring:
            return turned(view, pixel, snaps);
        case Kind::face:
            return sized(view, pixel, snaps);
        case Kind::corner:
            return scaled(view, pixel, snaps);
        case Kind::none:
            break;
    }
    return {};
}

/// Along the axis that is held, since the press [m].
std::optional<double> Gizmo::shiftOf(const ViewFrame& view, const Vec2& pixel) const {
    const Vec3 axis = held_->frame.axes.col(held_->part.axis);
    const auto from = alongAxis(view.rayThrough(held_->from), held_->frame.at, axis);
    const auto to = alongAxis(view.rayThrough(pixel), held_->frame.at, axis);
    return from && to ? std::optional(*to - *from) : std::nullopt;
}

GizmoChange Gizmo::shifted(const ViewFrame& view, const Vec2& pixel, bool snaps) {
    double shift = shiftOf(view, pixel).value_or(0);
    if (snaps) {
        shift = snapped(shift, roundStep(kSnap * pixelAt(view, held_->frame.at)));
    }
    held_->label = std::string(kNames[held_->part.axis]) + (shift < 0 ? " \u2212" : " +") +
                   lengthText(std::abs(shift));
    return {.by = shift * held_->frame.axes.col(held_->part.axis)};
}

GizmoChange Gizmo::turned(const ViewFrame& view, const Vec2& pixel, bool snaps) {
    const GizmoFrame& frame = held_->frame;
    const Vec3 axis = frame.axes.col(held_->part.axis);
    const double towards = axis.dot(view.camera.towardsEye(frame.at).normalized());
    const std::optional<Vec2> middle = pixelOf(view, frame.at);
    const std::optional<Vec2> end =
        pixelOf(view, frame.at + kRing * pixelAt(view, frame.at) * axis);
    if (middle && end && std::abs(towards) < kEdgeOn) {
        // Seen as a line, a ring turns by the way along it.
        const Vec2 along = (*end - *middle).normalized();
        const Vec2 way = pixel - held_->last;
        held_->turned +=
            (along.x() * way.y() - along.y() * way.x()) / kRing * 180 / std::numbers::pi;
    } else {
        held_->turned +=
            turnAbout(frame.at, axis, view.rayThrough(held_->last), view.rayThrough(pixel))
                .value_or(0);
    }
    held_->last = pixel;
    const double degrees = snaps ? snapped(held_->turned, kTurnStep) : held_->turned;
    held_->label = fmt::format("{} {:+.1f}\u00b0", kNames[held_->part.axis], degrees);
    return {.turn = Eigen::AngleAxisd(degrees * std::numbers::pi / 180, axis).toRotationMatrix()};
}

/// The other side stays.
GizmoChange Gizmo::sized(const ViewFrame& view, const Vec2& pixel, bool snaps) {
    const auto& [kind, axis, side] = held_->part;
    const double before = 2 * held_->frame.half[axis];
    const double pixelLength = pixelAt(view, held_->frame.at);
    double size = before + side * shiftOf(view, pixel).value_or(0);
    if (snaps) {
        size = snapped(size, roundStep(kSnap * pixelLength));
    }
    size = std::max(size, pixelLength);
    held_->label = std::string(kNames[axis]) + " " + lengthText(size);
    GizmoChange change;
    change.grow[axis] = size - before;
    change.by = side * 0.5 * (size - before) * held_->frame.axes.col(axis);
    return change;
}

GizmoChange Gizmo::scaled(const ViewFrame& view, const Vec2& pixel, bool snaps) {
    const std::optional<Vec2> middle = pixelOf(view, held_->frame.at);
    if (!middle) {
        return {};
    }
    const double before = std::max(kShortestArm, (held_->from - *middle).norm());
    double factor = std::max(kShortestArm, (pixel - *middle).norm()) / before;
    if (snaps) {
        factor = std::max(kFactorStep, snapped(factor, kFactorStep));
    }
    held_->label = fmt::format("\u00d7 {:.3g}", factor);
    return {.factor = factor};
}

// --- The picture -------------------------------------------------------------------------------

void Gizmo::addTo(ui::Overlay& overlay, const ViewFrame& view, const Vec2& pixel,
                  const GizmoFrame& frame) const {
    const std::optional<Vec2> middle = pixelOf(view, frame.at);
    if (!middle) {
        return;
    }
    const Part hot = held_ ? held_->part : partAt(view, pixel, frame);
    for (int axis = 0; axis < 3; ++axis) {
        const bool ringIsHot = hot == Part{Kind::ring, axis};
        const std::vector<Vec2> ring = ringOf(view, frame, axis);
        for (std::size_t i = 1; i < ring.size(); ++i) {
            overlay.axisLines.push_back({{plot(ring[i - 1]), plot(ring[i])}, axis, ringIsHot});
        }
        if (const auto tip = tipOf(view, frame, axis)) {
            const bool isTipHot = hot == Part{Kind::arrow, axis};
            overlay.axisLines.push_back({{plot(*middle), plot(*tip)}, axis, isTipHot});
            overlay.axisDots.push_back({plot(*tip), axis, isTipHot, false});
        }
        for (const int side : {1, -1}) {
            if (const auto face = faceOf(view, frame, axis, side); face && hasSize(frame)) {
                overlay.axisDots.push_back(
                    {plot(*face), axis, hot == Part{Kind::face, axis, side}, true});
            }
        }
    }
    if (const auto corner = cornerOf(view, frame); corner && frame.scales) {
        overlay.axisDots.push_back({plot(*corner), -1, hot == Part{Kind::corner}, true});
    }
    if (held_ && !held_->label.empty()) {
        overlay.labels.push_back({plot(*middle), held_->label});
    }
}

namespace {

constexpr double kSlanted = 0.2;  // sine of the least angle between the line of sight and an axis

/// From the center to where a ray meets the plane across the axis.
std::optional<Vec3> armTo(const Vec3& center, const Vec3& axis, const render::Ray& ray) {
    const double slope = ray.direction.dot(axis);
    const double way = slope == 0 ? -1 : (center - ray.origin).dot(axis) / slope;
    return way > 0 ? std::optional(Vec3(ray.origin + way * ray.direction - center)) : std::nullopt;
}

}  // namespace

std::optional<double> alongAxis(const render::Ray& ray, const Vec3& point, const Vec3& axis) {
    const double along = ray.direction.dot(axis);
    const double square = 1 - along * along;
    if (square < kSlanted * kSlanted) {
        return std::nullopt;
    }
    const Vec3 offset = ray.origin - point;
    return (offset.dot(axis) - along * offset.dot(ray.direction)) / square;
}

std::optional<double> turnAbout(const Vec3& center, const Vec3& axis, const render::Ray& from,
                                const render::Ray& to) {
    const std::optional<Vec3> a = armTo(center, axis, from);
    const std::optional<Vec3> b = armTo(center, axis, to);
    if (!a || !b) {
        return std::nullopt;
    }
    return std::atan2(axis.dot(a->cross(*b)), a->dot(*b)) * 180 / std::numbers::pi;
}

double distanceToLine(const Vec2& pixel, const Vec2& from, const Vec2& to) {
    const Vec2 line = to - from;
    const double square = line.squaredNorm();
    const double share = square > 0 ? std::clamp((pixel - from).dot(line) / square, 0.0, 1.0) : 0.0;
    return (pixel - from - share * line).norm();
}

double snapped(double value, double step) {
    return step * std::round(value / step);
}

double roundStep(double least) {
    const double decade = std::pow(10, std::floor(std::log10(least)));
    for (const double digit : {1.0, 2.0, 5.0}) {
        if (digit * decade >= least * (1 - 1e-9)) {
            return digit * decade;
        }
    }
    return 10 * decade;
}

}  // namespace kerf::app
