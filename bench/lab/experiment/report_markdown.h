#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bench/lab/experiment/experiment_result.h"

namespace kerf::app {

/// Stands where the paper's text gives no figure.
inline constexpr const char* kNotGiven = "-";

/// The cells of a row of a table.
using Cells = std::vector<std::string>;

/// A row of a Markdown table, with its line break.
std::string markdownRow(const Cells& cells);
/// A Markdown table with an empty line behind it.
std::string markdownTable(const Cells& head, const std::vector<Cells>& rows);
/// A table with one row for each experiment.
std::string experimentTable(const Cells& head, const std::vector<ExperimentResult>& results,
                            const std::function<Cells(const ExperimentResult&)>& cells);
/// A list with one item for each sentence and an empty line behind it; nothing for none.
std::string markdownList(const std::vector<std::string>& sentences);
/// A picture on a line of its own; `alt` is what people read who don't see it.
std::string markdownPicture(const std::string& alt, const std::string& file);
/// A caption below a table or a figure: "**Figure 5.** Cutting simulation."
std::string markdownCaption(const std::string& number, const std::string& text);

/// A ratio in per cent with two decimals, without the sign.
std::string percent(double ratio);
/// "mean (min to max)" with three decimals.
std::string spread(const Range& range);

}  // namespace kerf::app
