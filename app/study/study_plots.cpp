#include "app/study/study_plots.h"

#include <spdlog/fmt/fmt.h>

#include <charconv>

#include "app/files/io/csv.h"
#include "app/files/io/file_io.h"
#include "app/session/session.h"
#include "sim/base/containers.h"
#include "ui/plots/plot_picture.h"

namespace kerf::app {

namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMaxMetricsBytes = 1u << 30;
constexpr int kMostColumns = 6;
constexpr int kUsualColumns = 4;
constexpr std::size_t kMostNotes = 4;
constexpr int kFrameHeight = 150;  // [pixels], of a panel without its notes
constexpr int kNoteHeight = 20;    // [pixels]
constexpr double kPeakShare = 0.99;

/// A quantity that is drawn: a column of metrics.csv, and what a sheet of it is called.
struct Quantity {
    const char* file;
    const char* column;
    const char* title;
    double factor = 1;   ///< from the column to what is shown
    double minSpan = 1;  ///< of the y axis
    int decimals = 1;
    bool fromZero = false;
    double share = 1;  ///< of the values that the y axis shows at least
};

/// The first steps of a run, and steps that the machine was busy in, are far slower than all
/// others.
constexpr Quantity kQuantities[] = {
    {"volume", "volume_ratio", "Volume, % of rest", 100, 0.1, 3},
    {"kinetic_energy", "kinetic_energy", "Kinetic energy, J", 1, 1e-3, 3, true},
    {"frame_time", "frame_ms", "Time of a step, ms", 1, 1, 1, true, kPeakShare},
};
constexpr std::size_t kQuantityCount = std::size(kQuantities);

/// What a run went through, by step.
struct RunCurves {
    std::array<ui::Series, kQuantityCount> series;
    std::array<ui::PlotRange, kQuantityCount> ranges;  ///< turned over where there are no values
    std::vector<ui::PlotMark> marks;                   ///< where the number of pieces changed

    RunCurves() { ranges.fill({HUGE_VAL, -HUGE_VAL}); }
};

/// A value that is not finite is no reason to draw nothing of a run.
double readValue(const std::string& cell) {
    double value = NAN;
    std::from_chars(cell.data(), cell.data() + cell.size(), value);
    return value;
}

/// From the lowest value to that which no more than a few are above.
ui::PlotRange shownRange(std::vector<double> values, double share) {
    if (values.empty()) {
        return {HUGE_VAL, -HUGE_VAL};
    }
    std::ranges::sort(values);
    const double last = share * static_cast<double>(values.size() - 1);
    return {values.front(), values[static_cast<std::size_t>(last)]};
}

void readQuantity(RunCurves& curves, std::size_t q, const CsvTable& table) {
    const Quantity& quantity = kQuantities[q];
    const std::size_t column = table.require(quantity.column);
    std::vector<double> values;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const double value = quantity.factor * readValue(table.cell(row, column));
        if (std::isfinite(value)) {
            curves.series[q].add(static_cast<double>(row), value);
            values.push_back(value);
        }
    }
    curves.ranges[q] = shownRange(std::move(values), quantity.share);
}

void readMarks(RunCurves& curves, const CsvTable& table) {
    const std::size_t pieces = table.require("pieces");
    for (std::size_t row = 1; row < table.rows(); ++row) {
        const std::string& now = table.cell(row, pieces);
        if (now != table.cell(row - 1, pieces)) {
            curves.marks.push_back(
                {static_cast<double>(row), now + (now == "1" ? " piece" : " pieces")});
        }
    }
}

RunCurves readCurves(const fs::path& metrics) {
    RunCurves curves;
    if (fs::exists(metrics)) {
        const CsvTable table(metrics, kMaxMetricsBytes);
        for (std::size_t q = 0; q < kQuantityCount; ++q) {
            readQuantity(curves, q, table);
        }
        readMarks(curves, table);
    }
    return curves;
}

// --- Labels ----------------------------------------------------------------------------------

std::string withoutEnding(const std::string& session) {
    const std::string name = fs::path(session).filename().string();
    return name.substr(0, name.find(".kerf.json"));
}

std::string panelTitle(std::size_t number, const RunState& state) {
    if (!state.record) {
        return fmt::format("Run {}: missing", number);
    }
    return state.record->exitCode == 0
               ? fmt::format("Run {}", number)
               : fmt::format("Run {}: exit {}", number, state.record->exitCode);
}

/// A line for the session, where there are several, and one for each parameter; what is too much
/// stands in the last one.
std::vector<std::string> panelNotes(const Study& study, const StudyRun& run) {
    std::vector<std::string> notes;
    if (study.sessions.size() > 1) {
        notes.push_back(withoutEnding(study.sessionOf(run).name));
    }
    for (const std::string& parameter : study.parameters) {
        const std::string note = parameter + " " + startValue(study, run, parameter);
        if (notes.size() < kMostNotes) {
            notes.push_back(note);
        } else {
            notes.back() += ", " + note;
        }
    }
    return notes;
}

