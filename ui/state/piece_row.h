#pragma once

#include "sim/base/math.h"

namespace kerf::ui {

/// Measures that need all triangles of a piece.
struct PieceSums {
    double skinArea = 0;           ///< [m^2]
    double cutArea = 0;            ///< of the faces of cuts [m^2]
    Vec3 centroid = Vec3::Zero();  ///< of its volume [m]
};

/// One row of the pieces table.
struct PieceRow {
    int triangles = 0;
    double volume = 0;  ///< [m^3]
    double share = 0;   ///< of its rest volume, 1 = all
    bool hidden = false;
    double shareOfAll = 0;            ///< of the volume of all pieces, 1 = all
    Bounds bounds{};                  ///< [m]
    std::optional<PieceSums> sums{};  ///< none until requested while paused
    std::optional<Vec3> color{};      ///< of the view; none: its look
};

/// The columns of the table, in their order.
enum class PieceColumn { number, triangles, volume, ofRest, ofAll, area, size, centre };

/// The numbers of the rows sorted by a column, in falling order if `descending`. Equal rows keep
/// their order.
std::vector<int> sortedPieces(const std::vector<PieceRow>& rows, PieceColumn column,
                              bool descending);

/// piece,triangles,volume_m3,share_of_rest,share_of_all,skin_area_m2,cut_area_m2, then centre_x to
/// _z, low_x to _z and high_x to _z [m]. What is not known is left empty.
std::string piecesAsCsv(const std::vector<PieceRow>& rows);

}  // namespace kerf::ui
