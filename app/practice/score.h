#pragma once

#include <nlohmann/json_fwd.hpp>

#include "app/practice/cut_measure.h"
#include "app/practice/hand_path.h"

namespace kerf::app {

/// The load on the blade during a step.
struct ForceSample {
    double begin = 0;  ///< of the step, in simulated time [s]
    double end = 0;    ///< [s]
    Vec3 force = Vec3::Zero();
    int step = 0;
};

/// Forces as means over short windows of simulated time; none without a load.
struct ForceScore {
    std::optional<double> forceMax;   ///< [N]
    std::optional<double> forceMean;  ///< of the windows with a load [N]
};

/// How well a task was done.
struct Score : CutScore, MotionScore, ForceScore {
    std::optional<double> undos;
    std::optional<double> changes;        ///< of parameters, after the start
    std::vector<std::string> violations;  ///< a sentence for each limit that was not kept

    bool passed() const { return violations.empty(); }
};

/// A try: what was cut, how the hand moved, and what must not happen.
struct TaskRun {
    TaskBody body;
    std::span<const HandPose> hand;
    std::span<const ForceSample> forces;  ///< in the order of time
    int undos = 0;
    int changes = 0;  ///< of parameters, after the start
};

/// The box of the lines [m], empty without any.
Bounds boxOfLines(const Task& task);
/// The middle of the lines, or of the body without any: about it a hand is measured.
Vec3 pivotOf(const Task& task, const SurfaceMesh& uncut);
/// Measures and judges a try. The same input gives the same bits.
Score scoreOf(const TaskRun& run);

/// What figures are for people.
struct FigureUnit {
    const char* name;
    double factor;  ///< from SI
    int digits;     ///< after the point
    bool isFlag = false;
};

/// A figure of a score, as files, panels and pages have it.
struct FigureRow {
    const char* key;  ///< in files, where it has SI units
    const char* label;
    FigureUnit unit;
    int better;  ///< 1: more is better; -1: less; 0: neither
    std::optional<double> Score::*value;
    std::optional<double> TaskLimits::*limit = nullptr;
    bool (*isAsked)(const Task& task) = [](const Task&) { return true; };
    std::optional<double> fixedLimit = std::nullopt;  ///< where tasks have none of their own
};
std::span<const FigureRow> figureRows();
std::optional<double> valueOf(const FigureRow& row, const Score& score);
/// None where the task has no limit, or does not ask for the figure.
std::optional<double> limitOf(const FigureRow& row, const Task& task);

/// Whether a try kept the limit of a figure, if the task has one.
bool isKept(const FigureRow& row, const Score& score, const Task& task);

/// A value for people, without its unit; "" for none.
std::string formatFigure(const FigureUnit& unit, std::optional<double> value);
/// "\u2264 2"
std::string shortLimit(const FigureRow& row, double limit);
/// "at least 2.00 mm"
std::string limitText(const FigureRow& row, double limit);
/// `score` of summary.json (docs/session-format.md).
nlohmann::ordered_json toJson(const Score& score, const Task& task);

}  // namespace kerf::app
