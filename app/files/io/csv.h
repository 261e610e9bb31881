#pragma once

namespace kerf::app {

/// A text as a cell, in quotes only where it needs them (RFC 4180).
std::string csvCell(const std::string& text);

/// A table of comma-separated values as Kerf writes them: a header, then a row per line, no quotes.
class CsvTable {
  public:
    /// Reads a file of at most `limit` bytes. Throws InputError if it can't be read, has no header,
    /// or a row has another number of cells, naming file and line, like all functions here.
    CsvTable(const std::filesystem::path& file, std::uintmax_t limit);

    std::size_t rows() const { return rows_.size(); }
    /// Number of a column; nothing if there is none of that name.
    std::optional<std::size_t> find(std::string_view column) const;
    /// Number of a column that must be there.
    std::size_t require(std::string_view column) const;
    const std::string& cell(std::size_t row, std::size_t column) const {
        return rows_[row][column];
    }
    /// A cell that must be a finite number.
    double number(std::size_t row, std::size_t column) const;
    /// Throws InputError about a row: "hashes.csv, line 7: <problem>.".
    [[noreturn]] void fail(std::size_t row, const std::string& problem) const;

  private:
    using Cells = std::vector<std::string>;

    std::string name_;  ///< of the file
    Cells header_;
    std::vector<Cells> rows_;
};

}  // namespace kerf::app
