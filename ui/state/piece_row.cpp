#include "ui/state/piece_row.h"

#include <spdlog/fmt/fmt.h>

namespace kerf::ui {
namespace {

/// What a row is sorted by; a piece without sums comes before all others.
double keyOf(const PieceRow& row, PieceColumn column) {
    switch (column) {
        case PieceColumn::number:
            return 0;
        case PieceColumn::triangles:
            return row.triangles;
        case PieceColumn::volume:
        case PieceColumn::ofAll:
            return row.volume;
        case PieceColumn::ofRest:
            return row.share;
        case PieceColumn::area:
            return row.sums ? row.sums->skinArea + row.sums->cutArea : -1;
        case PieceColumn::size:
            return row.bounds.empty() ? -1 : row.bounds.diagonal();
        case PieceColumn::centre:
            return row.sums ? row.sums->centroid.x() : -1e300;
    }
    return 0;
}

std::string numbers(const Vec3& v) {
    return fmt::format(",{:.9g},{:.9g},{:.9g}", v.x(), v.y(), v.z());
}

}  // namespace

std::vector<int> sortedPieces(const std::vector<PieceRow>& rows, PieceColumn column,
                              bool descending) {
    std::vector<int> order(rows.size());
    std::iota(order.begin(), order.end(), 0);
    if (column == PieceColumn::number) {
        if (descending) {
            std::ranges::reverse(order);
        }
        return order;
    }
    std::ranges::stable_sort(order, [&](int a, int b) {
        const double left = keyOf(rows[a], column);
        const double right = keyOf(rows[b], column);
        return descending ? left > right : left < right;
    });
    return order;
}

std::string piecesAsCsv(const std::vector<PieceRow>& rows) {
    std::string text =
        "piece,triangles,volume_m3,share_of_rest,share_of_all,skin_area_m2,cut_area_m2,"
        "centre_x,centre_y,centre_z,low_x,low_y,low_z,high_x,high_y,high_z\n";
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const PieceRow& row = rows[i];
        text += fmt::format("{},{},{:.9g},{:.9g},{:.9g}", i + 1, row.triangles, row.volume,
                            row.share, row.shareOfAll);
        text += row.sums ? fmt::format(",{:.9g},{:.9g}", row.sums->skinArea, row.sums->cutArea) +
                               numbers(row.sums->centroid)
                         : std::string(",,,,,");
        text += row.bounds.empty() ? std::string(",,,,,,")
                                   : numbers(row.bounds.low) + numbers(row.bounds.high);
        text += "\n";
    }
    return text;
}

}  // namespace kerf::ui
