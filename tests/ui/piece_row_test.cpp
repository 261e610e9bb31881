#include "ui/state/piece_row.h"

#include <gmock/gmock.h>

namespace kerf::ui {
namespace {

using testing::ElementsAre;

PieceRow row(int triangles, double volume) {
    PieceRow piece;
    piece.triangles = triangles;
    piece.volume = volume;
    return piece;
}

TEST(SortedPieces, AreSortedByAColumnBothWaysAndKeepEqualOnesInOrder) {
    const std::vector<PieceRow> rows{row(10, 3), row(30, 1), row(10, 2)};
    EXPECT_THAT(sortedPieces(rows, PieceColumn::number, false), ElementsAre(0, 1, 2));
    EXPECT_THAT(sortedPieces(rows, PieceColumn::number, true), ElementsAre(2, 1, 0));
    EXPECT_THAT(sortedPieces(rows, PieceColumn::volume, false), ElementsAre(1, 2, 0));
    EXPECT_THAT(sortedPieces(rows, PieceColumn::volume, true), ElementsAre(0, 2, 1));
    EXPECT_THAT(sortedPieces(rows, PieceColumn::triangles, false), ElementsAre(0, 2, 1));
}

TEST(SortedPieces, PutThoseWithoutSumsFirst) {
    std::vector<PieceRow> rows{row(1, 1), row(1, 1)};
    rows[0].sums = PieceSums{2, 1, Vec3::Zero()};
    EXPECT_THAT(sortedPieces(rows, PieceColumn::area, false), ElementsAre(1, 0));
}

TEST(PiecesAsCsv, HaveARowEachAndLeaveWhatIsNotKnownEmpty) {
    std::vector<PieceRow> rows{row(12, 0.5), row(20, 0.25)};
    rows[0].share = 1;
    rows[0].shareOfAll = 2.0 / 3;
    rows[0].sums = PieceSums{3, 0.5, Vec3(1, 2, 3)};
    rows[0].bounds = {Vec3(0, 0, 0), Vec3(1, 1, 2)};
    EXPECT_EQ(piecesAsCsv(rows),
              "piece,triangles,volume_m3,share_of_rest,share_of_all,skin_area_m2,cut_area_m2,"
              "centre_x,centre_y,centre_z,low_x,low_y,low_z,high_x,high_y,high_z\n"
              "1,12,0.5,1,0.666666667,3,0.5,1,2,3,0,0,0,1,1,2\n"
              "2,20,0.25,0,0,,,,,,,,,,,\n");
}

}  // namespace
}  // namespace kerf::ui
