#include "app/practice/score.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>

#include "app/practice/mean.h"
#include "sim/base/boxes.h"
#include "sim/base/text.h"

namespace kerf::app {

namespace {

constexpr double kWindow = 0.05;  // of forces, in simulated time [s]
constexpr double kHair = 1e-9;    // [s]: so little of a step is none

using Figure = std::optional<double>;
using Figures = std::vector<Figure>;

template <auto Member>
Figure ofCut(const Score& score) {
    return score.cut.*Member;
}
template <auto Member>
Figure ofMotion(const Score& score) {
    return score.motion.*Member;
}
template <auto Member>
Figure ofForce(const Score& score) {
    return score.force.*Member;
}
template <auto Member>
Figure given(const Task& task) {
    return task.*Member;
}

Figures deviationLimits(const Task& task) {
    Figures limits;
    for (const TaskLine& line : task.lines) {
        limits.push_back(line.deviation);
    }
    return limits;
}

Figures marginLimits(const Task& task) {
    Figures limits;
    for (const SparedModel& spared : task.spare) {
        limits.emplace_back(spared.margin);
    }
    for (const SparedRegion& spared : task.spareRegions) {
        limits.emplace_back(spared.margin);
    }
    return limits;
}

/// The limit of all; none where they differ, and each is judged alone.
Figure sharedOf(const Figures& limits) {
    const bool alike = std::ranges::adjacent_find(limits, std::not_equal_to()) == limits.end();
    return alike && !limits.empty() ? limits.front() : std::nullopt;
}
template <auto Limits>
Figure shared(const Task& task) {
    return sharedOf(Limits(task));
}

/// What may be cut too far or too short: the deviation that is allowed aside, at both ends.
Figure atEnds(const Task& task) {
    Figure sum;
    for (const TaskLine& line : task.lines) {
        sum = line.deviation ? sum.value_or(0) + 2 * *line.deviation : sum;
    }
    return sum;
}

Figure inDepthBand(const Task& task) {
    return std::ranges::any_of(task.lines,
                               [](const TaskLine& line) { return line.depth.has_value(); })
               ? task.inBand
               : std::nullopt;
}
Figure inSliceBand(const Task& task) {
    return task.slice ? task.inBand : std::nullopt;
}

Figure toBeTaken(const Task& task) {
    return task.take ? Figure(1) : std::nullopt;
}

constexpr FigureUnit kLength{"mm", 1e3, 2};
constexpr FigureUnit kShare{"%", 100, 1};
constexpr FigureUnit kTime{"s", 1, 2};
constexpr FigureUnit kForce{"N", 1, 3};

constexpr FigureRow kRows[] = {
    {"deviation_mean", "Mean deviation", kLength, -1, ofCut<&CutScore::deviationMean>},
    {"deviation_max", "Largest deviation", kLength, -1, ofCut<&CutScore::deviationMax>,
     shared<deviationLimits>},
    {"depth_mean", "Mean depth", kLength, 0, ofCut<&CutScore::depthMean>},
    {"depth_in_band", "Depth in its band", kShare, 1, ofCut<&CutScore::depthInBand>, inDepthBand},
    {"length_under", "Not cut", kLength, -1, ofCut<&CutScore::lengthUnder>, atEnds},
    {"length_over", "Cut elsewhere", kLength, -1, ofCut<&CutScore::lengthOver>, atEnds},
    {"margin_least", "Least margin", kLength, 1, ofCut<&CutScore::marginLeast>,
     shared<marginLimits>},
    {"margin_mean", "Mean margin", kLength, 0, ofCut<&CutScore::marginMean>},
    {"taken", "Taken out whole", {"", 1, 0, true}, 1, ofCut<&CutScore::taken>, toBeTaken},
    {"excised_volume", "Volume taken out", {"cm³", 1e6, 3}, -1, ofCut<&CutScore::excisedVolume>},
    {"thickness_mean", "Mean thickness", kLength, 0, ofCut<&CutScore::thicknessMean>},
    {"thickness_in_band", "Thickness in its band", kShare, 1, ofCut<&CutScore::thicknessInBand>,
     inSliceBand},
    {"time", "Time", kTime, -1, ofMotion<&MotionScore::time>, given<&Task::seconds>},
    {"path", "Path of the hand", kLength, -1, ofMotion<&MotionScore::path>},
    {"economy", "Economy of the path", kShare, 1, ofMotion<&MotionScore::economy>,
     given<&Task::economy>},
    {"smoothness",
     "Smoothness",
     {"", 1, 1},
     1,
     ofMotion<&MotionScore::smoothness>,
     given<&Task::smoothness>},
    {"tremor", "Tremor", kLength, -1, ofMotion<&MotionScore::tremor>},
    {"idle_time", "Idle time", kTime, -1, ofMotion<&MotionScore::idleTime>, given<&Task::idle>},
    {"force_max", "Largest force", kForce, -1, ofForce<&ForceScore::largest>,
     given<&Task::newtons>},
    {"force_mean", "Mean force", kForce, -1, ofForce<&ForceScore::mean>},
};

/// The middle of what is to be cut.
Vec3 pivotOf(const TaskBody& body) {
    Vec3 sum = Vec3::Zero();
    double count = 0;
    for (const TaskLine& line : body.task.lines) {
        sum = std::accumulate(line.points.begin(), line.points.end(), sum);
        count += static_cast<double>(line.points.size());
    }
    return count > 0 ? Vec3(sum / count) : boxOf(body.uncut.restPositions()).center();
}

ForceScore measureForce(std::span<const ForceSample> samples) {
    std::map<double, Vec3> impulses;  // by the number of the window [N s]
    for (const ForceSample& sample : samples) {
        const double first = std::floor((sample.begin + kHair) / kWindow);
        for (double k = first; k * kWindow < sample.end - kHair; ++k) {
            impulses.try_emplace(k, Vec3::Zero()).first->second +=
                sample.force *
                (std::min(sample.end, (k + 1) * kWindow) - std::max(sample.begin, k * kWindow));
        }
    }
    ForceScore score;
    Mean mean;
    for (const auto& [k, impulse] : impulses) {
        if (!impulse.isZero(0)) {
            raise(score.largest, impulse.norm() / kWindow);
            mean.add(impulse.norm() / kWindow, 1);
        }
    }
    score.mean = mean.value();
    return score;
}

/// Notes the limit of a figure if it was not kept, or if nothing shows that it was.
void judge(const FigureRow& row, Figure value, Figure limit, std::string_view where, Score& score) {
    if (!limit || (value && (row.better > 0 ? *value >= *limit : *value <= *limit))) {
        return;
    }
    const auto text = [&](Figure figure) {
        return formatFigure(row.unit, figure).append(*row.unit.name != 0 ? " " : "") +
               row.unit.name;
    };
    const std::string asked =
        fmt::format(" ({} {})", row.better > 0 ? "at least" : "at most", text(limit));
    score.violations.push_back(fmt::format("{}{}: {}{}.", row.label, where,
                                           value ? text(value) : "not measured",
                                           row.unit.isFlag ? "" : asked));
}

/// Judges lines, or what is spared, each by its own limit where these differ.
void judgeEach(std::string_view key, const Figures& values, const Figures& limits,
               std::string_view what, Score& score) {
    const auto row = std::ranges::find(kRows, key, &FigureRow::key);
    for (std::size_t i = 0; i < limits.size() && !sharedOf(limits); ++i) {
        judge(*row, values[i], limits[i], fmt::format(" of {} {}", what, i), score);
    }
}

void judgeAll(const TaskRun& run, Score& score) {
    const Task& task = run.body.task;
    for (const FigureRow& row : kRows) {
        judge(row, row.value(score), row.limit != nullptr ? row.limit(task) : std::nullopt, "",
              score);
    }
    judgeEach("deviation_max", score.cut.lineDeviations, deviationLimits(task), "line", score);
    judgeEach("margin_least", score.cut.partMargins, marginLimits(task), "spared part", score);
    for (const int model : score.cut.harmed) {
        score.violations.push_back(fmt::format("Model {} was to be spared, and was cut.", model));
    }
    if (run.undos > 0) {
        score.violations.push_back(
            fmt::format("{} undone.", counted(run.undos, "change was", "changes were")));
    }
    if (run.changes > 0) {
        score.violations.push_back(fmt::format(
            "{} set after the start.", counted(run.changes, "parameter was", "parameters were")));
    }
}

}  // namespace

std::span<const FigureRow> figureRows() {
    return kRows;
}

Score scoreOf(const TaskRun& run) {
    Score score;
    score.cut = measureCut(run.body);
    score.motion = measureMotion(run.hand, pivotOf(run.body), run.body.task.path);
    score.force = measureForce(run.forces);
    judgeAll(run, score);
    return score;
}

std::string formatFigure(const FigureUnit& unit, std::optional<double> value) {
    if (value && unit.isFlag) {
        return *value > 0 ? "yes" : "no";
    }
    return value ? fmt::format("{:.{}f}", *value * unit.factor, unit.digits) : "";
}

nlohmann::ordered_json toJson(const Score& score, const Task& task) {
    nlohmann::ordered_json json{{"task", task.name}, {"person", task.person}, {"date", task.date}};
    for (const FigureRow& row : kRows) {
        const Figure value = row.value(score);
        json[row.key] = value ? nlohmann::ordered_json(*value) : nullptr;
        if (value && row.unit.isFlag) {
            json[row.key] = *value > 0;
        }
    }
    json["violations"] = score.violations;
    json["passed"] = score.passed();
    return json;
}

}  // namespace kerf::app
