#include "app/files/io/csv.h"

#include <charconv>

#include "app/files/io/errors.h"
#include "app/files/io/file_io.h"
#include "sim/base/text.h"

namespace kerf::app {

namespace {

std::vector<std::string> split(std::string_view text, char separator) {
    std::vector<std::string> parts;
    for (std::size_t end = 0; end != std::string_view::npos;) {
        end = text.find(separator);
        parts.emplace_back(text.substr(0, end));
        text.remove_prefix(end == std::string_view::npos ? 0 : end + 1);
    }
    return parts;
}

/// Without line breaks of either kind; the last one ends the last line.
std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines = split(text, '\n');
    if (lines.back().empty()) {
        lines.pop_back();
    }
    for (std::string& line : lines) {
        if (line.ends_with('\r')) {
            line.pop_back();
        }
    }
    return lines;
}

}  // namespace

std::string csvCell(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) {
        return text;
    }
    std::string quoted = "\"";
    for (const char c : text) {
        quoted += c == '"' ? "\"\"" : std::string(1, c);
    }
    return quoted + "\"";
}

CsvTable::CsvTable(const std::filesystem::path& file, std::uintmax_t limit) : name_(file.string()) {
    const std::vector<std::string> lines = linesOf(readInputFile(file, limit));
    if (lines.empty()) {
        throw InputError(name_ + ": the file is empty; expected a table with a header.");
    }
    header_ = split(lines.front(), ',');
    for (std::size_t i = 1; i < lines.size(); ++i) {
        rows_.push_back(split(lines[i], ','));
        if (rows_.back().size() != header_.size()) {
            fail(i - 1, "expected " + std::to_string(header_.size()) + " cells, found " +
                            std::to_string(rows_.back().size()));
        }
    }
}

std::optional<std::size_t> CsvTable::find(std::string_view column) const {
    const auto found = std::ranges::find(header_, column);
    return found == header_.end()
               ? std::nullopt
               : std::optional(static_cast<std::size_t>(found - header_.begin()));
}

std::size_t CsvTable::require(std::string_view column) const {
    const std::optional<std::size_t> found = find(column);
    if (!found) {
        throw InputError(name_ + ": the column '" + std::string(column) + "' is missing.");
    }
    return *found;
}

double CsvTable::number(std::size_t row, std::size_t column) const {
    const std::string& text = cell(row, column);
    double value = 0;
    const char* end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, value);
    if (read.ec != std::errc() || read.ptr != end || !std::isfinite(value)) {
        fail(row, "'" + shortened(text) + "' is no number");
    }
    return value;
}

void CsvTable::fail(std::size_t row, const std::string& problem) const {
    throw InputError(name_ + ", line " + std::to_string(row + 2) + ": " + problem + ".");
}

}  // namespace kerf::app
