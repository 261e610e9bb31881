#include <spdlog/fmt/fmt.h>

#include "bench/lab/experiment/report_markdown.h"
#include "bench/lab/experiment/report_sections.h"
#include "sim/base/text.h"

namespace kerf::app {

namespace {

/// A value as a session has it.
struct ValueText {
    std::string operator()(double value) const { return fmt::format("{:g}", value); }
    std::string operator()(const Vec3& value) const {
        return "[" +
               joined(std::array{value.x(), value.y(), value.z()}, ", ",
                      [](double x) { return fmt::format("{:g}", x); }) +
               "]";
    }
    std::string operator()(std::monostate) const { return "none"; }
    std::string operator()(const std::string& value) const { return value; }
};

std::string valueOf(const ExperimentResult& result, std::string_view name) {
    return std::visit(ValueText{}, getParam(result.session.params, name));
}

Cells paramRow(const ParamInfo& info, const std::vector<ExperimentResult>& results) {
    const std::string name = "`" + std::string(info.name) + "`";
    Cells cells{info.unit.empty() ? name : name + ", " + std::string(info.unit)};
    for (const ExperimentResult& result : results) {
        cells.push_back(valueOf(result, info.name));
    }
    return cells;
}

Cells rowOf(const std::string& name, const std::vector<ExperimentResult>& results,
            std::string (*cell)(const ExperimentResult&)) {
    Cells cells{name};
    for (const ExperimentResult& result : results) {
        cells.push_back(cell(result));
    }
    return cells;
}

std::string gravityLater(const ExperimentResult& result) {
    for (const SessionEvent& event : result.session.events) {
        const auto* set = std::get_if<SetParam>(&event.action);
        if (set != nullptr && set->name == "gravity") {
            return std::visit(ValueText{}, set->value) + fmt::format(" from step {}", event.step);
        }
    }
    return kNotGiven;
}

}  // namespace

std::string settingsSection(const ReportData& data) {
    Cells head{"setting"};
    std::vector<Cells> rows;
    for (const ExperimentResult& result : data.results) {
        head.emplace_back(result.paper->label);
    }
    rows.push_back(rowOf("steps", data.results, [](const ExperimentResult& r) {
        return fmt::format("{}", r.summary.statistics.steps);
    }));
    rows.push_back(rowOf("gravity after the cut, m/s^2", data.results, gravityLater));
    for (const ParamInfo& info : paramTable()) {
        rows.push_back(paramRow(info, data.results));
    }
    rows.push_back(rowOf("pieces at the end", data.results, [](const ExperimentResult& r) {
        return fmt::format("{}", r.summary.pieces.size());
    }));
    rows.push_back(rowOf("closed after every step", data.results, [](const ExperimentResult& r) {
        return std::string(r.summary.statistics.closedEveryStep ? "yes" : "no");
    }));
    return "## Settings\n\nAll parameters at the start of each run, by their names in a session. "
           "Time steps and iterations are the paper's; it gives no stiffness, modulus, density or "
           "friction, so these are our own.\n\n" +
           markdownTable(head, rows);
}

}  // namespace kerf::app