/// Values of the parameter that varies fastest.
int fastestValues(const Study& study) {
    const std::string& parameter = study.parameters.back();
    std::vector<std::string> values;
    for (const StudyRun& run : study.runs) {
        const std::string value = startValue(study, run, parameter);
        if (std::ranges::count(values, value) != 0) {
            break;
        }
        values.push_back(value);
        if (values.size() > kMostColumns) {
            break;
        }
    }
    return static_cast<int>(values.size());
}

// --- Sheets ----------------------------------------------------------------------------------

/// A run as its panels show it.
struct DrawnRun {
    std::string title;
    std::vector<std::string> notes;
    RunCurves curves;
};

DrawnRun readRun(const Study& study, std::size_t number, const fs::path& out) {
    const RunState state = stateOfRun(study, number, out);
    return {panelTitle(number, state), panelNotes(study, study.runs[number]),
            state.record ? readCurves(folderOfRun(out, number) / kMetricsFile) : RunCurves()};
}

std::vector<DrawnRun> readRuns(const Study& study, const fs::path& out) {
    std::vector<DrawnRun> runs;
    for (std::size_t i = 0; i < std::min(study.runs.size(), kMostDrawnRuns); ++i) {
        runs.push_back(readRun(study, i, out));
    }
    return runs;
}

/// One range for all runs, or they could not be compared.
ui::PlotRange commonRange(std::size_t q, std::span<const DrawnRun> runs) {
    ui::PlotRange range{HUGE_VAL, -HUGE_VAL};
    for (const DrawnRun& run : runs) {
        range.low = std::min(range.low, run.curves.ranges[q].low);
        range.high = std::max(range.high, run.curves.ranges[q].high);
    }
    ui::PlotRange padded = ui::paddedRange(range, kQuantities[q].minSpan);
    padded.low = kQuantities[q].fromZero ? 0 : padded.low;
    return padded;
}

ui::PlotSpec panelOf(const DrawnRun& run, std::size_t q, const ui::PlotRange& range) {
    ui::PlotSpec spec;
    spec.id = "plot";
    spec.title = run.title;
    spec.notes = run.notes;
    spec.xUnit = "steps";
    spec.curves = {{.label = kQuantities[q].title, .series = &run.curves.series[q]}};
    spec.marks = run.curves.marks;
    spec.yRange = range;
    spec.readoutDecimals = kQuantities[q].decimals;
    return spec;
}

std::vector<ui::PlotSpec> panelsOf(std::span<const DrawnRun> runs, std::size_t q,
                                   const ui::PlotRange& range) {
    return mapped(runs, [&](const DrawnRun& run) { return panelOf(run, q, range); });
}

std::string pictureName(std::size_t q, std::size_t page) {
    return kQuantities[q].file + (page == 0 ? "" : fmt::format("-{}", page + 1)) + ".png";
}

std::size_t pageCount(const Study& study) {
    return (std::min(study.runs.size(), kMostDrawnRuns) + kRunsPerPicture - 1) / kRunsPerPicture;
}

void drawPage(ui::PlotPainter& painter, const Study& study, std::size_t q,
              std::span<const ui::PlotSpec> panels, const fs::path& file) {
    const auto notes = static_cast<int>(panels.front().notes.size());
    writePicture(painter.draw({.title = study.name + ": " + kQuantities[q].title,
                               .panels = panels,
                               .columns = panelColumns(study),
                               .panelHeight = kFrameHeight + kNoteHeight * notes}),
                 file);
}

/// The pictures of one quantity.
void drawQuantity(ui::PlotPainter& painter, const Study& study, std::size_t q,
                  std::span<const DrawnRun> runs, const fs::path& out) {
    const std::vector<ui::PlotSpec> panels = panelsOf(runs, q, commonRange(q, runs));
    for (std::size_t page = 0; page < pageCount(study); ++page) {
        const std::size_t first = page * kRunsPerPicture;
        const std::size_t count = std::min(kRunsPerPicture, panels.size() - first);
        drawPage(painter, study, q, std::span(panels).subspan(first, count),
                 out / pictureName(q, page));
    }
}

}  // namespace

int panelColumns(const Study& study) {
    const auto runs = static_cast<int>(study.runs.size());
    const int values = study.parameters.empty() ? 1 : fastestValues(study);
    if (values > kMostColumns || values < 2) {
        return std::min(runs, kUsualColumns);
    }
    int columns = values;
    while (columns * columns < runs && columns + values <= kMostColumns) {
        columns += values;
    }
    return columns;
}

std::vector<std::string> studyPictures(const Study& study) {
    std::vector<std::string> names;
    for (std::size_t q = 0; q < kQuantityCount; ++q) {
        for (std::size_t page = 0; page < pageCount(study); ++page) {
            names.push_back(pictureName(q, page));
        }
    }
    return names;
}

void drawStudy(const Study& study, const fs::path& out) {
    const std::vector<DrawnRun> runs = readRuns(study, out);
    ui::PlotPainter painter(ui::Theme::light);
    for (std::size_t q = 0; q < kQuantityCount; ++q) {
        drawQuantity(painter, study, q, runs, out);
    }
}

}  // namespace kerf::app
