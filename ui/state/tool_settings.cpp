#include "ui/state/tool_settings.h"

#include <spdlog/fmt/fmt.h>

namespace kerf::ui {

std::string_view nameOf(MeasureKind kind) {
    static constexpr std::array<std::string_view, 4> kNames{"distance", "angle", "piece", "point"};
    return kNames[static_cast<std::size_t>(kind)];
}

std::string measuresAsCsv(const std::vector<MeasureRow>& measures) {
    std::string text = "id,measure,quantity,value,unit,value_in_file,unit_in_file\n";
    for (const MeasureRow& row : measures) {
        for (const MeasureFigure& figure : row.figures) {
            const bool own = !figure.ownUnit.empty();
            text += fmt::format("{},{},{},{:.9g},{},{:.9g},{}\n", row.id, nameOf(row.kind),
                                figure.quantity, figure.value, figure.unit, figure.ownValue,
                                own ? figure.ownUnit : figure.unit);
        }
    }
    return text;
}

}  // namespace kerf::ui
