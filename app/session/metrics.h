#pragma once

#include <nlohmann/json_fwd.hpp>

#include "app/practice/score.h"
#include "app/session/cut_report.h"
#include "app/session/real_time_factor.h"
#include "sim/mesh/invariants.h"
#include "sim/run/simulation.h"

namespace kerf::app {

struct Session;

/// Mean, smallest and largest of a series; all 0 for an empty one.
class Range {
  public:
    void add(double value);
    double mean() const { return count_ == 0 ? 0 : sum_ / count_; }
    double min() const { return min_; }
    double max() const { return max_; }

  private:
    double sum_ = 0;
    double min_ = 0;
    double max_ = 0;
    int count_ = 0;
};

/// One row of metrics.csv: values of the simulation and measurements of the replay.
struct MetricsRow {
    StepReport report;
    double renderMs = 0;  ///< pictures before this step, those of a film too, wall clock
    double frameMs = 0;   ///< the step and its commands, without pictures and files, wall clock
    bool namesToughness = true;   ///< see namesToughness(); else there is no fracture energy
    double simulatedSeconds = 0;  ///< see secondsOfStep()
};

/// Whether the toughness of a session was chosen: it has a material at the start, an event sets it,
/// it is not the parameter's default, or `blade_feels` or `tearing` uses it. `now`: the parameters
/// of the coming step.
bool namesToughness(const Session& session, const Params& now);

/// What a cell of metrics.csv holds; nothing where it is empty.
using MetricsValue = std::variant<std::monostate, bool, long, double>;
/// A column of metrics.csv.
struct MetricsColumn {
    std::string_view name;
    MetricsValue (*value)(const MetricsRow& row);
    const char* meaning = "";  ///< a sentence; "" for components, which Python has as a vector
};
/// The columns in their order (docs/session-format.md).
std::span<const MetricsColumn> metricsColumns();

/// First line of metrics.csv and its rows, each with its line break.
std::string metricsHeader();
std::string formatMetrics(const MetricsRow& row);
/// The row as one JSON object with the columns as keys, and its line break. An empty cell is null.
std::string formatJsonLine(const MetricsRow& row);

/// First line of pieces.csv.
std::string piecesHeader();
/// Its rows after a step, one for each piece, from 0, with their boxes, relative to `from`.
std::string formatPieces(int step, const std::vector<Piece>& pieces,
                         const std::vector<Bounds>& boxes, const Vec3& from);

/// The numbers that are counted before and after a run.
struct Counts {
    int vertices = 0;
    int triangles = 0;
    int ispcs = 0;
};

/// Statistics over all rows of a run.
struct RunStatistics {
    int steps = 0;
    Range volumeRatio;
    double finalVolumeRatio = 1;
    Range fps;  ///< of single steps; its mean is not used, see meanFps()
    Range frameMs;
    Range deformMs;
    Range collideMs;
    Range cutMs;
    Range searchMs;
    RealTimeFactors realTime;
    SubdivisionCounts subdivisions{};
    bool closedEveryStep = true;
    int lostPieces = 0;                    ///< reset, over all steps
    Debris debris;                         ///< removed, over all steps
    std::optional<double> fractureEnergy;  ///< of all steps [J]; none without a toughness
    std::optional<int> tears;              ///< steps that tore; none while nothing can tear

    void add(const MetricsRow& row);
    /// Steps over the whole time [1/s].
    double meanFps() const { return frameMs.mean() > 0 ? 1000 / frameMs.mean() : 0; }
};

/// The contents of summary.json without paths.
struct RunSummary {
    std::string model;
    std::string renderer;  ///< GL_RENDERER
    std::string driver;    ///< GL_VERSION
    std::string stateHash;
    Counts before;
    Counts after;
    std::vector<Piece> pieces;
    RunStatistics statistics;
    std::optional<CutReport> cuts;  ///< none if no stroke met the body
    std::vector<std::string>
        failures;  ///< checks and invariants that did not hold, one sentence each
    std::vector<std::string> messages;  ///< problems in steps, as in the log
    std::vector<std::string> remarks;   ///< warnings about the figures
    std::optional<Task> task;           ///< of a try
    std::optional<Score> score;         ///< of it
};

/// The keys of summary.json (docs/session-format.md).
nlohmann::ordered_json toJson(const RunSummary& summary);
/// The text of summary.json.
std::string formatSummary(const RunSummary& summary);

}  // namespace kerf::app
