#include <gtest/gtest.h>

#include "ui/over_view.h"
#include "ui/plots/history.h"
#include "ui/state/panel_model.h"

namespace kerf::ui {
namespace {

TEST(StatusText, CountsPiecesThatWereTakenBackWhereAnyWere) {
    History history;
    PanelModel model;
    model.plots.history = &history;
    EXPECT_EQ(statusText(model), "No file open");
    model.name = "sphere80";
    model.pieces.rows.resize(2);
    EXPECT_NE(statusText(model).find("2 pieces   |"), std::string::npos) << statusText(model);
    history[Reading::lostPieces].add(0.5, 3);
    EXPECT_NE(statusText(model).find("2 pieces, 3 reset   |"), std::string::npos)
        << statusText(model);
}

}  // namespace
}  // namespace kerf::ui
