#include "bench/lab/experiment/report_markdown.h"

#include <spdlog/fmt/fmt.h>

#include "sim/base/text.h"

namespace kerf::app {

std::string markdownRow(const Cells& cells) {
    return "| " + joined(cells, " | ") + " |\n";
}

std::string markdownTable(const Cells& head, const std::vector<Cells>& rows) {
    std::string text = markdownRow(head) + markdownRow(Cells(head.size(), "---"));
    for (const Cells& row : rows) {
        text += markdownRow(row);
    }
    return text + "\n";
}

std::string experimentTable(const Cells& head, const std::vector<ExperimentResult>& results,
                            const std::function<Cells(const ExperimentResult&)>& cells) {
    std::vector<Cells> rows;
    rows.reserve(results.size());
    for (const ExperimentResult& result : results) {
        rows.push_back(cells(result));
    }
    return markdownTable(head, rows);
}

std::string markdownList(const std::vector<std::string>& sentences) {
    std::string text;
    for (const std::string& sentence : sentences) {
        text += "- " + sentence + "\n";
    }
    return text.empty() ? "" : text + "\n";
}

std::string markdownPicture(const std::string& alt, const std::string& file) {
    return "![" + alt + "](" + file + ")\n\n";
}

std::string markdownCaption(const std::string& number, const std::string& text) {
    return "**" + number + ".** " + text + "\n\n";
}

std::string percent(double ratio) {
    return fmt::format("{:.2f}", 100 * ratio);
}

std::string spread(const Range& range) {
    return fmt::format("{:.3f} ({:.3f} to {:.3f})", range.mean(), range.min(), range.max());
}

}  // namespace kerf::app
