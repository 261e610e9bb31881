#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace kerf::ui {

/// What the clicks of the measuring tool tell.
enum class MeasureKind : std::uint8_t { distance, angle, piece };
std::string_view nameOf(MeasureKind kind);

/// One number that was measured.
struct MeasureFigure {
    std::string quantity;  ///< "distance", "angle", "skin area", "cut area", "volume"
    double value = 0;      ///< [m, degrees, m^2, m^3]
    std::string unit;      ///< of value: "m", "deg", "m2", "m3"
    double ownValue = 0;   ///< in the numbers of the model's own file
    std::string ownUnit;   ///< "mm", "mm2"; empty where that is the same
    std::string text;      ///< as people read it: "12.3 cm (123 mm in its file)"
};

/// One measure in the list: a distance, an angle, or a piece with its areas and its volume.
struct MeasureRow {
    int id = 0;  ///< what RemoveMeasure asks for
    MeasureKind kind = MeasureKind::distance;
    std::vector<MeasureFigure> figures;
    bool isOld = false;  ///< the body has moved since its areas were added up
};

/// The measures as a table: id,measure,quantity,value,unit,value_in_file,unit_in_file.
std::string measuresAsCsv(const std::vector<MeasureRow>& measures);

}  // namespace kerf::ui
