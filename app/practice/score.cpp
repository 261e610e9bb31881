#include "app/practice/score.h"

#include <spdlog/fmt/fmt.h>

#include <nlohmann/json.hpp>

#include "sim/base/math.h"
#include "sim/mesh/triangle.h"

namespace kerf::app {

namespace {

using Json = nlohmann::ordered_json;

constexpr double kWindow = 0.05;      // of forces, in simulated time [s]
constexpr double kLeastForce = 1e-9;  // [N]: less is rounding

// Whether a task asks for a figure.
constexpr auto kForAll = [](const Task&) { return true; };
constexpr auto kForLines = [](const Task& task) { return !task.lines.empty(); };
constexpr auto kForDepth = [](const Task& task) { return kForLines(task) && task.depth; };
constexpr auto kForTaking = [](const Task& task) { return task.take.has_value(); };
constexpr auto kForMargin = [](const Task& task) {
    return !task.spare.empty() || !task.spareRegions.empty();
};

constexpr FigureUnit kLength{"mm", 1e3, 2};
constexpr FigureUnit kShare{"%", 100, 1};
constexpr FigureUnit kTime{"s", 1, 2};
constexpr FigureUnit kForce{"mN", 1e3, 1};
constexpr FigureUnit kCount{"", 1, 0};
constexpr FigureUnit kFlag{"", 1, 0, true};
constexpr FigureUnit kVolume{"cm³", 1e6, 3};
constexpr FigureUnit kLogarithm{"", 1, 1};

using Limits = TaskLimits;
constexpr FigureRow kRows[] = {
    {"deviation_mean", "Mean deviation", kLength, -1, &Score::deviationMean, &Limits::meanDeviation,
     kForLines},
    {"deviation_max", "Largest deviation", kLength, -1, &Score::deviationMax, &Limits::deviation,
     kForLines},
    {"depth_mean", "Mean depth", kLength, 0, &Score::depthMean},
    {"depth_in_band", "Depth within limits", kShare, 1, &Score::depthInBand, &Limits::inBand,
     kForDepth},
    {"length_under", "Line missed", kLength, -1, &Score::lengthUnder, &Limits::ends, kForLines},
    {"length_over", "Cut off the line", kLength, -1, &Score::lengthOver, &Limits::ends, kForLines},
    {"margin_least", "Least margin", kLength, 1, &Score::marginLeast, &Limits::margin, kForMargin},
    {"spared_cut", "Structures damaged", kCount, -1, &Score::sparedCut, nullptr, kForAll, 0},
    {"taken", "Taken out whole", kFlag, 1, &Score::taken, nullptr, kForTaking, 1},
    {"excised_volume", "Volume taken out", kVolume, -1, &Score::excisedVolume},
    {"time", "Time", kTime, -1, &Score::time, &Limits::seconds},
    {"path", "Path of the hand", kLength, -1, &Score::path},
    {"economy", "Economy of the path", kShare, 1, &Score::economy, &Limits::economy},
    {"smoothness", "Smoothness", kLogarithm, 1, &Score::smoothness, &Limits::smoothness},
    {"tremor", "Tremor", kLength, -1, &Score::tremor},
    {"wobble", "Wobble", kLength, -1, &Score::wobble, &Limits::wobble, kForLines},
    {"idle_time", "Idle time", kTime, -1, &Score::idleTime, &Limits::idle},
    {"force_max", "Largest force", kForce, -1, &Score::forceMax, &Limits::newtons},
    {"force_mean", "Mean force", kForce, -1, &Score::forceMean},
    {"undos", "Undone changes", kCount, -1, &Score::undos, nullptr, kForAll, 0},
    {"changes", "Parameters changed", kCount, -1, &Score::changes, nullptr, kForAll, 0},
};

ForceScore measureForce(std::span<const ForceSample> samples) {
    Curve impulse;  // over time [N s]
    Vec3 sum = Vec3::Zero();
    for (const ForceSample& sample : samples) {
        impulse.add(sample.begin, sum);
        sum += sample.force * (sample.end - sample.begin);
        impulse.add(sample.end, sum);
    }
    Statistics force;
    const double end = samples.empty() ? 0 : samples.back().end;
    for (double k = 0; k * kWindow < end; ++k) {
        const Vec3 gain = impulse((k + 1) * kWindow) - impulse(k * kWindow);
        if (gain.norm() / kWindow > kLeastForce) {
            force.add(gain.norm() / kWindow);
        }
    }
    return {force.most, force.mean};
}

/// How far a point is beside the nearest line within reach, as it is seen along `into`.
std::optional<double> besideLine(const Task& task, const Vec3& point) {
    const Vec3 into = task.into.stableNormalized();
    const auto flat = [&](const Vec3& x) -> Vec3 { return x - x.dot(into) * into; };
    double nearest = task.reach;
    std::optional<double> beside;
    for (const TaskLine& line : task.lines) {
        for (std::size_t i = line.closed ? 0 : 1; i < line.points.size(); ++i) {
            const Vec3& from = line.points[(i == 0 ? line.points.size() : i) - 1];
            const Vec3 way = flat(line.points[i] - from);
            const Vec3 x = flat(point - from);
            const double distance = distanceToSegment(x, Vec3::Zero(), way);
            if (distance <= nearest) {
                nearest = distance;
                beside = x.dot(into.cross(way).stableNormalized());
            }
        }
    }
    return beside;
}

/// "2.41 mm".
std::string withUnit(const FigureUnit& unit, double value) {
    return formatFigure(unit, value) + (*unit.name != 0 ? " " : "") + unit.name;
}

}  // namespace

std::span<const FigureRow> figureRows() {
    return kRows;
}

std::optional<double> valueOf(const FigureRow& row, const Score& score) {
    return score.*row.value;
}

std::optional<double> limitOf(const FigureRow& row, const Task& task) {
    const auto limit = row.limit != nullptr ? task.limits.*row.limit : row.fixedLimit;
    return row.isAsked(task) ? limit : std::nullopt;
}

bool isKept(const FigureRow& row, const Score& score, const Task& task) {
    const std::optional<double> limit = limitOf(row, task);
    const std::optional<double> value = valueOf(row, score);
    return !limit || (value && (row.better > 0 ? *value >= *limit : *value <= *limit));
}

Bounds boxOfLines(const Task& task) {
    return boxOf(task.lines, [](const TaskLine& line) { return boxOf(line.points); });
}

Vec3 pivotOf(const Task& task, const SurfaceMesh& uncut) {
    const Bounds lines = boxOfLines(task);
    return (lines.empty() ? boxOf(uncut.restPositions()) : lines).center();
}

Score scoreOf(const TaskRun& run) {
    const Task& task = run.body.task;
    const MotionScore motion =
        measureMotion(run.hand, pivotOf(task, run.body.uncut), task.path,
                      [&](const Vec3& point) { return besideLine(task, point); });
    Score score{measureCut(run.body), motion, measureForce(run.forces), run.undos, run.changes, {}};
    for (const FigureRow& row : kRows) {
        const std::optional<double> limit = limitOf(row, task);
        const std::optional<double> value = valueOf(row, score);
        if (!isKept(row, score, task)) {
            score.violations.push_back(fmt::format(
                "{}: {} ({}).", row.label, value ? withUnit(row.unit, *value) : "not measured",
                limitText(row, *limit)));
        }
    }
    return score;
}

std::string formatFigure(const FigureUnit& unit, std::optional<double> value) {
    if (value && unit.isFlag) {
        return *value > 0 ? "yes" : "no";
    }
    return value ? fmt::format("{:.{}f}", *value * unit.factor, unit.digits) : "";
}

std::string shortLimit(const FigureRow& row, double limit) {
    const char* const most = row.better > 0 ? "\u2265 " : "\u2264 ";
    return row.unit.isFlag ? formatFigure(row.unit, limit)
                           : fmt::format("{}{:.3g}", most, limit * row.unit.factor);
}

std::string limitText(const FigureRow& row, double limit) {
    const char* const most = row.better > 0 ? "at least" : "at most";
    return fmt::format("{} {}", row.unit.isFlag ? "must be" : most, withUnit(row.unit, limit));
}

nlohmann::ordered_json toJson(const Score& score, const Task& task) {
    Json json{{"task", task.name}, {"person", task.person}, {"date", task.date}};
    Json limits = Json::object();
    for (const FigureRow& row : kRows) {
        const std::optional<double> value = valueOf(row, score);
        if (const auto limit = limitOf(row, task)) {
            limits[row.key] = *limit;
        }
        json[row.key] = !value ? Json() : row.unit.isFlag ? Json(*value > 0) : Json(*value);
    }
    json["limits"] = limits;
    json["violations"] = score.violations;
    json["passed"] = score.passed();
    return json;
}

}  // namespace kerf::app
