#include "app/practice/task_line.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/mesh/ray_box.h"

namespace kerf::app {

namespace {

constexpr double kLongestStep = 5e-4;  // of sections [m]
constexpr double kFewestSteps = 100;
constexpr double kGrazing = 1e-9;
constexpr double kAtEnd = 1e-3;  // of the line: so little beyond its end is at it
constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// How far from `point` the line along `into` first meets the body, from outside.
double firstHit(const SurfaceMesh& mesh, const std::vector<int>& body, const Vec3& point,
                const Vec3& into) {
    double first = kInfinite;
    for (const int t : body) {
        const auto hit = hitOf(restCornersOf(mesh, t), point, into, kGrazing);
        first = hit ? std::min(first, hit->distance) : first;
    }
    return first;
}

}  // namespace

std::vector<int> trianglesOfModel(int model, const SurfaceMesh& mesh,
                                  std::span<const int> members) {
    std::vector<int> triangles = livingTriangles(mesh);
    std::erase_if(triangles, [&](int t) { return members[t] != model; });
    return triangles;
}

LineCurve::LineCurve(const TaskLine& line)
    : line_(line), into_(line.into.stableNormalized()), starts_{0} {
    std::ranges::transform(line.points, std::back_inserter(points_),
                           [&](const Vec3& x) { return flat(x); });
    if (line.closed) {
        points_.push_back(points_.front());
    }
    for (std::size_t i = 1; i < points_.size(); ++i) {
        starts_.push_back(length() + (points_[i] - points_[i - 1]).norm());
    }
}

PlaceAtLine LineCurve::nearest(const Vec3& x) const {
    const double slack = kAtEnd * length();
    PlaceAtLine found{kInfinite, false};
    for (std::size_t i = 1; i < points_.size(); ++i) {
        const double way = starts_[i] - starts_[i - 1];
        const Vec3 along = (points_[i] - points_[i - 1]) / way;
        const double s = (flat(x) - points_[i - 1]).dot(along);
        const double distance = (points_[i - 1] + std::clamp(s, 0.0, way) * along - flat(x)).norm();
        if (distance < found.distance) {
            const bool isBefore = i == 1 && s < -slack;
            const bool isBehind = i + 1 == points_.size() && s > way + slack;
            found = {distance, !line_.closed && (isBefore || isBehind)};
        }
    }
    return found;
}

double LineCurve::sectionStep() const {
    return length() / std::ceil(std::max(kFewestSteps, length() / kLongestStep));
}

LineSection LineCurve::sectionAt(double s) const {
    const std::size_t i = std::ranges::upper_bound(starts_, s) - starts_.begin();
    const Vec3 along = (points_[i] - points_[i - 1]).stableNormalized();
    return {line_.closed ? kInfinite : std::min(s, length() - s),
            points_[i - 1] + (s - starts_[i - 1]) * along, along, along.cross(into_)};
}

std::vector<LineSection> LineCurve::sections(const SurfaceMesh& uncut,
                                             std::span<const int> members) const {
    const std::vector<int> body = trianglesOfModel(line_.model, uncut, members);
    std::vector<LineSection> sections;
    for (double s = sectionStep() / 2; s < length(); s += sectionStep()) {
        LineSection section = sectionAt(s);
        const double way = firstHit(uncut, body, section.top, into_);
        if (way < kInfinite) {
            section.top += way * into_;
            sections.push_back(section);
        }
    }
    return sections;
}

}  // namespace kerf::app
