#include "app/scene/readout/cut_quality.h"

#include <gtest/gtest.h>

#include "app/session/cut_report.h"

namespace kerf::app {
namespace {

std::string ofAll(const CutReport& report, const std::string& quantity) {
    for (const ui::CutRow& row : rowsOf(report)) {
        if (row.quantity == quantity) {
            return row.all;
        }
    }
    ADD_FAILURE() << "no row about " << quantity;
    return "";
}

CutReport reportWith(const ShapeFigures& walls) {
    CutReport report;
    report.all.walls = walls;
    report.strokes.push_back(report.all);
    return report;
}

TEST(CutQuality, AnglesAreToldWhereThereAreTriangles) {
    ShapeFigures walls;
    EXPECT_EQ(ofAll(reportWith(walls), "Minimum angle, worst"), "-");
    EXPECT_EQ(ofAll(reportWith(walls), "Minimum angle, mean"), "-");
    walls.triangles = 2;
    walls.worstAngle = 12.34;
    walls.angleSum = 60;
    EXPECT_EQ(ofAll(reportWith(walls), "Triangles"), "2");
    EXPECT_EQ(ofAll(reportWith(walls), "Minimum angle, worst"), "12.3\u00b0");
    EXPECT_EQ(ofAll(reportWith(walls), "Minimum angle, mean"), "30.0\u00b0");
}

}  // namespace
}  // namespace kerf::app
