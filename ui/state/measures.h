#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace kerf::ui {

/// The kind of measurement by clicks.
enum class MeasureKind : std::uint8_t { distance, angle, piece, point };
std::string_view nameOf(MeasureKind kind);

/// One measured number.
struct MeasureFigure {
    std::string quantity;  ///< "distance", "angle", "skin area", "cut area", "volume", "strain"
    double value = 0;      ///< [m, degrees, m^2, m^3, share, m/s]
    std::string unit;      ///< of value: "m", "deg", "m2", "m3", "", "m/s"
    double ownValue = 0;   ///< in the numbers of the model's own file
    std::string ownUnit;   ///< "mm", "mm2"; empty if it is the same
    std::string text;      ///< for display: "12.3 cm (123 mm in its file)"
};

/// A measurement in the list: a distance, an angle, a piece with its areas and its volume, or the
/// point that is plotted.
struct MeasureRow {
    int id = 0;  ///< for RemoveMeasure
    MeasureKind kind = MeasureKind::distance;
    std::vector<MeasureFigure> figures;
    bool isOld = false;  ///< the body has moved since its areas were computed
};

/// The measurements as a table: id,measure,quantity,value,unit,value_in_file,unit_in_file.
std::string measuresAsCsv(const std::vector<MeasureRow>& measures);

}  // namespace kerf::ui
