#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sim/base/region.h"

namespace kerf::app {

/// A line on a body at rest, along which to cut.
struct TaskLine {
    std::vector<Vec3> points;         ///< two at least, no two in a row the same [m]
    bool closed = false;              ///< the last point is joined to the first
    int model = 0;                    ///< the body to cut
    Vec3 into = -Vec3::UnitY();       ///< direction into the body, along no segment; of any length
    std::optional<double> depth;      ///< of the cut [m]; none where it goes through
    std::optional<double> band;       ///< by which the depth may differ [m]
    std::optional<double> deviation;  ///< the largest allowed one [m]
    double reach = 0.01;              ///< what lies farther aside is not of this line [m]
};

/// A model that is not to be cut.
struct SparedModel {
    int model = 0;
    double margin = 0;  ///< how far off cuts must stay [m]
};

/// A part of space at rest that is not to be cut.
struct SparedRegion {
    Region region;
    double margin = 0;  ///< how far off cuts must stay [m]
};

/// A slice to be cut off.
struct TaskSlice {
    double thickness = 0;  ///< [m]
    double band = 0;       ///< by which it may differ [m]
};

/// What to practise, and how well it is to be done (docs/practice.md).
struct Task {
    std::string name;
    std::string about;             ///< what to do
    std::filesystem::path expert;  ///< a session that shows it; may be empty
    std::vector<TaskLine> lines;
    std::vector<SparedModel> spare;
    std::vector<SparedRegion> spareRegions;
    std::optional<int> take;  ///< a model to be taken out whole
    std::optional<TaskSlice> slice;
    std::optional<double> seconds;     ///< at most
    std::optional<double> newtons;     ///< at most
    std::optional<double> idle;        ///< at most [s]
    std::optional<double> economy;     ///< at least
    std::optional<double> smoothness;  ///< at least
    std::optional<double> inBand;  ///< share of depth and thickness within their bands, at least
    std::optional<double> path;    ///< of the expert's hand, for `economy` [m]
    std::string person;            ///< of a try: who
    std::string date;              ///< of a try: when, ISO 8601 in UTC
};

}  // namespace kerf::app
