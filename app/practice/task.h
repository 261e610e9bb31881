#pragma once

#include "sim/base/placement.h"

namespace kerf::app {

/// A line on a body at rest, along which to cut.
struct TaskLine {
    std::vector<Vec3> points;  ///< two at least, no two in a row the same [m]
    bool closed = false;       ///< the last point is joined to the first
};

inline constexpr std::size_t kMostOfTask = 20;  ///< lines, and regions to spare

/// How well a task must be done; a figure without a limit is measured, but not judged.
struct TaskLimits {
    std::optional<double> deviation;   ///< of the rim from the line, at most [m]
    std::optional<double> ends;        ///< of the lines left uncut, or cut elsewhere, at most [m]
    std::optional<double> inBand;      ///< share of the depth within its band, at least
    std::optional<double> margin;      ///< between cuts and what is spared, at least [m]
    std::optional<double> seconds;     ///< at most
    std::optional<double> idle;        ///< at most [s]
    std::optional<double> economy;     ///< at least
    std::optional<double> smoothness;  ///< at least
    std::optional<double> wobble;      ///< at most [m]
    std::optional<double> newtons;     ///< at most
    std::optional<double> meanDeviation;  ///< at most [m]
};

/// What to practise, and how well it is to be done (docs/practice.md).
struct Task {
    std::string name;
    std::string about;             ///< what to do
    std::filesystem::path expert;  ///< a session that shows it; may be empty
    std::vector<TaskLine> lines;
    int model = 0;                     ///< the body to cut
    Vec3 into = -Vec3::UnitY();        ///< direction into it, along no line; of any length
    double reach = 0.01;               ///< what lies farther from a line is not of it [m]
    std::optional<double> depth;       ///< of the cut [m]; none where it goes through
    double band = 0;                   ///< by which the depth may differ [m]
    std::vector<int> spare;            ///< models that must not be cut
    std::vector<Region> spareRegions;  ///< parts of space at rest that must not be cut
    std::optional<int> take;           ///< a model to be taken out whole
    std::optional<double> path;        ///< of the expert's hand, for the economy [m]
    TaskLimits limits;
    std::string person;  ///< of a try: who
    std::string date;    ///< of a try: when, ISO 8601 in UTC
};

}  // namespace kerf::app
