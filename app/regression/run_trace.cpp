#include "app/regression/run_trace.h"

#include "app/files/io/csv.h"
#include "app/files/io/file_io.h"
#include "sim/base/text.h"

namespace kerf::app {

namespace {

constexpr std::uintmax_t kMaxTableBytes = 1u << 30;
constexpr int kSamples = 30;
constexpr double kMostCounted = 1e9;

constexpr const char* kTraceHeader = "step,volume,pieces,vertices,triangles\n";
constexpr const char* kPiecesHeader = "step,piece,volume,low_x,low_y,low_z,high_x,high_y,high_z\n";
constexpr std::array kSides = {"low_x", "low_y", "low_z", "high_x", "high_y", "high_z"};

int readCount(const CsvTable& table, std::size_t row, std::size_t column) {
    const double value = table.number(row, column);
    if (!(value >= 0 && value <= kMostCounted)) {
        table.fail(row, "'" + shortened(table.cell(row, column)) + "' is no count");
    }
    return static_cast<int>(value);
}

}  // namespace

RunTrace readTrace(const std::filesystem::path& file) {
    const CsvTable table(file, kMaxTableBytes);
    const std::size_t step = table.require("step");
    const std::size_t volume = table.require("volume");
    const std::size_t pieces = table.require("pieces");
    const std::size_t vertices = table.require("vertices");
    const std::size_t triangles = table.require("triangles");
    RunTrace trace;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        if (readCount(table, row, step) != static_cast<int>(row)) {
            table.fail(row, "expected step " + std::to_string(row));
        }
        trace.push_back({table.number(row, volume), readCount(table, row, pieces),
                         readCount(table, row, vertices), readCount(table, row, triangles)});
    }
    return trace;
}

std::string formatTrace(const RunTrace& trace) {
    std::string text = kTraceHeader;
    for (std::size_t step = 0; step < trace.size(); ++step) {
        const TraceRow& row = trace[step];
        text += std::to_string(step) + "," + formatNumber(row.volume) + "," +
                std::to_string(row.pieces) + "," + std::to_string(row.vertices) + "," +
                std::to_string(row.triangles) + "\n";
    }
    return text;
}

PieceTrace readPieces(const std::filesystem::path& file) {
    const CsvTable table(file, kMaxTableBytes);
    const std::size_t step = table.require("step");
    const std::size_t volume = table.require("volume");
    std::array<std::size_t, kSides.size()> sides{};
    std::ranges::transform(kSides, sides.begin(), [&](auto side) { return table.require(side); });
    PieceTrace pieces;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        PieceBox& piece = pieces[readCount(table, row, step)].emplace_back();
        piece.volume = table.number(row, volume);
        for (int i = 0; i < 3; ++i) {
            piece.box.low[i] = table.number(row, sides[static_cast<std::size_t>(i)]);
            piece.box.high[i] = table.number(row, sides[static_cast<std::size_t>(i) + 3]);
        }
    }
    return pieces;
}

std::string formatPieces(const PieceTrace& pieces) {
    std::string text = kPiecesHeader;
    for (const auto& [step, boxes] : pieces) {
        for (std::size_t p = 0; p < boxes.size(); ++p) {
            text += std::to_string(step) + "," + std::to_string(p) + "," +
                    formatNumber(boxes[p].volume);
            for (const Vec3& corner : {boxes[p].box.low, boxes[p].box.high}) {
                for (int i = 0; i < 3; ++i) {
                    text += "," + formatNumber(static_cast<float>(corner[i]));
                }
            }
            text += "\n";
        }
    }
    return text;
}

PieceTrace thinnedOut(const PieceTrace& pieces) {
    PieceTrace kept;
    const int last = std::max(0, lastStepOf(pieces));
    const int spacing = std::max(1, (last + kSamples) / kSamples);
    for (const auto& entry : pieces) {
        if (entry.first % spacing == 0 || entry.first == last) {
            kept.insert(entry);
        }
    }
    return kept;
}

int lastStepOf(const PieceTrace& pieces) {
    return pieces.empty() ? -1 : pieces.rbegin()->first;
}

}  // namespace kerf::app
