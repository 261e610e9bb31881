#include "app/session/hash_trace.h"

#include "app/files/io/csv.h"
#include "sim/base/text.h"

namespace kerf::app {

namespace {

constexpr std::uintmax_t kMaxBytes = 1u << 30;
constexpr std::size_t kDigits = 16;
constexpr const char* kStateColumn = "state_hash";

std::string columnOf(std::string_view part) {
    return std::string(part) + "_hash";
}

bool isHash(std::string_view text) {
    return text.size() == kDigits &&
           text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

/// The columns of a file that hold hashes.
struct Columns {
    std::size_t step;
    std::size_t state;
    std::array<std::optional<std::size_t>, kStatePartNames.size()> parts;

    explicit Columns(const CsvTable& table)
        : step(table.require("step")), state(table.require(kStateColumn)) {
        for (std::size_t part = 0; part < parts.size(); ++part) {
            parts[part] = table.find(columnOf(kStatePartNames[part]));
        }
        table.require(columnOf(kStatePartNames[static_cast<std::size_t>(StatePart::topology)]));
    }
};

std::string readHash(const CsvTable& table, std::size_t row, std::size_t column) {
    std::string text = table.cell(row, column);
    if (!isHash(text)) {
        table.fail(row, "'" + shortened(text) + "' is no hash of 16 lower-case hexadecimal digits");
    }
    return text;
}

StateHashes readRow(const CsvTable& table, const Columns& columns, std::size_t row) {
    if (table.cell(row, columns.step) != std::to_string(row)) {
        table.fail(row, "expected step " + std::to_string(row));
    }
    StateHashes hashes{readHash(table, row, columns.state), {}};
    for (std::size_t part = 0; part < hashes.parts.size(); ++part) {
        if (columns.parts[part]) {
            hashes.parts[part] = readHash(table, row, *columns.parts[part]);
        }
    }
    return hashes;
}

/// Where nothing but the state hash tells of a difference.
std::string partsNotHeld(const StateHashes& expected) {
    std::vector<std::string> names;
    for (const StatePart part : {StatePart::positions, StatePart::velocities, StatePart::boxes}) {
        if (expected.of(part).empty()) {
            names.emplace_back(kStatePartNames[static_cast<std::size_t>(part)]);
        }
    }
    return names.empty() ? "the state" : joined(names, " or ");
}

std::vector<std::string> partsThatDiffer(const StateHashes& expected, const StateHashes& found) {
    std::vector<std::string> names;
    for (std::size_t part = 0; part < expected.parts.size(); ++part) {
        const std::string& a = expected.parts[part];
        const std::string& b = found.parts[part];
        if (!a.empty() && !b.empty() && a != b) {
            names.emplace_back(kStatePartNames[part]);
        }
    }
    if (names.empty() && expected.state != found.state) {
        return {partsNotHeld(expected)};
    }
    return names;
}

}  // namespace

std::string hashesHeader() {
    std::string line = std::string("step,") + kStateColumn;
    for (const std::string_view part : kStatePartNames) {
        line += "," + columnOf(part);
    }
    return line + "\n";
}

std::string formatHashes(int step, const StateHashes& hashes) {
    return std::to_string(step) + "," + hashes.state + "," + joined(hashes.parts, ",") + "\n";
}

HashTrace HashTrace::read(const std::filesystem::path& file) {
    const CsvTable table(file, kMaxBytes);
    const Columns columns(table);
    HashTrace trace;
    trace.rows_.reserve(table.rows());
    for (std::size_t row = 0; row < table.rows(); ++row) {
        trace.rows_.push_back(readRow(table, columns, row));
    }
    return trace;
}

std::vector<std::string> HashTrace::differingParts(int step, const StateHashes& hashes) const {
    return partsThatDiffer(rows_[static_cast<std::size_t>(step)], hashes);
}

std::vector<std::string> HashTrace::differingParts(int step, const HashTrace& other) const {
    return differingParts(step, other.rows_[static_cast<std::size_t>(step)]);
}

}  // namespace kerf::app
