#include "app/editor/view/new_task.h"

#include <spdlog/fmt/fmt.h>

#include "app/practice/score.h"
#include "app/scene/readout/cut_preview.h"
#include "app/session/task_run.h"
#include "sim/base/text.h"
#include "sim/mesh/triangle.h"
#include "sim/mesh/triangle_quality.h"
#include "sim/run/start/prepared_body.h"

namespace kerf::app {
namespace {

constexpr double kDeviation = 0.03;  // allowed, of the length of a line
constexpr double kSmooth = 0.25;     // of it: what a line leaves out of a hand's path
constexpr double kEnds = 2;          // of it: uncut, or beyond the ends
constexpr double kReach = 4;         // of it
constexpr double kLeastCut = 1e-3;   // of the body's size: a shorter one is a slip

/// Where a stroke met the skin.
struct SkinPath {
    std::vector<Vec3> points;
    std::vector<double> depths;  ///< below it; none where the blade came out at the other side
    Vec3 into = Vec3::Zero();
    int model = 0;

    double length() const {
        double sum = 0;
        for (std::size_t i = 1; i < points.size(); ++i) {
            sum += (points[i] - points[i - 1]).norm();
        }
        return sum;
    }
};

void addPose(const Blade& blade, const Vec3& eye, const UncutBody& uncut,
             std::span<const int> triangles, SkinPath& path) {
    const bool fromA = (blade.a - eye).norm() < (blade.b - eye).norm();
    const Vec3& outer = fromA ? blade.a : blade.b;
    const Vec3& inner = fromA ? blade.b : blade.a;
    const double length = (inner - outer).norm();
    const Vec3 into = (inner - outer).stableNormalized();
    const auto entry = pickSurface(uncut.mesh, triangles, {outer, into});
    const double below = entry ? length - (entry->position - outer).norm() : -1;
    if (below <= 0) {
        return;  // beside the body, or above it
    }
    path.points.push_back(entry->position);
    path.into += into;
    path.model = uncut.modelOf(uncut.mesh.triangle(entry->triangle)[0]);
    const auto exit = pickSurface(uncut.mesh, triangles, {inner, -into});
    if (!exit || (exit->position - inner).norm() > (1 - 1e-6) * below) {
        path.depths.push_back(below);
    }
}

/// Keeps the ends, and between them what is farther than `off` from the line through those kept:
/// Douglas and Peucker 1973.
std::vector<Vec3> simplified(std::span<const Vec3> points, double off) {
    if (points.size() < 3) {
        return {points.begin(), points.end()};
    }
    const Vec3 way = points.back() - points.front();
    std::size_t farthest = 0;
    double most = off;
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        const Vec3 to = points[i] - points.front();
        const double along =
            way.isZero(0) ? 0 : std::clamp(to.dot(way) / way.squaredNorm(), 0., 1.);
        const double away = (to - along * way).norm();
        if (away > most) {
            most = away;
            farthest = i;
        }
    }
    if (farthest == 0) {
        return {points.front(), points.back()};
    }
    std::vector<Vec3> line = simplified(points.first(farthest + 1), off);
    line.pop_back();
    std::ranges::copy(simplified(points.subspan(farthest), off), std::back_inserter(line));
    return line;
}

/// To one digit, as people set limits.
double rounded(double value) {
    const double digit = std::pow(10, std::floor(std::log10(value)));
    return std::max(1.0, std::round(value / digit)) * digit;
}

TaskLine lineOf(const SkinPath& path, double deviation) {
    TaskLine line{simplified(path.points, kSmooth * deviation)};
    const double gap = (line.points.back() - line.points.front()).norm();
    line.closed = line.points.size() > 3 && gap < kEnds * deviation;
    if (line.closed) {
        line.points.pop_back();
    }
    return line;
}

double meanEdgeOf(const SurfaceMesh& mesh) {
    TriangleFigures figures;
    for (const int t : livingTriangles(mesh)) {
        figures.add(cornersOf(mesh, t));
    }
    return figures.meanEdge();
}

/// The typical depth; none where most poses went right through.
std::optional<double> depthOf(const std::vector<SkinPath>& paths) {
    std::vector<double> depths;
    std::size_t poses = 0;
    for (const SkinPath& path : paths) {
        poses += path.points.size();
        std::ranges::copy(path.depths, std::back_inserter(depths));
    }
    if (2 * depths.size() < poses) {
        return std::nullopt;
    }
    const auto middle = depths.begin() + std::ssize(depths) / 2;
    std::ranges::nth_element(depths, middle);
    return std::round(*middle * 1e4) / 1e4;  // [m], to a tenth of a millimetre
}

std::vector<SkinPath> pathsOf(const Session& done, const UncutBody& uncut, const Vec3& eye) {
    const std::vector<int> triangles = livingTriangles(uncut.mesh);
    std::vector<SkinPath> paths;
    for (const HandPose& pose : handOf(done)) {
        if (pose.begins || paths.empty()) {
            paths.emplace_back();
        }
        addPose(pose.blade, eye, uncut, triangles, paths.back());
    }
    const double least = kLeastCut * meshBounds(uncut.mesh).diagonal();
    std::erase_if(paths, [&](const SkinPath& path) { return path.length() <= least; });
    return paths;
}

}  // namespace

std::variant<Task, std::string> taskOfCuts(const Session& done, const UncutBody& uncut,
                                           const Vec3& eye) {
    const std::vector<SkinPath> paths = pathsOf(done, uncut, eye);
    if (paths.empty()) {
        return "Nothing was cut yet. Cut the model once as the task is to be done.";
    }
    if (paths.size() > kMostOfTask) {
        return fmt::format("A task has at most {} lines, and you made {} cuts. Undo some.",
                           kMostOfTask, paths.size());
    }
    Task task;
    const double deviation =
        rounded(kDeviation * std::ranges::max(paths, {}, &SkinPath::length).length());
    task.into = Vec3::Zero();
    for (const SkinPath& path : paths) {
        task.lines.push_back(lineOf(path, deviation));
        task.into += path.into;
    }
    task.into.normalize();
    task.model = paths.front().model;
    task.depth = depthOf(paths);
    task.band = task.depth ? kBand * *task.depth : 0;
    task.reach = kReach * deviation;
    task.limits.deviation = deviation;
    // A blade that cuts like a real one begins and ends an edge late.
    task.limits.ends = rounded(std::max(kEnds * deviation, meanEdgeOf(uncut.mesh)));
    task.limits.inBand = task.depth ? std::optional(kInBand) : std::nullopt;
    for (int model = 0; model < int(uncut.models.size()); ++model) {
        if (model != task.model) {
            task.spare.push_back(model);
        }
    }
    task.name = task.depth ? "Incision" : "Cut";
    task.about = aboutOf(task);
    return task;
}

std::string aboutOf(const Task& task) {
    return "Cut along the line" + std::string(task.lines.size() > 1 ? "s" : "") +
           (task.depth ? ", " + millimetreText(*task.depth) + " deep." : ", right through.");
}

Session beforeCuts(Session done) {
    const auto cut = std::ranges::find_if(done.events, [](const SessionEvent& event) {
        return std::holds_alternative<MoveBlade>(event.action);
    });
    done.steps = cut == done.events.end() ? done.steps : cut->step;
    done.events.erase(cut, done.events.end());
    std::erase_if(done.events, [](const SessionEvent& event) {
        return std::holds_alternative<CheckEvent>(event.action);
    });
    return done;
}

}  // namespace kerf::app
